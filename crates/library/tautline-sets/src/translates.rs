//! The translates of a set by multiples of periods.
//!
//! Where coordinates are angles, a set is all of its translates by multiples of the periods, and the
//! shortest curve to it ends in one of them.

use tautline_scalar::ANY;

use crate::kind::{Kind, Value};
use crate::{AnySet, SetError, Shape};

/// The most periodic coordinates for which all neighbours of the nearest translate are taken, `3³ = 27`.
const ALL_NEIGHBOURS: usize = 3;

impl Shape<ANY> {
    /// Returns the set `X + t`, for a vector `t` with a coordinate for each dimension, in `ℓ`. Each
    /// coordinate, and the side of a half-space, is rounded.
    ///
    /// # Errors
    ///
    /// [`SetError::Coordinates`] for a vector of another dimension; [`SetError::NonFiniteCoordinate`] or
    /// [`SetError::NonFinite`] if a sum is not finite.
    pub fn translated(&self, by: &[f64]) -> Result<Self, SetError> {
        let (found, dimension) = (by.len(), self.dimension());
        if found != dimension {
            return Err(SetError::Coordinates { what: "a translation", found, dimension });
        }
        match self {
            Shape::Union(shapes) => {
                let moved = shapes.iter().map(|shape| shape.translated(by));
                Ok(Shape::Union(moved.collect::<Result<_, _>>()?))
            }
            piece => {
                let moved = piece
                    .described()
                    .into_iter()
                    .map(|(kind, values)| kind.shape(&translated(kind, values, by)));
                Shape::union(moved.collect::<Result<_, _>>()?)
            }
        }
    }
}

/// Returns the values of the parts of a translated set.
fn translated(kind: Kind, values: Vec<Value>, by: &[f64]) -> Vec<Value> {
    let moved = |x: Vec<f64>| -> Vec<f64> { x.iter().zip(by).map(|(x, by)| x + by).collect() };
    // A side is that of the direction before it.
    let mut height = 0.0;
    let moved = values.into_iter().zip(kind.parts).map(|(value, part)| match value {
        Value::Vector(x) if part.are_places => Value::Vector(moved(x)),
        Value::Vectors(rows) if part.are_places => {
            Value::Vectors(rows.into_iter().map(moved).collect())
        }
        Value::Vector(direction) => {
            height = direction.iter().zip(by).map(|(n, by)| n * by).sum();
            Value::Vector(direction)
        }
        Value::AtMost(side) => Value::AtMost(side + height),
        Value::AtLeast(side) => Value::AtLeast(side + height),
        value @ (Value::Vectors(_) | Value::Number(_)) => value,
    });
    moved.collect()
}

/// Returns the translates of a set by multiples of periods that come near to the set `from`: for each
/// coordinate with a period, the translate of each piece nearest to a point of `from`, and those next to it on both sides.
/// With more than three periodic coordinates, neighbours differ from the nearest translate in one of them.
///
/// `periods` has a number for each coordinate, in `ℓ`: 0 for a coordinate that is not periodic. A set that
/// a translation does not change is taken once.
///
/// Every other translate is, for up to three periods, farther than the least period from the other set: along
/// some coordinate it is moved by two periods from the nearest one, which is at most half a period away, and
/// the sets together extend over half a period at most. With a metric `H ≥ c₁ I` a curve to it is longer than
/// `√c₁` times the least period. With a larger `c₂` it may be shorter than all curves to these translates.
///
/// ```
/// use tautline_scalar::ANY;
/// use tautline_sets::{Point, Shape, translates};
///
/// let [from, to] = [[0.0, -3.0], [0.0, 3.0]].map(|x| Point::<ANY>::from_slice(&x).map(Shape::Point));
/// let turn = std::f64::consts::TAU;
/// let all = translates(&to?, &from?, &[0.0, turn])?;
/// let ends: Vec<f64> = all.iter().map(|shape| shape.boxes()[0][0][1]).collect();
/// assert_eq!(ends, [3.0 - 2.0 * turn, 3.0 - turn, 3.0]);
/// # Ok::<(), tautline_sets::SetError>(())
/// ```
///
/// # Errors
///
/// As for [`Shape::translated`]; [`SetError::Period`] if a period is negative or not finite;
/// [`SetError::Extent`] if the sets extend over more than half of a period.
pub fn translates(
    set: &Shape<ANY>,
    from: &Shape<ANY>,
    periods: &[f64],
) -> Result<Vec<Shape<ANY>>, SetError> {
    let dimension = set.dimension();
    for (what, found) in [("the period", periods.len()), ("the other set", from.dimension())] {
        if found != dimension {
            return Err(SetError::Coordinates { what, found, dimension });
        }
    }
    if let Some((index, &value)) =
        periods.iter().enumerate().find(|(_, period)| !(period.is_finite() && **period >= 0.0))
    {
        return Err(SetError::Period { index, value });
    }
    let periodic: Vec<usize> = (0..dimension).filter(|&i| periods[i] > 0.0).collect();
    let mut found: Vec<Shape<ANY>> = Vec::new();
    for piece in set.single_pieces() {
        for here in from.single_pieces() {
            for &index in &periodic {
                let period = periods[index];
                let extent = extent(&piece, index, period)? + extent(&here, index, period)?;
                if !(extent <= 0.5 * period) {
                    return Err(SetError::Extent { index, extent, period });
                }
            }
            let mut start = vec![0.0; dimension];
            piece.project(&mut start);
            here.project(&mut start);
            let mut goal = start.clone();
            piece.project(&mut goal);
            let nearest = |i: usize| ((start[i] - goal[i]) / periods[i]).round();
            for steps in neighbours(periodic.len()) {
                let mut by = vec![0.0; dimension];
                for (&i, step) in periodic.iter().zip(steps) {
                    by[i] = (nearest(i) + step) * periods[i];
                }
                let translate = piece.translated(&by)?;
                if !found.contains(&translate) {
                    found.push(translate);
                }
            }
        }
    }
    Ok(found)
}

