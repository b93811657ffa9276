//! The other local minimisers of a result.

use tautline_discretizations::PointSequence;

use crate::{
    Other,
    search::candidate::{are_apart, by_key},
};

/// The largest number of local minimisers that are returned besides the result.
const OTHERS: usize = 7;

/// Returns those of some local minimisers that run along other curves than `lowest`, and than each other,
/// lowest first: the first seven that `is_kept` accepts.
#[must_use]
pub fn lowest_different<const D: usize>(
    others: Vec<Other<D>>,
    lowest: &PointSequence<D>,
    is_kept: &dyn Fn(&Other<D>) -> bool,
) -> Vec<Other<D>> {
    let keys: Vec<_> = others.iter().map(|other| (false, other.energy)).collect();
    let mut others: Vec<_> = others.into_iter().map(Some).collect();
    let mut kept: Vec<Other<D>> = Vec::new();
    for other in by_key(&keys).into_iter().filter_map(|place| others[place].take()) {
        let is_new = |known: &PointSequence<D>| are_apart(&other.sequence, known);
        if is_new(lowest) && kept.iter().all(|known| is_new(&known.sequence)) && is_kept(&other) {
            kept.push(other);
        }
        if kept.len() == OTHERS {
            break;
        }
    }
    kept
}
