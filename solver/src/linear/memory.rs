//! Arrays whose memory is used again: what one gives back the next one takes. A solve asks for hundreds of them, and
//! most are larger than what allocators keep at hand.

use super::scalar::{Lane, Scalar};
use std::cell::RefCell;
use std::fmt;
use std::ops::{Deref, DerefMut};
use std::thread::LocalKey;

/// Memory that has been given back, by powers of 2 of its length.
pub(crate) struct Shelf<T> {
    classes: [Vec<Vec<T>>; CLASSES],
    /// Values that all of it has room for.
    held: usize,
}

/// Longer arrays are not kept.
const CLASSES: usize = 15;
/// Bytes that a thread keeps at most, of each kind.
const MOST: usize = 1 << 22;

impl<T> Shelf<T> {
    pub(crate) const fn new() -> Self {
        Self { classes: [const { Vec::new() }; CLASSES], held: 0 }
    }

    /// With room for at least `len` values, and whatever values it was given back with.
    fn take(&mut self, len: usize) -> Vec<T> {
        let class = len.next_power_of_two().trailing_zeros() as usize;
        match self.classes.get_mut(class).and_then(Vec::pop) {
            Some(values) => {
                self.held -= values.capacity();
                values
            }
            None if class < CLASSES => Vec::with_capacity(1 << class),
            None => Vec::with_capacity(len),
        }
    }

    fn give(&mut self, values: Vec<T>) {
        let capacity = values.capacity();
        if (self.held + capacity) * size_of::<T>() <= MOST
            && let Some(class) = self.classes.get_mut(capacity.ilog2() as usize)
        {
            self.held += capacity;
            class.push(values);
        }
    }
}

thread_local! {
    static NUMBERS: RefCell<Shelf<f64>> = const { RefCell::new(Shelf::new()) };
    static LANES: RefCell<Shelf<Lane>> = const { RefCell::new(Shelf::new()) };
}

/// What arrays are of.
pub(crate) trait Kept: Scalar + 'static {
    fn shelf() -> &'static LocalKey<RefCell<Shelf<Self>>>;
}

impl Kept for f64 {
    fn shelf() -> &'static LocalKey<RefCell<Shelf<Self>>> {
        &NUMBERS
    }
}

impl Kept for Lane {
    fn shelf() -> &'static LocalKey<RefCell<Shelf<Self>>> {
        &LANES
    }
}

/// An array of fixed length.
pub(crate) struct Array<T: Kept>(Vec<T>);

pub(crate) type Numbers = Array<f64>;
pub(crate) type Lanes = Array<Lane>;

impl<T: Kept> Array<T> {
    /// With room for `len` values, and whatever values.
    fn room(len: usize) -> Vec<T> {
        if len == 0 {
            return Vec::new();
        }
        // At the end of a thread there may be no shelf any more.
        let kept = T::shelf().try_with(|shelf| shelf.try_borrow_mut().ok().map(|mut shelf| shelf.take(len)));
        kept.ok().flatten().unwrap_or_else(|| Vec::with_capacity(len))
    }

    pub(crate) fn zeros(len: usize) -> Self {
        let mut values = Self::room(len);
        values.clear();
        values.resize(len, T::ZERO);
        Self(values)
    }

    /// For what is written before it is read: the values may be any. With debug assertions they are NaN, so that tests
    /// see what is read too early.
    pub(crate) fn unset(len: usize) -> Self {
        let mut values = Self::room(len);
        if cfg!(debug_assertions) {
            values.clear();
        }
        values.resize(len, T::ONE.times(f64::NAN));
        Self(values)
    }

    pub(crate) fn of(values: &[T]) -> Self {
        let mut copied = Self::room(values.len());
        copied.clear();
        copied.extend_from_slice(values);
        Self(copied)
    }

    /// These values, so many of them or a few more.
    pub(crate) fn collected(len: usize, values: impl Iterator<Item = T>) -> Self {
        let mut all = Self::room(len);
        all.clear();
        all.extend(values);
        Self(all)
    }
}

impl<T: Kept> Drop for Array<T> {
    #[inline]
    fn drop(&mut self) {
        if self.0.capacity() > 0 {
            give_back(std::mem::take(&mut self.0));
        }
    }
}

#[inline(never)]
fn give_back<T: Kept>(values: Vec<T>) {
    let _ = T::shelf().try_with(|shelf| {
        if let Ok(mut shelf) = shelf.try_borrow_mut() {
            shelf.give(values);
        }
    });
}

impl<T: Kept> Default for Array<T> {
    fn default() -> Self {
        Self(Vec::new())
    }
}

impl<T: Kept> Clone for Array<T> {
    fn clone(&self) -> Self {
        Self::of(&self.0)
    }
}

impl<T: Kept> From<Vec<T>> for Array<T> {
    fn from(values: Vec<T>) -> Self {
        Self(values)
    }
}

impl<T: Kept> Deref for Array<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        &self.0
    }
}

impl<T: Kept> DerefMut for Array<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        &mut self.0
    }
}

impl<'a, T: Kept> IntoIterator for &'a Array<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter()
    }
}

impl<'a, T: Kept> IntoIterator for &'a mut Array<T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.0.iter_mut()
    }
}

impl<T: Kept> FromIterator<T> for Array<T> {
    fn from_iter<I: IntoIterator<Item = T>>(values: I) -> Self {
        let values = values.into_iter();
        Self::collected(values.size_hint().0, values)
    }
}

impl<T: Kept + fmt::Debug> fmt::Debug for Array<T> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.0.fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn memory_is_used_again_and_holds_what_is_asked_for() {
        let held = || NUMBERS.with(|shelf| shelf.borrow().held);
        for len in [1, 2, 3, 8, 100, 5000, 100_000] {
            let before = held();
            let mut array = Numbers::zeros(len);
            array.fill(7.0);
            let (at, kept) = (array.as_ptr(), len < 1 << CLASSES);
            drop(array);
            assert_eq!(held() > before, kept, "{len}");
            let again = Numbers::zeros(len);
            assert!(again.len() == len && again.iter().all(|&x| x == 0.0));
            // Where an array that is not kept comes to lie is the allocator's to say: it may be the same place.
            assert!(again.as_ptr() == at || !kept, "{len}");
            assert_eq!(held(), before, "{len}");
            assert_eq!(&*again.clone(), &*again);
        }
        assert!(Numbers::default().is_empty());
    }

    #[test]
    fn what_is_not_set_has_its_length_and_shows_when_it_is_read() {
        drop(Numbers::of(&[1.0; 100]));
        for len in [0, 7, 100, 120] {
            let values = Numbers::unset(len);
            assert_eq!(values.len(), len);
            assert!(!cfg!(debug_assertions) || values.iter().all(|x| x.is_nan()));
        }
    }

    #[test]
    fn a_thread_keeps_no_more_than_it_may() {
        let all: Vec<Lanes> = (0..100).map(|_| Lanes::zeros(4096)).collect();
        drop(all);
        LANES.with(|shelf| {
            let shelf = shelf.borrow();
            let held: usize = shelf.classes.iter().flatten().map(Vec::capacity).sum();
            assert_eq!(held, shelf.held);
            assert!(held * size_of::<Lane>() <= MOST);
        });
    }
}
