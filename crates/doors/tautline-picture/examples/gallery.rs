//! Draws eleven problems into a folder, `target/portraits` unless another one is given.

use std::{error::Error, f64::consts::PI, fs, path::PathBuf, sync::Arc};

use tautline::{
    ANY, AxisBox, Ball, ClosedSet, Ends, FiniteSet, HalfSpace, Metric, Point, Problem, Rule,
    SMatrix, SVector, Scalar, Shape, Sphere, Union, check,
    gallery::{
        Bump, CoupledCosines, Obstacle, RotatingAnisotropy, SineProjections, SoftObstacles,
        SpherePatch, TwoLinkArm, Valleys,
    },
};
use tautline_picture::{
    pdf, png,
    portrait::{Corridor, Cubes, Field, Portrait},
    svg,
};

type Outcome<T = ()> = Result<T, Box<dyn Error>>;

/// `H(x) = (2 − cos 3x)²` on the line.
struct Waves;

impl Metric<1> for Waves {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element((2.0 - (x[0] * 3.0).cos()).sqr())
    }
}

fn main() -> Outcome {
    let folder = std::env::args().nth(1).map_or("target/portraits".into(), PathBuf::from);
    fs::create_dir_all(&folder)?;
    let pictures: [(&str, Draw); 11] = [
        ("valleys", valleys),
        ("arm", arm),
        ("rotating", rotating),
        ("two_minima", two_minima),
        ("corridor", corridor),
        ("union", union),
        ("line", line),
        ("eight_dimensions", eight_dimensions),
        ("sphere_patch", sphere_patch),
        ("half_plane", half_plane),
        ("three_dimensions", three_dimensions),
    ];
    for (name, draw) in pictures {
        draw(&|portrait: &Portrait<'_>| {
            let scene = portrait.draw()?;
            let path = |extension: &str| folder.join(format!("{name}.{extension}"));
            fs::write(path("svg"), svg(&scene))?;
            fs::write(path("png"), png(&scene)?)?;
            fs::write(path("pdf"), pdf(&scene))?;
            println!("{}", path("svg").display());
            Ok(())
        })?;
    }
    Ok(())
}

type Draw = fn(&Write<'_>) -> Outcome;
type Write<'a> = dyn Fn(&Portrait<'_>) -> Outcome + 'a;

fn solve<M: Metric<D>, const D: usize>(metric: M, ends: Ends<D>) -> Outcome<Vec<Vec<f64>>> {
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 128)?;
    Ok(line.sequence().points().iter().map(|x| x.as_slice().to_vec()).collect())
}

fn gram<M: Metric<D>, const D: usize>(metric: &M) -> impl Fn(&[f64]) -> Option<Vec<f64>> {
    |x| Some(metric.gram(&SVector::<f64, D>::from_column_slice(x)).as_slice().to_vec())
}

/// Returns the two sets as data.
fn shapes<const D: usize>(ends: &Ends<D>) -> Outcome<[[Shape<ANY>; 1]; 2]> {
    let shape =
        |set: &dyn ClosedSet<D>| set.shape().map(Shape::into_any).ok_or("a set of one's own");
    Ok([[shape(&**ends.first())?], [shape(&**ends.second())?]])
}

fn valleys(write: &Write<'_>) -> Outcome {
    let ends = Ends::new(Ball::new([0.0, 0.0], 1.0)?, HalfSpace::at_least([3.0, 1.0], 24.0)?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(Valleys, ends)?;
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        ..Portrait::new(2, &gram::<_, 2>(&Valleys))
    })
}

fn arm(write: &Write<'_>) -> Outcome {
    let arm = TwoLinkArm::new(3.0, 1.0, 1.0)?;
    let ends = Ends::points([-1.2, 2.6], [1.6, -2.2])?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(arm, ends)?;
    write(&Portrait { ends: [&from, &to], curve: &curve, ..Portrait::new(2, &gram::<_, 2>(&arm)) })
}

fn rotating(write: &Write<'_>) -> Outcome {
    let metric = RotatingAnisotropy::new([1.0, 9.0], [0.8, 0.4])?;
    let ends = Ends::new(Point::new([-2.0, -1.0])?, AxisBox::new([2.5, 1.0], [0.5, 0.7])?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric, ends)?;
    let gram = gram::<_, 2>(&metric);
    let portrait = Portrait::new(2, &gram);
    write(&Portrait { ends: [&from, &to], curve: &curve, field: Field::Ellipses, ..portrait })
}

fn two_minima(write: &Write<'_>) -> Outcome {
    // The hill and the ends are symmetric about the first axis, and so are the two minima.
    let metric = Bump::new(8.0, 0.5)?;
    let ends = Ends::points([-1.5, 0.0], [1.5, 0.0])?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric, ends)?;
    let mirrored: Vec<Vec<f64>> = curve.iter().map(|x| vec![x[0], -x[1]]).collect();
    let gram = gram::<_, 2>(&metric);
    let portrait = Portrait::new(2, &gram);
    write(&Portrait { ends: [&from, &to], curve: &curve, others: &[mirrored], ..portrait })
}

