//! Cubic Hermite interpolation on a tensor grid.
//!
//! Each node has a value and its first derivatives, which the solver gives exactly. A cell of n axes needs all mixed
//! derivatives besides; these are differences of the exact ones between neighbours, quadratic in the distance, so that
//! the interpolant stays of fourth order, and it is smooth across the cells' faces.

/// A tensor grid: the number of breakpoints of each axis, the last axis running fastest.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Shape {
    lens: Vec<usize>,
    strides: Vec<usize>,
}

impl Shape {
    pub fn new(lens: Vec<usize>) -> Self {
        let mut strides = vec![1; lens.len()];
        for axis in (1..lens.len()).rev() {
            strides[axis - 1] = strides[axis] * lens[axis];
        }
        Self { lens, strides }
    }

    pub fn axes(&self) -> usize {
        self.lens.len()
    }

    /// Number of points.
    pub fn points(&self) -> usize {
        self.lens.iter().product()
    }

    pub fn stride(&self, axis: usize) -> usize {
        self.strides[axis]
    }

    pub fn len(&self, axis: usize) -> usize {
        self.lens[axis]
    }

    /// Place along an axis of a point.
    pub fn place(&self, point: usize, axis: usize) -> usize {
        point / self.strides[axis] % self.lens[axis]
    }

    /// The points in an order in which each is a neighbour of the one before it, the last of `axes`, which are all,
    /// running fastest.
    pub fn snake(&self, axes: Vec<usize>) -> impl Iterator<Item = usize> + '_ {
        (0..self.points()).map(move |number| {
            let (mut point, mut rest) = (0, number);
            for axis in axes.iter().rev() {
                let (place, above) = (rest % self.lens[*axis], rest / self.lens[*axis]);
                // A line goes back after one that went forth.
                let turned = if above % 2 == 1 { self.lens[*axis] - 1 - place } else { place };
                point += turned * self.strides[*axis];
                rest = above;
            }
            point
        })
    }
}

/// Place in a cell: in the interval of each axis, its share from the left and its width.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Local {
    /// The corner with the lowest breakpoints.
    pub corner: usize,
    /// Share of the way through each interval, and its width.
    pub shares: Vec<(f64, f64)>,
}

/// Values and derivatives of the four cubics of an interval: by value and slope at both ends.
struct Cubics {
    /// By end, then by order of the derivative at that end.
    value: [[f64; 2]; 2],
    slope: [[f64; 2]; 2],
}

impl Cubics {
    fn at(share: f64, width: f64) -> Self {
        let (t, u) = (share, 1.0 - share);
        Self {
            value: [[u * u * (1.0 + 2.0 * t), width * t * u * u], [t * t * (3.0 - 2.0 * t), -width * t * t * u]],
            slope: [[-6.0 * t * u / width, u * (1.0 - 3.0 * t)], [6.0 * t * u / width, t * (3.0 * t - 2.0)]],
        }
    }
}

/// Weights of the corners' derivatives at a place in a cell: for the value, then for the slope along each axis.
#[derive(Debug, Clone, Default)]
pub(super) struct Weights {
    /// Offsets of the corners from the first.
    corners: Vec<usize>,
    /// For the value and each slope: corner by corner, derivative by derivative.
    weights: Vec<Vec<f64>>,
}

impl Weights {
    pub fn new(shape: &Shape, local: &Local) -> Self {
        let axes = shape.axes();
        let cubics: Vec<Cubics> = local.shares.iter().map(|(share, width)| Cubics::at(*share, *width)).collect();
        let many = 1 << axes;
        let corners = (0..many)
            .map(|corner: usize| (0..axes).filter(|axis| corner >> axis & 1 == 1).map(|axis| shape.stride(axis)).sum());
        let weight = |along: Option<usize>, corner: usize, order: usize| -> f64 {
            let factor = |(axis, cubics): (usize, &Cubics)| {
                let table = if along == Some(axis) { &cubics.slope } else { &cubics.value };
                table[corner >> axis & 1][order >> axis & 1]
            };
            cubics.iter().enumerate().map(factor).product()
        };
        let all = |along: Option<usize>| {
            (0..many)
                .flat_map(|corner| (0..many).map(move |order| (corner, order)))
                .map(|(corner, order)| weight(along, corner, order))
                .collect()
        };
        let weights = std::iter::once(None).chain((0..axes).map(Some)).map(all).collect();
        Self { corners: corners.collect(), weights }
    }

