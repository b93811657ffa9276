//! `Region`: an obstacle, and metrics with obstacles.

use tautline::{
    ANY, Formula,
    formula::{Part, Weight, Written, WrittenError},
};

use crate::{Given, GivenError, Shape, given::check_coordinates};

/// A region that no curve enters.
#[derive(Clone, Debug)]
pub enum Region {
    /// A ball of positive radius, a half-space, or a box.
    Set(Shape),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(String),
    /// Where a function `f` of the coordinates is not positive, given as the metric `f I`.
    NegativeOf(Given),
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
    let mut functions = Vec::new();
    for region in regions {
        functions.push(match region {
            Region::Negative(text) => Ok(text.clone()),
            Region::NegativeOf(f) => Err(f.formula()?),
            Region::Set(shape) => {
                check_coordinates(shape, formula.dimension())?;
                let text = distance(shape, margin);
                Ok(text.ok_or(GivenError::NoInside { set: shape.name() })?)
            }
        });
    }
    let factor = factor(functions.len(), margin);
    fn part(text: &str) -> Part<'_> {
        Part { text, id: 0 }
    }
    let distances = functions.iter().map(|function| match function {
        Ok(text) => Weight::Text(part(text)),
        Err(formula) => Weight::Recorded((*formula).clone()),
    });
    let distances = distances.collect();
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

/// Returns the text of the distance of `x` from a ball, a half-space or a box, negative inside. `None` for a
/// ball of radius 0, a normal that is 0, and other sets.
///
/// The distance from a box has corners. Its text is smooth: with `s(t) = (t + √(t² + ε²))/2`, close to
/// `max(t, 0)`, it is `√(Σᵢ (s(xᵢ − uᵢ) + s(lᵢ − xᵢ))²) − c`, where `c` is its root at a corner. Since `s` is
/// convex, the root is at most `c` in the box, and the region is the box, rounded and grown by about
/// `m (D − 1)/(4 √D)`. For a margin `m` and `ε = m/2` it differs from the distance by
/// at most `m √D/2`.
#[must_use]
pub fn distance(shape: &Shape, margin: f64) -> Option<String> {
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
        Shape::AxisBox(solid) => {
            let [lower, upper] = solid.corner_slices();
            let square = (0.5 * margin).powi(2);
            let s = |t: f64| 0.5 * (t + (t * t + square).sqrt());
            let text = |t: String| format!("({t} + sqrt(sqr({t}) + {square:?}))/2");
            let (mut squares, mut corner) = (Vec::new(), 0.0);
            for (i, (l, u)) in lower.iter().zip(upper).enumerate() {
                let [beyond, before] =
                    [format!("(x{} - ({u:?}))", i + 1), format!("(({l:?}) - x{})", i + 1)];
                squares.push(format!("sqr({} + {})", text(beyond), text(before)));
                corner += (s(0.0) + s(l - u)).powi(2);
            }
            // Some roundings more, so that the corner is inside.
            Some(format!("sqrt({}) - {:?}", sum(squares), corner.sqrt() * (1.0 + 1e-12)))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use tautline::{AxisBox, Ball, HalfSpace};
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
            let text = distance(&wall, 0.1).expect("a normal");
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
            let text = distance(&wall, 0.1).expect("a normal");
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
            let text = distance(&wall, 0.1).expect("a normal");
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
        assert_eq!(distance(&ball(0.0), 0.1), None);
        let ball = ball(0.5);
        let text = distance(&ball, 0.1).expect("a radius");
        for (x, expected) in [([1.0, -2.0], -0.5), ([4.0, 2.0], 4.5), ([1.0, -1.5], 0.0)] {
            let text =
                text.replace("x1", &format!("{:?}", x[0])).replace("x2", &format!("({:?})", x[1]));
            assert_eq!(tautline::formula::number(&text, &[]), Ok(expected), "{text}");
        }
    }

    /// The text of a box is at most half the margin times `√D` off the distance, not positive in the box, and
    /// positive beyond the margin.
    #[test]
    fn the_text_of_a_box_is_close_to_its_distance() {
        let mut random = Random(seed(8));
        for case in 0..2000 {
            let margin = 10.0_f64.powi(-(case % 5));
            let lower = [random.between(-3.0, 0.0), random.between(-3.0, 0.0)];
            let upper = lower.map(|l| l + random.between(0.0, 2.0));
            let solid = Shape::AxisBox(AxisBox::from_slices(&lower, &upper).expect("ordered"));
            let text = distance(&solid, margin).expect("a box");
            // Inside, at a corner, and anywhere.
            let x = match case % 3 {
                0 => [0, 1].map(|i| lower[i] + (upper[i] - lower[i]) * random.between(0.0, 1.0)),
                1 => [lower[0], upper[1]],
                _ => [random.between(-5.0, 5.0), random.between(-5.0, 5.0)],
            };
            let names = [("x1", x[0]), ("x2", x[1])];
            let text =
                names.iter().fold(text, |text, (name, x)| text.replace(name, &format!("({x:?})")));
            let found = tautline::formula::number(&text, &[]).expect("a number");
            let beyond = |i: usize| (x[i] - upper[i]).max(lower[i] - x[i]).max(0.0);
            let exact = beyond(0).hypot(beyond(1));
            assert!(
                (found - exact).abs() <= 0.5 * margin * 2.0_f64.sqrt() + 1e-12,
                "{x:?} {solid:?}"
            );
            assert!(
                if exact == 0.0 { found <= 0.0 } else { exact < margin || found > 0.0 },
                "{x:?}"
            );
        }
    }
}
