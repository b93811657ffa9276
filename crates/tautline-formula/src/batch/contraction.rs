//! `Contraction`: the derivatives of `H` at a point, contracted with a chord.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, is_gram};
use tautline_scalar::{Jet1, Jet2, MixedJet, Scalar};

/// The derivatives of `H` at a point, contracted with a chord `d` as soon as they are known.
#[derive(Clone, Debug)]
pub(crate) struct Contraction<const D: usize> {
    /// `H`.
    pub(crate) h: SMatrix<f64, D, D>,
    /// `Gₖ = dᵀ ∂ₖH d`.
    pub(crate) g: SVector<f64, D>,
    /// `Pᵢₖ = (∂ₖH d)ᵢ`.
    pub(crate) p: SMatrix<f64, D, D>,
    /// `Qₖₗ = dᵀ ∂ₖ∂ₗH d`.
    pub(crate) q: SMatrix<f64, D, D>,
    /// Whether `H`, with both halves as the metric has them, is finite, symmetric and positive
    /// definite.
    pub(crate) is_metric: bool,
}

/// From this dimension on `dᵀHd` is differentiated twice apart from the rest, as one scalar:
/// second-order jets of all `D²` entries of `H` would cost `D⁴`, and a metric of low rank
/// evaluates `dᵀHd` far cheaper. Below it, one evaluation for all is faster.
pub(crate) const SPLIT: usize = 4;

/// From this dimension on derivatives are taken by so many directions at once.
///
/// At once, `dᵀHd` would need second-order jets of all `D²` entries of `H` where it follows from
/// them: `D⁴/2` numbers, 1.3 MB at `D = 24`, which leave the cache and then the stack. Measured on an
/// expansion of the energy with chunks of 8: there it takes 0.5 times as long at `D = 16`, 1.2 times
/// at 24 and 0.3 times at 32. A sum of few terms of rank one, whose jets are small, pays for it: with
/// 4 terms it takes 3.1, 3.7 and 3.4 times as long, with `D` terms 3.5, 4.8 and 5.3 times.
pub(crate) const CHUNKED: usize = 24;
pub(crate) const CHUNK: usize = 8;

impl<const D: usize> Contraction<D> {
    /// With all derivatives of all entries at once. All sums begin with their first term: a zero to
    /// begin with costs an addition for each.
    #[inline(always)]
    fn together(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        let jets = metric.gram(&SVector::from(Jet2::variables(&(*y).into())));
        let mut contraction = Self::first_order(&jets, d, Jet2::value, Jet2::first);
        for k in 0..D {
            for l in k..D {
                let second = |i: usize, j: usize| jets[(i, j)].second(k, l);
                let row = |i: usize| {
                    let beside = (i + 1..D).map(|j| second(i, j) * (d[j] * 2.0));
                    beside.fold(second(i, i) * d[i], |sum, term| sum + term) * d[i]
                };
                contraction.q[(k, l)] = (1..D).fold(row(0), |sum, i| sum + row(i));
            }
        }
        contraction
    }

    /// `H`, `P` and `G` from the jets of the entries `i ≤ j` of `H`.
    #[inline(always)]
    fn first_order<J>(
        jets: &SMatrix<J, D, D>,
        d: &SVector<f64, D>,
        value: impl Fn(&J) -> f64,
        first: impl Fn(&J, usize) -> f64,
    ) -> Self {
        let jet = |i: usize, j: usize| &jets[(i.min(j), i.max(j))];
        let h = SMatrix::<f64, D, D>::from_fn(|i, j| value(jet(i, j)));
        let p = SMatrix::<f64, D, D>::from_fn(|i, k| {
            let term = |j: usize| first(jet(i, j), k) * d[j];
            (1..D).fold(term(0), |sum, j| sum + term(j))
        });
        let is_metric = is_gram(&SMatrix::<f64, D, D>::from_fn(|i, j| value(&jets[(i, j)])));
        Self { h, g: p.tr_mul(d), p, q: SMatrix::zeros(), is_metric }
    }
}

impl<const D: usize> Contraction<D> {
    /// Differentiates at `y`.
    #[inline(always)]
    pub(crate) fn new(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        // Constants, so that of the three only one is compiled for each metric.
        let mut contraction = if const { D < SPLIT } {
            Self::together(metric, y, d)
        } else if const { D < CHUNKED } {
            Self::apart(metric, y, d)
        } else {
            Self::by_chunks(metric, y, d)
        };
        contraction.q.fill_lower_triangle_with_upper_triangle();
        contraction
    }

    /// With `H`, the derivatives of `H d` and the second derivatives of `dᵀHd` apart.
    #[inline(always)]
    fn apart(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        let h = metric.gram(y);
        let momentum = metric.momentum(&SVector::from(Jet1::variables(&(*y).into())), d);
        let square = metric.norm_squared(&SVector::from(Jet2::variables(&(*y).into())), d);
        let mut q = SMatrix::<f64, D, D>::zeros();
        for k in 0..D {
            for l in k..D {
                q[(k, l)] = square.second(k, l);
            }
        }
        Self {
            h,
            g: SVector::from(*square.gradient()),
            p: SMatrix::from_fn(|i, k| momentum[i].first(k)),
            q,
            is_metric: is_gram(&h),
        }
    }

