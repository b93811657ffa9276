//! Distances that are known in closed form.

use nalgebra::{SMatrix, SVector};
use tautline_chance::Random;
use tautline_check::Region;
use tautline_formula::Formula;
use tautline_metrics::gallery::Constant;

use crate::helpers::{one_level, point};

fn constant<const D: usize>(seed: u64) {
    let mut random = Random(seed);
    for _ in 0..5 {
        let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-0.4, 0.4));
        let h = a.transpose() * a + SMatrix::identity();
        let [x, y]: [SVector<f64, D>; 2] =
            std::array::from_fn(|_| SVector::from_fn(|_, _| random.between(-1.0, 1.0)));
        let v = y - x;
        let d = (v.transpose() * h * v)[0].sqrt();
        let p = h * v / d;
        let formula = Formula::record(&Constant::new(h).expect("definite")).expect("no branches");
        let hi = 1.001 * d;
        let region = Region::Tubes { radius: 0.51 * hi / 0.9, c1: 0.9 };
        let sets = [point(x.into()), point(y.into())];
        let exponent = (d / 4.0).log2().floor() as i32;
        let certificate = one_level(
            formula,
            sets,
            hi,
            region,
            exponent,
            [&|z| p.dot(&(z - x)), &|z| p.dot(&(y - z))],
        );
        let proved = certificate.check().expect("proved");
        println!("{D}: {d:e} {:e} {:?}", 1.0 - proved.lower / d, proved.levels);
        assert!(proved.lower <= d * (1.0 + 1e-15) && proved.lower >= d * (1.0 - 1e-13));
    }
}

/// Linear functions are the distances, up to rounding.
#[test]
fn constant_metrics_lose_only_rounding() {
    constant::<1>(1);
    constant::<2>(2);
    constant::<3>(3);
    constant::<4>(4);
}
