//! The solver behind the functions that an interactive page calls.
//!
//! The page is written in JavaScript and knows no mathematics. It passes the text of a metric on the
//! plane and two points, and receives one JSON document: `{"Ok": …}` or `{"Err": …}`, the
//! serialised [`Curve`], [`Bound`] or [`Background`], or the [`Complaint`]. This crate has no
//! mathematics of its own either: what it returns, the other crates compute.
//!
//! ```
//! let answer = tautline_page::solve("(2 - cos(x1))^2 I", 0.0, 0.0, 3.0, 0.0, 64);
//! assert!(answer.starts_with(r#"{"Ok":{"points":[[0.0,0.0],"#));
//! let answer = tautline_page::solve("(2 - cos(x3))^2 I", 0.0, 0.0, 3.0, 0.0, 64);
//! assert!(answer.starts_with(r#"{"Err":{"message":"there is no x3 in dimension 2","start":9,"#));
//! ```

mod background;
mod bound;
mod complaint;
mod curve;
mod question;

use serde::Serialize;
use wasm_bindgen::prelude::wasm_bindgen;

pub use background::{Background, Band, View};
pub use bound::Bound;
pub use complaint::Complaint;
pub use curve::{Curve, Other};
pub use question::Question;

/// Returns the shortest curve found from `(x1, x2)` to `(y1, y2)` with this many chords, as the JSON
/// text of a [`Curve`] or a [`Complaint`].
#[wasm_bindgen]
#[must_use]
pub fn solve(formula: &str, x1: f64, x2: f64, y1: f64, y2: f64, chords: u32) -> String {
    json(Question::new(formula, [x1, x2], [y1, y2], chords).and_then(|it| Curve::new(&it)))
}

/// Returns bounds on the distance from `(x1, x2)` to `(y1, y2)`, as the JSON text of a [`Bound`] or
/// a [`Complaint`]. The lower bound belongs to the curve that [`solve`] returns.
#[wasm_bindgen]
#[must_use]
pub fn prove(formula: &str, x1: f64, x2: f64, y1: f64, y2: f64, chords: u32) -> String {
    json(Question::new(formula, [x1, x2], [y1, y2], chords).and_then(|it| Bound::new(&it)))
}

/// Returns the contour bands of a metric in the rectangle `[left, right] × [bottom, top]`, as the
/// JSON text of a [`Background`] or a [`Complaint`].
#[wasm_bindgen]
#[must_use]
pub fn background(formula: &str, left: f64, right: f64, bottom: f64, top: f64) -> String {
    json(Background::new(formula, View { x: (left, right), y: (bottom, top) }))
}

/// Numbers that are not finite become `null`.
fn json<T: Serialize>(answer: Result<T, Complaint>) -> String {
    serde_json::to_string(&answer).expect("no map in these types has a key that is not a text")
}
