//! The box in which an audit draws samples.

use tautline::{Domain, Formula, SVector};
use tautline_kit::Region;
use tautline_problem::Question;

use crate::answer::Place;

/// The space around the sets, as a share of the longest edge of the box around them.
const MARGIN: f64 = 0.25;

/// Returns the box in which samples are drawn: that of the file; or the largest cube in the ball
/// of the file; or one period; or the box around the sets, with a margin; or `[−1, 1]^D`.
pub(crate) fn choose<const D: usize>(
    question: &Question,
    formula: &Formula<D>,
) -> (Region<D>, Place) {
    let of_the_file = || {
        let [lower, upper] = question.audit_region()?;
        Some((box_between(lower, upper)?, "[audit] region"))
    };
    let in_the_ball = || {
        let (centre, radius) = question.ball_of_constants()?;
        let centre = point::<D>(&centre);
        Some((cube(&centre, radius / (D as f64).sqrt())?, "the largest cube in [certify] within"))
    };
    let around = question.extents().and_then(|[low, high]| with_margin::<D>(&low, &high));
    let period = || Some((period(formula, around.as_ref())?, "one period of the formula"));
    let of_the_sets = || Some((around?, "the box around the sets, and a quarter more"));
    let chosen = of_the_file().or_else(in_the_ball).or_else(period).or_else(of_the_sets);
    let (region, why) = chosen.unwrap_or_else(|| {
        let why = "the file has neither [audit] region nor [from] and [to]";
        (Region::cell([-1.0; D], [1.0; D]), why)
    });
    (region, place(&region, why))
}

/// Returns a box, and why it is this one.
pub(crate) fn place<const D: usize>(region: &Region<D>, why: &str) -> Place {
    let corner = |share| region.at(&SVector::repeat(share)).as_slice().to_vec();
    Place { lower: corner(0.0), upper: corner(1.0), why: why.to_owned() }
}

/// Returns the centre and the radius of the largest ball in a box.
pub(crate) fn largest_ball<const D: usize>(region: &Region<D>) -> (Vec<f64>, f64) {
    let edges = region.at(&SVector::repeat(1.0)) - region.at(&SVector::repeat(0.0));
    (region.at(&SVector::repeat(0.5)).as_slice().to_vec(), 0.5 * edges.min())
}

/// Returns the largest cube in a ball.
pub(crate) fn cube<const D: usize>(centre: &SVector<f64, D>, half: f64) -> Option<Region<D>> {
    let half = SVector::repeat(half);
    Region::new(centre - half, centre + half).ok()
}

pub(crate) fn point<const D: usize>(x: &[f64]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| x.get(i).copied().unwrap_or(0.0))
}

fn box_between<const D: usize>(low: &[f64], high: &[f64]) -> Option<Region<D>> {
    Region::new(point::<D>(low), point::<D>(high)).ok()
}

fn with_margin<const D: usize>(low: &[f64], high: &[f64]) -> Option<Region<D>> {
    let longest = low.iter().zip(high).map(|(a, b)| b - a).fold(0.0, f64::max);
    // Two equal points have no extent.
    let margin = if longest > 0.0 { MARGIN * longest } else { 1.0 };
    let margin = SVector::repeat(margin);
    Region::new(point::<D>(low) - margin, point::<D>(high) + margin).ok()
}

/// Returns one period along each coordinate of a periodic formula. Along coordinates that it does
/// not depend on, the box is that around the sets.
fn period<const D: usize>(formula: &Formula<D>, around: Option<&Region<D>>) -> Option<Region<D>> {
    let space = Domain::space(formula);
    let sides = space.bounding_cell().sides();
    if !space.is_one_period() || sides.iter().all(|side| side.width() == 0.0) {
        return None;
    }
    let end = |share: f64, side: fn(usize, &[tautline::Interval]) -> f64, other: f64| {
        SVector::<f64, D>::from_fn(|i, _| {
            if sides[i].width() > 0.0 {
                return side(i, sides);
            }
            around.map_or(other, |around| around.at(&SVector::repeat(share))[i])
        })
    };
    Region::new(end(0.0, |i, s| s[i].lo(), -1.0), end(1.0, |i, s| s[i].hi(), 1.0)).ok()
}
