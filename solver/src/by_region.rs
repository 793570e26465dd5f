//! One value for each region.

use std::ops::{Deref, DerefMut};

/// One value for each region, in their order. Most problems have one region, whose value needs no memory of its own
/// then. Where there are no regions, or nothing is to be said of them, it is empty.
#[derive(Debug, Clone)]
pub(crate) enum ByRegion<T> {
    One([T; 1]),
    Any(Vec<T>),
}

impl<T> ByRegion<T> {
    /// The value of one more region.
    pub(crate) fn push(&mut self, value: T) {
        *self = match std::mem::take(self) {
            Self::Any(values) if values.is_empty() => Self::One([value]),
            Self::Any(mut values) => {
                values.push(value);
                Self::Any(values)
            }
            Self::One([first]) => Self::Any(vec![first, value]),
        };
    }
}

impl<T> Default for ByRegion<T> {
    fn default() -> Self {
        Self::Any(Vec::new())
    }
}

impl<T> FromIterator<T> for ByRegion<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let mut values = values.into_iter();
        match (values.next(), values.next()) {
            (Some(first), None) => Self::One([first]),
            (first, second) => Self::Any(first.into_iter().chain(second).chain(values).collect()),
        }
    }
}

impl<T> Deref for ByRegion<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        match self {
            Self::One(values) => values,
            Self::Any(values) => values,
        }
    }
}

impl<T> DerefMut for ByRegion<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        match self {
            Self::One(values) => values,
            Self::Any(values) => values,
        }
    }
}

impl<'a, T> IntoIterator for &'a ByRegion<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, T> IntoIterator for &'a mut ByRegion<T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn as_many_values_as_regions() {
        let mut pushed = ByRegion::default();
        for count in 0..4 {
            let collected: ByRegion<usize> = (0..count).collect();
            assert_eq!(&collected[..], (0..count).collect::<Vec<_>>());
            assert_eq!(&collected[..], &pushed[..]);
            assert_eq!(matches!(collected, ByRegion::One(_)), count == 1);
            pushed.push(count);
        }
        (&mut pushed).into_iter().for_each(|value| *value += 1);
        assert_eq!(pushed.iter().sum::<usize>(), 10);
    }
}
