//! Steps as polynomials, to find out which of them are equal.

use std::collections::{BTreeMap, HashMap};

use crate::operation::{Arithmetic, Function, Number, Operation, Step};

/// A polynomial: how often each product of identities occurs. The factors are sorted. A product that
/// cancels stays, since the polynomial is undefined where a factor is.
type Polynomial = BTreeMap<Vec<u32>, i64>;

/// The most terms of a polynomial, and the most factors of a term. Beyond, it counts as one step.
const MOST_TERMS: usize = 512;
const MOST_FACTORS: usize = 16;

/// What makes a step equal to another one.
#[derive(PartialEq, Eq, Hash)]
enum Key {
    /// An operation on these identities.
    Operation(Operation),
    /// The second step of the pair with this identity.
    Second(u32),
    Polynomial(Vec<(Vec<u32>, i64)>),
}

/// Returns a number for each step. Steps with the same number are equal, and defined at the same points.
pub(crate) fn identities(operations: &[Operation]) -> Vec<u32> {
    let mut known: HashMap<Key, u32> = HashMap::new();
    let mut identity = |key: Key| {
        let next = known.len() as u32;
        *known.entry(key).or_insert(next)
    };
    let mut steps: Vec<(u32, Polynomial)> = Vec::with_capacity(operations.len());
    for (place, operation) in operations.iter().enumerate() {
        let of = |step: Step| &steps[step as usize].1;
        let mut constant = |number: Number| {
            // 0 and −0 are the same number.
            let value = Number::of(number.value() + 0.0);
            single(identity(Key::Operation(Operation::Constant(value))))
        };
        let expanded = match *operation {
            Operation::Constant(number) => Some(constant(number)),
            Operation::Binary(Arithmetic::Add, a, b) => sum(of(a), of(b), 1),
            Operation::Binary(Arithmetic::Sub, a, b) => sum(of(a), of(b), -1),
            Operation::Binary(Arithmetic::Mul, a, b) => product(of(a), of(b)),
            Operation::WithNumber(Arithmetic::Add, a, c) => sum(of(a), &constant(c), 1),
            Operation::WithNumber(Arithmetic::Sub, a, c) => sum(of(a), &constant(c), -1),
            Operation::WithNumber(Arithmetic::Mul, a, c) => product(of(a), &constant(c)),
            Operation::Of(Function::Neg, a) => sum(&Polynomial::new(), of(a), -1),
            Operation::Of(Function::Sqr, a) | Operation::Powi(a, 2) => product(of(a), of(a)),
            _ => None,
        };
        let polynomial = expanded.unwrap_or_else(|| {
            single(identity(match operation.with_reads(|step| steps[step as usize].0) {
                // It comes right after the first step of its pair.
                Operation::Second => Key::Second(steps[place - 1].0),
                Operation::Binary(how @ (Arithmetic::Add | Arithmetic::Mul), a, b) => {
                    Key::Operation(Operation::Binary(how, a.min(b), a.max(b)))
                }
                Operation::Of(Function::Sqr, a) => Key::Operation(Operation::Powi(a, 2)),
                other => Key::Operation(other),
            }))
        });
        let own = match polynomial.first_key_value() {
            Some((factors, 1)) if polynomial.len() == 1 && factors.len() == 1 => factors[0],
            _ => identity(Key::Polynomial(polynomial.clone().into_iter().collect())),
        };
        steps.push((own, polynomial));
    }
    steps.into_iter().map(|(own, _)| own).collect()
}

/// Returns the polynomial that is one identity.
fn single(identity: u32) -> Polynomial {
    Polynomial::from([(vec![identity], 1)])
}

/// Returns `a + sign · b`, unless it has too many terms.
fn sum(a: &Polynomial, b: &Polynomial, sign: i64) -> Option<Polynomial> {
    let mut sum = a.clone();
    for (factors, count) in b {
        let to = sum.entry(factors.clone()).or_insert(0);
        *to = to.checked_add(count.checked_mul(sign)?)?;
    }
    (sum.len() <= MOST_TERMS).then_some(sum)
}

/// Returns `a b`, unless it has too many terms or factors.
fn product(a: &Polynomial, b: &Polynomial) -> Option<Polynomial> {
    if a.len() * b.len() > MOST_TERMS {
        return None;
    }
    let mut product = Polynomial::new();
    for (left, m) in a {
        for (right, n) in b {
            let mut factors = [&left[..], &right[..]].concat();
            if factors.len() > MOST_FACTORS {
                return None;
            }
            factors.sort_unstable();
            let to = product.entry(factors).or_insert(0);
            *to = to.checked_add(m.checked_mul(*n)?)?;
        }
    }
    Some(product)
}
