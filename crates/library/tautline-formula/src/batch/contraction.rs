//! `Contraction`: the derivatives of `H` at a point, contracted with a chord.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, is_gram};
use tautline_scalar::{Jet1, Jet2, Scalar};

/// `H` at a point and its derivatives, contracted with a chord `d` as soon as they are known.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Contraction<const D: usize> {
    /// `H`.
    pub(crate) h: SMatrix<f64, D, D>,
    /// `Gₖ = dᵀ ∂ₖH d`.
    pub(crate) g: SVector<f64, D>,
    /// `Pᵢₖ = (∂ₖH d)ᵢ`.
    pub(crate) p: SMatrix<f64, D, D>,
    /// `Qₖₗ = dᵀ ∂ₖ∂ₗH d`.
    pub(crate) q: SMatrix<f64, D, D>,
    /// Whether `H` is finite, symmetric and positive definite, with both halves as the metric gives
    /// them.
    pub(crate) is_metric: bool,
}

/// From this dimension on, derivatives are taken in [`CHUNK`] directions at a time. The jets of all
/// `D²` entries of `H` in all directions are `D⁴` numbers. At `D = 24` these are 2.8 MB, which
/// exceeds first the cache and then the stack.
pub(crate) const CHUNKED: usize = 24;
const CHUNK: usize = 8;

impl<const D: usize> Contraction<D> {
    /// Differentiates `H` at `y`.
    #[inline(always)]
    pub(crate) fn new(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        // The condition is a constant, so that only one of the two branches is compiled.
        if const { D < CHUNKED } {
            Self::at_once(metric, y, d)
        } else {
            Self::by_chunks(metric, y, d)
        }
    }

    #[inline(always)]
    fn at_once(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        let jets = metric.gram(&SVector::from(Jet2::variables(&(*y).into())));
        let mut contraction = Self::of(&jets.map(|jet| jet.value()));
        contraction.differentiate(&jets, d, std::array::from_fn(|k| k));
        contraction
    }

    /// Combines all half chunks in pairs, so that any two coordinates share a chunk.
    fn by_chunks(metric: &impl Metric<D>, y: &SVector<f64, D>, d: &SVector<f64, D>) -> Self {
        const HALF: usize = CHUNK / 2;
        let mut contraction = Self::of(&metric.gram(y));
        for a in (0..D).step_by(HALF) {
            for b in (a + HALF..D).step_by(HALF) {
                let directions: [usize; CHUNK] =
                    std::array::from_fn(|k| if k < HALF { a + k } else { b + k - HALF });
                let jets = metric.gram(&variables(y, directions, Jet2::variables, Jet2::constant));
                contraction.differentiate(&jets, d, directions);
            }
        }
        contraction
    }

    fn of(gram: &SMatrix<f64, D, D>) -> Self {
        Self {
            h: SMatrix::from_fn(|i, j| gram[(i.min(j), i.max(j))]),
            g: SVector::zeros(),
            p: SMatrix::zeros(),
            q: SMatrix::zeros(),
            is_metric: is_gram(gram),
        }
    }

    /// Sets `G`, `P` and `Q` in the directions of the jets. Directions from `D` on are padding.
    #[inline(always)]
    fn differentiate<const B: usize>(
        &mut self,
        jets: &SMatrix<Jet2<f64, B>, D, D>,
        d: &SVector<f64, D>,
        directions: [usize; B],
    ) {
        let mut p = SMatrix::<f64, D, B>::zeros();
        let mut q = SMatrix::<f64, B, B>::zeros();
        for i in 0..D {
            for j in i..D {
                let (jet, weight) = (&jets[(i, j)], weight(d, i, j));
                for k in 0..B {
                    p[(i, k)] += jet.first(k) * d[j];
                    if i != j {
                        p[(j, k)] += jet.first(k) * d[i];
                    }
                    for l in k..B {
                        q[(k, l)] += jet.second(k, l) * weight;
                    }
                }
            }
        }
        let g = slope(jets, d, Jet2::gradient);
        let places = || directions.into_iter().enumerate().filter(|&(_, k)| k < D);
        for (a, k) in places() {
            self.g[k] = g[a];
            self.p.set_column(k, &p.column(a));
            places().for_each(|(b, l)| self.q[(k, l)] = q[(a.min(b), a.max(b))]);
        }
    }
}

/// Returns the weight of the entries `(i, j)` and `(j, i)` of `H` in `dᵀHd`.
#[inline(always)]
fn weight<const D: usize>(d: &SVector<f64, D>, i: usize, j: usize) -> f64 {
    if i == j { d[i] * d[i] } else { 2.0 * d[i] * d[j] }
}

/// Returns `G` in the directions of the jets, computed from the entries `i ≤ j` of `H`.
#[inline(always)]
fn slope<J, const B: usize, const D: usize>(
    jets: &SMatrix<J, D, D>,
    d: &SVector<f64, D>,
    gradient: impl Fn(&J) -> &[f64; B],
) -> SVector<f64, B> {
    let mut g = SVector::zeros();
    for i in 0..D {
        for j in i..D {
            g += SVector::from(*gradient(&jets[(i, j)])) * weight(d, i, j);
        }
    }
    g
}

