//! Every figure is legible, its three files agree, and two runs give the same bytes.

use std::sync::OnceLock;

use paper::{
    Failure,
    artefact::{Artefact, Form, Times},
    drawing::{Extent, Scene, Shape, pdf, png, svg},
    figures::FIGURES,
    output::Output,
    parallel,
    sweep::Sweep,
};

/// All figures, computed and drawn once.
fn figures() -> &'static [(&'static str, Scene)] {
    static FIRST: OnceLock<Vec<(&'static str, Scene)>> = OnceLock::new();
    FIRST.get_or_init(|| computed(Sweep { quick: false, repeats: false }).expect("drawable"))
}

/// Figures with measured times are drawn from the committed data: on each machine and in each run the
/// times are others, and so are their pictures.
fn computed(sweep: Sweep) -> Result<Vec<(&'static str, Scene)>, Failure> {
    let draw = |figure: &Artefact| match figure.form {
        Form::Figure(draw) if figure.times == Times::None => {
            Ok((figure.id, draw(&(figure.data)(sweep)?)?))
        }
        Form::Figure(draw) => {
            let quick = (figure.data)(Sweep { quick: true, repeats: false })?;
            let committed = Output::committed().read(&figure.data_file())?;
            Ok((figure.id, draw(&quick.read(&committed)?)?))
        }
        Form::Table(_) => Err(Failure::Data(format!("{} is a table", figure.id))),
    };
    parallel::map(FIGURES, draw).into_iter().collect()
}

/// The ink of a scene that is neither white nor invisible, cut by the clips, in px.
fn inked(scene: &Scene) -> Extent {
    let white = |shape: &Shape| shape.fill.is_some_and(|fill| fill.colour.rgb == [255; 3]);
    let mut all: Option<Extent> = None;
    for shape in scene.shapes().iter().filter(|shape| !white(shape)) {
        let Some(mut extent) = shape.path.extent() else { continue };
        let grown = shape.stroke.as_ref().map_or(0.0, |stroke| stroke.width / 2.0);
        if shape.stroke.as_ref().is_some_and(|stroke| stroke.paint.colour.rgb == [255; 3]) {
            continue;
        }
        extent = extent.inset(-grown, -grown);
        if let Some(clip) = shape.clip {
            extent.left = extent.left.clamp(clip.left, clip.right);
            extent.right = extent.right.clamp(clip.left, clip.right);
            extent.top = extent.top.clamp(clip.top, clip.bottom);
            extent.bottom = extent.bottom.clamp(clip.top, clip.bottom);
        }
        all = Some(all.map_or(extent, |others| others.union(extent)));
    }
    all.expect("a figure has ink")
}

#[test]
fn labels_neither_overlap_nor_leave_the_canvas() {
    for (name, scene) in figures() {
        assert_eq!(scene.check_labels(), Ok(()), "{name}");
        assert_eq!(scene.check_crossings(), Ok(()), "{name}");
        assert!(scene.canvas().contains(&inked(scene)), "{name}: {:?}", inked(scene));
    }
}

/// A quick run; `cargo xtask ci` compares the full figures with what is committed.
#[test]
fn two_runs_give_the_same_bytes() {
    let [first, second] =
        [(); 2].map(|()| computed(Sweep { quick: true, repeats: false }).expect("drawable"));
    for ((name, a), (_, b)) in first.iter().zip(&second) {
        assert_eq!(svg(a), svg(b), "{name}.svg");
        assert_eq!(pdf(a), pdf(b), "{name}.pdf");
        assert_eq!(png(a).expect("PNG"), png(b).expect("PNG"), "{name}.png");
    }
}

#[test]
fn the_png_has_its_ink_where_the_scene_has_it() {
    for (name, scene) in figures() {
        let pixmap = tiny_skia::Pixmap::decode_png(&png(scene).expect("PNG")).expect("our PNG");
        let scale = f64::from(pixmap.width()) / scene.width;
        let (mut left, mut top, mut right, mut bottom) = (u32::MAX, u32::MAX, 0, 0);
        for y in 0..pixmap.height() {
            for x in 0..pixmap.width() {
                if pixmap.pixel(x, y).expect("inside").green() < 250 {
                    (left, top) = (left.min(x), top.min(y));
                    (right, bottom) = (right.max(x + 1), bottom.max(y + 1));
                }
            }
        }
        let ink = inked(scene);
        let found = [left, top, right, bottom].map(|pixel| f64::from(pixel) / scale);
        for (found, wanted) in found.into_iter().zip([ink.left, ink.top, ink.right, ink.bottom]) {
            // One pixel is a third of a px; a faint one at an edge may be missing.
            assert!((found - wanted).abs() <= 0.7, "{name}: {found} for {wanted}");
        }
    }
}

#[test]
fn every_label_can_be_read_from_the_svg() {
    for (name, scene) in figures() {
        let text = String::from_utf8(svg(scene)).expect("UTF-8");
        let labels = scene.shapes().iter().filter(|shape| shape.label.is_some()).count();
        assert!(labels >= 8, "{name} has only {labels}");
        assert_eq!(text.matches("aria-label").count(), labels, "{name}");
        assert!(!text.contains("<text"), "{name}");
    }
}
