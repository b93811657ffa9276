//! `Polygon`: the curve `γᵖˡ` through given points, with rigorous bounds on its energies and
//! length.

use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::{Formula, RecordError};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Enclosure, Interval, Kernel, Rigorous};

use super::{chord::Chord, pairwise_sum::PairwiseSum};

/// The polygon `γᵖˡ` through the points of a sequence, which are taken as exact doubles. The first
/// and the last point may be replaced by boxes.
///
/// With boxes it represents all polygons with ends in them, and the enclosures hold for each of
/// these. `K` is the kernel of the intervals.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`]. Every enclosure is that of
/// the recorded formula, by code that is compiled once for all dimensions.
///
/// ```
/// use tautline_certify::Polygon;
/// use tautline_discretizations::PointSequence;
/// use tautline_metrics::gallery::Valleys;
///
/// // Along x₁ from 0 to 1: ∫ f² = 9/2 − 4 sin 1 + ¼ sin 2, where f = 2 − cos x₁.
/// let line = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 4)?;
/// let energy = Polygon::new(&line).energy(&Valleys);
/// assert!(energy.contains(1.361_440_417_474_834_4) && energy.width() < 1e-12);
/// # Ok::<(), tautline_discretizations::SequenceError>(())
/// ```
#[derive(Clone, Debug)]
#[doc(alias = "interpolation")]
pub struct Polygon<'a, const D: usize, K = Rigorous> {
    sequence: &'a PointSequence<D>,
    first: Vec<Enclosure<K>>,
    last: Vec<Enclosure<K>>,
}

/// Why there are no enclosures.
pub(super) enum NotEnclosed {
    /// The formula has branches or too many steps.
    NotRecorded(RecordError),
    /// The metric is undefined somewhere on this chord; chords are counted from 0.
    Undefined { chord: usize },
    /// The metric is not proved to be positive definite on this chord.
    Indefinite { chord: usize },
}

/// Returns the point as a box.
fn point<K: Kernel>(x: &[f64]) -> Vec<Enclosure<K>> {
    x.iter().map(|&x| Enclosure::point(x)).collect()
}

impl<'a, const D: usize> Polygon<'a, D> {
    /// Joins the points of `sequence` by straight lines.
    #[must_use]
    pub fn new(sequence: &'a PointSequence<D>) -> Self {
        let [first, last] = [0, sequence.n().get()].map(|k| point(sequence.row(k)));
        Polygon { sequence, first, last }
    }

    /// Returns the polygon with boxes for the first and the last point, in `ℓ`. If a box is undefined,
    /// so is every result.
    ///
    /// # Panics
    ///
    /// If a box has another dimension than the polygon.
    #[must_use]
    pub fn with_ends(&self, first: impl AsRef<[Interval]>, last: impl AsRef<[Interval]>) -> Self {
        let (first, last) = (first.as_ref().to_vec(), last.as_ref().to_vec());
        let dimension = self.sequence.dimension();
        assert_eq!([first.len(), last.len()], [dimension; 2], "the ends lie in the space");
        Polygon { sequence: self.sequence, first, last }
    }
}

