//! The kernels' lanes in WebAssembly, called from a test.

#[path = "../../../generated/tests/common/mod.rs"]
mod common;

use common::{Random, Slip, Written, call, point, room};
use generated::{REGIONS, RegionFn, RegionKernel, Simd};

struct Batch {
    s: Vec<f64>,
    y: Vec<f64>,
    constants: Vec<f64>,
    stride: usize,
    written: Written,
}

impl Batch {
    fn new(kernel: &RegionKernel, points: usize) -> Self {
        let stride = points + 3;
        let mut random = Random::new(points as u64);
        let drawn: Vec<_> = (0..points).map(|_| point(kernel, &mut random, Slip::Beyond)).collect();
        let mut y = vec![f64::NAN; kernel.states.len() * stride];
        for (j, point) in drawn.iter().enumerate() {
            point.y.iter().enumerate().for_each(|(i, value)| y[i * stride + j] = *value);
        }
        let s = drawn.iter().map(|point| point.s).collect();
        let constants = point(kernel, &mut Random::new(5), Slip::Beyond).constants;
        Self { s, y, constants, stride, written: room(kernel, stride) }
    }

    fn run(&mut self, function: RegionFn) {
        call(function, self.s.len(), self.stride, &self.s, &self.y, &self.constants, &mut self.written);
    }

    fn bits(&self) -> Vec<u64> {
        let Written { f, dy, dc, fields } = &self.written;
        [f, dy, dc, fields].into_iter().flatten().map(|value| value.to_bits()).collect()
    }
}

/// Sets of numbers that were compared, or minus those that differ.
#[unsafe(no_mangle)]
pub extern "C" fn lanes_agree() -> i32 {
    let (mut compared, mut wrong) = (0, 0);
    for kernel in REGIONS {
        for function in [kernel.value, kernel.jacobian, kernel.full, kernel.fields_fn] {
            for points in [0, 1, 2, 3, 4, 5, 8, 9, 40] {
                let bits = |simd: Simd| {
                    Simd::limit(simd);
                    let mut batch = Batch::new(kernel, points);
                    batch.run(function);
                    batch.bits()
                };
                compared += 1;
                wrong += i32::from(bits(Simd::Scalar) != bits(Simd::Simd128));
            }
        }
    }
    if wrong > 0 { -wrong } else { compared }
}

/// Whether two numbers at a time are there at all.
#[unsafe(no_mangle)]
pub extern "C" fn has_simd128() -> bool {
    Simd::available().contains(&Simd::Simd128)
}

/// Jacobians of all regions, `rounds` batches of 256 points each, two numbers at a time if `wide`.
#[unsafe(no_mangle)]
pub extern "C" fn work(rounds: u32, wide: bool) {
    Simd::limit(if wide { Simd::Simd128 } else { Simd::Scalar });
    let mut batches: Vec<_> = REGIONS.iter().map(|kernel| (kernel.jacobian, Batch::new(kernel, 256))).collect();
    for _ in 0..rounds {
        batches.iter_mut().for_each(|(function, batch)| batch.run(*function));
    }
}
