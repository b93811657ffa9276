//! try
use nalgebra::SVector;
use std::ops::ControlFlow;
use tautline::distance::*;
use tautline::Formula;
use tautline_sets::{Point, Shape};
fn run<const D: usize>(name: &str, text: &str, a: [f64; D], b: [f64; D], gap: f64, n: usize) {
    let sets = [Shape::Point(Point::new(a).unwrap()), Shape::Point(Point::new(b).unwrap())];
    let formula = Formula::<D>::parse(text, &[]).unwrap();
    let ends = tautline::Ends::points(a, b).unwrap();
    let line =
        tautline::Problem::new(formula.clone(), ends).solve(tautline::Trapezoidal, n).unwrap();
    let pts: Vec<SVector<f64, D>> = line.sequence().points().to_vec();
    go(name, formula, sets, pts, gap)
}
fn runs<const D: usize>(name: &str, text: &str, ends: tautline::Ends<D>, gap: f64, n: usize) {
    let formula = Formula::<D>::parse(text, &[]).unwrap();
    let sets = [ends.first().shape().unwrap(), ends.second().shape().unwrap()];
    let line =
        tautline::Problem::new(formula.clone(), ends).solve(tautline::Trapezoidal, n).unwrap();
    let mut pts: Vec<SVector<f64, D>> = line.sequence().points().to_vec();
    let l = pts.len() - 1;
    let c = pts[l];
    let e = pts[l - 1];
    pts[l] += (c - e) * 1e-6;
    let c = pts[0];
    let e = pts[1];
    pts[0] += (c - e) * 1e-6;
    go(name, formula, sets, pts, gap)
}
fn go<const D: usize>(
    name: &str,
    formula: Formula<D>,
    sets: [Shape<D>; 2],
    pts: Vec<SVector<f64, D>>,
    gap: f64,
) {
    let t = std::time::Instant::now();
    let f = search(&formula, &sets, &[pts], Wanted::gap(gap), &mut |p: Progress| {
        eprintln!(
            "{:?} {:.2} {:e}",
            (p.levels, p.cubes),
            t.elapsed().as_secs_f64(),
            (p.upper - p.lower) / p.upper
        );
        ControlFlow::Continue(())
    });
    match f {
        Ok(f) => {
            println!(
                "{name} {:?} lo {} hi {} gap {:e} t {:.2}",
                f.ended,
                f.proved.lower,
                f.proved.upper.unwrap(),
                f.proved.gap().unwrap(),
                t.elapsed().as_secs_f64()
            );
            let t = std::time::Instant::now();
            let text = f.certificate.to_string();
            std::fs::write(format!("/tmp/certs/{name}"), &text).unwrap();
            println!("  bytes {} written {:.2}", text.len(), t.elapsed().as_secs_f64());
            let r = tautline::check::AnyCertificate::read(&text).unwrap();
            match &r {
                tautline::check::AnyCertificate::Plane(c) => {
                    println!("  same text {}", c.to_string() == text)
                }
                _ => {}
            };
            println!("  read {:.2}", t.elapsed().as_secs_f64());
            let t = std::time::Instant::now();
            let p = f.certificate.check().unwrap();
            println!("  check {:.2} same {}", t.elapsed().as_secs_f64(), p == f.proved);
        }
        Err(e) => println!("{name} {e}"),
    }
}
fn main() {
    let gap: f64 = std::env::args().nth(1).unwrap().parse().unwrap();
    let which = std::env::args().nth(2).unwrap_or_default();
    let n = 4096;
    let on = |s: &str| which.is_empty() || s == which;
    if on("hill") {
        run("hill", "sqr(1 + 4*exp(-2*(x1^2+x2^2))) I", [-1.5, 0.05], [1.5, -0.1], gap, n);
    }
    if on("corr") {
        run("corr", "sqr(2 - cos(x1)) I", [0.0, 0.0], [4.0 * std::f64::consts::PI, 0.0], gap, n);
    }
    if on("sphere") {
        run("sphere", "4/sqr(1+x1^2+x2^2) I", [-0.5, 0.2], [0.6, 0.4], gap, n);
    }
    if on("shear") {
        run("shear", "pullback(x1 + 0.6*sin(3*x2), x2)", [0.05, 0.03], [1.95, 0.03], gap, n);
    }
    if on("sphere3") {
        run("sphere3", "4/sqr(1+x1^2+x2^2+x3^2) I", [-0.5, 0.2, 0.0], [0.6, 0.4, 0.0], gap, n);
    }
    if on("hill3") {
        run(
            "hill3",
            "sqr(1 + 4*exp(-2*(x1^2+x2^2+x3^2))) I",
            [-1.5, 0.3, 0.0],
            [1.5, 0.2, 0.1],
            gap,
            n,
        );
    }
    use tautline::{Ball, Ends, HalfSpace};
    let hill = "sqr(1 + 4*exp(-2*(x1^2+x2^2))) I";
    if on("hillsets") {
        runs(
            "hillsets",
            hill,
            Ends::new(
                Ball::new([-2.0, 0.0], 0.5).unwrap(),
                HalfSpace::at_least([1.0, 0.0], 2.0).unwrap(),
            )
            .unwrap(),
            gap,
            n,
        );
    }
    if on("hillsetsoff") {
        runs(
            "hillsetsoff",
            hill,
            Ends::new(
                Ball::new([-2.0, 0.3], 0.5).unwrap(),
                HalfSpace::at_least([1.0, 0.0], 2.0).unwrap(),
            )
            .unwrap(),
            gap,
            n,
        );
    }
    if on("p1") {
        runs(
            "p1",
            "sqr(2 - cos(x1)) I",
            Ends::new(
                Ball::new([-2.0, 0.0], 0.5).unwrap(),
                HalfSpace::at_least([1.0, 0.0], 2.0).unwrap(),
            )
            .unwrap(),
            gap,
            n,
        );
    }
    if on("rot") {
        run(
            "rot",
            "c = cos(x1); s = sin(x1); [1 + 3*c^2, 3*c*s; 3*c*s, 1 + 3*s^2]",
            [-1.0, -0.5],
            [1.0, 0.7],
            gap,
            n,
        );
    }
    if on("aniso3") {
        run(
            "aniso3",
            "pullback(x1 + 0.3*sin(2*x2), x2 + 0.2*sin(x3), x3 + 0.2*sin(x1))",
            [-0.5, 0.2, 0.0],
            [0.6, 0.4, 0.3],
            gap,
            n,
        );
    }
    if on("long") {
        run("long", "(1.5 + 0.4*sin(2*x1)*cos(3*x2)) I", [0.0, 0.0], [8.0, 1.0], gap, n);
    }
}
