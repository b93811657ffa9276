//! Opens the page in headless Chromium, uses it as a reader would, and compares what it shows with
//! what the solver returns on this machine.

mod reader;

use std::{fs, path::Path};

use serde_json::Value;

use super::{Built, FILE, build};
use reader::Reader;

/// The length is a quadrature with the functions of the standard library, which are those of the
/// machine: off by a few units of the last place each, over some hundred chords.
const SAME: f64 = 1e-12;

/// Returns the answer of the solver on this machine to what the page asks.
fn native(question: &Value, answer: fn(&str, f64, f64, f64, f64, u32) -> String) -> Value {
    let formula = question[0].as_str().expect("a formula");
    let [x1, x2, y1, y2, chords] = [1, 2, 3, 4, 5].map(|k| question[k].as_f64().expect("a number"));
    let answer = answer(formula, x1, x2, y1, y2, chords as u32);
    let answer: Value = serde_json::from_str(&answer).expect("a document");
    answer["Ok"].clone()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Returns the number at the start of a text of the page.
fn shown(text: &str) -> f64 {
    let word = text.split_whitespace().next().unwrap_or_default();
    word.replace('−', "-").parse().unwrap_or_else(|_| panic!("{text:?} is no number"))
}

/// Compares the curve on the page and the length in words with those of this machine.
fn agrees_with_this_machine(reader: &Reader) {
    let question = reader.json("page.question");
    let (page, here) = (reader.json("page.curve"), native(&question, tautline_page::solve));
    let coordinates = |curve: &Value| -> Vec<f64> {
        let points = curve["points"].as_array().expect("points").iter();
        points.flat_map(|point| [number(&point[0]), number(&point[1])]).collect()
    };
    let (drawn, expected) = (coordinates(&page), coordinates(&here));
    assert_eq!(drawn.len(), expected.len());
    for (a, b) in drawn.iter().zip(&expected) {
        // A search ends where another step would lower the energy by 10⁻¹⁸ of it. Such a step moves
        // the points by the root of that.
        assert!((a - b).abs() <= 1e-9, "{a} {b} of {question}");
    }
    let length = number(&here["length"]);
    assert!((number(&page["length"]) - length).abs() <= SAME * length);
    // Seven digits are shown.
    let text = reader.text("#length");
    let digits = text.split('.').nth(1).map_or(0, str::len);
    assert_eq!(text, format!("{length:.digits$}"), "{question}");
    assert!(text.chars().filter(char::is_ascii_digit).count() >= 7, "{text}");
}

/// Waits for the bounds on the page, and compares them with those of this machine.
fn bounds_agree_with_this_machine(reader: &Reader) {
    let text = reader.wait_for_text("#bound", |text| text.contains('≤'));
    let here = native(&reader.json("page.question"), tautline_page::prove);
    let (lower, upper) = (number(&here["lower"]), number(&here["upper"]));
    let (from, to) = text.split_once(" ≤ d ≤ ").expect("two bounds");
    // Rounded outward to two digits of the distance between them.
    let room = 0.1 * (upper - lower);
    assert!(shown(from) <= lower && lower - shown(from) <= room, "{text}: {lower}");
    assert!(shown(to) >= upper && shown(to) - upper <= room, "{text}: {upper}");
}

#[test]
fn a_reader_drags_types_and_uses_the_keyboard() {
    let folder = tempfile::tempdir().expect("a folder");
    let built = build(folder.path()).expect("built");
    let Built::Written { file, bytes } = built else {
        // Nothing is to be opened, and the guide says so.
        assert!(built.to_string().contains("rustup target add"), "{built}");
        assert!(!folder.path().join(FILE).exists());
        return;
    };
    assert_eq!(fs::metadata(&file).expect("a file").len(), bytes as u64);
    let pictures = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/pictures");
    fs::create_dir_all(&pictures).expect("a folder");

    let reader = Reader::open(&file, 1200, 860);
    agrees_with_this_machine(&reader);
    bounds_agree_with_this_machine(&reader);
    reader.picture(&pictures.join("interactive-before.png"));

    // By the mouse, across the line through B and the top of the hill.
    let (before, curve) = (reader.json("page.question"), reader.json("page.curve.points"));
    reader.drag("#from", (60.0, 95.0));
    let after = reader.json("page.question");
    let per_pixel = number(&reader.json("page.picture.side / page.picture.size"));
    for (place, pixels) in [(1, 60.0), (2, -95.0)] {
        let moved = number(&after[place]) - number(&before[place]);
        // The page rounds to thousandths of the plane.
        assert!((moved - pixels * per_pixel).abs() < 2e-3, "{before} {after}");
    }
    assert_ne!(curve, reader.json("page.curve.points"));
    agrees_with_this_machine(&reader);
    bounds_agree_with_this_machine(&reader);
    reader.picture(&pictures.join("interactive-after.png"));

    // By touch.
    reader.touch_drag("#to", (-30.0, 40.0));
    let touched = reader.json("page.question");
    let moved = number(&touched[3]) - number(&after[3]);
    assert!((moved + 30.0 * per_pixel).abs() < 2e-3, "{after} {touched}");
    agrees_with_this_machine(&reader);

    // By the keyboard: a step is an eightieth of half the side.
    reader.run("document.getElementById('to').focus()");
    reader.press("ArrowLeft");
    reader.press("ArrowUp");
    reader.press("ArrowUp");
    let pressed = reader.json("page.question");
    let step = number(&reader.json("page.half")) / 80.0;
    assert!((number(&touched[3]) - number(&pressed[3]) - step).abs() < 1e-3, "{pressed}");
    assert!((number(&pressed[4]) - number(&touched[4]) - 2.0 * step).abs() < 2e-3, "{pressed}");
    let spoken = reader.attribute("#to", "aria-valuetext");
    assert!(spoken.contains(&pressed[3].to_string()), "{spoken}");
    assert!(spoken.ends_with(&reader.text("#length")), "{spoken}");
    agrees_with_this_machine(&reader);

    // A broken formula, and a whole one.
    reader.type_formula("cost(1 + x1^2 + x3)");
    assert_eq!(reader.text("#complaint p"), "There is no x3 in dimension 2.");
    assert_eq!(reader.text("#complaint mark"), "x3");
    assert_eq!(reader.attribute("#formula", "aria-invalid"), "true");
    reader.picture(&pictures.join("interactive-broken.png"));
    reader.type_formula("cost(1 + x1^2)");
    assert_eq!(reader.text("#complaint"), "");
    agrees_with_this_machine(&reader);

    assert_eq!(reader.troubles(), Vec::<String>::new());
}

#[test]
fn every_example_computes_within_a_frame_and_fits_a_telephone() {
    let folder = tempfile::tempdir().expect("a folder");
    let Built::Written { file, .. } = build(folder.path()).expect("built") else { return };
    let pictures = Path::new(env!("CARGO_MANIFEST_DIR")).join("target/pictures");
    fs::create_dir_all(&pictures).expect("a folder");
    let reader = Reader::open(&file, 360, 800);
    let count = reader.json("EXAMPLES.length").as_u64().expect("a number");
    assert_eq!(count, 5);
    for example in 0..count {
        reader.run(&format!(
            "document.getElementById('example').selectedIndex = {example}; page.choose(EXAMPLES[{example}])"
        ));
        agrees_with_this_machine(&reader);
        let text = reader.wait_for_text("#status", |text| text.contains("bound"));
        let median = number(&reader.json(MEDIAN_OF_A_DRAG));
        println!("{example}: {median:.2} ms a solve, {text}");
        assert!(median < 16.0, "{median} ms with 64 chords");
        assert_eq!(reader.json("document.documentElement.scrollWidth"), 360);
        reader.picture(&pictures.join(format!("interactive-narrow-{example}.png")));
    }
    for text in ["", "I", "1 I)", "½ I", "-1 I", "1e999 I", "(x1 - 0.3) I", "ln(x1) I", "1/x1 I"] {
        answers_in_words(&reader, &format!("{text:?}"));
    }
    // Deeper and longer than anyone types.
    for text in ["'('.repeat(1e5)", "'-'.repeat(1e5)", "'x1+'.repeat(1e3) + '9 I'"] {
        answers_in_words(&reader, text);
    }
    assert_eq!(reader.troubles(), Vec::<String>::new());
}

/// Asks all three questions about the formula that this expression of JavaScript is.
fn answers_in_words(reader: &Reader, text: &str) {
    for ask in
        ["solve(it, 0, 0, 1, 1, 64)", "prove(it, 0, 0, 1, 1, 8)", "background(it, -1, 1, -1, 1)"]
    {
        let answer = reader.json(&format!("((it) => JSON.parse(wasm_bindgen.{ask}))({text})"));
        let has_answer = answer["Ok"].is_object() || answer["Err"]["message"].is_string();
        assert!(has_answer, "{ask} of {text}: {answer}");
    }
}

/// The median time of a solve with 64 chords, its document read included, on a way of the first end.
const MEDIAN_OF_A_DRAG: &str = "(() => {
    const times = [];
    for (let k = 0; k < 101; k++) {
        const [formula, x1, x2, ...rest] = page.question;
        const start = performance.now();
        JSON.parse(wasm_bindgen.solve(formula, x1 + k / 200, x2 + k / 300, rest[0], rest[1], 64));
        times.push(performance.now() - start);
    }
    return times.sort((a, b) => a - b)[50];
})()";
