//! The three codes, each solving a case in one of its configurations.

use crate::cases::{CASES, Case};
use crate::fortran::peers;
use crate::system::{ends, stated, system_derivatives};
use solver::{Options, Order};
use std::cell::{Cell, RefCell};
use std::ffi::c_int;
use std::fmt;
use std::slice::{from_raw_parts, from_raw_parts_mut};
use std::sync::atomic::{AtomicUsize, Ordering};
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
                write!(f, "{}, {tolerance:.0e}{}", order.number(), star(*correction))
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

    pub fn configurations(self) -> Vec<Configuration> {
        let tolerances = (3..=11).map(|digits| 10.0_f64.powi(-digits));
        let with = |tolerance: f64| -> Vec<Configuration> {
            match self {
                Self::Here => [Order::Four, Order::Six, Order::Eight]
                    .into_iter()
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
                Self::Twpbvpc => {
                    [true, false].map(|conditioning| Configuration::Twpbvpc { conditioning, tolerance }).to_vec()
                }
            }
        };
        tolerances.flat_map(with).collect()
    }

    /// `None` if the code fails.
    pub fn solve(self, case: &'static Case, configuration: &Configuration) -> Option<Run> {
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

/// `values`: at each node, states u₁, u₁', ...
fn run(case: &Case, seconds: f64, nodes: &[f64], values: &[f64]) -> Run {
    let states = 2 * case.equations();
    let (mut error, mut size) = ([0.0_f64; 2], [1.0_f64; 2]);
    for (&x, z) in nodes.iter().zip(values.chunks_exact(states)) {
        let exact = case.exact(x);
        for i in 0..case.equations() {
            error[i] = error[i].max((z[2 * i] - exact[i]).abs());
            size[i] = size[i].max(exact[i].abs());
        }
    }
    let error = (error[0] / size[0]).max(error[1] / size[1]);
    let error = if values.iter().all(|u| u.is_finite()) { error } else { f64::INFINITY };
    Run { seconds, error, intervals: nodes.len() - 1 }
}

fn here(case: &'static Case, options: &Options, intervals: usize) -> Option<Run> {
    // The peers' are known beforehand too.
    let ends = ends(case);
    let start = Instant::now();
    let problem = stated(case, ends, intervals);
    // The peers are told as much.
    let problem = if case.linear { problem.linear() } else { problem };
    let solution = problem.solve(options).ok()?;
    let seconds = start.elapsed().as_secs_f64();
    let line = &solution.regions()[0];
    let values = (0..line.mesh().len()).flat_map(|j| (0..2 * case.equations()).map(move |i| line.state(i)[j]));
    Some(run(case, seconds, line.mesh(), &values.collect::<Vec<_>>()))
}

/// The case that the callbacks below belong to, and its boundary values.
static CURRENT: AtomicUsize = AtomicUsize::new(0);

thread_local! {
    static ENDS: Cell<[f64; 4]> = const { Cell::new([0.0; 4]) };
}

fn current() -> &'static Case {
    &CASES[CURRENT.load(Ordering::Relaxed)]
}

fn choose(case: &'static Case) {
    let at = CASES.iter().position(|other| std::ptr::eq(other, case)).unwrap();
    CURRENT.store(at, Ordering::Relaxed);
    ENDS.set(ends(case));
}

/// F alone: COLNEW takes equations of second order.
extern "C" fn second(_: *const c_int, x: *const f64, z: *const f64, f: *mut f64, _: *mut f64, _: *mut c_int) {
    let (case, mut values) = (current(), [0.0; 2]);
    // SAFETY: COLNEW hands over one x, all z and room for one value an equation.
    unsafe {
        case.values(*x, from_raw_parts(z, 2 * case.equations()), &mut values);
        from_raw_parts_mut(f, case.equations()).copy_from_slice(&values[..case.equations()]);
    }
}

extern "C" fn second_jacobian(_: *const c_int, x: *const f64, z: *const f64, df: *mut f64, _: *mut f64, _: *mut c_int) {
    let (case, mut values, mut rows) = (current(), [0.0; 2], [0.0; 8]);
    let (count, states) = (case.equations(), 2 * case.equations());
    // SAFETY: as above, with room for all derivatives, by columns.
    unsafe {
        case.derivatives(*x, from_raw_parts(z, states), &mut values, &mut rows);
        let out = from_raw_parts_mut(df, count * states);
        (0..count).for_each(|i| (0..states).for_each(|j| out[j * count + i] = rows[i * states + j]));
    }
}

/// As a system of first order.
extern "C" fn first(_: *const c_int, x: *const f64, z: *const f64, f: *mut f64, _: *mut f64, _: *mut c_int) {
    let (case, mut values) = (current(), [0.0; 2]);
    // SAFETY: TWPBVPC hands over one x, all z and room for one value a state.
    unsafe {
        let z = from_raw_parts(z, 2 * case.equations());
        case.values(*x, z, &mut values);
        let out = from_raw_parts_mut(f, z.len());
        (0..case.equations()).for_each(|i| (out[2 * i], out[2 * i + 1]) = (z[2 * i + 1], values[i]));
    }
}

