//! The three codes, each solving a case in one of its configurations.

use crate::cases::{Case, Condition, STATES};
use crate::fortran::peers;
use crate::reference::Truth;
use crate::system::{stated, system_derivatives, system_values};
use solver::{Options, Order};
use std::cell::{Cell, RefCell};
use std::ffi::c_int;
use std::fmt;
use std::slice::{from_raw_parts, from_raw_parts_mut};
use std::time::Instant;

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Code {
    Here,
    Colnew,
    Twpbvpc,
}

/// What a code can be told.
#[derive(Debug, Clone, Copy)]
pub enum Configuration {
    Here { order: Order, tolerance: f64, intervals: usize, correction: bool },
    Colnew { points: c_int, tolerance: f64, intervals: c_int },
    Twpbvpc { conditioning: bool, tolerance: f64 },
}

/// Order or points, then the tolerance; a star: with defect correction here, with conditioning in TWPBVPC.
impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let star = |wanted: bool| if wanted { " *" } else { "" };
        match self {
            Self::Here { order, tolerance, correction, .. } => {
                let gauss = if *order == Order::SixGauss { " (Gauss)" } else { "" };
                write!(f, "{}{gauss}, {tolerance:.0e}{}", order.number(), star(*correction))
            }
            Self::Colnew { points, tolerance, .. } => write!(f, "{points}, {tolerance:.0e}"),
            Self::Twpbvpc { conditioning, tolerance } => write!(f, "{tolerance:.0e}{}", star(*conditioning)),
        }
    }
}

/// What a run brought.
#[derive(Debug, Clone, Copy)]
pub struct Run {
    pub seconds: f64,
    /// Largest at the nodes, relative to the largest |u|, or to 1 where that is smaller.
    pub error: f64,
    pub intervals: usize,
}

impl Code {
    pub const ALL: [Self; 3] = [Self::Here, Self::Colnew, Self::Twpbvpc];

    /// None of TWPBVPC where equations are undefined at an end: it evaluates them there.
    pub fn configurations(self, case: &Case) -> Vec<Configuration> {
        let tolerances = (3..=11).map(|digits| 10.0_f64.powi(-digits));
        let orders: &[Order] = if case.is_singular() {
            &[Order::Eight, Order::SixGauss]
        } else {
            &[Order::Four, Order::Six, Order::Eight]
        };
        let with = |tolerance: f64| -> Vec<Configuration> {
            match self {
                Self::Here => orders
                    .iter()
                    .copied()
                    .flat_map(|order| [4, 8, 16].map(|intervals| (order, intervals)))
                    .flat_map(|(order, intervals)| {
                        [false, true].map(|correction| Configuration::Here { order, tolerance, intervals, correction })
                    })
                    .collect(),
                Self::Colnew => (3..=7)
                    .flat_map(|points| {
                        [5, 10, 20].map(|intervals| Configuration::Colnew { points, tolerance, intervals })
                    })
                    .collect(),
                Self::Twpbvpc if case.is_singular() => Vec::new(),
                Self::Twpbvpc => {
                    [true, false].map(|conditioning| Configuration::Twpbvpc { conditioning, tolerance }).to_vec()
                }
            }
        };
        tolerances.flat_map(with).collect()
    }

    /// `None` if the code fails.
    pub fn solve(self, case: &'static Case, configuration: &Configuration) -> Option<Found> {
        match *configuration {
            Configuration::Here { order, tolerance, intervals, correction } => {
                let options = Options { order, tolerance, defect_correction: correction, ..Options::default() };
                here(case, &options, intervals)
            }
            Configuration::Colnew { points, tolerance, intervals } => colnew(case, points, tolerance, intervals),
            Configuration::Twpbvpc { conditioning, tolerance } => twpbvpc(case, conditioning, tolerance),
        }
    }
}

/// What a code found.
pub struct Found {
    pub seconds: f64,
    nodes: Vec<f64>,
    /// All states at each node.
    values: Vec<f64>,
}

