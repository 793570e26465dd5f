//! The equivalent cross-section of Appendix A: a rectangle outside the cords and a trapezoid inside them, whose height
//! is such that the section has the second moment of area that a bending test found.

use crate::bench::error::{BenchError, BenchProblem};
use serde::Serialize;

/// The equivalent section; SI. Heights are counted from the outside surface of the belt inwards.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
#[cfg_attr(feature = "schema", derive(schemars::JsonSchema))]
pub struct Section {
    /// Width at the cords and outside them, m.
    pub width: f64,
    /// Height of the rectangle: depth of the cords, m.
    pub cord_depth: f64,
    /// h, height of the trapezoid, m.
    pub height: f64,
    /// t, width at the inside, m.
    pub inside_width: f64,
    /// A, m².
    pub area: f64,
    /// C_r, height of the centroid above the outside surface, m.
    pub centroid: f64,
    /// Height of the centroid, where the neutral axis of the rubber alone is, above the cords, m.
    pub above_cords: f64,
    /// Ī, second moment of area about the centroid, m⁴.
    pub about_centroid: f64,
    /// I about the line of the cords, by the parallel axis theorem (4.7), m⁴.
    pub about_cords: f64,
}

/// Steps of the bisection: more than a 64-bit number has digits.
const STEPS: usize = 200;

impl Section {
    /// The section with a trapezoid of that height: equations f_1 to f_11 of Appendix A.
    pub fn of_height(width: f64, cord_depth: f64, half_angle: f64, height: f64) -> Self {
        let inside_width = width - 2.0 * height * half_angle.tan();
        let rectangle = (width * cord_depth, 0.5 * cord_depth, width * cord_depth.powi(3) / 12.0);
        let (t, w, h) = (inside_width, width, height);
        let trapezoid = (
            0.5 * h * (w + t),
            cord_depth + h / 3.0 * (2.0 * t + w) / (t + w),
            h.powi(3) * (t * t + 4.0 * t * w + w * w) / (36.0 * (t + w)),
        );
        let area = rectangle.0 + trapezoid.0;
        let centroid = (rectangle.0 * rectangle.1 + trapezoid.0 * trapezoid.1) / area;
        let about = |(area, center, own): (f64, f64, f64)| own + area * (center - centroid).powi(2);
        let about_centroid = about(rectangle) + about(trapezoid);
        let above_cords = centroid - cord_depth;
        let about_cords = about_centroid + area * above_cords.powi(2);
        Self { width, cord_depth, height, inside_width, area, centroid, above_cords, about_centroid, about_cords }
    }

    /// The section with a second moment of area about its centroid, m⁴; lengths in m, the half angle in rad.
    ///
    /// # Errors
    /// [`BenchProblem::Unusable`] where no trapezoid has it: less than the rectangle alone has, or more than the
    /// wedge that ends in an edge.
    pub fn equivalent(width: f64, cord_depth: f64, half_angle: f64, about_centroid: f64) -> Result<Self, BenchError> {
        let of = |height| Self::of_height(width, cord_depth, half_angle, height);
        // The wedge ends in an edge; one with parallel flanks anywhere, and 100 widths are no belt's.
        let highest = if half_angle > 0.0 { 0.5 * width / half_angle.tan() } else { f64::INFINITY };
        let (mut low, mut high) = (0.0, highest.min(100.0 * width));
        let (least, most) = (of(0.0).about_centroid, of(high).about_centroid);
        if !(least..=most).contains(&about_centroid) {
            let reason = format!(
                "the bending test says a second moment of area of {about_centroid:.4e} m⁴, but sections of this width \
                 and cord depth have {least:.4e} (no rubber inside the cords) to {most:.4e} m⁴; check the units of \
                 moment, radius and modulus, and the width"
            );
            return Err(BenchProblem::Unusable { path: "section".into(), reason }.into());
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            if of(middle).about_centroid < about_centroid { low = middle } else { high = middle }
        }
        Ok(of(0.5 * (low + high)))
    }

    /// Length around the section, m.
    pub fn perimeter(&self) -> f64 {
        let flank = self.height.hypot(0.5 * (self.width - self.inside_width));
        self.width + self.inside_width + 2.0 * (self.cord_depth + flank)
    }

    /// Corners of the section, across and from the outside surface, m; the first again at the end.
    pub fn corners(&self) -> [(f64, f64); 7] {
        let inset = 0.5 * (self.width - self.inside_width);
        let (width, cords, top) = (self.width, self.cord_depth, self.cord_depth + self.height);
        [(0.0, 0.0), (0.0, cords), (inset, top), (width - inset, top), (width, cords), (width, 0.0), (0.0, 0.0)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    /// Area, first and second moment of a polygon about y = 0 by Green's theorem: a route that shares nothing.
    fn polygon(corners: &[(f64, f64)]) -> (f64, f64, f64) {
        let mut sums = (0.0, 0.0, 0.0);
        for pair in corners.windows(2) {
            let ((ax, ay), (bx, by)) = (pair[0], pair[1]);
            let cross = ax * by - bx * ay;
            sums.0 += 0.5 * cross;
            sums.1 += cross * (ay + by) / 6.0;
            sums.2 += cross * (ay * ay + ay * by + by * by) / 12.0;
        }
        (sums.0.abs(), sums.1.abs(), sums.2.abs())
    }

    proptest! {
        #[test]
        fn moments_are_those_of_the_polygon(
            width in 0.005f64..0.1, depth in 0.02f64..0.5, angle in 0.0f64..0.7, share in 0.001f64..0.999,
        ) {
            let highest = if angle > 1e-3 { (0.5 * width / angle.tan()).min(2.0 * width) } else { 2.0 * width };
            let section = Section::of_height(width, depth * width, angle, share * highest);
            let (area, first, second) = polygon(&section.corners());
            prop_assert!((section.area / area - 1.0).abs() < 1e-10);
            let corners = section.corners();
            let around: f64 = corners.windows(2).map(|p| (p[1].0 - p[0].0).hypot(p[1].1 - p[0].1)).sum();
            prop_assert!((section.perimeter() / around - 1.0).abs() < 1e-12);
            prop_assert!((section.centroid / (first / area) - 1.0).abs() < 1e-10);
            let own = second - first * first / area;
            prop_assert!((section.about_centroid / own - 1.0).abs() < 1e-8, "{} {}", section.about_centroid, own);
            let found = Section::equivalent(width, depth * width, angle, section.about_centroid).unwrap();
            prop_assert!((found.height / section.height - 1.0).abs() < 1e-6);
        }
    }

    #[test]
    fn what_no_section_has_is_refused() {
        for moment in [1e-15, 1.0, f64::NAN] {
            assert!(Section::equivalent(0.03051, 0.00285, 0.2, moment).is_err(), "{moment}");
        }
    }
}
