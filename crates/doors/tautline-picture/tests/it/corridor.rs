//! The drawn squares are those of the certificate.

use tautline::{Ends, Problem, Rule, check, gallery::Bump};
use tautline_picture::{
    Paint, Segment,
    palette::ORANGE,
    portrait::{Corridor, Cubes, Field, Portrait},
};

use crate::reading::{Reading, labels};

const WINDOW: [[f64; 2]; 2] = [[-2.0, 2.0], [-1.0, 1.0]];

fn nothing(_: &[f64]) -> Option<Vec<f64>> {
    None
}

fn plain<const D: usize>(cubes: &check::Cubes<D>) -> Cubes {
    Cubes { side: cubes.side(), places: cubes.places().iter().flatten().copied().collect() }
}

/// Returns how often closed rings go around a point.
fn winding(segments: &[Segment], (x, y): (f64, f64)) -> i32 {
    let (mut count, mut start, mut at) = (0, (0.0, 0.0), (0.0, 0.0));
    let mut side = |a: (f64, f64), b: (f64, f64)| {
        let crossing = |a: (f64, f64), b: (f64, f64)| {
            a.1 <= y && y < b.1 && x < a.0 + (y - a.1) / (b.1 - a.1) * (b.0 - a.0)
        };
        count += i32::from(crossing(a, b)) - i32::from(crossing(b, a));
    };
    for segment in segments {
        match *segment {
            Segment::Move(x, y) => (start, at) = ((x, y), (x, y)),
            Segment::Line(x, y) => {
                side(at, (x, y));
                at = (x, y);
            }
            Segment::Close => side(at, start),
            Segment::Cubic(_) => panic!("squares have straight sides"),
        }
    }
    count
}

#[test]
fn the_drawn_squares_are_the_corridor_of_the_certificate() {
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("points");
    let hill = Bump::new(4.0, 0.5).expect("a hill");
    let line = Problem::new(hill, ends).solve(Rule::TRAPEZOIDAL, 256).expect("a line");
    let found = line.certificate(1e-2).expect("a certificate");
    let proved = found.certificate.check().expect("a proof");
    let sets = found.certificate.levels.iter().map(|level| level.cubes());
    let sets: Vec<&check::Cubes<2>> = sets.chain([&proved.corridor]).collect();
    let levels: Vec<Cubes> = sets.iter().map(|cubes| plain(cubes)).collect();
    let bounds = [proved.lower, proved.upper.expect("a curve")];
    let portrait = Portrait {
        corridor: Some(Corridor { levels: &levels, bounds }),
        window: Some(WINDOW),
        field: Field::Plain,
        ..Portrait::new(2, &nothing)
    };
    let scene = portrait.draw().expect("a picture");
    let reading = Reading::new(&scene, WINDOW);
    let orange = |fill: Paint| fill.colour == ORANGE && fill.opacity < 1.0;
    let drawn: Vec<_> =
        scene.shapes().iter().filter(|shape| shape.fill.is_some_and(orange)).collect();
    assert_eq!(drawn.len(), sets.len());
    for (shape, cubes) in drawn.iter().zip(&sets) {
        let [[left, right], [bottom, top]] = WINDOW;
        let range = |from: f64, to: f64| (from / cubes.side()) as i32..(to / cubes.side()) as i32;
        let mut inside = 0;
        for i in range(left, right) {
            for j in range(bottom, top) {
                let middle = |k: i32| (f64::from(k) + 0.5) * cubes.side();
                let at = reading.place(middle(i), middle(j));
                let is_drawn = winding(shape.path.segments(), at) != 0;
                assert_eq!(is_drawn, cubes.contains(&[i, j]), "{i}, {j} of {}", cubes.side());
                inside += usize::from(is_drawn);
            }
        }
        assert!(inside > 100, "only {inside} squares of side {}", cubes.side());
    }
    let text = labels(&scene).join(" ");
    assert!(text.contains("Every minimal geodesic lies in the darkest orange squares"), "{text}");
}

#[test]
fn cubes_in_space_are_projected_and_the_finest_are_in_the_window() {
    // Two cubes lie over one square.
    let levels = [Cubes { side: 0.5, places: vec![0, 7, 1, 0, 9, 1, 1, 9, 1] }];
    let curve = [vec![0.1, 4.0, 0.6], vec![0.9, 4.0, 0.6]];
    let portrait = Portrait {
        curve: &curve,
        corridor: Some(Corridor { levels: &levels, bounds: [1.0, 1.5] }),
        coordinates: Some([0, 2]),
        field: Field::Plain,
        ..Portrait::new(3, &nothing)
    };
    let scene = portrait.draw().expect("a picture");
    let text = labels(&scene).join(" ");
    assert!(text.contains("Every minimal geodesic projects into"), "{text}");
    // From 0 to 1 with a tenth on both sides.
    let shape = scene.shapes().iter().find(|shape| shape.fill.is_some_and(|f| f.colour == ORANGE));
    let shape = shape.expect("a corridor");
    let (extent, frame) = (shape.path.extent().expect("corners"), shape.clip.expect("a frame"));
    let share = extent.width() / frame.width();
    assert!((share - 1.0 / 1.2).abs() <= 1e-3, "{share}");
    // One rectangle of two squares: the four corners and the way back.
    assert_eq!(shape.path.segments().len(), 5);
}
