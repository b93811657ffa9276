//! `Bounds`: the bounds and constants of a subject, as a table of functions.

use std::num::NonZeroUsize;

use tautline::{
    Constants,
    bounds::{
        self, BetweenPoints, Bound, BoundError, Computed, Enclosure, PaperRule, Setting, Spread,
    },
};

use super::{Asked, Subject};

/// The type of an argument, by its name.
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

/// Makes the table, the set of its replaced entries, and a method of [`Subject`] for each entry.
macro_rules! table {
    ($($(#[$doc:meta])* $entry:ident($($name:ident),*) -> $result:ty = $genuine:path;)*) => {
        /// The bounds and constants in use: a function for each.
        ///
        /// `Bounds { rule_gap: |_, _, _| 0.0, ..Bounds::LIBRARY }` replaces an entry. The methods
        /// of [`Subject`] with the same names call the entries.
        #[derive(Clone, Copy, Debug)]
        pub struct Bounds {
            $($(#[$doc])* pub $entry: fn($(kind!($name)),*) -> $result,)*
        }

        /// The entries, by their names.
        #[expect(non_camel_case_types, reason = "the names of the entries")]
        #[derive(Clone, Copy)]
        enum Entry {
            $($entry,)*
        }

        impl Bounds {
            /// The functions of the library.
            pub const LIBRARY: Self = Self { $($entry: $genuine,)* };

            /// The entries that differ from [`GENUINE`] in address: one address means one function.
            pub(super) fn replaced(&self) -> Asked {
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

        impl Subject {
            $(
                $(#[$doc])*
                pub fn $entry(&self, $($name: kind!($name)),*) -> $result {
                    self.note(|asked| asked.add_bound(Entry::$entry as usize));
                    (self.bounds.$entry)($($name),*)
                }
            )*
        }
    };
}

/// The functions of the library, each at one address: a constant may be compiled more than once.
pub(crate) static GENUINE: Bounds = Bounds::LIBRARY;

table! {
    /// Returns `K_{1,g}`, in `ℓ`.
    k1_g(setting) -> f64 = bounds::k1_g;
    /// Returns `K_{2,g}`, in `ℓ`.
    k2_g(setting) -> f64 = bounds::k2_g;
    /// Returns `C_tra(N)`, in `m²`.
    c_tra(constants, k1, k2, n) -> f64 = bounds::c_tra;
    /// Returns `C_tra♯`, in `m²`.
    c_tra_sharp(constants, k1, k2) -> f64 = bounds::c_tra_sharp;
    /// Returns `K̄_{3,g}`, in `ℓ`.
    k3_bar_g(setting) -> f64 = bounds::k3_bar_g;
    /// Returns `K̄_{4,g}`, in `ℓ`.
    k4_bar_g(setting) -> f64 = bounds::k4_bar_g;
    /// Returns the bound of Proposition 7.9, in `m²`.
    polyline_gap_trapezoidal(constants, k3, n) -> f64 = bounds::polyline_gap_trapezoidal;
    /// Returns the bound of Proposition 8.1, in `m²`.
    rule_gap(constants, k3, n) -> f64 = bounds::rule_gap;
    /// Returns the bound of Proposition 8.2, in `m²`.
    polyline_gap_left(constants, k3, n) -> f64 = bounds::polyline_gap_left;
    /// Returns the constant `C` of Theorems 1.1 and 1.2, in `m²`.
    theorem_1_1_constant(setting) -> f64 = bounds::theorem_1_1_constant;
    /// Returns the constant `C` of Theorems 1.3 and 1.4, in `m²`.
    theorem_1_3_constant(setting) -> f64 = bounds::theorem_1_3_constant;
    /// Returns the bound on `E(γᵖˡ) − d²` in the proof of Theorem 1.1, in `m²`.
    theorem_1_1_excess(setting, n) -> f64 = bounds::theorem_1_1_excess;
    /// Returns the bound on `E(γᵖˡ) − d²` in the proof of Theorem 1.3, in `m²`.
    theorem_1_3_excess(setting, n) -> f64 = bounds::theorem_1_3_excess;
    /// Returns the `K₂` of Lemma S.1, in `ℓ`.
    k2_sharp(setting) -> f64 = bounds::k2_sharp;
    /// Returns the bound on `|E(γᵖˡ) − E_N|` by the mean cube in Lemma S.2, in `m²`.
    cubic_gap(constants, rule, cube, n) -> f64 = bounds::cubic_gap;
    /// Returns the bound on `|E_l,N − E_tra,N|` by the mean cube in Lemma S.2, in `m²`.
    cubic_rule_gap(constants, cube, n) -> f64 = bounds::cubic_rule_gap;
    /// Returns the bound on `|E(γᵖˡ) − E_tra,N|` by the mean fourth power of Lemma S.2, in `m²`.
    quartic_gap(constants, fourth, n) -> Option<f64> = bounds::quartic_gap;
    /// Returns the bound on `max qₙ` of Lemma S.3, in `m`.
    greatest_speed(constants, energy, rho, n) -> f64 = bounds::greatest_speed;
    /// Returns the bound on `max |βₙ|` of Lemma S.3, in `ℓ`.
    greatest_difference(constants, k3, rho) -> f64 = bounds::greatest_difference;
    /// Returns the bound on `|βₙ − βₙ₋₁|` of Lemma S.3, in `ℓ`.
    difference_step(constants, greatest, n) -> f64 = bounds::difference_step;
    /// Returns the bound on `L(γᵖˡ)²` by the discrete energy of Lemma S.5, in `m²`.
    squared_length(constants, rule, e, n) -> f64 = bounds::squared_length;
    /// Returns the spread of Lemma S.5 by the first order, pure numbers.
    spread(setting, rule, n, surplus) -> Spread = Spread::of_first_order;
    /// Returns the spread of Lemma S.5 by the second order, pure numbers.
    sharp_spread(setting, n, surplus) -> Option<Spread> = Spread::of_second_order;
    /// Returns the bound of order `1/N` of `min E_N − d²`, in `m²`.
    theorem_a_minimum_gap(setting, rule, n) -> f64 = bounds::theorem_a_minimum_gap;
    /// Returns the bound on `E(γᵖˡ) − E_N` and `d² − E_N` of Theorem A, in `m²`.
    theorem_a_polyline_gap(setting, rule, n) -> f64 = bounds::theorem_a_polyline_gap;
    /// Returns the bound on `E(γᵖˡ) − d²` of Theorem A, in `m²`.
    theorem_a_excess(setting, rule, n) -> f64 = bounds::theorem_a_excess;
    /// Returns the bound of order `1/N²` of `min E_tra,N − d²` of Theorem B, in `m²`.
    theorem_b_minimum_gap(setting, n) -> Option<f64> = bounds::theorem_b_minimum_gap;
    /// Returns the bound on `|E(γᵖˡ) − E_tra,N|` of Theorem B, in `m²`.
    theorem_b_polyline_gap(setting, n) -> Option<f64> = bounds::theorem_b_polyline_gap;
    /// Returns the bound on `d² − E_N` of Theorem C, in `m²`.
    theorem_c_deficit(setting, rule, n) -> f64 = bounds::theorem_c_deficit;
    /// Returns the bound on `|E(γᵖˡ) − E_N|` of Theorem C, in `m²`.
    theorem_c_polyline_gap(setting, rule, n) -> f64 = bounds::theorem_c_polyline_gap;
    /// Returns the bound on `L(γᵖˡ)² − d²` of Theorem C, in `m²`.
    theorem_c_length_excess(setting, rule, n) -> f64 = bounds::theorem_c_length_excess;
    /// Returns the bound on `L(γᵖˡ)² − d²` of Theorem D, in `m²`.
    theorem_d_length_excess(setting, n) -> Option<f64> = bounds::theorem_d_length_excess;
    /// Returns the bound of order `1/N²` of `min E_tra,N − d²` of Theorem D, in `m²`.
    theorem_d_minimum_gap(setting, n) -> Option<f64> = bounds::theorem_d_minimum_gap;
    /// Returns the bound on `d² − E_tra,N` of Theorem D, in `m²`.
    theorem_d_deficit(setting, n) -> Option<f64> = bounds::theorem_d_deficit;
    /// Returns the bound on `|E(γᵖˡ) − E_tra,N|` of Theorem D, in `m²`.
    theorem_d_polyline_gap(setting, n) -> Option<f64> = bounds::theorem_d_polyline_gap;
    /// Returns the least of all bounds of `L(γᵖˡ)² − d²`, in `m²`.
    least_length_excess(setting, rule, n) -> Bound = bounds::least_length_excess;
    /// Returns the enclosure of `d²` of Proposition S.6.
    ///
    /// # Errors
    ///
    /// As [`bounds::enclose`].
    enclose(constants, dimension, computed) -> Result<Enclosure, BoundError> = bounds::enclose;
    /// Returns the modulus of convexity of Proposition S.7, in `m²/ℓ²`.
    convexity_modulus(constants, rule, greatest, n) -> Option<f64> = bounds::convexity_modulus;
    /// Returns the lower bound of the discrete minimum of Proposition S.7, in `m²`.
    strict_convexity(constants, dimension, between) -> Option<f64> = bounds::strict_convexity;
}