    /// With the first derivatives by one chunk of directions at a time, and the second by all
    /// pairs of chunks `a ≤ b`.
    fn by_chunks(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        let mut h = SMatrix::<f64, D, D>::zeros();
        let mut p = SMatrix::<f64, D, D>::zeros();
        let mut q = SMatrix::<f64, D, D>::zeros();
        let mut is_metric = false;
        for a in (0..D).step_by(CHUNK) {
            let jets = metric.gram(&chunk_of_variables(y, a));
            if a == 0 {
                is_metric = is_gram(&jets.map(|jet| jet.value()));
            }
            for j in 0..D {
                for i in 0..=j {
                    let jet = &jets[(i, j)];
                    h[(i, j)] = jet.value();
                    h[(j, i)] = jet.value();
                    for k in a..D.min(a + CHUNK) {
                        p[(i, k)] += jet.first(k - a) * d[j];
                        if i != j {
                            p[(j, k)] += jet.first(k - a) * d[i];
                        }
                    }
                }
            }
            for b in (a..D).step_by(CHUNK) {
                let variables = SVector::<_, D>::from_fn(|i, _| {
                    MixedJet::<f64, CHUNK>::variable(y[i], place(i, a), place(i, b))
                });
                let square = metric.norm_squared(&variables, d);
                for k in a..D.min(a + CHUNK) {
                    for l in b..D.min(b + CHUNK) {
                        q[(k, l)] = square.mixed(k - a, l - b);
                    }
                }
            }
        }
        Self { h, g: p.tr_mul(d), p, q, is_metric }
    }
}

/// Where in the chunk that begins with `start` the coordinate `i` is.
fn place(i: usize, start: usize) -> Option<usize> {
    i.checked_sub(start).filter(|&place| place < CHUNK)
}

/// The coordinates as functions of those in the chunk that begins with `start`.
fn chunk_of_variables<const D: usize>(
    y: &SVector<f64, D>,
    start: usize,
) -> SVector<Jet1<f64, CHUNK>, D> {
    // Beyond the last coordinate stand variables on which nothing depends.
    let values = std::array::from_fn(|k| y.get(start + k).copied().unwrap_or(0.0));
    let chunk = Jet1::variables(&values);
    SVector::from_fn(|i, _| place(i, start).map_or(Jet1::constant(y[i]), |k| chunk[k]))
}

/// `H`, both halves as the metric has them, and `Gₖ = dᵀ ∂ₖH d` at `y`.
#[inline(always)]
pub(crate) fn momentum<const D: usize>(
    metric: &impl Metric<D>,
    y: &SVector<f64, D>,
    d: &SVector<f64, D>,
) -> (SMatrix<f64, D, D>, SVector<f64, D>) {
    let variables = || SVector::from(Jet1::variables(&(*y).into()));
    if const { D < SPLIT } {
        let jets = metric.gram(&variables());
        let contraction = Contraction::first_order(&jets, d, Jet1::value, Jet1::first);
        return (jets.map(|jet| jet.value()), contraction.g);
    }
    let h: SMatrix<f64, D, D> = metric.gram(y);
    let gradient = if const { D < CHUNKED } {
        SVector::from(*metric.norm_squared(&variables(), d).gradient())
    } else {
        let mut gradient = SVector::zeros();
        for start in (0..D).step_by(CHUNK) {
            let square = metric.norm_squared(&chunk_of_variables(y, start), d);
            for k in start..D.min(start + CHUNK) {
                gradient[k] = square.first(k - start);
            }
        }
        gradient
    };
    (h, gradient)
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_metrics::gallery::{SineProjection, SineProjections};

    use super::{CHUNK, CHUNKED, Contraction, momentum};

    /// Chunked and not, between 8 waves in every coordinate at once.
    #[track_caller]
    fn compare<const D: usize>() {
        let wave = |k: usize, i: usize| (0.7 * k as f64 + 1.9 * i as f64).sin();
        let term = |k: usize| SineProjection {
            wave_vector: SVector::from_fn(|i, _| wave(k, i)),
            direction: SVector::from_fn(|i, _| 0.5 * wave(k + 1, i + 1)),
        };
        let metric = SineProjections::<D>::new((1..=8).map(term).collect()).expect("finite");
        let y = SVector::<f64, D>::from_fn(|i, _| 0.3 * wave(3, 2 * i));
        let d = SVector::<f64, D>::from_fn(|i, _| 0.25 * wave(5, i));
        let mut whole = Contraction::apart(&metric, &y, &d);
        let mut chunked = Contraction::by_chunks(&metric, &y, &d);
        whole.q.fill_lower_triangle_with_upper_triangle();
        chunked.q.fill_lower_triangle_with_upper_triangle();
        // ∂ₖHᵢⱼ is a sum of 8 terms below 1/8, P of D terms below 1/4 in either order, and G of D
        // terms below D/16. A sum of D terms is known to D ε/2 times the sum of their sizes, so
        // that P differs by D² ε/4 at most. G inherits D³ ε/16 of that, and has as much from its own
        // two sums: 4.4e-13 for D = 25. Every entry of H and of Q comes from the same operations
        // either way.
        let close = 4.5e-13;
        assert_eq!(whole.h, chunked.h);
        assert_eq!(whole.q, chunked.q);
        assert!((whole.p - chunked.p).amax() <= close);
        assert!((whole.g - chunked.g).amax() <= close);
        let (h, g) = momentum(&metric, &y, &d);
        assert!((h - whole.h).amax() <= close && (g - whole.g).amax() <= close);
        // None of which is small by itself.
        assert!(whole.p.amax() > 1e-2 && whole.g.amax() > 1e-2 && whole.q.amax() > 1e-2);
        assert_eq!(
            Contraction::new(&metric, &y, &d).q,
            if D < CHUNKED { whole.q } else { chunked.q }
        );
    }

    /// With two, three and four chunks, of which the last is full or not.
    #[test]
    fn derivatives_by_chunks_are_those_of_all_at_once() {
        const { assert!(CHUNK == 8 && CHUNKED > 16) };
        compare::<13>();
        compare::<16>();
        compare::<{ CHUNKED - 1 }>();
        compare::<CHUNKED>();
        compare::<{ CHUNKED + 1 }>();
    }
}
