//! Draws `wiring.txt` as an SVG: parts with their pins, each pin labelled with its net. Usage: `rig-schematic >
//! wiring.svg`.

use std::collections::BTreeMap;
use std::fmt::Write as _;

const WIRING: &str = include_str!("../wiring.txt");
/// Pixels of a drawing unit.
const UNIT: i32 = 12;
const WIDTH: i32 = 16 * UNIT;

/// Which side of its part a pin is on.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

struct Pin {
    side: Side,
    name: String,
    net: String,
}

struct Part {
    title: String,
    column: i32,
    row: i32,
    pins: Vec<Pin>,
}

/// Takes the text apart; a line that is not understood is returned as the error.
fn parse(text: &str) -> Result<Vec<Part>, String> {
    let mut parts: Vec<Part> = Vec::new();
    for line in text.lines().map(str::trim).filter(|line| !line.is_empty() && !line.starts_with('#')) {
        let bad = || format!("not understood: {line}");
        if line.starts_with("part ") {
            let mut quoted = line.split('"');
            let (Some(_), Some(title), Some(place)) = (quoted.next(), quoted.next(), quoted.next()) else {
                return Err(bad());
            };
            let place: Vec<i32> = place.split_whitespace().filter_map(|number| number.parse().ok()).collect();
            let [column, row] = place[..] else { return Err(bad()) };
            parts.push(Part { title: title.to_owned(), column, row, pins: Vec::new() });
            continue;
        }
        let words: Vec<&str> = line.split_whitespace().collect();
        let [side, name, net] = words[..] else { return Err(bad()) };
        let side = match side {
            "left" => Side::Left,
            "right" => Side::Right,
            _ => return Err(bad()),
        };
        let part = parts.last_mut().ok_or_else(bad)?;
        part.pins.push(Pin { side, name: name.to_owned(), net: net.to_owned() });
    }
    Ok(parts)
}

/// How many pins each net joins.
fn nets(parts: &[Part]) -> BTreeMap<&str, usize> {
    let mut nets = BTreeMap::new();
    for pin in parts.iter().flat_map(|part| &part.pins) {
        *nets.entry(pin.net.as_str()).or_default() += 1;
    }
    nets
}

/// Parts of resistors or contacts alone, which need no ground of their own.
const PASSIVE: [&str; 3] = ["Pull-ups", "Ignition relay", "Emergency stop"];
/// Nets that a pin of the Raspberry Pi may share with parts that run on 5 V: inputs of theirs that 3.3 V suffices for.
const DRIVEN_BY_THE_PI: [&str; 3] = ["SERVO", "BRAKE_DIR", "BRAKE_ON"];

/// What is wrong with the wiring: nets that end nowhere, parts without ground, pins named twice, 5 V at the Raspberry
/// Pi's inputs (which stand 3.3 V).
fn mistakes(parts: &[Part]) -> Vec<String> {
    let name = |part: &Part| part.title.split('|').next().unwrap_or_default().to_owned();
    let on = |part: &Part, net: &str| part.pins.iter().any(|pin| pin.net == net);
    let mut mistakes: Vec<String> =
        nets(parts).iter().filter(|(_, pins)| **pins < 2).map(|(net, _)| format!("{net} ends nowhere")).collect();
    for part in parts {
        if !PASSIVE.contains(&name(part).as_str()) && !on(part, "GND") {
            mistakes.push(format!("{} has no ground", name(part)));
        }
        let mut pins: Vec<&str> = part.pins.iter().map(|pin| pin.name.as_str()).collect();
        pins.sort_unstable();
        if let Some(twice) = pins.windows(2).find(|pair| pair.first() == pair.last()) {
            mistakes.push(format!("{} has two pins {}", name(part), twice.concat()));
        }
    }
    let signal = |net: &str| !matches!(net, "GND" | "+5V" | "+3V3") && !DRIVEN_BY_THE_PI.contains(&net);
    for pin in parts.iter().filter(|part| name(part) == "Raspberry Pi").flat_map(|part| &part.pins) {
        for part in parts.iter().filter(|part| signal(&pin.net) && on(part, &pin.net)) {
            if on(part, "+5V") && !on(part, "+3V3") {
                mistakes.push(format!("{} puts 5 V on pin {} of the Raspberry Pi", name(part), pin.name));
            }
        }
    }
    mistakes
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

fn colour(net: &str) -> &'static str {
    match net {
        "GND" => "#555",
        "+5V" | "+12V" | "+3V3" => "#b00020",
        _ => "#0b57d0",
    }
}

