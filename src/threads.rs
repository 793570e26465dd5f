//! Jobs on several threads with the feature `parallel`, one after the other without it.

#[cfg(feature = "parallel")]
mod pool {
    use rayon::prelude::*;

    pub(crate) use rayon::ScopeFifo as Scope;

    /// A pool of so many threads (all cores if 0) cannot be had.
    #[derive(Debug)]
    pub(crate) struct NoThreads;

    /// A pool whose threads end their work when the calling thread's is cancelled.
    fn pool(threads: usize) -> Result<rayon::ThreadPool, NoThreads> {
        let cancel = crate::cancel::current();
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.start_handler(move |_| crate::cancel::set(cancel.clone())).build().map_err(|_| NoThreads)
    }

    /// Runs what `begin` spawns, and what that spawns, first come, first served, on so many threads (0: all cores).
    pub(crate) fn scope<'s>(threads: usize, begin: impl FnOnce(&Scope<'s>) + Send) -> Result<(), NoThreads> {
        pool(threads)?.scope_fifo(begin);
        Ok(())
    }

    /// What `item` gives for each number below `count`, in order, on so many threads (0: all cores).
    pub(crate) fn map<T: Send>(
        threads: usize,
        count: usize,
        item: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, NoThreads> {
        Ok(pool(threads)?.install(|| (0..count).into_par_iter().map(item).collect()))
    }

    /// What `of` makes of each item, in order, on all cores; on the calling thread if no others can be had.
    pub(crate) fn collect<I: Sync, T: Send>(items: &[I], of: impl Fn(&I) -> T + Sync + Send) -> Vec<T> {
        match pool(0) {
            Ok(pool) => pool.install(|| items.par_iter().map(of).collect()),
            Err(NoThreads) => items.iter().map(of).collect(),
        }
    }
}

#[cfg(not(feature = "parallel"))]
mod pool {
    use std::cell::RefCell;
    use std::collections::VecDeque;

    type Job<'s> = Box<dyn FnOnce(&Scope<'s>) + 's>;

    /// Jobs that wait, in the order in which they were spawned.
    pub(crate) struct Scope<'s>(RefCell<VecDeque<Job<'s>>>);

    impl<'s> Scope<'s> {
        /// Leaves a job for later.
        pub(crate) fn spawn_fifo(&self, job: impl FnOnce(&Scope<'s>) + Send + 's) {
            self.0.borrow_mut().push_back(Box::new(job));
        }
    }

    /// Never: there is always the one thread.
    #[derive(Debug)]
    pub(crate) struct NoThreads;

    /// Runs what `begin` spawns, and what that spawns, one job after the other.
    pub(crate) fn scope<'s>(_threads: usize, begin: impl FnOnce(&Scope<'s>) + Send) -> Result<(), NoThreads> {
        let scope = Scope(RefCell::default());
        begin(&scope);
        loop {
            // The borrow ends before the job runs, for the job may spawn.
            let next = scope.0.borrow_mut().pop_front();
            match next {
                Some(job) => job(&scope),
                None => return Ok(()),
            }
        }
    }

    /// What `item` gives for each number below `count`, in order.
    pub(crate) fn map<T: Send>(
        _threads: usize,
        count: usize,
        item: impl Fn(usize) -> T + Sync + Send,
    ) -> Result<Vec<T>, NoThreads> {
        Ok((0..count).map(item).collect())
    }

    /// What `of` makes of each item, in order.
    pub(crate) fn collect<I: Sync, T: Send>(items: &[I], of: impl Fn(&I) -> T + Sync + Send) -> Vec<T> {
        items.iter().map(of).collect()
    }
}

pub(crate) use pool::{Scope, collect, map, scope};
