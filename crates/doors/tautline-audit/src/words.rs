//! The sentences of a report, which its formats share.

use tautline_problem::{
    IF_IT_SETTLES, UsedConstants,
    decimal::{shortly_down, shortly_up},
};

use crate::{
    answer::{Audit, Lie, Status, Verdict},
    lies::METRIC,
};

/// The significant digits of a number that is claimed or found.
pub(crate) const DIGITS: usize = 10;

/// The significant digits of a coordinate.
const COORDINATE_DIGITS: usize = 6;

/// Returns a number in the fewest digits, at most ten.
pub(crate) fn number(x: f64) -> String {
    rounded(x, DIGITS)
}

fn rounded(x: f64, digits: usize) -> String {
    let text = format!("{x:.*e}", digits - 1);
    let nearest: f64 = text.parse().unwrap_or(x);
    let is_readable = nearest == 0.0 || (1e-4..1e7).contains(&nearest.abs());
    if is_readable { nearest.to_string() } else { format!("{nearest:e}") }
}

/// Returns a point or a direction.
pub(crate) fn vector(x: &[f64]) -> String {
    let coordinates = x.iter().map(|x| rounded(*x, COORDINATE_DIGITS));
    format!("({})", coordinates.collect::<Vec<_>>().join(", "))
}

/// Returns the verdict in a sentence.
pub(crate) fn verdict(audit: &Audit) -> String {
    let what = match audit.verdict {
        Verdict::Holds => "All laws hold".to_owned(),
        Verdict::Lies => {
            let mut about: Vec<&str> = audit.lies.iter().map(|lie| lie.about).collect();
            about.dedup();
            if about.first() == Some(&METRIC) {
                "The formula is not a metric".to_owned()
            } else {
                format!("A claim is false: {}", about.join(", "))
            }
        }
        Verdict::Fails => "Laws fail, although no claim is known to be false".to_owned(),
        Verdict::Incomplete => "No law fails, but not all were tried".to_owned(),
    };
    let counts = [
        (Status::Holds, "held"),
        (Status::Fails, "failed"),
        (Status::FalseHypothesis, "rested on a false claim"),
        (Status::NotTried, "not tried"),
        (Status::DoesNotApply, "not about this metric"),
    ];
    let counts = counts.map(|(status, word)| (audit.count(status), word));
    let counts = counts.iter().filter(|(count, _)| *count > 0);
    let counts: Vec<String> = counts.map(|(count, word)| format!("{count} {word}")).collect();
    format!("{what}. Of {} laws: {}.", audit.laws.len(), counts.join(", "))
}

/// Returns a false claim in a sentence with both numbers and the place.
pub(crate) fn lie(lie: &Lie) -> String {
    let Lie { about, claim, claimed, found, formula, point, direction, other } = lie;
    let is_a_constant = *about != METRIC;
    let mut text = if is_a_constant {
        format!("{claim} is claimed, but {formula}")
    } else {
        format!("H is not a metric: {formula}")
    };
    match (found, point) {
        (Some(found), None) => {
            let (side, bound) = if *about == "c1" {
                ("at most", shortly_up(*found, DIGITS))
            } else {
                ("at least", shortly_down(*found, DIGITS))
            };
            text += &format!(" is proved to reach {side} {bound} somewhere");
        }
        (Some(found), Some(_)) => text += &format!(" = {}", number(*found)),
        (None, _) if is_a_constant => text += " is infinite",
        (None, _) => {}
    }
    if let Some(point) = point {
        text += &format!(" at x = {}", vector(point));
    }
    match (other, direction) {
        (Some(other), _) => text += &format!(" and y = {}", vector(other)),
        (None, Some(direction)) => text += &format!(" in the direction w = {}", vector(direction)),
        (None, None) => {}
    }
    text + &match (claimed, found) {
        (Some(claimed), Some(found)) if is_a_constant => off_by(about, *claimed, *found),
        (Some(_), Some(_)) => format!("; {claim} must hold"),
        (None, None) => "; name a region without this point in [audit], or mend the formula".into(),
        _ => String::new(),
    }
}

/// Returns by how much a claimed constant is wrong.
fn off_by(about: &str, claimed: f64, found: f64) -> String {
    let percent = |ratio: f64| rounded(100.0 * ratio, 2);
    match about {
        "c1" if found > 0.0 => format!("; {} % too large", percent(claimed / found - 1.0)),
        "c2" | "L_H" | "M_H" => format!("; {} % too small", percent(1.0 - claimed / found)),
        _ => String::new(),
    }
}

/// Returns the constants that the laws use, or why there are none.
pub(crate) fn constants(audit: &Audit) -> String {
    let Some(UsedConstants { c1, c2, l_h, m_h, proved, within, if_it_settles }) = &audit.constants
    else {
        let why = audit.no_constants.as_deref().unwrap_or("time ran out");
        return format!("none: {why}");
    };
    // A claim is what was typed.
    let down = |x: &f64| if *proved { shortly_down(*x, DIGITS) } else { number(*x) };
    let up = |x: &f64| if *proved { shortly_up(*x, DIGITS) } else { number(*x) };
    let m_h = m_h.as_ref().map_or(String::new(), |m_h| format!(", M_H = {}", up(m_h)));
    let how = if *proved { "proved" } else { "claimed" };
    let place = match within {
        None if *if_it_settles => format!("on all of space, {IF_IT_SETTLES}"),
        None => "on all of space".to_owned(),
        Some(ball) => {
            let (centre, radius) = ball.shortened(DIGITS);
            let centre: Vec<String> = centre.iter().map(f64::to_string).collect();
            format!("in the ball of radius {radius} about ({})", centre.join(", "))
        }
    };
    let (c1, c2, l_h) = (down(c1), up(c2), up(l_h));
    format!("c1 = {c1}, c2 = {c2}, L_H = {l_h}{m_h}; {how} {place}")
}

/// Returns where and how samples are drawn.
pub(crate) fn samples(audit: &Audit) -> String {
    let Audit { cases, seed, region, .. } = audit;
    let (lower, upper) = (vector(&region.lower), vector(&region.upper));
    format!("{cases} for each law, seed {seed}, from the box {lower} to {upper}: {}", region.why)
}

/// Returns the laws that are not tried or do not apply, by their reasons.
pub(crate) fn untried(audit: &Audit, status: Status) -> Vec<(&str, Vec<&str>)> {
    let mut reasons: Vec<(&str, Vec<&str>)> = Vec::new();
    for law in audit.laws.iter().filter(|law| law.status == status) {
        let reason = law.reason.as_deref().unwrap_or_default();
        match reasons.iter_mut().find(|(other, _)| *other == reason) {
            Some((_, laws)) => laws.push(law.law),
            None => reasons.push((reason, vec![law.law])),
        }
    }
    reasons
}

/// Returns an overestimation, or a dash if nothing came near the bound.
pub(crate) fn overestimation(found: Option<f64>) -> String {
    match found {
        None => "-".to_owned(),
        Some(found) if found < 1e4 => format!("{found:.4}"),
        Some(found) => format!("{found:.1e}"),
    }
}
