//! An answer as text for a person.

use std::fmt::Write;

use tautline_problem::{
    Answer, Bounds, ConstantsAnswer, Estimated, GlobalMinimum, OtherMinimum, UsedConstants,
};

use crate::decimal::{nearest, rounded_down, rounded_up};

/// Returns the lines that describe an answer.
pub(crate) fn answer(answer: &Answer) -> String {
    let mut text = String::new();
    let mut line = |name: &str, rest: String| {
        // Writing to a string does not fail.
        let _ = writeln!(text, "{name:<13}{rest}");
    };
    match (&answer.bounds, &answer.no_bounds) {
        (Some(bounds), _) => {
            line("distance", interval(bounds));
            if let Some(note) = note(bounds) {
                line("", note.to_owned());
            }
        }
        (None, Some(reason)) => line("distance", format!("no bounds: {reason}")),
        (None, None) => {}
    }
    let (rule, chords) = (answer.rule.replace('_', " "), answer.n);
    line(
        "length",
        format!("{} of a curve of {}, {rule} rule", nearest(answer.length.value), counted(chords)),
    );
    if let [first, .., last] = answer.curve.as_slice() {
        line("", format!("from {} to {}", point(first), point(last)));
    }
    if let Some(Estimated { value, error }) = answer.extrapolated {
        line("extrapolated", format!("{} ± {error:.0e}, an estimate", nearest(value)));
    }
    if !answer.resolved {
        let seen = nearest(answer.discrete_energy.sqrt());
        line(
            "warning",
            "the metric changes between the points of the rule, which sees a".to_owned(),
        );
        line("", format!("length of {seen}; use more than {}", counted(chords)));
    }
    let search = &answer.search;
    if answer.length.value > 0.0 {
        line("search", format!("{}, Hessian {}", search.stop, search.hessian));
    } else {
        line("search", search.stop.to_owned());
    }
    line(
        "residual",
        format!("{:.1e}; rounding alone {:.1e}", search.residual, search.residual_floor),
    );
    if let Some(bounds) = &answer.bounds {
        line("constants", constants(&bounds.constants));
    }
    let (ties, longer): (Vec<_>, Vec<_>) = answer
        .other_minima
        .iter()
        .map(|OtherMinimum { length, .. }| length.value)
        .partition(|length| *length < answer.length.value * (1.0 + TIE));
    match ties.len() {
        0 => {}
        1 => line("tie", "another curve is as short".to_owned()),
        ties => line("tie", format!("{ties} other curves are as short")),
    }
    if !longer.is_empty() {
        let longer: Vec<String> = longer.iter().map(|length| format!("{length:.6}")).collect();
        line("other minima", longer.join(", "));
    }
    text
}

fn counted(chords: usize) -> String {
    if chords == 1 { "1 chord".to_owned() } else { format!("{chords} chords") }
}

/// Returns a point to six decimals.
fn point(x: &[f64]) -> String {
    // Adding 0 turns −0 into 0.
    let coordinates = x.iter().map(|x| ((x * 1e6).round() / 1e6 + 0.0).to_string());
    format!("[{}]", coordinates.collect::<Vec<_>>().join(", "))
}

fn interval(bounds: &Bounds) -> String {
    let (lower, upper) = (rounded_down(bounds.lower.value), rounded_up(bounds.upper.value));
    format!("between {lower} and {upper}")
}

/// Curves that are longer by less than this fraction count as equally short: on a coarser grid they
/// are a little longer.
const TIE: f64 = 1e-5;

/// Returns what the bounds rest on.
fn note(bounds: &Bounds) -> Option<&'static str> {
    match bounds.global_minimum {
        GlobalMinimum::Proved => None,
        GlobalMinimum::Assumed => {
            Some("the lower bound assumes that the minimum found is the global one")
        }
        GlobalMinimum::Refuted => {
            Some("the minimum found is not the global one: a shorter curve may exist")
        }
    }
}

fn constants(constants: &UsedConstants) -> String {
    let UsedConstants { c1, c2, l_h, m_h, proved, within } = constants;
    let m_h = m_h.map_or(String::new(), |m_h| format!(", M_H {m_h:.4}"));
    let how = if *proved { "proved" } else { "claimed" };
    let place = match within {
        None => "on all of space".to_owned(),
        Some(ball) => format!("within {:.4} of {:.4?}", ball.radius, ball.centre),
    };
    format!("c1 {c1:.4}, c2 {c2:.4}, L_H {l_h:.4}{m_h}; {how} {place}")
}

/// Returns the lines that describe proved constants.
pub(crate) fn proved_constants(answer: &ConstantsAnswer) -> String {
    let mut text = format!("constants on {}\n", answer.region);
    for constant in &answer.constants {
        let bound = |bound: &Option<tautline_problem::Float>, round: fn(f64) -> String, none| {
            bound.as_ref().map_or(String::from(none), |float| round(float.value))
        };
        let (lower, upper) =
            (bound(&constant.lower, rounded_down, "-∞"), bound(&constant.upper, rounded_up, "∞"));
        let (name, bounds) = (&constant.name, constant.bounds);
        let _ = match &constant.reason {
            None => writeln!(text, "{name:<5}between {lower} and {upper}   {bounds}"),
            Some(reason) => writeln!(text, "{name:<5}not proved: {reason}"),
        };
    }
    text
}
