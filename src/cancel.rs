//! Ending a computation from outside.
//!
//! ```
//! use sheave::{Cancel, cancellable, case::Case};
//! let cancel = Cancel::new();
//! // In another thread, or in a handler of signals: `cancel.clone().cancel()`.
//! cancel.cancel();
//! assert!(cancellable(&cancel, || sheave::solve(&Case::base())).is_err());
//! ```

use solver::Cancel;
use std::cell::RefCell;

thread_local! {
    /// The handle that holds on this thread: a value beside the options, which are plain data and compared as such.
    static HANDLE: RefCell<Option<Cancel>> = const { RefCell::new(None) };
}

/// Does `work`, which ends with a failure at its next step once `cancel` is cancelled: every solution that it looks
/// for, on the threads that it starts, too. A study keeps the rows that it has by then and gives the others a reason;
/// who wants none of them refuses the rows (see [`study::run`](crate::study::run)).
pub fn cancellable<T>(cancel: &Cancel, work: impl FnOnce() -> T) -> T {
    /// Puts back what held before, even where `work` panics.
    struct Restored(Option<Cancel>);
    impl Drop for Restored {
        fn drop(&mut self) {
            set(self.0.take());
        }
    }
    let before = Restored(current());
    set(Some(cancel.clone()));
    let done = work();
    drop(before);
    done
}

/// The handle that holds on this thread.
pub(crate) fn current() -> Option<Cancel> {
    HANDLE.with_borrow(Clone::clone)
}

/// Whether the work of this thread is cancelled.
pub(crate) fn is_cancelled() -> bool {
    // Of a clone: what a handle asks may itself do cancellable work.
    current().is_some_and(|handle| handle.is_cancelled())
}

/// Has a handle hold on this thread.
pub(crate) fn set(cancel: Option<Cancel>) {
    HANDLE.with_borrow_mut(|handle| *handle = cancel);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_handle_holds_while_the_work_lasts() {
        let (outer, inner) = (Cancel::new(), Cancel::new());
        assert_eq!(current(), None);
        cancellable(&outer, || {
            cancellable(&inner, || assert_eq!(current().as_ref(), Some(&inner)));
            assert_eq!(current().as_ref(), Some(&outer));
        });
        assert_eq!(current(), None);
        let nested = Cancel::asking(|| cancellable(&Cancel::new(), || false));
        cancellable(&nested, || assert!(!is_cancelled()));
        let panicked = std::panic::catch_unwind(|| cancellable(&Cancel::new(), || panic!("on purpose")));
        assert!(panicked.is_err() && current().is_none());
    }
}
