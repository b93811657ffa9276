//! A lattice in the section `[solve]`, and how far a search looks without one.

use tautline::{Point, Scope};
use tautline_any::{Given, Request, Shape};
use tautline_problem::{Answer, Failure, Grid, Question};

/// A wall along `x₁ = 0` with a gap at `x₂ = 3`.
const WALL: &str = "\
[metric]
cost = \"1 + 100*exp(-(x1/0.1)^2)*(1 - exp(-((x2 - 3)/0.3)^2))\"
[from]
point = [-1, 0]
[to]
point = [1, 0]
[certify]
bound = false
[solve]
n = 512
";
const LATTICE: &str = "lattice = { lower = [-2, -1], upper = [2, 4], spacing = \"1/20\" }\n";

#[test]
fn a_lattice_finds_the_gap_in_a_wall() {
    let length = |file: &str| {
        let question = Question::read(file).expect("a file");
        question.solve(&mut |_| ()).expect("a curve").length.value
    };
    let (automatic, found) = (length(WALL), length(&format!("{WALL}{LATTICE}")));
    // √40 is the way to the gap and back, without the wall.
    assert!((6.3..7.0).contains(&found) && automatic > 15.0, "{found} beside {automatic}");
}

#[test]
fn each_mistake_in_a_lattice_is_underlined() {
    let file = format!("{WALL}{LATTICE}");
    for (from, to, underlined, says) in [
        ("n = 512", "tolerance = 1e-6", "{ lower", "a lattice besides a tolerance"),
        ("upper = [2, 4]", "upper = [2, 4, 1]", "[2, 4, 1]", "3 coordinates in dimension 2"),
        ("upper = [2, 4]", "upper = [-4, 4]", "{ lower", "coordinate 1 of a lattice from -2 to -4"),
        ("\"1/20\"", "0", "{ lower", "with the spacing 0"),
        ("\"1/20\"", "1e-6", "{ lower", "nodes; at most"),
        ("lower = [-2, -1]", "lower = [1.5, 3]", "{ lower", "no node of the lattice"),
        ("spacing", "step", "step", "unknown key step"),
        (" }", ", classes = 0 }", "0", "no homotopy class"),
    ] {
        let wrong = file.replace(from, to);
        let solved =
            Question::read(&wrong).map_err(Failure::from).and_then(|q| q.solve(&mut |_| ()));
        let Err(Failure::BadInput(diagnostic)) = solved else { panic!("{wrong}: {solved:?}") };
        assert!(wrong[diagnostic.at.clone()].starts_with(underlined), "{wrong}: {diagnostic:?}");
        assert!(diagnostic.to_string().contains(says), "{wrong}: {diagnostic}");
    }
}

/// Three hills across the way leave four ways: the answer has all of them, where the automatic search
/// meets fewer.
#[test]
fn classes_find_every_way_past_the_hills() {
    let hill = |y: f64| format!("20*exp(-(x1^2 + (x2 - ({y}))^2)/0.08)");
    let hills: Vec<String> = [-1.0, 0.1, 1.3].map(hill).to_vec();
    let file = format!(
        "[metric]\ncost = \"1 + {}\"\n[from]\npoint = [-2, 0]\n[to]\npoint = [2, 0.1]\n\
         [certify]\nbound = false\n[solve]\nn = 64\n",
        hills.join(" + ")
    );
    let ways = |file: &str| {
        let question = Question::read(file).expect("a file");
        let answer = question.solve(&mut |_| ()).expect("a curve");
        let others: Vec<f64> = answer.other_minima.iter().map(|other| other.length.value).collect();
        assert!(others.iter().all(|other| *other > answer.length.value));
        others.len() + 1
    };
    let lattice =
        "lattice = { lower = [-2.2, -2], upper = [2.2, 2.2], spacing = 0.1, classes = 4 }";
    assert!(ways(&format!("{file}scope = \"local\"\n")) < 4);
    assert_eq!(ways(&format!("{file}{lattice}\n")), 4);
}

/// A search along a lattice has one grid, also where a tolerance is asked for later. A refused grid changes
/// nothing.
#[test]
fn a_tolerance_that_is_asked_for_is_refused_too() {
    let file = format!("{WALL}{LATTICE}");
    let mut question = Question::read(&file).expect("a file");
    let refused = question.set_grid(Grid::Tolerance(1e-6)).expect_err("a lattice");
    assert_eq!(refused.message, "a lattice besides a tolerance");
    assert!(file[refused.at].starts_with("{ lower"));
    assert_eq!(question.solve(&mut |_| ()).expect("a curve").n, 512);
    question.set_grid(Grid::Chords(256)).expect("a number of chords");
    assert_eq!(question.solve(&mut |_| ()).expect("a curve").n, 256);
    let mut without = Question::read(WALL).expect("a file");
    assert!(without.set_grid(Grid::Tolerance(1e-2)).is_ok());
}

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
