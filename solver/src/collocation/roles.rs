//! Which states are unknowns of coupled equations inside an interval, and which follow from others.

/// What each state of a region is.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub(crate) struct Roles {
    /// States that are unknowns, in order.
    pub unknowns: Vec<usize>,
    /// States that are integrals of an unknown, with that: their equations say what they are.
    pub integrals: Vec<(usize, usize)>,
    /// One a state.
    pub of: Vec<Role>,
}

/// What one state is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Role {
    /// An unknown, and the how-manieth.
    Unknown(usize),
    /// The integral of an unknown, the how-manieth.
    IntegralOf(usize),
}

/// States in pairs.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pairs<const Q: usize> {
    /// The unknowns, in order.
    pub unknowns: [usize; Q],
    /// The integral of each.
    pub integrals: [usize; Q],
}

impl Roles {
    /// The states as `Q` pairs, if they are nothing else.
    pub(crate) fn pairs<const Q: usize>(&self) -> Option<Pairs<Q>> {
        let unknowns: [usize; Q] = self.unknowns.as_slice().try_into().ok()?;
        let mut integrals = [0; Q];
        for (integral, unknown) in integrals.iter_mut().zip(unknowns) {
            *integral = self.integrals.iter().find(|(_, of)| *of == unknown)?.0;
        }
        Some(Pairs { unknowns, integrals })
    }

    /// Of `n` states, where the first of each pair has the second for derivative. Of a chain of them every other one is
    /// an integral.
    pub(crate) fn new(n: usize, second_order: &[(usize, usize)]) -> Self {
        let mut integrals: Vec<(usize, usize)> = Vec::new();
        for &(u, v) in second_order {
            let apart = |&(other, of): &(usize, usize)| of != u && other != v && other != u;
            if integrals.iter().all(apart) {
                integrals.push((u, v));
            }
        }
        let unknowns: Vec<usize> = (0..n).filter(|state| integrals.iter().all(|(u, _)| u != state)).collect();
        let mut of = vec![Role::Unknown(0); n];
        unknowns.iter().enumerate().for_each(|(index, &state)| of[state] = Role::Unknown(index));
        for &(u, v) in &integrals {
            if let Role::Unknown(index) = of[v] {
                of[u] = Role::IntegralOf(index);
            }
        }
        Self { unknowns, integrals, of }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_integral_is_that_of_an_unknown() {
        let roles = Roles::new(4, &[(0, 1), (2, 3)]);
        assert_eq!((roles.unknowns, roles.integrals), (vec![1, 3], vec![(0, 1), (2, 3)]));
        assert_eq!(roles.of, [Role::IntegralOf(0), Role::Unknown(0), Role::IntegralOf(1), Role::Unknown(1)]);
        // An equation of third order, y, v, w: whatever the order in which they are found.
        assert_eq!(Roles::new(3, &[(0, 1), (1, 2)]).unknowns, [1, 2]);
        assert_eq!(Roles::new(3, &[(1, 2), (0, 1)]).unknowns, [0, 2]);
        assert_eq!(Roles::new(2, &[]).of, [Role::Unknown(0), Role::Unknown(1)]);
        assert!(Roles::new(2, &[]).pairs::<1>().is_none() && Roles::new(2, &[]).pairs::<2>().is_none());
        let crossed = Roles::new(4, &[(0, 3), (2, 1)]).pairs::<2>().unwrap();
        assert_eq!((crossed.unknowns, crossed.integrals), ([1, 3], [2, 0]));
        assert!(Roles::new(3, &[(0, 1)]).pairs::<2>().is_none() && Roles::new(3, &[(0, 1)]).pairs::<1>().is_none());
        // u' = v, v' = u.
        assert_eq!(Roles::new(2, &[(0, 1), (1, 0)]).unknowns, [1]);
    }
}
