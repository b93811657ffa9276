//! Batches evaluated with a formula, operation by operation: for formulas whose derivatives are too long
//! for a program.

use tautline_metrics::are_gram;
use tautline_scalar::{Jet2, Scalar};

use crate::{
    batch::{Kind, Layout},
    formula::Tape,
    program::Registers,
};

/// The number of directions in which derivatives are taken at once.
const CHUNK: usize = 8;

/// Fills the rows of a kind, lane by lane.
pub(crate) fn evaluate(tape: Tape<'_>, layout: &Layout, kind: Kind, registers: &mut Registers) {
    let dimension = tape.dimension;
    for lane in 0..registers.count() {
        let input = |k: usize| registers.row(k as u32)[lane];
        let x: Vec<f64> = (0..dimension).map(input).collect();
        let d: Vec<f64> = (dimension..2 * dimension).map(input).collect();
        let full = gram(tape, &x);
        let half = |i: usize, j: usize| full[i.max(j) * dimension + i.min(j)];
        let momentum: Vec<f64> =
            (0..dimension).map(|i| (0..dimension).map(|j| half(i, j) * d[j]).sum()).collect();
        let square: f64 = momentum.iter().zip(&d).map(|(p, d)| p * d).sum();
        registers.set_all(&layout.square, lane, &[square]);
        registers.set_all(&layout.momentum, lane, &momentum);
        let sign = if are_gram(&full, dimension) { 1.0 } else { -1.0 };
        registers.set_all(&layout.positive, lane, &[sign]);
        if matches!(kind, Kind::Square | Kind::Checked) {
            continue;
        }
        let Derivatives { slope, turn, bend } = Derivatives::new(tape, &x, &d);
        registers.set_all(&layout.slope, lane, &slope);
        if kind == Kind::Contraction {
            let places = 0..dimension * dimension;
            let h: Vec<f64> = places.map(|k| half(k / dimension, k % dimension)).collect();
            registers.set_all(&layout.gram, lane, &h);
            registers.set_all(&layout.turn, lane, &turn);
            registers.set_all(&layout.bend, lane, &bend);
        }
    }
}

/// Returns `H(x)`, column by column.
pub(crate) fn gram(tape: Tape<'_>, x: &[f64]) -> Vec<f64> {
    let values = tape.values(x);
    tape.entries.iter().map(|&entry| values[entry as usize]).collect()
}

/// The derivatives of `H` at a point, contracted with a vector `d`; matrices row by row.
struct Derivatives {
    /// `Gₖ = dᵀ ∂ₖH d`.
    slope: Vec<f64>,
    /// `Pᵢₖ = (∂ₖH d)ᵢ`.
    turn: Vec<f64>,
    /// `Qₖₗ = dᵀ ∂ₖ∂ₗH d`.
    bend: Vec<f64>,
}

impl Derivatives {
    fn new(tape: Tape<'_>, x: &[f64], d: &[f64]) -> Self {
        let n = tape.dimension;
        let mut found =
            Self { slope: vec![0.0; n], turn: vec![0.0; n * n], bend: vec![0.0; n * n] };
        // All halves of chunks are combined in pairs, so that any two coordinates share a chunk.
        const HALF: usize = CHUNK / 2;
        for a in (0..n).step_by(HALF) {
            for b in (a + HALF..n.max(a + HALF + 1)).step_by(HALF) {
                let directions =
                    std::array::from_fn(|k| if k < HALF { a + k } else { b + k - HALF });
                found.differentiate(tape, x, d, directions);
            }
        }
        found
    }

