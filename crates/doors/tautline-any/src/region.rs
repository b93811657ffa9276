//! `Region`: an obstacle, and metrics with obstacles.

use tautline::{
    ANY, Formula,
    formula::{Part, Written, WrittenError},
};

use crate::{GivenError, Shape, given::check_coordinates};

/// A region that no curve enters.
#[derive(Clone, Debug, PartialEq)]
pub enum Region {
    /// A ball of positive radius, or a half-space.
    Set(Shape),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(String),
}

/// Returns the metric `(1 + Σₖ (m/δₖ)²) H` with the distances `δₖ` from regions, which is undefined in them.
pub(crate) fn avoiding(
    formula: &Formula<ANY>,
    regions: &[Region],
    margin: f64,
) -> Result<Formula<ANY>, GivenError> {
    if !(margin > 0.0 && margin.is_finite()) {
        return Err(GivenError::Margin { margin });
    }
    let mut distances = Vec::new();
    for region in regions {
        let text = match region {
            Region::Negative(text) => text.clone(),
            Region::Set(shape) => {
                check_coordinates(shape, formula.dimension())?;
                distance(shape).ok_or(GivenError::NoInside { set: shape.name() })?
            }
        };
        distances.push(text);
    }
    let factor = factor(distances.len(), margin);
    fn part(text: &str) -> Part<'_> {
        Part { text, id: 0 }
    }
    let distances = distances.iter().map(|text| part(text)).collect();
    let metric = Box::new(Written::Recorded(formula.clone()));
    let metric = Written::Weighted(distances, part(&factor), metric);
    let formula = Formula::compose_in(formula.dimension(), &[], &[], &[], &metric);
    formula.map_err(|WrittenError { error, .. }| GivenError::Text(error))
}

/// Returns the text of `1 + Σₖ (m/δₖ)²` for so many distances, which a
/// [weight](tautline::formula::Written::Weighted) calls `u1`, `u2`, …. By the logarithm it is undefined
/// for `δ ≤ 0`, so that a search refuses a step into the region.
#[must_use]
pub fn factor(count: usize, margin: f64) -> String {
    let repulsion = |number: usize| format!(" + exp(-2*ln(u{number}/{margin:?}))");
    "1".to_owned() + &(1..=count).map(repulsion).collect::<String>()
}

/// Returns the text of the distance of `x` from a ball or a half-space, negative inside. `None` if it has
/// no inside, and for other sets.
#[must_use]
pub fn distance(shape: &Shape) -> Option<String> {
    let sum = |terms: Vec<String>| terms.join(" + ");
    match shape {
        Shape::Ball(ball) if ball.r() > 0.0 => {
            let square = |(i, c): (usize, &f64)| format!("sqr(x{} - ({c:?}))", i + 1);
            let squares = sum(ball.centre_slice().iter().enumerate().map(square).collect());
            Some(format!("sqrt({squares}) - {:?}", ball.r()))
        }
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given_slice();
            let largest = normal.iter().fold(0.0_f64, |largest, n| largest.max(n.abs()));
            // So that no square overflows, nor is too small to count. A power of two rounds nothing, and
            // where a product underflows, it is a step of the formula.
            let scaled = |x: f64| match largest {
                large if large > 1e100 => format!("({x:?})*{:?}", 0.5_f64.powi(600)),
                small if small < 1e-100 => format!("({x:?})*{:?}", 2.0_f64.powi(600)),
                _ => format!("({x:?})"),
            };
            let product = |(i, n): (usize, &f64)| format!("{}*x{}", scaled(*n), i + 1);
            let products = sum(normal.iter().enumerate().map(product).collect());
            let squares = sum(normal.iter().map(|n| format!("sqr({})", scaled(*n))).collect());
            let at = scaled(offset);
            // The half-space is normal·x ≤ offset.
            Some(format!("({products} - {at})/sqrt({squares})"))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use tautline::{Ball, HalfSpace};
    use tautline_chance::{Random, seed};

    use super::distance;
    use crate::Shape;

    fn half_space(normal: &[f64], offset: f64) -> Shape {
        Shape::HalfSpace(HalfSpace::from_slice(normal, offset).expect("a normal"))
    }

    /// The distance is Euclidean, whatever the length of the normal: `(n·x − b)/|n|`.
    #[test]
    fn the_distance_from_a_half_space_does_not_depend_on_the_length_of_its_normal() {
        let mut random = Random(seed(7));
        for case in 0..200 {
            let length = 10.0_f64.powi([case % 13 - 6, -300, -162, 160, 300][case as usize % 5]);
            let angle = random.between(0.0, 6.0);
            let (unit, height) = ([angle.cos(), angle.sin()], random.between(-3.0, 3.0));
            let wall = half_space(&unit.map(|n| n * length), height * length);
            let text = distance(&wall).expect("a normal");
            let at = [random.between(-5.0, 5.0), random.between(-5.0, 5.0)];
            let names = [("x1", at[0]), ("x2", at[1])];
            let text =
                names.iter().fold(text, |text, (name, x)| text.replace(name, &format!("({x:?})")));
            let found = tautline::formula::number(&text, &[]).expect("a number");
            let expected = unit[0] * at[0] + unit[1] * at[1] - height;
            // A dozen roundings of numbers up to 10.
            assert!((found - expected).abs() < 1e-14, "{text}: {found} for {expected}");
        }
    }

    /// Nothing typed is rounded: `3 x₁ ≤ 10¹⁶` begins at 10¹⁶/3, and the double next to it is not there.
    #[test]
    fn the_numbers_of_a_half_space_are_those_of_its_distance() {
        for scale in [1.0, 2.0_f64.powi(700), 0.5_f64.powi(700)] {
            let wall = half_space(&[3.0 * scale], 1e16 * scale);
            let text = distance(&wall).expect("a normal");
            // 3 · 3333333333333334 = 10¹⁶ + 2.
            let text = text.replace("x1", "3333333333333334");
            let found = tautline::formula::number(&text, &[]).expect("a number");
            assert_eq!(found, 2.0 / 3.0, "{text}");
        }
        // Whatever the size of the entries, δ is n·x/|n|.
        for (normal, x, expected) in [
            ([1e200, 5e-324], ["(3)", "(7)"], 3.0),
            ([1.7e308, 1.7e308], ["(1)", "(0)"], 0.5_f64.sqrt()),
            ([5e-324, 0.0], ["(3)", "(7)"], 3.0),
        ] {
            let wall = half_space(&normal, 0.0);
            let text = distance(&wall).expect("a normal");
            let text = text.replace("x1", x[0]).replace("x2", x[1]);
            let found = tautline::formula::number(&text, &[]).expect("a number");
            // Half a dozen roundings.
            assert!((found / expected - 1.0).abs() < 2e-15, "{text}: {found}");
        }
    }

    /// Positive outside, negative inside.
    #[test]
    fn the_distance_from_a_ball_is_that_of_its_surface() {
        let ball = |r| Shape::Ball(Ball::from_slice(&[1.0, -2.0], r).expect("a radius"));
        assert_eq!(distance(&ball(0.0)), None);
        let ball = ball(0.5);
        let text = distance(&ball).expect("a radius");
        for (x, expected) in [([1.0, -2.0], -0.5), ([4.0, 2.0], 4.5), ([1.0, -1.5], 0.0)] {
            let text =
                text.replace("x1", &format!("{:?}", x[0])).replace("x2", &format!("({:?})", x[1]));
            assert_eq!(tautline::formula::number(&text, &[]), Ok(expected), "{text}");
        }
    }
}
