//! A belt's properties for people: a case file with everything else as comments, and figures.

use super::{BeltTable, Properties};
use crate::plot::{Axis, Figure, Look, Series};
use crate::quantity::celsius;
use crate::text::on_one_line;
use std::fmt::Write;

impl BeltTable {
    /// The `[belt]` table of a case file, in engineering units.
    pub fn toml(&self) -> String {
        let mut text = format!(
            "[belt]\nlength = \"{:.6} mm\"\nmass_per_length = \"{:.7} kg/m\"\nlongitudinal_stiffness = \"{:.6} kN\"\n\
             bending_stiffness = \"{:.7} N*m^2\"\nradial_stiffness = \"{:.6} MPa\"\n",
            1e3 * self.length,
            self.mass_per_length,
            1e-3 * self.longitudinal_stiffness,
            self.bending_stiffness,
            1e-6 * self.radial_stiffness,
        );
        // Writing to a string does not fail.
        if let Some(perimeter) = self.perimeter {
            let _ = writeln!(text, "perimeter = \"{:.6} mm\"", 1e3 * perimeter);
        }
        if let Some(tangent) = self.loss_tangent {
            let _ = writeln!(text, "loss_tangent = {tangent:.8}");
        }
        text
    }
}

/// A quantity on the way: its name, its value in that unit, the unit.
pub type Row = (String, f64, &'static str);

impl Properties {
    /// Everything on the way to the belt, in the order in which it is computed, for people.
    pub fn rows(&self) -> Vec<Row> {
        let mut rows: Vec<Row> = Vec::new();
        let mut add = |name: &str, value: f64, unit: &'static str| rows.push((name.to_owned(), value, unit));
        for test in &self.rubber_tests {
            let at = format!("at {:.1} °C", celsius(test.temperature));
            if let Some(modulus) = test.storage_modulus {
                add(&format!("rubber {at}: storage modulus G'"), 1e-6 * modulus, "MPa");
            }
            if let Some(ratio) = test.storage_over_loss {
                add(&format!("rubber {at}: storage over loss modulus"), ratio, "");
            }
            add(&format!("rubber {at}: Young's modulus E"), 1e-6 * test.youngs_modulus, "MPa");
        }
        if let Some(rubber) = self.rubber {
            add(&format!("in use{}: Young's modulus E", self.at()), 1e-6 * rubber.youngs_modulus, "MPa");
        }
        if let Some(yarns) = self.yarns {
            add("EA of one yarn", yarns.one, "N");
            add("EA of all yarns", 1e-3 * yarns.all, "kN");
        }
        if let Some(strain) = self.tension.strain {
            add("strain in the tension test", strain, "");
        }
        if let Some(line) = self.tension.line {
            add("R² of the tension test's line", line.r_squared, "");
        }
        let of = if self.tension.of_rubber { "EA of the rubber" } else { "EA of the belt" };
        add(&format!("{of} as tested"), 1e-3 * self.tension.as_tested, "kN");
        add(&format!("{of} in use"), 1e-3 * self.tension.stiffness, "kN");
        if let Some(moment) = self.bending.second_moment {
            add("I about the rubber's neutral axis", 1e12 * moment, "mm⁴");
        }
        if let Some(section) = self.section {
            add("height of the equivalent trapezoid", 1e3 * section.height, "mm");
            add("width at its inside", 1e3 * section.inside_width, "mm");
            add("area of the equivalent section", 1e6 * section.area, "mm²");
            add("neutral axis above the cords", 1e3 * section.above_cords, "mm");
            add("I about the cords", 1e12 * section.about_cords, "mm⁴");
        }
        add("lateral test: slope", 1e-3 * self.lateral.slope, "N/mm");
        if let Some(line) = self.lateral.line {
            add("lateral test: R² of the line", line.r_squared, "");
            if let Some(half) = line.slope_interval() {
                add("lateral test: 95 % interval of the slope, ±", 1e-3 * half, "N/mm");
            }
        }
        add("k as tested", 1e-6 * self.lateral.as_tested, "MPa");
        add("k for the sheaves' half angle", 1e-6 * self.lateral.at_sheave_angle, "MPa");
        add("E in use over E in the lateral test", self.lateral.modulus_ratio, "");
        add("mass", 1e3 * self.length.mass, "g");
        rows
    }

    /// The tables of a case file: the belt, the half angle for which its radial stiffness holds, and the temperature at
    /// which its stiffnesses do, with what they fall by per kelvin.
    pub fn tables(&self) -> String {
        let mut text = self.belt.toml();
        let degrees = self.lateral.sheave_half_angle.to_degrees();
        // Writing to a string does not fail.
        let _ = writeln!(text, "\n[sheave]\nhalf_angle = \"{degrees:.6} deg\"");
        if let Some(kelvin) = self.temperature {
            let _ = writeln!(text, "\n[thermal]\nreference = \"{kelvin:.4} K\"");
            if let Some(softening) = self.softening {
                let _ = writeln!(text, "bending_softening = {softening:.8}\nradial_softening = {softening:.8}");
            }
        }
        text
    }

    /// A case file: everything on the way as comments, then the tables.
    pub fn case_file(&self) -> String {
        let mut text = format!("# {}{}\n#\n", on_one_line(self.name.as_deref().unwrap_or("Belt")), self.at());
        for (name, value, unit) in self.rows() {
            let _ = writeln!(text, "# {name:<48}{value:>13.6} {unit}"); // writing to a string does not fail
        }
        for warning in &self.warnings {
            let _ = writeln!(text, "# warning: {}", on_one_line(warning));
        }
        text += "#\n# The radial stiffness holds for this sheave.half_angle alone.\n";
        if self.belt.loss_tangent.is_none() {
            text += "# No loss tangent was measured here: without belt.loss_tangent a case has that of the thesis's \
                     rubber.\n";
        }
        text += &format!("\n{}", self.tables());
        text.truncate(text.trim_end().len());
        text + "\n"
    }

    /// The figures: the equivalent section, and moduli over temperature where the rubber was tested at several.
    pub fn figures(&self) -> Vec<Figure> {
        [self.section_figure(), self.modulus_figure()].into_iter().flatten().collect()
    }

    fn section_figure(&self) -> Option<Figure> {
        let section = self.section?;
        let mm = |points: &[(f64, f64)]| points.iter().map(|(x, y)| (1e3 * x, 1e3 * y)).collect::<Vec<_>>();
        let across = |y: f64| vec![(0.0, 1e3 * y), (1e3 * section.width, 1e3 * y)];
        let mut series = vec![Series::line("equivalent section", mm(&section.corners())).color(0)];
        if !self.outline.is_empty() {
            series.push(Series::line("belt", mm(&self.outline)).look(Look::Dashed).color(6));
        }
        series.push(Series::line("neutral axis of the rubber", across(section.centroid)).color(1));
        series.push(Series::line("cords", across(section.cord_depth)).color(2));
        let caption = format!(
            "Equivalent section in bending: trapezoid {:.3} mm high, neutral axis of the rubber {:.3} mm above the \
            cords",
            1e3 * section.height,
            1e3 * section.above_cords
        );
        let mut figure = Figure::new(
            "section",
            caption,
            Axis::new("across the belt (mm)"),
            Axis::new("from the outside (mm)"),
            series,
        );
        figure.equal = true;
        Some(figure)
    }

    fn modulus_figure(&self) -> Option<Figure> {
        let [first, .., last] = self.rubber_tests.as_slice() else { return None };
        let tested = self.rubber_tests.iter().map(|test| (celsius(test.temperature), 1e-6 * test.youngs_modulus));
        let mut series = vec![Series::line("tests", tested.collect()).look(Look::Dots).color(0)];
        // Between tests as the properties are interpolated: ln E linear.
        let mut curve = Vec::new();
        for pair in self.rubber_tests.windows(2) {
            let (a, b) = (pair[0], pair[1]);
            curve.extend((0..=40).map(|at| {
                let share = f64::from(at) / 40.0;
                let modulus = a.youngs_modulus.powf(1.0 - share) * b.youngs_modulus.powf(share);
                (celsius(a.temperature + share * (b.temperature - a.temperature)), 1e-6 * modulus)
            }));
        }
        series.push(Series::line("interpolation", curve).color(6));
        if let Some(rubber) = self.rubber {
            let here = (celsius(rubber.temperature), 1e-6 * rubber.youngs_modulus);
            series.push(
                Series::line(format!("in use: {:.2} MPa at {:.1} °C", here.1, here.0), vec![here])
                    .look(Look::Dots)
                    .color(1),
            );
        }
        let caption = format!(
            "Young's modulus of the rubber between {:.1} °C and {:.1} °C",
            celsius(first.temperature),
            celsius(last.temperature)
        );
        let axes = (Axis::new("temperature (°C)"), Axis::new("Young's modulus E (MPa)"));
        Some(Figure::new("modulus", caption, axes.0, axes.1, series))
    }
}
