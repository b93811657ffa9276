//! try
use nalgebra::SVector;
use std::ops::ControlFlow;
use tautline_distance::*;
use tautline_formula::Formula;
use tautline_sets::{Point, Shape};
fn run<const D: usize>(name: &str, text: &str, a: [f64; D], b: [f64; D], gap: f64, n: usize) {
    let formula = Formula::<D>::parse(text, &[]).unwrap();
    let ends = tautline::Ends::points(a, b).unwrap();
    let line =
        tautline::Problem::new(formula.clone(), ends).solve(tautline::Trapezoidal, n).unwrap();
    let pts: Vec<SVector<f64, D>> = line.sequence().points().to_vec();
    let t = std::time::Instant::now();
    let sets = [Shape::Point(Point::new(a).unwrap()), Shape::Point(Point::new(b).unwrap())];
    let f = search(&formula, &sets, &pts, Wanted { gap, cubes: 2_000_000 }, &mut |p: Progress| {
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
            let r = tautline_check::AnyCertificate::read(&text).unwrap();
            match &r {
                tautline_check::AnyCertificate::Plane(c) => {
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
}
