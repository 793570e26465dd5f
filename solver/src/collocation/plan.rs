//! What a choice of unknown constants makes of a layout: which derivatives are needed, and where they go.

use crate::linear::chain::Sizes;
use crate::problem::{Layout, Scope};

/// One region's share.
#[derive(Debug, Clone)]
pub(crate) struct RegionPlan {
    /// States.
    pub n: usize,
    /// States and all integrals.
    pub rows: usize,
    /// Integrals whose derivatives are needed.
    pub active: Vec<usize>,
    /// Unknowns (indices into [`Plan::unknowns`]) on which the region depends, one a column.
    pub columns: Vec<usize>,
    /// `(entry, row, state)`, row by row: rows `0..n` are states, rows from `n` active integrals.
    pub state_entries: Vec<(usize, usize, usize)>,
    /// `(entry, row, column)`.
    pub constant_entries: Vec<(usize, usize, usize)>,
    /// Entries of the state pattern.
    pub state_nonzeros: usize,
    /// Entries of the constant pattern.
    pub constant_nonzeros: usize,
    /// What to ask of the problem.
    pub scope: Scope,
    /// Where this region's states begin among the ends.
    pub first_end: usize,
    /// Where this region's integrals begin.
    pub first_integral: usize,
}

impl RegionPlan {
    pub(crate) fn sizes(&self) -> Sizes {
        Sizes { n: self.n, p: self.columns.len(), k: self.active.len() }
    }
}

/// The plan of a problem with chosen unknowns.
#[derive(Debug, Clone)]
pub(crate) struct Plan {
    pub regions: Vec<RegionPlan>,
    /// Indices into the layout's constants.
    pub unknowns: Vec<usize>,
    /// Whether the last integral of each region is what the method's quadrature says, by definition: it has no error.
    pub by_quadrature: bool,
}

impl Plan {
    /// As [`new`](Self::new), with [`by_quadrature`](Self::by_quadrature).
    pub(crate) fn defining(layout: &Layout, unknowns: &[usize]) -> Self {
        Self { by_quadrature: true, ..Self::new(layout, unknowns) }
    }

    /// What Newton's iteration needs. `unknowns` must be distinct indices of constants.
    pub(crate) fn new(layout: &Layout, unknowns: &[usize]) -> Self {
        let ends = layout.ends();
        let mut used = vec![false; layout.integrals()];
        for &(_, input) in &layout.boundary_pattern {
            if let Some(flag) = input.checked_sub(ends).and_then(|index| used.get_mut(index)) {
                *flag = true;
            }
        }
        Self::with(layout, unknowns, &used)
    }

    /// With all constants for unknowns and all integrals.
    pub(crate) fn complete(layout: &Layout) -> Self {
        let constants: Vec<usize> = (0..layout.constants.len()).collect();
        Self::with(layout, &constants, &vec![true; layout.integrals()])
    }

    fn with(layout: &Layout, unknowns: &[usize], used: &[bool]) -> Self {
        let (mut first_end, mut first_integral) = (0, 0);
        let mut regions = Vec::new();
        for region in &layout.regions {
            let (n, k) = (region.states.len(), region.integrals.len());
            let active: Vec<usize> = (0..k).filter(|&i| used[first_integral + i]).collect();
            let row_of = |row: usize| {
                if row < n { Some(row) } else { active.iter().position(|&i| i == row - n).map(|at| n + at) }
            };
            let depends = |constant: usize| {
                region.constant_pattern.iter().any(|&(row, c)| c == constant && row_of(row).is_some())
            };
            let columns: Vec<usize> = (0..unknowns.len()).filter(|&u| depends(unknowns[u])).collect();
            let entries = |pattern: &[(usize, usize)], column_of: &dyn Fn(usize) -> Option<usize>| {
                let placed = pattern.iter().enumerate();
                placed.filter_map(|(e, &(row, column))| Some((e, row_of(row)?, column_of(column)?))).collect()
            };
            let mut state_entries: Vec<(usize, usize, usize)> = entries(&region.state_pattern, &Some);
            // Stable: what is summed up in a row is so in the pattern's order.
            state_entries.sort_by_key(|&(_, row, _)| row);
            let constant_entries: Vec<(usize, usize, usize)> =
                entries(&region.constant_pattern, &|c| columns.iter().position(|&u| unknowns[u] == c));
            let default = constant_entries.iter().all(|&(entry, ..)| entry < region.default_entries);
            let scope = if default { Scope::DefaultUnknowns } else { Scope::All };
            regions.push(RegionPlan {
                n,
                rows: n + k,
                active,
                columns,
                state_entries,
                constant_entries,
                state_nonzeros: region.state_pattern.len(),
                constant_nonzeros: region.constant_pattern.len(),
                scope,
                first_end,
                first_integral,
            });
            first_end += 2 * n;
            first_integral += k;
        }
        Self { regions, unknowns: unknowns.to_vec(), by_quadrature: false }
    }

    /// Σ n_r.
    pub(crate) fn states(&self) -> usize {
        self.regions.iter().map(|region| region.n).sum()
    }
}
