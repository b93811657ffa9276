//! Random formulas: what is read off a formula must hold for its values.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Scalar};

use super::{Along, dependence, dependence::is_constant_along, is_isotropic, is_radial};

/// Reproducible random numbers from SplitMix64, by Steele, Lea and Flood.
struct Random(u64);

impl Random {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 33) as usize % n
    }

    fn coordinate(&mut self) -> f64 {
        self.below(1 << 20) as f64 / f64::from(1 << 18) - 2.0
    }

    fn point(&mut self) -> [f64; 3] {
        std::array::from_fn(|_| self.coordinate())
    }

    /// Returns a random tree of at most this depth with these leaves.
    fn tree(&mut self, depth: usize, leaf: &mut impl FnMut(&mut Self) -> Tree) -> Tree {
        let mut below = |random: &mut Self| Box::new(random.tree(depth - 1, leaf));
        match self.below(if depth == 0 { 1 } else { 10 }) {
            0 | 1 => leaf(self),
            2 | 3 => Tree::Sum(below(self), below(self)),
            4 => Tree::Product(below(self), below(self)),
            5 => Tree::Quotient(below(self), below(self)),
            _ => Tree::Of(self.below(FUNCTIONS), below(self)),
        }
    }
}

#[derive(Clone)]
enum Tree {
    /// `a · x`, with only the variables for which `aᵢ ≠ 0`.
    Linear([f64; 3]),
    /// `tan (a · x)`.
    Tangent([f64; 3]),
    /// `|x|²`.
    Square,
    Number(f64),
    Sum(Box<Tree>, Box<Tree>),
    Product(Box<Tree>, Box<Tree>),
    /// The first tree divided by one plus the square of the second.
    Quotient(Box<Tree>, Box<Tree>),
    Of(usize, Box<Tree>),
}

const FUNCTIONS: usize = 13;

fn function<S: Scalar>(which: usize, y: S) -> S {
    match which {
        0 | 1 => y.sin(),
        2 | 3 => y.cos(),
        4 => y.atan(),
        5 => y.tanh(),
        6 => y.sqr(),
        7 => y.powi(3),
        8 => (y * 0.125).exp(),
        9 => (y * 0.25).sinh() - (y * 0.5).cosh(),
        10 => (y.sqr() + 1.0).ln(),
        11 => (y.sqr() + 2.0).sqrt(),
        _ => -(y.sqr() + 1.0).recip(),
    }
}

impl Tree {
    fn at<S: Scalar>(&self, x: &[S; 3]) -> S {
        let linear = |a: &[f64; 3]| {
            let terms = (0..3).filter(|&i| a[i] != 0.0).map(|i| x[i] * a[i]);
            terms.fold(S::zero(), |sum, term| sum + term)
        };
        match self {
            Tree::Linear(a) => linear(a),
            Tree::Tangent(a) => linear(a).tan(),
            Tree::Square => x.iter().fold(S::zero(), |sum, x| sum + x.sqr()),
            Tree::Number(c) => S::constant(*c),
            Tree::Sum(a, b) => a.at(x) + b.at(x),
            Tree::Product(a, b) => a.at(x) * b.at(x),
            Tree::Quotient(a, b) => a.at(x) / (b.at(x).sqr() + 1.0),
            Tree::Of(which, a) => function(*which, a.at(x)),
        }
    }

    /// Returns the largest intermediate result. If it is large, so is the rounding error.
    fn largest(&self, x: &[f64; 3]) -> f64 {
        let below = match self {
            Tree::Sum(a, b) | Tree::Product(a, b) | Tree::Quotient(a, b) => {
                a.largest(x).max(b.largest(x))
            }
            Tree::Of(_, a) => a.largest(x),
            _ => 0.0,
        };
        below.max(self.at(x).abs())
    }
}

/// The upper triangle, column by column.
struct Matrix([Tree; 6]);

impl Metric<3> for Matrix {
    fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let x = [x[0], x[1], x[2]];
        SMatrix::from_fn(|i, j| {
            let (i, j) = (i.min(j), i.max(j));
            self.0[j * (j + 1) / 2 + i].at(&x)
        })
    }
}

impl Matrix {
    /// Returns a random matrix in which every other entry is 1.
    fn random(random: &mut Random, leaf: &mut impl FnMut(&mut Random) -> Tree) -> Self {
        Self(std::array::from_fn(|_| {
            let depth = random.below(3);
            if random.below(2) == 0 { Tree::Number(1.0) } else { random.tree(depth, leaf) }
        }))
    }

    fn formula(&self) -> Formula<ANY> {
        Formula::record(self).expect("no comparison").into_any()
    }

    /// Returns whether all entries agree at both points, up to rounding, or `None` if intermediate
    /// results are too large to decide.
    fn same(&self, x: [f64; 3], y: [f64; 3]) -> Option<bool> {
        let largest = |tree: &Tree| tree.largest(&x).max(tree.largest(&y));
        // The tolerance covers a hundred roundings, each magnified by derivatives of some
        // functions.
        let tame = self.0.iter().all(|tree| largest(tree) < 1e3);
        let close = |tree: &Tree| (tree.at(&x) - tree.at(&y)).abs() < 1e-6;
        tame.then(|| self.0.iter().all(close))
    }
}

