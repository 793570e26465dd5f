//! The simplified belt path of the thesis's section 6.2.1: arcs at the nominal radii, spans tangent to both.

use std::f64::consts::PI;

/// L_P, pitch length of the belt around radii `primary` and `secondary` at `center_distance`, all in metres:
/// (6.10) and (6.11) in (6.12), with θ_T = asin((R_S − R_P)/L_c).
pub fn pitch_length(primary: f64, secondary: f64, center_distance: f64) -> f64 {
    let difference = secondary - primary;
    let tangent = libm::asin(difference / center_distance);
    2.0 * center_distance * libm::cos(tangent) + PI * (primary + secondary) + 2.0 * tangent * difference
}

/// Wrap angles of the primary and the secondary in radians, around radii `primary` and `secondary` at
/// `center_distance`: π ∓ 2 θ_T with θ_T from (6.10).
pub fn wrap_angles(primary: f64, secondary: f64, center_distance: f64) -> (f64, f64) {
    let tangent = libm::asin((secondary - primary) / center_distance);
    (PI - 2.0 * tangent, PI + 2.0 * tangent)
}

/// Why no radii satisfy (6.12).
#[derive(Debug, Clone, Copy, PartialEq, thiserror::Error)]
pub enum NoRadii {
    /// Even with radii of zero the belt would have to be longer.
    #[error("the belt is too short: it would have to be longer than {shortest:.4} m")]
    TooShort {
        /// Pitch length in the limit of the smallest radius, m.
        shortest: f64,
    },
    /// Even where the pulleys touch the belt would have to be shorter.
    #[error("the belt is too long: where the pulleys touch, it would have to be shorter than {longest:.4} m")]
    TooLong {
        /// Pitch length where the pulleys touch, m.
        longest: f64,
    },
}

/// R_P and R_S = `ratio` R_P in metres, for which a belt of pitch length `length` fits pulleys `center_distance` apart.
///
/// # Errors
/// [`NoRadii`] when none exist, short of pulleys that touch.
pub fn radii_of_ratio(ratio: f64, length: f64, center_distance: f64) -> Result<(f64, f64), NoRadii> {
    let primary = largest_root(center_distance / (1.0 + ratio), length, |primary| {
        let tangent = libm::asin((ratio - 1.0) * primary / center_distance);
        let slope = PI * (1.0 + ratio) + 2.0 * tangent * (ratio - 1.0);
        (pitch_length(primary, ratio * primary, center_distance), slope)
    })?;
    Ok((primary, ratio * primary))
}

/// The radius in metres that, beside the pulley of radius `other`, a belt of pitch length `length` fits.
///
/// # Errors
/// [`NoRadii`] when none exists, short of pulleys that touch.
pub fn radius_beside(other: f64, length: f64, center_distance: f64) -> Result<f64, NoRadii> {
    largest_root(center_distance - other, length, |radius| {
        let slope = PI - 2.0 * libm::asin((other - radius) / center_distance);
        (pitch_length(radius, other, center_distance), slope)
    })
}

/// Solves `length(radius) = target` on (0, `touching`), for a length that grows with the radius, and ever faster.
/// Newton's method from the right end then falls monotonically to the one root, and is done when it stops falling.
fn largest_root(touching: f64, target: f64, length: impl Fn(f64) -> (f64, f64)) -> Result<f64, NoRadii> {
    let (shortest, longest) = (length(0.0).0, length(touching).0);
    if target <= shortest {
        return Err(NoRadii::TooShort { shortest });
    }
    if target >= longest {
        return Err(NoRadii::TooLong { longest });
    }
    let mut radius = touching;
    for _ in 0..100 {
        let (value, slope) = length(radius);
        let next = radius - (value - target) / slope;
        if next >= radius || next <= 0.0 {
            break;
        }
        radius = next;
    }
    Ok(radius)
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// The residual of the MATLAB function in the thesis's appendix, letter by letter.
    fn printed(x: f64, ratio: f64, l_o: f64, l: f64) -> f64 {
        2.0 * (l.powi(2) - (ratio * x - x).powi(2)).powf(0.5)
            + PI * (x + ratio * x)
            + 2.0 * ((ratio * x - x) / l).asin() * (ratio * x - x)
            - l_o
    }

    #[test]
    fn the_base_case_is_at_ratio_one() {
        let (primary, secondary) = radii_of_ratio(1.0, 0.8572, 0.214).unwrap();
        assert!((primary - 0.068309).abs() < 1e-6 && primary == secondary, "{primary}");
    }

    #[test]
    fn a_belt_that_does_not_fit_is_refused() {
        assert_eq!(radii_of_ratio(1.0, 0.4, 0.214), Err(NoRadii::TooShort { shortest: 0.428 }));
        assert!(matches!(radii_of_ratio(1.0, 2.0, 0.214), Err(NoRadii::TooLong { .. })));
        assert!(matches!(radius_beside(0.1, 0.5, 0.214), Err(NoRadii::TooShort { .. })));
        assert!(matches!(radius_beside(0.1, 1.5, 0.214), Err(NoRadii::TooLong { .. })));
    }

    proptest! {
        #[test]
        fn radii_satisfy_the_printed_function(ratio in 0.05f64..20.0, share in 0.001f64..0.999,
            center in 0.05f64..2.0) {
            let touching = center / (1.0 + ratio);
            let longest = pitch_length(touching, ratio * touching, center);
            let length = 2.0 * center + share * (longest - 2.0 * center);
            let (primary, secondary) = radii_of_ratio(ratio, length, center).unwrap();
            prop_assert!(printed(primary, ratio, length, center).abs() < 1e-13 * length);
            prop_assert_eq!(secondary, ratio * primary);
            let beside = radius_beside(secondary, length, center).unwrap();
            prop_assert!((beside / primary - 1.0).abs() < 1e-9, "{} {}", beside, primary);
        }
    }
}
