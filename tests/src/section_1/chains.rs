//! The inequalities of Theorems 1.1 to 1.4, each under its name.

use proptest::prelude::*;
use tautline::{
    Bounded, LeftEndpoint, Trapezoidal,
    bounds::{
        c_tra_sharp_g, k3_bar_g, polyline_gap_left, polyline_gap_trapezoidal, theorem_1_1_constant,
        theorem_1_1_excess, theorem_1_1_minimum_gap, theorem_1_1_polyline_gap,
        theorem_1_2_length_excess, theorem_1_3_constant, theorem_1_3_excess,
        theorem_1_3_minimum_gap, theorem_1_3_polyline_gap, theorem_1_4_length_excess,
    },
};

use super::observed::Observed;
use crate::{
    families::Known,
    random::{Verdict, for_all, subintervals},
};

/// Tests Theorems 1.1 and 1.2 on random cases of a family.
#[track_caller]
pub(super) fn trapezoidal<M, const D: usize>(
    seed: u64,
    cases: u32,
    family: impl Strategy<Value = Known<M, D>>,
) where
    M: Bounded<D> + Clone + std::fmt::Debug,
{
    for_all(seed, cases, (family, subintervals()), |(known, n)| {
        let seen = Observed::new(&known, Trapezoidal, n)?;
        every_curve(&seen)?;
        theorem_1_1(&seen)?;
        theorem_1_2(&seen)
    });
}

/// Tests Theorems 1.3 and 1.4 on random cases of a family.
#[track_caller]
pub(super) fn left_endpoint<M, const D: usize>(
    seed: u64,
    cases: u32,
    family: impl Strategy<Value = Known<M, D>>,
) where
    M: Bounded<D> + Clone + std::fmt::Debug,
{
    for_all(seed, cases, (family, subintervals()), |(known, n)| {
        let seen = Observed::new(&known, LeftEndpoint, n)?;
        every_curve(&seen)?;
        theorem_1_3(&seen)?;
        theorem_1_4(&seen)
    });
}

/// Proposition 6.3: no curve between the sets has less energy than `d²`, or less length than `d`.
fn every_curve(seen: &Observed) -> Verdict {
    seen.at_most("d² ≤ E(γᵖˡ)", seen.d2, seen.energy.value)?;
    seen.at_most("d² ≤ L(γᵖˡ)²", seen.d2, seen.length2.value)?;
    seen.at_most("L(γᵖˡ)² ≤ E(γᵖˡ)", seen.length2.value, seen.energy.value)
}

fn theorem_1_1(seen: &Observed) -> Verdict {
    let &Observed { setting, n, d2, discrete, .. } = seen;
    let energy = seen.energy.value;
    // C/√N and C/N once more by hand, so that the powers of N are not taken on trust.
    let (constant, count) = (theorem_1_1_constant(setting), n.get() as f64);
    let (root, whole) = (constant / count.sqrt(), constant / count);
    let premise = d2 + c_tra_sharp_g(setting);
    seen.at_most("E_tra,N ≤ d² + C_tra♯ (the premise)", discrete, premise)?;
    seen.at_most("d² − C/√N ≤ E(γᵖˡ) − C/√N", d2 - root, energy - root)?;
    seen.at_most("E(γᵖˡ) − C/√N ≤ E_tra,N", energy - root, discrete)?;
    seen.at_most("d² − C/√N ≤ E_tra,N", d2 - root, discrete)?;
    seen.at_most("E_tra,N ≤ d² + C/N", discrete, d2 + whole)?;
    let gap = theorem_1_1_polyline_gap(setting, n);
    seen.at_most("E(γᵖˡ) − E_tra,N ≤ theorem_1_1_polyline_gap", energy - discrete, gap)?;
    let proof = polyline_gap_trapezoidal(setting.constants(), k3_bar_g(setting), n);
    seen.at_most("E(γᵖˡ) − E_tra,N ≤ L_H K̄₃³/4√N", energy - discrete, proof)?;
    let gap = theorem_1_1_minimum_gap(setting, n);
    seen.at_most("theorem_1_1_minimum_gap ≤ C/N", gap, whole * (1.0 + 1e-15))?;
    seen.at_most("E_tra,N − d² ≤ theorem_1_1_minimum_gap", discrete - d2, gap)?;
    let excess = theorem_1_1_excess(setting, n);
    seen.at_most("E(γᵖˡ) − d² ≤ theorem_1_1_excess", energy - d2, excess)
}

fn theorem_1_2(seen: &Observed) -> Verdict {
    let &Observed { setting, n, d2, .. } = seen;
    let excess = seen.length2.value - d2;
    seen.at_most("0 ≤ L(γᵖˡ)² − d²", 0.0, excess)?;
    let bound = theorem_1_1_constant(setting) / (n.get() as f64).sqrt();
    seen.at_most("L(γᵖˡ)² − d² ≤ C/√N", excess, bound)?;
    let bound = theorem_1_2_length_excess(setting, n);
    seen.at_most("L(γᵖˡ)² − d² ≤ theorem_1_2_length_excess", excess, bound)
}

fn theorem_1_3(seen: &Observed) -> Verdict {
    let &Observed { setting, n, d2, discrete, .. } = seen;
    let energy = seen.energy.value;
    let root = theorem_1_3_constant(setting) / (n.get() as f64).sqrt();
    // ½ L_H K̄₃³ is the gap of Proposition 8.1 at N = 1.
    let cube = polyline_gap_left(setting.constants(), k3_bar_g(setting), 1.try_into().expect("1"));
    let premise = d2 + c_tra_sharp_g(setting) + cube;
    seen.at_most("E_l,N ≤ d² + C_tra♯ + ½ L_H K̄₃³ (the premise)", discrete, premise)?;
    seen.at_most("d² − C/√N ≤ E(γᵖˡ) − C/√N", d2 - root, energy - root)?;
    seen.at_most("E(γᵖˡ) − C/√N ≤ E_l,N", energy - root, discrete)?;
    seen.at_most("d² − C/√N ≤ E_l,N", d2 - root, discrete)?;
    seen.at_most("E_l,N ≤ d² + C/√N", discrete, d2 + root)?;
    let gap = theorem_1_3_polyline_gap(setting, n);
    seen.at_most("E(γᵖˡ) − E_l,N ≤ theorem_1_3_polyline_gap", energy - discrete, gap)?;
    let gap = theorem_1_3_minimum_gap(setting, n);
    seen.at_most("E_l,N − d² ≤ theorem_1_3_minimum_gap", discrete - d2, gap)?;
    let excess = theorem_1_3_excess(setting, n);
    seen.at_most("E(γᵖˡ) − d² ≤ theorem_1_3_excess", energy - d2, excess)
}

fn theorem_1_4(seen: &Observed) -> Verdict {
    let &Observed { setting, n, d2, .. } = seen;
    let excess = seen.length2.value - d2;
    seen.at_most("0 ≤ L(γᵖˡ)² − d²", 0.0, excess)?;
    let bound = theorem_1_3_constant(setting) / (n.get() as f64).sqrt();
    seen.at_most("L(γᵖˡ)² − d² ≤ C/√N", excess, bound)?;
    let bound = theorem_1_4_length_excess(setting, n);
    seen.at_most("L(γᵖˡ)² − d² ≤ theorem_1_4_length_excess", excess, bound)
}