/// No entry changes along a coordinate that is read as constant, nor after a period.
#[test]
fn values_depend_on_coordinates_as_the_formula_shows() {
    let mut random = Random(tautline_chance::seed(1));
    let mut seen = [0_usize; 3];
    for case in 0..4000 {
        // All leaves of a metric share their variables, so that some metrics lack one.
        let mask: [bool; 3] = std::array::from_fn(|_| random.below(2) == 0);
        let mut leaf = |random: &mut Random| {
            let wave = [1.0, -1.0, 2.0, 0.5, 3.0];
            let a =
                mask.map(|on| if on && random.below(3) > 0 { wave[random.below(5)] } else { 0.0 });
            match random.below(8) {
                0 => Tree::Number([0.0, 1.0, -0.75, 2.0][random.below(4)]),
                1 => Tree::Tangent(a),
                // A wave is made right away; otherwise only one tree in ten would have one.
                2..=4 => Tree::Of(random.below(4), Box::new(Tree::Linear(a))),
                _ => Tree::Linear(a),
            }
        };
        let metric = Matrix::random(&mut random, &mut leaf);
        for (i, along) in dependence(&metric.formula()).into_iter().enumerate() {
            for _ in 0..8 {
                let (x, mut y) = (random.point(), random.coordinate());
                match along {
                    Along::Unknown => continue,
                    Along::Constant => {}
                    Along::Periodic(wave_number) => y = x[i] + std::f64::consts::TAU / wave_number,
                }
                let moved = std::array::from_fn(|k| if k == i { y } else { x[k] });
                if let Some(same) = metric.same(x, moved) {
                    assert!(same, "case {case}, coordinate {i}: {along:?} from {x:?} to {moved:?}");
                    seen[usize::from(along == Along::Constant)] += 1;
                }
            }
            seen[2] += usize::from(along == Along::Unknown);
        }
    }
    assert!(seen.iter().all(|&count| count > 1000), "{seen:?}");
}

/// A formula does not change along a direction that is proved constant.
#[test]
fn values_do_not_change_along_a_direction_that_is_proved() {
    let mut random = Random(tautline_chance::seed(2));
    let mut seen = [0_usize; 2];
    // For each direction, two linear forms that vanish on it.
    let directions = [
        ([1.0, -1.0, 0.0], [[1.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        ([1.0, 1.0, 1.0], [[1.0, -1.0, 0.0], [0.0, 2.0, -2.0]]),
        ([0.0, 1.0, -2.0], [[3.0, 0.0, 0.0], [0.0, 1.0, 0.5]]),
        ([0.5, 0.0, 1.0], [[2.0, 0.0, -1.0], [-1.0, 3.0, 0.5]]),
    ];
    for case in 0..3000 {
        let (direction, forms) = directions[random.below(4)];
        // In every other case, one leaf in ten is an arbitrary form.
        let wild = case % 2 == 0;
        let mut leaf = |random: &mut Random| match random.below(10) {
            0 if wild => Tree::Linear([1.0, 2.0, 0.0]),
            1 => Tree::Number(0.5),
            k => Tree::Linear(forms[k % 2]),
        };
        let metric = Matrix::random(&mut random, &mut leaf);
        let constant = is_constant_along(&metric.formula(), &direction);
        seen[usize::from(constant)] += 1;
        for _ in 0..8 {
            let (x, s) = (random.point(), random.coordinate());
            let moved = std::array::from_fn(|k| x[k] + s * direction[k]);
            let same = metric.same(x, moved);
            assert!(!constant || same != Some(false), "case {case}: from {x:?} to {moved:?}");
        }
    }
    assert!(seen.iter().all(|&count| count > 300), "{seen:?}");
}

/// A metric read as isotropic is a multiple of the identity. A metric read as radial has the same
/// value at points of equal norm.
#[test]
fn isotropic_and_radial_metrics_are_so() {
    let mut random = Random(tautline_chance::seed(3));
    let mut seen = [0_usize; 3];
    for case in 0..3000 {
        let stray = random.below(3) == 0;
        let mut leaf = |random: &mut Random| match random.below(6) {
            0 if stray => Tree::Linear([0.0, 0.0, 1.0]),
            1 => Tree::Number(0.5),
            _ => Tree::Square,
        };
        let [one, other] = [0, 1].map(|_| random.tree(2, &mut leaf));
        let diagonal = |odd: bool| if odd { other.clone() } else { one.clone() };
        let beside = |odd: bool| if odd { other.clone() } else { Tree::Number(0.0) };
        // At most one of the entries is different.
        let odd = random.below(9);
        let metric = Matrix(std::array::from_fn(|k| match k {
            0 | 2 | 5 => diagonal(k == odd),
            _ => beside(k == odd),
        }));
        let formula = metric.formula();
        let (isotropic, radial) = (is_isotropic(&formula), is_radial(&formula));
        assert!(isotropic || !radial);
        seen[usize::from(isotropic) + usize::from(radial)] += 1;
        for _ in 0..6 {
            let x = random.point();
            let gram = metric.gram(&SVector::from(x));
            let multiple = SMatrix::<f64, 3, 3>::from_diagonal_element(gram[(0, 0)]);
            let finite = gram.iter().all(|entry| entry.is_finite());
            assert!(!isotropic || !finite || gram == multiple, "case {case}: {gram}");
            // The coordinates are permuted, or rotated by the angle of the 3-4-5 triangle.
            let (c, s) = (0.6 * x[0] - 0.8 * x[1], 0.8 * x[0] + 0.6 * x[1]);
            let turned = [x[2], c, s];
            assert!(!radial || metric.same(x, turned) != Some(false), "case {case}: {x:?}");
        }
    }
    assert!(seen.iter().all(|&count| count > 50), "{seen:?}");
}

/// A nonzero slope does not round to zero. With the double `⅓`, `3 · ⅓` is below 1, though the
/// product in doubles is 1.
#[test]
fn slopes_are_exact() {
    assert_eq!(1.0 / 3.0 * 3.0, 1.0);
    let nearly = crate::testing::parsed::<1>("exp(x1*(1/3)*3 - x1) + 1 I");
    assert_eq!(dependence(&nearly.into_any()), [Along::Unknown]);
}
