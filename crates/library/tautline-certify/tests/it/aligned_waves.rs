//! Formulas with nearly commensurate waves: their constants on all of space hold where phases align.
//!
//! `cos(0.1 x)` and `cos(0.5 x)` look as if one number were five times the other. As doubles they
//! are not, and far out the phases drift apart: at `10¹⁷` the sum of `3`, the first and minus the
//! second is nearly 5, which it never is below `10¹⁵`. Random points do not find such places.
//! Continued fractions do: the remainders of Euclid's algorithm for two wave numbers `a` and `s` are
//! `|q s − p a|` for the convergents `p/q` of `s/a`, exactly. Where a remainder times `x` is half a
//! turn, `q` times one phase and `p` times the other differ by half a turn. Among the doubles there,
//! those are taken at which a sum of the waves, or a derivative of it, is nearly extreme; the metric
//! is then evaluated to 192 bits.

use std::f64::consts::TAU;

use astro_float::{BigFloat, Consts, RoundingMode};
use nalgebra::{DMatrix, SMatrix, SVector, SymmetricEigen};
use tautline_certify::{Accuracy, CertifiedConstants, Domain};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::{
    parsed,
    precise::{Precise, Value},
    reference::Random,
};

/// `amplitude · cos(k·x + shift)`, possibly with a tail as a factor.
#[derive(Clone, Copy, Debug)]
struct Wave<const D: usize> {
    amplitude: f64,
    k: [f64; D],
    shift: f64,
    /// The slope of a factor `tanh(slope · x₁)`; 0 if there is none.
    slope: f64,
}

/// A function with limits along each line.
#[derive(Clone, Copy, Debug)]
enum Tail<const D: usize> {
    Tanh([f64; D]),
    Wall([f64; D]),
    Hill,
}

/// A matrix of waves and tails: `φ I`, or a full one whose entries beside the diagonal are a wave.
#[derive(Clone, Debug)]
struct Waves<const D: usize> {
    base: f64,
    waves: Vec<Wave<D>>,
    tail: Option<Tail<D>>,
    beside: Option<Wave<D>>,
}

fn product<S: Scalar, const D: usize>(k: &[f64; D], x: &SVector<S, D>) -> S {
    let terms = (0..D).filter(|&i| k[i] != 0.0).map(|i| x[i] * k[i]);
    terms.reduce(|sum, term| sum + term).unwrap_or_else(S::zero)
}

impl<const D: usize> Wave<D> {
    fn at<S: Scalar>(&self, x: &SVector<S, D>) -> S {
        let wave = (product(&self.k, x) + self.shift).cos() * self.amplitude;
        if self.slope == 0.0 { wave } else { wave * (x[0] * self.slope).tanh() }
    }
}

impl<const D: usize> Metric<D> for Waves<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let tail = match &self.tail {
            None => S::zero(),
            Some(Tail::Tanh(k)) => product(k, x).tanh() * 0.3,
            Some(Tail::Wall(k)) => 0.6 / (product(k, x).exp() + 1.0),
            Some(Tail::Hill) => (-x.iter().fold(S::zero(), |sum, x| sum + x.sqr())).exp() * 0.5,
        };
        let phi = self.waves.iter().fold(tail + self.base, |sum, wave| sum + wave.at(x));
        let beside = self.beside.map(|wave| wave.at(x));
        SMatrix::from_fn(|i, j| if i == j { phi } else { beside.unwrap_or_else(S::zero) })
    }
}

/// Returns a number that is nearly `p/q` times another: as a decimal, rounded, exactly, or one
/// double beside.
fn nearly_multiple(k: f64, p: u64, q: u64, random: &mut Random) -> f64 {
    let product = k * p as f64 / q as f64;
    let decimal = || format!("{product:.11e}").parse().expect("a number");
    match random.bits() % 8 {
        0..4 => decimal(),
        4 => product,
        5 => product.next_up(),
        6 => product.next_down(),
        // A power of two times the number is exact.
        _ => k * (1_u64 << (p % 4)) as f64,
    }
}

