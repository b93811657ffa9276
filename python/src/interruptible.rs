//! Long computations that Ctrl-C ends.

use std::{
    sync::{
        Arc,
        atomic::{AtomicBool, Ordering},
        mpsc::{RecvTimeoutError, channel},
    },
    thread,
    time::Duration,
};

use pyo3::{exceptions::PyRuntimeError, prelude::*};

use crate::pool::pool;

/// How often signals are looked for.
const PERIOD: Duration = Duration::from_millis(50);

/// Runs `work` on the threads of this process, while this one waits for signals without the interpreter. After
/// a signal, such as Ctrl-C, its exception is raised at once, and the flag is set: the thread ends with
/// what it has in hand, such as a level of cubes.
pub(crate) fn interruptible<T: Send + 'static>(
    py: Python<'_>,
    work: impl FnOnce(&Arc<AtomicBool>) -> T + Send + 'static,
) -> PyResult<T> {
    let pool = pool(py)?;
    py.detach(|| {
        let stopped = Arc::new(AtomicBool::new(false));
        let (sender, receiver) = channel();
        let flag = Arc::clone(&stopped);
        thread::Builder::new().spawn(move || {
            // Nobody receives it after a signal.
            let _ = sender.send(pool.install(|| work(&flag)));
        })?;
        loop {
            match receiver.recv_timeout(PERIOD) {
                Ok(found) => return Ok(found),
                Err(RecvTimeoutError::Timeout) => {}
                Err(RecvTimeoutError::Disconnected) => {
                    return Err(PyRuntimeError::new_err("the computation panicked"));
                }
            }
            if let Err(error) = Python::attach(|py| py.check_signals()) {
                stopped.store(true, Ordering::Relaxed);
                return Err(error);
            }
        }
    })
}
