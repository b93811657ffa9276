//! Metrics that are, or nearly are, sums of squares of vectors.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Formula, Kind, Prepared};
use tautline_metrics::{Metric, gallery::TanhDecoder};
use tautline_scalar::Scalar;

use crate::{
    programs::{all, compare_one, places},
    random::Random,
};

/// Distinct numbers without a pattern.
fn number(k: usize) -> f64 {
    (1.0 + 1.7 * k as f64).sin()
}

pub(crate) fn decoder<const D: usize, const HIDDEN: usize, const OUT: usize>()
-> TanhDecoder<D, HIDDEN, OUT> {
    let inner = SMatrix::from_fn(|a, i| number(D * a + i) / 2.0);
    // Terms with weight zero stay: they are undefined where their unit is.
    let outer = SMatrix::from_fn(|o, a| if o == a { 0.0 } else { number(50 + HIDDEN * o + a) });
    TanhDecoder::new(inner, outer, 0.5).expect("finite")
}

#[test]
fn decoders_are_contracted_by_programs() {
    all(&decoder::<1, 6, 4>());
    all(&decoder::<2, 6, 4>());
    all(&decoder::<2, 16, 16>());
    all(&decoder::<3, 5, 7>());
    all(&decoder::<4, 16, 16>());
}

/// A program that differentiates the entries themselves would be too long.
#[test]
fn a_decoder_of_8_coordinates_has_a_program() {
    let metric = decoder::<8, 16, 16>();
    let prepared = Prepared::new(&metric);
    assert!(prepared.size(Kind::Contraction).is_some());
    let known = compare_one(&metric, &prepared, &places(20), "");
    assert_eq!(known, 20 * (1 + 1 + 3 * 8 + 3 * 8 * 8));
}

/// One output more makes a program by so much longer as 42 is more than 40, and a bit for its registers.
#[test]
fn no_program_is_much_longer_than_that_of_one_output_less() {
    fn length<const OUT: usize>() -> usize {
        let formula = Formula::<8>::record(&decoder::<8, 32, OUT>()).expect("no branches");
        Prepared::<_, 8>::new(formula).size(Kind::Contraction).expect("a program")[0]
    }
    let [before, after, far] = [length::<40>(), length::<42>(), length::<120>()];
    assert!(before < after && after < before * 11 / 10, "{before} {after}");
    assert!(far < 4 * before, "{before} {far}");
}

/// `8 I + diag(sin x₀, 0, …) + Σₒ wₒ aₒ aₒᵀ` in five coordinates, possibly with a defect.
struct Vectors(Wrong);

#[derive(Clone, Copy, PartialEq)]
enum Wrong {
    Nothing,
    /// One product has a different weight from the others of its vector.
    Factor,
    /// One product of a vector is missing.
    Missing,
    /// A product belongs to two pairs.
    Ambiguous,
    /// The weight is not constant.
    Weight,
}

impl Metric<5> for Vectors {
    fn gram<S: Scalar>(&self, x: &SVector<S, 5>) -> SMatrix<S, 5, 5> {
        let wave = |k: usize| {
            x.iter().enumerate().fold(S::zero(), |sum, (i, &x)| sum + x * number(5 * k + i)).sin()
        };
        let waves: [S; 4] = std::array::from_fn(wave);
        let entry = |o: usize, i: usize| {
            let terms = waves.iter().enumerate();
            let sum =
                terms.fold(S::zero(), |sum, (a, &s)| sum + s * number(20 + 20 * o + 5 * a + i));
            sum * 0.5 + 0.25 * (i + o) as f64
        };
        let mut vectors: [[S; 5]; 5] =
            std::array::from_fn(|o| std::array::from_fn(|i| entry(o, i)));
        // The entries include a zero, a constant, and a single function.
        vectors[1][2] = S::zero();
        vectors[2][0] = S::constant(0.75);
        vectors[3] = [waves[0], waves[1], x[2] + 0.5, S::zero(), waves[3]];
        if self.0 == Wrong::Ambiguous {
            vectors[4] = vectors[0];
            vectors[4].swap(0, 1);
        }
        let mut h = SMatrix::<S, 5, 5>::from_diagonal_element(S::constant(8.0));
        h[(0, 0)] += x[0].sin();
        for (o, a) in vectors.iter().enumerate() {
            for i in 0..5 {
                for j in i..5 {
                    let product = a[i] * a[j];
                    let weight = [1.0, 0.5, 0.25, -0.125, 1.0][o];
                    let is_here = o == 0 && (i, j) == (1, 2);
                    let term = match self.0 {
                        Wrong::Factor if is_here => product * (1.0 + 1e-3),
                        Wrong::Missing if is_here => S::zero(),
                        Wrong::Weight if o == 0 => product * (x[1].cos() + 2.0),
                        _ => product * weight,
                    };
                    h[(i, j)] += term;
                }
            }
        }
        h.fill_lower_triangle_with_upper_triangle();
        h
    }
}