fn draw(parts: &[Part]) -> String {
    let mut body = String::new();
    let mut bottom = 0;
    for part in parts {
        let count = |side: Side| part.pins.iter().filter(|pin| pin.side == side).count() as i32;
        let (x, y) = ((part.column + 4) * UNIT, (part.row + 2) * UNIT);
        let height = (count(Side::Left).max(count(Side::Right)) as f64 * 1.4 * f64::from(UNIT)) as i32 + 3 * UNIT;
        bottom = bottom.max(y + height);
        let _ = writeln!(
            body,
            r##"<rect x="{x}" y="{y}" width="{WIDTH}" height="{height}" fill="#fff" stroke="#222" rx="3"/>"##
        );
        for (line, text) in part.title.split('|').enumerate() {
            let (style, down) = if line == 0 { ("font-weight='600'", 14) } else { ("fill='#444'", 27) };
            let middle = x + WIDTH / 2;
            let text = escaped(text);
            let _ = writeln!(body, r#"<text x="{middle}" y="{}" text-anchor="middle" {style}>{text}</text>"#, y + down);
        }
        let mut placed = [0, 0];
        for pin in &part.pins {
            let left = pin.side == Side::Left;
            let place = &mut placed[usize::from(!left)];
            let at = y + 3 * UNIT + (f64::from(*place) * 1.4 * f64::from(UNIT)) as i32 + 4;
            *place += 1;
            let (edge, out, inside) =
                if left { (x, x - 14, x + 5) } else { (x + WIDTH, x + WIDTH + 14, x + WIDTH - 5) };
            let (anchor, other, label) = if left { ("start", "end", out - 4) } else { ("end", "start", out + 4) };
            let (colour, name, net) = (colour(&pin.net), escaped(&pin.name), escaped(&pin.net));
            let _ = writeln!(body, r#"<path d="M{edge} {at}H{out}" stroke="{colour}" stroke-width="1.5"/>"#);
            let _ = writeln!(body, r#"<text x="{inside}" y="{}" text-anchor="{anchor}">{name}</text>"#, at + 4);
            let _ = writeln!(
                body,
                r#"<text x="{label}" y="{}" text-anchor="{other}" fill="{colour}">{net}</text>"#,
                at + 4
            );
        }
    }
    let (width, height) = (91 * UNIT, bottom + 2 * UNIT);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" \
         height=\"{height}\" font-family=\"sans-serif\" font-size=\"10.5\">\n<rect width=\"100%\" height=\"100%\" \
         fill=\"#fff\"/>\n{body}</svg>\n"
    )
}

fn main() -> Result<(), String> {
    let parts = parse(WIRING)?;
    let mistakes = mistakes(&parts);
    if !mistakes.is_empty() {
        return Err(mistakes.join("; "));
    }
    print!("{}", draw(&parts));
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_committed_drawing_is_the_one_of_the_wiring() {
        let committed = include_str!("../../../docs/rig/wiring.svg");
        assert!(parse(WIRING).map(|parts| draw(&parts)).as_deref() == Ok(committed), "draw it anew: see rig/README.md");
    }

    #[test]
    fn the_wiring_holds_its_rules_and_every_broken_rule_is_named() {
        let found = |text: &str| mistakes(&parse(text).unwrap_or_default()).join("; ");
        assert_eq!(found(WIRING), "");
        assert!(parse(WIRING).is_ok_and(|parts| parts.len() > 12));
        for (from, to, mistake) in [
            ("right OUT HALL_P", "right OUT HALL_X", "HALL_X ends nowhere"),
            ("left SDA_5 SDA_5V\n", "left SDA_5 SDA_5V\nleft SDA_5 SDA_5V\n", "has two pins SDA_5"),
            ("right A4 SDA_5V", "right A4 SDA", "Arduino Nano puts 5 V on pin 3 of the Raspberry Pi"),
            ("left SCL SCL\nleft GND GND", "left SCL SCL", "MLX90614 has no ground"),
        ] {
            let changed = WIRING.replacen(from, to, 1);
            assert!(found(&changed).contains(mistake), "{from} -> {to}: {}", found(&changed));
        }
        assert!(parse("part nano").is_err() && parse("left D2 X").is_err());
    }
}
