//! Exact comparisons of boxes with the formulas of sets, for tests.
//!
//! The numbers have so many bits that no sum or product rounds: coordinates are doubles of ordinary
//! size, their products have 106 bits, and sums of products span about 200.

use astro_float::{BigFloat, RoundingMode};
use nalgebra::SVector;
use tautline_scalar::Interval;

const P: usize = 1024;
const RM: RoundingMode = RoundingMode::None;

/// A number that is computed without rounding.
#[derive(Clone, Debug)]
pub(crate) struct Exact(BigFloat);

impl Exact {
    pub(crate) fn new(x: f64) -> Exact {
        Exact(BigFloat::from_f64(x, P))
    }

    pub(crate) fn plus(&self, other: &Exact) -> Exact {
        Exact(self.0.add(&other.0, P, RM))
    }

    pub(crate) fn minus(&self, other: &Exact) -> Exact {
        Exact(self.0.sub(&other.0, P, RM))
    }

    pub(crate) fn times(&self, other: &Exact) -> Exact {
        Exact(self.0.mul(&other.0, P, RM))
    }

    pub(crate) fn at_most(&self, other: &Exact) -> bool {
        self.0.cmp(&other.0).is_some_and(|order| order <= 0)
    }

    fn sqr(&self) -> Exact {
        self.times(self)
    }
}

fn sum(terms: impl Iterator<Item = Exact>) -> Exact {
    terms.fold(Exact::new(0.0), |sum, term| sum.plus(&term))
}

/// Returns the box that consists of one point.
pub(crate) fn point<const D: usize>(x: &SVector<f64, D>) -> SVector<Interval, D> {
    x.map(Interval::point)
}

/// Returns whether the box contains the point.
pub(crate) fn contains<const D: usize>(y: &SVector<Interval, D>, p: &SVector<f64, D>) -> bool {
    (0..D).all(|i| y[i].contains(p[i]))
}

/// Returns the smallest and the largest `|z − c|²` for `z` in the box.
pub(crate) fn squared_distances<const D: usize>(
    y: &SVector<Interval, D>,
    c: &SVector<f64, D>,
) -> (Exact, Exact) {
    let offset = |z: f64, i: usize| Exact::new(z).minus(&Exact::new(c[i])).sqr();
    let larger = |a: Exact, b: Exact| if a.at_most(&b) { b } else { a };
    let least = sum((0..D).map(|i| offset(c[i].clamp(y[i].lo(), y[i].hi()), i)));
    let most = sum((0..D).map(|i| larger(offset(y[i].lo(), i), offset(y[i].hi(), i))));
    (least, most)
}

/// Returns `r²`.
pub(crate) fn square(r: f64) -> Exact {
    Exact::new(r).sqr()
}

/// Returns the smallest `n·z` for `z` in the box.
pub(crate) fn least_product<const D: usize>(
    n: &SVector<f64, D>,
    y: &SVector<Interval, D>,
) -> Exact {
    sum((0..D).map(|i| {
        let end = if n[i] >= 0.0 { y[i].lo() } else { y[i].hi() };
        Exact::new(n[i]).times(&Exact::new(end))
    }))
}

/// Returns whether the box meets the points `a + s v`, with `s` in `[0, 1]` for a segment and any
/// `s` for a line; `v` is the exact `b − a`.
pub(crate) fn meets_line<const D: usize>(
    y: &SVector<Interval, D>,
    a: &SVector<f64, D>,
    v: &[Exact; D],
    segment: bool,
) -> bool {
    let zero = Exact::new(0.0);
    // Lower and upper bounds on s, as fractions p/q with q > 0.
    let (mut from, mut to) = (Vec::new(), Vec::new());
    if segment {
        from.push((zero.clone(), Exact::new(1.0)));
        to.push((Exact::new(1.0), Exact::new(1.0)));
    }
    for i in 0..D {
        let ends = [y[i].lo(), y[i].hi()].map(|end| Exact::new(end).minus(&Exact::new(a[i])));
        let [lo, hi] = ends;
        match (v[i].at_most(&zero), zero.at_most(&v[i])) {
            (true, true) if lo.at_most(&zero) && zero.at_most(&hi) => {}
            (true, true) => return false,
            (false, _) => {
                from.push((lo, v[i].clone()));
                to.push((hi, v[i].clone()));
            }
            (true, false) => {
                from.push((zero.minus(&hi), zero.minus(&v[i])));
                to.push((zero.minus(&lo), zero.minus(&v[i])));
            }
        }
    }
    from.iter().all(|(p, q)| to.iter().all(|(r, s)| p.times(s).at_most(&r.times(q))))
}

/// Returns `b − a` in each coordinate.
pub(crate) fn difference<const D: usize>(b: &SVector<f64, D>, a: &SVector<f64, D>) -> [Exact; D] {
    std::array::from_fn(|i| Exact::new(b[i]).minus(&Exact::new(a[i])))
}

/// Returns whether the midpoint of the box is at most as far from `p + span(directions)` as from a
/// corner. This is true if the box contains a member.
///
/// The distances are computed by Gram–Schmidt in long numbers; distances below `10⁻²⁰⁰` count as
/// zero.
pub(crate) fn reaches_subspace<const D: usize>(
    y: &SVector<Interval, D>,
    p: &SVector<f64, D>,
    directions: &[SVector<f64, D>],
) -> bool {
    let dot = |a: &[Exact; D], b: &[Exact; D]| sum((0..D).map(|i| a[i].times(&b[i])));
    let without = |x: &[Exact; D], q: &[Exact; D]| -> [Exact; D] {
        let share = Exact(dot(x, q).0.div(&dot(q, q).0, P, RM));
        std::array::from_fn(|i| x[i].minus(&share.times(&q[i])))
    };
    let mut basis: Vec<[Exact; D]> = Vec::new();
    for v in directions {
        let v = std::array::from_fn(|i| Exact::new(v[i]));
        basis.push(basis.iter().fold(v, |v, q| without(&v, q)));
    }
    let half = Exact::new(0.5);
    let ends = |i: usize| (Exact::new(y[i].lo()), Exact::new(y[i].hi()));
    let offset = std::array::from_fn(|i| {
        let (lo, hi) = ends(i);
        lo.plus(&hi).times(&half).minus(&Exact::new(p[i]))
    });
    let across = basis.iter().fold(offset, |offset, q| without(&offset, q));
    let corner = sum((0..D).map(|i| {
        let (lo, hi) = ends(i);
        hi.minus(&lo).times(&half).sqr()
    }));
    let nothing = Exact::new(1e-200).sqr();
    dot(&across, &across).at_most(&corner.plus(&nothing))
}
