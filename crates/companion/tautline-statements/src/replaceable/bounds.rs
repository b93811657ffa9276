//! `Bounds`: the bounds and constants that a mutant can replace, as a table of functions.

use std::num::NonZeroUsize;

use tautline::{
    Constants,
    bounds::{
        self, BetweenPoints, Bound, BoundError, Computed, Enclosure, PaperRule, Setting, Spread,
    },
};

use super::Asked;

/// Maps the name of an argument to its type.
macro_rules! kind {
    (setting) => {
        Setting
    };
    (constants) => {
        Constants
    };
    (rule) => {
        PaperRule
    };
    (n) => {
        NonZeroUsize
    };
    (dimension) => {
        usize
    };
    (computed) => {
        &Computed
    };
    (between) => {
        &BetweenPoints
    };
    ($number:ident) => {
        f64
    };
}
pub(crate) use kind;

/// Makes the table, and the method that returns the set of its replaced entries.
macro_rules! bounds {
    ($($entry:ident($($name:ident),*) -> $result:ty = $genuine:path;)*) => {
        /// The bounds and constants in use, each as a function.
        ///
        /// `Bounds { rule_gap: |_, _, _| 0.0, ..Bounds::LIBRARY }` replaces an entry. The methods
        /// of [`Subject`](crate::Subject) with the same names call the entries.
        #[derive(Clone, Copy, Debug)]
        pub struct Bounds {
            $(
                #[doc = concat!("In the library [`", stringify!($genuine), "`].")]
                pub $entry: fn($(kind!($name)),*) -> $result,
            )*
        }

        /// The names of the entries.
        #[expect(non_camel_case_types, reason = "the names of the entries")]
        #[derive(Clone, Copy)]
        pub(crate) enum Entry {
            $($entry,)*
        }

        impl Bounds {
            /// The functions of the library.
            pub const LIBRARY: Self = Self { $($entry: $genuine,)* };

            /// Returns the entries that differ from [`GENUINE`] in address. Equal addresses mean
            /// equal functions.
            pub(crate) fn replaced(&self) -> Asked {
                let mut replaced = Asked::default();
                $(
                    if self.$entry as usize != GENUINE.$entry as usize {
                        replaced.add_bound(Entry::$entry as usize);
                    }
                )*
                replaced
            }
        }

        const ENTRIES: usize = [$(Entry::$entry),*].len();
        const _: () = assert!(Asked::PROGRAMS + ENTRIES <= u64::BITS as usize);
    };
}

/// The functions of the library, each at one address. A constant may be compiled more than once.
pub(crate) static GENUINE: Bounds = Bounds::LIBRARY;

/// Passes each entry to the macro `$each`: its name, arguments and result, and the library's
/// function.
macro_rules! for_each_bound {
    ($each:ident) => {
        $each! {
            k1_g(setting) -> f64 = bounds::k1_g;
            k2_g(setting) -> f64 = bounds::k2_g;
            c_tra(constants, k1, k2, n) -> f64 = bounds::c_tra;
            c_tra_sharp(constants, k1, k2) -> f64 = bounds::c_tra_sharp;
            k3_bar_g(setting) -> f64 = bounds::k3_bar_g;
            k4_bar_g(setting) -> f64 = bounds::k4_bar_g;
            polyline_gap_trapezoidal(constants, k3, n) -> f64 = bounds::polyline_gap_trapezoidal;
            rule_gap(constants, k3, n) -> f64 = bounds::rule_gap;
            polyline_gap_left(constants, k3, n) -> f64 = bounds::polyline_gap_left;
            theorem_1_1_constant(setting) -> f64 = bounds::theorem_1_1_constant;
            theorem_1_3_constant(setting) -> f64 = bounds::theorem_1_3_constant;
            theorem_1_1_excess(setting, n) -> f64 = bounds::theorem_1_1_excess;
            theorem_1_3_excess(setting, n) -> f64 = bounds::theorem_1_3_excess;
            k2_sharp(setting) -> f64 = bounds::k2_sharp;
            cubic_gap(constants, rule, cube, n) -> f64 = bounds::cubic_gap;
            cubic_rule_gap(constants, cube, n) -> f64 = bounds::cubic_rule_gap;
            quartic_gap(constants, fourth, n) -> Option<f64> = bounds::quartic_gap;
            greatest_speed(constants, energy, rho, n) -> f64 = bounds::greatest_speed;
            greatest_difference(constants, k3, rho) -> f64 = bounds::greatest_difference;
            difference_step(constants, greatest, n) -> f64 = bounds::difference_step;
            squared_length(constants, rule, e, n) -> f64 = bounds::squared_length;
            spread(setting, rule, n, surplus) -> Spread = Spread::of_first_order;
            sharp_spread(setting, n, surplus) -> Option<Spread> = Spread::of_second_order;
            theorem_a_minimum_gap(setting, rule, n) -> f64 = bounds::theorem_a_minimum_gap;
            theorem_a_polyline_gap(setting, rule, n) -> f64 = bounds::theorem_a_polyline_gap;
            theorem_a_excess(setting, rule, n) -> f64 = bounds::theorem_a_excess;
            theorem_b_minimum_gap(setting, n) -> Option<f64> = bounds::theorem_b_minimum_gap;
            theorem_b_polyline_gap(setting, n) -> Option<f64> = bounds::theorem_b_polyline_gap;
            theorem_c_deficit(setting, rule, n) -> f64 = bounds::theorem_c_deficit;
            theorem_c_polyline_gap(setting, rule, n) -> f64 = bounds::theorem_c_polyline_gap;
            theorem_c_length_excess(setting, rule, n) -> f64 = bounds::theorem_c_length_excess;
            theorem_d_length_excess(setting, n) -> Option<f64> = bounds::theorem_d_length_excess;
            theorem_d_minimum_gap(setting, n) -> Option<f64> = bounds::theorem_d_minimum_gap;
            theorem_d_deficit(setting, n) -> Option<f64> = bounds::theorem_d_deficit;
            theorem_d_polyline_gap(setting, n) -> Option<f64> = bounds::theorem_d_polyline_gap;
            least_length_excess(setting, rule, n) -> Bound = bounds::least_length_excess;
            enclose(constants, dimension, computed) -> Result<Enclosure, BoundError> = bounds::enclose;
            convexity_modulus(constants, rule, greatest, n) -> Option<f64> = bounds::convexity_modulus;
            strict_convexity(constants, dimension, between) -> Option<f64> = bounds::strict_convexity;
            convex_excess(constants, dimension, between) -> Option<f64> = bounds::convex_excess;
            reach(setting, rule, n) -> f64 = bounds::reach;
        }
    };
}
pub(crate) use for_each_bound;

for_each_bound!(bounds);

#[cfg(test)]
mod tests {
    /// The entries, and the functions of the library.
    macro_rules! names {
        ($($entry:ident($($name:ident),*) -> $result:ty = $genuine:path;)*) => {
            [$((stringify!($entry), stringify!($genuine))),*]
        };
    }

    #[test]
    fn every_entry_is_the_function_of_its_name() {
        for (entry, genuine) in for_each_bound!(names) {
            let expected = match entry {
                "spread" => "Spread::of_first_order".to_owned(),
                "sharp_spread" => "Spread::of_second_order".to_owned(),
                _ => format!("bounds::{entry}"),
            };
            assert_eq!(genuine.replace(' ', ""), expected);
        }
    }
}
