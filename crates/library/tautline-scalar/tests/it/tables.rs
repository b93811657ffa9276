//! Tables in every number type, compared with the same polynomial as a formula.
//!
//! All numbers are small integers, so nothing rounds, and results are equal.

use std::{
    hash::{BuildHasher, RandomState},
    sync::Arc,
};

use tautline_scalar::{Interval, Jet1, Jet2, Pair, Scalar, Table};

use crate::{INFINITY, interval};

/// A factor and the powers along the axes.
type Term = (f64, [u8; 3]);

/// No two derivatives up to the second order are the same.
const TERMS: [Term; 6] = [
    (1.0, [3, 0, 0]),
    (2.0, [2, 2, 0]),
    (3.0, [1, 0, 2]),
    (5.0, [0, 3, 1]),
    (7.0, [1, 1, 1]),
    (-4.0, [0, 1, 3]),
];

/// A polynomial as a table. It ignores arguments that are too many, and takes 1 for those that are
/// missing and for sides that are undefined: it is the number types that refuse them.
#[derive(Debug, PartialEq)]
struct Polynomial {
    axes: usize,
    terms: Vec<Term>,
}

impl Polynomial {
    /// Returns the part of the terms that depends on so many axes.
    fn new(axes: usize) -> Self {
        let is_own = |term: &Term| term.1[axes..].iter().all(|&power| power == 0);
        Self { axes, terms: TERMS.into_iter().filter(is_own).collect() }
    }

    /// Returns a partial derivative.
    fn derivative(&self, orders: [u8; 3]) -> Self {
        let of_term = |&(mut factor, mut powers): &Term| {
            for (power, order) in powers.iter_mut().zip(orders) {
                for _ in 0..order {
                    factor *= f64::from(*power);
                    *power = power.checked_sub(1)?;
                }
            }
            Some((factor, powers))
        };
        Self { axes: self.axes, terms: self.terms.iter().filter_map(of_term).collect() }
    }

    fn at<S: Scalar>(&self, u: &[S]) -> S {
        let power = |(axis, &power): (usize, &u8)| u.get(axis).map(|u| u.powi(i32::from(power)));
        let term = |(factor, powers): &Term| {
            powers.iter().enumerate().filter_map(power).fold(S::constant(*factor), |all, u| all * u)
        };
        self.terms.iter().map(term).fold(S::zero(), |sum, term| sum + term)
    }
}

impl Table for Polynomial {
    fn axes(&self) -> usize {
        self.axes
    }

    fn value(&self, u: &[f64], orders: [u8; 3]) -> f64 {
        self.derivative(orders).at(u)
    }

    fn bounds(&self, sides: &[(f64, f64)], orders: [u8; 3]) -> Option<(f64, f64)> {
        let side = |&(lo, hi): &(f64, f64)| Interval::new(lo, hi).unwrap_or(Interval::point(1.0));
        let bounds = self.derivative(orders).at(&sides.iter().map(side).collect::<Vec<_>>());
        Some((bounds.lo(), bounds.hi()))
    }

    fn fingerprint(&self) -> u64 {
        self.axes as u64
    }

    fn is_same(&self, other: &dyn Table) -> bool {
        (other as &dyn std::any::Any).downcast_ref::<Self>().is_some_and(|other| self == other)
    }
}

/// Returns the polynomial of so many axes and the same as a table.
fn both(axes: usize) -> (Polynomial, Arc<dyn Table>) {
    (Polynomial::new(axes), Arc::new(Polynomial::new(axes)))
}

/// Returns points with small integer coordinates.
fn points() -> impl Iterator<Item = [f64; 3]> {
    [-2.0, 0.0, 1.0, 3.0].into_iter().flat_map(|x| {
        [-1.0, 0.0, 2.0].into_iter().flat_map(move |y| [-3.0, 1.0].map(|z| [x, y, z]))
    })
}

/// The orders of some derivatives for so many axes.
fn orders(axes: usize) -> impl Iterator<Item = [u8; 3]> {
    [[0, 0, 0], [1, 0, 0], [0, 1, 0], [2, 0, 0], [0, 0, 1], [1, 1, 0], [0, 1, 2]]
        .into_iter()
        .filter(move |orders| orders[axes..].iter().all(|&order| order == 0))
}

/// Arguments that depend on two variables in different ways, not all of them linearly.
fn arguments<S: Scalar>([x, y]: [S; 2]) -> [S; 3] {
    [x * 2.0 - y, x * y + 1.0, y.sqr() - x]
}

