//! Metrics that lie: each is rejected, with the point, the direction and both numbers.

use std::f64::consts::TAU;

use tautline::{
    MetricError,
    gallery::{
        CoupledCosines, Hill, Lens, Ramp, RotatingAnisotropy, Separable, Shear, TwoLinkArm, Valleys,
    },
};
use tautline_verify::{
    kit::{Constant, Fault, Lie, MetricCase, Outcome, WithConstants, metric},
    prelude::*,
};

/// The metric with one of its constants multiplied by a factor, put to the law about that constant.
fn put<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: Region<D>,
    constant: Constant,
    factor: f64,
) -> Outcome {
    let claimed = metric.constants();
    let by = |which| if which == constant { factor } else { 1.0 };
    let constants = Constants::new(
        claimed.c1() * by(Constant::C1),
        claimed.c2() * by(Constant::C2),
        claimed.l_h() * by(Constant::LH),
    );
    let m_h = claimed.m_h().expect("claimed") * by(Constant::MH);
    let constants = constants.and_then(|constants| constants.with_m_h(m_h)).expect("in order");
    let liar = MetricCase::new(WithConstants { metric, constants }, region, Effort::default());
    match constant {
        Constant::C1 => metric::c1_is_a_lower_bound(&liar),
        Constant::C2 => metric::c2_is_an_upper_bound(&liar),
        Constant::LH => metric::l_h_bounds_the_derivative(&liar),
        Constant::MH => metric::m_h_bounds_the_second_derivative(&liar),
    }
}

fn measure<M: Bounded<D>, const D: usize>(name: &str, metric: &M, region: Region<D>) {
    for constant in Constant::ALL {
        let sizes = [0.1, 0.05, 0.01, 1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9];
        let caught: Vec<f64> = sizes.into_iter().filter(|size| {
            let factor = if constant == Constant::C1 { 1.0 + size } else { 1.0 - size };
            !put(metric, region, constant, factor).holds()
        }).collect();
        println!("{name} {constant}: slack {:.9} caught down to {:?}", put(metric, region, constant, 1.0).slack, caught.last());
    }
}

#[test]
fn measure_all() {
    let cube = |size: f64| Region::<2>::cell([-size; 2], [size; 2]);
    measure("valleys", &Valleys, Region::<2>::cell([0.0; 2], [TAU; 2]));
    measure("ramp", &Ramp::new(0.5, 1.0).unwrap(), Region::<1>::cell([-8.0], [8.0]));
    measure("separable", &Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]).unwrap(), Region::<3>::cell([-3.2; 3], [3.2; 3]));
    measure("shear", &Shear::new(0.5, 1.0).unwrap(), Region::<2>::cell([0.0; 2], [TAU; 2]));
    measure("lens", &Lens::new(1.0, 0.5).unwrap(), cube(3.0));
    measure("bump", &tautline::gallery::Bump::new(1.0, 0.5).unwrap(), cube(3.0));
    measure("hill", &Hill::new(0.5, 0.5).unwrap(), cube(3.0));
    measure("aniso", &RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]).unwrap(), cube(2.0));
    measure("arm", &TwoLinkArm::new(4.0, 0.8, 1.0).unwrap(), Region::<2>::cell([0.0; 2], [TAU; 2]));
    measure("cosines", &CoupledCosines, Region::<3>::cell([0.0; 3], [TAU; 3]));
    measure("sine projections", &tautline::gallery::SineProjections::benchmark(), Region::<8>::cell([-1.5; 8], [1.5; 8]));
}
