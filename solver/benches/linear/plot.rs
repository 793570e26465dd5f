//! Cost against the number of intervals, both logarithmic.

use plotters::coord::Shift;
use plotters::prelude::*;

pub struct Curve {
    pub name: String,
    pub points: Vec<(f64, f64)>,
}

type Failure = Box<dyn std::error::Error>;
type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

const COLOURS: [RGBColor; 5] =
    [RGBColor(0, 0, 0), RGBColor(213, 94, 0), RGBColor(0, 114, 178), RGBColor(0, 158, 115), RGBColor(204, 121, 167)];

/// Both figures side by side, as SVG.
///
/// # Errors
/// Those of the backend.
pub fn draw(times: &[Curve], memory: &[Curve]) -> Result<String, Failure> {
    let mut text = String::new();
    {
        let area = SVGBackend::with_string(&mut text, (1100, 460)).into_drawing_area();
        area.fill(&WHITE)?;
        let (left, right) = area.split_horizontally(620);
        figure(&left, "Time, s", times, 0)?;
        figure(&right, "Peak memory, bytes", memory, 3)?;
        area.present()?;
    }
    Ok(text)
}

fn figure(area: &Area<'_>, title: &str, curves: &[Curve], first_colour: usize) -> Result<(), Failure> {
    let all = || curves.iter().flat_map(|curve| curve.points.iter().copied()).filter(|point| point.1 > 0.0);
    let bounds = |values: &mut dyn Iterator<Item = f64>| {
        values.fold((f64::INFINITY, 0.0), |(low, high): (f64, f64), value| (low.min(value), high.max(value)))
    };
    let (x, y) = (bounds(&mut all().map(|point| point.0)), bounds(&mut all().map(|point| point.1)));
    let decades = |(low, high): (f64, f64)| 10_f64.powf(low.log10().floor())..10_f64.powf(high.log10().ceil());
    let mut chart = ChartBuilder::on(area)
        .caption(title, ("sans-serif", 20))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(62)
        .build_cartesian_2d(decades(x).log_scale(), decades(y).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("intervals")
        .label_style(("sans-serif", 14))
        .x_label_formatter(&|value| format!("1e{:.0}", value.log10()))
        .y_label_formatter(&|value| format!("1e{:.0}", value.log10()))
        .light_line_style(WHITE)
        .draw()?;
    for (curve, colour) in curves.iter().zip(COLOURS.into_iter().skip(first_colour)) {
        let points: Vec<_> = curve.points.iter().copied().filter(|point| point.1 > 0.0).collect();
        chart.draw_series(points.iter().map(|&point| Circle::new(point, 3, colour.filled())))?;
        chart
            .draw_series(LineSeries::new(points, colour.stroke_width(2)))?
            .label(curve.name.clone())
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperLeft)
        .label_font(("sans-serif", 14))
        .background_style(WHITE)
        .border_style(BLACK)
        .draw()?;
    Ok(())
}
