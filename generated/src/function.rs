//! Elementary functions on lanes: the same steps, and so the same bits, for one number and for eight.

// The coefficients stand as their sources print them, to more digits than a double holds.
#![allow(clippy::excessive_precision, clippy::approx_constant)]

use crate::lane::Lane;

/// 1/a
#[inline(always)]
pub(crate) fn reciprocal<Real: Lane>(a: Real) -> Real {
    Real::splat(1.0) / a
}

/// √a
#[inline(always)]
pub(crate) fn sqrt<Real: Lane>(a: Real) -> Real {
    a.root()
}

/// min(1, u); NaN stays NaN.
#[inline(always)]
pub(crate) fn saturate<Real: Lane>(u: Real) -> Real {
    let one = Real::splat(1.0);
    u.where_at_least(one, one, u)
}

/// The derivative of [`saturate`]: 1 where u < 1, else 0.
#[inline(always)]
pub(crate) fn below_one<Real: Lane>(u: Real) -> Real {
    let one = Real::splat(1.0);
    u.where_at_least(one, Real::splat(0.0), one)
}

/// The angle of the vector (a, b), in [−π, π], with the sign of b; as IEEE 754's atan2(b, a), but NaN where both are
/// infinite.
///
/// The arc tangent of the smaller over the larger, by fdlibm's `s_atan.c`: of the angle's difference from 0, atan ½ or
/// π/4, whichever is near, and its polynomial (error below 2⁻⁵⁸ up to 7/16). The relative error is below 2⁻⁵¹ (a test
/// holds it).
#[inline(always)]
pub(crate) fn angle<Real: Lane>(a: Real, b: Real) -> Real {
    let number = Real::splat;
    let sign = number(-0.0);
    let (abs_a, abs_b) = (a.xor(a.and(sign)), b.xor(b.and(sign)));
    let (large, small) = (abs_b.where_at_least(abs_a, abs_b, abs_a), abs_b.where_at_least(abs_a, abs_a, abs_b));

    // Up to 7/16, up to 11/16, and beyond.
    let (half, whole) = (number(16.0 / 7.0) * small, number(16.0 / 11.0) * small);
    let pick = |zero: Real, at_half: Real, at_whole: Real| {
        whole.where_at_least(large, at_whole, half.where_at_least(large, at_half, zero))
    };
    let none = number(0.0);
    // tan(α − β) = (tan α − tan β)/(1 + tan α tan β)
    let above = pick(small, small + small - large, small - large);
    let below = pick(large, large + large + small, large + small);
    let t = above / below;
    let z = t * t;
    let rest = t * (z * polynomial(z, ARC_TANGENT));
    let tail = pick(none, number(2.269_877_745_296_168_709_24e-17), number(3.061_616_997_868_383_017_93e-17));
    let head = pick(none, number(4.636_476_090_008_060_935_15e-1), number(7.853_981_633_974_482_789_99e-1));
    let near = head - ((rest - tail) - t);

    let (quarter, quarter_tail) = (number(1.570_796_326_794_896_558_00), number(6.123_233_995_736_766_035_87e-17));
    let steep = quarter - (near - quarter_tail);
    let first = abs_b.where_at_least(abs_a, steep, near);
    // No vector, no angle.
    let first = none.where_at_least(large + small, none, first);
    let (turn, turn_tail) = (number(3.141_592_653_589_793_116_00), number(1.224_646_799_147_353_177_2e-16));
    let upper = a.where_sign(turn - (first - turn_tail), first);
    upper.xor(b.and(sign))
}

/// arctan t = t − t z p(z), z = t²: fdlibm's p, highest coefficient first.
const ARC_TANGENT: [f64; 11] = [
    1.628_582_011_536_578_236_23e-2,
    -3.653_157_274_421_691_552_70e-2,
    4.976_877_994_615_932_360_17e-2,
    -5.833_570_133_790_573_486_45e-2,
    6.661_073_137_387_531_206_69e-2,
    -7.691_876_205_044_829_994_95e-2,
    9.090_887_133_436_506_561_96e-2,
    -1.111_111_040_546_235_578_80e-1,
    1.428_571_427_250_346_637_11e-1,
    -1.999_999_999_987_648_324_76e-1,
    3.333_333_333_333_293_180_27e-1,
];

/// An angle in (−π, π], in [0, 2π).
#[inline(always)]
pub(crate) fn turn<Real: Lane>(angle: Real) -> Real {
    let zero = Real::splat(0.0);
    angle.where_at_least(zero, angle, angle + Real::splat(2.0 * std::f64::consts::PI))
}

/// Beyond this |x| the sine and cosine of `libm` stand in, in all lanes alike.
const SIN_COS_RANGE: f64 = 524_288.0;

