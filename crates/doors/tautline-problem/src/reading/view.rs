//! `View`: what a file asks to be drawn.

use tautline_picture::portrait::Field;

use crate::{
    Diagnostic,
    file::{ProblemFile, request::FieldFile},
    reading::{numbers::Numbers, pieces::corners},
};

/// What a file asks to be drawn.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct View {
    /// The two coordinates, from 0; `None` to choose them by the curve.
    pub(crate) coordinates: Option<[usize; 2]>,
    pub(crate) field: Field,
    /// The range of each drawn coordinate; `None` to choose it by the curve.
    pub(crate) window: Option<[[f64; 2]; 2]>,
}

/// Reads the section `[output]`.
pub(crate) fn view(
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    dimension: usize,
) -> Result<View, Diagnostic> {
    let output = &problem.output;
    let coordinates = match &output.coordinates {
        None => None,
        Some(chosen) => {
            let [a, b] = *chosen.get_ref();
            let all = 1..=dimension;
            if !all.contains(&a) || !all.contains(&b) || (a == b && dimension > 1) {
                let label = format!("expected two of the coordinates 1 to {dimension}");
                return Err(Diagnostic::new("no such plane", chosen.span()).label(label));
            }
            Some([a - 1, b - 1])
        }
    };
    let field = match output.field {
        FieldFile::Determinant => Field::Determinant,
        FieldFile::Ellipses => Field::Ellipses,
        FieldFile::Plain => Field::Plain,
    };
    let window = match &output.window {
        None => None,
        Some(window) => {
            let [lower, upper] = corners(window, numbers, 2)?;
            if !(lower[0] < upper[0] && lower[1] < upper[1]) {
                return Err(Diagnostic::new("an empty window", window.upper.span())
                    .label("expected larger coordinates than those of lower"));
            }
            Some([[lower[0], upper[0]], [lower[1], upper[1]]])
        }
    };
    Ok(View { coordinates, field, window })
}