impl Found {
    pub fn judged(&self, case: &Case, truth: &Truth) -> Run {
        let mut worst = 0.0_f64;
        for (i, state) in case.unknowns().enumerate() {
            let (mut error, mut size) = (0.0_f64, 1.0_f64);
            for (&x, z) in self.nodes.iter().zip(self.values.chunks_exact(case.states())) {
                let u = match truth {
                    Truth::Exact => case.exact(x).unwrap()[i],
                    Truth::Computed(solution) => solution.regions()[0].eval(x)[state],
                };
                (error, size) = (error.max((z[state] - u).abs()), size.max(u.abs()));
            }
            worst = worst.max(error / size);
        }
        let error = if self.values.iter().all(|u| u.is_finite()) { worst } else { f64::INFINITY };
        Run { seconds: self.seconds, error, intervals: self.nodes.len() - 1 }
    }
}

fn here(case: &'static Case, options: &Options, intervals: usize) -> Option<Found> {
    // The peers' are known beforehand too.
    let conditions = case.conditions();
    let start = Instant::now();
    let problem = stated(case, conditions, intervals);
    // The peers are told as much.
    let problem = if case.linear { problem.linear() } else { problem };
    let solution = problem.solve(options).ok()?;
    let seconds = start.elapsed().as_secs_f64();
    let line = &solution.regions()[0];
    let values = (0..line.mesh().len()).flat_map(|j| (0..case.states()).map(move |i| line.state(i)[j]));
    Some(Found { seconds, nodes: line.mesh().to_vec(), values: values.collect() })
}

// The case that the callbacks below belong to, and what is given at its ends.
thread_local! {
    static CURRENT: Cell<Option<&'static Case>> = const { Cell::new(None) };
    static CONDITIONS: RefCell<Vec<Condition>> = const { RefCell::new(Vec::new()) };
}

fn current() -> &'static Case {
    CURRENT.get().unwrap()
}

fn choose(case: &'static Case) {
    CURRENT.set(Some(case));
    CONDITIONS.replace(case.conditions());
}

fn given(i: usize) -> Condition {
    CONDITIONS.with_borrow(|conditions| conditions[i])
}

/// The highest derivatives alone: COLNEW takes equations as they are.
extern "C" fn highest(_: *const c_int, x: *const f64, z: *const f64, f: *mut f64, _: *mut f64, _: *mut c_int) {
    let case = current();
    // SAFETY: COLNEW hands over one x, all z and room for one value an equation.
    unsafe {
        case.values(*x, from_raw_parts(z, case.states()), from_raw_parts_mut(f, case.equations()));
    }
}

extern "C" fn highest_jacobian(
    _: *const c_int,
    x: *const f64,
    z: *const f64,
    df: *mut f64,
    _: *mut f64,
    _: *mut c_int,
) {
    let (case, mut values, mut rows) = (current(), [0.0; STATES], [0.0; STATES * STATES]);
    let (count, states) = (case.equations(), case.states());
    // SAFETY: as above, with room for all derivatives, by columns.
    unsafe {
        let z = from_raw_parts(z, states);
        case.derivatives(*x, z, &mut values[..count], &mut rows[..count * states]);
        let out = from_raw_parts_mut(df, count * states);
        (0..count).for_each(|i| (0..states).for_each(|j| out[j * count + i] = rows[i * states + j]));
    }
}

/// As a system of first order.
extern "C" fn first(_: *const c_int, x: *const f64, z: *const f64, f: *mut f64, _: *mut f64, _: *mut c_int) {
    let case = current();
    // SAFETY: TWPBVPC hands over one x, all z and room for one value a state.
    unsafe { system_values(case, *x, from_raw_parts(z, case.states()), from_raw_parts_mut(f, case.states())) };
}

extern "C" fn first_jacobian(_: *const c_int, x: *const f64, z: *const f64, df: *mut f64, _: *mut f64, _: *mut c_int) {
    let case = current();
    let states = case.states();
    // SAFETY: as above, with room for all derivatives, by columns.
    unsafe {
        let out = from_raw_parts_mut(df, states * states);
        system_derivatives(case, *x, from_raw_parts(z, states), out, None);
    }
}

