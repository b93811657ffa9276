//! The list of all checks.

use super::{Check, numerics, paper, sharper};

/// Returns all checks, in the paper's order.
#[must_use]
pub fn suite() -> Vec<Check> {
    [
        paper::section_1::CHECKS,
        paper::theorem_witnesses::CHECKS,
        numerics::orders::CHECKS,
        numerics::leading_constants::CHECKS,
        numerics::golden::CHECKS,
        numerics::gradients::CHECKS,
        paper::section_3::CHECKS,
        paper::section_4::clocks::CHECKS,
        paper::section_4::normal_balls::CHECKS,
        paper::section_4::constant_speed::CHECKS,
        paper::section_5::CHECKS,
        numerics::global_minima::CHECKS,
        paper::section_6::CHECKS,
        paper::existence::CHECKS,
        paper::section_7_morrey::CHECKS,
        paper::section_7_algebra::CHECKS,
        paper::section_7_sampling::CHECKS,
        paper::section_7_apriori::CHECKS,
        paper::point_sequences::CHECKS,
        numerics::proved_numbers::CHECKS,
        numerics::tables::CHECKS,
        paper::section_9::CHECKS,
        paper::dropped::theorems::CHECKS,
        paper::dropped::energy_and_length::CHECKS,
        paper::dropped::unneeded::CHECKS,
        paper::dropped::apriori::CHECKS,
        paper::dropped::rates::CHECKS,
        sharper::lemmas::CHECKS,
        sharper::theorems::CHECKS,
        sharper::locality::CHECKS,
        sharper::witnesses::CHECKS,
        sharper::speeds::CHECKS,
        sharper::convex_excess::CHECKS,
        sharper::convexity::CHECKS,
        sharper::monotone::CHECKS,
        sharper::leading::CHECKS,
        sharper::golden::CHECKS,
        sharper::dropped::CHECKS,
    ]
    .concat()
}