    /// The value of a quantity and its slopes, from all derivatives at the grid's points:
    /// `jets[point][quantity][order]` with `width` numbers a point, those of the quantity beginning at `first`.
    pub fn apply(&self, jets: &[f64], corner: usize, width: usize, first: usize) -> (f64, Vec<f64>) {
        let many = self.corners.len();
        let part = |weights: &Vec<f64>| {
            let corners = self.corners.iter().zip(weights.chunks_exact(many));
            let sum = corners.map(|(offset, weights)| {
                let begin = (corner + offset) * width + first;
                let jet = jets.get(begin..begin + many).unwrap_or_default();
                weights.iter().zip(jet).map(|(weight, derivative)| weight * derivative).sum::<f64>()
            });
            sum.sum::<f64>()
        };
        let mut parts = self.weights.iter().map(part);
        let value = parts.next().unwrap_or(f64::NAN);
        (value, parts.collect())
    }
}

/// All mixed derivatives at the grid's points: `orders[point]` from values and first derivatives, which are `None`
/// where a point has none. Bit k of an order stands for a derivative along axis k.
pub(super) fn jets(shape: &Shape, places: &[&[f64]], known: &[Option<(f64, &[f64])>]) -> Vec<Vec<f64>> {
    let (axes, points) = (shape.axes(), shape.points());
    let many = 1_usize << axes;
    let mut jets = vec![vec![f64::NAN; many]; points];
    for (jet, known) in jets.iter_mut().zip(known) {
        let Some((value, slopes)) = known else { continue };
        jet[0] = *value;
        for (axis, slope) in slopes.iter().enumerate() {
            jet[1 << axis] = *slope;
        }
    }
    let mut orders: Vec<usize> = (0..many).filter(|order| order.count_ones() > 1).collect();
    orders.sort_by_key(|order| order.count_ones());
    for order in orders {
        for point in (0..points).filter(|point| known.get(*point).is_some_and(Option::is_some)) {
            let parts = (0..axes).filter(|axis| order >> axis & 1 == 1);
            let lower = |axis: usize| {
                let at = |point: usize| jets[point][order & !(1 << axis)];
                difference(shape, places[axis], point, axis, at)
            };
            let mean = parts.map(lower).sum::<f64>() / f64::from(order.count_ones());
            jets[point][order] = mean;
        }
    }
    jets
}

/// The derivative along an axis of what is known at points: by the parabola through three neighbours, by a line where
/// there are two, zero where there is one.
pub(super) fn difference(shape: &Shape, places: &[f64], point: usize, axis: usize, at: impl Fn(usize) -> f64) -> f64 {
    let (place, stride) = (shape.place(point, axis), shape.stride(axis));
    let neighbour = |step: isize| -> Option<(f64, f64)> {
        let there = place.checked_add_signed(step).filter(|there| *there < shape.len(axis))?;
        let value = at(point.checked_add_signed(step * stride.cast_signed())?);
        value.is_finite().then(|| (places[there] - places[place], value))
    };
    let here = at(point);
    let ahead = neighbour(1);
    let back = neighbour(-1);
    let pair = match (back, ahead) {
        (Some(a), Some(b)) => (a, b),
        (None, Some(a)) => (a, neighbour(2).unwrap_or(a)),
        (Some(a), None) => (a, neighbour(-2).unwrap_or(a)),
        (None, None) => return 0.0,
    };
    let ((a, left), (b, right)) = pair;
    let (left, right) = ((left - here) / a, (right - here) / b);
    if a == b { left } else { (b * left - a * right) / (b - a) }
}