impl<const D: usize> Waves<D> {
    /// Returns whether the numbers of two waves seem to be multiples along an axis, and are not.
    fn is_deceptive(&self) -> bool {
        let seems = |a: f64, b: f64| (b / a).fract() == 0.0 && (b / a) * a == b && b % a != 0.0;
        let pair = |k: &[f64; D], l: &[f64; D]| (0..D).any(|i| seems(k[i], l[i]));
        self.waves.iter().any(|one| self.waves.iter().any(|other| pair(&one.k, &other.k)))
    }

    fn random(random: &mut Random) -> Self {
        const UNITS: [f64; 10] = [0.1, 0.2, 0.3, 0.7, 1.1, 0.06, 1.0 / 3.0, 2.3, 0.9, 1.0];
        let below = |n: usize, random: &mut Random| (random.bits() % n as u64) as usize;
        let mut waves = Vec::new();
        let forms = 1 + below(D.min(2), random);
        for _ in 0..forms {
            // A form along an axis, or in all coordinates.
            let axis = below(D + 1, random);
            let direction: [f64; D] = std::array::from_fn(|i| {
                let unit = UNITS[below(UNITS.len(), random)] * random.sign();
                if axis == D || axis == i { unit } else { 0.0 }
            });
            for count in 0..if forms == 2 { 2 } else { 2 + below(2, random) } {
                // The first wave is that of the form; the others are nearly small multiples of it.
                let p = [3, 5, 6, 7, 3, 5, 2, 9][below(8, random)];
                let q = [1, 1, 1, 1, 2, 3][below(6, random)];
                let mut multiple = random.clone();
                // All coordinates get the same kind of rounding, each of its own number.
                let k = direction.map(|k| {
                    let mut same = multiple.clone();
                    if count == 0 || k == 0.0 { k } else { nearly_multiple(k, p, q, &mut same) }
                });
                multiple.bits();
                *random = multiple;
                let amplitude = random.sign() * [0.5, 1.0, 0.75, 0.3][below(4, random)];
                let shift = [0.7, 1.9, 0.0][below(3, random)];
                let slope = if below(6, random) == 0 { 1.3 } else { 0.0 };
                waves.push(Wave { amplitude, k, shift, slope });
            }
        }
        let tail = match below(8, random) {
            0 => Some(Tail::Tanh(waves[0].k)),
            1 => Some(Tail::Wall(waves[0].k)),
            2 => Some(Tail::Hill),
            _ => None,
        };
        let beside =
            (D == 2 && below(3, random) == 0).then(|| Wave { amplitude: 0.25, ..waves[0] });
        let sum: f64 = waves.iter().map(|wave| wave.amplitude.abs()).sum();
        Self { base: sum + 1.5, waves, tail, beside }
    }
}

/// Exact products of doubles in turns: the fractional part of `a b/2π`, up to `10⁻¹⁵`.
struct Turns {
    per_turn: BigFloat,
}

/// With 320 bits, 190 are left of the fraction of a product below `2¹³⁰`.
const P: usize = 320;
const RM: RoundingMode = RoundingMode::None;

/// The largest coordinate that is tried.
const FARTHEST: f64 = f64::from_bits((1023 + 90) << 52);

impl Turns {
    fn new() -> Self {
        let pi = Consts::new().expect("memory").pi(P, RM);
        Self { per_turn: pi.mul(&BigFloat::from_f64(2.0, P), P, RM) }
    }

    fn of(&self, a: f64, b: f64) -> f64 {
        let product = BigFloat::from_f64(a, P).mul(&BigFloat::from_f64(b, P), P, RM);
        double(&product.div(&self.per_turn, P, RM).fract())
    }
}

/// Returns the number to about 60 bits, rounded to a double; 0 below `2⁻⁹⁰⁰`.
fn double(x: &BigFloat) -> f64 {
    let Some((words, _, sign, exponent, _)) = x.as_raw_parts().filter(|_| !x.is_zero()) else {
        return 0.0;
    };
    let bits = astro_float::WORD_BIT_SIZE as i32;
    let top = words.last().map_or(0.0, |&word| word as f64) * 2.0_f64.powi(-bits);
    let size = if exponent < -900 { 0.0 } else { top * 2.0_f64.powi(exponent) };
    if sign.is_negative() { -size } else { size }
}