extern "C" fn condition(i: *const c_int, _: *const c_int, z: *const f64, g: *mut f64, _: *mut f64, _: *mut c_int) {
    // SAFETY: one index, from 1, and all z.
    unsafe {
        let given = given((*i - 1) as usize);
        *g = *z.add(given.state) - given.value;
    }
}

extern "C" fn condition_jacobian(
    i: *const c_int,
    _: *const c_int,
    _: *const f64,
    dg: *mut f64,
    _: *mut f64,
    _: *mut c_int,
) {
    // SAFETY: one index, from 1, and room for the derivatives by all z.
    unsafe {
        let out = from_raw_parts_mut(dg, current().states());
        out.fill(0.0);
        out[given((*i - 1) as usize).state] = 1.0;
    }
}

/// The guess of all z, and of the highest derivatives.
extern "C" fn guess(x: *const f64, z: *mut f64, dm: *mut f64, _: *mut f64, _: *mut c_int) {
    let case = current();
    // SAFETY: one x, room for all z, and for one value an equation.
    unsafe {
        let (z, dm) = (from_raw_parts_mut(z, case.states()), from_raw_parts_mut(dm, case.equations()));
        case.guess(*x, z);
        case.values(*x, z, dm);
    }
}

/// Whether the guess is zero, which the peers need not be given.
fn is_from_zero(case: &Case) -> bool {
    let (mut z, (a, b)) = ([0.0; STATES], case.interval);
    case.guess(0.7 * a + 0.3 * b, &mut z[..case.states()]);
    z.iter().all(|z| *z == 0.0)
}

/// Room for work, asked for once: what the peers' callers do outside the time that is taken.
struct Room {
    reals: Vec<f64>,
    integers: Vec<c_int>,
    mesh: Vec<f64>,
    values: Vec<f64>,
}

thread_local! {
    static ROOM: RefCell<Room> = RefCell::new(Room {
        reals: vec![0.0; 6_000_000],
        integers: vec![0; 400_000],
        mesh: vec![0.0; NODES],
        values: vec![0.0; STATES * NODES],
    });
}

const NODES: usize = 20_000;

/// The u whose errors the peers hold to the tolerance, from 1, and the tolerance of each.
fn held(case: &Case, tolerance: f64) -> (Vec<c_int>, Vec<f64>) {
    (case.unknowns().map(|state| state as c_int + 1).collect(), vec![tolerance; case.equations()])
}

fn colnew(case: &'static Case, points: c_int, tolerance: f64, intervals: c_int) -> Option<Found> {
    choose(case);
    let (a, b) = case.interval;
    ROOM.with_borrow_mut(|room| {
        let (reals, integers) = (room.reals.len() as c_int, room.integers.len() as c_int);
        let nonlinear = c_int::from(!case.linear);
        let (count, states, from_zero) = (case.equations(), case.states(), is_from_zero(case));
        let orders: Vec<c_int> = case.orders().iter().map(|&order| order as c_int).collect();
        let conditions = case.conditions();
        let places: Vec<f64> = conditions.iter().map(|given| if given.on_the_right { b } else { a }).collect();
        let (held, tolerances) = held(case, tolerance);
        let guessed = c_int::from(!from_zero);
        let mut settings = [nonlinear, points, intervals, count as c_int, reals, integers, 1, 0, guessed, 0, 0, 0, 0];
        let (mut flag, mut counts, mut rpar, mut ipar) = (0, [0; 16], [0.0; 1], [0; 1]);
        let start = Instant::now();
        // SAFETY: arguments as the head of the sources asks for, arrays of the lengths stated in them.
        unsafe {
            (peers().colnew)(
                &(count as c_int),
                orders.as_ptr(),
                &a,
                &b,
                places.as_ptr(),
                settings.as_mut_ptr(),
                // The tolerance is for u alone, as in TWPBVPC.
                held.as_ptr(),
                tolerances.as_ptr(),
                [0.0].as_ptr(),
                room.integers.as_mut_ptr(),
                room.reals.as_mut_ptr(),
                &mut flag,
                highest,
                highest_jacobian,
                condition,
                condition_jacobian,
                guess,
                rpar.as_mut_ptr(),
                ipar.as_mut_ptr(),
                counts.as_mut_ptr(),
            );
        }
        let seconds = start.elapsed().as_secs_f64();
        if flag != 1 {
            return None;
        }
        let intervals = room.integers[0] as usize;
        let nodes = room.reals[..=intervals].to_vec();
        let mut values = vec![0.0; states * nodes.len()];
        for (&node, z) in nodes.iter().zip(values.chunks_exact_mut(states)) {
            let mut x = node;
            // SAFETY: the work arrays are those that COLNEW has filled.
            unsafe { (peers().appsln)(&mut x, z.as_mut_ptr(), room.reals.as_mut_ptr(), room.integers.as_mut_ptr()) };
        }
        Some(Found { seconds, nodes, values })
    })
}

