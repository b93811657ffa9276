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
/// the theorems between two points are put to them instead of to estimates.
///
/// Expands to `mod egg` with a test for each of [`metric::LAWS`](crate::kit::metric::LAWS), which
/// calls the function of the same name, and with the test `every_law_is_a_test`. Each test draws
/// the same samples in every run; minimisers are computed once for all of them.
/// See [`kit`](crate::kit).
#[macro_export]
macro_rules! metric_suite {
    ($name:ident: $metric:expr, dimension $d:literal, in $region:expr $(,)?) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            { $name, $d, (|effort| $crate::kit::MetricCase::new($metric, $region, effort)), {} }
        }
    };
    ($name:ident: $metric:expr, dimension $d:literal, in $region:expr, with distances $(,)?) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            {
                $name, $d, (|effort| $crate::kit::MetricCase::new($metric, $region, effort)),
                {.with_known_distance()}
            }
        }
    };
    ($name:ident: $metric:expr, dimension $d:literal, within $radius:expr, of $centre:expr $(,)?) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            {
                $name, $d,
                (|effort| $crate::kit::MetricCase::within($metric, $centre, $radius, effort)
                    .unwrap_or_else(|error| panic!("{error}"))),
                {}
            }
        }
    };
    (
        $name:ident: $metric:expr, dimension $d:literal, within $radius:expr, of $centre:expr,
        with distances $(,)?
    ) => {
        $crate::__metric_laws! {
            [$crate::__metric_tests]
            {
                $name, $d,
                (|effort| $crate::kit::MetricCase::within($metric, $centre, $radius, effort)
                    .unwrap_or_else(|error| panic!("{error}"))),
                {.with_known_distance()}
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __metric_tests {
    (
        { $name:ident, $d:literal, $case:expr, {$($known:tt)*} }
        $($id:ident, $law:literal, $run:expr;)*
    ) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the metric is made of")]
            use super::*;

            fn case() -> $crate::kit::MetricCase<
                impl $crate::prelude::Bounded<$d>,
                $d,
            > {
                let effort = $crate::kit::Effort::for_dimension($d);
                $case(effort)$($known)*.sharing(&SOLVED)
            }

            /// What the tests of this metric have solved.
            static SOLVED: ::std::sync::LazyLock<
                ::std::sync::Arc<$crate::kit::metric::Solved<$d>>,
            > = ::std::sync::LazyLock::new(::std::default::Default::default);

            $(
                #[test]
                fn $id() {
                    $crate::kit::metric::$id(&case()).assert();
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::kit::metric::LAWS);
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
/// boundary. Expands to a test for each of [`set::LAWS`](crate::kit::set::LAWS), and to the test
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
                    let (set, region): (_, $crate::kit::Region<$d>) = ($set, $region);
                    let effort = $crate::kit::Effort::default();
                    let case = $crate::kit::SetCase::new(&set, region, effort);
                    $crate::kit::set::$id(&case).assert();
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::kit::set::LAWS);
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
/// [`rule::LAWS`](crate::kit::rule::LAWS), and to the test `every_law_is_a_test`.
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
                    let effort = $crate::kit::Effort::default();
                    $crate::kit::rule::$id(&$crate::kit::RuleCase::new($rule, effort)).assert();
                }
            )*

            #[test]
            fn every_law_is_a_test() {
                assert_eq!([$(stringify!($id)),*], $crate::kit::rule::LAWS);
            }
        }
    };
}
