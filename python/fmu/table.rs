//! The table of a unit, and what it says at a point.
//!
//! Little-endian: the mark `SHEAVEM1`, the GUID as text, the axes (name, start, breakpoints), the names of the
//! quantities, all derivatives node by node, quantity by quantity, order by order (bit k of an order for axis k; the
//! last axis running fastest), and a byte for each cell, by its lowest corner, that is 1 where the map has values. A
//! text is its length as four bytes and its UTF-8; numbers of things are four bytes.

/// One direction of the map.
pub struct Axis {
    pub name: String,
    pub start: f64,
    breakpoints: Vec<f64>,
}

/// A belt map.
pub struct Table {
    pub guid: String,
    pub axes: Vec<Axis>,
    pub quantities: Vec<String>,
    jets: Vec<f64>,
    usable: Vec<u8>,
}

/// Values of all quantities, and of each its derivatives by the coordinates.
pub type Found = (Vec<f64>, Vec<Vec<f64>>);

/// Rounding beyond an end of an axis that still counts as the end, as a share of the axis: as in the map itself.
const ROUNDING: f64 = 1e-12;

/// Outputs that follow from the quantities, where losses are not among these.
const DERIVED: usize = 3;
/// The quantity that has one more follow from it.
const LOSSES: &str = "losses.total";

impl Axis {
    pub fn range(&self) -> (f64, f64) {
        (self.breakpoints[0], self.breakpoints[self.breakpoints.len() - 1])
    }
}

/// What is left to be read.
struct Reader<'a>(&'a [u8]);

impl Reader<'_> {
    fn take<const N: usize>(&mut self) -> Option<[u8; N]> {
        let (head, rest) = self.0.split_first_chunk::<N>()?;
        self.0 = rest;
        Some(*head)
    }

    fn count(&mut self) -> Option<usize> {
        let count = usize::try_from(u32::from_le_bytes(self.take()?)).ok()?;
        // No more things than bytes.
        (count <= self.0.len()).then_some(count)
    }

    fn text(&mut self) -> Option<String> {
        let count = self.count()?;
        let (head, rest) = self.0.split_at_checked(count)?;
        self.0 = rest;
        String::from_utf8(head.to_vec()).ok()
    }

    fn number(&mut self) -> Option<f64> {
        Some(f64::from_le_bytes(self.take()?))
    }

    fn numbers(&mut self, count: usize) -> Option<Vec<f64>> {
        (count.checked_mul(8)? <= self.0.len()).then_some(())?;
        (0..count).map(|_| self.number()).collect()
    }
}

impl Table {
    /// From the bytes of its file; nothing if they are no table.
    pub fn read(bytes: &[u8]) -> Option<Self> {
        let mut reader = Reader(bytes.strip_prefix(b"SHEAVEM1")?);
        let guid = reader.text()?;
        let many = reader.count()?;
        let mut axes = Vec::new();
        for _ in 0..many {
            let (name, start) = (reader.text()?, reader.number()?);
            let count = reader.count()?;
            let breakpoints = reader.numbers(count)?;
            if breakpoints.len() < 2 || !breakpoints.windows(2).all(|pair| pair[0] < pair[1]) {
                return None;
            }
            axes.push(Axis { name, start, breakpoints });
        }
        let count = reader.count()?;
        let quantities = (0..count).map(|_| reader.text()).collect::<Option<Vec<_>>>()?;
        let points = axes.iter().try_fold(1_usize, |points, axis| points.checked_mul(axis.breakpoints.len()))?;
        let width = quantities.len().checked_mul(1_usize.checked_shl(u32::try_from(axes.len()).ok()?)?)?;
        let jets = reader.numbers(points.checked_mul(width)?)?;
        let usable = reader.0.to_vec();
        (usable.len() == points).then_some(Self { guid, axes, quantities, jets, usable })
    }

    /// The point of the map's range that is nearest to one outside, coordinate by coordinate.
    pub fn nearest(&self, at: &[f64]) -> Vec<f64> {
        let clamped = |(axis, value): (&Axis, &f64)| {
            let (from, to) = axis.range();
            value.clamp(from, to)
        };
        self.axes.iter().zip(at).map(clamped).collect()
    }

