//! The whole Newton sweep: by the compiled formula and by programs, side by side.
use std::{hint::black_box, time::Instant};
use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{LeftEndpoint, PointSequence, Rule, Trapezoidal, TrueTrapezoid};
use tautline_formula::{Batches, Formula, InstructionSet, Kind, Programs};
use tautline_metrics::{Metric, Scalar, gallery::*};
use tautline_optimizers::{Workspace, newton::measure::{batches, compiled}};
use tautline_sets::{Ball, ClosedSet, Point};

struct Line;
impl Metric<1> for Line {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> { SMatrix::from_element(2.0 + x[0].sin()) }
}
/// H = J^T J of a small decoder with tanh.
struct Decoder<const D: usize>;
impl<const D: usize> Metric<D> for Decoder<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = SMatrix::<S, D, D>::identity();
        for k in 0..6 {
            let w: [f64; D] = std::array::from_fn(|i| (1.3 * k as f64 + 0.7 * i as f64).sin());
            let u = (1..D).fold(x[0] * w[0], |s, i| s + x[i] * w[i]);
            let t = u.tanh();
            let slope = (1.0 - t * t).sqr();
            for i in 0..D { for j in 0..D { h[(i, j)] += slope * (w[i] * w[j]); } }
        }
        h
    }
}

fn time(mut f: impl FnMut()) -> f64 {
    let t = Instant::now();
    f();
    t.elapsed().as_secs_f64()
}

fn row<R: Rule, const D: usize>(name: &str, rule: R, rule_name: &str, metric: &impl Metric<D>, n: usize, sets: bool, from: [f64; D], to: [f64; D]) {
    let formula = Formula::record(metric).expect("recorded");
    let sse = Programs::with(formula.clone(), InstructionSet::Baseline, 64);
    let avx = Programs::with(formula.clone(), InstructionSet::Widest, 64);
    let at = |k: usize| {
        let t = k as f64 / n as f64;
        SVector::<f64, D>::from_fn(|i, _| from[i] + (to[i] - from[i]) * t + 0.02 * (i as f64 + 1.0) * (6.0 * t * (1.0 - t) * 4.0 / 6.0) * if i == 0 { 0.0 } else { 1.0 })
    };
    let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
    let (a, b) = (Point::new(from).expect("finite"), Point::new(to).expect("finite"));
    let mut ca = from; ca[0] -= 0.3;
    let mut cb = to; cb[0] += 0.2;
    let (ba, bb) = (Ball::new(ca, 0.3).expect("r"), Ball::new(cb, 0.2).expect("r"));
    let ends: [&dyn ClosedSet<D>; 2] = if sets { [&ba, &bb] } else { [&a, &b] };
    let e = compiled(rule, metric, ends, &sequence, false, None);
    let f = batches(rule, metric, &avx, ends, &sequence, false, None);
    let g = batches(rule, metric, &sse, ends, &sequence, false, None);
    assert_eq!(f.map(|x| x.map(f64::to_bits)), g.map(|x| x.map(f64::to_bits)));
    let (Some(e), Some(f)) = (e, f) else { println!("{name} {rule_name}: {e:?} {f:?}"); return };
    let off: Vec<f64> = e.iter().zip(&f).map(|(a, b)| (a - b).abs() / a.abs()).collect();
    let mut workspace = [(); 3].map(|()| Workspace::<D>::default());
    let mut eliminated = [(); 3].map(|()| Vec::new());
    let mut best = [[f64::INFINITY; 3]; 2];
    let repeats = 15;
    let inner = (20_000 / n).max(1);
    for _ in 0..repeats {
        let times = [
            time(|| for _ in 0..inner { black_box(compiled(rule, metric, ends, &sequence, false, None)); }),
            time(|| for _ in 0..inner { black_box(batches(rule, metric, &sse, ends, &sequence, false, None)); }),
            time(|| for _ in 0..inner { black_box(batches(rule, metric, &avx, ends, &sequence, false, None)); }),
        ];
        let [w0, w1, w2] = &mut workspace;
        let [e0, e1, e2] = &mut eliminated;
        let kept = [
            time(|| for _ in 0..inner { black_box(compiled(rule, metric, ends, &sequence, false, Some((w0, e0)))); }),
            time(|| for _ in 0..inner { black_box(batches(rule, metric, &sse, ends, &sequence, false, Some((w1, e1)))); }),
            time(|| for _ in 0..inner { black_box(batches(rule, metric, &avx, ends, &sequence, false, Some((w2, e2)))); }),
        ];
        for (best, times) in best.iter_mut().zip([times, kept]) { for (b, t) in best.iter_mut().zip(times) { *b = b.min(t) } }
    }
    let [judge, newton] = best;
    let ns = 1e9 * judge[0] / (n * inner) as f64;
    let [ins, regs] = avx.size(Kind::Contraction);
    println!("{name:14} {rule_name:6} N={n:6} sets={sets:5} ins={ins:4} regs={regs:3} lanes={:2} compiled {ns:7.1} ns/chord | judge {:.2}/{:.2} | newton {:.2}/{:.2} | off {:.0e} {:.0e} {:.0e}",
        avx.batch(Kind::Contraction).lanes(), judge[1] / judge[0], judge[2] / judge[0], newton[1] / newton[0], newton[2] / newton[0], off[0], off[1], off[2]);
}

fn main() {
    let filter: Vec<String> = std::env::args().skip(1).collect();
    let wants = |name: &str| filter.is_empty() || filter.iter().any(|f| f == name);
    macro_rules! rows { ($name:expr, $m:expr, $from:expr, $to:expr) => { if wants($name) {
        let m = $m;
        row($name, Trapezoidal, "trap", &m, 100_000, false, $from, $to);
        row($name, Trapezoidal, "trap", &m, 1000, false, $from, $to);
        row($name, Trapezoidal, "trap", &m, 1001, true, $from, $to);
        row($name, Trapezoidal, "trap", &m, 64, false, $from, $to);
        row($name, Trapezoidal, "trap", &m, 8, false, $from, $to);
        row($name, LeftEndpoint, "left", &m, 1000, true, $from, $to);
        row($name, TrueTrapezoid, "truetr", &m, 1000, true, $from, $to);
    } } }
    rows!("line", Line, [0.0], [3.0]);
    rows!("valleys2", Valleys, [-2.0, 0.0], [2.0, 0.3]);
    rows!("shear", Shear::new(0.5, 1.0).unwrap(), [-1.0, 0.0], [1.0, 0.3]);
    rows!("coupled3", CoupledCosines, [-0.5, 0.0, 0.1], [0.5, 0.3, 0.2]);
    rows!("separable3", Separable::new([0.3, -0.5, 0.7], [1.0, 2.0, 3.0]).unwrap(), [-0.5, 0.0, 0.1], [0.5, 0.3, 0.2]);
    rows!("rotating", RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).unwrap(), [-0.5, 0.0], [0.5, 0.3]);
    rows!("decoder2", Decoder::<2>, [-0.5, 0.0], [0.5, 0.3]);
    rows!("decoder4", Decoder::<4>, [-0.5, 0.0, 0.1, 0.0], [0.5, 0.3, 0.2, 0.1]);
    rows!("sines8", SineProjections::benchmark(), [-0.5, 0.0, 0.1, 0.0, 0.0, 0.2, 0.1, 0.0], [0.5, 0.3, 0.2, 0.1, 0.1, 0.1, 0.0, 0.1]);
}
