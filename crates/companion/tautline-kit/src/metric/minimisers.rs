//! The statements of the paper about minimisers, checked on the solved problems of a metric.

use tautline::Bounded;
use tautline_statements::{
    self as statements, Evidence, Known, LIBRARY, NearestPair, PaperRule, Reconstruction, Subject,
    VerifyError, curves::Measured, discrete_energy,
};

use super::{
    Case,
    solutions::Minimiser,
    statements::{judge, judge_all},
};
use crate::{Fault, margin::Margin, report::LawResult};

/// Checks Proposition 6.2 on the ends of the minimisers for the trapezoidal rule.
///
/// The length of the reconstruction bounds the distance between the ends. The distance of another
/// pair is known or is bounded by the length of a detour. Upper bounds suffice, since only a
/// shorter length is refused.
pub(super) fn prop_6_2<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_solutions(PaperRule::Trapezoidal, &|minimiser| {
        let detour = minimiser.detour()?;
        let (metric, seen) = (&case.metric, minimiser.seen);
        let other = case
            .distance
            .as_ref()
            .and_then(|distance| distance(detour.first(), detour.last()))
            .unwrap_or_else(|| Measured::of_sequence(&LIBRARY, metric, &detour).length.value);
        let apart = seen.length_squared.value.sqrt();
        let pair = NearestPair::of(&LIBRARY, minimiser.known, seen, apart);
        let pair = pair.map_err(VerifyError::from)?.beside(other);
        judge(&statements::prop_6_2(&pair, metric.constants().c1()))
    })
}

/// Checks Proposition 6.3 on the reconstructions for the trapezoidal rule and on detours.
pub(super) fn prop_6_3<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_solutions(PaperRule::Trapezoidal, &|minimiser| {
        let sequences = [&minimiser.seen.minimum.sequence, &minimiser.detour()?];
        judge_all(sequences.map(|sequence| {
            let curve = Measured::of_sequence(&LIBRARY, &case.metric, sequence);
            statements::prop_6_3(&LIBRARY, minimiser.known, &curve)
        }))
    })
}

/// Checks Proposition 7.1 on the minimisers for both rules. Each is compared with a detour and with
/// the same sequence after its points are moved a little.
///
/// A search may end at a local minimum, or where the energy is flat to second order, with less
/// energy nearby. It is then restarted, also from the better sequence, and its result must not have
/// more energy than that sequence.
pub(super) fn prop_7_1<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| {
        let (rule, metric, sets) = (minimiser.seen.rule, &case.metric, minimiser.sets());
        let others = [minimiser.detour()?, minimiser.moved()?];
        others.into_iter().try_fold(Margin::idle(), |all, other| {
            let less =
                discrete_energy(&LIBRARY, rule, metric, &other) < minimiser.seen.discrete_energy;
            let again = if less { Some(minimiser.again(&other)?) } else { None };
            let found = again.as_ref().unwrap_or(&minimiser.seen.minimum.sequence);
            let evidence = statements::prop_7_1(&LIBRARY, rule, metric, sets, [found, &other])?;
            Ok(all.and(judge(&evidence)?))
        })
    })
}

/// Checks that the minimisers of Proposition 7.1 are critical points with nearly constant speed.
pub(super) fn critical_points<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| critical_point(&LIBRARY, minimiser))
}

/// Checks one minimiser. The statement varies the ends by a step that may not be small compared
/// with the gaps in a finite set, so each member of the set is taken by itself.
fn critical_point<const D: usize>(
    subject: &Subject,
    minimiser: &Minimiser<'_, D>,
) -> Result<Margin, Fault> {
    let sequence = &minimiser.seen.minimum.sequence;
    let ends = minimiser.posed.ends_near([*sequence.first(), *sequence.last()]);
    let known = Known { ends: ends.map_err(VerifyError::from)?, ..minimiser.known.clone() };
    judge(&statements::critical_point(subject, &known, minimiser.seen))
}

/// Checks Remark 9.2 on the minimisers for both rules.
pub(super) fn remark_9_2<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.of_both_rules(&|minimiser| judge(&statements::remark_9_2(&LIBRARY, minimiser.seen)))
}

/// Evaluates `C_tra(N)` at `K_{1,g}` and `K_{2,g}` of a problem, as in the proof of Theorem 1.1.
pub(super) fn c_tra<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let norms = [subject.k1_g(seen.setting), subject.k2_g(seen.setting)];
    statements::constant_c_tra(subject, seen.setting.constants(), norms, seen.n)
}