/// Returns an enclosure of the number, `None` if nothing is known of it.
fn enclosed(x: Precise) -> Option<Interval> {
    let Value::Within(ball) = x.value() else { return None };
    // A word has at least 32 bits.
    let relative = Interval::new(1.0 - 2.0_f64.powi(-30), 1.0 + 2.0_f64.powi(-30)).ok()?;
    let tight = Interval::new(1.0 - 2.0_f64.powi(-50), 1.0 + 2.0_f64.powi(-50)).ok()?;
    let relative = if astro_float::WORD_BIT_SIZE == 64 { tight } else { relative };
    let least = Interval::new(-1e-200, 1e-200).ok()?;
    let radius = (Interval::point(double(&ball.radius)) * relative + least).magnitude();
    let around = Interval::new(-radius, radius).ok()?;
    Some(Interval::point(double(&ball.centre)) * relative + around)
}

/// Returns points along an axis at which phases align.
fn aligned<const D: usize>(
    metric: &Waves<D>,
    axis: usize,
    turns: &Turns,
    random: &mut Random,
) -> Vec<f64> {
    let along: Vec<&Wave<D>> = metric.waves.iter().filter(|wave| wave.k[axis] != 0.0).collect();
    let (mut near, mut far) = (Vec::new(), vec![random.between(-20.0, 20.0)]);
    for (j, wave) in along.iter().enumerate() {
        for other in &along[..j] {
            starts([wave, other], axis, random, &mut near, &mut far);
        }
    }
    // All where few turns of one phase are nearly few of the other, and some others.
    near.extend((0..4).map(|_| far[(random.bits() as usize) % far.len()]));
    near.retain(|x: &f64| x.abs() < FARTHEST);
    let mut best: [Vec<(f64, f64)>; 6] = Default::default();
    for start in near {
        let found = around(&along, axis, start, turns);
        best.iter_mut().zip(found).for_each(|(best, found)| best.push(found));
    }
    let mut points = Vec::new();
    for mut best in best {
        best.sort_unstable_by(|a, b| b.0.total_cmp(&a.0));
        points.extend(best.iter().take(2).map(|&(_, x)| x));
    }
    points.sort_unstable_by(f64::total_cmp);
    points.dedup();
    points
}

/// Adds places where two phases are both at multiples of a quarter turn, or both within a step of
/// the search around the place.
///
/// A remainder of Euclid's algorithm for the wave numbers `A` and `B` is `r = c A + d B` with integers,
/// so the phases `A x + α` and `B x + β` satisfy `c (A x + α) + d (B x + β) = r x + c α + d β`.
fn starts<const D: usize>(
    [wave, other]: [&Wave<D>; 2],
    axis: usize,
    random: &mut Random,
    near: &mut Vec<f64>,
    far: &mut Vec<f64>,
) {
    let shift = |wave: &Wave<D>| wave.shift * wave.k[axis].signum();
    let (mut a, mut b) = (wave.k[axis].abs(), other.k[axis].abs());
    let (mut of_a, mut of_b) = ([1.0, 0.0], [0.0, 1.0]);
    while b > 0.0 {
        let rest = a % b;
        let quotient = ((a - rest) / b).round();
        let of_rest = [0, 1].map(|k| of_a[k] - quotient * of_b[k]);
        (a, b, of_a, of_b) = (b, rest, of_b, of_rest);
        // The remainder a is c A + d B.
        let [c, d] = of_a;
        let places = if c.abs().max(d.abs()) <= 32.0 { &mut *near } else { &mut *far };
        for quarters in 0..4 {
            let whole = (random.bits() % 5) as f64 - 2.0;
            let turn = f64::from(quarters) / 4.0 + whole;
            places.push((TAU * turn - c * shift(wave) - d * shift(other)) / a);
        }
    }
}

