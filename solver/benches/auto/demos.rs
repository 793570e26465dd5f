//! Three of AUTO's demos, restated: `exp` (Bratu's problem), `int` (an integral constraint), `bvp` (branch points).

use solver::{Guess, Layout, Points, Problem, Region, Scope};
use std::f64::consts::PI;

/// A branch in λ from λ = 0 and u = 0.
pub struct Demo {
    pub name: &'static str,
    /// The equations for AUTO, with their derivatives.
    pub fortran: &'static str,
    /// Boundary conditions and integral constraints.
    pub conditions: [usize; 2],
    /// AUTO's unit of steps, of which several are tried: 0.2, and where the demo allows it more.
    pub largest_steps: &'static [f64],
    /// Largest steps here, in which every component counts relative to its size.
    pub largest_steps_here: &'static [f64],
    pub wanted: Wanted,
}

/// What is to be located, and where the branch ends.
pub enum Wanted {
    /// The fold, and the parameter's value `at` on both sides of it, where the branch ends.
    Fold { at: f64 },
    /// So many branch points, at λ = 1, 2, ... up to the parameter's value `to`.
    BranchPoints { count: usize, to: f64 },
}

/// What of a branch is compared.
#[derive(Debug, Default)]
pub struct Located {
    /// λ of folds.
    pub folds: Vec<f64>,
    /// λ and u'(0) where λ was to be met.
    pub met: Vec<[f64; 2]>,
    /// λ of branch points.
    pub branch_points: Vec<f64>,
}

impl Wanted {
    /// The largest relative error; infinite if there is more or less than is wanted.
    pub fn error(&self, found: &Located, reference: &Located) -> f64 {
        let relative = |a: f64, b: f64| ((a - b) / b).abs();
        let errors: Vec<f64> = match self {
            Self::Fold { .. } => {
                if found.folds.len() != 1 || found.met.len() != 2 {
                    return f64::INFINITY;
                }
                let pairs = found.met.iter().zip(&reference.met);
                let met = pairs.flat_map(|(a, b)| [relative(a[0], b[0]), relative(a[1], b[1])]);
                met.chain([relative(found.folds[0], reference.folds[0])]).collect()
            }
            // Those of the equations themselves.
            Self::BranchPoints { count, .. } => {
                if found.branch_points.len() != *count {
                    return f64::INFINITY;
                }
                found.branch_points.iter().zip(1..).map(|(found, k)| relative(*found, f64::from(k))).collect()
            }
        };
        errors.into_iter().fold(0.0, f64::max)
    }
}

pub static DEMOS: &[Demo] = &[
    Demo {
        name: "exp",
        fortran: EXP,
        conditions: [2, 0],
        largest_steps: &[0.2, 0.5, 1.0, 2.0],
        largest_steps_here: &[0.2, 0.5, 1.0, 2.0],
        wanted: Wanted::Fold { at: 0.5 },
    },
    Demo {
        name: "int",
        fortran: INT,
        conditions: [1, 1],
        largest_steps: &[0.2, 0.5, 1.0, 2.0, 5.0],
        largest_steps_here: &[0.2, 0.5, 1.0, 2.0],
        wanted: Wanted::Fold { at: 1.0 },
    },
    Demo {
        name: "bvp",
        fortran: BVP,
        conditions: [2, 0],
        largest_steps: &[0.2, 0.4, 0.7, 0.9],
        largest_steps_here: &[0.04, 0.08, 0.14, 0.18],
        wanted: Wanted::BranchPoints { count: 5, to: 5.5 },
    },
];

const EXP: &str = "\
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: e
  e = exp(u(1))
  f(1) = u(2)
  f(2) = -par(1)*e
  if (ijac == 0) return
  dfdu(1, 1) = 0
  dfdu(1, 2) = 1
  dfdu(2, 1) = -par(1)*e
  dfdu(2, 2) = 0
  if (ijac == 1) return
  dfdp(1, 1) = 0
  dfdp(2, 1) = -e
