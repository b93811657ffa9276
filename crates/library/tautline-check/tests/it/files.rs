//! Files of every kind of content: they are read as they were written, and say what they are about.

use std::sync::Arc;

use nalgebra::SVector;
use tautline_check::{AnyCertificate, Certificate, Cubes, Level, Place, Region};
use tautline_formula::{Formula, spline::Spline};
use tautline_scalar::Table;
use tautline_sets::{Ball, HalfSpace, Shape};

use crate::helpers::{axis_box, point};

/// Returns a level with a number of its own at every node of each function.
fn numbered<const D: usize>(number: usize, exponent: i32, places: &[Place<D>]) -> Level<D> {
    let cubes = Cubes::new(exponent, places.to_vec()).expect("in range");
    let count = cubes.nodes().len();
    let values = [0.1, -0.7].map(|step| (0..count).map(|n| step * (n as f64 + 1.0)).collect());
    Level::new(number, cubes, values).expect("finite")
}

fn tables() -> [(&'static str, Arc<dyn Table>); 3] {
    [("t", vec![3]), ("h", vec![2, 3]), ("f", vec![2, 1, 3])].map(
        |(name, shape): (_, Vec<usize>)| {
            let count = shape.iter().product::<usize>();
            let numbers = (0..count).map(|k| 0.1 * (k as f64 - 1.0)).collect();
            (name, Arc::new(Spline::new(&shape, numbers).expect("a shape")) as Arc<dyn Table>)
        },
    )
}

/// Returns certificates with each kind of region, piece, table and level, with and without a curve.
fn certificates<const D: usize>(formula: &str, places: &[Place<D>]) -> Vec<Certificate<D>> {
    let formula = Formula::parse_with(formula, &[], &tables()).expect("a formula").of_upper_half();
    let vector = |step: f64| SVector::<f64, D>::from_fn(|i, _| step * (i as f64 + 0.3));
    let ball = Shape::Ball(Ball::new(vector(-0.1), 0.7).expect("a radius"));
    let wall = Shape::HalfSpace(HalfSpace::new(vector(0.7), -0.3).expect("a normal"));
    let side = axis_box(vector(-1.1).into(), vector(1.3).into());
    let spot = point(vector(0.9).into());
    let pieces = [ball, wall, side, spot];
    let regions = [
        Region::Tubes { radius: 0.3, c1: 0.1 },
        Region::Declared { c1: 0.7 },
        Region::ExitOne,
        Region::ExitTwo,
    ];
    (0..4)
        .map(|n| {
            let [one, other] = [pieces[n].clone(), pieces[(n + 1) % 4].clone()];
            let all = Shape::Union(vec![pieces[(n + 2) % 4].clone(), other, one.clone()]);
            let sets = if n % 2 == 0 { [one, all] } else { [all, one] };
            let curve = (n > 0).then(|| (0..n).map(|k| vector(0.1 * k as f64)).collect());
            let levels = (0..n).map(|level| numbered(level, -3 - level as i32, places)).collect();
            Certificate {
                formula: formula.clone(),
                sets,
                hi: 0.1,
                region: regions[n],
                curve,
                levels,
            }
        })
        .collect()
}

/// Runs of cubes that touch at the ends of rows, that have gaps, and that are in different rows.
#[test]
fn files_are_read_as_they_were_written_in_every_dimension() {
    let line: Vec<Place<1>> = [-3, -2, 0, 1, 2, 7].map(|k| [k]).to_vec();
    for certificate in certificates::<1>("[2 + t(x1) + t_1(x1)]", &line) {
        let read = AnyCertificate::read(&certificate.to_string());
        assert_eq!(read, Ok(AnyCertificate::Line(certificate)));
    }
    let plane: Vec<Place<2>> =
        vec![[-1, 3], [-1, 4], [0, 5], [0, 6], [1, -7], [1, 7], [1, 8], [1, 10]];
    for certificate in
        certificates::<2>("s = h(x2, x1)*t(x1) + 0.1; [2, s; s, h_02(x1, x2)]", &plane)
    {
        let read = AnyCertificate::read(&certificate.to_string());
        assert_eq!(read, Ok(AnyCertificate::Plane(certificate)));
    }
    let space: Vec<Place<3>> =
        vec![[-1, 3, 0], [-1, 3, 1], [-1, 4, 2], [0, 4, 3], [0, 4, 4], [2, 0, -9]];
    for certificate in certificates::<3>("2 + f(x1, x2, x3) + f_010(x3, x2, x1) I", &space) {
        let read = AnyCertificate::read(&certificate.to_string());
        assert_eq!(read, Ok(AnyCertificate::Space(certificate)));
    }
    let four: Vec<Place<4>> = vec![[0, -1, 3, 0], [0, -1, 3, 1], [0, 0, 3, 2], [5, 0, 0, 0]];
    for certificate in certificates::<4>("cost(2 + sin(x1 - x4)*x2^3 + h(x3, x1))", &four) {
        let read = AnyCertificate::read(&certificate.to_string());
        assert_eq!(read, Ok(AnyCertificate::Four(certificate)));
    }
}

/// What changes the distance changes the first lines, by which files are compared.
#[test]
fn two_statements_are_equal_only_if_all_of_their_numbers_are() {
    let places: [Place<2>; 1] = [[0, 0]];
    let all = certificates::<2>("2 + h(x1, x2) I", &places);
    let mut seen: Vec<String> = all.iter().map(Certificate::statement).collect();
    let base = &all[1];
    let mut changed = vec![base.clone(); 6];
    changed[0].hi = base.hi.next_up();
    changed[1].region = Region::Declared { c1: 0.7_f64.next_down() };
    changed[2].sets.reverse();
    changed[3].sets[1] = Shape::Ball(Ball::new([0.0, 0.0], 1.0).expect("a radius"));
    for (n, shape, last) in [(4, [2, 3], 0.5), (5, [3, 2], 0.4)] {
        let mut numbers: Vec<f64> = (0..6).map(|k| 0.1 * (f64::from(k) - 1.0)).collect();
        numbers[5] = last;
        let table: Arc<dyn Table> = Arc::new(Spline::new(&shape, numbers).expect("a shape"));
        let formula = Formula::parse_with("2 + h(x1, x2) I", &[], &[("h", table)]);
        changed[n].formula = formula.expect("a formula").of_upper_half();
    }
    seen.extend(changed.iter().map(Certificate::statement));
    for (n, statement) in seen.iter().enumerate() {
        assert!(!seen[..n].contains(statement), "{statement}");
    }
    // Values, curves and cubes are no part of it.
    let mut same = base.clone();
    (same.curve, same.levels) = (None, Vec::new());
    assert_eq!(same.statement(), base.statement());
}
