//! Lines cut to the frame and into dashes.

type Point = (f64, f64);

/// The parts of a line within a frame (left, right, top, bottom); a point that is no number breaks the line.
pub fn clipped(points: &[Point], frame: [f64; 4]) -> Vec<Vec<Point>> {
    let mut parts: Vec<Vec<Point>> = Vec::new();
    let mut end: Option<Point> = None;
    for pair in points.windows(2) {
        let &[a, b] = pair else { continue };
        let Some((from, to)) = inside(a, b, frame) else {
            end = None;
            continue;
        };
        match parts.last_mut() {
            Some(part) if end == Some(from) => part.push(to),
            _ => parts.push(vec![from, to]),
        }
        end = Some(to);
    }
    parts
}

/// The part of a segment within a frame (Y.-D. Liang, B. A. Barsky, ACM Trans. Graphics 3, 1984).
fn inside((ax, ay): Point, (bx, by): Point, [left, right, top, bottom]: [f64; 4]) -> Option<(Point, Point)> {
    if ![ax, ay, bx, by].iter().all(|value| value.is_finite()) {
        return None;
    }
    let (dx, dy) = (bx - ax, by - ay);
    let (mut t0, mut t1) = (0.0_f64, 1.0_f64);
    for (p, q) in [(-dx, ax - left), (dx, right - ax), (-dy, ay - top), (dy, bottom - ay)] {
        if p == 0.0 {
            if q < 0.0 {
                return None;
            }
        } else if p < 0.0 {
            t0 = t0.max(q / p);
        } else {
            t1 = t1.min(q / p);
        }
    }
    let at = |t: f64| {
        if t == 0.0 {
            (ax, ay)
        } else if t == 1.0 {
            (bx, by)
        } else {
            (ax + t * dx, ay + t * dy)
        }
    };
    (t0 <= t1).then(|| (at(t0), at(t1)))
}

/// The line without points that lie closer than `most` to the line without them (D. H. Douglas, T. K. Peucker,
/// Cartographica 10, 1973); both ends stay.
pub fn thinned(points: &[Point], most: f64) -> Vec<Point> {
    let last = points.len().saturating_sub(1);
    let mut kept = vec![false; points.len()];
    let mut open = vec![(0, last)];
    while let Some((from, to)) = open.pop() {
        let (Some(&a), Some(&b)) = (points.get(from), points.get(to)) else { continue };
        let farthest = (from + 1..to)
            .filter_map(|at| Some((at, distance(*points.get(at)?, a, b))))
            .max_by(|one, other| one.1.total_cmp(&other.1));
        if let Some((at, away)) = farthest
            && away > most
        {
            open.extend([(from, at), (at, to)]);
        }
        for end in [from, to] {
            kept.get_mut(end).into_iter().for_each(|kept| *kept = true);
        }
    }
    points.iter().zip(kept).filter_map(|(point, kept)| kept.then_some(*point)).collect()
}

/// The parts of a line between corners at which it turns by more than a right angle; neighbours share the corner.
pub fn between_corners(points: &[(i32, i32)]) -> Vec<Vec<(i32, i32)>> {
    let mut distinct = points.to_vec();
    distinct.dedup();
    let mut parts = vec![Vec::new()];
    for (at, &point) in distinct.iter().enumerate() {
        parts.last_mut().into_iter().for_each(|part| part.push(point));
        let neighbours = at.checked_sub(1).and_then(|before| Some((distinct.get(before)?, distinct.get(at + 1)?)));
        let Some((&(ax, ay), &(bx, by))) = neighbours else { continue };
        let turn =
            i64::from(point.0 - ax) * i64::from(bx - point.0) + i64::from(point.1 - ay) * i64::from(by - point.1);
        if turn < 0 {
            parts.push(vec![point]);
        }
    }
    parts
}

/// From a point to a segment.
fn distance((x, y): Point, (ax, ay): Point, (bx, by): Point) -> f64 {
    let (dx, dy) = (bx - ax, by - ay);
    let square = dx * dx + dy * dy;
    let t = if square > 0.0 { (((x - ax) * dx + (y - ay) * dy) / square).clamp(0.0, 1.0) } else { 0.0 };
    (ax + t * dx - x).hypot(ay + t * dy - y)
}

/// The line in dashes of length `on` with gaps of length `off`.
pub fn dashed(points: &[Point], on: f64, off: f64) -> Vec<Vec<Point>> {
    let mut dashes = Vec::new();
    let mut dash: Vec<Point> = points.first().copied().into_iter().collect();
    let (mut drawing, mut left) = (true, on);
    for pair in points.windows(2) {
        let &[(ax, ay), (bx, by)] = pair else { continue };
        let length = (bx - ax).hypot(by - ay);
        let mut done = 0.0;
        while length - done > left {
            done += left;
            let t = done / length;
            let here = (ax + t * (bx - ax), ay + t * (by - ay));
            if drawing {
                dash.push(here);
                dashes.push(std::mem::take(&mut dash));
            } else {
                dash = vec![here];
            }
            drawing = !drawing;
            left = if drawing { on } else { off };
        }
        left -= length - done;
        if drawing {
            dash.push((bx, by));
        }
    }
    if drawing && dash.len() > 1 {
        dashes.push(dash);
    }
    dashes
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_cut_at_the_frame_and_at_gaps() {
        let frame = [0.0, 10.0, 0.0, 10.0];
        assert_eq!(clipped(&[(-5.0, 5.0), (15.0, 5.0)], frame), [[(0.0, 5.0), (10.0, 5.0)]]);
        assert_eq!(clipped(&[(1.0, 1.0), (f64::NAN, 2.0), (3.0, 3.0), (4.0, 4.0)], frame), [[(3.0, 3.0), (4.0, 4.0)]]);
        assert!(clipped(&[(-5.0, -5.0), (15.0, -6.0)], frame).is_empty());
    }

    #[test]
    fn points_on_a_line_are_left_out_and_corners_stay() {
        let line = [(0.0, 0.0), (1.0, 0.01), (2.0, 0.0), (3.0, 1.0), (4.0, 2.0)];
        assert_eq!(thinned(&line, 0.1), [(0.0, 0.0), (2.0, 0.0), (4.0, 2.0)]);
        assert_eq!(thinned(&line, 0.0).len(), 4);
        assert_eq!(thinned(&[(1.0, 1.0); 3], 0.1), [(1.0, 1.0); 2]);
        assert!(thinned(&[], 0.1).is_empty());
    }

    #[test]
    fn a_line_is_parted_where_it_turns_back() {
        let spike = [(0, 0), (0, 0), (5, 50), (6, 0), (20, 0), (20, 9)];
        assert_eq!(between_corners(&spike), [vec![(0, 0), (5, 50)], vec![(5, 50), (6, 0), (20, 0), (20, 9)]]);
        assert_eq!(between_corners(&[(3, 3); 4]), [vec![(3, 3)]]);
    }

    #[test]
    fn dashes_have_their_lengths() {
        let dashes = dashed(&[(0.0, 0.0), (4.0, 0.0), (10.0, 0.0)], 3.0, 2.0);
        assert_eq!(dashes, [vec![(0.0, 0.0), (3.0, 0.0)], vec![(5.0, 0.0), (8.0, 0.0)]]);
    }
}