end subroutine

subroutine bcnd(ndim, par, icp, nbc, a, b, g, ijac, dg)
  implicit none
  integer, intent(in) :: ndim, icp(*), nbc, ijac
  double precision, intent(in) :: par(*), a(ndim), b(ndim)
  double precision, intent(out) :: g(nbc)
  double precision, intent(inout) :: dg(nbc, *)
  g(1) = a(1)
  g(2) = b(1)
  if (ijac == 0) return
  dg(1:2, 1:5) = 0
  dg(1, 1) = 1
  dg(2, 3) = 1
end subroutine

subroutine icnd
end subroutine
";

const INT: &str = "\
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision :: e
  e = exp(u(1))
  f(1) = u(2)
  f(2) = -par(1)*e
  if (ijac == 0) return
  dfdu(1, 1) = 0
  dfdu(1, 2) = 1
  dfdu(2, 1) = -par(1)*e
  dfdu(2, 2) = 0
  if (ijac == 1) return
  dfdp(1, 1) = 0
  dfdp(2, 1) = -e
end subroutine

subroutine bcnd(ndim, par, icp, nbc, a, b, g, ijac, dg)
  implicit none
  integer, intent(in) :: ndim, icp(*), nbc, ijac
  double precision, intent(in) :: par(*), a(ndim), b(ndim)
  double precision, intent(out) :: g(nbc)
  double precision, intent(inout) :: dg(nbc, *)
  g(1) = a(1) - b(1)
  if (ijac == 0) return
  dg(1, 1:5) = 0
  dg(1, 1) = 1
  dg(1, 3) = -1
end subroutine

subroutine icnd(ndim, par, icp, nint, u, uold, udot, upold, q, ijac, dq)
  implicit none
  integer, intent(in) :: ndim, icp(*), nint, ijac
  double precision, intent(in) :: par(*), u(ndim), uold(ndim), udot(ndim), upold(ndim)
  double precision, intent(out) :: q(nint)
  double precision, intent(inout) :: dq(nint, *)
  q(1) = u(1)
  if (ijac == 0) return
  dq(1, 1:3) = 0
  dq(1, 1) = 1
end subroutine
";

const BVP: &str = "\
subroutine func(ndim, u, icp, par, ijac, f, dfdu, dfdp)
  implicit none
  integer, intent(in) :: ndim, icp(*), ijac
  double precision, intent(in) :: u(ndim), par(*)
  double precision, intent(out) :: f(ndim)
  double precision, intent(inout) :: dfdu(ndim, ndim), dfdp(ndim, *)
  double precision, parameter :: pi = 4*atan(1d0)
  f(1) = u(2)
  f(2) = u(1)**2 - (par(1)*pi)**2*u(1)
  if (ijac == 0) return
  dfdu(1, 1) = 0
  dfdu(1, 2) = 1
  dfdu(2, 1) = 2*u(1) - (par(1)*pi)**2
  dfdu(2, 2) = 0
  if (ijac == 1) return
  dfdp(1, 1) = 0
  dfdp(2, 1) = -2*par(1)*pi**2*u(1)
end subroutine

subroutine bcnd(ndim, par, icp, nbc, a, b, g, ijac, dg)
  implicit none
  integer, intent(in) :: ndim, icp(*), nbc, ijac
  double precision, intent(in) :: par(*), a(ndim), b(ndim)
  double precision, intent(out) :: g(nbc)
  double precision, intent(inout) :: dg(nbc, *)
  g(1) = a(1)
  g(2) = b(1)
  if (ijac == 0) return
  dg(1:2, 1:5) = 0
  dg(1, 1) = 1
  dg(2, 3) = 1
end subroutine

subroutine icnd
end subroutine
";

/// A demo as the library is given it: by hand, with the derivatives that AUTO is given.
pub struct Stated {
    demo: &'static Demo,
    layout: Layout,
}

