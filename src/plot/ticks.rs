//! Where an axis has its ticks, and what they say.

/// Part of a step by which data may overshoot a tick.
const HAIR: f64 = 0.02;

/// A tick: its place on the axis and its text.
pub type Tick = (f64, String);

/// The range widened to whole steps of 1, 2 or 5 times a power of ten, and its ticks, about `count` of them.
pub fn linear(low: f64, high: f64, count: usize, widen: bool) -> ((f64, f64), Vec<Tick>) {
    let (low, high) = if high - low > 1e-12 * high.abs().max(low.abs()) { (low, high) } else { around(low) };
    let raw = (high - low) / count.max(1) as f64;
    let power = 10_f64.powf(raw.log10().floor());
    let step = [1.0, 2.0, 5.0, 10.0].into_iter().map(|part| part * power).find(|step| *step >= 0.999 * raw);
    let step = step.unwrap_or(power);
    // What overshoots a tick by a hair does not call for another.
    let (first, last) =
        ((low / step + HAIR).floor(), (high / step - HAIR).ceil().max((low / step + HAIR).floor() + 1.0));
    let range = if widen { (low.min(first * step), high.max(last * step)) } else { (low, high) };
    let digits = (-(step.log10() + 1e-9).floor()).max(0.0) as usize;
    let ticks = (0..=(last - first) as usize).map(|index| (first + index as f64) * step);
    let within = ticks.filter(|tick| *tick >= range.0 - 1e-9 * step && *tick <= range.1 + 1e-9 * step);
    (range, within.map(|tick| (tick, number(tick, digits))).collect())
}

/// The range as it is, with a tick at every multiple of `step`.
pub fn multiples(low: f64, high: f64, step: f64) -> ((f64, f64), Vec<Tick>) {
    let (first, last) = ((low / step - 1e-9).ceil(), (high / step + 1e-9).floor());
    let ticks = (0..=(last - first).max(0.0) as usize).map(|index| (first + index as f64) * step);
    ((low, high), ticks.map(|tick| (tick, number(tick, 0))).collect())
}

/// The range, given as logarithms to base 10, widened to whole decades, and its ticks there.
pub fn decades(low: f64, high: f64) -> ((f64, f64), Vec<Tick>) {
    let (first, last) = (low.floor(), high.ceil().max(low.floor() + 1.0));
    let ticks = (0..=(last - first) as usize).map(|index| first + index as f64);
    ((first, last), ticks.map(|power| (power, power_of_ten(power as i32))).collect())
}

fn around(value: f64) -> (f64, f64) {
    let half = if value == 0.0 { 1.0 } else { 0.05 * value.abs() };
    (value - half, value + half)
}

fn number(value: f64, digits: usize) -> String {
    let text = format!("{value:.digits$}");
    let text =
        if text.trim_start_matches('-').chars().all(|c| c == '0' || c == '.') { text.replace('-', "") } else { text };
    text.replace('-', "\u{2212}")
}

fn power_of_ten(power: i32) -> String {
    let superscript = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        '0' => '⁰',
        digit => char::from_u32(0x2070 + digit as u32 - '0' as u32).unwrap_or(digit),
    };
    format!("10{}", power.to_string().chars().map(superscript).collect::<String>())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round_and_cover_the_data() {
        let texts = |ticks: Vec<Tick>| ticks.into_iter().map(|(_, text)| text).collect::<Vec<_>>();
        let (range, ticks) = linear(-0.3, 11.2, 5, true);
        assert_eq!(range, (-5.0, 15.0));
        assert_eq!(texts(ticks), ["−5", "0", "5", "10", "15"]);
        let (range, ticks) = linear(0.72, 1.74, 5, false);
        assert_eq!(range, (0.72, 1.74));
        assert_eq!(texts(ticks), ["1.0", "1.5"]);
        let (range, _) = linear(3.0, 3.0, 5, true);
        assert!(range.0 < 3.0 && range.1 > 3.0);
        assert_eq!(texts(decades(-4.2, 0.5).1), ["10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰", "10¹"]);
    }
}
