//! The minima of every rule converge with the order that the rule claims.

use tautline_discretizations::{Interpolation, Rule};
use tautline_metrics::{KnownDistance, gallery::Shear};
use tautline_optimizers::{Minimum, leading_constants};

use crate::setup::{from_to, lowest};

const FROM: [f64; 2] = [0.0, 0.3];
const TO: [f64; 2] = [2.5, 1.5];

fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("a wave number")
}

fn squared_distance() -> f64 {
    shear().distance(&FROM.into(), &TO.into()).expect("known").powi(2)
}

fn minimum(rule: Rule, n: usize) -> Minimum<2> {
    lowest(&shear(), &from_to(FROM, TO), rule, n)
}

/// Returns `log₂` of the factor by which an error falls from 32 to 64 chords.
fn order(error: impl Fn(usize) -> f64) -> f64 {
    (error(32).abs() / error(64).abs()).log2()
}

/// The next term of the expansion is smaller by a factor of about `N` or `N²`, so that the observed
/// order is off by about `1/N = 0.03` for the endpoint rules, and less for the others.
#[test]
fn minima_converge_with_the_order_of_their_rule() {
    let d2 = squared_distance();
    for &rule in Rule::ALL {
        let order = order(|n| minimum(rule, n).energy - d2);
        let expected = f64::from(rule.error_exponent());
        assert!((order - expected).abs() <= 0.06, "{rule}: {order}");
    }
}

/// At their minimisers the energies of Simpson and Gauss differ from that of the reconstructed curve
/// by high orders of `1/N`.
#[test]
fn exact_rules_see_the_reconstructed_curve() {
    let gap = |rule: Rule, n: usize| {
        let sequence = minimum(rule, n).sequence;
        rule.energy(&shear(), &sequence) - Interpolation::new(&sequence).energy(&shear()).value
    };
    // On coarse grids, since a gap of order 6 is rounding on fine ones.
    let order = |rule: Rule| (gap(rule, 8).abs() / gap(rule, 16).abs()).log2();
    for (rule, expected) in [(Rule::SIMPSON, 4.0), (Rule::GAUSS_TWO, 4.0), (Rule::GAUSS_THREE, 6.0)]
    {
        let order = order(rule);
        // The next term is smaller by N⁻², with a factor of about (k d)²/10 for the wave number k.
        assert!((order - expected).abs() <= 0.3, "{rule}: {order}");
    }
}

/// The leading constants of the other rules follow from those of the paper's. A rule that sees the
/// reconstructed curve has the constant of its energy, `C = (1/12) ∫ γ̈ᵀHγ̈ ≥ 0`, so that its minimum is
/// above `d²` up to higher orders. The error of the true trapezoid on a chord is −2 times that of the
/// midpoint: its constant is `C + 2 (C − C_tra)`. The right endpoint has that of the left, negated.
#[test]
fn leading_constants_of_all_rules_follow_from_those_of_the_paper() {
    let d2 = squared_distance();
    let ends = from_to(FROM, TO);
    let fine = minimum(Rule::TRAPEZOIDAL, 512);
    let known = leading_constants(&shear(), &ends, &fine).expect("smooth");
    let bent = known.energy_trapezoidal;
    let ends_twice = bent + 2.0 * (bent - known.trapezoidal);
    // The constants differ from each other by far more than the tolerance.
    assert!(bent > 0.01 && (bent - known.trapezoidal).abs() > bent, "{known:?}");
    let n = 128.0_f64;
    for (rule, expected) in [
        (Rule::SIMPSON, bent),
        (Rule::GAUSS_TWO, bent),
        (Rule::GAUSS_THREE, bent),
        (Rule::TRUE_TRAPEZOID, ends_twice),
        (Rule::RIGHT_ENDPOINT, -known.left),
    ] {
        let scale = n.powi(rule.error_exponent());
        let found = scale * (minimum(rule, 128).energy - d2);
        // The next term of the expansion, with a constant of up to ten times the first.
        assert!(
            (found - expected).abs() <= 10.0 / scale * expected.abs(),
            "{rule}: {found} {expected}"
        );
    }
}