/// Returns the largest and the least values of the waves and of both derivatives at a thousand
/// doubles near `start`, and where they are. Tails count as their limits.
fn around<const D: usize>(
    along: &[&Wave<D>],
    axis: usize,
    start: f64,
    turns: &Turns,
) -> [(f64, f64); 6] {
    let ulp = (start.abs().next_up() - start.abs()).max(f64::MIN_POSITIVE);
    let fastest = along.iter().map(|wave| wave.k[axis].abs()).fold(0.0, f64::max);
    // A step of about 0.38 turns of the fastest wave, or a multiple of the last place.
    let golden = 0.381_966 * TAU / fastest;
    let step = ulp * (golden / ulp).round().max(1.0);
    let angles: Vec<[f64; 2]> = along
        .iter()
        .map(|wave| [turns.of(wave.k[axis], start), turns.of(wave.k[axis], step)])
        .collect();
    let mut best = [(f64::NEG_INFINITY, start); 6];
    for count in 0..1000 {
        let count = f64::from(count);
        let x = start + step * count;
        let mut sums = [0.0; 3];
        for (wave, [at, by]) in along.iter().zip(&angles) {
            let (sin, cos) = (TAU * (at + by * count) + wave.shift).sin_cos();
            let sign = if wave.slope == 0.0 { 1.0 } else { start.signum() };
            let (a, k) = (wave.amplitude * sign, wave.k[axis]);
            sums[0] += a * cos;
            sums[1] += a * k * sin;
            sums[2] += a * k * k * cos;
        }
        for (best, value) in best.iter_mut().zip(sums.iter().flat_map(|&sum| [sum, -sum])) {
            if value > best.0 {
                *best = (value, x);
            }
        }
    }
    best
}

/// `H` and its derivatives at a point, enclosed.
struct At<const D: usize> {
    h: SMatrix<Interval, D, D>,
    first: [SMatrix<Interval, D, D>; D],
    second: [[SMatrix<Interval, D, D>; D]; D],
}

impl<const D: usize> At<D> {
    fn new(formula: &Formula<D>, x: &[f64; D]) -> Option<Self> {
        Precise::forget_all();
        let variables = Jet2::variables(&x.map(Precise::constant));
        let gram = formula.gram(&SVector::from(variables));
        let all = |of: &dyn Fn(&Jet2<Precise, D>) -> Precise| {
            let entries = gram.map(|entry| enclosed(of(&entry)));
            entries.iter().all(Option::is_some).then(|| entries.map(|x| x.expect("known")))
        };
        let mut second = [[SMatrix::repeat(Interval::point(0.0)); D]; D];
        let mut first = [SMatrix::repeat(Interval::point(0.0)); D];
        for k in 0..D {
            first[k] = all(&|entry| entry.first(k))?;
            for l in 0..D {
                second[k][l] = all(&|entry| entry.second(k, l))?;
            }
        }
        Some(Self { h: all(&|entry| entry.value())?, first, second })
    }

    /// Returns enclosures of quotients that are at least `c₁` and at most `c₂`, `L_H` and `M_H`, in
    /// this order; each is the constant at this point, as far as a few steps find it.
    fn quotients(&self) -> [Interval; 4] {
        let middle = |m: &SMatrix<Interval, D, D>| m.map(Interval::midpoint);
        let [least, greatest] = [-1.0, 1.0].map(|sign| {
            let (_, u) = top(&(middle(&self.h) * sign));
            form(&self.h, &u) / square(&u)
        });
        let [mut slope, mut bend] = [Interval::point(0.0); 2];
        for axis in 0..D {
            let mut v = SVector::<f64, D>::zeros();
            v[axis] = 1.0;
            let mut w = v;
            for _ in 0..4 {
                let u = extreme(
                    &(0..D).fold(SMatrix::zeros(), |sum, k| sum + middle(&self.first[k]) * v[k]),
                );
                v = SVector::from_fn(|k, _| form(&self.first[k], &u).midpoint());
                let found = (0..D)
                    .fold(Interval::point(0.0), |sum, k| sum + form(&self.first[k], &u) * v[k])
                    / (square(&v).sqrt() * square(&u));
                slope = larger(slope, found);
                v = v.try_normalize(0.0).unwrap_or(v);
                let u = extreme(&(0..D * D).fold(SMatrix::zeros(), |sum, at| {
                    let (k, l) = (at / D, at % D);
                    sum + middle(&self.second[k][l]) * (w[k] * w[l])
                }));
                let of = SMatrix::<Interval, D, D>::from_fn(|k, l| form(&self.second[k][l], &u));
                w = extreme(&middle(&of));
                bend = larger(bend, form(&of, &w) / (square(&w) * square(&u)));
            }
        }
        [least, greatest, slope, bend]
    }
}