extern "C" fn first_jacobian(_: *const c_int, x: *const f64, z: *const f64, df: *mut f64, _: *mut f64, _: *mut c_int) {
    let case = current();
    let states = 2 * case.equations();
    // SAFETY: as above, with room for all derivatives, by columns.
    unsafe {
        let out = from_raw_parts_mut(df, states * states);
        system_derivatives(case, *x, from_raw_parts(z, states), out, None);
    }
}

extern "C" fn condition(i: *const c_int, _: *const c_int, z: *const f64, g: *mut f64, _: *mut f64, _: *mut c_int) {
    // SAFETY: one index, from 1, and all z.
    unsafe {
        let at = (*i - 1) as usize;
        *g = *z.add(2 * (at % current().equations())) - ENDS.get()[at];
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
    let count = current().equations();
    // SAFETY: one index, from 1, and room for the derivatives by all z.
    unsafe {
        let out = from_raw_parts_mut(dg, 2 * count);
        out.fill(0.0);
        out[2 * ((*i - 1) as usize % count)] = 1.0;
    }
}

extern "C" fn no_guess(_: *const f64, z: *mut f64, dm: *mut f64, _: *mut f64, _: *mut c_int) {
    let count = current().equations();
    // SAFETY: room for all z, and for one u'' an equation.
    unsafe {
        from_raw_parts_mut(z, 2 * count).fill(0.0);
        from_raw_parts_mut(dm, count).fill(0.0);
    }
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
        values: vec![0.0; 4 * NODES],
    });
}

const NODES: usize = 20_000;

fn colnew(case: &'static Case, points: c_int, tolerance: f64, intervals: c_int) -> Option<Run> {
    choose(case);
    let (a, b) = case.interval;
    ROOM.with_borrow_mut(|room| {
        let (reals, integers) = (room.reals.len() as c_int, room.integers.len() as c_int);
        let nonlinear = c_int::from(!case.linear);
        let count = case.equations();
        let mut settings = [nonlinear, points, intervals, count as c_int, reals, integers, 1, 0, 0, 0, 0, 0, 0];
        let (mut flag, mut counts, mut rpar, mut ipar) = (0, [0; 16], [0.0; 1], [0; 1]);
        let start = Instant::now();
        // SAFETY: arguments as the head of the sources asks for, arrays of the lengths stated in them.
        unsafe {
            (peers().colnew)(
                &(count as c_int),
                [2, 2].as_ptr(),
                &a,
                &b,
                (if count == 1 { [a, b, 0.0, 0.0] } else { [a, a, b, b] }).as_ptr(),
                settings.as_mut_ptr(),
                // The tolerance is for u alone, as in TWPBVPC.
                [1, 3].as_ptr(),
                [tolerance; 2].as_ptr(),
                [0.0].as_ptr(),
                room.integers.as_mut_ptr(),
                room.reals.as_mut_ptr(),
                &mut flag,
                second,
                second_jacobian,
                condition,
                condition_jacobian,
                no_guess,
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
        let mut values = vec![0.0; 2 * count * nodes.len()];
        for (&node, z) in nodes.iter().zip(values.chunks_exact_mut(2 * count)) {
            let mut x = node;
            // SAFETY: the work arrays are those that COLNEW has filled.
            unsafe { (peers().appsln)(&mut x, z.as_mut_ptr(), room.reals.as_mut_ptr(), room.integers.as_mut_ptr()) };
        }
        Some(run(case, seconds, &nodes, &values))
    })
}

fn twpbvpc(case: &'static Case, conditioning: bool, tolerance: f64) -> Option<Run> {
    choose(case);
    let (a, b) = case.interval;
    ROOM.with_borrow_mut(|room| {
        let states = 2 * case.equations();
        let (mut nodes, mut most, mut flag, mut meshes) = (0, 0, 0, 0);
        let (mut rpar, mut ipar, mut settings, mut series) = ([0.0; 1], [0; 1], [0; 6], [0; 200]);
        let mut condition_numbers = [0.0; 5];
        let [kappa1, gamma1, sigma, kappa, kappa2] = &mut condition_numbers;
        let (reals, integers) = (room.reals.len() as c_int, room.integers.len() as c_int);
        let start = Instant::now();
        // SAFETY: arguments as the head of the sources asks for, arrays of the lengths stated in them.
        unsafe {
            (peers().twpbvpc)(
                &(states as c_int),
                &(states as c_int / 2),
                &a,
                &b,
                &0,
                [0.0].as_ptr(),
                &(states as c_int / 2),
                [1, 3].as_ptr(),
                [tolerance; 2].as_ptr(),
                &c_int::from(case.linear),
                &0,
                &0,
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
                [0.0; 4].as_ptr(),
                settings.as_mut_ptr(),
            );
        }
        let seconds = start.elapsed().as_secs_f64();
        if !(flag == 0 || flag == -1) || nodes < 2 {
            return None;
        }
        let count = nodes as usize;
        Some(run(case, seconds, &room.mesh[..count], &room.values[..states * count]))
    })
}