/// 1.5 · 2⁵²: adding it rounds to an integer, which then stands in the low bits.
const ROUND: f64 = 6_755_399_441_055_744.0;

/// sin x and cos x.
///
/// Cody and Waite's reduction by π/2 in three parts of 33 bits, so that |x| ≤ 2¹⁹ loses nothing but the last part's
/// rounding, then the polynomials of fdlibm's `k_sin.c` and `k_cos.c` (error below 2⁻⁵⁸ on |r| ≤ π/4). The absolute
/// error is below 2⁻⁵³·1.5, and for |x| ≤ π/4 the relative error of the sine below 2⁻⁵² (a test holds both).
#[inline(always)]
pub(crate) fn sin_cos<Real: Lane>(x: Real) -> (Real, Real) {
    if !x.all_within(SIN_COS_RANGE) {
        return (x.map(far_sin), x.map(far_cos));
    }
    near_sin_cos(x)
}

/// Element by element, where a neighbour may be far but this one is not.
fn far_sin(x: f64) -> f64 {
    if x.all_within(SIN_COS_RANGE) { near_sin_cos(x).0 } else { libm::sin(x) }
}

fn far_cos(x: f64) -> f64 {
    if x.all_within(SIN_COS_RANGE) { near_sin_cos(x).1 } else { libm::cos(x) }
}

#[inline(always)]
fn near_sin_cos<Real: Lane>(x: Real) -> (Real, Real) {
    let number = Real::splat;
    let turns = x * number(6.366_197_723_675_814e-1) + number(ROUND);
    let quadrant = turns - number(ROUND);
    let r = x - quadrant * number(1.570_796_326_734_125_614_17);
    let r = r - quadrant * number(6.077_100_506_303_965_976_60e-11);
    let r = r - quadrant * number(2.022_266_248_795_950_631_54e-21);

    let z = r * r;
    let sine = polynomial(
        z,
        [
            1.589_690_995_211_550_102_21e-10,
            -2.505_076_025_340_686_341_95e-8,
            2.755_731_370_707_006_767_89e-6,
            -1.984_126_982_985_794_931_34e-4,
            8.333_333_333_322_489_461_24e-3,
            -1.666_666_666_666_663_243_48e-1,
        ],
    );
    let sine = r + r * z * sine;
    let cosine = polynomial(
        z,
        [
            -1.135_964_755_778_819_482_65e-11,
            2.087_572_321_298_174_827_90e-9,
            -2.755_731_435_139_066_330_35e-7,
            2.480_158_728_947_672_941_78e-5,
            -1.388_888_888_887_410_957_49e-3,
            4.166_666_666_666_660_190_37e-2,
        ],
    );
    // 1 − z/2 rounded, what that lost, and the rest (k_cos.c).
    let half = number(0.5) * z;
    let head = number(1.0) - half;
    let cosine = head + ((number(1.0) - head - half) + z * z * cosine);

    // The lowest bit of the quadrant swaps the two; the next changes signs.
    let odd = turns.shift_bits::<63>();
    let (sine, cosine) = (odd.where_sign(cosine, sine), odd.where_sign(sine, cosine));
    let sign = number(-0.0);
    let second = turns.shift_bits::<62>().and(sign);
    (sine.xor(second), cosine.xor(second.xor(odd)))
}

/// Horner's rule, highest coefficient first.
#[inline(always)]
fn polynomial<Real: Lane, const N: usize>(z: Real, coefficients: [f64; N]) -> Real {
    let (first, rest) = (coefficients[0], &coefficients[1..]);
    rest.iter().fold(Real::splat(first), |sum, &coefficient| sum * z + Real::splat(coefficient))
}

/// tanh u = e/(e + 2) with e = exp(2u) − 1 = 2ᵏ p + (2ᵏ − 1), p = exp(r) − 1 by its Taylor polynomial on
/// |r| ≤ ln 2/2 (remainder below 2⁻⁵⁵); 1 beyond |u| = 20. The relative error is below 2⁻⁵¹ (a test holds it).
#[inline(always)]
pub(crate) fn tanh<Real: Lane>(u: Real) -> Real {
    let number = Real::splat;
    let limit = number(20.0);
    let u = u.where_at_least(limit, limit, u);
    let u = (-u).where_at_least(limit, -limit, u);
    let twice = u + u;
    let scaled = twice * number(std::f64::consts::LOG2_E) + number(ROUND);
    let k = scaled - number(ROUND);
    // ln 2 in two parts, the first of 32 bits.
    let r = twice - k * number(6.931_471_803_691_238_164_90e-1);
    let r = r - k * number(1.908_214_929_270_587_700_02e-10);
    let p = r + r * r * polynomial(r, TAYLOR);
    // 2ᵏ: k stands in the low bits of `scaled`; shifting drops the rest.
    let power = scaled.shift_bits::<52>().add_bits(number(1.0));
    let e = power * p + (power - number(1.0));
    e / (e + number(2.0))
}

