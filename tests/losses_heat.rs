//! Properties over temperature, and heat: where the belt's temperature follows, in reserves, limits and optima as well.
#![allow(clippy::unwrap_used, clippy::expect_used, clippy::panic)]

use sheave::case::Case;
use sheave::design::{LimitOptions, largest_torque, optimum};
use sheave::drive::SolveOptions;
use sheave::result::{Outcome, run};
use support::{Read, assert_derivatives};

#[path = "support/derivatives.rs"]
mod support;

/// Stiffnesses as the thesis measured them (4.1), and a loss tangent that falls with the temperature.
const MEASURED: &str = "[belt]
bending_stiffness = { temperature = ['25 degC', '60 degC'], value = [0.40304, 0.2602] }
radial_stiffness = { temperature = ['25 degC', '60 degC', '100 degC'], value = ['28.98 MPa', '18.71 MPa', '13 MPa'] }
loss_tangent = { frequency = ['10 Hz', '1 kHz'], temperature = ['25 degC', '90 degC'], value = [[0.16, 0.1], [0.18, \
    0.12]] }
cord_loss_tangent = 0.01
[thermal]
ambient = '25 degC'
heat_transfer_per_area = 180
friction_share = 0.4
[losses]
gear_efficiency = 0.98
[sheave]
slip_threshold = '1e-2 m/s'
";

fn options() -> SolveOptions {
    SolveOptions { tolerance: 1e-7, ..SolveOptions::default() }
}

fn measured(settings: &[(&str, &str)]) -> Case {
    let mut case = Case::from_toml("measured", MEASURED).unwrap();
    settings.iter().for_each(|(key, value)| case.set(key, value).unwrap());
    case
}

fn solve(case: &Case, options: &SolveOptions) -> Outcome {
    run(&case.resolve().unwrap(), options).unwrap()
}

#[test]
fn a_table_of_one_number_is_the_number() {
    let number = solve(&Case::base(), &options());
    let mut case = Case::base();
    let flat = "{ frequency = [1, 1e4], temperature = [280, 380], value = [[0.125, 0.125], [0.125, 0.125]] }";
    case.set("belt.loss_tangent", "0.125").unwrap();
    let told = solve(&case, &options()).result.losses.unwrap();
    case.set("belt.loss_tangent", flat).unwrap();
    case.set("belt.bending_stiffness", "{ temperature = [280, 380], value = [0.2602, 0.2602] }").unwrap();
    let table = solve(&case, &options());
    let tabulated = table.result.losses.unwrap();
    assert!((tabulated.bending / told.bending - 1.0).abs() < 1e-9, "{} {}", tabulated.bending, told.bending);
    assert!((tabulated.groove / told.groove - 1.0).abs() < 1e-9);
    assert!((table.result.primary.axial_force / number.result.primary.axial_force - 1.0).abs() < 1e-9);
}

/// Two temperatures are the exponential through them, whatever it is written as.
#[test]
fn a_table_of_two_temperatures_is_a_softening() {
    let settings = [("thermal.ambient", "20 degC"), ("thermal.heat_transfer", "14 W/K")];
    let mut exponential = Case::base();
    settings.iter().for_each(|(key, value)| exponential.set(key, value).unwrap());
    let softening = (0.40304_f64 / 0.2602).ln() / 35.0;
    exponential.set("thermal.bending_softening", &softening.to_string()).unwrap();
    let mut table = exponential.clone();
    table.unset("thermal.bending_softening").unwrap();
    table.set("belt.bending_stiffness", "{ temperature = ['25 degC', '60 degC'], value = [0.40304, 0.2602] }").unwrap();
    let (one, other) = (solve(&exponential, &options()).result, solve(&table, &options()).result);
    let (kelvin, same) = (one.belt.temperature.unwrap(), other.belt.temperature.unwrap());
    assert!((kelvin - same).abs() < 1e-4, "{kelvin} {same}");
    assert!((one.primary.axial_force / other.primary.axial_force - 1.0).abs() < 1e-6);
}

