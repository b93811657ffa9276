//! Work on all threads, behind a pointer: what the threads need is compiled once for each type of result.

use std::ops::Range;

use rayon::prelude::*;

/// How many numbers a chunk has.
const CHUNK: usize = 64;

/// Returns `f(0), …, f(count − 1)`, in this order.
pub fn in_parallel<T: Send>(count: usize, f: &(dyn Fn(usize) -> T + Sync)) -> Vec<T> {
    (0..count).into_par_iter().map(f).collect()
}

/// Returns what `f` returns for `0..64`, `64..128`, …, up to `count`, one after the other.
///
/// # Errors
///
/// The first error of `f`.
pub(crate) fn in_chunks<T: Send, E: Send>(
    count: usize,
    f: &(dyn Fn(Range<usize>) -> Result<Vec<T>, E> + Sync),
) -> Result<Vec<T>, E> {
    let chunk = |k: usize| f(k * CHUNK..count.min((k + 1) * CHUNK));
    let chunks: Vec<Vec<T>> =
        in_parallel(count.div_ceil(CHUNK), &chunk).into_iter().collect::<Result<_, _>>()?;
    Ok(chunks.into_iter().flatten().collect())
}

#[cfg(test)]
mod tests {
    use super::{in_chunks, in_parallel};

    #[test]
    fn results_are_in_order_and_the_first_error_counts() {
        assert_eq!(in_parallel(1000, &|k| 2 * k), (0..1000).map(|k| 2 * k).collect::<Vec<_>>());
        for count in [0, 1, 63, 64, 65, 1000] {
            let all: Result<Vec<usize>, ()> = in_chunks(count, &|range| Ok(range.collect()));
            assert_eq!(all, Ok((0..count).collect()));
        }
        let refused = in_chunks(1000, &|range| {
            if range.start < 500 { Ok(vec![0]) } else { Err(range.start) }
        });
        assert_eq!(refused, Err(512));
    }
}
