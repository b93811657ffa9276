//! The audit in one dimension: the formula, its constants, and then everything else.

use tautline::{Constants, Formula};
use tautline_kit::{Claim, Fault, MetricCase, Outcome, Region, metric};
use tautline_problem::{Failure, InDimension, Question, UsedConstants};
use tautline_statements::WithConstants;

use crate::{
    answer::{Audit, Law, Measured, Standing, Status, Verdict},
    constants::{BallOf, Proved, Unproved, prove, used},
    effort::Effort,
    laws::{KitLaw, LAST_OF_THE_CLAIMS, OF_THE_FORMULA, laws},
    lies,
    region::{choose, cube, place, point},
    typed::{Case, Typed},
    words::vector,
};

/// What is said of a law that was not reached.
const OUT_OF_TIME: &str = "time ran out";

/// The audit of a question.
pub(crate) struct Run<'q> {
    pub(crate) question: &'q Question,
    pub(crate) effort: Effort,
    /// Is told what is known after each law; returns whether the audit shall go on.
    pub(crate) report: &'q dyn Fn(&Audit) -> bool,
}

impl InDimension for Run<'_> {
    type Output = Result<Audit, Failure>;

    fn run<const D: usize>(self) -> Self::Output {
        let Run { question, effort, report } = self;
        let formula = question.formula::<D>()?;
        let (region, place) = choose(question, &formula);
        let mut kit = tautline_kit::Effort::for_dimension(D);
        kit.cases = effort.cases.or(question.audit_cases()).unwrap_or(kit.cases);
        kit.seed = effort.seed.or(question.audit_seed()).unwrap_or(kit.seed);
        // Few samples also mean few problems.
        kit.problems = kit.problems.min(kit.cases);
        let audit = Audit {
            verdict: Verdict::Incomplete,
            lies: Vec::new(),
            dimension: D,
            region: place,
            cases: kit.cases,
            seed: kit.seed,
            constants: None,
            no_constants: None,
            measured: Vec::new(),
            proved: Vec::new(),
            laws: laws::<D>().iter().map(|law| Law::not_tried(law, OUT_OF_TIME)).collect(),
        };
        let mut session = Session { formula, region, kit, audit, report };
        match question.claimed_constants() {
            Some(claimed) => {
                let ball = question.ball_of_constants();
                session.audit.constants = Some(used(claimed, false, ball.as_ref()));
                session.with(claimed, ball);
            }
            None => session.without_claims(question)?,
        }
        Ok(session.audit)
    }
}

struct Session<'q, const D: usize> {
    formula: Formula<D>,
    region: Region<D>,
    kit: tautline_kit::Effort,
    audit: Audit,
    report: &'q dyn Fn(&Audit) -> bool,
}