/// Returns the extent of a piece along a coordinate with a period, in `ℓ`: 0 if it is its own translate, and
/// infinite for another set without end.
fn extent(piece: &Shape<ANY>, index: usize, period: f64) -> Result<f64, SetError> {
    if let [[lower, upper]] = &piece.boxes()[..] {
        return Ok(upper[index] - lower[index]);
    }
    let mut by = vec![0.0; piece.dimension()];
    by[index] = period;
    Ok(if piece.translated(&by)? == *piece { 0.0 } else { f64::INFINITY })
}

/// Returns the multiples of each of the periods by which neighbours differ from the nearest translate.
fn neighbours(periodic: usize) -> Vec<Vec<f64>> {
    if periodic <= ALL_NEIGHBOURS {
        let all = 3_usize.pow(periodic as u32);
        let step = |k: usize, i: usize| (k / 3_usize.pow(i as u32) % 3) as f64 - 1.0;
        return (0..all).map(|k| (0..periodic).map(|i| step(k, i)).collect()).collect();
    }
    let alone = |i: usize, step: f64| {
        let mut steps = vec![0.0; periodic];
        steps[i] = step;
        steps
    };
    let beside = (0..periodic).flat_map(|i| [alone(i, -1.0), alone(i, 1.0)]);
    std::iter::once(vec![0.0; periodic]).chain(beside).collect()
}

#[cfg(test)]
mod tests {
    use tautline_chance::{Random, cases, seed};
    use tautline_scalar::ANY;

    use super::translates;
    use crate::{
        AffineSubspace, AnySet, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, SetError,
        Shape, Sphere,
    };

    fn point(x: &[f64]) -> Shape<ANY> {
        Shape::Point(Point::from_slice(x).expect("finite"))
    }

    /// One set of each kind, and a union of all.
    fn sets() -> Vec<Shape<ANY>> {
        let [a, b] = [[1.0, -2.0], [3.0, 0.5]];
        let sets = [
            Point::from_slice(&a).map(Shape::Point),
            FiniteSet::from_slices([&a[..], &b]).map(Shape::FiniteSet),
            Ball::from_slice(&a, 2.0).map(Shape::Ball),
            Sphere::from_slice(&a, 2.0).map(Shape::Sphere),
            AxisBox::from_slices(&a, &b).map(Shape::AxisBox),
            Segment::from_slices(&a, &b).map(Shape::Segment),
            HalfSpace::from_slice(&a, 1.0).map(Shape::HalfSpace),
            AffineSubspace::from_slices(&a, [&b]).map(Shape::AffineSubspace),
        ];
        let mut sets: Vec<_> = sets.map(|set| set.expect("a set")).into();
        sets.push(Shape::union(sets.clone()).expect("a union"));
        sets
    }

