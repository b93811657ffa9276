//! The flags of constants: isotropic metrics, and constants on a region only.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_metrics::{
    Bounded, LocallyBounded, Metric,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::*,
};

/// Returns whether `H` is a multiple of the identity at 40 points near the origin.
fn looks_isotropic<const D: usize>(g: &impl Metric<D>) -> bool {
    (0..40).all(|k| {
        let x = SVector::from_fn(|i, _| 0.3 * (f64::from(k) * (1.0 + i as f64).sqrt()).sin());
        let h: SMatrix<f64, D, D> = g.gram(&x);
        // This allows for the rounding of entries that are computed in different ways.
        (h - SMatrix::identity() * h[(0, 0)]).amax() <= 1e-14 * h[(0, 0)]
    })
}

#[track_caller]
fn on_balls<const D: usize>(g: &impl LocallyBounded<D>, isotropic: bool) {
    assert_eq!(looks_isotropic(g), isotropic);
    for radius in [0.0, 0.25] {
        let found = g.constants_within(&SVector::repeat(0.1), radius).expect("inside");
        assert_eq!(found.is_isotropic(), isotropic);
        assert!(found.is_local() && found.m_h().is_some());
    }
}

macro_rules! flags_are_right {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
        exact $exact:expr $(, with $distances:ident)?;
    )*) => {$(
        let metric = $metric.expect("in range");
        let constants = Bounded::<$D>::constants(&metric);
        let isotropic = looks_isotropic::<$D>(&metric);
        assert_eq!(constants.is_isotropic(), isotropic, stringify!($id));
        assert!(!constants.is_local(), stringify!($id));
    )*};
}

#[test]
fn metrics_are_marked_isotropic_if_and_only_if_they_are() {
    for_each_sample!(flags_are_right);
}

#[test]
fn constants_on_balls_are_local_and_keep_the_other_flags() {
    on_balls::<2>(&Sphere, true);
    on_balls::<3>(&Hyperbolic, true);
    on_balls(&GaussianFisher, false);
    on_balls(&Constant::new(matrix![2.0, 0.5; 0.5, 1.0]).expect("definite"), false);
    on_balls::<2>(&&Sphere, true);
    on_balls::<2>(&Scaled::new(Sphere, 3.0).expect("positive"), true);
    on_balls::<2>(&Sum::new(Sphere, Hyperbolic), true);
    on_balls(&Sum::new(Sphere, GaussianFisher), false);
    on_balls(&Sum::new(GaussianFisher, Sphere), false);
    on_balls::<4>(&Product::<_, _, 2, 2>::new(Sphere, GaussianFisher), false);
    let slanted = AffinePullback::new(Sphere, matrix![1.0, 0.5; 0.0, 1.0], [0.1, 0.0]);
    on_balls(&slanted.expect("invertible"), false);
}

/// If the two halves differ by rounding, they are made equal.
#[test]
fn a_constant_metric_is_symmetric_to_the_last_bit() {
    let next = 0.5_f64.next_up();
    let g = Constant::new(matrix![2.0, 0.5; next, 1.0]).expect("symmetric up to rounding");
    let h: SMatrix<f64, 2, 2> = g.gram(&vector![0.0, 0.0]);
    assert_eq!(h, matrix![2.0, 0.5; 0.5, 1.0]);
}

/// Fails unless the constants that are `exact` in a sample are those of the metric's row in the
/// table at the top of the gallery.
#[track_caller]
fn assert_as_in_the_table(sample: &str, metric: &str, exact: [bool; 4]) {
    let table = include_str!("../../../src/gallery/mod.rs");
    let rows = table.lines().filter(|line| line.starts_with("//! | [`"));
    let mut rows = rows.map(|row| row.split(" | ").collect::<Vec<_>>());
    let words = || metric.split(|c: char| !c.is_alphanumeric());
    let row = rows.find(|row| words().any(|word| row[1] == format!("[`{word}`]")));
    let row = row.unwrap_or_else(|| panic!("{metric} has no row"));
    let stated = match row[4] {
        "exact" => [true; 4],
        "exact but `M_H`" => [true, true, true, false],
        "exact but `L_H`" => [true, true, false, true],
        "exact but `L_H`, `M_H`" => [true, true, false, false],
        "bounds" => [false; 4],
        other => panic!("{metric}: {other}"),
    };
    let rounded = match row[1] {
        // The eigenvalues are computed.
        "[`Constant`]" => [true, true, false, false],
        patch if patch.ends_with("Patch`]") => [false, false, true, true],
        _ => [false; 4],
    };
    let expected: [bool; 4] = std::array::from_fn(|k| stated[k] && !rounded[k]);
    assert_eq!(exact, expected, "{sample}");
}

macro_rules! exact_constants_are_as_in_the_table {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in $cell:expr,
        exact $exact:expr $(, with $distances:ident)?;
    )*) => {
        $(assert_as_in_the_table(stringify!($id), stringify!($metric), $exact);)*
    };
}

/// A constant that is not marked exact is hardly checked.
#[test]
fn constants_are_marked_exact_if_and_only_if_the_table_says_so() {
    for_each_sample!(exact_constants_are_as_in_the_table);
}
