//! Computes the two halves of a computation in the lanes of a register, one after the other, or on
//! two threads.

use std::{panic::resume_unwind, thread};

/// Whether the two sides of an elimination are computed together in the lanes of a register, one
/// chord from each side at a time. Up to three dimensions the matrices stay in registers, and this
/// is faster than one side after the other.
pub(crate) const fn goes_in_lanes(dimension: usize) -> bool {
    dimension < 4
}

/// The stack of the second thread, in bytes. In many dimensions it holds matrices of jets, 8 MB at
/// `D = 64`. Only the part that is used takes up memory.
const STACK: usize = 32 << 20;

/// If the chords of a grid have this many second derivatives, half a sweep takes ten times as long
/// as starting and ending a thread.
const WORTH_A_THREAD: usize = 65_536;

/// Returns whether two of `threads` threads should share a pass over `n` chords, one from each end.
/// Where both sides share the lanes of a register, two threads with one side each are slower.
pub(crate) fn share(dimension: usize, threads: usize, n: usize) -> bool {
    let processors = || thread::available_parallelism().map_or(1, usize::from);
    let worth = !goes_in_lanes(dimension) && n * dimension * dimension >= WORTH_A_THREAD;
    worth && threads > 1 && processors() > 1
}

/// Returns both results, if both exist. They are computed one after the other or, if `at_once` and
/// the system grants a second thread, at the same time.
pub(crate) fn join<T: Send>(
    at_once: bool,
    one: impl FnOnce() -> Option<T>,
    other: impl FnOnce() -> Option<T> + Send,
) -> Option<[T; 2]> {
    if at_once { on_two_threads(STACK, one, other) } else { Some([one()?, other()?]) }
}

fn on_two_threads<T: Send>(
    stack: usize,
    one: impl FnOnce() -> Option<T>,
    other: impl FnOnce() -> Option<T> + Send,
) -> Option<[T; 2]> {
    let mut other = Some(other);
    let (one, done) = thread::scope(|scope| {
        let work = || other.take().map(|other| other());
        let thread = thread::Builder::new().stack_size(stack).spawn_scoped(scope, work);
        let one = one();
        let done = thread.ok().map(|thread| thread.join().unwrap_or_else(|why| resume_unwind(why)));
        (one, done.flatten())
    });
    // If no thread took the other half, it is computed here.
    let other = done.or_else(|| other.map(|other| other()));
    Some([one?, other.flatten()?])
}

#[cfg(test)]
mod tests {
    use std::thread;

    use super::{STACK, join, on_two_threads, share};

    /// Returns which half was computed, and whether this thread computed it.
    fn halves(stack: usize) -> [(i32, bool); 2] {
        let here = thread::current().id();
        let half = |which| Some((which, thread::current().id() == here));
        on_two_threads(stack, || half(1), || half(2)).expect("both halves")
    }

    #[test]
    fn the_halves_run_in_order_on_two_threads() {
        assert_eq!(halves(STACK), [(1, true), (2, false)]);
        assert_eq!(join(false, || Some(1), || Some(2)), Some([1, 2]));
    }

    #[test]
    fn without_a_second_thread_the_first_does_both() {
        // No system grants a stack of this size.
        assert_eq!(halves(1 << 60), [(1, true), (2, true)]);
    }

    #[test]
    fn there_is_no_result_without_either_half() {
        for at_once in [false, true] {
            for [one, other] in [[None, Some(2)], [Some(1), None], [None, None]] {
                assert_eq!(join(at_once, || one, || other), None);
            }
        }
        // If the halves are computed one after the other, the second does not begin in vain.
        let begun = join(false, || None::<()>, || panic!("begun"));
        assert_eq!(begun, None);
    }

    #[test]
    #[should_panic(expected = "the other half")]
    fn a_panic_reaches_the_waiting_thread() {
        join(true, || Some(()), || panic!("the other half"));
    }

    #[test]
    fn threads_share_large_passes_only() {
        let two = thread::available_parallelism().is_ok_and(|processors| processors.get() > 1);
        assert_eq!([4095, 4096].map(|n| share(4, 2, n)), [false, two]);
        assert_eq!([1023, 1024].map(|n| share(8, 2, n)), [false, two]);
        assert_eq!([0, 1, 3].map(|threads| share(8, threads, 1024)), [false, false, two]);
        // Up to three dimensions one thread takes both sides at once.
        assert!(!share(3, 2, 1 << 20));
    }
}