/// By how much the cubic through two points is wrong in the middle between them, as the quintic says that meets value
/// and slope of a third besides. Each point with its place, value and slope.
pub(super) fn quintic_less_cubic(a: [f64; 3], b: [f64; 3], c: [f64; 3]) -> f64 {
    let [x0, y0, d0] = a;
    let [x1, y1, d1] = b;
    let [x, y, d] = c;
    let width = x1 - x0;
    let cubics = Cubics::at((x - x0) / width, width);
    let of = |table: &[[f64; 2]; 2]| table[0][0] * y0 + table[0][1] * d0 + table[1][0] * y1 + table[1][1] * d1;
    let (rest, slope_rest) = (y - of(&cubics.value), d - of(&cubics.slope));
    let bump = |x: f64| ((x - x0) * (x - x1)).powi(2);
    let bump_slope = 2.0 * (x - x0) * (x - x1) * (2.0 * x - x0 - x1);
    let first = rest / bump(x);
    let second = (slope_rest - bump_slope * first) / bump(x);
    let middle = 0.5 * (x0 + x1);
    bump(middle) * (first + second * (middle - x))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A function of three variables with its first derivatives.
    fn f(x: &[f64]) -> (f64, Vec<f64>) {
        let (a, b, c) = (x[0], x[1], x[2]);
        let value = (a * b).sin() + c * c * a + (0.5 * c * b).exp();
        let e = (0.5 * c * b).exp();
        (value, vec![b * (a * b).cos() + c * c, a * (a * b).cos() + 0.5 * c * e, 2.0 * c * a + 0.5 * b * e])
    }

    /// Largest error over some points of value and slopes on a grid of n³ points over [0, 1]³ with unequal intervals.
    fn errors(n: usize) -> (f64, f64) {
        let places: Vec<f64> = (0..n).map(|i| i as f64 / (n - 1) as f64).map(|t| t * (0.8 + 0.2 * t)).collect();
        let shape = Shape::new(vec![n; 3]);
        let at = |point: usize| (0..3).map(|axis| places[shape.place(point, axis)]).collect::<Vec<f64>>();
        let samples: Vec<(f64, Vec<f64>)> = (0..shape.points()).map(|point| f(&at(point))).collect();
        let known: Vec<Option<(f64, &[f64])>> = samples.iter().map(|(y, d)| Some((*y, d.as_slice()))).collect();
        let jets = jets(&shape, &[&places, &places, &places], &known).concat();
        let (mut worst, mut slopes) = (0.0_f64, 0.0_f64);
        for i in 0..200 {
            let x: Vec<f64> =
                [0.754_877, 0.569_840, 0.430_159].iter().map(|a| (a * f64::from(i + 1)).fract()).collect();
            let interval = |x: f64| places.partition_point(|p| *p <= x).clamp(1, n - 1) - 1;
            let corner = x.iter().enumerate().map(|(axis, x)| interval(*x) * shape.stride(axis)).sum();
            let share = |x: f64| {
                let i = interval(x);
                ((x - places[i]) / (places[i + 1] - places[i]), places[i + 1] - places[i])
            };
            let local = Local { corner, shares: x.iter().map(|x| share(*x)).collect() };
            let (value, slope) = Weights::new(&shape, &local).apply(&jets, local.corner, 8, 0);
            let (exact, by) = f(&x);
            worst = worst.max((value - exact).abs());
            slopes = slope.iter().zip(&by).fold(slopes, |worst, (a, b)| worst.max((a - b).abs()));
        }
        (worst, slopes)
    }

    #[test]
    fn it_is_of_fourth_order_and_its_slopes_of_third() {
        let (coarse, coarse_slope) = errors(6);
        let (fine, fine_slope) = errors(11);
        assert!(fine < 1e-4 && fine_slope < 2e-3, "{fine:.2e} {fine_slope:.2e}");
        assert!(coarse / fine > 10.0, "{coarse:.2e} over {fine:.2e}");
        assert!(coarse_slope / fine_slope > 5.0, "{coarse_slope:.2e} over {fine_slope:.2e}");
    }

    #[test]
    fn the_error_of_a_cubic_is_estimated_exactly_for_quintics() {
        let y = |x: f64| 1.0 + x - 2.0 * x.powi(3) + 0.7 * x.powi(4) - 0.3 * x.powi(5);
        let d = |x: f64| 1.0 - 6.0 * x * x + 2.8 * x.powi(3) - 1.5 * x.powi(4);
        let point = |x: f64| [x, y(x), d(x)];
        let (a, b) = (0.4, 1.1);
        let middle = 0.5 * (a + b);
        let cubic = 0.5 * (y(a) + y(b)) + (b - a) / 8.0 * (d(a) - d(b));
        for c in [-0.3, 2.0] {
            let found = quintic_less_cubic(point(a), point(b), point(c));
            assert!((found - (y(middle) - cubic)).abs() < 1e-12, "{found} {}", y(middle) - cubic);
        }
    }

    #[test]
    fn a_snake_visits_every_point_by_single_steps() {
        let shape = Shape::new(vec![3, 4, 2, 3]);
        let order: Vec<usize> = shape.snake(vec![2, 0, 3, 1]).collect();
        let mut sorted = order.clone();
        sorted.sort_unstable();
        assert_eq!(sorted, (0..72).collect::<Vec<_>>());
        for pair in order.windows(2) {
            let steps: usize = (0..4).map(|axis| shape.place(pair[0], axis).abs_diff(shape.place(pair[1], axis))).sum();
            assert_eq!(steps, 1, "{pair:?}");
        }
    }
}
