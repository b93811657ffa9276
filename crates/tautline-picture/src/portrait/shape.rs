//! The sets at which a curve may begin and end.

/// A closed set in `R^D`. An end of a problem is a union of them.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A point.
    Point(Vec<f64>),
    /// Finitely many points.
    Points(Vec<Vec<f64>>),
    /// The ball `|x − centre| ≤ radius`.
    Ball {
        /// The centre.
        centre: Vec<f64>,
        /// The radius, at least 0.
        radius: f64,
    },
    /// The sphere `|x − centre| = radius`.
    Sphere {
        /// The centre.
        centre: Vec<f64>,
        /// The radius, at least 0.
        radius: f64,
    },
    /// The box `low ≤ x ≤ high`, whose sides may be infinite.
    AxisBox {
        /// The lower ends of the sides.
        low: Vec<f64>,
        /// The upper ends of the sides.
        high: Vec<f64>,
    },
    /// The half-space `normal·x ≤ offset`. The normal need not have length 1.
    HalfSpace {
        /// The normal, which points out of the set.
        normal: Vec<f64>,
        /// The offset.
        offset: f64,
    },
    /// The segment between two points.
    Segment {
        /// One end.
        from: Vec<f64>,
        /// The other end.
        to: Vec<f64>,
    },
    /// The points `point + Σ tₖ directions[k]`, for all real `tₖ`.
    AffineSubspace {
        /// One of its points.
        point: Vec<f64>,
        /// The directions, which may be dependent.
        directions: Vec<Vec<f64>>,
    },
}

impl Shape {
    /// Returns the number of coordinates of each of its vectors.
    pub fn coordinates(&self) -> impl Iterator<Item = usize> {
        let (first, others): (&[f64], &[Vec<f64>]) = match self {
            Shape::Points(points) => (points.first().map_or(&[], |x| x), points),
            Shape::Point(x) | Shape::Ball { centre: x, .. } | Shape::Sphere { centre: x, .. } => {
                (x, &[])
            }
            Shape::HalfSpace { normal, .. } => (normal, &[]),
            Shape::AxisBox { low: x, high: y } | Shape::Segment { from: x, to: y } => {
                (x, std::slice::from_ref(y))
            }
            Shape::AffineSubspace { point, directions } => (point, directions),
        };
        std::iter::once(first.len()).chain(others.iter().map(Vec::len))
    }

    /// Returns the name of the kind of set, with its article.
    #[must_use]
    pub fn name(&self) -> &'static str {
        match self {
            Shape::Point(_) => "a point",
            Shape::Points(_) => "a finite set",
            Shape::Ball { .. } => "a ball",
            Shape::Sphere { .. } => "a sphere",
            Shape::AxisBox { .. } => "a box",
            Shape::HalfSpace { .. } => "a half-space",
            Shape::Segment { .. } => "a segment",
            Shape::AffineSubspace { .. } => "an affine subspace",
        }
    }

    /// Returns the extents of its bounded pieces along some coordinates, one list for each piece.
    /// They are empty if the set is unbounded along one of them.
    pub(crate) fn extents(&self, coordinates: &[usize]) -> Vec<Vec<[f64; 2]>> {
        let sides = |side: &dyn Fn(usize) -> [f64; 2]| -> Vec<[f64; 2]> {
            coordinates.iter().map(|&k| side(k)).collect()
        };
        let pieces = match self {
            Shape::Point(point) => vec![sides(&|k| [point[k]; 2])],
            Shape::Points(points) => points.iter().map(|point| sides(&|k| [point[k]; 2])).collect(),
            Shape::Ball { centre, radius } | Shape::Sphere { centre, radius } => {
                vec![sides(&|k| [centre[k] - radius, centre[k] + radius])]
            }
            Shape::AxisBox { low, high } => vec![sides(&|k| [low[k], high[k]])],
            Shape::Segment { from, to } => {
                vec![sides(&|k| [from[k].min(to[k]), from[k].max(to[k])])]
            }
            Shape::HalfSpace { .. } | Shape::AffineSubspace { .. } => Vec::new(),
        };
        let bounded = |piece: &Vec<[f64; 2]>| piece.iter().flatten().all(|end| end.is_finite());
        pieces.into_iter().filter(bounded).collect()
    }

    /// Returns a point of an unbounded set that is near the origin, for a picture without a curve.
    pub(crate) fn anchor(&self) -> Option<Vec<f64>> {
        match self {
            Shape::HalfSpace { normal, offset } => {
                let largest = normal.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
                let scaled: Vec<f64> = normal.iter().map(|n| n / largest).collect();
                let square: f64 = scaled.iter().map(|n| n * n).sum();
                Some(scaled.iter().map(|n| n * (offset / largest) / square).collect())
            }
            Shape::AffineSubspace { point, .. } => Some(point.clone()),
            Shape::AxisBox { low, high } => {
                let near = |(low, high): (&f64, &f64)| 0.0_f64.clamp(*low, *high);
                Some(low.iter().zip(high).map(near).collect())
            }
            _ => None,
        }
    }
}