/// Each derivative against a difference of two solutions, the temperature following in both.
#[test]
fn derivatives_follow_tables_and_surface() {
    let case = measured(&[]);
    let at = solve(&case, &SolveOptions { sensitivities: true, ..options() });
    let (result, heat) = (&at.result, at.result.thermal.unwrap());
    let temperature = result.belt.temperature.unwrap();
    let surface = 0.0773 * 0.8572;
    assert!((180.0 * surface * (temperature - 298.15) / heat.belt - 1.0).abs() < 1e-5, "{temperature} {heat:?}");
    assert!((310.0..360.0).contains(&temperature), "{temperature}");
    for (key, value, step) in [
        ("thermal.ambient", 298.15, 1e-3),
        ("thermal.heat_transfer_per_area", 180.0, 2e-3),
        ("belt.perimeter", 0.0773, 2e-3),
        ("operating_point.slack_tension", 100.0, 2e-3),
    ] {
        let read: &[(&str, Read)] = &[
            ("belt.temperature", |result| result.belt.temperature.unwrap()),
            ("primary.axial_force", |result| result.primary.axial_force),
            ("losses.bending", |result| result.losses.as_ref().unwrap().bending),
            ("losses.total", |result| result.losses.as_ref().unwrap().total),
            ("efficiency.overall_with_losses", |result| result.efficiency.overall_with_losses.unwrap()),
        ];
        assert_derivatives((&case, result), (key, value, step), |case| solve(case, &options()).result, read);
    }
}

#[test]
fn a_reserve_is_that_of_the_warm_belt() {
    let case = measured(&[("operating_point.slip_reserve", "30 %")]);
    let found = solve(&case, &options());
    let (result, heat) = (&found.result, found.result.thermal.unwrap());
    assert!((result.slip_reserve - 0.3).abs() < 1e-6, "{}", result.slip_reserve);
    let temperature = result.belt.temperature.unwrap();
    assert!((180.0 * 0.0773 * 0.8572 * (temperature - 298.15) / heat.belt - 1.0).abs() < 1e-5);
    // The same drive, asked for by its slack tension.
    let tension = result.found["operating_point.slack_tension"];
    let same = solve(&measured(&[("operating_point.slack_tension", &format!("{tension:e}"))]), &options()).result;
    assert!((same.belt.temperature.unwrap() - temperature).abs() < 1e-3);
    assert!((same.slip_reserve - 0.3).abs() < 1e-5, "{}", same.slip_reserve);
    // Not that of the belt at its reference temperature.
    let cold = solve(
        &measured(&[("thermal.heat_transfer_per_area", "1e5"), ("operating_point.slip_reserve", "30 %")]),
        &options(),
    );
    assert!((cold.result.found["operating_point.slack_tension"] / tension - 1.0).abs() > 1e-3);
}

#[test]
fn the_optimum_is_that_of_belts_as_warm_as_they_become() {
    let case = measured(&[("losses.include", "on")]);
    let options = SolveOptions { tolerance: 1e-6, ..SolveOptions::default() };
    let best = optimum(&case.resolve().unwrap(), &options).unwrap();
    let (tension, efficiency) = (best.state.slack_tension, best.efficiency_with_losses.unwrap());
    assert!(best.belt_temperature.is_some_and(|kelvin| (305.0..360.0).contains(&kelvin)), "{best:?}");
    let at = |factor: f64| {
        let case = measured(&[("operating_point.slack_tension", &format!("{:e}", tension * factor))]);
        let result = solve(&case, &options).result;
        (result.efficiency.overall_with_losses.unwrap(), result.belt.temperature.unwrap())
    };
    let ((here, kelvin), (looser, _), (tighter, _)) = (at(1.0), at(0.9), at(1.1));
    assert!((here - efficiency).abs() < 1e-6 && (kelvin - best.belt_temperature.unwrap()).abs() < 0.01);
    assert!(looser < here && tighter < here, "{looser} {here} {tighter} at {tension} N");
}

