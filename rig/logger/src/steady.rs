//! The automated steady-state test: brake on a little more, wait until the drive has settled, read, again (thesis,
//! 9.1).

use crate::hardware::{Brake, Hardware};
use crate::interlock::{Command, Mode};
use crate::journal::Record;
use crate::session::Session;
use crate::settle::Settling;
use crate::watch::{PRELOAD_US, speed_lost};

/// What a test notes in the journal: a pass begins,
pub(crate) const BEGINS: &str = "putting the brake on";
/// a point is waited for,
pub(crate) const SETTLING: &str = "settling";
/// it is read,
pub(crate) const READING: &str = "reading";
/// it is read all the same.
pub(crate) const READING_UNSETTLED: &str = "reading, though it has not settled";

/// How the test goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plan {
    /// How long the brake moves for each step, ms (50 in the thesis).
    pub brake_step_ms: u64,
    /// How long an operating point is read, ms (3000 in the thesis).
    pub read_ms: u64,
    /// The longest that settling is waited for, ms; a point read without having settled is marked so.
    pub longest_settling_ms: u64,
    /// The test ends when the secondary turns slower than this, rpm (1200 in the thesis).
    pub least_secondary_rpm: f64,
    /// The test ends after so many points.
    pub most_points: u32,
    /// How often the whole test is repeated, the brake let go between.
    pub passes: u32,
    /// The throttle opens only after the operator has asked for it, with the engine idling: somebody has just pulled
    /// its starter.
    pub ask_before_opening: bool,
}

impl Plan {
    /// The thesis's test, with settling detected.
    pub const THESIS: Self = Self {
        brake_step_ms: 50,
        read_ms: 3000,
        longest_settling_ms: 20_000,
        least_secondary_rpm: 1200.0,
        most_points: 1000,
        passes: 1,
        ask_before_opening: false,
    };
}

/// An operating point, as a first look; `sheave dyno` reduces the recording itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Pass, from 0.
    pub pass: u32,
    /// Number, from 0.
    pub number: u32,
    /// Mean and standard deviation of the primary's speed, rpm.
    pub primary_rpm: (f64, f64),
    /// Mean and standard deviation of the secondary's speed, rpm.
    pub secondary_rpm: (f64, f64),
    /// Mean and standard deviation of the torque at the secondary, N·m.
    pub torque: (f64, f64),
    /// Conversions in it.
    pub conversions: u32,
    /// Length, s.
    pub duration: f64,
    /// Time that settling took, ms.
    pub settling_ms: u64,
    /// Whether it had settled before it was read, and no speed was lost while it was read.
    pub settled: bool,
}

/// What the operator wants while a test runs.
pub trait Operator {
    /// Asked in every step; `Stop` ends the test.
    fn command(&mut self, status: &crate::session::Status) -> Option<Command>;
}

/// Nobody intervenes.
pub struct Nobody;

impl Operator for Nobody {
    fn command(&mut self, _: &crate::session::Status) -> Option<Command> {
        None
    }
}

/// Mean and standard deviation of values as they come.
#[derive(Clone, Copy, Debug, Default)]
pub struct Mean {
    count: u32,
    mean: f64,
    squares: f64,
}

impl Mean {
    /// How many values there were.
    pub(crate) fn count(&self) -> u32 {
        self.count
    }

    /// Mean and standard deviation of some values; zero for none.
    pub fn of(values: impl IntoIterator<Item = f64>) -> (f64, f64) {
        let mut mean = Self::default();
        values.into_iter().for_each(|value| mean.add(value));
        mean.result()
    }

    pub(crate) fn add(&mut self, value: f64) {
        self.count += 1;
        let before = value - self.mean;
        self.mean += before / f64::from(self.count);
        self.squares += before * (value - self.mean);
    }

    pub(crate) fn result(&self) -> (f64, f64) {
        (self.mean, if self.count > 1 { (self.squares / f64::from(self.count - 1)).sqrt() } else { 0.0 })
    }
}

/// Runs the test and returns its points. It ends early when the interlock stops the rig or the operator says so; the
/// points
/// read until then are returned, and `Session::cause` says why.
pub fn run<H: Hardware>(session: &mut Session<H>, plan: &Plan, operator: &mut dyn Operator) -> Vec<Point> {
    let mut test = Test { session, plan, operator, points: Vec::new() };
    for pass in 0..plan.passes {
        if !test.pass(pass) {
            break;
        }
    }
    test.points
}

struct Test<'a, H> {
    session: &'a mut Session<H>,
    plan: &'a Plan,
    operator: &'a mut dyn Operator,
    points: Vec<Point>,
}

