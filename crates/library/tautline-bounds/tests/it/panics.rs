//! Arguments that are negative, out of range or NaN panic with a message.

use std::{
    num::NonZeroUsize,
    panic::{UnwindSafe, catch_unwind},
};

use tautline_bounds::{self as bounds, Constants, PaperRule, Setting, Spread};

const ONE: NonZeroUsize = NonZeroUsize::MIN;
const TRA: PaperRule = PaperRule::Trapezoidal;

fn constants() -> Constants {
    Constants::new(1.0, 5.0, 7.0).and_then(|c| c.with_m_h(6.0)).expect("in order")
}

/// A call with one bad argument, together with the beginning of its panic message.
type Call = (&'static str, fn(f64) -> f64);

const CALLS: [Call; 24] = [
    ("K1 must", |bad| bounds::c_tra(constants(), bad, 3.0, ONE)),
    ("K2 must", |bad| bounds::c_tra(constants(), 3.0, bad, ONE)),
    ("K1 must", |bad| bounds::c_tra_sharp(constants(), bad, 3.0)),
    ("K2 must", |bad| bounds::c_tra_sharp(constants(), 3.0, bad)),
    ("K3 must", |bad| bounds::polyline_gap_trapezoidal(constants(), bad, ONE)),
    ("K3 must", |bad| bounds::polyline_gap_left(constants(), bad, ONE)),
    ("K3 must", |bad| bounds::rule_gap(constants(), bad, ONE)),
    ("the mean cube must", |bad| bounds::cubic_gap(constants(), TRA, bad, ONE)),
    ("the mean cube must", |bad| bounds::cubic_rule_gap(constants(), bad, ONE)),
    ("the mean fourth power must", |bad| {
        bounds::quartic_gap(constants(), bad, ONE).expect("M_H is known")
    }),
    ("an energy must", |bad| bounds::squared_length(constants(), TRA, bad, ONE)),
    ("the greatest difference must", |bad| {
        bounds::convexity_modulus(constants(), TRA, bad, ONE).expect("M_H is known")
    }),
    ("the surplus must", |bad| {
        let setting = Setting::new(constants(), 1.0, 2).expect("valid");
        Spread::of_first_order(setting, TRA, ONE, bad).cube
    }),
    ("the acceleration must", |bad| bounds::velocity_error(bad, 0.5, ONE)),
    ("θ must", |bad| bounds::velocity_error(1.0, bad, ONE)),
    ("K1 and K2 must", |bad| bounds::sampling_rise(constants(), bad, 1.0, ONE)),
    ("K1 and K2 must", |bad| bounds::sampling_fall(constants(), 1.0, bad, ONE)),
    ("A1 and A2 must", |bad| bounds::pointwise_fall(constants(), bad, 1.0, ONE)),
    ("A1 and A2 must", |bad| {
        bounds::pointwise_rise(constants(), PaperRule::LeftEndpoint, 1.0, bad, ONE)
    }),
    ("an energy must", |bad| bounds::greatest_speed(constants(), bad, 0.0, ONE)),
    ("the mean residual must", |bad| bounds::greatest_speed(constants(), 1.0, bad, ONE)),
    ("K3 must", |bad| bounds::greatest_difference(constants(), bad, 0.0)),
    ("the mean residual must", |bad| bounds::greatest_difference(constants(), 1.0, bad)),
    ("the greatest difference must", |bad| bounds::difference_step(constants(), bad, ONE)),
];

fn message(call: impl FnOnce() -> f64 + UnwindSafe) -> String {
    let payload = catch_unwind(call).expect_err("a panic");
    match payload.downcast::<String>() {
        Ok(message) => *message,
        Err(payload) => payload.downcast::<&str>().expect("a message").to_string(),
    }
}

#[test]
fn bad_arguments_panic() {
    for bad in [-1.0, f64::NAN] {
        for (k, (begin, call)) in CALLS.into_iter().enumerate() {
            let message = message(move || call(bad));
            let names_the_number = message.contains(&bad.to_string());
            assert!(message.starts_with(begin) && names_the_number, "call {k}: {message}");
        }
    }
    let theta = message(|| bounds::velocity_error(1.0, 1.5, ONE));
    assert_eq!(theta, "θ must be between 0 and 1, got 1.5");
    let dimension = message(|| bounds::christoffel_bound(constants(), 0));
    assert_eq!(dimension, "D must be at least 1");
}