/// Evaluates `C_tra♯` at `K_{1,g}` and `K_{2,g}` of a problem, as in the proof of Theorem 1.1.
pub(super) fn c_tra_sharp<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let norms = [subject.k1_g(seen.setting), subject.k2_g(seen.setting)];
    statements::constant_c_tra_sharp(subject, seen.setting.constants(), norms, seen.n)
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;
    use tautline::{
        Bounded, PointSequence, bounds,
        gallery::{Constant, Shear},
    };
    use tautline_statements::{
        self as statements, Bounds, LIBRARY, Mutant, PaperRule, Subject, VerifyError,
    };

    use super::{critical_point, judge};
    use crate::{
        Effort, Fault, Region,
        metric::{case::Case, minimisers, solutions::Minimiser},
        report::LawResult,
    };

    /// Returns the library with an error of one part in a million in `C_tra(N)`.
    fn off() -> Subject {
        let c_tra = |constants, k1, k2, n| bounds::c_tra(constants, k1, k2, n) * (1.0 + 1e-6);
        Subject::with(Bounds { c_tra, ..Bounds::LIBRARY })
    }

    fn shear() -> Shear {
        Shear::new(0.5, 1.0).expect("a wave number")
    }

    fn case(metric: &impl Bounded<2>) -> Case<'_, 2> {
        let effort = Effort { problems: 6, subintervals: &[1, 3], ..Effort::default() };
        Case::new(metric, Region::cell([0.0, 0.0], [6.0, 6.0]), effort)
    }

    type Way = fn(&Minimiser<'_, 2>) -> Result<PointSequence<2>, VerifyError>;

    /// Returns the violated claim.
    #[track_caller]
    fn violated(result: LawResult) -> &'static str {
        match result.expect_err("it is off").fault {
            Fault::Statement { hypothesis: false, inequality, .. } => inequality.claim,
            fault => panic!("{fault}"),
        }
    }

    #[test]
    fn constants_that_are_off_by_a_millionth_are_refused() {
        let of = |statement| case(&shear()).of_constants(PaperRule::Trapezoidal, statement, None);
        assert!(of(minimisers::c_tra).is_ok() && of(minimisers::c_tra_sharp).is_ok());
        let wrong = violated(of(|_, seen| minimisers::c_tra(&off(), seen)));
        assert_eq!(wrong, "C_tra(N) ≤ its definition");
        let wrong = violated(of(|_, seen| minimisers::c_tra_sharp(&off(), seen)));
        assert_eq!(wrong, "C_tra(N) ≤ C_tra♯/N");
    }

    /// For a constant metric every length is the length of a straight line, and `C_tra(N)` always
    /// equals its definition.
    #[test]
    fn cases_that_could_not_fail_are_counted_apart() {
        let rule = PaperRule::Trapezoidal;
        let (flat, shear) = (Constant::<2>::new(SMatrix::identity()), shear());
        let flat = flat.expect("positive definite");
        let of_flat = case(&flat).of_minimisers(rule, statements::theorem_1_2).expect("it holds");
        let of_shear = case(&shear).of_minimisers(rule, statements::theorem_1_2).expect("it holds");
        assert_eq!(of_flat.idle, of_flat.cases);
        let idle_less = 2 * of_shear.idle < of_shear.cases;
        assert!(of_flat.cases == of_shear.cases && idle_less, "{of_shear:?}");
        let identity = case(&shear).of_constants(rule, minimisers::c_tra, None).expect("it holds");
        assert_eq!((identity.idle, identity.overestimation), (identity.cases, f64::INFINITY));
    }

    /// One point is moved so far that the gradient at this point, whose derivative is about `4N H`,
    /// is off by a millionth.
    #[test]
    fn gradients_that_are_off_by_a_millionth_are_refused() {
        let shear = shear();
        let case = case(&shear);
        assert!(case.of_both_rules(&|minimiser| critical_point(&LIBRARY, minimiser)).is_ok());
        let moved = case.of_both_rules(&|minimiser| {
            let mut seen = minimiser.seen.clone();
            let mut points = seen.minimum.sequence.points().to_vec();
            let n = points.len() - 1;
            if n > 1 {
                points[n / 2].add_scalar_mut(1e-6 / (4.0 * n as f64));
            }
            seen.minimum.sequence = PointSequence::new(points).expect("finite");
            critical_point(&LIBRARY, &Minimiser { seen: &seen, ..*minimiser })
        });
        let claim = violated(moved);
        assert!(claim.contains("ρₙ"), "{claim}");
    }

    /// A single chord has no inner point.
    #[test]
    fn a_gradient_that_points_out_of_the_sets_is_refused() {
        let one = Effort { problems: 6, subintervals: &[1], ..Effort::default() };
        let shear = shear();
        let case = Case::new(&shear, Region::cell([0.0, 0.0], [6.0, 6.0]), one);
        let by = |subject: &Subject| case.of_both_rules(&|found| critical_point(subject, found));
        assert!(by(&LIBRARY).is_ok());
        let claim = violated(by(&Mutant::GradientReversed.into()));
        assert!(claim.contains("∂E"), "{claim}");
    }

    /// A minimiser is compared with sequences whose energy is larger by more than the granted
    /// rounding.
    #[test]
    fn a_moved_minimiser_is_no_minimiser() {
        let shear = shear();
        let case = case(&shear);
        let ways: [Way; 2] = [|minimiser| minimiser.moved(), |minimiser| minimiser.detour()];
        for way in ways {
            let swapped = case.of_both_rules(&|minimiser| {
                let (rule, found) = (minimiser.seen.rule, &minimiser.seen.minimum.sequence);
                let (metric, sets) = (&case.metric, minimiser.sets());
                let pair = [&way(minimiser)?, found];
                judge(&statements::prop_7_1(&LIBRARY, rule, metric, sets, pair)?)
            });
            assert_eq!(violated(swapped), "E_N(γ*) ≤ E_N(γᵖ)");
        }
    }
}
