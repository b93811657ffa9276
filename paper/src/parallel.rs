//! Applies one function to many values, on all cores, and returns the results in order.

use std::{
    sync::atomic::{AtomicUsize, Ordering},
    thread,
};

/// Returns `f` of each value, in the order of the values, whatever the number of threads.
///
/// # Panics
///
/// If `f` panics.
pub fn map<T: Sync, R: Send>(values: &[T], f: impl Fn(&T) -> R + Sync) -> Vec<R> {
    let threads = thread::available_parallelism().map_or(1, usize::from).min(values.len());
    let next = AtomicUsize::new(0);
    let mut results: Vec<(usize, R)> = thread::scope(|scope| {
        let work = || {
            let take = || next.fetch_add(1, Ordering::Relaxed);
            let mine = std::iter::repeat_with(take).take_while(|&k| k < values.len());
            mine.map(|k| (k, f(&values[k]))).collect::<Vec<_>>()
        };
        let workers: Vec<_> = (0..threads).map(|_| scope.spawn(work)).collect();
        workers.into_iter().flat_map(|worker| worker.join().expect("f did not panic")).collect()
    });
    results.sort_by_key(|(k, _)| *k);
    results.into_iter().map(|(_, result)| result).collect()
}