/// eᵘ, by `libm`.
#[inline(always)]
pub(crate) fn exp<Real: Lane>(u: Real) -> Real {
    u.map(libm::exp)
}

/// ln u, by `libm`; NaN for a negative u.
#[inline(always)]
pub(crate) fn ln<Real: Lane>(u: Real) -> Real {
    u.map(libm::log)
}

/// 1/13!, …, 1/3!, 1/2!
const TAYLOR: [f64; 12] = [
    1.0 / 6_227_020_800.0,
    1.0 / 479_001_600.0,
    1.0 / 39_916_800.0,
    1.0 / 3_628_800.0,
    1.0 / 362_880.0,
    1.0 / 40_320.0,
    1.0 / 5_040.0,
    1.0 / 720.0,
    1.0 / 120.0,
    1.0 / 24.0,
    1.0 / 6.0,
    1.0 / 2.0,
];

#[cfg(test)]
mod tests {
    use super::*;

    /// Evenly spaced with an irrational-looking step, ends included.
    fn samples(low: f64, high: f64) -> impl Iterator<Item = f64> {
        let count = 200_003;
        (0..=count).map(move |i| low + (high - low) * f64::from(i) / f64::from(count))
    }

    #[test]
    fn sines_and_cosines() {
        let bound = 1.5 * f64::EPSILON / 2.0 + f64::EPSILON / 4.0; // the last part is the library's own
        for (low, high) in [(-0.8, 0.8), (-10.0, 10.0), (-1e5, 1e5), (5.2e5, 5.25e5)] {
            for x in samples(low, high) {
                let (sine, cosine) = sin_cos(x);
                assert!((sine - x.sin()).abs() <= bound, "sin {x}: {sine}");
                assert!((cosine - x.cos()).abs() <= bound, "cos {x}: {cosine}");
            }
        }
        for x in samples(-std::f64::consts::FRAC_PI_4, std::f64::consts::FRAC_PI_4) {
            assert!((sin_cos(x).0 - x.sin()).abs() <= 1.5 * f64::EPSILON * x.sin().abs(), "sin {x}");
        }
        assert!(sin_cos(f64::NAN).0.is_nan() && sin_cos(f64::INFINITY).1.is_nan());
        assert_eq!(sin_cos(0.0), (0.0, 1.0));
    }

    #[test]
    fn hyperbolic_tangents() {
        for u in samples(-30.0, 30.0).chain(samples(-1e-3, 1e-3)).chain([1e-12, -1e-300, 0.0, 20.0]) {
            let exact = u.tanh();
            assert!((tanh(u) - exact).abs() <= 3.0 * f64::EPSILON * exact.abs(), "tanh {u}: {} {exact}", tanh(u));
        }
        assert!(tanh(f64::NAN).is_nan());
        assert_eq!(tanh(f64::INFINITY), 1.0);
        assert_eq!(tanh(f64::NEG_INFINITY), -1.0);
    }

    #[test]
    fn angles() {
        let off = |a: f64, b: f64| {
            let (found, exact) = (angle(a, b), f64::atan2(b, a));
            let equal = found.to_bits() == exact.to_bits();
            assert!(
                equal || (found - exact).abs() <= 2.0 * f64::EPSILON * exact.abs(),
                "angle of ({a:e}, {b:e}): {found} {exact}"
            );
        };
        for turn in samples(-3.2, 3.2) {
            let (sin, cos) = turn.sin_cos();
            off(cos, sin);
            off(1e-300 * cos, 1e-300 * sin);
        }
        let ends = [0.0, f64::from_bits(1), 1e-310, 1e-9, 0.4375, 0.5, 0.6875, 1.0, 1e9, 1e300, f64::INFINITY];
        for (a, b) in ends.iter().flat_map(|a| ends.map(|b| (*a, b))).filter(|(a, b)| *a < 1e308 || *b < 1e308) {
            for (a, b) in [(a, b), (-a, b), (a, -b), (-a, -b)] {
                off(a, b);
            }
        }
        assert!(angle(f64::NAN, 1.0).is_nan() && angle(1.0, f64::NAN).is_nan() && angle(0.0, f64::NAN).is_nan());
    }

    #[test]
    fn friction_switches() {
        assert_eq!((saturate(0.5), saturate(1.0), saturate(2.0)), (0.5, 1.0, 1.0));
        assert_eq!((below_one(0.5), below_one(1.0), below_one(2.0)), (1.0, 0.0, 0.0));
        assert!(saturate(f64::NAN).is_nan());
        assert_eq!(turn(-1.0), 2.0 * std::f64::consts::PI - 1.0);
        assert_eq!((angle(1.0, 0.0), turn(1.0)), (0.0, 1.0));
    }
}
