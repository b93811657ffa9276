//! The rules, one a file.

use crate::Rule;

mod gauss_three;
mod gauss_two;
mod left_endpoint;
mod right_endpoint;
mod simpson;
mod trapezoidal;
mod true_trapezoid;

impl Rule {
    /// The rules of this library. Files, Python and the command know them by their
    /// [names](Rule::name).
    pub const ALL: &'static [Rule] = &[
        Rule::TRAPEZOIDAL,
        Rule::LEFT_ENDPOINT,
        Rule::RIGHT_ENDPOINT,
        Rule::TRUE_TRAPEZOID,
        Rule::SIMPSON,
        Rule::GAUSS_TWO,
        Rule::GAUSS_THREE,
    ];

    /// The names of [these rules](Rule::ALL), in the same order.
    pub const NAMES: [&str; Rule::ALL.len()] = {
        let mut names = [""; Rule::ALL.len()];
        let mut k = 0;
        while k < names.len() {
            names[k] = Rule::ALL[k].name();
            k += 1;
        }
        names
    };
}
