//! Certificates that were changed: what they still prove is true.
//!
//! The base is a certificate of a pull-back with a known distance, a curve and four levels.

mod cubes;
mod statement;
mod text;
mod values;

use std::sync::LazyLock;

use nalgebra::SVector;
use tautline_check::{Certificate, CheckError, Level, Proved, Region, length_above};

use crate::{
    helpers::{point, proved, several_levels},
    wave::Wave,
};

const ENDS: [[f64; 2]; 2] = [[0.05, 0.03], [0.95, 0.28]];

/// A certificate with the distance that it encloses.
pub(super) struct Base {
    pub(super) wave: Wave,
    pub(super) ends: [SVector<f64, 2>; 2],
    pub(super) d: f64,
    pub(super) certificate: Certificate<2>,
    pub(super) proved: Proved<2>,
}

pub(super) static BASE: LazyLock<Base> = LazyLock::new(|| {
    let wave = Wave::new(0.3, 2.0);
    let ends = ENDS.map(SVector::from);
    let (formula, sets) = (wave.formula(), ENDS.map(point));
    let curve = wave.geodesic(ends, 512);
    let length = length_above(&formula, sets.each_ref(), &curve).expect("its ends are the points");
    let hi = length * (1.0 + 1e-9);
    let region = Region::Tubes { radius: 0.51 * hi / wave.c1().sqrt(), c1: wave.c1() };
    let functions = [0, 1].map(|i| wave.calibration([ends[i], ends[1 - i]], 0.4));
    let mut certificate = several_levels(
        formula,
        sets,
        hi,
        region,
        &[-4, -5, -6, -7],
        [&functions[0], &functions[1]],
    );
    certificate.curve = Some(curve);
    let proved = proved(&certificate);
    Base { wave, ends, d: wave.distance(&ends[0], &ends[1]), certificate, proved }
});

impl Base {
    /// Returns the number of a node at a point of the minimal geodesic, for each of some levels.
    pub(super) fn nodes_on_the_geodesic(&self) -> Vec<(usize, usize)> {
        let middles = self.wave.geodesic(self.ends, 8);
        let levels = self.certificate.levels.iter().enumerate();
        let near = |level: &Level<2>, x: &SVector<f64, 2>| {
            let half = 0.5 * level.cubes().side();
            let place = [(x[0] / half).round() as i32, (x[1] / half).round() as i32];
            level.nodes().iter().position(|node| *node == place).expect("a node on the geodesic")
        };
        levels.flat_map(|(n, level)| middles.iter().map(move |x| (n, near(level, x)))).collect()
    }

    /// Returns the certificate with other values at one level.
    pub(super) fn with_values(
        &self,
        level: usize,
        change: impl FnOnce(&mut [Vec<f64>; 2]),
    ) -> Result<Certificate<2>, CheckError> {
        let mut certificate = self.certificate.clone();
        let mut values = certificate.levels[level].values().clone();
        change(&mut values);
        certificate.levels[level] =
            Level::new(level, certificate.levels[level].cubes().clone(), values)?;
        Ok(certificate)
    }

    /// Asserts that a certificate of the same problem proves nothing false.
    pub(super) fn assert_true(&self, checked: &Result<Proved<2>, CheckError>) {
        if let Ok(proved) = checked {
            assert!(proved.lower <= self.d, "{} > {}", proved.lower, self.d);
            let curve = self.certificate.curve.as_ref().expect("a curve");
            assert!(crate::helpers::keeps(proved, curve), "the geodesic left {:?}", proved.levels);
        }
    }
}

#[test]
fn the_base_encloses_the_distance() {
    let Base { d, proved, .. } = &*BASE;
    assert!(proved.lower <= *d && proved.upper.expect("a curve") >= *d);
    assert!(proved.gap().expect("a curve") < 2e-3, "{:?} {:?}", proved.gap(), proved.levels);
    BASE.assert_true(&Ok(proved.clone()));
    // A cheaper base would have no cubes to prune.
    assert!(proved.levels.iter().all(|&(cubes, _)| cubes > 20), "{:?}", proved.levels);
}
