//! The cubes in which every minimal geodesic lies, and the outline of what is seen of them.

use std::collections::{BTreeMap, BTreeSet};

use super::shadow::Point;

/// Equal cubes `k a + [0, a]^D`, with whole numbers `k₁, …, k_D`.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cubes {
    /// The side `a`.
    pub side: f64,
    /// The places `k`, `D` numbers for each cube, one cube after the other.
    pub places: Vec<i32>,
}

/// What a proof says of a problem: bounds on the distance `d`, and cubes that hold every minimal
/// geodesic.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corridor<'a> {
    /// Sets of cubes, from coarse to fine. Each holds every minimal geodesic.
    pub levels: &'a [Cubes],
    /// The bounds `lower ≤ d ≤ upper`.
    pub bounds: [f64; 2],
}

/// A corner on the lattice of the cubes.
type Corner = (i32, i32);

impl Cubes {
    /// Returns the squares of the plane that cubes lie over, each once.
    pub(crate) fn squares(&self, dimension: usize, [right, up]: [usize; 2]) -> BTreeSet<Corner> {
        self.places.chunks_exact(dimension).map(|place| (place[right], place[up])).collect()
    }

    /// Returns the extents of all cubes along some coordinates, unless there are none.
    pub(crate) fn extents(&self, dimension: usize, coordinates: &[usize]) -> Option<Vec<[f64; 2]>> {
        let along = |k: usize| {
            let places = || self.places.iter().skip(k).step_by(dimension).copied();
            let (low, high) = (places().min()?, places().max()?);
            Some([f64::from(low) * self.side, (f64::from(high) + 1.0) * self.side])
        };
        coordinates.iter().map(|&k| along(k)).collect()
    }
}

impl Corridor<'_> {
    /// Returns what is proved, for the foot of the picture. `lie` says where the curves lie.
    pub(crate) fn remark(&self, lie: &str) -> String {
        let [lower, upper] = self.bounds;
        let exponent = exponent(upper);
        let unit = 10.0_f64.powi(exponent);
        // Two digits of the gap are shown.
        let gap = ((upper - lower) / unit).max(1e-12);
        let digits = (1.0 - gap.log10().floor()).clamp(2.0, 12.0) as usize;
        let factor = 10.0_f64.powi(digits as i32);
        // Outward, so that what is printed is true; a product may round to a whole number.
        let mut low = (lower / unit * factor).floor();
        if low / factor * unit > lower {
            low -= 1.0;
        }
        let mut high = (upper / unit * factor).ceil();
        if high / factor * unit < upper {
            high += 1.0;
        }
        let (low, high) = (low / factor, high / factor);
        let times = if exponent == 0 { String::new() } else { format!("·10^{{{exponent}}}") };
        format!("{lie} $d$ is in $[{low:.digits$}, {high:.digits$}]{times}$.")
    }
}

/// Returns the power of ten that is taken out of a number.
fn exponent(value: f64) -> i32 {
    if value == 0.0 || (1e-3..1e6).contains(&value) { 0 } else { value.log10().floor() as i32 }
}

/// Returns the outline of a union of squares `[i, i + 1] × [j, j + 1]`: closed rings that have it on
/// their left.
pub(crate) fn outline(squares: &BTreeSet<Corner>) -> Vec<Vec<Corner>> {
    let mut edges: BTreeMap<Corner, Vec<Corner>> = BTreeMap::new();
    for &(i, j) in squares {
        let corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)];
        let beyond = [(i, j - 1), (i + 1, j), (i, j + 1), (i - 1, j)];
        for (k, neighbour) in beyond.iter().enumerate() {
            if !squares.contains(neighbour) {
                edges.entry(corners[k]).or_default().push(corners[(k + 1) % 4]);
            }
        }
    }
    let mut rings = Vec::new();
    while let Some((&start, _)) = edges.first_key_value() {
        let mut ring: Vec<Corner> = Vec::new();
        let mut at = start;
        while let Some(next) = leave(&mut edges, at) {
            // A corner on a straight side is left out.
            if let [.., before, last] = ring[..]
                && (before.0 == last.0 && last.0 == at.0 || before.1 == last.1 && last.1 == at.1)
            {
                ring.pop();
            }
            ring.push(at);
            at = next;
        }
        rings.push(ring);
    }
    rings
}

/// Takes an edge that leaves a corner. As many edges enter a corner as leave it, so that a path ends
/// where it began.
fn leave(edges: &mut BTreeMap<Corner, Vec<Corner>>, at: Corner) -> Option<Corner> {
    let ends = edges.get_mut(&at)?;
    let next = ends.pop();
    if ends.is_empty() {
        edges.remove(&at);
    }
    next
}

/// Returns the outline of the squares of these cubes that are inside a box.
pub(crate) fn rings(
    cubes: &Cubes,
    dimension: usize,
    plane: [usize; 2],
    (x, y): ((f64, f64), (f64, f64)),
) -> Vec<Vec<Point>> {
    let mut squares = cubes.squares(dimension, plane);
    let meets = |k: i32, (from, to): (f64, f64)| {
        (f64::from(k) + 1.0) * cubes.side >= from && f64::from(k) * cubes.side <= to
    };
    squares.retain(|&(i, j)| meets(i, x) && meets(j, y));
    let point = |(i, j): Corner| (f64::from(i) * cubes.side, f64::from(j) * cubes.side);
    outline(&squares).into_iter().map(|ring| ring.into_iter().map(point).collect()).collect()
}

#[cfg(test)]
mod tests {
    use std::collections::BTreeSet;

    use super::{Corner, Corridor, outline};

    /// Returns twice the area inside rings, by their corners.
    fn twice_the_area(rings: &[Vec<Corner>]) -> i32 {
        let ring = |ring: &Vec<Corner>| -> i32 {
            let next = ring.iter().cycle().skip(1);
            ring.iter().zip(next).map(|(a, b)| a.0 * b.1 - a.1 * b.0).sum()
        };
        rings.iter().map(ring).sum()
    }

    #[test]
    fn an_outline_has_the_area_of_its_squares() {
        // A ring of eight squares around a hole, and two more that touch it at a corner.
        let mut squares: BTreeSet<Corner> =
            (0..3).flat_map(|i| (0..3).map(move |j| (i, j))).filter(|s| *s != (1, 1)).collect();
        squares.extend([(3, 3), (-1, -1)]);
        let rings = outline(&squares);
        assert_eq!(twice_the_area(&rings), 2 * squares.len() as i32, "{rings:?}");
        let straight: Vec<Vec<Corner>> = outline(&(0..5).map(|i| (i, 0)).collect());
        assert_eq!(straight, [[(0, 0), (5, 0), (5, 1), (0, 1)]]);
    }

    #[test]
    fn printed_bounds_are_rounded_outward() {
        let said = |bounds| Corridor { levels: &[], bounds }.remark("Here;");
        assert_eq!(said([4.674_924_141, 4.675_290_285]), "Here; $d$ is in $[4.67492, 4.67530]$.");
        assert_eq!(said([1.0, 1.0]), "Here; $d$ is in $[1.000000000000, 1.000000000000]$.");
        assert_eq!(said([2.0e-9, 2.1e-9]), "Here; $d$ is in $[2.00, 2.10]·10^{-9}$.");
    }
}
