//! Curves through the passes between two distance fields.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::PointSequence;
use tautline_metrics::{Metric, check_gram};
use tautline_sets::{ClosedSet, Ends, Point};

use crate::{Distances, Eikonal, EikonalError, GraphPathError, Lattice, Order, equal_chords};

/// The largest corner at a pass: `|∇u + ∇v|` under `H⁻¹`, which is 0 where two geodesics of unit speed
/// meet head on and 2 where one turns back. A chord of 30° is 0.52.
const SHARPEST: f64 = 0.5;

/// A curve through a pass: a shortest curve from the first set to a point, and one from there to the
/// second set, which meet without a corner.
#[derive(Clone, Debug, PartialEq)]
pub struct PassPath<const D: usize> {
    pass: SVector<f64, D>,
    corners: Vec<(f64, SVector<f64, D>)>,
}

impl<const D: usize> PassPath<D> {
    /// Returns the pass, a node of the lattice, in `ℓ`.
    #[must_use]
    pub fn pass(&self) -> &SVector<f64, D> {
        &self.pass
    }

    /// Returns the length, in `m`.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.corners.last().map_or(0.0, |last| last.0)
    }

    /// Returns `n` chords of equal length along the curve.
    ///
    /// # Errors
    ///
    /// Those of [`equal_chords`].
    pub fn sequence(&self, n: usize) -> Result<PointSequence<D>, GraphPathError> {
        equal_chords(&self.corners, n)
    }
}

/// Returns curves through the passes between two sets, in the plane or in space: at most `most`, those
/// through the lowest passes, and none through a pass where `u + v` is more than `slack` times its least
/// value.
///
/// With the distances `u` from the first set and `v` from the second, `u(x) + v(x)` is the length of the
/// shortest curve through `x`. Along a minimal geodesic it is least. Along a local one it is stationary
/// wherever both parts are shortest, `∇u = −∇v`: the curves through such nodes, one for each cluster of
/// them, run near to the minimal geodesic and to the local ones that are made of two shortest parts. In
/// road networks they are known as plateaus (I. Abraham, D. Delling, A. Goldberg and R. Werneck,
/// *Alternative routes in road networks*, ACM J. Exp. Algorithmics 18, 2013).
///
/// # Errors
///
/// [`GraphPathError::Slack`] unless `slack` is at least 1, those of [`Eikonal::new`] and
/// [`Eikonal::distances_from`], and [`EikonalError::NotConnected`]. A pass to which no path descends is left
/// out.
pub fn pass_paths<M: Metric<D>, const D: usize>(
    metric: &M,
    ends: &Ends<D>,
    lattice: &Lattice<D>,
    most: usize,
    slack: f64,
) -> Result<Vec<PassPath<D>>, EikonalError> {
    if !(slack >= 1.0) {
        return Err(GraphPathError::Slack { slack }.into());
    }
    let equation = Eikonal::new(metric, lattice)?;
    let first = equation.distances_from(&**ends.first(), Order::Second)?;
    let second =
        equation.distances_from(&**ends.second(), Order::Second).map_err(|error| match error {
            EikonalError::FarFromEnd { .. } => EikonalError::FarFromEnd { end: "second" },
            error => error,
        })?;
    let through: Vec<f64> =
        first.values().iter().zip(second.values()).map(|(u, v)| u + v).collect();
    let least = through.iter().copied().fold(f64::INFINITY, f64::min);
    if !least.is_finite() {
        let reached = first.values().iter().filter(|value| value.is_finite()).count();
        return Err(EikonalError::NotConnected { reached, nodes: lattice.nodes() });
    }
    let corner = |node: usize| {
        if !(through[node] <= slack * least) {
            return None;
        }
        let bend = first.gradient(node)? + second.gradient(node)?;
        let h: SMatrix<f64, D, D> = check_gram(metric, &lattice.point(node)).ok()?;
        let corner = bend.dot(&(h.cholesky()?.solve(&bend))).sqrt();
        (corner <= SHARPEST).then_some(corner)
    };
    let corners: Vec<Option<f64>> = (0..through.len()).map(corner).collect();
    let mut passes = passes(lattice, &corners);
    passes.sort_by(|&a, &b| through[a].total_cmp(&through[b]));
    let path = |&node: &usize| path_through(&first, &second, lattice.point(node));
    Ok(passes.iter().filter_map(path).take(most).collect())
}

/// Returns the node with the least corner of each cluster of neighbouring nodes with one.
fn passes<const D: usize>(lattice: &Lattice<D>, corners: &[Option<f64>]) -> Vec<usize> {
    let offsets: Vec<[isize; D]> = (0..3_usize.pow(D as u32))
        .map(|number| std::array::from_fn(|i| (number / 3_usize.pow(i as u32) % 3) as isize - 1))
        .collect();
    let (mut seen, mut passes) = (vec![false; corners.len()], Vec::new());
    for start in 0..corners.len() {
        if seen[start] || corners[start].is_none() {
            continue;
        }
        let (mut cluster, mut next) = (vec![start], 0);
        seen[start] = true;
        while let Some(&node) = cluster.get(next) {
            next += 1;
            let place = lattice.place(node);
            for other in offsets.iter().filter_map(|offset| lattice.neighbour(&place, offset)) {
                if corners[other].is_some() && !std::mem::replace(&mut seen[other], true) {
                    cluster.push(other);
                }
            }
        }
        let least = cluster.into_iter().min_by(|&a, &b| {
            let key = |node: usize| corners[node].unwrap_or(f64::INFINITY);
            key(a).total_cmp(&key(b))
        });
        passes.extend(least);
    }
    passes
}

/// Returns the two descents from a node, joined there.
fn path_through<M: Metric<D>, const D: usize>(
    first: &Distances<'_, M, D>,
    second: &Distances<'_, M, D>,
    pass: SVector<f64, D>,
) -> Option<PassPath<D>> {
    let node = Point::new(pass).ok()?;
    let set: &dyn ClosedSet<D> = &node;
    let (there, back) = (first.path_to(set).ok()?, second.path_to(set).ok()?);
    let mut corners = there.corners().to_vec();
    let (half, whole) = (there.length(), there.length() + back.length());
    let rest = back.corners().iter().rev().skip(1);
    // The rounding of the difference must not make the lengths decrease.
    corners.extend(rest.map(|&(length, x)| ((whole - length).max(half), x)));
    Some(PassPath { pass, corners })
}

#[cfg(test)]
mod tests {
    use super::passes;
    use crate::Lattice;

    /// A cluster is of nodes beside each other, also along a diagonal, and its pass is the node with the least
    /// corner, wherever in the cluster it is.
    #[test]
    fn the_pass_of_a_cluster_is_its_node_with_the_least_corner() {
        let lattice = Lattice::new([0.0, 0.0], [4.0, 4.0], 1.0).expect("a box");
        let mut corners = vec![None; lattice.nodes()];
        // Rows of five nodes: a chain along diagonals, one node alone, and a row.
        for (node, corner) in
            [(0, 0.3), (6, 0.1), (12, 0.2), (4, 0.4), (20, 0.4), (21, 0.3), (22, 0.2)]
        {
            corners[node] = Some(corner);
        }
        assert_eq!(passes(&lattice, &corners), [6, 4, 22]);
        corners[16] = Some(0.05);
        assert_eq!(passes(&lattice, &corners), [16, 4]);
        assert!(passes(&lattice, &vec![None; lattice.nodes()]).is_empty());
    }
}
