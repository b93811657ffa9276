//! Test a metric, a closed set or a rule of your own.
//!
//! The kit draws samples and checks laws on them: the requirements of the trait, the claims made by
//! your constants, and the statements of the paper that follow from them.
//!
//! | you provide | tests | as a function | single laws |
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
//! The crate is not published. The `Cargo.toml` of your package, here `egg` next to the clone,
//! gives the path of the crate and optimises the library. Without optimisation the tests take ten
//! times as long.
//!
//! ```toml
//! [dev-dependencies]
//! tautline-kit = { path = "../tautline/crates/companion/tautline-kit" }
//! tautline = { path = "../tautline/crates/library/tautline" } # for the gallery, and to solve problems
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
//! The whole file `tests/egg.rs` consists of a formula and twelve lines:
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
//! An `S: Scalar` has the operators `+ - * /` with another `S`, and with an `f64` on either side
//! (`1.0 + 2.0 * x[0]`, and `S::constant(2.0)` for an entry that is a plain number). It has the
//! functions `sqr`, `powi`, `recip`, `sqrt`, `exp`, `ln`, `sin`, `cos`, `tan`, `atan`, `sinh`,
//! `cosh` and `tanh`. It has no `abs`, no `powf` and no ordering, since a formula must be smooth.
//!
//! `cargo test egg` then runs `egg::l_h_bounds_the_derivative`, `egg::theorem_1_1` and so on. A
//! failure shows its numbers. Here we claim `L_H = 1/2` instead of 1:
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
//! If your metric knows its distances, end the arguments of `metric_suite!` with `with distances`,
//! or call [`MetricCase::with_known_distance`].
//! [`WithConstants`](tautline_statements::WithConstants) adds constants to a metric that claims
//! none. [`Certified`](tautline::Certified) proves them if the formula is constant or periodic
//! along each coordinate; then you need to write only the formula. Use
//! [`Certified::settled`](tautline::Certified::settled) if the metric is constant far away.
//! Otherwise prove constants in a ball:
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
//! The constants are proved once for all laws. If they cannot be proved, because the formula is not
//! periodic or `H` is indefinite somewhere, the test `tray::the_metric_has_constants` fails with
//! the reason, the point if there is one, and advice. No law is then tested. A metric that has
//! constants only on balls is tested on one of them: write `within 0.5, of [0.1, 0.2]` instead of
//! `in Region::cell(…)`.
//!
//! # What the laws check
//!
//! Random samples alone would test the program, not the constants: of 256 uniform points perhaps
//! none has `‖DH(x)[w]‖` within 9 % of its maximum. So each constant is also tested by local
//! ascents from the best samples, which find the maximum of a smooth formula to about six digits. A
//! claim that is off by more is refused, and the message shows the point, the direction, and both
//! numbers. All [`Effort::ascents`] may still miss the maximum, so a law that holds is evidence,
//! not a proof.
//!
//! One law is a proof, in up to three dimensions and for a formula without branches:
//! `no_constant_is_refuted` bounds the constants over the whole region by interval arithmetic. It
//! refuses a claim that the bounds contradict and shows the point, unless the boxes run out. It
//! also refuses an indefinite metric and shows the point. If the law holds, this does not mean that
//! everything is proved. The [`standings`](Outcome::standings) say for each constant whether it is
//! proved, right to within a percentage (the best possible result for an attained claim), not
//! decided by the boxes, or not tried.
//!
//! One sample in eight is moved to the ends, the quarters or the middle of the edges, or to 0.
//! There `x/|x|`, `1/r` and angles break, and no uniform sample lies there. If a law of the formula
//! itself fails, or if `H` jumps, the laws that solve problems fail with `not tried` and the name
//! of the law that fails; fix the formula first.
//!
//! A suite prints nothing about laws that hold. To see the table of overestimations and standings,
//! print a report, perhaps with more effort, and run `cargo test -- --nocapture`:
//! `println!("{}", verify_metric(&Egg, &region, &Effort { ascents: 12, ..Effort::default() }))`.
//!
//! A claim may be loose, and the bounds of the theorems are then as loose as the constants. The
//! [`Report`] shows the overestimation of each law, and `refuses_a_smaller_l_h` repeats that of
//! `L_H` in a note.
//!
//! Samples are integers mapped to the [`Region`], so the coordinates of the smallest failing sample
//! are short binary fractions of its edges. Nothing is written to disk, and every run draws the
//! same samples, unless the environment sets another seed or more cases:
//!
//! ```console
//! $ TAUTLINE_SEED=7 TAUTLINE_CASES=100 cargo test egg
//! ```
//!
//! A seed is an unsigned 64-bit integer. A failure shows the environment variables with which its
//! samples were drawn. See [`Chance`].

mod brought;
mod difference_test;
mod effort;
mod fault;
mod laws;
mod lie;
mod margin;
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
