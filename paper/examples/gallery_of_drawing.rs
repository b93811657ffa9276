//! What the drawing layer can do, with invented data: `cargo run -p paper --example gallery_of_drawing FOLDER`.

use std::{env, error::Error, f64::consts::PI, fs, path::Path};

use paper::drawing::{
    Align, Axis, Curve, DrawingError, Field, Figure, Marker, Note, Panel, Scale, Scene,
    SlopeTriangle, palette, pdf, png, svg,
};

type Points = Vec<(f64, f64)>;

fn main() -> Result<(), Box<dyn Error>> {
    let folder = env::args().nth(1).ok_or("give the folder to write into")?;
    for (name, scene) in figures()? {
        let file = |ending: &str| Path::new(&folder).join(format!("{name}.{ending}"));
        fs::write(file("svg"), svg(&scene))?;
        fs::write(file("png"), png(&scene)?)?;
        fs::write(file("pdf"), pdf(&scene))?;
    }
    Ok(())
}

/// Returns every figure with its name.
pub(crate) fn figures() -> Result<Vec<(&'static str, Scene)>, DrawingError> {
    Ok(vec![
        ("convergence", convergence()?.draw()?),
        ("convergence_one", convergence_one()?.draw()?),
        ("valleys", valleys()?.draw()?),
        ("lengths", lengths()?.draw()?),
        ("stack", stack()?.draw()?),
    ])
}

/// The powers of two from 1 to 4096, each with the value of a function there.
fn over_n(f: impl Fn(f64) -> f64) -> Points {
    (0..=12).map(|k| 2.0_f64.powi(k)).map(|n| (n, f(n))).collect()
}

/// A panel of the convergence figure: two observed curves far below their bounds.
fn convergence_panel(title: &str, size: f64, y_label: &str) -> Result<Panel, DrawingError> {
    let wobble = |n: f64| 1.0 + 0.25 * (n.ln() * 2.3).sin();
    let trapezoidal = over_n(|n| size * wobble(n) / n.powi(2));
    let left = over_n(|n| 2.3 * size * wobble(n + 1.0) / n.powi(2));
    let paper = over_n(|n| 3e12 * size / n.sqrt());
    let second = over_n(|n| 6e3 * size / n.powi(2));
    let all = [&trapezoidal, &left, &paper, &second];
    let values = all.into_iter().flatten().map(|point| point.1);
    let x = Axis::new(Scale::Octaves, 1.0, 4096.0)?.labelled("number of subintervals $N$");
    let y = Axis::decades_covering(values, 4.0)?.labelled(y_label);
    Ok(Panel::new(x, y)
        .titled(title)
        .tall(330.0)
        .curve(Curve::new(paper, palette::SKY).labelled("bound $C\u{2009}N^{-1/2}$"))
        .curve(
            Curve::new(second, palette::BLUE)
                .dashed(&[7.0, 3.0])
                .labelled("second-order bound $C_\"tra\"^♯ N^{-2}$"),
        )
        .curve(
            Curve::new(left, palette::GREEN).marked(Marker::Square).labelled("left-endpoint rule"),
        )
        .curve(
            Curve::new(trapezoidal, palette::VERMILLION)
                .marked(Marker::Disc)
                .labelled("trapezoidal rule"),
        )
        .triangle(SlopeTriangle::below(-2.0, 4.0, 32.0, 8e-3 * size)))
}

fn convergence() -> Result<Figure, DrawingError> {
    let row = vec![
        convergence_panel("(a)  valleys, $D = 2$", 0.7, "excess energy $E(γ^\"pl\") - d^2$")?,
        convergence_panel("(b)  shear, $D = 2$", 12.0, "")?,
        convergence_panel("(c)  separable, $D = 3$", 0.05, "")?,
    ];
    Ok(Figure::new(960.0, "Excess energy against N in three metrics", vec![row]).keyed())
}

fn convergence_one() -> Result<Figure, DrawingError> {
    let panel = convergence_panel("", 0.7, "excess energy $E(γ^\"pl\") - d^2$")?;
    Ok(Figure::new(640.0, "Excess energy against N", vec![vec![panel]]))
}