impl<const D: usize> Session<'_, D> {
    /// Tries the laws that these constants suffice for.
    fn with(&mut self, constants: Constants, ball: Option<BallOf>) {
        let Some((centre, radius)) = ball else {
            let case = self.case(constants, self.region);
            self.try_laws(&case, |_| true);
            return;
        };
        let typed = Typed { formula: self.formula.clone(), in_ball: Some(constants) };
        let centre = point::<D>(&centre);
        if let Some(cube) = cube(&centre, radius / (D as f64).sqrt()) {
            let before = &self.audit.region;
            let mut why = "the largest cube in the ball of the constants".to_owned();
            if self.audit.count(Status::Holds) > 0 && self.region != cube {
                let [lower, upper] = [&before.lower, &before.upper].map(|x| vector(x));
                why += &format!("; for the laws of the formula, the box {lower} to {upper}");
            }
            self.region = cube;
            self.audit.region = place(&cube, &why);
        }
        match MetricCase::within(typed, centre, radius, self.kit) {
            Ok(case) => self.try_laws(&case, |_| true),
            Err(error) => {
                let why = format!("no problem can be posed in so small a ball: {error}");
                let all = laws::<D>();
                let last = all.iter().position(|law| law.id == LAST_OF_THE_CLAIMS).unwrap_or(0);
                self.skip(&why, |law| all[..=last].iter().all(|claim| claim.id != law));
                let case = self.case(constants.on_a_region(), self.region);
                self.try_laws(&case, |id| all[..=last].iter().any(|law| law.id == id));
            }
        }
    }

    /// Measures the metric, tries the laws of the formula, proves constants, and goes on with them.
    fn without_claims(&mut self, question: &Question) -> Result<(), Failure> {
        self.audit.no_constants = Some("time ran out before they were proved".to_owned());
        let scale = self.measure();
        let case = self.case(scale, self.region);
        self.try_laws(&case, |id| OF_THE_FORMULA.contains(&id));
        if self.audit.count(Status::Fails) > 0 {
            self.give_up("H is not a metric in the region");
            return Ok(());
        }
        if !(self.report)(&self.audit) {
            return Ok(());
        }
        match prove(question, &self.region) {
            Ok(Proved { constants, ball, if_it_settles, standings }) => {
                let used = used(constants, true, ball.as_ref());
                self.audit.constants = Some(UsedConstants { if_it_settles, ..used });
                self.audit.no_constants = None;
                self.audit.proved = standings;
                self.with(constants, ball);
            }
            Err(Unproved::BadFile(failure)) => return Err(failure),
            Err(Unproved::At { point, reason }) => {
                if let Some(lie) = lies::indefinite(&self.formula, &point) {
                    lies::add(&mut self.audit.lies, lie);
                }
                self.give_up(&reason);
            }
            Err(Unproved::Reason(reason)) => self.give_up(&reason),
        }
        Ok(())
    }

    /// Says why there are no constants. The laws that need some are not tried.
    fn give_up(&mut self, why: &str) {
        self.audit.no_constants = Some(why.to_owned());
        self.skip("no constants are known", |_| true);
        self.audit.judge();
    }

    /// Gives the reason why laws are not tried.
    fn skip(&mut self, why: &str, which: impl Fn(&str) -> bool) {
        let laws = self.audit.laws.iter_mut();
        for law in laws.filter(|law| law.status == Status::NotTried && which(law.law)) {
            law.reason = Some(why.to_owned());
        }
    }

    fn case(&self, constants: Constants, region: Region<D>) -> Case<D> {
        let metric = Typed { formula: self.formula.clone(), in_ball: None };
        MetricCase::new(WithConstants { metric, constants }, region, self.kit)
    }

    /// Finds the extreme values in the region, and returns constants of about this size.
    fn measure(&mut self) -> Constants {
        // The laws refuse claims that are out of all reach, and show the worst values they find.
        let tiny = f64::MIN_POSITIVE;
        let claims = |size: f64| Constants::new(size, size, 0.0)?.with_m_h(0.0);
        let (Ok(low), Ok(high)) = (claims(tiny), claims(f64::MAX)) else {
            unreachable!("positive and finite")
        };
        let [low, high] = [low, high].map(|claims| self.case(claims, self.region));
        let found = [
            metric::c1_is_a_lower_bound(&high),
            metric::c2_is_an_upper_bound(&low),
            metric::l_h_bounds_the_derivative(&low),
            metric::m_h_bounds_the_second_derivative(&low),
        ];
        let found = found.map(|outcome| match outcome.failure.map(|failure| failure.fault) {
            Some(Fault::Lie(lie)) if lie.found.is_finite() => Some(lie),
            _ => None,
        });
        if let Some(lowest) = &found[0]
            && let Some(lie) = lies::indefinite(&self.formula, &lowest.point)
        {
            lies::add(&mut self.audit.lies, lie);
        }
        let value = |k: usize| found[k].as_ref().map(|lie| lie.found);
        let (c1, c2) = (value(0).unwrap_or(1.0).max(tiny), value(1).unwrap_or(1.0));
        let scale = Constants::new(c1, c2.max(c1), value(2).unwrap_or(0.0));
        self.audit.measured = found
            .into_iter()
            .flatten()
            .map(|lie| Measured {
                constant: lie.constant.name(),
                value: lie.found,
                point: lie.point,
                direction: lie.direction,
            })
            .collect();
        scale.unwrap_or_else(|_| unreachable!("positive, finite and in order"))
    }

    /// Tries laws one after the other, until nobody listens any more. Laws that were tried before
    /// are not tried again.
    fn try_laws(&mut self, case: &Case<D>, which: impl Fn(&str) -> bool) {
        for (k, KitLaw { id, check, .. }) in laws::<D>().into_iter().enumerate() {
            if !which(id) || self.audit.laws[k].status != Status::NotTried {
                continue;
            }
            if !(self.report)(&self.audit) {
                return;
            }
            let outcome = check(case);
            self.learn(&outcome);
            self.audit.laws[k] = Law::tried(outcome);
            self.audit.judge();
        }
    }

    fn learn(&mut self, outcome: &Outcome) {
        if let Some(failure) = &outcome.failure {
            for lie in lies::shown_by(&self.formula, &failure.fault) {
                lies::add(&mut self.audit.lies, lie);
            }
        }
        let is_proved = self.audit.constants.as_ref().is_some_and(|used| used.proved);
        if !is_proved {
            let standings = outcome.standings.iter().map(|standing| Standing {
                constant: standing.claim.name(),
                proof: self.in_words(standing),
                within: format!("the box of the samples: {}", self.audit.region.why),
            });
            self.audit.proved.extend(standings.collect::<Vec<_>>());
        }
    }

    fn in_words(&self, standing: &tautline_kit::Standing) -> String {
        use tautline_kit::Proof;
        let claimed = match (&self.audit.constants, standing.claim) {
            (Some(UsedConstants { c1, .. }), Claim::C1) => Some(*c1),
            (Some(UsedConstants { c2, .. }), Claim::C2) => Some(*c2),
            (Some(UsedConstants { l_h, .. }), Claim::LH) => Some(*l_h),
            (Some(UsedConstants { m_h, .. }), Claim::MH) => *m_h,
            (None, _) => None,
        };
        let claimed = claimed.map_or(String::new(), |claimed| format!("{claimed} "));
        match standing.proof {
            Proof::NotDecided => format!("{claimed}neither proved nor refuted: the boxes ran out"),
            Proof::NotTried => format!("{claimed}not tried: the kit proves in 1 to 3 dimensions"),
            proof => format!("{claimed}{proof}"),
        }
    }
}

impl Audit {
    /// Sets the verdict.
    pub(crate) fn judge(&mut self) {
        self.verdict = if !self.lies.is_empty() {
            Verdict::Lies
        } else if self.count(Status::Fails) + self.count(Status::FalseHypothesis) > 0 {
            Verdict::Fails
        } else if self.count(Status::NotTried) > 0 {
            Verdict::Incomplete
        } else {
            Verdict::Holds
        };
    }
}
