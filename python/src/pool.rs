//! The threads of this process.

use std::{
    mem, process,
    sync::{Arc, Mutex, PoisonError},
};

use pyo3::{exceptions::PyRuntimeError, prelude::*};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// The stack of a thread: programs in many dimensions keep matrices on it.
const STACK: usize = 16 << 20;

/// The threads, and the process that started them.
static POOL: Mutex<Option<(u32, Arc<ThreadPool>)>> = Mutex::new(None);

/// Returns the threads of this process, one for each processor. A child by `fork` has none of those of
/// its parent, and starts its own: on theirs it would wait for ever.
///
/// The caller holds the interpreter, as `fork` does, so that no child is born while the lock is held.
pub(crate) fn pool(_: Python<'_>) -> PyResult<Arc<ThreadPool>> {
    let mut held = POOL.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some((id, pool)) = &*held
        && *id == process::id()
    {
        return Ok(Arc::clone(pool));
    }
    let pool = threads(0)?;
    // Those of the parent are not there to be ended.
    mem::forget(held.replace((process::id(), Arc::clone(&pool))));
    Ok(pool)
}

/// Starts this many threads; 0 stands for one for each processor.
pub(crate) fn threads(number: usize) -> PyResult<Arc<ThreadPool>> {
    let pool = ThreadPoolBuilder::new().num_threads(number).stack_size(STACK).build();
    let failed = |error| PyRuntimeError::new_err(format!("{number} threads do not start: {error}"));
    pool.map(Arc::new).map_err(failed)
}
