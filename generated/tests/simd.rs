//! All vector widths give the same bits, whatever the number of points.
#![allow(clippy::unwrap_used, clippy::panic)]

mod common;

use common::{Random, Slip, Written, call, point, room};
use generated::{REGIONS, RegionFn, RegionKernel, Simd};

/// Strides are wider than the batch, and what lies beyond the batch must not be written.
fn batch(kernel: &RegionKernel, function: RegionFn, m: usize) -> Written {
    let stride = m + 3;
    let mut random = Random::new(m as u64);
    let points: Vec<_> = (0..m).map(|_| point(kernel, &mut random, Slip::Beyond)).collect();
    let mut y = vec![f64::NAN; kernel.states.len() * stride];
    for (j, point) in points.iter().enumerate() {
        for (i, value) in point.y.iter().enumerate() {
            y[i * stride + j] = *value;
        }
    }
    let s: Vec<f64> = points.iter().map(|point| point.s).collect();
    let constants = point(kernel, &mut Random::new(5), Slip::Beyond).constants;
    let mut written = room(kernel, stride);
    call(function, m, stride, &s, &y, &constants, &mut written);
    written
}

fn bits(values: &[f64]) -> Vec<u64> {
    values.iter().map(|value| value.to_bits()).collect()
}

#[test]
fn same_bits_on_every_path() {
    // The limit is the process's: this test is alone in its file.
    println!("paths: {:?}", Simd::available());
    for kernel in REGIONS {
        for function in [kernel.value, kernel.jacobian, kernel.full, kernel.fields_fn] {
            for m in [0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 40] {
                Simd::limit(Simd::Scalar);
                let scalar = batch(kernel, function, m);
                for simd in Simd::available() {
                    Simd::limit(simd);
                    assert_eq!(Simd::current(), simd);
                    let wide = batch(kernel, function, m);
                    let name = kernel.name;
                    assert_eq!(bits(&scalar.f), bits(&wide.f), "{name}, {m} points, {simd:?}");
                    assert_eq!(bits(&scalar.dy), bits(&wide.dy), "{name}, {m} points, {simd:?}");
                    assert_eq!(bits(&scalar.dc), bits(&wide.dc), "{name}, {m} points, {simd:?}");
                    assert_eq!(bits(&scalar.fields), bits(&wide.fields), "{name}, {m} points, {simd:?}");
                }
            }
        }
    }
    Simd::limit(Simd::Avx512);
}
