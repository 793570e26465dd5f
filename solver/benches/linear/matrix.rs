//! A bordered almost block diagonal system, as Newton's iteration solves it, by three methods.
//!
//! The trapezoidal rule for `y' = A(s) y + b c`, five states, one unknown constant, and six boundary equations that mix
//! both ends and the constant.

use crate::linear::chain::{Block, Chain, Intervals, Reduced, Sizes};
use crate::linear::dense::Lu;
use crate::linear::reflect::{Fixed, Rows};
use crate::linear::scalar::{Lane, Scalar, W};
use crate::linear::simd::{Job, vectorised};
use crate::shortest;
use faer::linalg::solvers::{PartialPivLu, Solve};
use faer::sparse::linalg::solvers::{Lu as SparseLu, SymbolicLu};
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, MatMut};

/// Numbers of intervals that are compared: multiples of [`W`].
pub const SIZES: [usize; 10] = [16, 32, 64, 128, 256, 512, 1024, 4096, 16_384, 65_536];
const N: usize = 5;
const P: usize = 1;
pub const SHAPE: Sizes = Sizes { n: N, p: P, k: 0 };

pub struct Bordered {
    steps: usize,
    /// `a`, `b` and `c` of each interval by columns: `A u_t + B u_{t+1} + C c`.
    blocks: Vec<Block<Vec<f64>>>,
    /// Boundary equations by rows: first node, last node, constant.
    boundary: Vec<f64>,
    rhs: Vec<f64>,
    /// What `rhs` was made from.
    pub solution: Vec<f64>,
}

/// Numbers that look random but are always the same.
struct Random(u64);

impl Random {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64 * 2.0 - 1.0
    }
}

/// Entry of A(s): rotation, growth and decay at rates up to 8.
fn coefficient(i: usize, j: usize, s: f64) -> f64 {
    let phase = (3 * i + 7 * j) as f64;
    if i == j { 4.0 * (i as f64 - 2.0) } else { 3.0 * (phase + 2.0 * s).sin() }
}

impl Bordered {
    pub fn new(intervals: usize) -> Self {
        assert_eq!(intervals % W, 0);
        let h = 1.0 / intervals as f64;
        let blocks = (0..intervals).map(|t| {
            let zeros = |count: usize| vec![0.0; count];
            let (a, b, c) = (zeros(N * N), zeros(N * N), zeros(N * P));
            let mut block = Block { a, b, c, fa: Vec::new(), fb: Vec::new(), fc: Vec::new() };
            let (left, right) = (t as f64 * h, (t + 1) as f64 * h);
            for j in 0..N {
                for i in 0..N {
                    let one = if i == j { 1.0 } else { 0.0 };
                    block.a[j * N + i] = -one - 0.5 * h * coefficient(i, j, left);
                    block.b[j * N + i] = one - 0.5 * h * coefficient(i, j, right);
                }
                block.c[j] = -h * (j as f64 + 1.0);
            }
            block
        });
        let mut random = Random(1);
        let boundary = (0..(N + P) * (2 * N + P)).map(|_| random.next()).collect();
        let unknowns = (intervals + 1) * N + P;
        let solution = (0..unknowns).map(|_| random.next()).collect();
        let mut made =
            Self { steps: intervals / W, blocks: blocks.collect(), boundary, rhs: vec![0.0; unknowns], solution };
        for (row, column, value) in made.entries() {
            made.rhs[row] += value * made.solution[column];
        }
        made
    }

    pub fn unknowns(&self) -> usize {
        self.rhs.len()
    }

    /// All entries: row, column, value. Unknowns: nodes in order, then the constant.
    fn entries(&self) -> Vec<(usize, usize, f64)> {
        let (first, constant) = (self.blocks.len() * N, self.unknowns() - P);
        let mut entries = Vec::new();
        for (t, block) in self.blocks.iter().enumerate() {
            for i in 0..N {
                for j in 0..N {
                    entries.push((t * N + i, t * N + j, block.a[j * N + i]));
                    entries.push((t * N + i, (t + 1) * N + j, block.b[j * N + i]));
                }
                entries.push((t * N + i, constant, block.c[i]));
            }
        }
        for (i, row) in self.boundary.chunks_exact(2 * N + P).enumerate() {
            for j in 0..N {
                entries.push((first + i, j, row[j]));
                entries.push((first + i, first + j, row[N + j]));
            }
            entries.push((first + i, constant, row[2 * N]));
        }
        entries
    }

    /// By the elimination of the crate: stretches side by side, then one after another, then ends and constant.
    pub fn eliminated(&self) -> Vec<f64> {
        vectorised(Eliminate(self))
    }

