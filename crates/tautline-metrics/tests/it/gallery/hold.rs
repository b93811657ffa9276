//! The constants hold at random points, for random parameters, and for near pairs.

use nalgebra::{SMatrix, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::gallery::{
    Bump, Checkerboard, Constant, Corrugated, CoupledCosines, EggCrate, Hill, Lens, Obstacle, Ramp,
    RotatingAnisotropy, Separable, Shear, SineProjection, SineProjections, SoftObstacles, Swirl,
    TwoChannels, TwoLinkArm, Valleys,
};

use crate::laws::{cube, hold};

/// Relative amplitudes with `|a| < 1`, and wave numbers.
fn wave() -> impl Strategy<Value = (f64, f64)> {
    (-0.95..0.95_f64, 0.2..4.0_f64)
}

/// Heights and widths, of either scale.
fn profile() -> impl Strategy<Value = (f64, f64)> {
    (0.05..5.0_f64, 0.1..3.0_f64)
}

#[test]
fn constants_of_constant_hold() {
    hold::<3, _, _>(1, (uniform::<_, 9>(-1.0..1.0_f64), 0.01..1.0_f64), |(entries, shift)| {
        let b = SMatrix::<f64, 3, 3>::from_column_slice(&entries);
        let a = b * b.transpose() + SMatrix::identity() * shift;
        (Constant::new(a).expect("positive definite"), 1.0)
    });
}

#[test]
fn constants_of_valleys_hold() {
    hold::<1, _, _>(2, Just(()), |()| (Valleys, 7.0));
    hold::<3, _, _>(3, Just(()), |()| (Valleys, 7.0));
}

#[test]
fn constants_of_ramp_hold() {
    hold(4, wave(), |(a, k)| (Ramp::new(a, k).expect("|a| < 1"), 3.0 / k));
}

#[test]
fn constants_of_shear_hold() {
    hold(5, (-3.0..3.0_f64, 0.2..4.0_f64), |(a, k)| (Shear::new(a, k).expect("k > 0"), 4.0));
}

#[test]
fn constants_of_separable_hold() {
    hold(6, uniform::<_, 3>(wave()), |waves| {
        let a = vector![waves[0].0, waves[1].0, waves[2].0];
        let k = vector![waves[0].1, waves[1].1, waves[2].1];
        (Separable::new(a, k).expect("|a| < 1"), 4.0)
    });
}

#[test]
fn constants_of_hill_hold() {
    let hill = |(h, s): (f64, f64)| (Hill::new(-h, s).expect("s > 0"), 3.0 * s);
    hold::<1, _, _>(7, profile(), hill);
    hold::<2, _, _>(8, profile(), hill);
    hold::<4, _, _>(9, profile(), hill);
}

#[test]
fn constants_of_lens_hold() {
    let lens = |(a, s): (f64, f64)| (Lens::new(a, s).expect("s > 0"), 3.0 * s);
    hold::<1, _, _>(10, profile(), lens);
    hold::<3, _, _>(11, profile(), lens);
}

#[test]
fn constants_of_bump_hold() {
    let bump = |(a, s): (f64, f64)| (Bump::new(a, s).expect("s > 0"), 3.0 * s);
    hold::<2, _, _>(12, profile(), bump);
    hold::<3, _, _>(13, profile(), bump);
}

#[test]
fn constants_of_soft_obstacles_hold() {
    hold::<2, _, _>(14, uniform::<_, 3>((cube(), profile())), |obstacles| {
        let obstacles =
            obstacles.map(|(centre, (height, width))| Obstacle { centre, height, width });
        (SoftObstacles::new(obstacles.to_vec()).expect("s > 0"), 4.0)
    });
}

#[test]
fn constants_of_swirl_hold() {
    hold(20, (-6.0..6.0_f64, 0.1..3.0_f64), |(angle, s)| {
        (Swirl::new(angle, s).expect("s > 0"), 3.0 * s)
    });
}

/// Amplitudes of either sign, and wave numbers: slopes `ak` up to 12.
fn surface() -> impl Strategy<Value = (f64, f64)> {
    (-3.0..3.0_f64, 0.2..4.0_f64)
}

#[test]
fn constants_of_egg_crate_hold() {
    hold(21, surface(), |(a, k)| (EggCrate::new(a, k).expect("k > 0"), 4.0));
}

#[test]
fn constants_of_corrugated_hold() {
    let sheet = |(a, k): (f64, f64)| (Corrugated::new(a, k).expect("k > 0"), 4.0);
    hold::<1, _, _>(22, surface(), sheet);
    hold::<3, _, _>(23, surface(), sheet);
}

#[test]
fn constants_of_checkerboard_hold() {
    hold(24, profile(), |(a, e)| (Checkerboard::new(a, e).expect("e > 0"), 3.0 * e));
}

#[test]
fn constants_of_two_channels_hold() {
    // Channels that overlap and channels that do not.
    hold(25, (profile(), 0.1..5.0_f64), |((a, s), beta)| {
        (TwoChannels::new(a, beta * s, s).expect("positive"), (beta + 3.0) * s)
    });
}

#[test]
fn constants_of_rotating_anisotropy_hold() {
    hold(15, (uniform(0.1..5.0_f64), cube()), |(eigenvalues, k)| {
        (RotatingAnisotropy::new(eigenvalues, k * 3.0).expect("positive"), 3.0)
    });
}

#[test]
fn constants_of_two_link_arm_hold() {
    // C = 1 and A = 1 + B² + excess.
    hold(16, (-2.0..2.0_f64, 0.01..2.0_f64), |(b, excess)| {
        (TwoLinkArm::new(1.0 + b * b + excess, b, 1.0).expect("definite"), 4.0)
    });
}

#[test]
fn constants_of_coupled_cosines_hold() {
    hold(17, Just(()), |()| (CoupledCosines, 3.2));
}

#[test]
fn constants_of_sine_projections_hold() {
    hold::<3, _, _>(18, uniform::<_, 4>((cube(), cube())), |terms| {
        let terms = terms.map(|(wave_vector, direction)| SineProjection { wave_vector, direction });
        (SineProjections::new(terms.to_vec()).expect("finite"), 4.0)
    });
    hold(19, Just(()), |()| (SineProjections::benchmark(), 3.0));
}
