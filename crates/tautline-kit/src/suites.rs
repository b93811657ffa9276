//! The macros that give each law a test of its own name.

/// Tests a metric of your own: one test a law, in a module of the given name.
///
/// ```text
/// metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]));
/// metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]), with distances);
/// metric_suite!(disc: Disc, dimension 2, within 0.5, of [0.1, 0.2]);
/// metric_suite!(disc: Disc, dimension 2, within 0.5, of [0.1, 0.2], with distances);
/// ```
///
/// In the last two it is tested in the ball of this radius and centre, and implements
/// [`LocallyBounded`](tautline::LocallyBounded) instead of [`Bounded`](tautline::Bounded).
///
/// The metric implements [`Bounded`](tautline::Bounded), and for the second and the fourth form
/// [`KnownDistance`](tautline::KnownDistance), with which its own distances are tested too, and
/// the theorems between two points are put to them instead of to estimates. In the first two forms
/// the metric may be a `Result` as well: `Certified::new(Egg, Accuracy::default())`.
///
/// Expands to `mod egg` with a test for each of [`metric::LAWS`](crate::metric::LAWS), which
/// calls the function of the same name, with the test `every_law_is_a_test`, and with the test
/// `the_metric_has_constants`. The metric is made once, and minimisers are computed once, for all of
/// them. Where the metric cannot be made, `the_metric_has_constants` fails with the reason, and the
/// laws are not tried. Each test draws the same samples in every run.
/// See the page of the [`crate`].
#[macro_export]
macro_rules! metric_suite {
    (
        $name:ident: $metric:expr, dimension $d:literal, in $region:expr
        $(, with $distances:ident)? $(,)?
    ) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            {
                $name, $d,
                (|effort| {
                    $crate::Bring::<_, $d>::bring($metric).map(|metric| {
                        $crate::MetricCase::<_, $d>::new(metric, $region, effort)
                            $(.$distances())?
                    })
                })
            }
        }
    };
    (
        $name:ident: $metric:expr, dimension $d:literal, within $radius:expr, of $centre:expr
        $(, with $distances:ident)? $(,)?
    ) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            {
                $name, $d,
                (|effort| {
                    $crate::MetricCase::<_, $d>::within($metric, $centre, $radius, effort)
                        .map(|case| case$(.$distances())?)
                        .map_err(|error| ::std::string::ToString::to_string(&error))
                })
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __metric_tests {
    ({ $name:ident, $d:literal, $case:expr } $($id:ident, $law:literal, $run:expr;)*) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the metric is made of")]
            use super::*;

            static BROUGHT: $crate::Brought = $crate::Brought::new();

            fn case() -> ::std::result::Result<
                &'static $crate::MetricCase<impl $crate::prelude::Bounded<$d>, $d>,
                &'static str,
            > {
                BROUGHT.case(|| $case($crate::Effort::for_dimension($d)))
            }

            #[test]
            fn the_metric_has_constants() {
                $crate::assert_made(case());
            }

            $(
                #[test]
                fn $id() {
                    // Else there is nothing to try, which `the_metric_has_constants` tells.
                    if let ::std::result::Result::Ok(case) = case() {
                        $crate::metric::$id(case).assert();
                    }
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::metric::LAWS);
            }
        }
    };
}

/// Tests a closed set of your own: one test a law, in a module of the given name.
///
/// ```text
/// set_suite!(ellipse: Ellipse, dimension 2, in Region::cell([-4.0, -4.0], [4.0, 4.0]));
/// ```
///
/// The set implements [`ClosedSet`](tautline::ClosedSet). The region should reach beyond its
/// boundary. Expands to a test for each of [`set::LAWS`](crate::set::LAWS), and to the test
/// `every_law_is_a_test`.
#[macro_export]
macro_rules! set_suite {
    ($name:ident: $set:expr, dimension $d:literal, in $region:expr $(,)?) => {
        $crate::__set_laws! { [$crate::__set_tests] { $name, $d, $set, $region } }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __set_tests {
    (
        { $name:ident, $d:literal, $set:expr, $region:expr }
        $($id:ident, $law:literal, $run:expr;)*
    ) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the set is made of")]
            use super::*;

            $(
                #[test]
                fn $id() {
                    let (set, region): (_, $crate::Region<$d>) = ($set, $region);
                    let effort = $crate::Effort::default();
                    let case = $crate::SetCase::new(&set, region, effort);
                    $crate::set::$id(&case).assert();
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::set::LAWS);
            }
        }
    };
}

/// Tests a rule of numerical integration of your own: one test a law, in a module of the given
/// name.
///
/// ```text
/// rule_suite!(simpson: Simpson);
/// ```
///
/// The rule implements [`Rule`](tautline::Rule). Expands to a test for each of
/// [`rule::LAWS`](crate::rule::LAWS), and to the test `every_law_is_a_test`.
#[macro_export]
macro_rules! rule_suite {
    ($name:ident: $rule:expr $(,)?) => {
        $crate::__rule_laws! { [$crate::__rule_tests] { $name, $rule } }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __rule_tests {
    ({ $name:ident, $rule:expr } $($id:ident, $law:literal, $run:expr;)*) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the rule is made of")]
            use super::*;

            $(
                #[test]
                fn $id() {
                    let effort = $crate::Effort::default();
                    $crate::rule::$id(&$crate::RuleCase::new($rule, effort)).assert();
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::rule::LAWS);
            }
        }
    };
}
