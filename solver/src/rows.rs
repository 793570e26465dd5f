//! Rows of numbers of equal length, in one piece of memory.

/// By rows.
#[derive(Debug, Clone, Default, PartialEq)]
pub(crate) struct Rows {
    values: Vec<f64>,
    /// Values of a row.
    width: usize,
}

impl Rows {
    /// Of rows one after the other, `width` values each; of none where that is 0.
    pub(crate) fn new(values: Vec<f64>, width: usize) -> Self {
        Self { values, width }
    }

    /// How many rows.
    pub(crate) fn len(&self) -> usize {
        self.values.len().checked_div(self.width).unwrap_or(0)
    }

    /// One row; empty if there is no such row.
    pub(crate) fn row(&self, i: usize) -> &[f64] {
        self.values.get(i * self.width..).and_then(|rest| rest.get(..self.width)).unwrap_or(&[])
    }

    /// Row by row.
    pub(crate) fn iter(&self) -> impl Iterator<Item = &[f64]> {
        (0..self.len()).map(|i| self.row(i))
    }

    /// The sum of each row.
    pub(crate) fn sums(&self) -> impl Iterator<Item = f64> {
        self.iter().map(|row| row.iter().sum())
    }

    /// Each row by itself.
    pub(crate) fn to_vecs(&self) -> Vec<Vec<f64>> {
        self.iter().map(<[f64]>::to_vec).collect()
    }

    /// Keeps so many rows.
    pub(crate) fn truncate(&mut self, rows: usize) {
        self.values.truncate(rows * self.width);
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_stand_one_after_the_other() {
        let mut rows = Rows::new(vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0], 2);
        assert_eq!((rows.len(), rows.row(1), rows.row(3)), (3, &[3.0, 4.0][..], &[][..]));
        assert_eq!(rows.iter().map(|row| row[0]).collect::<Vec<_>>(), [1.0, 3.0, 5.0]);
        assert_eq!(rows.sums().collect::<Vec<_>>(), [3.0, 7.0, 11.0]);
        assert_eq!(rows.to_vecs(), [[1.0, 2.0], [3.0, 4.0], [5.0, 6.0]]);
        rows.truncate(1);
        assert_eq!((rows.len(), rows.row(1)), (1, &[][..]));
        let none = Rows::default();
        assert!(none.len() == 0 && none.row(0).is_empty() && none.iter().next().is_none());
    }
}
