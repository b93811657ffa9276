//! Test a metric of your own, a closed set or a rule.
//!
//! A kit takes what you bring, draws samples, and tries laws on them, one after the other: what
//! the trait asks for, what your constants claim, and the statements of the paper that follow.
//!
//! | you bring | tests | the same as a function | one law |
//! | --- | --- | --- | --- |
//! | [`Metric`] and [`Bounded`] | [`metric_suite!`] | [`verify_metric`] | [`metric`] |
//! | [`Metric`] and [`LocallyBounded`] | [`metric_suite!`] `within` a ball | [`verify_metric_within`] | |
//! | [`ClosedSet`] | [`set_suite!`] | [`verify_set`] | [`set`] |
//! | [`Rule`] | [`rule_suite!`] | [`verify_rule`] | [`rule`] |
//!
//! [`Metric`]: tautline::Metric
//! [`Bounded`]: tautline::Bounded
//! [`LocallyBounded`]: tautline::LocallyBounded
//! [`ClosedSet`]: tautline::ClosedSet
//! [`Rule`]: tautline::Rule
//! [`metric_suite!`]: crate::metric_suite
//! [`set_suite!`]: crate::set_suite
//! [`rule_suite!`]: crate::rule_suite
//!
//! # Test a metric of your own
//!
//! The crate is not published: the `Cargo.toml` of your package, here `egg` beside the clone, names
//! where it lies, and has this library optimised: unoptimised, the tests take ten times as long.
//!
//! ```toml
//! [dev-dependencies]
//! tautline-kit = { path = "../tautline/crates/tautline-kit" }
//! tautline = { path = "../tautline/crates/tautline" } # for the gallery, and to solve problems
//!
//! [profile.dev]
//! opt-level = 2
//!
//! [profile.dev.package.egg] # your crate, whose tests take longer to compile than to run
//! opt-level = 0
//! debug = false
//! codegen-units = 16
//! ```
//!
//! A file `tests/egg.rs`, all of it, which is a formula and twelve lines:
//!
//! ```
//! use tautline_kit::prelude::*;
//!
//! struct Egg; // H(x) = diag(2 + cos x₁, 3 + sin x₂)
//! impl Metric<2> for Egg {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal(&[2.0 + x[0].cos(), 3.0 + x[1].sin()].into())
//!     }
//! }
//! impl Bounded<2> for Egg {
//!     fn constants(&self) -> Constants {
//!         Constants::new(1.0, 4.0, 1.0).expect("c1 ≤ c2")
//!     }
//! }
//! metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]));
//! # let region = Region::cell([0.0, 0.0], [6.3, 6.3]);
//! # let effort = Effort { cases: 32, problems: 1, subintervals: &[1, 4], ..Effort::default() };
//! # let report = verify_metric(&Egg, &region, &effort);
//! # assert!(report.holds(), "{report}");
//! ```
//!
//! An `S: Scalar` has `+ - * /` with another `S` and with an `f64` on either side
//! (`1.0 + 2.0 * x[0]`, and `S::constant(2.0)` where an entry is a number alone), `sqr`, `powi`,
//! `recip`, `sqrt`, `exp`, `ln`, `sin`, `cos`, `tan`, `atan`, `sinh`, `cosh` and `tanh`; it has no
//! `abs`, no `powf`, and no order, since a formula has to be smooth.
//!
//! `cargo test egg` then runs `egg::l_h_bounds_the_derivative`, `egg::theorem_1_1` and so on. What
//! is wrong is named with its numbers; here with `L_H = 1/2` in place of 1:
//!
//! ```
//! use tautline_kit::{Claim, Fault, MetricCase, metric};
//! # use tautline_kit::prelude::*;
//! # #[derive(Clone, Copy, Debug)]
//! # struct Egg;
//! # impl Metric<2> for Egg {
//! #     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//! #         SMatrix::from_diagonal(&[2.0 + x[0].cos(), 3.0 + x[1].sin()].into())
//! #     }
//! # }
//! let constants = Constants::new(1.0, 4.0, 0.5)?;
//! let region = Region::new([0.0, 0.0], [6.3, 6.3])?;
//! let case = MetricCase::new(WithConstants { metric: Egg, constants }, region, Effort::default());
//! let outcome = metric::l_h_bounds_the_derivative(&case);
//! let Some(Fault::Lie(lie)) = outcome.failure.map(|failure| failure.fault) else { panic!() };
//! assert_eq!((lie.constant, lie.claimed), (Claim::LH, 0.5));
//! // ‖DH(x)[w]‖ at x = lie.point, in the direction w = lie.direction
//! assert!((lie.found - 1.0).abs() < 1e-6);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A metric that knows its distances says `with distances` at the end of the line, and
//! [`MetricCase::with_known_distance`] where functions are called. A metric that claims nothing is
//! given claims by [`WithConstants`](tautline_statements::WithConstants), or proved ones by
//! [`Certified`](tautline::Certified) if its formula is constant or periodic along each coordinate:
//! then the formula is all that there is to write. One that goes over into a constant one far away
//! takes [`Certified::settled`](tautline::Certified::settled), and any other one constants that are
//! proved in a ball:
//! `metric_suite!(dent: LocallyCertified::new(Dent, Accuracy::default()), dimension 2, within 0.5, of [0.1, 0.2]);`.
//!
//! ```
//! use tautline_kit::prelude::*;
//!
//! struct Tray; // H(x) = (2 + cos x₁ sin x₂) I
//! impl Metric<2> for Tray {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal_element(2.0 + x[0].cos() * x[1].sin())
//!     }
//! }
//! metric_suite!(
//!     tray: Certified::new(Tray, Accuracy::default()), dimension 2,
//!     in Region::cell([0.0, 0.0], [6.3, 6.3]),
//! );
//! # let constants = Certified::new(Tray, Accuracy::default()).expect("periodic").constants();
//! # assert!(constants.c1() <= 1.0 && constants.c1() > 0.99 && constants.c2() < 3.01);
//! ```
//!
//! The constants are proved once for all laws. Where they cannot be, because the formula is not
//! periodic or `H` is indefinite somewhere, the test `tray::the_metric_has_constants` fails with
//! the reason, with the point if there is one, and with what may be done about it, and no law is
//! tried. A metric that has constants on balls only is tested in one of them,
//! `within 0.5, of [0.1, 0.2]` in place of `in Region::cell(…)`.
//!
//! # How the laws look
//!
//! Random samples alone test the program, not the constants: of 256 uniform points none need be
//! where `‖DH(x)[w]‖` comes within 9 % of its largest value. So each constant is looked for by
//! local ascents from the best of the samples, until the maximum over a smooth formula is known
//! to six digits or so, and a claim that is off by more is refused with the point, the direction,
//! and both numbers. What ascents from [`Effort::ascents`] starts do not reach is not seen:
//! a law that holds is evidence, not a proof.
//!
//! One is a proof, up to three dimensions and of a formula without branches:
//! `no_constant_is_refuted` bounds the constants in all of the region by intervals, and refuses a
//! claim that they contradict, with the point unless the boxes ran out, and a metric that is
//! indefinite somewhere, with the point. That it passes does not mean that all is proved: its
//! [`standings`](Outcome::standings) say of each constant whether it is proved, right to so many
//! percent (as a claim that is attained can be only), not decided by the boxes, or not tried.
//!
//! One sample in eight is moved to the ends, the quarters or the middle of the edges, or to 0:
//! there `x/|x|`, `1/r` and angles break, and uniform samples are never there. Where a law of the
//! formula itself fails, or `H` jumps, the laws that would solve problems say `not tried` with the
//! name of that law, which is the one to mend first.
//!
//! A suite is silent about what holds. A test of your own prints the table of overestimations and
//! standings, and may look longer:
//! `println!("{}", verify_metric(&Egg, &region, &Effort { ascents: 12, ..Effort::default() }))`,
//! with `cargo test -- --nocapture`.
//!
//! A claim may be loose. The overestimation of each law is in the [`Report`], and
//! `refuses_a_smaller_l_h` notes it: the bounds of the theorems are as loose as the constants.
//!
//! Samples are integers that are mapped to the [`Region`], so that the smallest sample that fails
//! has short binary fractions of its edges. Nothing is written, and every run draws the same
//! samples, unless the environment asks for others, or for more:
//!
//! ```console
//! $ TAUTLINE_SEED=7 TAUTLINE_CASES=100 cargo test egg
//! ```
//!
//! A seed is a whole number of 64 bits; what fails says with which variables it was drawn. See
//! [`Chance`].

mod brought;
mod difference_test;
mod effort;
mod fault;
mod lie;
mod met;
pub mod metric;
mod order;
pub mod prelude;
mod region;
mod report;
pub mod rule;
mod sampling;
pub mod set;
mod standing;
mod suites;

pub use brought::{Attempt, Bring, Brought, Itself, assert_made};
pub use effort::Effort;
pub use fault::Fault;
pub use lie::{Claim, Lie};
pub use metric::{MetricCase, verify_metric, verify_metric_within};
pub use region::{Region, RegionError, directions};
pub use report::{Failure, Outcome, Report};
pub use rule::{RuleCase, verify_rule};
pub use set::{SetCase, verify_set};
pub use standing::{Proof, Standing};
pub use tautline_chance::{Chance, ChanceError};
