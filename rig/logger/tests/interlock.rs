//! Every state that the interlock can reach, with every fault at any moment, by exhaustive enumeration.
//!
//! The model joins three machines: the interlock, the run permit of the measuring device (the code that the firmware
//! runs),
//! and the world outside, which keeps its own account of how long each fault has truly lasted. In every step of 100 ms
//! the
//! world may change any of its conditions, the operator may ask for anything, and the program may die for good,
//! leaving its
//! outputs as they were. A breadth-first and a depth-first search must find the same number of states.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::{HashMap, HashSet, VecDeque};

use rig_logger::interlock::{Allowed, BrakeAllowed, Cause, Command, Inputs, Interlock, Limits, Mode, Temperature};

const STEP_MS: u16 = 100;
/// What the measuring device allows: 250 ms, in steps, rounded up.
const PERMIT_STEPS: u16 = 3;
/// Stopping is shortened from 15 s: its length appears in no invariant.
const LIMITS: Limits = Limits { stopping_ms: 200, ..Limits::RIG };

/// How long, in steps, each truth has lasted, up to one more than its limit. After the program's death only that
/// counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, Default)]
struct Lasted {
    link_lost: u16,
    hot: u16,
    unreadable: u16,
    released: u16,
    instant: u16,
    dead: u16,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
struct World {
    interlock: Interlock,
    outputs: Allowed,
    /// Steps for which the run permit still holds.
    permit: u16,
    dead: bool,
    lasted: Lasted,
}

/// One choice of the world and of the operator.
#[derive(Clone, Copy, Debug)]
struct Choice {
    link: bool,
    temperature: Temperature,
    brake_on: bool,
    /// Emergency stop, overspeed or a failed recording: all end power at once.
    instant: Option<Cause>,
    at_rest: bool,
    command: Option<Command>,
    dies: bool,
}

fn choices() -> Vec<Choice> {
    let commands = [None, Some(Command::Enable), Some(Command::Go), Some(Command::Stop), Some(Command::Acknowledge)];
    let instants = [None, Some(Cause::EmergencyStop), Some(Cause::Overspeed), Some(Cause::RecordingFailed)];
    let mut all = Vec::new();
    for link in [true, false] {
        for temperature in [Temperature::Good, Temperature::Hot, Temperature::Unreadable] {
            for (brake_on, at_rest) in [(true, true), (true, false), (false, true), (false, false)] {
                for instant in instants {
                    for command in commands {
                        all.push(Choice { link, temperature, brake_on, instant, at_rest, command, dies: false });
                    }
                }
            }
        }
    }
    let worst = Choice { link: false, temperature: Temperature::Hot, brake_on: false, dies: true, ..all[0] };
    all.push(worst);
    all
}

impl World {
    fn new(limits: Limits) -> Self {
        let interlock = Interlock::new(limits);
        Self { interlock, outputs: interlock.allowed(), permit: 0, dead: false, lasted: Lasted::default() }
    }

    /// Open throttle and ignition.
    fn power(&self) -> bool {
        self.outputs.throttle && self.permit > 0
    }

    fn next(mut self, choice: Choice) -> Self {
        self.lasted = self.lasted.after(choice, self.dead || choice.dies);
        self.permit = self.permit.saturating_sub(1);
        self.dead |= choice.dies;
        if self.dead {
            // Nothing that happens now reaches the outputs: only the permit runs out.
            self.lasted = Lasted { dead: self.lasted.dead, ..Lasted::default() };
            return self;
        }
        let inputs = Inputs {
            fresh_frame: choice.link,
            device_restarted: false,
            temperature: choice.temperature,
            brake_on: choice.brake_on,
            brake_jammed: false,
            overspeed: choice.instant == Some(Cause::Overspeed),
            torque_stuck: false,
            speed_stuck: false,
            recording: choice.instant != Some(Cause::RecordingFailed),
            emergency_stop: choice.instant == Some(Cause::EmergencyStop),
            at_rest: choice.at_rest,
            command: choice.command,
        };
        self.outputs = self.interlock.step(&inputs, STEP_MS);
        if choice.link {
            self.permit = if self.outputs.ignition { PERMIT_STEPS } else { 0 };
        }
        self
    }
}

impl Lasted {
    fn after(self, choice: Choice, dead: bool) -> Self {
        let longer = |steps: u16, holds: bool, limit_ms: u16| {
            if holds { (steps + 1).min(limit_ms / STEP_MS + 1) } else { 0 }
        };
        Self {
            link_lost: longer(self.link_lost, !choice.link, LIMITS.link_ms),
            hot: longer(self.hot, choice.temperature == Temperature::Hot, LIMITS.hot_ms),
            unreadable: longer(self.unreadable, choice.temperature == Temperature::Unreadable, LIMITS.unreadable_ms),
            released: longer(self.released, !choice.brake_on, LIMITS.brake_ms),
            instant: longer(self.instant, choice.instant.is_some(), 0),
            dead: longer(self.dead, dead, PERMIT_STEPS * STEP_MS),
        }
    }
}

/// The first invariant that a state breaks. Power after death is bounded by the permit, whatever else is wrong
/// meanwhile.
fn broken(world: &World) -> Option<&'static str> {
    let lasted = &world.lasted;
    let beyond = |steps: u16, limit_ms: u16| steps >= limit_ms / STEP_MS;
    let power = world.power();
    let alive_power = power && !world.dead;
    let mode = world.interlock.mode();
    let outputs = &world.outputs;
    [
        (alive_power && beyond(lasted.link_lost, LIMITS.link_ms), "1: power without a link"),
        (alive_power && beyond(lasted.released, LIMITS.brake_ms), "2: power without a brake"),
        (alive_power && beyond(lasted.hot, LIMITS.hot_ms), "3: power with a hot rotor"),
        (alive_power && beyond(lasted.unreadable, LIMITS.unreadable_ms), "4: power without a temperature"),
        (alive_power && lasted.instant > 0, "5: power under emergency stop, overspeed or without recording"),
        (power && beyond(lasted.dead, PERMIT_STEPS * STEP_MS), "6: power after the program's death"),
        (outputs.throttle != (mode == Mode::Running), "7: throttle open outside Running, or not in it"),
        (outputs.ignition != matches!(mode, Mode::Ready | Mode::Running), "7: ignition outside Ready and Running"),
        (outputs.throttle && outputs.brake == BrakeAllowed::Any, "7: the brake may be let go under power"),
    ]
    .into_iter()
    .find_map(|(is, name)| is.then_some(name))
}

