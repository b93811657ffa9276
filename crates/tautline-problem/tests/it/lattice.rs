//! A lattice in the section `[solve]`.

use tautline_problem::{Failure, Grid, Question};

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
