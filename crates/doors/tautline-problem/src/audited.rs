//! What an audit asks of a file: the part of space that it is about, and proofs in a ball.

use tautline::{ANY, AnySet, Ball, Interval, Shape};

use crate::{
    Diagnostic, Question,
    reading::shape::{Piece, refused},
};

impl Question {
    /// Returns the lower and the upper corner of a box around the bounded pieces of both sets and a
    /// near point of each unbounded one; `None` if the file has no sets.
    #[must_use]
    pub fn extents(&self) -> Option<[Vec<f64>; 2]> {
        let pieces = || self.ends.iter().flatten().flatten();
        let boxes = pieces().flat_map(|piece| piece.shape.boxes());
        let bounded: Vec<Vec<f64>> = boxes.flatten().collect();
        let [low, high] = hull(&bounded)?;
        let middle: Vec<f64> = low.iter().zip(&high).map(|(a, b)| 0.5 * (a + b)).collect();
        let far = pieces().filter_map(|piece| near(&piece.shape, &middle));
        hull(&bounded.iter().cloned().chain(far).collect::<Vec<_>>())
    }

    /// Returns the centre and the radius of the ball in which the constants of the file hold, or of
    /// the largest ball in the box; `None` if the file has no such region.
    #[must_use]
    pub fn ball_of_constants(&self) -> Option<(Vec<f64>, f64)> {
        match &self.within.as_ref()?.shape {
            Shape::Ball(ball) => Some((ball.centre_slice().to_vec(), ball.r())),
            Shape::AxisBox(side) => {
                let [low, high] = side.corner_slices();
                let centre: Vec<f64> =
                    low.iter().zip(high).map(|(a, b)| 0.5 * a + 0.5 * b).collect();
                // Rounded down, so that the ball lies in the box.
                let to = |a: f64, b: f64| (Interval::point(b) - Interval::point(a)).lo();
                let sides = low.iter().zip(&centre).zip(high);
                let halves = sides.map(|((&low, &c), &high)| to(low, c).min(to(c, high)));
                let radius = halves.fold(f64::INFINITY, f64::min);
                Some((centre, radius))
            }
            _ => None,
        }
    }

    /// Has constants proved in this ball. The centre must have as many coordinates as the metric.
    ///
    /// # Errors
    ///
    /// [`Diagnostic`] if the centre or the radius is not finite, or the radius is negative.
    pub fn prove_within_ball(&mut self, centre: &[f64], radius: f64) -> Result<(), Diagnostic> {
        let places = vec![self.problem.metric.span()];
        let ball = Ball::from_slice(centre, radius).map_err(|error| refused(&error, &places))?;
        self.within = Some(Piece { shape: Shape::Ball(ball), places });
        Ok(())
    }
}

/// Returns a point of an unbounded shape, the nearest of a half-space.
fn near(shape: &Shape<ANY>, x: &[f64]) -> Option<Vec<f64>> {
    match shape {
        Shape::HalfSpace(wall) => {
            let mut nearest = x.to_vec();
            wall.project(&mut nearest);
            Some(nearest)
        }
        Shape::AffineSubspace(subspace) => Some(subspace.base_slice().to_vec()),
        _ => None,
    }
}

/// Returns the corners of the smallest box around points.
fn hull(points: &[Vec<f64>]) -> Option<[Vec<f64>; 2]> {
    let first = points.first()?;
    let fold = |pick: fn(f64, f64) -> f64| {
        let coordinate = |i: usize| points.iter().map(|x| x[i]).fold(first[i], pick);
        (0..first.len()).map(coordinate).collect()
    };
    Some([fold(f64::min), fold(f64::max)])
}

#[cfg(test)]
mod tests {
    use crate::Question;

    #[test]
    fn the_extents_reach_from_a_ball_to_the_nearest_point_of_a_half_space() {
        let file = "[metric]\nphi = 1\n[from]\nball = { centre = [1, 2], radius = 1 }\n\
                    [to]\nhalf_space = { normal = [0, 2], at_least = 10 }\n";
        let question = Question::read(file).expect("a problem");
        assert_eq!(question.extents(), Some([vec![0.0, 1.0], vec![2.0, 5.0]]));
    }

    #[test]
    fn the_largest_ball_in_a_box_is_as_wide_as_its_shortest_edge() {
        let file = "dimension = 2\n[metric]\nphi = 1\n[certify]\n\
                    within = { box = { lower = [0, 0], upper = [4, 2] } }\n";
        let mut question = Question::read(file).expect("a problem");
        assert_eq!(question.ball_of_constants(), Some((vec![2.0, 1.0], 1.0)));
        question.prove_within_ball(&[3.0, 4.0], 0.5).expect("a ball");
        assert_eq!(question.ball_of_constants(), Some((vec![3.0, 4.0], 0.5)));
    }

