//! Sines and cosines of many angles.

use crate::function::sin_cos;
use crate::lane::Lane;
use crate::sweep::{Chunk, Sweep, sweep};
use crate::types::RegionOut;

/// A sweep whose only state is an angle.
struct SinesAndCosines;

impl Sweep for SinesAndCosines {
    const STATES: usize = 1;
    const CONSTANTS: usize = 0;
    const F: usize = 2;
    const DY: usize = 0;
    const DC: usize = 0;
    const FIELDS: usize = 0;
    const WIDE: bool = true;
    type Uniforms = ();

    fn uniforms(_: &[f64]) {}

    #[inline(always)]
    fn chunk<Real: Lane>((): &(), at: Chunk<'_>) {
        let (sine, cosine) = sin_cos::<Real>(at.state(0));
        at.write_f(0, sine);
        at.write_f(1, cosine);
    }
}

/// Sines and then cosines of some angles, rad, with the widest vectors that this machine has. Up to 2¹⁹ rad their error
/// is below 2⁻⁵³·1.5; the bits do not depend on the vectors.
pub fn sines_and_cosines(angles: &[f64]) -> [Vec<f64>; 2] {
    let count = angles.len();
    let mut sines = vec![0.0; 2 * count];
    let mut out = RegionOut { f: &mut sines, dy: &mut [], dc: &mut [], fields: &mut [] };
    sweep::<SinesAndCosines>(count, count, angles, angles, &[], &mut out);
    let cosines = sines.split_off(count);
    [sines, cosines]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn they_are_those_of_the_library_whatever_their_number() {
        for count in [0, 1, 3, 4, 5, 8, 11, 40] {
            let angles: Vec<f64> = (0..count).map(|i| f64::from(i) * 0.37 - 5.0).collect();
            let [sines, cosines] = sines_and_cosines(&angles);
            assert_eq!((sines.len(), cosines.len()), (angles.len(), angles.len()));
            for ((angle, sine), cosine) in angles.iter().zip(sines).zip(cosines) {
                assert!((sine - angle.sin()).abs() < 2e-16 && (cosine - angle.cos()).abs() < 2e-16, "{angle}");
            }
        }
    }
}