fn form<const D: usize>(matrix: &SMatrix<Interval, D, D>, u: &SVector<f64, D>) -> Interval {
    let mut sum = Interval::point(0.0);
    for i in 0..D {
        for j in 0..D {
            sum += matrix[(i, j)] * u[i] * u[j];
        }
    }
    sum
}

fn square<const D: usize>(u: &SVector<f64, D>) -> Interval {
    u.iter().fold(Interval::point(0.0), |sum, &u| sum + Interval::point(u).sqr())
}

/// Returns the absolute value of the number that is farther from 0.
fn larger(most: Interval, x: Interval) -> Interval {
    let size = Interval::new(x.mignitude(), x.magnitude()).unwrap_or(most);
    if size.lo() > most.lo() { size } else { most }
}

/// Returns the largest eigenvalue and its eigenvector, up to rounding.
fn top<const D: usize>(matrix: &SMatrix<f64, D, D>) -> (f64, SVector<f64, D>) {
    let eigen = SymmetricEigen::new(DMatrix::from_fn(D, D, |i, j| matrix[(i, j)]));
    let index = eigen.eigenvalues.imax();
    (eigen.eigenvalues[index], SVector::from_fn(|i, _| eigen.eigenvectors[(i, index)]))
}

/// Returns an eigenvector of the eigenvalue that is largest in absolute value, up to rounding.
fn extreme<const D: usize>(matrix: &SMatrix<f64, D, D>) -> SVector<f64, D> {
    let ((up, u), (down, v)) = (top(matrix), top(&-matrix));
    if up >= down { u } else { v }
}

/// What a campaign found.
#[derive(Debug, Default)]
struct Outcome {
    /// The formulas with constants on all of space.
    proved: usize,
    /// Those with a sample within three percent of each of `c₁`, `c₂` and `L_H`.
    close: usize,
    points: usize,
    /// Those with two waves of which one number is a multiple of the other as far as doubles tell,
    /// and is not.
    deceptive: usize,
    wrong: Vec<String>,
}

/// Proves the constants of random formulas, and evaluates these where phases align.
fn campaign<const D: usize>(formulas: u32, seed: u64, outcome: &mut Outcome) {
    let (mut random, turns) = (Random(seed), Turns::new());
    for case in 0..formulas {
        let metric = Waves::<D>::random(&mut random);
        try_one(&metric, &format!("D = {D}, case {case}"), &turns, &mut random, outcome);
    }
}

