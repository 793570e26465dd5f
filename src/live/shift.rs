//! The shift curve of a whole drive, one point a question.

use serde_json::{Value, json};

use super::Refused;
use super::ask::ShiftAsk;
use super::values;
use crate::case::{Case, Resolved};
use crate::equilibrium::{Direction, EquilibriumError, ShiftOptions, ShiftPoint, ShiftWalk};
use crate::result::{FailureKind, FailureReport};

/// Points of a direction at most.
const MOST: usize = 200;

/// The curves that are being computed or were last, one a direction.
#[derive(Debug, Default)]
pub(super) struct Curves(Vec<ShiftWalk>);

impl Curves {
    fn of(&mut self, direction: Direction) -> Option<&mut ShiftWalk> {
        self.0.iter_mut().find(|walk| walk.branch().direction == direction)
    }

    /// Begins a curve: its landmarks, and how many points there are to ask for; from the last one of its direction if
    /// there is one. What the case lacks to be a whole drive is a failure, and the case is told nevertheless.
    pub(super) fn begin(&mut self, case: &Case, resolved: &Resolved, ask: &ShiftAsk) -> Result<Value, Refused> {
        let options = ShiftOptions {
            points: ask.points.clamp(2, MOST),
            directions: vec![ask.direction],
            from: None,
            to: None,
            solve: ask.options(),
        };
        let begun = match self.of(ask.direction).filter(|_| !ask.from_nothing) {
            Some(near) => near.begin_near(resolved, &options),
            None => ShiftWalk::begin(resolved, ask.direction, &options).map(ShiftWalk::keeping),
        };
        let mut answer = json!({
            "case": case.to_toml(),
            "given": case.keys().map(crate::case::Key::path).collect::<Vec<_>>(),
            "remarks": case.remarks(),
            "choices": values::choices(resolved),
            "values": values::asked(resolved, None),
        });
        match begun {
            Ok(walk) => {
                let branch = walk.branch();
                answer["direction"] = json!(ask.direction);
                answer["engagement_speed"] = json!(branch.engagement);
                answer["take_off"] = json!(branch.take_off);
                answer["shift_out"] = json!(branch.shift_out);
                answer["full_shift"] = json!(branch.full_shift);
                answer["missing"] = json!(branch.remarks);
                answer["left"] = json!(walk.remaining());
                answer["travel_per_radian"] =
                    json!(resolved.parts.vehicle.as_ref().map(|vehicle| vehicle.load(1.0).speed));
                self.0.retain(|walk| walk.branch().direction != ask.direction);
                self.0.push(walk);
            }
            Err(error) => answer["failure"] = json!(report(&error)),
        }
        Ok(answer)
    }

    /// The next point of a curve, and how many are left; none where there is no curve, or no more of it. With the last
    /// comes what there is to say of all of them.
    pub(super) fn next(&mut self, direction: Direction) -> Result<Value, Refused> {
        let Some(walk) = self.of(direction) else { return Ok(json!({ "point": null, "left": 0 })) };
        let point = match walk.step() {
            Ok(point) => point.map(told),
            Err(error) => return Ok(json!({ "failure": report(&error) })),
        };
        let (is_one, left) = (point.is_some(), walk.remaining());
        let mut answer = json!({ "point": point, "left": left });
        if is_one && left == 0 {
            answer["remarks"] = json!(walk.remarks());
        }
        Ok(answer)
    }
}

fn report(error: &EquilibriumError) -> FailureReport {
    let kind = if error.is_bad_input() { FailureKind::Input } else { FailureKind::NoSolution };
    FailureReport { kind, message: error.to_string(), hint: error.hint().map(str::to_owned) }
}

/// A point as it is drawn, SI.
fn told(point: &ShiftPoint) -> Value {
    let mut told = json!({ "secondary_speed": point.secondary_speed });
    match &point.report {
        Ok(report) => {
            told["primary_speed"] = json!(report.primary_speed);
            told["vehicle_speed"] = json!(report.vehicle_speed);
            told["acceleration"] = json!(report.acceleration);
            told["phase"] = json!(report.phase);
            told["ratio"] = json!(report.ratio);
            told["primary_axial_force"] = json!(report.primary_axial_force);
            told["secondary_axial_force"] = json!(report.secondary_axial_force);
            told["primary_torque"] = json!(report.drive.primary.torque);
            told["slip_reserve"] = json!(report.slip_reserve);
            told["slipping"] = json!(report.slipping);
            told["doubt"] = json!(report.doubt);
            told["efficiency"] = json!(report.efficiency);
            told["power_in"] = json!(report.power_in);
            told["power_out"] = json!(report.power_out);
            told["belt_temperature"] = json!(report.belt_temperature);
        }
        Err(reason) => told["failure"] = json!(reason),
    }
    told
}
