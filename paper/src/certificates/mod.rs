//! Certificates of distances over the gallery: one pair of ends for each metric.

pub(crate) mod second_checker;

use std::{ops::ControlFlow, time::Instant};

use tautline::{
    Ends, KnownDistance, Metric, Options, Point, Problem, Rule, SVector, Shape,
    check::{AnyCertificate, Certificate, Level, Verdict},
    distance::{Ended, Wanted},
    gallery::*,
};

use crate::Failure;

/// The number of chords of the lines, which is that of `tautline certify`.
const CHORDS: usize = 256;

/// A metric of the gallery, with two points.
pub(crate) struct Pair {
    /// The name of the metric.
    pub(crate) metric: &'static str,
    /// The dimension.
    pub(crate) d: usize,
    /// The two points.
    pub(crate) ends: [Vec<f64>; 2],
    /// The distance, if the gallery knows it.
    pub(crate) known: Option<f64>,
    /// The wanted gap.
    pub(crate) gap: f64,
    search: Box<dyn Fn(f64) -> Result<Search, String>>,
}

/// A certificate that was found, and checked as it is read from its text.
pub(crate) struct Search {
    /// The text of the certificate.
    pub(crate) text: String,
    /// The same with one number changed, for each of [`CHANGES`].
    pub(crate) changed: Vec<String>,
    /// What it proves.
    pub(crate) verdict: Verdict,
    /// The number of cubes of all levels.
    pub(crate) cubes: usize,
    /// Why the search ended, unless the gap is as small as wanted.
    pub(crate) ended: Option<Ended>,
    /// The time for the line and the search, in seconds.
    pub(crate) search_seconds: f64,
    /// The time for the check without reading, in seconds.
    pub(crate) check_seconds: f64,
}

/// The numbers that are changed to see what a checker says.
pub(crate) const CHANGES: [&str; 3] = ["a value", "hi", "an end"];

impl Pair {
    /// Searches for a certificate and checks it.
    ///
    /// # Errors
    ///
    /// Why there is no certificate; [`Failure::Violated`] if it excludes the known distance.
    pub(crate) fn search(&self) -> Result<Result<Search, String>, Failure> {
        let found = (self.search)(self.gap);
        if let (Ok(found), Some(known)) = (&found, self.known) {
            let Verdict { lower, upper, .. } = found.verdict;
            // A closed form is computed with a few roundings, or by a quadrature.
            let rounding = 1e-12 * known;
            let upper = upper.unwrap_or(f64::INFINITY);
            if !(lower <= known + rounding && known - rounding <= upper) {
                let Self { metric, d, .. } = self;
                let message = format!("{metric}, D = {d}: {known} is not in [{lower}, {upper}]");
                return Err(Failure::Violated(message));
            }
        }
        Ok(found)
    }

    fn new<M: Metric<D> + 'static, const D: usize>(
        name: &'static str,
        metric: M,
        ends: [[f64; D]; 2],
        known: Option<f64>,
    ) -> Self {
        let gap = if D < 3 { 1e-3 } else { 1e-2 };
        Pair {
            metric: name,
            d: D,
            ends: ends.map(Vec::from),
            known,
            gap,
            search: Box::new(move |gap| search(&metric, ends, gap)),
        }
    }
}

fn search<const D: usize>(
    metric: &impl Metric<D>,
    [from, to]: [[f64; D]; 2],
    gap: f64,
) -> Result<Search, String> {
    let begun = Instant::now();
    let ends = Ends::points(from, to).map_err(|error| error.to_string())?;
    // One thread for the line; the search and the check use all.
    let options = Options { threads: 1, ..Options::default() };
    let line = Problem::new(metric, ends)
        .solve_with(Rule::TRAPEZOIDAL, CHORDS, &options)
        .map_err(|error| error.to_string())?;
    let found = line
        .certificate_with(Wanted::gap(gap), &mut |_| ControlFlow::Continue(()))
        .map_err(|error| error.to_string())?;
    let search_seconds = begun.elapsed().as_secs_f64();
    let text = found.certificate.to_string();
    let read = AnyCertificate::read(&text).map_err(|error| error.to_string())?;
    let begun = Instant::now();
    let verdict = read.check().map_err(|error| error.to_string())?;
    let check_seconds = begun.elapsed().as_secs_f64();
    Ok(Search {
        changed: changed(&found.certificate).map_err(|error| error.to_string())?,
        text,
        cubes: verdict.levels.iter().map(|(cubes, _)| cubes).sum(),
        verdict,
        ended: (found.ended != Ended::Reached).then_some(found.ended),
        search_seconds,
        check_seconds,
    })
}