/// Returns the number of instructions for all derivatives.
fn length(wrong: Wrong) -> usize {
    let size = Prepared::new(Vectors(wrong)).size(Kind::Contraction);
    size.expect("a program")[0]
}

#[test]
fn vectors_with_zeros_constants_and_weights_are_contracted() {
    all(&Vectors(Wrong::Nothing));
    // Without the squares the program is longer.
    assert!(length(Wrong::Nothing) < length(Wrong::Ambiguous));
}

#[test]
fn spoilt_squares_are_not_squares() {
    all(&Vectors(Wrong::Factor));
    all(&Vectors(Wrong::Missing));
    all(&Vectors(Wrong::Ambiguous));
    all(&Vectors(Wrong::Weight));
}

/// `I + ∇f ∇fᵀ` is made of one vector, with single functions for some of its entries.
#[test]
fn graphs_of_functions_are_contracted() {
    struct Graph;
    impl Metric<4> for Graph {
        fn gram<S: Scalar>(&self, x: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
            let (shared, own) = ((x[0] + x[1] * 0.5 - x[2]).cos(), (x[3] * x[0]).sin());
            let slope = [shared + own * x[3], shared * 0.5, -shared, own * x[0]];
            let mut h = SMatrix::<S, 4, 4>::from_fn(|i, j| slope[i.min(j)] * slope[i.max(j)]);
            for i in 0..4 {
                h[(i, i)] += S::one();
            }
            h
        }
    }
    all(&Graph);
}

/// `8 I + Σₒ Σᵢⱼ wₒᵢⱼ aₒᵢ aₒⱼ` in four coordinates. Each product has a weight of its own, so that
/// often some, but not all, of the squares and products of a vector have the same one.
struct Weighted([[[f64; 4]; 4]; 3]);

impl Weighted {
    const WEIGHTS: [f64; 3] = [1.0, 2.0, 0.5];

    /// Returns a sum in which the vector `spoilt` has random weights, with the same weight for most
    /// products; all weights of the others are the same.
    fn random(random: &mut Random, spoilt: Option<usize>) -> Self {
        let mut draw = |most: usize| Self::WEIGHTS[random.below(most)];
        Self(std::array::from_fn(|o| {
            let usual = draw(3);
            std::array::from_fn(|_| {
                std::array::from_fn(|_| match spoilt {
                    Some(one) if one == o && draw(3) != 1.0 => draw(2),
                    _ => usual,
                })
            })
        }))
    }
}

impl Metric<4> for Weighted {
    fn gram<S: Scalar>(&self, x: &SVector<S, 4>) -> SMatrix<S, 4, 4> {
        let wave = |k: usize| {
            x.iter().enumerate().fold(S::zero(), |sum, (i, &x)| sum + x * number(4 * k + i)).sin()
        };
        let waves: [S; 3] = std::array::from_fn(wave);
        let entry = |o: usize, i: usize| {
            let terms = waves.iter().enumerate();
            terms.fold(S::zero(), |sum, (a, &s)| sum + s * number(20 + 16 * o + 4 * a + i))
        };
        let mut h = SMatrix::<S, 4, 4>::from_diagonal_element(S::constant(8.0));
        for (o, weights) in self.0.iter().enumerate() {
            let a: [S; 4] = std::array::from_fn(|i| entry(o, i));
            for i in 0..4 {
                for j in i..4 {
                    let product = if i == j { a[i].sqr() } else { a[i] * a[j] };
                    h[(i, j)] += product * weights[i][j];
                }
            }
        }
        h.fill_lower_triangle_with_upper_triangle();
        h
    }
}

/// `2 b² + a b + a²` is not the square of a vector, although the weight of `a b` is that of `a²`.
#[test]
fn a_product_has_to_have_the_weight_of_both_its_squares() {
    let mut random = Random(tautline_chance::seed(91));
    let length = |metric: &Weighted| {
        let size = Prepared::new(metric).size(Kind::Contraction);
        size.expect("a program")[0]
    };
    let square = Weighted::random(&mut random, None);
    all(&square);
    let mut longer = 0;
    for case in 0..tautline_chance::cases(30) {
        let spoilt = Weighted::random(&mut random, Some(case as usize % 3));
        all(&spoilt);
        longer += u32::from(length(&spoilt) > length(&square));
    }
    // Those that are no squares are longer, so the others are contracted as squares.
    assert!(longer > tautline_chance::cases(10), "{longer}");
}
