//! Every state that the interlock can reach, with every fault at any moment, by exhaustive enumeration.
//!
//! The model joins three machines: the interlock, the run permit of the measuring device (the code that the firmware
//! runs), and the world outside, which keeps its own account of how long each fault has truly lasted. In every step of
//! 100 ms
//! the world may change any of its conditions, the operator may ask for anything, and the program may die for good,
//! leaving its outputs as they were.

#![allow(clippy::unwrap_used, clippy::panic)]

use std::collections::{HashMap, HashSet, VecDeque};
use std::hash::{BuildHasherDefault, Hasher};

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
    torque_stuck: u16,
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
    /// The measuring device was reset, and no frame has told the program yet.
    reset_unseen: bool,
    lasted: Lasted,
}

/// One choice of the world and of the operator.
#[derive(Clone, Copy, Debug)]
struct Choice {
    link: bool,
    temperature: Temperature,
    brake_on: bool,
    torque_stuck: bool,
    /// What ends power at once.
    instant: Option<Cause>,
    at_rest: bool,
    idling: bool,
    command: Option<Command>,
    dies: bool,
}

/// What the engine may do, as far as the interlock is told: at rest, and idling. Not both.
const ENGINES: [(bool, bool); 3] = [(false, false), (true, false), (false, true)];

