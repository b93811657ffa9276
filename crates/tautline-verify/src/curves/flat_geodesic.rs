//! `FlatGeodesic`: the minimal geodesic of a metric that is flat in coordinates of its own.

use nalgebra::SVector;
use tautline::{
    Bounded, Constants, Jet2,
    gallery::{Separable, Shear},
};

use super::Curve;

/// The preimage of a straight line, passed at constant Riemannian speed.
pub struct FlatGeodesic<const D: usize> {
    jet: Box<dyn Fn(f64) -> [SVector<f64, D>; 3]>,
    distance: f64,
    suprema: [f64; 3],
}

impl<const D: usize> FlatGeodesic<D> {
    /// Returns the distance of the ends, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// `|γ − a| ≤ K₁ = d/√c₁`, and by the geodesic equation `|γ̈| ≤ 3 L_H K₁²/2c₁`.
    fn new(
        constants: Constants,
        distance: f64,
        first: SVector<f64, D>,
        jet: impl Fn(f64) -> [SVector<f64, D>; 3] + 'static,
    ) -> Self {
        let k1 = distance / constants.c1().sqrt();
        let suprema = [first.norm() + k1, k1, 1.5 * constants.l_h() / constants.c1() * k1 * k1];
        Self { jet: Box::new(jet), distance, suprema }
    }
}

impl FlatGeodesic<2> {
    /// Returns the minimal geodesic of a shear: the way back from flat coordinates is a formula, so
    /// that a jet in `t` gives the derivatives.
    #[must_use]
    pub fn of_shear(metric: Shear, [a, b]: [SVector<f64, 2>; 2]) -> Self {
        let (p, q) = (metric.flatten(&a), metric.flatten(&b));
        Self::new(metric.constants(), (q - p).norm(), a, move |t| {
            let [t] = Jet2::variables(&[t]);
            let flat = SVector::<Jet2<f64, 1>, 2>::from_fn(|i, _| t * (q[i] - p[i]) + p[i]);
            let curve = metric.unflatten(&flat);
            [curve.map(|x| x.value()), curve.map(|x| x.first(0)), curve.map(|x| x.second(0, 0))]
        })
    }
}

impl<const D: usize> FlatGeodesic<D> {
    /// Returns the minimal geodesic of a separable metric: with `v = F(b) − F(a)`, coordinate `i`
    /// is where `Fᵢ = Fᵢ(aᵢ) + t vᵢ`, its velocity `vᵢ/fᵢ` and its acceleration `−fᵢ′ vᵢ²/fᵢ³`.
    #[must_use]
    pub fn of_separable(metric: Separable<D>, [a, b]: [SVector<f64, D>; 2]) -> Self {
        let p = metric.flatten(&a);
        let v = metric.flatten(&b) - p;
        Self::new(metric.constants(), v.norm(), a, move |t| {
            // Fᵢ is increasing. A step of Newton's method that leaves the bracket is replaced by
            // its middle; 60 steps are enough for halving alone.
            let mut x = a + (b - a) * t;
            let (mut low, mut high) = (a.inf(&b), a.sup(&b));
            let mut jets = metric.flatten(&SVector::from(Jet2::variables(&x.into())));
            for _ in 0..60 {
                let before = x;
                for i in 0..D {
                    let excess = jets[i].value() - (p[i] + t * v[i]);
                    *(if excess > 0.0 { &mut high[i] } else { &mut low[i] }) = x[i];
                    let newton = x[i] - excess / jets[i].first(i);
                    let inside = low[i] <= newton && newton <= high[i];
                    x[i] = if inside { newton } else { 0.5 * (low[i] + high[i]) };
                }
                jets = metric.flatten(&SVector::from(Jet2::variables(&x.into())));
                if (x - before).amax() <= 4.0 * f64::EPSILON * x.amax() {
                    break;
                }
            }
            let f = SVector::<f64, D>::from_fn(|i, _| jets[i].first(i));
            let velocity = v.component_div(&f);
            let acceleration =
                SVector::from_fn(|i, _| -jets[i].second(i, i) * velocity[i] * velocity[i] / f[i]);
            [x, velocity, acceleration]
        })
    }
}

impl<const D: usize> Curve<D> for FlatGeodesic<D> {
    fn jet(&self, t: f64) -> [SVector<f64, D>; 3] {
        (self.jet)(t)
    }

    fn suprema(&self) -> [f64; 3] {
        self.suprema
    }
}
