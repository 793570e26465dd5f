//! Arrays whose memory is used again: what one gives back the next one takes. A solve asks for hundreds of them, and
//! most are larger than what allocators keep at hand.
//!
//! Each thread has a shelf of blocks, by powers of 2 of their size. A block that lies there holds in its first bytes
//! where the next one of its size lies, so that to take and to give back is to read and write one address each.

use super::scalar::{Lane, Scalar};
use std::alloc::{Layout, alloc_zeroed, dealloc, handle_alloc_error};
use std::cell::Cell;
use std::fmt;
use std::marker::PhantomData;
use std::ops::{Deref, DerefMut};
use std::ptr::NonNull;

/// Bytes of the smallest blocks, and what all are aligned to: a line of a cache.
const LINE: usize = 64;

/// What lies where a block begins.
#[repr(align(64))]
struct Line;

/// Sizes of which blocks are kept; longer ones are not.
const CLASSES: usize = 14;
/// Bytes that a thread keeps at most.
const MOST: usize = 1 << 23;

/// What arrays are of.
///
/// # Safety
/// Any bits must be a value, and none be aligned to more than a line.
pub(crate) unsafe trait Kept: Scalar + 'static {}

// SAFETY: numbers are.
unsafe impl Kept for f64 {}
// SAFETY: some numbers are.
unsafe impl Kept for Lane {}

/// Blocks of memory that have been given back, all bytes of which have been set once.
struct Shelf {
    /// Of each size the first block.
    first: [Cell<Option<NonNull<Next>>>; CLASSES],
    /// Bytes of all of them.
    held: Cell<usize>,
}

/// What the first bytes of a block on the shelf are: where the next one of its size is.
struct Next(Option<NonNull<Next>>);

thread_local! {
    static SHELF: Shelf = const { Shelf { first: [const { Cell::new(None) }; CLASSES], held: Cell::new(0) } };
}

/// A block of memory, its bytes all set.
struct Block {
    at: NonNull<Line>,
    /// Bytes: a multiple of [`LINE`], a power of 2 where it is kept; or 0, and there is no memory.
    size: usize,
}

impl Block {
    const NONE: Self = Self { at: NonNull::dangling(), size: 0 };

    /// Of at least so many bytes, at least one.
    #[inline]
    fn of(bytes: usize) -> Self {
        let class = class_of(bytes);
        let taken = SHELF.try_with(|shelf| {
            let first = shelf.first.get(class)?;
            let block = first.get()?;
            // SAFETY: what lies on the shelf is a block that nothing else refers to, and begins with a `Next`.
            first.set(unsafe { block.read() }.0);
            shelf.held.set(shelf.held.get() - (LINE << class));
            Some(block.cast())
        });
        match taken {
            Ok(Some(at)) => Self { at, size: LINE << class },
            // At the end of a thread there is no shelf any more.
            Ok(None) | Err(_) => Self::new(if class < CLASSES { LINE << class } else { bytes }),
        }
    }

    #[cold]
    fn new(bytes: usize) -> Self {
        let layout = Layout::from_size_align(bytes, LINE).map(|layout| layout.pad_to_align());
        let Ok(layout) = layout else { handle_alloc_error(Layout::new::<Self>()) };
        // SAFETY: the size is not 0.
        match NonNull::new(unsafe { alloc_zeroed(layout) }) {
            Some(at) => Self { at: at.cast(), size: layout.size() },
            None => handle_alloc_error(layout),
        }
    }

    #[inline(never)]
    fn give_back(self) {
        let class = class_of(self.size);
        let kept = SHELF.try_with(|shelf| {
            let held = shelf.held.get() + self.size;
            let Some(first) = shelf.first.get(class).filter(|_| held <= MOST) else { return false };
            let next = self.at.cast::<Next>();
            // SAFETY: the block is of a line at least, aligned to one, and this value alone refers to it.
            unsafe { next.write(Next(first.get())) };
            first.set(Some(next));
            shelf.held.set(held);
            true
        });
        if !kept.unwrap_or(false) {
            // SAFETY: this value alone refers to the block.
            unsafe { free(self.at, self.size) };
        }
    }
}

/// Which size on the shelf has room for so many bytes, at least one.
#[inline]
fn class_of(bytes: usize) -> usize {
    ((bytes - 1) / LINE).checked_ilog2().map_or(0, |log| log as usize + 1)
}

/// # Safety
/// The block must be one that [`Block::new`] has made, of this size, to which nothing refers.
unsafe fn free(at: NonNull<Line>, size: usize) {
    if let Ok(layout) = Layout::from_size_align(size, LINE) {
        // SAFETY: the layout is the one that it was made with; the rest is the caller's to see to.
        unsafe { dealloc(at.as_ptr().cast(), layout) };
    }
}

impl Drop for Shelf {
    fn drop(&mut self) {
        for (class, first) in self.first.iter().enumerate() {
            while let Some(block) = first.get() {
                // SAFETY: as in `Block::of`; each block is freed once, for the next one takes its place.
                unsafe {
                    first.set(block.read().0);
                    free(block.cast(), LINE << class);
                }
            }
        }
    }
}

/// An array of fixed length.
pub(crate) struct Array<T: Kept> {
    block: Block,
    len: usize,
    values: PhantomData<Vec<T>>,
}

pub(crate) type Numbers = Array<f64>;
pub(crate) type Lanes = Array<Lane>;

// SAFETY: an array is the only one that refers to its block, as a vector would be.
unsafe impl<T: Kept + Send> Send for Array<T> {}
// SAFETY: a shared array lets values be read only.
unsafe impl<T: Kept + Sync> Sync for Array<T> {}

