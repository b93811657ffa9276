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

#[cfg(test)]
mod tests {
    use tautline_discretizations::PointSequence;

    use super::{OTHERS, lowest_different};
    use crate::Other;

    /// A line of length 2 whose middle is at a height.
    fn bent(height: f64) -> PointSequence<2> {
        let points = [[0.0, 0.0], [1.0, height], [2.0, 0.0]];
        PointSequence::new(points.map(Into::into).to_vec()).expect("finite")
    }

    fn heights(others: &[(f64, f64)], is_kept: &dyn Fn(&Other<2>) -> bool) -> Vec<f64> {
        let others =
            others.iter().map(|&(height, energy)| Other { sequence: bent(height), energy });
        let kept = lowest_different(others.collect(), &bent(0.0), is_kept);
        kept.iter().map(|other| other.sequence.points()[1][1]).collect()
    }

    /// Neither the lowest line nor one of the others stands twice, also if another one comes between; of two
    /// along one curve the lower one stays.
    #[test]
    fn each_curve_stands_once_and_the_lowest_first() {
        let all = [(1.0, 6.0), (2.0, 7.0), (1.001, 5.0), (0.01, 3.0), (-1.0, 4.0), (2.001, 8.0)];
        assert_eq!(heights(&all, &|_| true), [-1.0, 1.001, 2.0]);
        // One that is not kept makes room for the next along its curve.
        assert_eq!(heights(&all, &|other| other.energy != 5.0), [-1.0, 1.0, 2.0]);
    }

    #[test]
    fn there_are_at_most_seven() {
        let all: Vec<_> = (1..20).map(|k| (f64::from(k), f64::from(k))).collect();
        let expected: Vec<f64> = (1..=OTHERS as u32).map(f64::from).collect();
        assert_eq!(heights(&all, &|_| true), expected);
        assert!(heights(&[], &|_| true).is_empty());
    }
}