impl<H: Hardware> Test<'_, H> {
    /// One step; false once the rig is being stopped.
    fn step(&mut self, command: Option<Command>, brake: Brake) -> bool {
        let asked = self.operator.command(self.session.status());
        // What the operator asks for goes first, but for an open throttle: that waits for what the test needs done.
        let command = if asked == Some(Command::Go) { command.or(asked) } else { asked.or(command) };
        self.session.step(command, brake);
        !matches!(self.session.mode(), Mode::Stopping(_) | Mode::Tripped(_))
    }

    fn for_ms(&mut self, milliseconds: u64, brake: Brake) -> bool {
        let end = self.session.status().time + milliseconds * 1000;
        while self.session.status().time < end {
            if !self.step(None, brake) {
                return false;
            }
        }
        true
    }

    /// Puts the brake on, has the engine started and opens the throttle; false if that does not come about in a minute.
    fn start(&mut self) -> bool {
        self.session.note(BEGINS);
        if !self.for_ms(PRELOAD_US as u64 / 1000 + 100, Brake::Apply) {
            return false;
        }
        let patience = if self.plan.ask_before_opening { 600_000_000 } else { 60_000_000 };
        let end = self.session.status().time + patience;
        let mut asked = false;
        while self.session.status().time < end {
            // The interlock asks the same of every command to open, whoever gives it.
            let idles = self.session.idles();
            // An engine that has died is asked for anew.
            asked &= idles;
            if idles && self.plan.ask_before_opening && !asked {
                asked = true;
                self.session.note("The engine idles. Everybody behind the cage? Then press g to open the throttle.");
            }
            let go = idles && !self.plan.ask_before_opening;
            let command = match self.session.mode() {
                Mode::Safe => Some(Command::Enable),
                Mode::Ready if go => Some(Command::Go),
                Mode::Running => return true,
                Mode::Ready | Mode::Stopping(_) | Mode::Tripped(_) => None,
            };
            if !self.step(command, Brake::Hold) {
                return false;
            }
        }
        self.session.note("the engine did not start in time, or something forbids the start");
        self.step(Some(Command::Stop), Brake::Hold);
        false
    }

    /// One pass through the operating range; false if another must not follow.
    fn pass(&mut self, pass: u32) -> bool {
        if !self.start() {
            return false;
        }
        let mut torques = Vec::new();
        for number in 0..self.plan.most_points {
            if !self.for_ms(if number == 0 { 0 } else { self.plan.brake_step_ms }, Brake::Apply) {
                return false;
            }
            let Some(settling) = self.settle() else { return false };
            let Some(point) = self.read(pass, number, settling) else { return false };
            self.points.push(point);
            torques.push(point.torque.0);
            if self.does_not_follow(&torques) {
                self.session.brake_does_not_follow();
            }
            if point.secondary_rpm.0 < self.plan.least_secondary_rpm {
                break;
            }
        }
        self.end()
    }

    /// Whether the actuator has moved for 0.4 s over the last points without the torque rising by 0.5 N·m.
    fn does_not_follow(&self, torques: &[f64]) -> bool {
        let points = (400 / self.plan.brake_step_ms.max(1)).max(3) as usize;
        match (torques.len().checked_sub(points + 1).and_then(|first| torques.get(first)), torques.last()) {
            (Some(before), Some(after)) => after - before < 0.5,
            _ => false,
        }
    }

    /// Waits until speeds and torque have settled; the time it took in ms and whether they had.
    fn settle(&mut self) -> Option<(u64, bool)> {
        self.session.note(SETTLING);
        let begin = self.session.status().time;
        let mut settling = [Settling::new(25.0, 300), Settling::new(25.0, 300), Settling::new(0.6, 300)];
        loop {
            if !self.step(None, Brake::Hold) {
                return None;
            }
            let status = self.session.status();
            let passed = (status.time - begin) / 1000;
            for (channel, value) in settling.iter_mut().zip([status.primary_rpm, status.secondary_rpm, status.torque]) {
                channel.push(passed, value);
            }
            let settled = settling.iter().all(Settling::settled);
            if settled || passed > self.plan.longest_settling_ms {
                return Some((passed, settled));
            }
        }
    }

    fn read(&mut self, pass: u32, number: u32, (settling_ms, settled): (u64, bool)) -> Option<Point> {
        self.session.set_point(number);
        self.session.note(if settled { READING } else { READING_UNSETTLED });
        let begin = self.session.status().time;
        let count = self.points.len() as u32;
        self.session.record(&Record::Point { at: begin, number: count, begins: true });
        let (mut primary, mut secondary, mut torque) = (Mean::default(), Mean::default(), Mean::default());
        let (mut last_conversion, mut lost) = (None, false);
        while self.session.status().time < begin + self.plan.read_ms * 1000 {
            if !self.step(None, Brake::Hold) {
                return None;
            }
            let status = self.session.status();
            primary.add(status.primary_rpm);
            secondary.add(status.secondary_rpm);
            let value = status.torque;
            let at = self.session.frame().and_then(|frame| frame.snapshot.torque_at);
            lost |= self.session.frame().is_some_and(speed_lost);
            if at != last_conversion {
                last_conversion = at;
                torque.add(value);
            }
        }
        let end = self.session.status().time;
        self.session.record(&Record::Point { at: end, number: count, begins: false });
        Some(Point {
            pass,
            number,
            primary_rpm: primary.result(),
            secondary_rpm: secondary.result(),
            torque: torque.result(),
            conversions: torque.count,
            duration: (end - begin) as f64 * 1e-6,
            settling_ms,
            // A point in which a shaft showed no speed is none, however steady the zeros are.
            settled: settled && !lost,
        })
    }

    /// Stops in an orderly way and lets the brake go.
    fn end(&mut self) -> bool {
        self.step(Some(Command::Stop), Brake::Hold);
        for _ in 0..3000 {
            if self.session.mode() == Mode::Safe {
                break;
            }
            self.session.step(None, Brake::Hold);
        }
        self.for_ms(12_000, Brake::Release) && self.session.mode() == Mode::Safe
    }
}