fn valleys() -> Result<Figure, DrawingError> {
    let (x, y) = ((-1.0, 4.0 * PI + 1.0), (-2.0, 2.0));
    let levels: Vec<f64> = (4..=36).map(|k| f64::from(k) / 4.0).collect();
    let field = Field::sample(x, y, levels, |x, _| (2.0 - x.cos()).powi(2))?
        .lined_every(4)
        .labelled("$(2 - \"cos\" x_1)^2$");
    let straight: Points = (0..=64).map(|k| (PI * f64::from(k) / 16.0, 0.0)).collect();
    let bow: Points = straight.iter().map(|(x, _)| (*x, 0.9 * (x / 4.0).sin())).collect();
    let jumps: Points = vec![(0.0, -1.2), (2.0 * PI, -1.2), (4.0 * PI, -1.2)];
    let minimiser: Points = (0..=16).map(|k| (PI * f64::from(k) / 4.0, 0.0)).collect();
    let panel = Panel::new(
        Axis::new(Scale::MultiplesOfPi, x.0, x.1)?.labelled("$x_1$"),
        Axis::new(Scale::Linear, y.0, y.1)?.labelled("$x_2$"),
    )
    .equal_units()
    .over(field)
    .curve(Curve::new(straight, palette::INK).over_field())
    .curve(Curve::new(bow, palette::VERMILLION).wide(2.0).over_field())
    .curve(Curve::new(minimiser, palette::INK).without_line().marked(Marker::Disc).over_field())
    .curve(
        Curve::new(jumps, palette::GREEN).dashed(&[4.0, 3.0]).marked(Marker::Diamond).over_field(),
    )
    .note(Note::new((2.0 * PI, 0.9), "$γ$", palette::VERMILLION, Align::Centre).shifted(0.0, -14.0))
    .note(
        Note::new((PI, -1.2), "$L_\"tra\"$: jumps", palette::GREEN, Align::Centre)
            .shifted(0.0, 16.0),
    );
    Ok(Figure::new(900.0, "Valleys with curves over them", vec![vec![panel]]))
}

fn lengths() -> Result<Figure, DrawingError> {
    let n_axis = Axis::new(Scale::Octaves, 1.0, 4096.0)?.labelled("number of subintervals $N$");
    let y = Axis::new(Scale::MultiplesOfPi, 3.5 * PI, 8.25 * PI)?.labelled("value");
    let left = over_n(|n| 8.0 * PI - 4.0 * PI / n.powf(0.9));
    let trapezoidal = over_n(|n| 8.0 * PI - 4.0 * PI / n.powi(2));
    let flat = over_n(|_| 4.0 * PI);
    let panel = Panel::new(n_axis, y)
        .tall(300.0)
        .curve(Curve::level(8.0 * PI, palette::GREY).labelled("$d = 8π$"))
        .curve(Curve::level(4.0 * PI, palette::GREY))
        .curve(
            Curve::new(left, palette::BLUE).marked(Marker::Square).labelled("$√{E_{\"left\",N}}$"),
        )
        .curve(
            Curve::new(trapezoidal, palette::VERMILLION)
                .marked(Marker::Disc)
                .labelled("$√{E_{\"tra\",N}}$"),
        )
        .curve(
            Curve::new(flat, palette::GREEN)
                .marked(Marker::Ring)
                .labelled("shortest polygons\n$L_{\"left\",N} = L_{\"tra\",N} = 4π$"),
        );
    Ok(Figure::new(640.0, "Length and energy against N", vec![vec![panel]]))
}

fn stack() -> Result<Figure, DrawingError> {
    let x = |label: &str| Ok(Axis::new(Scale::Linear, 0.0, 1.0)?.labelled(label));
    let speed: Points =
        (0..=64).map(|k| f64::from(k) / 64.0).map(|t| (t, 2.0 + (9.0 * t).sin())).collect();
    let bent: Points = speed.iter().map(|(t, v)| (*t, 1e-3 * v * v)).collect();
    let top = Panel::new(
        x("")?.unnumbered(),
        Axis::new(Scale::Linear, 0.5, 3.5)?.labelled("speed $‖γ\u{307}‖_g$"),
    )
    .titled("(a)")
    .tall(140.0)
    .curve(Curve::new(speed, palette::BLUE).labelled("$K\u{304}_{3,g}$"));
    let bottom = Panel::new(
        x("time $t$")?,
        Axis::decades_covering(bent.iter().map(|p| p.1), 9.0)?.labelled("$δ$"),
    )
    .titled("(b)")
    .tall(140.0)
    .curve(Curve::new(bent, palette::PURPLE).marked(Marker::Cross).labelled("coefficient"));
    Ok(Figure::new(520.0, "Two stacked panels", vec![vec![top], vec![bottom]]))
}
