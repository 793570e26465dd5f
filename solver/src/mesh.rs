//! Meshes: making, splitting, redistributing.

/// `intervals + 1` equidistant nodes; at least one interval.
pub fn uniform((a, b): (f64, f64), intervals: usize) -> Vec<f64> {
    let count = intervals.max(1);
    let mut mesh: Vec<f64> = (0..=count).map(|j| a + (b - a) * (j as f64 / count as f64)).collect();
    mesh[count] = b;
    mesh
}

/// Divides interval `j` into `pieces[j]` equal ones, or into fewer if rounding would decide on their lengths.
pub(crate) fn split(mesh: &[f64], pieces: &[usize]) -> Vec<f64> {
    let mut out = Vec::with_capacity(mesh.len());
    for (pair, &count) in mesh.windows(2).zip(pieces) {
        let length = pair[1] - pair[0];
        let most = length / shortest(pair[0], pair[1]);
        let count = if count as f64 <= most { count } else { most as usize }.max(1);
        out.extend((0..count).map(|i| pair[0] + length * (i as f64 / count as f64)));
    }
    out.extend(mesh.last());
    out
}

/// Every interval divided into two, as far as rounding allows.
pub(crate) fn halved(mesh: &[f64]) -> Vec<f64> {
    split(mesh, &vec![2; mesh.len() - 1])
}

/// Of an interval between two nodes that is no longer than this, rounding decides on the length.
fn shortest(a: f64, b: f64) -> f64 {
    8.0 * f64::EPSILON * a.abs().max(b.abs())
}

/// Whether the parts of an interval are longer than what rounding decides on, if it is divided into as many as make a
/// difference.
pub(crate) fn is_divisible(a: f64, b: f64) -> bool {
    const PARTS: f64 = 8.0;
    b - a > PARTS * shortest(a, b)
}

/// Every `stride`-th node and the last, but no fewer than `fewest` intervals if there are as many.
pub(crate) fn thinned(mesh: &[f64], stride: usize, fewest: usize) -> Vec<f64> {
    let last = mesh.len() - 1;
    let stride = stride.min(last / fewest).max(1);
    (0..last).step_by(stride).chain([last]).map(|j| mesh[j]).collect()
}

/// How fast neighbouring intervals may grow: the change of the interval length per length.
const GRADATION: f64 = 0.7;

/// Bounds the gradation of wanted interval lengths `wanted`, by shortening.
pub(crate) fn grade(mesh: &[f64], wanted: &mut [f64]) {
    let middle = |j: usize| 0.5 * (mesh[j] + mesh[j + 1]);
    for j in 1..wanted.len() {
        wanted[j] = wanted[j].min(wanted[j - 1] + GRADATION * (middle(j) - middle(j - 1)));
    }
    for j in (1..wanted.len()).rev() {
        wanted[j - 1] = wanted[j - 1].min(wanted[j] + GRADATION * (middle(j) - middle(j - 1)));
    }
}

/// Number of intervals of the wanted lengths that fit.
pub(crate) fn needed(mesh: &[f64], wanted: &[f64]) -> f64 {
    mesh.windows(2).zip(wanted).map(|(pair, wanted)| (pair[1] - pair[0]) / wanted).sum()
}

/// A mesh of `intervals` whose lengths are in proportion to `wanted`, which is constant on each old interval.
pub(crate) fn equidistribute(mesh: &[f64], wanted: &[f64], intervals: usize) -> Vec<f64> {
    let share = needed(mesh, wanted) / intervals as f64;
    let mut out = Vec::with_capacity(intervals + 1);
    out.push(mesh[0]);
    let mut before = 0.0;
    for (pair, wanted) in mesh.windows(2).zip(wanted) {
        let density = 1.0 / wanted;
        let after = before + (pair[1] - pair[0]) * density;
        while out.len() < intervals && out.len() as f64 * share <= after {
            let s = pair[0] + (out.len() as f64 * share - before) / density;
            if out.last().is_some_and(|&last| s > last) && s < mesh[mesh.len() - 1] {
                out.push(s);
            } else {
                break;
            }
        }
        before = after;
    }
    out.push(mesh[mesh.len() - 1]);
    out
}

/// Without the nodes that lie so close to their left neighbours that rounding decides on the length between them.
pub(crate) fn distinct(mesh: Vec<f64>) -> Vec<f64> {
    let close = |a: f64, b: f64| b - a <= shortest(a, b);
    if !mesh.windows(2).any(|pair| close(pair[0], pair[1])) {
        return mesh;
    }
    let end = mesh[mesh.len() - 1];
    let mut kept = vec![mesh[0]];
    for &node in &mesh[1..mesh.len() - 1] {
        if !close(kept[kept.len() - 1], node) && !close(node, end) {
            kept.push(node);
        }
    }
    kept.push(end);
    kept
}

/// Slope at node `j` of the parabola through it and its neighbours; at an end that of the secant beside it.
pub(crate) fn slope(mesh: &[f64], values: &[f64], j: usize) -> f64 {
    let secant = |j: usize| (values[j + 1] - values[j]) / (mesh[j + 1] - mesh[j]);
    let last = mesh.len() - 1;
    match j {
        0 => secant(0),
        _ if j == last => secant(last - 1),
        _ => {
            let (left, right) = (mesh[j] - mesh[j - 1], mesh[j + 1] - mesh[j]);
            (secant(j - 1) * right + secant(j) * left) / (left + right)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn is_mesh(mesh: &[f64]) -> bool {
        mesh.windows(2).all(|pair| pair[0] < pair[1])
    }

    proptest! {
        #[test]
        fn redistribution_gives_the_wanted_number_of_increasing_nodes(
            lengths in proptest::collection::vec(1e-3..1.0_f64, 1..30),
            wanted in proptest::collection::vec(1e-3..1.0_f64, 30),
            intervals in 1_usize..60,
        ) {
            let mut mesh = vec![0.0];
            for h in &lengths {
                mesh.push(mesh[mesh.len() - 1] + h);
            }
            let mut wanted = wanted[..lengths.len()].to_vec();
            grade(&mesh, &mut wanted);
            let new = equidistribute(&mesh, &wanted, intervals);
            prop_assert_eq!(new.len(), intervals + 1);
            prop_assert!(is_mesh(&new));
            prop_assert_eq!((new[0], new[intervals]), (0.0, mesh[lengths.len()]));
        }
    }

    #[test]
    fn thinning_keeps_the_ends_and_enough_intervals() {
        let mesh = [0.0, 1.0, 3.0, 4.0, 6.0, 7.0, 9.0];
        assert_eq!(thinned(&mesh, 2, 2), [0.0, 3.0, 6.0, 9.0]);
        assert_eq!(thinned(&mesh, 4, 1), [0.0, 6.0, 9.0]);
        assert_eq!(thinned(&mesh, 4, 3), [0.0, 3.0, 6.0, 9.0]);
        assert_eq!(thinned(&mesh, 4, 7), mesh);
    }

    #[test]
    fn splitting_keeps_the_old_nodes() {
        assert_eq!(split(&[0.0, 1.0, 3.0], &[2, 1]), [0.0, 0.5, 1.0, 3.0]);
        // From 1 on numbers are ε apart: an interval of 10 ε is not divided, and one of 40 ε not into eight.
        let mesh = [0.0, 1.0, 1.0 + 10.0 * f64::EPSILON, 1.0 + 50.0 * f64::EPSILON];
        assert_eq!(halved(&mesh).len(), 6);
        let new = split(&mesh, &[1, 8, 8]);
        assert!(new.len() == 7 && is_mesh(&new), "{new:?}");
    }
}