fn corridor(write: &Write<'_>) -> Outcome {
    // The way around the other side of the hill is longer by 2 per cent.
    let metric = Bump::new(4.0, 0.5)?;
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1])?;
    let [from, to] = shapes(&ends)?;
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 256)?;
    let found = line.certificate(1e-4)?;
    let plain = |cubes: &check::Cubes<2>| Cubes {
        side: cubes.side(),
        places: cubes.places().iter().flatten().copied().collect(),
    };
    let levels = found.certificate.levels.iter().map(|level| level.cubes());
    let levels: Vec<Cubes> = levels.chain([&found.proved.corridor]).map(plain).collect();
    let bounds = [found.proved.lower, found.proved.upper.ok_or("no upper bound")?];
    let curve: Vec<Vec<f64>> =
        line.sequence().points().iter().map(|x| x.as_slice().to_vec()).collect();
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        corridor: Some(Corridor { levels: &levels, bounds }),
        ..Portrait::new(2, &gram::<_, 2>(&metric))
    })
}

fn union(write: &Write<'_>) -> Outcome {
    let at = |x: f64, y: f64, height: f64, width: f64| Obstacle {
        centre: SVector::from([x, y]),
        height,
        width,
    };
    let metric = SoftObstacles::new(vec![
        at(1.2, 0.3, 30.0, 0.4),
        at(2.0, 1.6, 20.0, 0.5),
        at(0.6, 2.0, 12.0, 0.3),
        at(2.2, -0.8, 30.0, 0.4),
    ])?;
    let from: Union<2> = Union::new(vec![
        Arc::new(Ball::new([-0.6, 0.0], 0.4)?),
        Arc::new(AxisBox::new([-0.4, 1.6], [0.3, 0.4])?),
    ])?;
    let harbours = [[3.2, 0.6], [3.0, 2.2], [1.4, -1.8]];
    let ends = Ends::new(from, FiniteSet::new(harbours)?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric.clone(), ends)?;
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        ..Portrait::new(2, &gram::<_, 2>(&metric))
    })
}

fn line(write: &Write<'_>) -> Outcome {
    let ends = Ends::new(Ball::new([0.0], 0.4)?, HalfSpace::at_least([1.0], 4.0)?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(Waves, ends)?;
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        ..Portrait::new(1, &gram::<_, 1>(&Waves))
    })
}

fn eight_dimensions(write: &Write<'_>) -> Outcome {
    let metric = SineProjections::benchmark();
    let ends = Ends::new(Ball::new([0.0; 8], 0.3)?, Point::new([1.0; 8])?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric.clone(), ends)?;
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        ..Portrait::new(8, &gram::<_, 8>(&metric))
    })
}

fn sphere_patch(write: &Write<'_>) -> Outcome {
    let metric = SpherePatch::new(1.5)?;
    let ends = Ends::new(Sphere::new([-0.7, 0.3], 0.3)?, Point::new([1.2, 0.5])?)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric, ends)?;
    let gram = gram::<_, 2>(&metric);
    let portrait = Portrait::new(2, &gram);
    write(&Portrait { ends: [&from, &to], curve: &curve, field: Field::Ellipses, ..portrait })
}

fn half_plane(write: &Write<'_>) -> Outcome {
    // H(x) = I/x₂² is defined for x₂ > 0, and its shortest curves are arcs of circles about points
    // of the first axis.
    let gram = |x: &[f64]| {
        let phi = 1.0 / (x[1] * x[1]);
        (x[1] > 0.0).then(|| vec![phi, 0.0, 0.0, phi])
    };
    let arc = |k: i32| {
        let angle = PI * (0.9 - 0.75 * f64::from(k) / 60.0);
        vec![angle.cos(), angle.sin()]
    };
    let curve: Vec<Vec<f64>> = (0..=60).map(arc).collect();
    let end = |x| Point::from_slice(x).map(|point| [Shape::Point(point)]);
    let ends = [end(&curve[0])?, end(&curve[60])?];
    let window = Some([[-1.3, 1.3], [-0.3, 1.4]]);
    let portrait = Portrait::new(2, &gram);
    write(&Portrait { ends: [&ends[0], &ends[1]], curve: &curve, window, ..portrait })
}

fn three_dimensions(write: &Write<'_>) -> Outcome {
    let metric = CoupledCosines;
    let wall = HalfSpace::at_least([0.0, 1.0, 1.0], 4.0)?;
    let ends = Ends::new(Ball::new([0.0; 3], 0.5)?, wall)?;
    let [from, to] = shapes(&ends)?;
    let curve = solve(metric, ends)?;
    write(&Portrait {
        ends: [&from, &to],
        curve: &curve,
        coordinates: Some([0, 1]),
        ..Portrait::new(3, &gram::<_, 3>(&metric))
    })
}