    /// Middles and edges are rounded: of `[3, 10¹⁶ + 2]` the middle is `5·10¹⁵ + 2`, and the half of the
    /// edge reaches from there to 2.
    #[test]
    fn the_largest_ball_in_a_box_lies_in_it() {
        let ball = |low: f64, high: f64| {
            let file = format!(
                "dimension = 1\n[metric]\nphi = 1\n[certify]\n\
                 within = {{ box = {{ lower = [{low:?}], upper = [{high:?}] }} }}\n"
            );
            let question = Question::read(&file).expect("a problem");
            let (centre, radius) = question.ball_of_constants().expect("a ball");
            (centre[0], radius)
        };
        let sides = (0..60).flat_map(|i| (i + 1..61).map(move |j| (i, j)));
        let tenths = sides.map(|(i, j)| (0.1 * f64::from(i) - 3.0, 0.1 * f64::from(j) - 3.0));
        for (low, high) in tenths.chain([(3.0, 1e16 + 2.0), (-1e308, 1e308), (1e308, 1.5e308)]) {
            let (centre, radius) = ball(low, high);
            // The difference of the centre and an end, exactly: its rounding error is a double.
            let exactly = |a: f64, b: f64| {
                let difference = b - a;
                let rounded = difference - b;
                (difference, (b - (difference - rounded)) - (a + rounded))
            };
            for (difference, error) in [exactly(low, centre), exactly(centre, high)] {
                assert!(radius < difference || (radius == difference && error >= 0.0));
            }
            assert!(radius > 0.0 && radius >= 0.49 * (0.5 * high - 0.5 * low), "{low} {high}");
        }
    }

    #[test]
    fn an_audit_of_nothing_is_refused() {
        let file = "dimension = 1\n[metric]\nphi = 1\n[audit]\n";
        for (audit, message) in [
            ("cases = 0", "no samples"),
            ("region = { lower = [1], upper = [1] }", "an empty region"),
        ] {
            let error = Question::read(&format!("{file}{audit}\n")).expect_err("refused");
            assert_eq!(error.message, message);
        }
    }

    /// Of a bounded piece all of it, of an unbounded one a point.
    #[test]
    fn the_extents_hold_pieces_of_every_kind() {
        let extents = |from: &str, to: &str| {
            let file = format!("[metric]\nphi = 1\n[from]\n{from}\n[to]\n{to}\n");
            Question::read(&file).unwrap_or_else(|error| panic!("{file}: {error}")).extents()
        };
        let here = "point = [0, 0]";
        for (to, low, high) in [
            ("point = [3, -2]", [0.0, -2.0], [3.0, 0.0]),
            ("points = [[1, 5], [-4, 2], [0, -1]]", [-4.0, -1.0], [1.0, 5.0]),
            ("ball = { centre = [3, 1], radius = 2 }", [0.0, -1.0], [5.0, 3.0]),
            ("sphere = { centre = [-3, 1], radius = 2 }", [-5.0, -1.0], [0.0, 3.0]),
            ("box = { lower = [1, -3], upper = [2, -1] }", [0.0, -3.0], [2.0, 0.0]),
            ("segment = { from = [4, 1], to = [-1, 2] }", [-1.0, 0.0], [4.0, 2.0]),
            ("affine = { through = [-7, 3], directions = [[1, 1]] }", [-7.0, 0.0], [0.0, 3.0]),
            // The foot of the origin is (1.2, 1.6), and a half-space that holds it adds nothing.
            ("half_space = { normal = [3, 4], at_least = 10 }", [0.0, 0.0], [1.2, 1.6]),
            ("half_space = { normal = [3, 4], at_most = 10 }", [0.0, 0.0], [0.0, 0.0]),
            ("union = [{ point = [1, 2] }, { point = [-1, -2] }]", [-1.0, -2.0], [1.0, 2.0]),
        ] {
            for found in [extents(here, to), extents(to, here)] {
                let [found_low, found_high] = found.expect("sets");
                let pairs = found_low.iter().zip(low).chain(found_high.iter().zip(high));
                for (found, exact) in pairs {
                    assert!((found - exact).abs() < 1e-14, "{to}: {found_low:?} {found_high:?}");
                }
            }
        }
        let none = "dimension = 2\n[metric]\nphi = 1\n";
        assert_eq!(Question::read(none).expect("a file").extents(), None);
    }
}
