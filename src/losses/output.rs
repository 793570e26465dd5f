//! What losses besides friction add to the outputs of a solution.

/// An output of a solution with losses besides friction.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum LossOutput {
    /// Power of bending the belt, W.
    Bending,
    /// Power of squeezing it in the groove, W.
    Groove,
    /// Power of stretching its cord, W.
    Cord,
    /// Power of drag at both pulleys, W.
    Drag,
    /// Power that the gears behind the secondary take, W.
    Gears,
    /// All of these, W.
    Total,
    /// Overall efficiency with all of it.
    Efficiency,
}

impl LossOutput {
    /// All of them, in order.
    pub const ALL: [Self; 7] =
        [Self::Bending, Self::Groove, Self::Cord, Self::Drag, Self::Gears, Self::Total, Self::Efficiency];

    /// What hysteresis takes, part by part: these heat the belt.
    pub const HYSTERESIS: [Self; 3] = [Self::Bending, Self::Groove, Self::Cord];

    /// Its key in the result object, with a dot.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Bending => "losses.bending",
            Self::Groove => "losses.groove",
            Self::Cord => "losses.cord",
            Self::Drag => "losses.drag",
            Self::Gears => "losses.gears",
            Self::Total => "losses.total",
            Self::Efficiency => "efficiency.overall_with_losses",
        }
    }

    /// Its place among [`LossOutput::ALL`].
    const fn index(self) -> usize {
        self as usize
    }
}

/// One value for each output.
#[derive(Debug, Clone, PartialEq)]
pub struct LossValues<T>([T; LossOutput::ALL.len()]);

impl<T> LossValues<T> {
    /// The value that `of` says for each.
    pub fn new(of: impl FnMut(LossOutput) -> T) -> Self {
        Self(LossOutput::ALL.map(of))
    }
}

impl<T> std::ops::Index<LossOutput> for LossValues<T> {
    type Output = T;

    fn index(&self, output: LossOutput) -> &T {
        &self.0[output.index()]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_output_has_its_own_value() {
        let names = LossValues::new(LossOutput::name);
        for output in LossOutput::ALL {
            assert_eq!(names[output], output.name());
        }
    }
}