/// Returns the certificate with one number changed: the value of `φ` at a node of the last level in
/// the middle of the curve, larger by a tenth of the distance; `hi`, smaller by a hundredth, so that
/// the curve is not below it; and a coordinate of the second end, farther by a tenth of `hi`.
fn changed<const D: usize>(
    certificate: &Certificate<D>,
) -> Result<Vec<String>, Box<dyn std::error::Error>> {
    let mut value = certificate.clone();
    if let (Some(level), Some(curve)) = (value.levels.last(), &certificate.curve) {
        let half = 0.5 * level.cubes().side();
        let middle = curve[curve.len() / 2] / half;
        let distance = |node: &[i32; D]| (middle - SVector::from(node.map(f64::from))).norm();
        let nodes = level.nodes().iter().enumerate();
        let nearest = nodes.min_by(|a, b| distance(a.1).total_cmp(&distance(b.1)));
        let mut values = level.values().clone();
        if let Some((node, _)) = nearest {
            values[0][node] += 0.1 * certificate.hi;
        }
        let last = value.levels.len() - 1;
        value.levels[last] = Level::new(last, level.cubes().clone(), values)?;
    }
    let mut hi = certificate.clone();
    hi.hi *= 0.99;
    let mut end = certificate.clone();
    if let Shape::Point(point) = &end.sets[1] {
        let mut position: SVector<f64, D> = *point.position();
        position[0] += 0.1 * certificate.hi;
        end.sets[1] = Shape::Point(Point::new(position)?);
    }
    Ok([value, hi, end].iter().map(ToString::to_string).collect())
}

/// Returns the ends for a sample of the gallery. If the metric is a [`KnownDistance`], it knows the
/// distance between them. In space the ends are near each other, since cubes are many.
fn ends<const D: usize>(id: &str) -> Result<[[f64; D]; 2], Failure> {
    let ends: [&[f64]; 2] = match id {
        "valleys_on_a_line" => [&[0.7], &[5.3]],
        "a_ramp" => [&[-1.9], &[1.3]],
        "valleys" => [&[1.1, 0.7], &[5.3, 1.3]],
        "valleys_in_space" => [&[0.7, 0.3, 0.2], &[2.1, 0.9, 0.7]],
        // The lens and the hills are known on rays from the centre.
        "a_lens" | "a_bump" | "a_hill" => [&[0.3, 0.1], &[1.8, 0.6]],
        "a_lens_in_space" => [&[0.3, 0.1, 0.2], &[0.9, 0.3, 0.6]],
        "soft_obstacles" => [&[-0.9, 0.3], &[1.7, 0.9]],
        "a_swirl" => [&[-0.9, 0.2], &[1.1, 0.3]],
        // The symmetry line x₁ = π/2 of the egg crate, and a grid line of the checkerboard.
        "an_egg_crate" => {
            [&[std::f64::consts::FRAC_PI_2, 3.3], &[std::f64::consts::FRAC_PI_2, 4.7]]
        }
        "a_checkerboard" => [&[0.1, 0.0], &[1.3, 0.0]],
        "two_channels" => [&[-1.1, 0.3], &[1.2, 1.7]],
        "rotating_anisotropy" => [&[-0.9, -0.7], &[1.1, 0.6]],
        "a_two_link_arm" => [&[0.7, 0.9], &[1.8, 2.3]],
        "coupled_cosines" => [&[0.3, 0.2, -0.3], &[0.8, 0.5, -0.7]],
        "a_patch_of_the_sphere" => [&[-0.4, 0.1], &[0.3, 0.3]],
        "sphere" => [&[-0.6, 0.1], &[0.5, 0.4]],
        "a_patch_of_hyperbolic_space" | "hyperbolic" => [&[-0.3, 0.1], &[0.2, 0.3]],
        "normal_distributions" | "Gaussian Fisher" => [&[-0.4, -0.3], &[0.6, 0.2]],
        "a_constant_matrix" | "a_separable_metric" | "a_shear" | "a_corrugated_sheet"
        | "sine_projections" | "a_tanh_decoder" => [&[-0.7, 0.3], &[1.1, 0.9]],
        _ => return Err(Failure::Violated(format!("the sample {id} has no ends"))),
    };
    let point = |end: &[f64]| {
        let wrong = |_| Failure::Violated(format!("the ends of {id} are in other dimensions"));
        <[f64; D]>::try_from(end).map_err(wrong)
    };
    Ok([point(ends[0])?, point(ends[1])?])
}

/// Returns the distance between the ends, if the metric knows it.
fn known<M: KnownDistance<D>, const D: usize>(metric: &M, ends: [[f64; D]; 2]) -> Option<f64> {
    let [x, y] = ends.map(SVector::from);
    metric.distance(&x, &y)
}

macro_rules! pairs {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
        exact $exact:expr $(, with $distances:ident)?;
    )*) => {
        vec![$({
            let (metric, ends) = ($metric?, ends::<$D>(stringify!($id))?);
            let known = pairs!(@known metric, ends $(, $distances)?);
            Pair::new($name, metric, ends, known)
        }),*]
    };
    (@known $metric:ident, $ends:ident, $distances:ident) => { known(&$metric, $ends) };
    (@known $metric:ident, $ends:ident) => { None };
}

/// Returns a pair for each metric of the gallery: the samples, and the metrics that have constants on
/// balls only.
pub(crate) fn pairs() -> Result<Vec<Pair>, Failure> {
    fn local<M: KnownDistance<2> + 'static>(id: &'static str, metric: M) -> Result<Pair, Failure> {
        let ends = ends::<2>(id)?;
        let known = known(&metric, ends);
        Ok(Pair::new(id, metric, ends, known))
    }
    let mut pairs = for_each_sample!(pairs);
    pairs.push(local("sphere", Sphere)?);
    pairs.push(local("hyperbolic", Hyperbolic)?);
    pairs.push(local("Gaussian Fisher", GaussianFisher)?);
    Ok(pairs)
}