fn choices() -> Vec<Choice> {
    let commands = [None, Some(Command::Enable), Some(Command::Go), Some(Command::Stop), Some(Command::Acknowledge)];
    let instants = [
        None,
        Some(Cause::EmergencyStop),
        Some(Cause::Overspeed),
        Some(Cause::RecordingFailed),
        Some(Cause::OutputFailed),
        Some(Cause::BrakeJammed),
        Some(Cause::SpeedStuck),
        Some(Cause::SpeedsLost),
        Some(Cause::DeviceRestarted),
    ];
    let mut all = Vec::new();
    for link in [true, false] {
        for temperature in [Temperature::Good, Temperature::Hot, Temperature::Unreadable] {
            for (bits, (at_rest, idling)) in (0..4).flat_map(|bits| ENGINES.map(|engine| (bits, engine))) {
                let (brake_on, torque_stuck) = (bits & 1 != 0, bits & 2 != 0);
                let calm = Choice {
                    link,
                    temperature,
                    brake_on,
                    torque_stuck,
                    instant: None,
                    at_rest,
                    idling,
                    command: None,
                    dies: false,
                };
                for instant in instants {
                    all.extend(commands.map(|command| Choice { instant, command, ..calm }));
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
        Self {
            interlock,
            outputs: interlock.allowed(),
            permit: 0,
            dead: false,
            reset_unseen: false,
            lasted: Lasted::default(),
        }
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
        let happens = |cause: Cause| choice.instant == Some(cause);
        if happens(Cause::DeviceRestarted) {
            self.permit = 0;
            self.reset_unseen = true;
        }
        let inputs = Inputs {
            fresh_frame: choice.link,
            device_restarted: choice.link && std::mem::take(&mut self.reset_unseen),
            temperature: choice.temperature,
            brake_on: choice.brake_on,
            brake_jammed: happens(Cause::BrakeJammed),
            overspeed: happens(Cause::Overspeed),
            torque_stuck: choice.torque_stuck,
            speed_stuck: happens(Cause::SpeedStuck),
            speeds_lost: happens(Cause::SpeedsLost),
            recording: !happens(Cause::RecordingFailed),
            outputs: !happens(Cause::OutputFailed),
            emergency_stop: happens(Cause::EmergencyStop),
            at_rest: choice.at_rest,
            idling: choice.idling,
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
            torque_stuck: longer(self.torque_stuck, choice.torque_stuck, LIMITS.torque_ms),
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
        (alive_power && lasted.instant > 0, "5: power under a cause that ends it at once"),
        (power && beyond(lasted.dead, PERMIT_STEPS * STEP_MS), "6: power after the program's death"),
        (outputs.throttle != (mode == Mode::Running), "7: throttle open outside Running, or not in it"),
        (outputs.ignition != matches!(mode, Mode::Ready | Mode::Running), "7: ignition outside Ready and Running"),
        (outputs.throttle && outputs.brake == BrakeAllowed::Any, "7: the brake may be let go under power"),
        (alive_power && beyond(lasted.torque_stuck, LIMITS.torque_ms), "10: power without a torque"),
        (power && world.reset_unseen, "11: power after a reset of the device"),
    ]
    .into_iter()
    .find_map(|(is, name)| is.then_some(name))
}

/// Invariants 8 and 12, of one transition.
fn broken_by(before: &World, choice: Choice, after: &World) -> Option<&'static str> {
    if after.outputs.throttle && !before.outputs.throttle && !choice.idling {
        return Some("12: the throttle opens though the engine does not idle");
    }
    let (Mode::Tripped(_), mode) = (before.interlock.mode(), after.interlock.mode()) else { return None };
    let left = !matches!(mode, Mode::Tripped(_));
    // A reset that no frame has told of yet is no cause yet.
    let unknown = choice.instant == Some(Cause::DeviceRestarted) && !choice.link;
    let gone = choice.instant.is_none() || unknown;
    let rightly = mode == Mode::Safe && choice.command == Some(Command::Acknowledge) && gone;
    (left && !rightly).then_some("8: a trip was left without being acknowledged")
}

/// A quick hash: hundreds of millions of states are looked up.
#[derive(Clone, Copy, Default)]
struct Fold(u64);

impl Fold {
    fn fold(&mut self, value: u64) {
        self.0 = (self.0.rotate_left(5) ^ value).wrapping_mul(0x517c_c1b7_2722_0a95);
    }
}

impl Hasher for Fold {
    fn write(&mut self, bytes: &[u8]) {
        bytes.iter().for_each(|byte| self.fold(u64::from(*byte)));
    }

    fn write_u8(&mut self, value: u8) {
        self.fold(u64::from(value));
    }

    fn write_u16(&mut self, value: u16) {
        self.fold(u64::from(value));
    }

    fn write_isize(&mut self, value: isize) {
        self.fold(value as u64);
    }

    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 29)
    }
}

type Quick = BuildHasherDefault<Fold>;
type Worlds = HashSet<World, Quick>;

struct Found {
    states: Worlds,
    transitions: u64,
    predecessors: HashMap<World, Vec<World>, Quick>,
    broken: Option<String>,
}

/// Visits everything, nearest states first, so that what is found broken is broken in the fewest steps.
fn explore(limits: Limits, keep_predecessors: bool) -> Found {
    let choices = choices();
    let start = World::new(limits);
    let mut found = Found {
        states: Worlds::from_iter([start]),
        transitions: 0,
        predecessors: HashMap::default(),
        broken: broken(&start).map(str::to_owned),
    };
    let mut open = VecDeque::from([start]);
    let mut successors = Worlds::default();
    while let Some(world) = open.pop_front() {
        for choice in &choices {
            let next = world.next(*choice);
            found.transitions += 1;
            if let Some(name) = broken(&next).or_else(|| broken_by(&world, *choice, &next)) {
                found.broken = Some(format!("{name}: {world:?} -> {choice:?} -> {next:?}"));
                return found;
            }
            successors.insert(next);
        }
        for next in successors.drain() {
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
    let found = explore(LIMITS, true);
    assert_eq!(found.broken, None);
    println!("{} states, {} transitions", found.states.len(), found.transitions);
    assert!(found.states.iter().any(World::power), "nothing was shown if power never comes on");
    // Invariant 9: backwards from Safe, every state in which the program lives is found.
    let mut reaches: Worlds =
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
const STATES: usize = 130_180;
const TRANSITIONS: u64 = 421_913_380;

/// The check itself can fail: with any limit too long it finds the invariant that this breaks.
#[test]
fn a_limit_that_is_too_long_is_found() {
    for (limits, number) in [
        (Limits { link_ms: 300, ..LIMITS }, "1:"),
        (Limits { brake_ms: 400, ..LIMITS }, "2:"),
        (Limits { hot_ms: 300, ..LIMITS }, "3:"),
        (Limits { unreadable_ms: 500, ..LIMITS }, "4:"),
        (Limits { torque_ms: 400, ..LIMITS }, "10:"),
    ] {
        let broken = explore(limits, false).broken.unwrap();
        assert!(broken.starts_with(number), "{broken}");
    }
}
