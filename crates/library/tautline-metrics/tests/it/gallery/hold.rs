//! The constants hold at random points, for random parameters, and for pairs of points close
//! together.

use nalgebra::{SMatrix, SVector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::gallery::*;

use crate::laws::{constants_hold, cube};

/// Draws relative amplitudes with `|a| < 1`, and wave numbers.
fn wave() -> impl Strategy<Value = (f64, f64)> {
    (-0.95..0.95_f64, 0.2..4.0_f64)
}

/// Draws heights and widths, of either scale.
fn profile() -> impl Strategy<Value = (f64, f64)> {
    (0.05..5.0_f64, 0.1..3.0_f64)
}

/// Draws amplitudes of either sign, and wave numbers, with slopes `ak` up to 12.
fn surface() -> impl Strategy<Value = (f64, f64)> {
    (-3.0..3.0_f64, 0.2..4.0_f64)
}

fn hill((h, s): (f64, f64)) -> (Hill, f64) {
    (Hill::new(-h, s).expect("s > 0"), 3.0 * s)
}

fn lens((a, s): (f64, f64)) -> (Lens, f64) {
    (Lens::new(a, s).expect("s > 0"), 3.0 * s)
}

fn bump((a, s): (f64, f64)) -> (Bump, f64) {
    (Bump::new(a, s).expect("s > 0"), 3.0 * s)
}

fn sheet((a, k): (f64, f64)) -> (Corrugated, f64) {
    (Corrugated::new(a, k).expect("k > 0"), 4.0)
}

constants_hold! {
    constant, 3, seed 1: (uniform::<_, 9>(-1.0..1.0_f64), 0.01..1.0_f64), |(entries, shift)| {
        let b = SMatrix::<f64, 3, 3>::from_column_slice(&entries);
        let a = b * b.transpose() + SMatrix::identity() * shift;
        (Constant::new(a).expect("positive definite"), 1.0)
    };
    valleys_on_a_line, 1, seed 2: Just(()), |()| (Valleys, 7.0);
    valleys_in_space, 3, seed 3: Just(()), |()| (Valleys, 7.0);
    ramp, 1, seed 4: wave(), |(a, k)| (Ramp::new(a, k).expect("|a| < 1"), 3.0 / k);
    shear, 2, seed 5: surface(), |(a, k)| (Shear::new(a, k).expect("k > 0"), 4.0);
    separable, 3, seed 6: uniform::<_, 3>(wave()), |waves| {
        let (a, k) = (waves.map(|wave| wave.0), waves.map(|wave| wave.1));
        (Separable::new(a, k).expect("|a| < 1"), 4.0)
    };
    hill_on_a_line, 1, seed 7: profile(), hill;
    hill_in_a_plane, 2, seed 8: profile(), hill;
    hill_in_four_dimensions, 4, seed 9: profile(), hill;
    lens_on_a_line, 1, seed 10: profile(), lens;
    lens_in_space, 3, seed 11: profile(), lens;
    bump_in_a_plane, 2, seed 12: profile(), bump;
    bump_in_space, 3, seed 13: profile(), bump;
    soft_obstacles, 2, seed 14: uniform::<_, 3>((cube(), profile())), |obstacles| {
        let obstacles =
            obstacles.map(|(centre, (height, width))| Obstacle { centre, height, width });
        (SoftObstacles::new(obstacles.to_vec()).expect("s > 0"), 4.0)
    };
    swirl, 2, seed 20: (-6.0..6.0_f64, 0.1..3.0_f64), |(angle, s)| {
        (Swirl::new(angle, s).expect("s > 0"), 3.0 * s)
    };
    egg_crate, 2, seed 21: surface(), |(a, k)| (EggCrate::new(a, k).expect("k > 0"), 4.0);
    corrugated_on_a_line, 1, seed 22: surface(), sheet;
    corrugated_in_space, 3, seed 23: surface(), sheet;
    checkerboard, 2, seed 24: profile(), |(a, e)| {
        (Checkerboard::new(a, e).expect("e > 0"), 3.0 * e)
    };
    // The cases include channels that overlap and channels that do not.
    two_channels, 2, seed 25: (profile(), 0.1..5.0_f64), |((a, s), beta)| {
        (TwoChannels::new(a, beta * s, s).expect("positive"), (beta + 3.0) * s)
    };
    rotating_anisotropy, 2, seed 15: (uniform(0.1..5.0_f64), cube()),
        |(eigenvalues, k): ([f64; 2], SVector<f64, 2>)| {
            (RotatingAnisotropy::new(eigenvalues, k * 3.0).expect("positive"), 3.0)
        };
    // C = 1 and A = 1 + B² + excess.
    two_link_arm, 2, seed 16: (-2.0..2.0_f64, 0.01..2.0_f64), |(b, excess)| {
        (TwoLinkArm::new(1.0 + b * b + excess, b, 1.0).expect("definite"), 4.0)
    };
    coupled_cosines, 3, seed 17: Just(()), |()| (CoupledCosines, 3.2);
    sine_projections, 3, seed 18: uniform::<_, 4>((cube(), cube())), |terms| {
        let terms = terms.map(|(wave_vector, direction)| SineProjection { wave_vector, direction });
        (SineProjections::new(terms.to_vec()).expect("finite"), 4.0)
    };
    sine_projections_of_the_benchmark, 8, seed 19: Just(()), |()| {
        (SineProjections::benchmark(), 3.0)
    };
}