/// Nodes of the guess that TWPBVPC is given, where it is not zero: a function it does not take.
const GUESSED: c_int = 12;

fn twpbvpc(case: &'static Case, conditioning: bool, tolerance: f64) -> Option<Found> {
    choose(case);
    let (a, b) = case.interval;
    ROOM.with_borrow_mut(|room| {
        let (states, from_zero) = (case.states(), is_from_zero(case));
        let left = case.conditions().iter().filter(|given| !given.on_the_right).count() as c_int;
        let (held, tolerances) = held(case, tolerance);
        let (mut nodes, mut most, mut flag, mut meshes) = (0, 0, 0, 0);
        if !from_zero {
            nodes = GUESSED;
            for (k, z) in room.values.chunks_exact_mut(states).take(GUESSED as usize).enumerate() {
                room.mesh[k] = a + (b - a) * k as f64 / f64::from(GUESSED - 1);
                case.guess(room.mesh[k], z);
            }
        }
        let (mut rpar, mut ipar, mut settings, mut series) = ([0.0; 1], [0; 1], [0; 6], [0; 200]);
        let mut condition_numbers = [0.0; 5];
        let [kappa1, gamma1, sigma, kappa, kappa2] = &mut condition_numbers;
        let (reals, integers) = (room.reals.len() as c_int, room.integers.len() as c_int);
        let start = Instant::now();
        // SAFETY: arguments as the head of the sources asks for, arrays of the lengths stated in them.
        unsafe {
            (peers().twpbvpc)(
                &(states as c_int),
                &left,
                &a,
                &b,
                &0,
                [0.0].as_ptr(),
                &(held.len() as c_int),
                held.as_ptr(),
                tolerances.as_ptr(),
                &c_int::from(case.linear),
                &c_int::from(!from_zero),
                &c_int::from(!from_zero),
                &mut nodes,
                &(NODES as c_int),
                room.mesh.as_mut_ptr(),
                &(states as c_int),
                room.values.as_mut_ptr(),
                &mut most,
                &reals,
                room.reals.as_mut_ptr(),
                &integers,
                room.integers.as_mut_ptr(),
                [f64::MIN_POSITIVE, f64::MAX, f64::EPSILON / 2.0].as_ptr(),
                first,
                first_jacobian,
                condition,
                condition_jacobian,
                kappa1,
                gamma1,
                sigma,
                kappa,
                kappa2,
                rpar.as_mut_ptr(),
                ipar.as_mut_ptr(),
                &mut flag,
                &(series.len() as c_int),
                series.as_mut_ptr(),
                &mut meshes,
                &0,
                &c_int::from(conditioning),
                &1,
                [0.0].as_ptr(),
                &(states as c_int),
                [0.0; STATES].as_ptr(),
                settings.as_mut_ptr(),
            );
        }
        let seconds = start.elapsed().as_secs_f64();
        if !(flag == 0 || flag == -1) || nodes < 2 {
            return None;
        }
        let count = nodes as usize;
        Some(Found { seconds, nodes: room.mesh[..count].to_vec(), values: room.values[..states * count].to_vec() })
    })
}