/// Invariant 8, of one transition.
fn broken_by(before: &World, choice: Choice, after: &World) -> Option<&'static str> {
    let (Mode::Tripped(_), mode) = (before.interlock.mode(), after.interlock.mode()) else { return None };
    let left = !matches!(mode, Mode::Tripped(_));
    let rightly = mode == Mode::Safe && choice.command == Some(Command::Acknowledge) && choice.instant.is_none();
    (left && !rightly).then_some("8: a trip was left without being acknowledged")
}

struct Found {
    states: HashSet<World>,
    transitions: u64,
    predecessors: HashMap<World, Vec<World>>,
    broken: Option<String>,
}

/// Visits everything; `depth_first` only changes the order.
fn explore(limits: Limits, depth_first: bool, keep_predecessors: bool) -> Found {
    let choices = choices();
    let start = World::new(limits);
    let mut found = Found {
        states: HashSet::from([start]),
        transitions: 0,
        predecessors: HashMap::new(),
        broken: broken(&start).map(str::to_owned),
    };
    let mut open = VecDeque::from([start]);
    while let Some(world) = if depth_first { open.pop_back() } else { open.pop_front() } {
        let mut successors = HashSet::new();
        for choice in &choices {
            let next = world.next(*choice);
            found.transitions += 1;
            if let Some(name) = broken(&next).or_else(|| broken_by(&world, *choice, &next)) {
                found.broken = Some(format!("{name}: {world:?} -> {choice:?} -> {next:?}"));
                return found;
            }
            successors.insert(next);
        }
        for next in successors {
            if keep_predecessors {
                found.predecessors.entry(next).or_default().push(world);
            }
            if found.states.insert(next) {
                open.push_back(next);
            }
        }
    }
    found
}

#[test]
fn no_reachable_state_breaks_an_invariant() {
    let found = explore(LIMITS, false, true);
    assert_eq!(found.broken, None);
    println!("{} states, {} transitions", found.states.len(), found.transitions);
    let again = explore(LIMITS, true, false);
    assert_eq!(found.states, again.states);
    assert!(found.states.iter().any(World::power), "nothing was shown if power never comes on");
    // Invariant 9: backwards from Safe, every state in which the program lives is found.
    let mut reaches: HashSet<World> =
        found.states.iter().filter(|world| world.interlock.mode() == Mode::Safe && !world.dead).copied().collect();
    let mut open: Vec<World> = reaches.iter().copied().collect();
    while let Some(world) = open.pop() {
        for before in found.predecessors.get(&world).into_iter().flatten() {
            if reaches.insert(*before) {
                open.push(*before);
            }
        }
    }
    let lost = found.states.iter().find(|world| !world.dead && !reaches.contains(*world));
    assert_eq!(lost, None, "no way back to Safe");
    assert_eq!((found.states.len(), found.transitions), (STATES, TRANSITIONS), "the machine changed: look at it anew");
}

/// What the search finds; stated in docs/rig.md.
const STATES: usize = 11_511;
const TRANSITIONS: u64 = 5_536_791;

/// The check itself can fail: with any limit too long it finds the invariant that this breaks.
#[test]
fn a_limit_that_is_too_long_is_found() {
    for (limits, number) in [
        (Limits { link_ms: 300, ..LIMITS }, "1:"),
        (Limits { brake_ms: 400, ..LIMITS }, "2:"),
        (Limits { hot_ms: 300, ..LIMITS }, "3:"),
        (Limits { unreadable_ms: 500, ..LIMITS }, "4:"),
    ] {
        let broken = explore(limits, false, false).broken.unwrap();
        assert!(broken.starts_with(number), "{broken}");
    }
}
