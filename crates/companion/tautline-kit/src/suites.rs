//! The macros that make one test per law, with the name of the law.

/// Tests a metric of your own, with one test per law, in a module with the given name.
///
/// ```text
/// metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]));
/// metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]), with distances);
/// metric_suite!(disc: Disc, dimension 2, within 0.5, of [0.1, 0.2]);
/// metric_suite!(disc: Disc, dimension 2, within 0.5, of [0.1, 0.2], with distances);
/// ```
///
/// The first two forms need [`Bounded`](tautline::Bounded). They also accept a `Result`, for
/// example `Certified::new(Egg, Accuracy::default())`. The last two forms test the ball with the
/// given radius and centre, and they need [`LocallyBounded`](tautline::LocallyBounded). The forms
/// `with distances` need [`KnownDistance`](tautline::KnownDistance). The distances of the metric
/// are then tested, and they replace estimates in the theorems between two points.
///
/// The macro expands to `mod egg` with one test for each of [`metric::LAWS`](crate::metric::LAWS),
/// which calls the function of the same name, and with the tests `every_law_is_a_test` and
/// `the_metric_has_constants`. All tests share one metric and its minimisers. If the metric cannot
/// be made, `the_metric_has_constants` fails with the reason, and no law is tested. Every run draws
/// the same samples. See the documentation of the [`crate`].
#[macro_export]
macro_rules! metric_suite {
    (
        $name:ident: $metric:expr, dimension $d:literal, in $region:expr
        $(, with $distances:ident)? $(,)?
    ) => {
        $crate::__metric_tests! {
            $name, $d,
            |effort| {
                $crate::Bring::<_, $d>::bring($metric).map(|metric| {
                    $crate::MetricCase::<_, $d>::new(metric, $region, effort)$(.$distances())?
                })
            }
        }
    };
    (
        $name:ident: $metric:expr, dimension $d:literal, within $radius:expr, of $centre:expr
        $(, with $distances:ident)? $(,)?
    ) => {
        $crate::__metric_tests! {
            $name, $d,
            |effort| {
                $crate::MetricCase::<_, $d>::within($metric, $centre, $radius, effort)
                    .map(|case| case$(.$distances())?)
                    .map_err(|error| ::std::string::ToString::to_string(&error))
            }
        }
    };
}

#[doc(hidden)]
#[macro_export]
macro_rules! __metric_tests {
    ($name:ident, $d:literal, $case:expr) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the metric is made of")]
            use super::*;

            static BROUGHT: $crate::Brought = $crate::Brought::new();

            fn case() -> ::std::result::Result<
                &'static $crate::MetricCase<impl $crate::prelude::Bounded<$d>, $d>,
                &'static str,
            > {
                BROUGHT.case(|| ($case)($crate::Effort::for_dimension($d)))
            }

            #[test]
            fn the_metric_has_constants() {
                $crate::assert_made(case());
            }

            // If a metric could not be made, `the_metric_has_constants` reports it.
            $crate::__metric_laws! {
                [$crate::__tests]
                { metric, |law| if let ::std::result::Result::Ok(case) = case() { law(case) } }
            }
        }
    };
}

/// Tests a closed set of your own, with one test per law, in a module with the given name.
///
/// ```text
/// set_suite!(ellipse: Ellipse, dimension 2, in Region::cell([-4.0, -4.0], [4.0, 4.0]));
/// ```
///
/// The set must implement [`ClosedSet`](tautline::ClosedSet). The region should reach beyond its
/// boundary. The macro expands to one test for each of [`set::LAWS`](crate::set::LAWS), and to the
/// test `every_law_is_a_test`.
#[macro_export]
macro_rules! set_suite {
    ($name:ident: $set:expr, dimension $d:literal, in $region:expr $(,)?) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the set is made of")]
            use super::*;

            $crate::__set_laws! {
                [$crate::__tests]
                {
                    set,
                    |law| {
                        let (set, region): (_, $crate::Region<$d>) = ($set, $region);
                        law(&$crate::SetCase::new(&set, region, $crate::Effort::default()))
                    }
                }
            }
        }
    };
}

/// Tests a rule of numerical integration of your own, with one test per law, in a module with the
/// given name.
///
/// ```text
/// rule_suite!(simpson: Rule::SIMPSON);
/// ```
///
/// The rule is a [`Rule`](tautline::Rule). The macro expands to one test for each of
/// [`rule::LAWS`](crate::rule::LAWS), and to the test `every_law_is_a_test`.
#[macro_export]
macro_rules! rule_suite {
    ($name:ident: $rule:expr $(,)?) => {
        #[cfg(test)]
        mod $name {
            #[allow(unused_imports, reason = "what the rule is made of")]
            use super::*;

            $crate::__rule_laws! {
                [$crate::__tests]
                { rule, |law| law(&$crate::RuleCase::new($rule, $crate::Effort::default())) }
            }
        }
    };
}

/// Makes one test for each law; `$check` runs a law on the case.
#[doc(hidden)]
#[macro_export]
macro_rules! __tests {
    ({ $module:ident, |$law:ident| $check:expr } $($id:ident, $says:literal, $run:expr;)*) => {
        $(
            #[test]
            fn $id() {
                let $law = |case: &_| $crate::$module::$id(case).assert();
                $check
            }
        )*

        #[test]
        fn every_law_is_a_test() {
            assert_eq!([$(stringify!($id)),*], $crate::$module::LAWS);
        }
    };
}
