//! The obstacles of a file, as a factor of the metric.

use std::ops::Range;

use tautline::{ANY, Shape};

use crate::{
    Diagnostic,
    file::{
        ProblemFile,
        expression::Text,
        obstacles::{ObstaclesFile, RegionFile},
        set::SetFile,
    },
    reading::{
        numbers::Numbers,
        pieces::{Draft, drafts},
    },
};

/// The distance from a region.
pub(crate) enum Distance<'f> {
    /// The text of an expression.
    Own(String),
    /// An expression of the file.
    Given(&'f Text),
}

/// The obstacles of a file.
pub(crate) struct Obstacles<'f> {
    pub(crate) distances: Vec<Distance<'f>>,
    /// The factor of the metric, an expression of the distances, as [`factor`] writes it.
    pub(crate) factor: String,
    /// The place of the regions.
    pub(crate) place: Range<usize>,
}

/// Reads the section `[obstacles]`.
pub(crate) fn obstacles<'f>(
    problem: &'f ProblemFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<Option<Obstacles<'f>>, Diagnostic> {
    let Some(section) = &problem.obstacles else { return Ok(None) };
    let ObstaclesFile { regions, margin } = section.get_ref();
    let margin = numbers.between(margin, 0.0, f64::INFINITY)?;
    let mut distances = Vec::new();
    for region in regions.get_ref() {
        let set = match region {
            RegionFile::Ball(ball) => SetFile::Ball(ball.clone()),
            RegionFile::HalfSpace(side) => SetFile::HalfSpace(side.clone()),
            RegionFile::Negative(text) => {
                distances.push(Distance::Given(text));
                continue;
            }
        };
        for Draft { shape, places } in drafts(&set, numbers, dimension)? {
            let text = shape.ok().as_ref().and_then(distance).ok_or_else(|| {
                let place = places.last().cloned().unwrap_or(regions.span());
                Diagnostic::new("an obstacle without inside", place)
                    .label("expected a positive radius, or a normal that is not 0")
            })?;
            distances.push(Distance::Own(text));
        }
    }
    let factor = factor(distances.len(), margin);
    Ok(Some(Obstacles { distances, factor, place: regions.span() }))
}

/// Returns the text of `1 + Σₖ (m/δₖ)²` for so many distances, which a
/// [weight](tautline::formula::Written::Weighted) calls `u1`, `u2`, …. By the logarithm it is undefined
/// for `δ ≤ 0`, so that a search refuses a step into the region.
pub(crate) fn factor(count: usize, margin: f64) -> String {
    let repulsion = |number: usize| format!(" + exp(-2*ln(u{number}/{margin:?}))");
    "1".to_owned() + &(1..=count).map(repulsion).collect::<String>()
}

/// Returns the text of the distance of `x` from a ball or a half-space, negative inside. `None` if it has
/// no inside, and for other sets.
pub(crate) fn distance(shape: &Shape<ANY>) -> Option<String> {
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
    use tautline::{ANY, Ball, HalfSpace, Shape};
    use tautline_chance::{Random, seed};

    use super::distance;

    fn half_space(normal: &[f64], offset: f64) -> Shape<ANY> {
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
