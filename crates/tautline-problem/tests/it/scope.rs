//! How far a search looks, in a file.

use tautline::{Point, Scope};
use tautline_any::{Given, Grid, Request, Shape};
use tautline_problem::{Answer, Question};

/// Seven hills, between which a path through a lattice finds a shorter way than the starts do.
const HILLS: &str = "1 + 29.1*exp(-((x1+1.05)^2 + (x2+0.27)^2)/(2*0.152^2)) \
    + 7.43*exp(-((x1+0.96)^2 + (x2+0.28)^2)/(2*0.114^2)) \
    + 5.02*exp(-((x1-0.04)^2 + (x2-0.10)^2)/(2*0.173^2)) \
    + 23.8*exp(-((x1+0.34)^2 + (x2-0.52)^2)/(2*0.235^2)) \
    + 9.52*exp(-((x1-0.81)^2 + (x2+1.12)^2)/(2*0.321^2)) \
    + 8.63*exp(-((x1+0.99)^2 + (x2+0.77)^2)/(2*0.160^2)) \
    + 22.7*exp(-((x1+1.16)^2 + (x2-0.93)^2)/(2*0.133^2))";

fn answer(scope: &str) -> Answer {
    let text = format!(
        "[metric]\ncost = \"sqrt({HILLS})\"\n[from]\npoint = [-1.8, -0.712]\n[to]\npoint = [1.8, 0.731]\n\
         [solve]\nn = 128\n{scope}\n[certify]\nbound = false\n"
    );
    Question::read(&text).expect("a file").solve(&mut |_| ()).expect("a line")
}

/// The default finds the shorter way, the local search does not, and Python's request is that of the file.
#[test]
fn a_search_looks_as_far_as_its_scope() {
    let [default, automatic, local] =
        ["", "scope = \"automatic\"", "scope = \"local\""].map(|scope| answer(scope).length.value);
    assert_eq!(default, automatic);
    assert!(automatic < 0.95 * local, "{automatic} {local}");
    let metric = Given::parse(&format!("cost(sqrt({HILLS}))"), 2, &[], &[]).expect("a metric");
    let point = |x: &[f64]| [Shape::Point(Point::from_slice(x).expect("finite"))];
    let (a, b) = (point(&[-1.8, -0.712]), point(&[1.8, 0.731]));
    for (scope, length) in [(Scope::Automatic, automatic), (Scope::Local, local)] {
        let grid = Grid::Chords(128);
        let request = Request { scope, grid, ..Request::default() };
        let curve = metric.solve([&a, &b], &request).expect("a line");
        assert_eq!(curve.length().value, length);
    }
}