    /// Sets the derivatives in some directions. Those from `D` on are padding.
    fn differentiate(&mut self, tape: Tape<'_>, x: &[f64], d: &[f64], directions: [usize; CHUNK]) {
        let n = tape.dimension;
        let at = directions.map(|k| x.get(k).copied().unwrap_or(0.0));
        let variables = Jet2::variables(&at);
        let coordinate = |i: usize| {
            let place = directions.iter().position(|&k| k == i);
            place.map_or_else(|| Jet2::constant(x[i]), |place| variables[place])
        };
        let coordinates: Vec<Jet2<f64, CHUNK>> = (0..n).map(coordinate).collect();
        let values = tape.values(&coordinates);
        let mut turn = vec![[0.0; CHUNK]; n];
        let (mut slope, mut bend) = ([0.0; CHUNK], [[0.0; CHUNK]; CHUNK]);
        for i in 0..n {
            for j in i..n {
                let jet = &values[tape.entries[j * n + i] as usize];
                let weight = if i == j { d[i] * d[i] } else { 2.0 * d[i] * d[j] };
                for k in 0..CHUNK {
                    let first = jet.first(k);
                    turn[i][k] += first * d[j];
                    if i != j {
                        turn[j][k] += first * d[i];
                    }
                    slope[k] += first * weight;
                    for l in k..CHUNK {
                        bend[k][l] += jet.second(k, l) * weight;
                    }
                }
            }
        }
        let inside = || directions.into_iter().enumerate().filter(|&(_, k)| k < n);
        for (a, k) in inside() {
            self.slope[k] = slope[a];
            for (i, turn) in turn.iter().enumerate() {
                self.turn[i * n + k] = turn[a];
            }
            for (b, l) in inside() {
                self.bend[k * n + l] = bend[a.min(b)][a.max(b)];
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline_metrics::{
        Metric,
        gallery::{SineProjection, SineProjections, Valleys},
    };

    use super::evaluate;
    use crate::{
        Formula,
        batch::{AnyBatches, Kind, Plain, contiguous, rows},
        program::Registers,
    };

    const KINDS: [Kind; 4] = [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction];

    /// Both read the same inputs, and fill the same rows.
    #[track_caller]
    fn compare<const D: usize>(metric: &impl Metric<D>) {
        let (plain, formula) = (Plain::new(metric), Formula::record(metric).expect("no branches"));
        for kind in KINDS {
            let layout = contiguous(kind, D);
            let rows = rows(&layout, D);
            let registers = || {
                let mut registers = Registers::empty(rows, 3);
                registers.set_used(3);
                for lane in 0..3 {
                    for k in 0..2 * D {
                        registers.set(k as u32, lane, (1.0 + (3 * k + 7 * lane) as f64).sin());
                    }
                }
                registers
            };
            let [mut found, mut expected] = [registers(), registers()];
            evaluate(formula.tape(), &layout, kind, &mut found);
            plain.evaluate(kind, &mut expected);
            for row in 0..rows {
                let [found, expected] = [&found, &expected].map(|all| &all.row(row as u32)[..3]);
                for (one, other) in found.iter().zip(expected) {
                    // Sums of up to D² terms of size 10.
                    let small = 1e-14 * (D * D).max(10) as f64;
                    assert!((one - other).abs() <= small, "{kind:?} {D} {row}: {one} {other}");
                }
            }
        }
    }

    fn projections<const D: usize>() -> SineProjections<D> {
        let term = |k: usize| SineProjection {
            wave_vector: SVector::from_fn(|i, _| ((3 * k + i) as f64).sin()),
            direction: SVector::from_fn(|i, _| ((k + 2 * i) as f64).cos()),
        };
        SineProjections::new((1..4).map(term).collect()).expect("finite")
    }

    /// In fewer directions than are taken at once, in as many, and in more.
    #[test]
    fn a_formula_is_differentiated_as_its_metric_in_any_dimension() {
        compare::<1>(&Valleys);
        compare(&projections::<2>());
        compare(&projections::<3>());
        compare(&projections::<4>());
        compare(&projections::<5>());
        compare(&projections::<8>());
        compare(&projections::<9>());
        compare(&projections::<13>());
        compare(&projections::<17>());
    }
}