    /// All quantities at a point; nothing outside the map.
    pub fn at(&self, at: &[f64]) -> Option<Found> {
        let axes = self.axes.len();
        let mut strides = vec![1; axes];
        for axis in (1..axes).rev() {
            strides[axis - 1] = strides[axis] * self.axes[axis].breakpoints.len();
        }
        let mut corner = 0;
        // By axis, at both corners, the weights of value and derivative: of the interpolant, and of its derivative.
        let mut tables = Vec::with_capacity(axes);
        for (k, (axis, &value)) in self.axes.iter().zip(at).enumerate() {
            let (from, to) = axis.range();
            let slack = ROUNDING * (to - from);
            if !(from - slack..=to + slack).contains(&value) {
                return None;
            }
            let value = value.clamp(from, to);
            let above = axis.breakpoints.partition_point(|place| *place <= value);
            let interval = above.clamp(1, axis.breakpoints.len() - 1) - 1;
            let h = axis.breakpoints[interval + 1] - axis.breakpoints[interval];
            let t = (value - axis.breakpoints[interval]) / h;
            corner += interval * strides[k];
            tables.push((
                [
                    [(1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t), h * t * (1.0 - t) * (1.0 - t)],
                    [t * t * (3.0 - 2.0 * t), h * t * t * (t - 1.0)],
                ],
                [
                    [6.0 * t * (t - 1.0) / h, (1.0 - t) * (1.0 - 3.0 * t)],
                    [6.0 * t * (1.0 - t) / h, t * (3.0 * t - 2.0)],
                ],
            ));
        }
        if self.usable.get(corner) != Some(&1) {
            return None;
        }
        let many = 1_usize << axes;
        let width = self.quantities.len() * many;
        // Once as it is, and once differentiated along each axis.
        let weighted = |along: Option<usize>, quantity: usize| {
            let mut sum = 0.0;
            for bits in 0..many {
                let above = (0..axes).filter(|axis| bits >> axis & 1 == 1);
                let node = corner + above.map(|axis| strides[axis]).sum::<usize>();
                let jet = &self.jets[node * width + quantity * many..][..many];
                for (order, derivative) in jet.iter().enumerate() {
                    let weight: f64 = (0..axes)
                        .map(|axis| {
                            let (values, slopes) = &tables[axis];
                            let table = if along == Some(axis) { slopes } else { values };
                            table[bits >> axis & 1][order >> axis & 1]
                        })
                        .product();
                    sum += weight * derivative;
                }
            }
            sum
        };
        let values = (0..self.quantities.len()).map(|quantity| weighted(None, quantity)).collect();
        let slopes = (0..self.quantities.len())
            .map(|quantity| (0..axes).map(|axis| weighted(Some(axis), quantity)).collect())
            .collect();
        Some((values, slopes))
    }

    /// The quantities, and behind them the secondary's speed, the slip reserve and the overall efficiency, also with
    /// losses where the map has them, with the derivatives of all; what a map lacks a quantity for is not a number.
    pub fn derived(&self, (mut values, mut slopes): Found) -> Found {
        let axes = self.axes.len();
        let of = |name: &str| {
            let at = self.quantities.iter().position(|other| other == name);
            at.map_or((f64::NAN, vec![f64::NAN; axes]), |at| (values[at], slopes[at].clone()))
        };
        let product = |(a, da): &(f64, Vec<f64>), (b, db): &(f64, Vec<f64>)| {
            (a * b, da.iter().zip(db).map(|(da, db)| da * b + a * db).collect::<Vec<f64>>())
        };
        let inverse = |(a, da): &(f64, Vec<f64>)| (1.0 / a, da.iter().map(|da| -da / (a * a)).collect::<Vec<f64>>());
        let less = |(a, da): &(f64, Vec<f64>)| (1.0 - a, da.iter().map(|da| -da).collect::<Vec<f64>>());
        let rim = product(&of("primary.speed"), &of("primary.radius"));
        let speed = product(&product(&rim, &inverse(&of("secondary.radius"))), &less(&of("speed_loss")));
        let size = |(a, da): (f64, Vec<f64>)| if a < 0.0 { (-a, da.iter().map(|da| -da).collect()) } else { (a, da) };
        let (one, other) = (size(of("primary.friction_utilization")), size(of("secondary.friction_utilization")));
        let reserve = less(if one.0 >= other.0 { &one } else { &other });
        let input = product(&of("primary.speed"), &of("primary.torque"));
        let output = product(&speed, &of("secondary.torque"));
        // What arrives, less what is lost, over what drives.
        let share = |(lost, by): &(f64, Vec<f64>)| {
            let (arriving, driving, sign) = if input.0 > 0.0 && output.0 > 0.0 {
                (&output, &input, 1.0)
            } else if input.0 < 0.0 && output.0 < 0.0 {
                (&input, &output, -1.0)
            } else {
                return (f64::NAN, vec![f64::NAN; axes]);
            };
            let slopes = arriving.1.iter().zip(by).map(|(slope, by)| slope - sign * by).collect();
            product(&(arriving.0 - sign * lost, slopes), &inverse(driving))
        };
        let efficiency = share(&(0.0, vec![0.0; axes]));
        let mut derived = vec![speed, reserve, efficiency];
        if self.has_losses() {
            derived.push(share(&of(LOSSES)));
        }
        for (value, slope) in derived {
            values.push(value);
            slopes.push(slope);
        }
        (values, slopes)
    }

    /// Outputs in all: the quantities, and what follows from them.
    pub fn outputs(&self) -> usize {
        self.quantities.len() + DERIVED + usize::from(self.has_losses())
    }

    fn has_losses(&self) -> bool {
        self.quantities.iter().any(|quantity| quantity == LOSSES)
    }
}