    /// `P_{X+t}(x + t) = P_X(x) + t`, up to rounding.
    #[test]
    fn the_projection_to_a_translated_set_is_translated() {
        let mut random = Random(seed(8361));
        for set in sets() {
            for _ in 0..cases(20) {
                let mut pair = || [(); 2].map(|()| random.between(-5.0, 5.0));
                let (by, x) = (pair(), pair());
                let moved = set.translated(&by).expect("finite");
                let [mut here, mut there] = [x, [x[0] + by[0], x[1] + by[1]]];
                set.project(&mut here);
                moved.project(&mut there);
                for i in 0..2 {
                    let error = (there[i] - here[i] - by[i]).abs();
                    assert!(error < 64.0 * f64::EPSILON * 20.0, "{error} of {set:?} by {by:?}");
                }
            }
            let back =
                set.translated(&[4.0, -8.0]).and_then(|moved| moved.translated(&[-4.0, 8.0]));
            assert_eq!(back.as_ref(), Ok(&set));
        }
    }

    #[test]
    fn the_nearest_translate_has_its_neighbours_beside_it() {
        let (from, to) = (point(&[0.5, 7.0, 1.0]), point(&[90.25, -100.0, 2.0]));
        let all = translates(&to, &from, &[10.0, 0.0, 4.0]).expect("translates");
        let ends: Vec<_> = all.iter().map(|set| set.boxes()[0][0].clone()).collect();
        let mut expected = Vec::new();
        for z in [-2.0, 2.0, 6.0] {
            expected.extend([-9.75, 0.25, 10.25].map(|x| vec![x, -100.0, z]));
        }
        assert_eq!(ends, expected);
        // In four coordinates one differs at a time.
        let [from, to] = [[0.0; 4], [0.25; 4]].map(|x| point(&x));
        assert_eq!(translates(&to, &from, &[1.0; 4]).expect("translates").len(), 9);
    }

    /// A half-space along the periodic coordinate, and a subspace, are their own translates; two starts far
    /// from each other have translates of their own.
    #[test]
    fn equal_translates_are_taken_once() {
        let wall = Shape::HalfSpace(HalfSpace::from_slice(&[0.0, 1.0], 3.0).expect("a normal"));
        let from = point(&[0.0, 9.0]);
        assert_eq!(translates(&wall, &from, &[2.0, 0.0]), Ok(vec![wall.clone()]));
        assert_eq!(translates(&wall, &from, &[0.0, 0.0]), Ok(vec![wall]));
        let both = Shape::union(vec![point(&[0.0, 0.0]), point(&[60.0, 0.0])]).expect("two");
        assert_eq!(translates(&from, &both, &[6.0, 0.0]).expect("translates").len(), 6);
    }

    /// A segment over ten periods has ten nearest translates, and a slanted half-space has each of them.
    #[test]
    fn sets_over_more_than_half_of_a_period_are_refused() {
        let segment =
            |x: f64| Shape::Segment(Segment::from_slices(&[0.0, 0.0], &[x, 10.0]).expect("finite"));
        let to = point(&[0.5, 10.0]);
        assert_eq!(translates(&to, &segment(5.0), &[10.0, 0.0]).expect("translates").len(), 3);
        for (one, other) in [(segment(100.0), to.clone()), (to.clone(), segment(5.1))] {
            let error = translates(&other, &one, &[10.0, 0.0]).expect_err("refused");
            assert!(matches!(error, SetError::Extent { index: 0, period: 10.0, .. }), "{error}");
        }
        let slanted = Shape::HalfSpace(HalfSpace::from_slice(&[1.0, 9.0], 0.0).expect("a normal"));
        let error = translates(&to, &slanted, &[10.0, 0.0]).expect_err("refused");
        assert_eq!(error, SetError::Extent { index: 0, extent: f64::INFINITY, period: 10.0 });
    }

    /// Twenty-seven for three periods.
    #[test]
    fn three_periods_have_all_neighbours() {
        let [from, to] = [[0.0; 3], [0.25; 3]].map(|x| point(&x));
        assert_eq!(translates(&to, &from, &[1.0; 3]).expect("translates").len(), 27);
    }

    #[test]
    fn what_is_no_period_is_refused() {
        let (from, to) = (point(&[0.0, 1.0]), point(&[1.0, 2.0]));
        for value in [-1.0, f64::INFINITY, f64::NAN] {
            let error = translates(&to, &from, &[0.0, value]).expect_err("refused");
            assert!(matches!(error, SetError::Period { index: 1, .. }), "{error}");
        }
        let error = translates(&to, &from, &[1.0]).expect_err("refused");
        let expected = SetError::Coordinates { what: "the period", found: 1, dimension: 2 };
        assert_eq!(error, expected);
        assert!(to.translated(&[f64::MAX, 0.0]).is_ok());
        assert!(point(&[f64::MAX, 0.0]).translated(&[f64::MAX, 0.0]).is_err());
    }
}