/// Compares a table with its formula, in one number type.
#[track_caller]
fn compare<S: Scalar>(variables: [S; 2]) {
    for axes in 1..=3 {
        let (polynomial, table) = both(axes);
        let u = &arguments(variables)[..axes];
        for orders in orders(axes) {
            let (found, expected) =
                (S::tabulated(&table, orders, u), polynomial.derivative(orders).at(u));
            assert!(found == expected, "{u:?}, {orders:?}: {found:?} {expected:?}");
        }
    }
}

#[test]
fn a_table_has_the_values_and_derivatives_of_its_formula() {
    for [x, y, z] in points() {
        compare([x, y]);
        compare([Pair::new(x, y), Pair::new(z, x)]);
        compare(Jet1::variables(&[x, y]));
        compare(Jet2::variables(&[x, y]));
        // Arguments that are bent already, and derivatives of the third order.
        compare([Jet2::variables(&[x, y])[0].sqr(), Jet2::variables(&[z, y])[1]]);
        let outer = Jet1::variables(&[x, y]);
        compare(Jet2::variables(&outer));
        compare(Jet1::variables(&Jet2::variables(&[y, z])));
    }
}

#[test]
fn the_bounds_of_a_table_are_those_of_its_intervals() {
    let (polynomial, table) = both(2);
    for [x, y, z] in points() {
        let u = [interval(x, x + 2.0), interval(y, y + z.abs())];
        for orders in orders(2) {
            let found = Interval::tabulated(&table, orders, &u);
            assert_eq!(found, polynomial.derivative(orders).at(&u), "{u:?} {orders:?}");
            assert!(found.contains(table.value(&[x + 1.0, y], orders)), "{u:?} {orders:?}");
        }
        let jet = Jet2::tabulated(&table, [0; 3], &Jet2::variables(&u));
        for (k, l) in [(0, 0), (0, 1), (1, 1)] {
            let mut second = [0; 3];
            second[k] += 1;
            second[l] += 1;
            assert!(jet.second(k, l).contains_interval(Interval::tabulated(&table, second, &u)));
        }
    }
    let half_line = interval(1.0, INFINITY);
    let found = Interval::tabulated(&both(1).1, [0; 3], &[half_line]);
    assert_eq!((found.lo(), found.hi()), (1.0, INFINITY));
}

/// Missing arguments and more than three are refused, and so is what is undefined, also where the
/// table has bounds without it.
#[test]
fn a_table_of_other_arguments_is_undefined() {
    for axes in 1..=3 {
        let table = both(axes).1;
        for count in (1..=4).filter(|&count| count != axes) {
            assert!(f64::tabulated(&table, [0; 3], &vec![1.0; count]).is_nan());
            let [a, b] = Pair::tabulated(&table, [0; 3], &vec![Pair::new(1.0, 2.0); count]).both();
            assert!(a.is_nan() && b.is_nan(), "{axes} {count}");
            let u = vec![interval(1.0, 2.0); count];
            assert!(Interval::tabulated(&table, [0; 3], &u).is_undefined(), "{axes} {count}");
            let jets = |u: Jet2<f64, 1>| Jet2::tabulated(&table, [0; 3], &vec![u; count]);
            let jet = jets(Jet2::variables(&[2.0])[0].sqr());
            assert!([jet.value(), jet.first(0), jet.second(0, 0)].iter().all(|x| x.is_nan()));
        }
        for undefined in 0..axes {
            let mut u = vec![interval(1.0, 2.0); axes];
            u[undefined] = Interval::UNDEFINED;
            assert!(Interval::tabulated(&table, [0; 3], &u).is_undefined(), "{axes} {undefined}");
        }
    }
}

/// Two functions may have the same fingerprint.
#[test]
fn tables_are_equal_if_they_are_the_same_function() {
    let [one, same, more] = [2, 2, 3].map(|axes| both(axes).1);
    let other: Arc<dyn Table> = Arc::new(Polynomial::new(2).derivative([1, 0, 0]));
    assert!(*one == *same && *one != *more);
    assert!(one.fingerprint() == other.fingerprint() && *one != *other);
    let hasher = RandomState::new();
    let [one, same, more] = [one, same, more].map(|table| hasher.hash_one(&*table));
    assert!(one == same && one != more);
}