impl<'a, const D: usize, K: Kernel> Polygon<'a, D, K> {
    /// Returns the same polygon, for evaluation by another kernel.
    #[must_use]
    pub fn with_kernel<L: Kernel>(&self) -> Polygon<'a, D, L> {
        let [first, last] =
            [&self.first, &self.last].map(|end| end.iter().map(|x| x.with_kernel()).collect());
        Polygon { sequence: self.sequence, first, last }
    }

    /// Returns the first point, in `ℓ`.
    #[must_use]
    pub fn first(&self) -> &[Enclosure<K>] {
        &self.first
    }

    /// Returns the last point, in `ℓ`.
    #[must_use]
    pub fn last(&self) -> &[Enclosure<K>] {
        &self.last
    }

    /// Encloses the continuous energy `E(γᵖˡ) = N Σ ∫₀¹ dᵀ H(x + s d) d ds`, in `m²`.
    ///
    /// The result is undefined if the metric is undefined or gives a negative square anywhere on
    /// the curve. It is also undefined if the formula cannot be
    /// [recorded](tautline_formula::Formula::record), since intervals would follow only one branch.
    /// It is infinite if a number overflows. The lower end is never negative.
    ///
    /// The method is Taylor's formula at the midpoint of each chord, with the remainder of fourth
    /// order over the whole chord. If the enclosure is too wide, the chord is bisected, into at
    /// most 8192 parts, none shorter than `2⁻⁴⁰` of the chord. The time is linear in `N`. If the
    /// metric is smooth on the scale of a chord, the relative width is that of rounding, about
    /// `10⁻¹⁵` to `10⁻¹⁴`. It stays below `10⁻¹²` as long as 8192 parts suffice.
    #[must_use]
    pub fn energy(&self, metric: &impl Metric<D>) -> Enclosure<K> {
        self.energy_and_length(metric).0
    }

    /// Encloses the length `L(γᵖˡ) = Σ ∫₀¹ (dᵀ H(x + s d) d)^{1/2} ds`, in `m`, like
    /// [`energy`](Polygon::energy). If all points are equal, the length is zero.
    #[must_use]
    pub fn length(&self, metric: &impl Metric<D>) -> Enclosure<K> {
        self.energy_and_length(metric).1
    }

    /// Encloses both the [`energy`](Polygon::energy), in `m²`, and the [`length`](Polygon::length),
    /// in `m`, in the time that one of them takes.
    #[must_use]
    pub fn energy_and_length(&self, metric: &impl Metric<D>) -> (Enclosure<K>, Enclosure<K>) {
        recorded(metric)
            .and_then(|formula| self.enclosures(&formula).ok())
            .unwrap_or((Enclosure::UNDEFINED, Enclosure::UNDEFINED))
    }

    /// Returns the energy and the length, or why they could not be enclosed.
    fn enclosures(
        &self,
        formula: &Formula<ANY>,
    ) -> Result<(Enclosure<K>, Enclosure<K>), NotEnclosed> {
        self.check(formula).map_err(NotEnclosed::NotRecorded)?;
        let (mut square, mut root) = (PairwiseSum::new(), PairwiseSum::new());
        for (n, chord) in self.chords().enumerate() {
            let integrals = chord.integrals(formula);
            if integrals.is_undefined() {
                return Err(NotEnclosed::Undefined { chord: n });
            }
            square.add(integrals.square);
            root.add(integrals.root);
        }
        Ok((square.value() * self.n(), root.value()))
    }

    /// Returns the energy and the length of a curve on which the metric is one: positive definite.
    pub(super) fn enclosures_of_a_curve(
        &self,
        formula: &Formula<ANY>,
    ) -> Result<(Enclosure<K>, Enclosure<K>), NotEnclosed> {
        let enclosures = self.enclosures(formula)?;
        match self.chords().position(|chord| !chord.is_definite(formula)) {
            Some(chord) => Err(NotEnclosed::Indefinite { chord }),
            None => Ok(enclosures),
        }
    }

    /// Encloses the discrete energy `E_N = N Σ Σᵢ wᵢ dᵀ H(x + θᵢ d) d` of a rule, in `m²`.
    ///
    /// The weights and fractions are the doubles of the rule. The result is undefined if the metric
    /// is undefined at a node, or if its formula cannot be recorded or is not known to be symmetric.
    #[must_use]
    pub fn discrete_energy(&self, rule: Rule, metric: &impl Metric<D>) -> Enclosure<K> {
        recorded(metric)
            .map_or(Enclosure::UNDEFINED, |formula| self.discrete_energy_by_formula(rule, &formula))
    }

    /// Encloses the [`discrete_energy`](Polygon::discrete_energy), in `m²`, in a dimension that is a
    /// value.
    ///
    /// # Panics
    ///
    /// If the formula is one in another dimension.
    #[must_use]
    pub fn discrete_energy_by_formula(&self, rule: Rule, formula: &Formula<ANY>) -> Enclosure<K> {
        if self.check(formula).is_err() {
            return Enclosure::UNDEFINED;
        }
        let mut sum = PairwiseSum::new();
        for chord in self.chords() {
            for node in rule.nodes() {
                sum.add(chord.square_at(formula, node.fraction) * node.weight);
            }
        }
        sum.value() * self.n()
    }

    /// Checks that a formula is known to be symmetric.
    pub(super) fn check(&self, formula: &Formula<ANY>) -> Result<(), RecordError> {
        assert_eq!(formula.dimension(), self.sequence.dimension(), "a formula on this space");
        formula.symmetric().map(|_| ())
    }

    /// Returns `N`, which is exact as a double.
    pub(super) fn n(&self) -> f64 {
        self.sequence.n().get() as f64
    }

    pub(super) fn chords(&self) -> impl Iterator<Item = Chord<K>> {
        let last = self.sequence.n().get();
        let vertex = move |n: usize| match n {
            0 => self.first.clone(),
            _ if n == last => self.last.clone(),
            _ => point(self.sequence.row(n)),
        };
        (0..last).map(move |n| Chord::between(&vertex(n), &vertex(n + 1)))
    }
}

/// Returns the formula of a metric, if it can be recorded.
pub(super) fn recorded<const D: usize>(metric: &impl Metric<D>) -> Option<Formula<ANY>> {
    Formula::record(metric).ok().map(Formula::into_any)
}
