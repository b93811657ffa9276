//! Random fields of obstacles, and how often each method finds the shortest way through.

use tautline::{
    Rule, SVector, Starts,
    gallery::{Obstacle, SoftObstacles},
};
use tautline_checks::adversary::SplitMix;

use super::{
    method::{Method, Setting},
    task::{Answer, Task},
};
use crate::{Failure, parallel};

/// The seed of all problems.
pub(crate) const SEED: u64 = 12;

/// A group of problems.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Group {
    /// The dimension `D`.
    pub(crate) dimension: usize,
    /// Where the obstacles are.
    obstacles: Obstacles,
    /// The number of problems.
    pub(crate) problems: usize,
}

/// Where the obstacles are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Obstacles {
    /// Four of them, near the straight line.
    Few,
    /// Thirty smaller ones, all over the box.
    Many,
}

/// All groups.
pub(crate) const GROUPS: [Group; 4] = [
    Group { dimension: 2, obstacles: Obstacles::Few, problems: 20 },
    Group { dimension: 2, obstacles: Obstacles::Many, problems: 20 },
    Group { dimension: 3, obstacles: Obstacles::Few, problems: 12 },
    Group { dimension: 6, obstacles: Obstacles::Few, problems: 12 },
];

impl Group {
    /// Returns the name of the group in tables and data.
    pub(crate) fn name(self) -> String {
        let number = match self.obstacles {
            Obstacles::Few => 4,
            Obstacles::Many => 30,
        };
        format!("{number} obstacles, D = {}", self.dimension)
    }
}

/// The number of chords of all sequences.
pub(crate) const N: usize = 64;

/// The number of chords with which the shortest curve is measured. Its error is 64 times smaller than
/// with [`N`].
const FINE: usize = 512;

/// The relative errors of all methods on one problem, in the order of [`METHODS`]; `None` where a
/// method has no answer.
type Errors = Vec<Option<f64>>;

/// The methods that are counted. Two that are left out are those of the same sequences.
pub(crate) const METHODS: [Method; 15] = [
    Method::Trapezoidal,
    Method::Classes,
    Method::LeftEndpoint,
    Method::FromTheLine,
    Method::LbfgsPoints,
    Method::LbfgsSobolev,
    Method::SobolevGradient,
    Method::DynamicProgramming,
    Method::GaussNewton,
    Method::EqualSpeeds,
    Method::Shooting,
    Method::Collocation,
    Method::LatticePath,
    Method::FirstOrderMarch,
    Method::SecondOrderMarch,
];

/// Returns the setting of a method: as usual, with fewer chords, and with shots that are as exact as
/// the counts need.
fn setting(method: Method, dimension: usize) -> Setting {
    match method.usual(dimension) {
        Setting::Chords(_) => Setting::Chords(N),
        _ if method == Method::Shooting => Setting::Tolerance(1e-6),
        other => other,
    }
}

/// Draws the problems of each group, and lets all methods solve them.
pub(crate) fn errors_by_group() -> Result<Vec<(Group, Vec<Errors>)>, Failure> {
    let mut seeds = SplitMix::new(SEED);
    let of_group = |group: Group| {
        let seeds: Vec<u64> = (0..group.problems).map(|_| seeds.bits()).collect();
        let errors = parallel::map(&seeds, |&seed| match group.dimension {
            2 => errors::<2>(group.obstacles, seed),
            3 => errors::<3>(group.obstacles, seed),
            _ => errors::<6>(group.obstacles, seed),
        });
        Ok((group, errors.into_iter().collect::<Result<_, Failure>>()?))
    };
    GROUPS.into_iter().map(of_group).collect()
}

/// Draws two points and obstacles.
fn draw<const D: usize>(
    obstacles: Obstacles,
    random: &mut SplitMix,
) -> Result<Task<SoftObstacles<D>, D>, Failure> {
    let mut end = |side: f64| {
        let mut x = vector::<D>(random, 0.3);
        x[0] += 1.5 * side;
        x
    };
    let ends = [end(-1.0), end(1.0)];
    let [x, y] = ends;
    let near = |along: f64, random: &mut SplitMix| Obstacle {
        centre: x + (y - x) * along + vector(random, 0.8),
        height: random.between(0.0, 10.0),
        width: random.between(0.3, 0.6),
    };
    let anywhere = |random: &mut SplitMix| Obstacle {
        centre: vector(random, 1.8),
        height: random.between(0.0, 15.0),
        width: random.between(0.15, 0.3),
    };
    let drawn = match obstacles {
        Obstacles::Few => (1..5).map(|k| near(0.2 * f64::from(k), random)).collect(),
        Obstacles::Many => (0..30).map(|_| anywhere(random)).collect(),
    };
    let reach = SVector::repeat(2.4);
    Ok(Task { metric: SoftObstacles::new(drawn)?, ends, corners: [-reach, reach] })
}

/// Returns a random vector in the cube `[−size, size]^D`.
fn vector<const D: usize>(random: &mut SplitMix, size: f64) -> SVector<f64, D> {
    SVector::from_fn(|_, _| random.between(-size, size))
}

/// Returns the relative errors of all methods on one problem.
fn errors<const D: usize>(obstacles: Obstacles, seed: u64) -> Result<Errors, Failure> {
    let task = draw::<D>(obstacles, &mut SplitMix::new(seed))?;
    let answers: Vec<Option<Answer<D>>> =
        METHODS.iter().map(|&method| task.answer(method, setting(method, D)).ok()).collect();
    let distance = shortest(&task, &answers)?;
    let error = |answer: &Answer<D>| answer.distance / distance - 1.0;
    Ok(answers.iter().map(|answer| answer.as_ref().map(error)).collect())
}

/// Returns the length of the shortest of all curves that were found, in `m`: from each sequence and
/// path along a lattice a fine grid is searched, and a geodesic has its own length.
fn shortest<const D: usize>(
    task: &Task<SoftObstacles<D>, D>,
    answers: &[Option<Answer<D>>],
) -> Result<f64, Failure> {
    let found = || answers.iter().flatten();
    let starts = found().filter_map(|answer| answer.sequence.clone()).collect();
    // Coarser grids lose narrow ways.
    let fine = task.solve(Rule::TRAPEZOIDAL, FINE, Starts::OnTheGrid(starts))?;
    if !fine.minimum().is_local_minimum() {
        return Err(Failure::Unfinished(format!("the reference: {:?}", fine.minimum().stop)));
    }
    let geodesics = METHODS.iter().zip(answers).filter_map(|(method, answer)| {
        let is_exact = matches!(method, Method::Shooting | Method::Collocation);
        answer.as_ref().filter(|_| is_exact).map(|answer| answer.distance)
    });
    Ok(geodesics.fold(fine.discrete_energy().sqrt(), f64::min))
}
