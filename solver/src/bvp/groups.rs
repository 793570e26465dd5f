//! States whose derivatives are found together, because no value depends on two of them.

use crate::problem::LayoutError;

/// What each value of f depends on, and the states in groups of which each value depends on one at most: one evaluation
/// gives the derivatives by all states of a group (A. R. Curtis, M. J. D. Powell and J. K. Reid, J. Inst. Maths.
/// Applics. 13 (1974) 117-119: the states are coloured, and those of one colour are a group).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Groups {
    /// Of each state.
    of: Vec<usize>,
    /// Value and state of the derivatives, by groups.
    entries: Vec<Vec<(usize, usize)>>,
}

impl Groups {
    /// Of so many states, `rows` the states that each of so many values depends on.
    pub(super) fn new(states: usize, values: usize, rows: &[&[usize]]) -> Result<Self, LayoutError> {
        if rows.len() != values {
            return Err(LayoutError::Dependences { given: rows.len(), expected: values });
        }
        let mut values_of = vec![Vec::new(); states];
        for (row, &column) in rows.iter().enumerate().flat_map(|(row, on)| on.iter().map(move |state| (row, state))) {
            let outside = || LayoutError::RegionPattern { region: super::REGION.to_owned(), row, column };
            values_of.get_mut(column).ok_or_else(outside)?.push(row);
        }
        // Each state into the first group of whose states none of its values depends on another.
        let (mut of, mut entries, mut taken) = (Vec::new(), Vec::new(), Vec::<Vec<bool>>::new());
        for (state, rows) in values_of.iter().enumerate() {
            let free = |taken: &Vec<bool>| rows.iter().all(|&row| !taken[row]);
            let group = taken.iter().position(free).unwrap_or(taken.len());
            if group == taken.len() {
                taken.push(vec![false; values]);
                entries.push(Vec::new());
            }
            rows.iter().for_each(|&row| taken[group][row] = true);
            entries[group].extend(rows.iter().map(|&row| (row, state)));
            of.push(group);
        }
        Ok(Self { of, entries })
    }

    /// How many there are.
    pub(super) fn count(&self) -> usize {
        self.entries.len()
    }

    /// The group of each state.
    pub(super) fn of(&self) -> &[usize] {
        &self.of
    }

    /// Value and state of the derivatives by all states of a group; none of a group that there is not.
    pub(super) fn entries(&self, group: usize) -> &[(usize, usize)] {
        self.entries.get(group).map_or(&[], Vec::as_slice)
    }
}