impl Stated {
    pub fn new(demo: &'static Demo) -> Self {
        let integrals: &[&str] = if demo.conditions[1] > 0 { &["u"] } else { &[] };
        let mut line = Region::dense("line", (0.0, 1.0), &["u", "slope"], integrals, 1);
        line.state_pattern = [(0, 1), (1, 0)].into_iter().chain(integrals.iter().map(|_| (2, 0))).collect();
        line.constant_pattern = vec![(1, 0)];
        line.default_entries = 0;
        let mut layout = Layout::dense(vec![line], &["lambda"], &["first", "second"]);
        // Steps are relative to this.
        layout.constants[0].scale = matches!(demo.wanted, Wanted::BranchPoints { .. }).then_some(5.0);
        layout.boundary_pattern =
            if demo.conditions[1] > 0 { vec![(0, 0), (0, 2), (1, 4)] } else { vec![(0, 0), (1, 2)] };
        Self { demo, layout }
    }

    pub fn start(&self, intervals: usize) -> Guess {
        Guess::uniform(&self.layout, intervals, &[0.0], |_, _, y| y.fill(0.0))
    }

    fn branches(&self) -> bool {
        matches!(self.demo.wanted, Wanted::BranchPoints { .. })
    }
}

impl Problem for Stated {
    fn layout(&self) -> &Layout {
        &self.layout
    }

    fn rhs(&self, _: usize, at: &Points<'_>, c: &[f64], f: &mut [f64]) {
        let m = at.stride;
        let (u, v) = (&at.y[..at.len], &at.y[m..m + at.len]);
        f[..at.len].copy_from_slice(v);
        let square = (c[0] * PI).powi(2);
        for (f, u) in f[m..].iter_mut().zip(u) {
            *f = if self.branches() { u * u - square * u } else { -c[0] * u.exp() };
        }
        if self.demo.conditions[1] > 0 {
            f[2 * m..2 * m + at.len].copy_from_slice(u);
        }
    }

    fn rhs_jacobian(
        &self,
        _: usize,
        at: &Points<'_>,
        c: &[f64],
        _: Scope,
        f: &mut [f64],
        dy: &mut [f64],
        dc: &mut [f64],
    ) {
        let m = at.stride;
        let (u, v) = (&at.y[..at.len], &at.y[m..m + at.len]);
        f[..at.len].copy_from_slice(v);
        dy[..at.len].fill(1.0);
        let square = (c[0] * PI).powi(2);
        for (p, &u) in u.iter().enumerate() {
            let (value, by_u, by_lambda) = if self.branches() {
                (u * u - square * u, 2.0 * u - square, -2.0 * c[0] * PI * PI * u)
            } else {
                let e = u.exp();
                (-c[0] * e, -c[0] * e, -e)
            };
            (f[m + p], dy[m + p]) = (value, by_u);
            if let Some(entry) = dc.get_mut(p) {
                *entry = by_lambda;
            }
        }
        if self.demo.conditions[1] > 0 {
            f[2 * m..2 * m + at.len].copy_from_slice(u);
            dy[2 * m..2 * m + at.len].fill(1.0);
        }
    }

    fn boundary(&self, ends: &[f64], integrals: &[f64], _: &[f64], g: &mut [f64]) {
        match integrals {
            [mean, ..] => (g[0], g[1]) = (ends[0] - ends[2], *mean),
            [] => (g[0], g[1]) = (ends[0], ends[2]),
        }
    }

    fn boundary_jacobian(&self, ends: &[f64], integrals: &[f64], c: &[f64], g: &mut [f64], dz: &mut [f64]) {
        self.boundary(ends, integrals, c, g);
        let values: &[f64] = if integrals.is_empty() { &[1.0, 1.0] } else { &[1.0, -1.0, 1.0] };
        dz[..values.len()].copy_from_slice(values);
    }
}