fn try_one<const D: usize>(
    metric: &Waves<D>,
    name: &str,
    turns: &Turns,
    random: &mut Random,
    outcome: &mut Outcome,
) {
    let formula = Formula::record(metric).expect("no comparison");
    let space = Domain::space(&formula);
    let accuracy = Accuracy { tolerance: 3e-3, budget: 1000 };
    let proved = CertifiedConstants::within_budget(&formula, &space, accuracy);
    let Some(proved) = proved.ok().filter(|_| space.is_all_of_space()) else { return };
    let m_h = proved.m_h().map_or(f64::INFINITY, |m_h| m_h.upper);
    let bounds = [proved.c1().lower, proved.c2().upper, proved.l_h().upper, m_h];
    outcome.proved += 1;
    outcome.deceptive += usize::from(metric.is_deceptive());
    let (mut least, mut most) = (f64::INFINITY, [0.0_f64; 3]);
    for axis in 0..D {
        for aligned in aligned(metric, axis, turns, random) {
            let other = if random.bits() & 3 == 0 { 9.0 } else { 0.0 };
            let mut x = [0; D].map(|_| random.between(-other, other));
            x[axis] = aligned;
            let Some(at) = At::new(&formula, &x) else { continue };
            let found = at.quotients();
            outcome.points += 1;
            let holds = |k: usize| match k {
                0 => !(found[0].hi() < bounds[0]),
                _ => !(found[k].lo() > bounds[k]),
            };
            let wrong = (0..4).find(|&k| !holds(k));
            if let Some(k) = wrong {
                let constant = ["c₁", "c₂", "L_H", "M_H"][k];
                let (found, bound) = (found[k], bounds[k]);
                outcome.wrong.push(format!(
                    "{name}: {constant} is {found:?}, not {bound}, at {x:?} for {metric:?}"
                ));
                return;
            }
            least = least.min(found[0].hi());
            for (most, found) in most.iter_mut().zip(&found[1..]) {
                *most = most.max(found.lo());
            }
        }
    }
    let is_close = most[0] > 0.97 * bounds[1] && most[1] > 0.97 * bounds[2];
    outcome.close += usize::from(is_close && least < 1.03 * bounds[0]);
}

/// With `TAUTLINE_CASES=250` these are ten thousand formulas.
#[test]
fn constants_on_all_of_space_hold_where_phases_align() {
    let mut outcome = Outcome::default();
    campaign::<1>(tautline_chance::cases(20), tautline_chance::seed(71), &mut outcome);
    campaign::<2>(tautline_chance::cases(14), tautline_chance::seed(72), &mut outcome);
    campaign::<3>(tautline_chance::cases(6), tautline_chance::seed(73), &mut outcome);
    let Outcome { proved, close, points, deceptive, wrong } = outcome;
    println!("{proved} formulas, {deceptive} of them deceptive, {close} close, {points} points");
    assert!(wrong.is_empty(), "{} wrong: {:#?}", wrong.len(), &wrong[..wrong.len().min(4)]);
    // Otherwise the test would not see a mistake.
    let formulas = tautline_chance::cases(40) as usize;
    let is_hard = 6 * deceptive > proved && 5 * close > proved;
    assert!(10 * proved > 9 * formulas && is_hard, "{proved} {deceptive} {close} of {formulas}");
}

/// The double `0.5` is not five times the double `0.1`.
#[test]
fn a_decimal_multiple_of_a_wave_number_is_not_a_multiple() {
    let formula = parsed::<1>("3 + cos(0.1*x1) - cos(0.5*x1) I");
    let space = Domain::space(&formula);
    assert!(space.is_all_of_space());
    let accuracy = Accuracy { tolerance: 1e-3, budget: 100_000 };
    let proved = CertifiedConstants::new(&formula, &space, accuracy).expect("constants");
    let far = f64::from_bits(0x4379_21fb_5444_9f08);
    let found = At::new(&formula, &[far]).expect("a value").quotients();
    assert!(found[1].lo() > 4.999_999 && found[1].hi() <= proved.c2().upper, "{found:?}");
    // Nothing is lost: the four constants are those of independent phases.
    let m_h = proved.m_h().expect("second derivatives");
    for (found, exact) in [(proved.c1(), 1.0), (proved.c2(), 5.0), (proved.l_h(), 0.6), (m_h, 0.26)]
    {
        // The doubles 0.1 and 0.5 are the decimals to within 10⁻¹⁶.
        assert!(found.lower <= exact * (1.0 + 1e-15) && exact * (1.0 - 1e-15) <= found.upper);
    }
    assert!(proved.c1().lower > 0.998 && proved.c2().upper < 5.01, "{proved:?}");
    assert!(proved.l_h().upper < 0.6012 && m_h.upper < 0.2606, "{proved:?}");
}
