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

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;")
}

fn colour(net: &str) -> &'static str {
    match net {
        "GND" => "#555",
        "+5V" | "+12V" => "#b00020",
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
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" width=\"{width}\" height=\"{height}\" \
         font-family=\"sans-serif\" font-size=\"10.5\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n{body}</svg>\n"
    )
}

fn main() -> Result<(), String> {
    let parts = parse(WIRING)?;
    if let Some((net, _)) = nets(&parts).into_iter().find(|(net, pins)| *pins < 2 && *net != "+12V") {
        return Err(format!("the net {net} ends nowhere"));
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
    fn every_net_joins_two_pins_and_a_wrong_line_is_named() {
        let parts = parse(WIRING).unwrap_or_default();
        assert!(parts.len() > 10);
        assert_eq!(
            nets(&parts).iter().filter(|(_, pins)| **pins < 2).map(|(net, _)| *net).collect::<Vec<_>>(),
            ["+12V"]
        );
        assert!(parse("part nano").is_err() && parse("left D2 X").is_err());
    }
}
