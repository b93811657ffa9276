//! Quadratic polynomials with known gradients and values.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, cases, seed};
use tautline_scalar::Interval;

use super::{Bernstein, gradient};
use crate::kuhn::{Simplex, simplices};

/// `xᵀAx/2 + b·x` on the unit cube. Its numbers are small multiples of a power of two, so that the
/// values at nodes are exact.
struct Quadratic<const D: usize> {
    a: SMatrix<f64, D, D>,
    b: SVector<f64, D>,
}

impl<const D: usize> Quadratic<D> {
    fn random(random: &mut Random) -> Self {
        let mut number = || (random.between(-64.0, 64.0)).round() / 16.0;
        let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| number());
        Self { a: a + a.transpose(), b: SVector::from_fn(|_, _| number()) }
    }

    fn at(&self, x: &SVector<f64, D>) -> f64 {
        0.5 * x.dot(&(self.a * x)) + self.b.dot(x)
    }

    fn gradient(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        self.a * x + self.b
    }

    fn values(&self) -> Vec<f64> {
        let node = |at: usize| {
            SVector::from_fn(|i, _| (at / 3_usize.pow((D - 1 - i) as u32) % 3) as f64 * 0.5)
        };
        (0..3_usize.pow(D as u32)).map(|at| self.at(&node(at))).collect()
    }
}

fn vertex<const D: usize>(simplex: &Simplex, k: usize) -> SVector<f64, D> {
    SVector::from_fn(|i, _| (simplex.corners[k] >> i & 1) as f64)
}

/// Returns random barycentric coordinates.
fn weights<const D: usize>(random: &mut Random) -> Vec<f64> {
    let parts: Vec<f64> = (0..=D).map(|_| -random.unit().max(1e-9).ln()).collect();
    let sum: f64 = parts.iter().sum();
    parts.iter().map(|part| part / sum).collect()
}

fn check<const D: usize>(fixed: u64) {
    let mut random = Random(seed(fixed));
    for _ in 0..cases(20) {
        let quadratic = Quadratic::<D>::random(&mut random);
        let values = quadratic.values();
        for simplex in &simplices(D) {
            let form = Bernstein::<D>::of(simplex, &values);
            for k in 0..=D {
                let found: [Interval; D] = gradient(simplex, &values, k, 4.0);
                let exact = 4.0 * quadratic.gradient(&vertex(simplex, k));
                for i in 0..D {
                    assert!(found[i].contains(exact[i]), "{:?} {exact}", found[i]);
                    assert!(found[i].width() < 1e-12);
                }
            }
            for _ in 0..5 {
                let weights = weights::<D>(&mut random);
                let x = (0..=D).fold(SVector::zeros(), |x, k| x + vertex(simplex, k) * weights[k]);
                // The point was computed with rounding.
                let value = quadratic.at(&x);
                let inside =
                    |range: Interval| range.lo() <= value + 1e-12 && value - 1e-12 <= range.hi();
                assert!(inside(form.range()), "{value} {:?}", form.range());
                let points: Vec<Interval> = weights.iter().map(|&w| Interval::point(w)).collect();
                assert!(inside(form.at(&points)) && form.at(&points).width() < 1e-12);
                let twice = form.plus(&form.times(-0.5)).range();
                assert!(twice.lo() <= 0.5 * value + 1e-12 && 0.5 * value - 1e-12 <= twice.hi());
            }
            for k in 0..=D {
                let mut weights = weights::<D>(&mut random);
                let left = 1.0 - weights[k];
                weights[k] = 0.0;
                let x = (0..=D)
                    .fold(SVector::zeros(), |x, k| x + vertex(simplex, k) * (weights[k] / left));
                let facet = form.range_opposite(k);
                let value = quadratic.at(&x);
                assert!(facet.lo() <= value + 1e-12 && value - 1e-12 <= facet.hi());
                assert!(form.range().contains_interval(facet));
            }
        }
    }
}

#[test]
fn gradients_and_ranges_in_every_dimension() {
    check::<1>(31);
    check::<2>(32);
    check::<3>(33);
    check::<4>(34);
}

/// The greatest value lies between two nodes, and below the greatest Bernstein coefficient.
#[test]
fn the_range_holds_values_between_the_nodes() {
    let simplex = &simplices(1)[0];
    // The parabola through 1, 9 and 10 has its greatest value 10.40 at 0.82.
    let range = Bernstein::<1>::of(simplex, &[1.0, 9.0, 10.0]).range();
    assert_eq!((range.lo(), range.hi()), (1.0, 12.5));
}

#[test]
fn values_that_overflow_leave_the_range_open() {
    let simplex = &simplices(1)[0];
    for values in [[1.7e308, 0.0, 1.7e308], [0.0, 1.7e308, 0.0], [f64::MAX, f64::MIN, f64::MAX]] {
        let range = Bernstein::<1>::of(simplex, &values).range();
        assert!(range.lo() == f64::NEG_INFINITY || range.hi() == f64::INFINITY, "{range:?}");
        for value in [values[0], values[2]] {
            assert!(range.contains(value));
        }
    }
    assert_eq!(Bernstein::<1>::new(|_, _| Interval::UNDEFINED).range(), Interval::REALS);
}