/// Returns the coordinates as jets in these directions.
fn variables<J: Scalar, const B: usize, const D: usize>(
    y: &SVector<f64, D>,
    directions: [usize; B],
    variables: impl Fn(&[f64; B]) -> [J; B],
    constant: impl Fn(f64) -> J,
) -> SVector<J, D> {
    // Nothing depends on variables beyond the last coordinate.
    let variables = variables(&directions.map(|k| y.get(k).copied().unwrap_or(0.0)));
    let place = |i: usize| directions.iter().position(|&k| k == i);
    SVector::from_fn(|i, _| place(i).map_or(constant(y[i]), |place| variables[place]))
}

/// Returns `H`, with both halves as the metric gives them, and `Gₖ = dᵀ ∂ₖH d` at `y`.
#[inline(always)]
pub(crate) fn momentum<const D: usize>(
    metric: &impl Metric<D>,
    y: &SVector<f64, D>,
    d: &SVector<f64, D>,
) -> (SMatrix<f64, D, D>, SVector<f64, D>) {
    if const { D < CHUNKED } {
        let jets = metric.gram(&SVector::from(Jet1::variables(&(*y).into())));
        (jets.map(|jet| jet.value()), slope(&jets, d, Jet1::gradient))
    } else {
        (metric.gram(y), slope_by_chunks(metric, y, d))
    }
}

fn slope_by_chunks<const D: usize>(
    metric: &impl Metric<D>,
    y: &SVector<f64, D>,
    d: &SVector<f64, D>,
) -> SVector<f64, D> {
    let mut g = SVector::zeros();
    for start in (0..D).step_by(CHUNK) {
        let directions: [usize; CHUNK] = std::array::from_fn(|k| start + k);
        let jets = metric.gram(&variables(y, directions, Jet1::variables, Jet1::constant));
        let part = slope(&jets, d, Jet1::gradient);
        for k in start..D.min(start + CHUNK) {
            g[k] = part[k - start];
        }
    }
    g
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_metrics::gallery::{SineProjection, SineProjections};

    use super::{CHUNK, CHUNKED, Contraction, momentum, slope_by_chunks};

    /// Expands a sum of 8 waves, each of which depends on all coordinates.
    fn expand<const D: usize>(
        by: fn(&SineProjections<D>, &SVector<f64, D>, &SVector<f64, D>) -> Contraction<D>,
    ) -> Contraction<D> {
        let wave = |k: usize, i: usize| (0.7 * k as f64 + 1.9 * i as f64).sin();
        let term = |k: usize| SineProjection {
            wave_vector: SVector::from_fn(|i, _| wave(k, i)),
            direction: SVector::from_fn(|i, _| 0.5 * wave(k + 1, i + 1)),
        };
        let terms: Vec<_> = (1..=8).map(term).collect();
        let metric = SineProjections::new(terms.clone()).expect("finite");
        let y = SVector::<f64, D>::from_fn(|i, _| 0.3 * wave(3, 2 * i));
        let d = SVector::<f64, D>::from_fn(|i, _| 0.25 * wave(5, i));
        let contraction = by(&metric, &y, &d);
        assert_eq!(momentum(&metric, &y, &d), (contraction.h, contraction.g));
        assert_eq!(slope_by_chunks(&metric, &y, &d), contraction.g);
        // The exact values: Σ cos(2 w·y) (a·d)² w wᵀ, ½ Σ sin(2 w·y) (a·d) a wᵀ, and G = Pᵀd.
        let (mut p, mut q) = (contraction.p, contraction.q);
        let g = contraction.g - p.tr_mul(&d);
        for SineProjection { wave_vector: w, direction: a } in terms {
            let (sin, cos) = (2.0 * w.dot(&y)).sin_cos();
            p -= a * w.transpose() * (0.5 * sin * a.dot(&d));
            q -= w * w.transpose() * (cos * a.dot(&d).powi(2));
        }
        // There are hundreds of terms below 1; their roundings add up to 1e-14 at D = 25.
        assert!(p.amax() <= 1e-12 && q.amax() <= 1e-12, "{} {}", p.amax(), q.amax());
        assert!(g.amax() <= 1e-12, "{}", g.amax());
        // None of them is small.
        let Contraction { g, p, q, .. } = &contraction;
        assert!(p.amax() > 1e-2 && g.amax() > 1e-2 && q.amax() > 1e-2);
        contraction
    }

    /// The number of half chunks is even or odd, and the last half chunk is full or not.
    #[test]
    fn derivatives_by_chunks_are_those_of_all_at_once() {
        const { assert!(CHUNK == 8 && CHUNKED == 24) };
        // The results agree bit for bit, since each derivative takes the same operations.
        assert_eq!(expand::<7>(Contraction::by_chunks), expand(Contraction::new));
        assert_eq!(expand::<8>(Contraction::by_chunks), expand(Contraction::new));
        assert_eq!(expand::<12>(Contraction::by_chunks), expand(Contraction::new));
        assert_eq!(expand::<13>(Contraction::by_chunks), expand(Contraction::new));
        // 23 is the highest dimension that is differentiated at once, with jets of several
        // megabytes.
        let all = || assert_eq!(expand::<23>(Contraction::by_chunks), expand(Contraction::new));
        let thread = std::thread::Builder::new().stack_size(64 << 20).spawn(all);
        thread.expect("a thread").join().expect("the same derivatives");
        expand::<CHUNKED>(Contraction::new);
        expand::<{ CHUNKED + 1 }>(Contraction::new);
    }
}