#[test]
fn a_limit_is_that_of_a_belt_as_warm_as_it_is_there() {
    let options = LimitOptions {
        solve: SolveOptions { tolerance: 1e-5, ..SolveOptions::default() },
        least_speed_efficiency: 0.95,
    };
    let case = measured(&[("thermal.heat_transfer_per_area", "300")]);
    let (limit, _) = largest_torque(&case.resolve().unwrap(), &options).unwrap();
    let kelvin = limit.belt_temperature.unwrap();
    // The same belt, its stiffnesses given as they are at that temperature, has the same limit.
    let mut same = measured(&[("thermal.reference", &format!("{kelvin:e} K"))]);
    same.unset("thermal.ambient").unwrap();
    same.unset("thermal.heat_transfer_per_area").unwrap();
    let (again, branch) = largest_torque(&same.resolve().unwrap(), &options).unwrap();
    assert!((again.value / limit.value - 1.0).abs() < 1e-6 && again.belt_temperature.is_none(), "{again:?} {limit:?}");
    // And its heat is in balance there.
    let last = branch.points.last().unwrap();
    let friction = last.value(sheave::model::Output::EnergyFrictionLoss).unwrap();
    let told = sheave::losses::losses(&same.resolve().unwrap(), &last.solved, kelvin, 1e-5).unwrap();
    let heat = 0.4 * friction + told.bending + told.groove + told.cord;
    let given_off = 300.0 * 0.0773 * 0.8572 * (kelvin - 298.15);
    assert!((heat / given_off - 1.0).abs() < 1e-3, "{heat} {given_off}");
}

/// Engine braking: the secondary drives, losses are taken off what arrives at the primary, and the energy closes.
#[test]
fn braking_pays_for_its_losses_too() {
    let case = measured(&[
        ("operating_point.primary_torque", "-9 N*m"),
        ("operating_point.slack_tension", "400 N"),
        ("losses.primary_drag", "0.3 N*m"),
        ("losses.secondary_drag_per_speed", "2e-4 N*m*s"),
    ]);
    let outcome = solve(&case, &SolveOptions { tolerance: 1e-8, ..SolveOptions::default() });
    let (result, losses) = (&outcome.result, outcome.result.losses.as_ref().unwrap());
    let energy = &result.energy;
    assert!(energy.power_in < 0.0 && energy.power_out < 0.0);
    // What drives is the secondary's power; what arrives is taken by the primary.
    let driving = -energy.power_out;
    let hysteresis = losses.bending + losses.groove + losses.cord;
    let sum = losses.power_out + energy.friction_loss + hysteresis + losses.drag + losses.gears + energy.stretch_work;
    assert!((sum / driving - 1.0).abs() < 1e-8, "{sum} of {driving}");
    let (elastic, whole) = (result.efficiency.overall.unwrap(), result.efficiency.overall_with_losses.unwrap());
    assert!((whole - losses.power_out / driving).abs() < 1e-12);
    assert!(0.0 < whole && whole < elastic && elastic < 1.0, "{whole} {elastic}");
    assert!(losses.drag > 0.0 && losses.gears > 0.0 && losses.power_out > 0.0);
    assert!(result.belt.temperature.unwrap() > 300.0);
}

#[test]
fn a_temperature_beyond_the_tables_is_warned_of() {
    let hot = solve(&measured(&[("thermal.heat_transfer_per_area", "60")]), &SolveOptions::default());
    let said = sheave::result::warnings(&hot);
    assert!(said.iter().any(|said| said.contains("is beyond those at which `belt.bending_stiffness`")), "{said:?}");
    for (key, value, words) in [
        ("thermal.heat_transfer", "10 W/K", "one is that of the whole belt"),
        ("thermal.bending_softening", "0.01", "the table says how"),
    ] {
        let error = measured(&[(key, value)]).resolve().unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    }
    let mut alone = Case::base();
    alone.set("thermal.heat_transfer_per_area", "100").unwrap();
    assert!(alone.resolve().unwrap_err().to_string().contains("thermal.ambient"));
}

/// Whether losses are told changes no other figure: not the temperature, what it makes of the belt, or derivatives.
#[test]
fn a_belt_is_as_warm_whether_its_losses_are_told_or_not() {
    let options = SolveOptions { sensitivities: true, ..options() };
    let [on, off] = ["on", "off"].map(|include| solve(&measured(&[("losses.include", include)]), &options).result);
    assert!(on.losses.is_some() && off.losses.is_none() && off.efficiency.overall_with_losses.is_none());
    assert_eq!((&on.belt, &on.thermal), (&off.belt, &off.thermal));
    assert_eq!((&on.primary, &on.secondary), (&off.primary, &off.secondary));
    assert_eq!((&on.energy, on.efficiency.overall), (&off.energy, off.efficiency.overall));
    let (on, off) = (on.sensitivities.unwrap(), off.sensitivities.unwrap());
    assert_eq!(on["primary.axial_force"], off["primary.axial_force"]);
    assert!(off.keys().all(|name| !name.starts_with("losses.") && !name.ends_with("with_losses")), "{:?}", off.keys());
}