    /// Time of the analysis, of factorisation and solve, and the solution.
    pub fn by_sparse_lu(&self) -> (f64, f64, Vec<f64>) {
        let triplets: Vec<_> = self.entries().into_iter().map(|(row, col, val)| Triplet { row, col, val }).collect();
        let size = self.unknowns();
        let matrix = SparseColMat::<usize, f64>::try_new_from_triplets(size, size, &triplets).unwrap();
        let symbolic = SymbolicLu::try_new(matrix.symbolic()).unwrap();
        let analysis = shortest(|| SymbolicLu::try_new(matrix.symbolic()).unwrap());
        let solve = || {
            let lu = SparseLu::try_new_with_symbolic(symbolic.clone(), matrix.as_ref()).unwrap();
            let mut x = self.rhs.clone();
            lu.solve_in_place(MatMut::from_column_major_slice_mut(&mut x, size, 1));
            x
        };
        (analysis, shortest(solve), solve())
    }

    /// Time of factorisation and solve, and the solution.
    pub fn by_dense_lu(&self) -> (f64, Vec<f64>) {
        let size = self.unknowns();
        let mut matrix = Mat::<f64>::zeros(size, size);
        for (row, column, value) in self.entries() {
            matrix[(row, column)] += value;
        }
        let solve = || {
            let mut x = self.rhs.clone();
            PartialPivLu::new(matrix.as_ref()).solve_in_place(MatMut::from_column_major_slice_mut(&mut x, size, 1));
            x
        };
        (shortest(solve), solve())
    }
}

/// `W` stretches of `steps` blocks, side by side.
struct Stretches<'a> {
    steps: usize,
    blocks: &'a [Block<Vec<f64>>],
}

impl Intervals<Lane> for Stretches<'_> {
    #[inline(always)]
    fn fill<R: Rows>(&mut self, _: R, t: usize, block: &mut Block<&mut [Lane]>) {
        let of = |l: usize| &self.blocks[l * self.steps + t];
        let pick = |entry: &dyn Fn(&Block<Vec<f64>>) -> f64| Lane(std::array::from_fn(|l| entry(of(l))));
        for i in 0..N * N {
            block.a[i] = pick(&|block| block.a[i]);
            block.b[i] = pick(&|block| block.b[i]);
        }
        for i in 0..N * P {
            block.c[i] = pick(&|block| block.c[i]);
        }
    }
}

struct Eliminate<'a>(&'a Bordered);

impl Job for Eliminate<'_> {
    type Output = Vec<f64>;

    #[inline(always)]
    fn run(self) -> Vec<f64> {
        let Bordered { steps, blocks, boundary, rhs, .. } = self.0;
        let (steps, rows) = (*steps, Fixed::<N>);
        let gathered = |values: &dyn Fn(usize) -> f64| Lane(std::array::from_fn(|l| values(l * steps)));
        let mut lanes = Chain::<Lane>::new(SHAPE, steps);
        lanes.factor(rows, Stretches { steps, blocks });
        let mut top = Chain::<f64>::new(SHAPE, W);
        top.factor(rows, Reduced(lanes.end()));
        let (size, end) = (2 * N + P, top.end());
        let mut dense = vec![0.0; size * size];
        for i in 0..N {
            for j in 0..N {
                dense[i * size + j] = end.a[j * N + i];
                dense[i * size + N + j] = end.b[j * N + i];
            }
            dense[i * size + 2 * N] = end.c[i];
        }
        dense[N * size..].copy_from_slice(boundary);
        let mut border = Lu::default();
        border.factor(size, &dense);
        // Right-hand side.
        let mut right: Vec<Lane> = (0..steps * N).map(|p| gathered(&|first| rhs[first * N + p])).collect();
        lanes.forward(rows, &mut right, &mut []);
        let last = &right[(steps - 1) * N..];
        let mut reduced: Vec<f64> = (0..W).flat_map(|l| last.iter().map(move |lane| lane.0[l])).collect();
        top.forward(rows, &mut reduced, &mut []);
        let mut ends = [&reduced[(W - 1) * N..], &rhs[W * steps * N..]].concat();
        border.solve(&mut ends);
        let (ends, constant) = ends.split_at(2 * N);
        let mut interfaces = vec![0.0; (W + 1) * N];
        interfaces[..N].copy_from_slice(&ends[..N]);
        interfaces[W * N..].copy_from_slice(&ends[N..]);
        top.backward(rows, &reduced, constant, &mut interfaces);
        let mut u = vec![Lane::ZERO; (steps + 1) * N];
        for i in 0..N {
            u[i] = Lane(std::array::from_fn(|l| interfaces[l * N + i]));
            u[steps * N + i] = Lane(std::array::from_fn(|l| interfaces[(l + 1) * N + i]));
        }
        lanes.backward(rows, &right, &[Lane([constant[0]; W])], &mut u);
        let mut x = Vec::with_capacity(rhs.len());
        for l in 0..W {
            x.extend(u[..steps * N].iter().map(|lane| lane.0[l]));
        }
        x.extend_from_slice(&ends[N..]);
        x.extend_from_slice(constant);
        x
    }
}