impl<T: Kept> Array<T> {
    /// Of `len` values, whatever they are.
    #[inline]
    fn room(len: usize) -> Self {
        let block = if len == 0 { Block::NONE } else { Block::of(len.saturating_mul(size_of::<T>())) };
        Self { block, len, values: PhantomData }
    }

    pub(crate) fn zeros(len: usize) -> Self {
        let mut array = Self::room(len);
        array.fill(T::ZERO);
        array
    }

    /// For what is written before it is read: the values may be any. With debug assertions they are NaN, so that tests
    /// see what is read too early.
    #[inline]
    pub(crate) fn unset(len: usize) -> Self {
        let mut array = Self::room(len);
        if cfg!(debug_assertions) {
            array.fill(T::ONE.times(f64::NAN));
        }
        array
    }

    #[inline]
    pub(crate) fn of(values: &[T]) -> Self {
        let mut array = Self::room(values.len());
        array.copy_from_slice(values);
        array
    }

    /// These values, so many of them or a few more.
    #[inline]
    pub(crate) fn collected(len: usize, values: impl Iterator<Item = T>) -> Self {
        let mut all = Self::room(len);
        let mut count = 0;
        for value in values {
            if count == all.len {
                let mut longer = Self::room((2 * count).max(1));
                longer[..count].copy_from_slice(&all);
                all = longer;
            }
            all[count] = value;
            count += 1;
        }
        all.len = count;
        all
    }
}

impl<T: Kept> Drop for Array<T> {
    #[inline]
    fn drop(&mut self) {
        if self.block.size > 0 {
            std::mem::replace(&mut self.block, Block::NONE).give_back();
        }
    }
}

impl<T: Kept> Default for Array<T> {
    #[inline]
    fn default() -> Self {
        Self::room(0)
    }
}

impl<T: Kept> Clone for Array<T> {
    fn clone(&self) -> Self {
        Self::of(self)
    }
}

impl<T: Kept> From<Vec<T>> for Array<T> {
    fn from(values: Vec<T>) -> Self {
        Self::of(&values)
    }
}

impl<T: Kept> Deref for Array<T> {
    type Target = [T];

    #[inline]
    fn deref(&self) -> &[T] {
        // SAFETY: the block has room for so many values, aligned to more than they are; its bytes are set, and any are
        // a value. No block is needed for none.
        unsafe { std::slice::from_raw_parts(self.block.at.cast().as_ptr(), self.len) }
    }
}

impl<T: Kept> DerefMut for Array<T> {
    #[inline]
    fn deref_mut(&mut self) -> &mut [T] {
        // SAFETY: as in `deref`; and this array alone refers to the block.
        unsafe { std::slice::from_raw_parts_mut(self.block.at.cast().as_ptr(), self.len) }
    }
}

impl<'a, T: Kept> IntoIterator for &'a Array<T> {
    type Item = &'a T;
    type IntoIter = std::slice::Iter<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter()
    }
}

impl<'a, T: Kept> IntoIterator for &'a mut Array<T> {
    type Item = &'a mut T;
    type IntoIter = std::slice::IterMut<'a, T>;

    fn into_iter(self) -> Self::IntoIter {
        self.iter_mut()
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
        (**self).fmt(f)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn held() -> usize {
        SHELF.with(|shelf| shelf.held.get())
    }

    #[test]
    fn memory_is_used_again_and_holds_what_is_asked_for() {
        for len in [1, 2, 3, 8, 9, 100, 5000, 65536, 65537, 200_000] {
            let mut array = Numbers::zeros(len);
            array.fill(7.0);
            let before = held();
            let (at, kept) = (array.as_ptr(), len <= 65536);
            assert_eq!(at.addr() % LINE, 0);
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
    fn sizes_have_room_for_what_is_asked_for_and_not_twice_that() {
        for bytes in (1..3000).chain([4096, 4097, LINE << (CLASSES - 1), (LINE << (CLASSES - 1)) + 1]) {
            let size = LINE << class_of(bytes);
            assert!(size >= bytes && (size == LINE || size / 2 < bytes), "{bytes}: {size}");
            assert_eq!(class_of(bytes) < CLASSES, bytes <= LINE << (CLASSES - 1));
        }
    }

    #[test]
    fn arrays_at_the_same_time_share_nothing() {
        let all: Vec<Numbers> = (0..200).map(|i| Numbers::collected(1 + i, (0..i).map(|_| i as f64))).collect();
        for (i, array) in all.iter().enumerate() {
            assert!(array.len() == i && array.iter().all(|&x| x == i as f64));
        }
        let copies = all.clone();
        drop(all);
        let others: Vec<Lanes> = (0..200).map(Lanes::zeros).collect();
        for (i, array) in copies.iter().enumerate() {
            assert!(array.len() == i && array.iter().all(|&x| x == i as f64));
        }
        drop(others);
    }

    #[test]
    fn more_values_than_said_are_collected_all_the_same() {
        for (said, count) in [(0, 0), (0, 1), (3, 2), (3, 100), (8, 9)] {
            let values = Numbers::collected(said, (0..count).map(f64::from));
            assert!(values.iter().copied().eq((0..count).map(f64::from)));
        }
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
        assert!(held() <= MOST && held() > MOST / 2, "{}", held());
        let other = std::thread::spawn(|| {
            let array = Numbers::zeros(10);
            drop(Numbers::zeros(20));
            array
        });
        // What another thread has made is given back here, and what it has kept goes with it.
        let before = held();
        drop(other.join().unwrap());
        assert!(held() >= before);
    }
}
