//! An answer as text for a person.

use std::fmt::Write;

use tautline_problem::{
    Answer, Bounds, CertifiedAnswer, ConstantsAnswer, Estimated, GlobalMinimum, UsedConstants,
    decimal::{
        nearest, one_digit_up, places_up, rounded_down, rounded_up, shortly_down, shortly_up, up_to,
    },
};

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
            if let Some(note) = note(bounds, answer.search.converged) {
                line("", note);
            }
        }
        (None, Some(reason)) => line("distance", format!("no bounds: {reason}")),
        (None, None) => {}
    }
    let (rule, chords) = (answer.rule.replace('_', " "), answer.n);
    let Estimated { value, error } = answer.length;
    let mut length = nearest(value);
    if value == 0.0 && error > 0.0 {
        // The ends are in both sets up to rounding only.
        length += &format!(" ± {}", one_digit_up(error));
    }
    line("length", format!("{length} of a curve of {}, {rule} rule", counted(chords)));
    if let [first, .., last] = answer.curve.as_slice() {
        let places = places(&[first, last].map(Vec::as_slice));
        line("", format!("from {} to {}", point(first, places), point(last, places)));
    }
    if let Some(Estimated { value, error }) = answer.extrapolated {
        let printed = nearest(value);
        // What printing rounds off counts as an error too.
        let rounding = printed.parse().map_or(0.0, |printed: f64| (printed - value).abs());
        line(
            "extrapolated",
            format!("{printed} ± {}, an estimate", one_digit_up(error + rounding)),
        );
    }
    let others = &answer.other_minima;
    if let Some(shorter) = others.iter().find(|other| other.is_shorter_than(answer)) {
        let length = nearest(shorter.length.value);
        line(
            "warning",
            format!("another minimum is shorter, {length}, but has more energy by the"),
        );
        line("", format!("rule; use more than {}", counted(chords)));
    } else if !answer.resolved {
        let seen = nearest(answer.discrete_energy.sqrt());
        line(
            "warning",
            "the metric changes between the points of the rule, which sees a".to_owned(),
        );
        line("", format!("length of {seen}; use more than {}", counted(chords)));
    }
    if answer.within_tolerance == Some(false) {
        line("warning", format!("the tolerance is not reached with {}", counted(chords)));
    }
    let search = &answer.search;
    if !search.converged {
        line("warning", "the search did not end at a strict minimum".to_owned());
    }
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
    let (ties, other): (Vec<_>, Vec<_>) = others.iter().partition(|other| other.ties_with(answer));
    match ties.len() {
        0 => {}
        1 => line("tie", "another curve is as short".to_owned()),
        ties => line("tie", format!("{ties} other curves are as short")),
    }
    if !other.is_empty() {
        let lengths = other.iter().map(|other| format!("{:.6}", other.length.value));
        line("other minima", lengths.collect::<Vec<_>>().join(", "));
    }
    text
}

fn counted(chords: usize) -> String {
    if chords == 1 { "1 chord".to_owned() } else { format!("{chords} chords") }
}

/// Returns the number of decimals in which points are printed: six, or more if they are close to
/// the origin.
fn places(points: &[&[f64]]) -> i32 {
    let largest = points.iter().flat_map(|x| x.iter()).fold(0.0_f64, |most, x| most.max(x.abs()));
    if largest > 0.0 && largest < 1e-2 { 6 - largest.log10().floor() as i32 } else { 6 }
}

/// Returns a point to some decimals.
fn point(x: &[f64], places: i32) -> String {
    let coordinate = |x: &f64| {
        // The text rounds where a scale would overflow. Adding 0 turns −0 into 0.
        let x = format!("{x:.*}", places as usize).parse().unwrap_or(*x) + 0.0;
        if x != 0.0 && x.abs() < 1e-5 { format!("{x:e}") } else { x.to_string() }
    };
    format!("[{}]", x.iter().map(coordinate).collect::<Vec<_>>().join(", "))
}

fn interval(bounds: &Bounds) -> String {
    let (lower, upper) = (rounded_down(bounds.lower.value), rounded_up(bounds.upper.value));
    format!("between {lower} and {upper}")
}

/// The last digit of a percentage that is printed.
const SHOWN: f64 = 0.01;

/// Returns what the bounds rest on.
fn note(bounds: &Bounds, converged: bool) -> Option<String> {
    let note = match bounds.global_minimum {
        GlobalMinimum::Proved => return None,
        GlobalMinimum::NotNeeded => {
            let (lower, upper) = (bounds.lower.value, bounds.upper.value);
            // Sets that touch have the distance 0.
            let percent = if upper > lower { 100.0 * (1.0 - lower / upper) } else { 0.0 };
            let (about, is_close) = match &bounds.certificate {
                Some(certificate) => (
                    "the lower bound is that of a certificate, which is about all curves",
                    certificate.reached,
                ),
                None => ("the lower bound holds for all curves", percent < SHOWN),
            };
            if is_close {
                return bounds.certificate.is_some().then(|| about.to_owned());
            }
            return Some(format!("{about}; one shorter by {} % may exist", share(lower, upper)));
        }
        GlobalMinimum::Assumed => {
            "the lower bound assumes that the minimum found is the global one"
        }
        GlobalMinimum::Refuted if bounds.constants.proved || !converged => {
            "the minimum found is not the global one; the lower bound does without it"
        }
        GlobalMinimum::Refuted => {
            "the minimum found is not the global one, or a claimed constant is wrong"
        }
    };
    Some(note.to_owned())
}

/// Returns how much shorter than `upper` something of at least `lower` can be, in percent, rounded up.
fn share(lower: f64, upper: f64) -> String {
    if !(lower > 0.0) {
        return "100.00".to_owned();
    }
    // The quotient and the difference are off by half an ε each, at most, in numbers up to 1; the
    // product by as much in a hundred.
    places_up(100.0 * (1.0 - lower / upper) + 200.0 * f64::EPSILON, 2)
}

/// The number of significant digits of a constant.
const SHORT: usize = 5;

fn constants(constants: &UsedConstants) -> String {
    let UsedConstants { c1, c2, l_h, m_h, proved, within } = constants;
    // A claim is what was typed.
    let down = |x: &f64| if *proved { shortly_down(*x, SHORT) } else { x.to_string() };
    let up = |x: &f64| if *proved { shortly_up(*x, SHORT) } else { x.to_string() };
    let (c1, c2, l_h) = (down(c1), up(c2), up(l_h));
    let m_h = m_h.as_ref().map_or(String::new(), |m_h| format!(", M_H {}", up(m_h)));
    let how = if *proved { "proved" } else { "claimed" };
    let place = match within {
        None => "on all of space".to_owned(),
        Some(ball) => {
            let (centre, radius) = ball.shortened(SHORT);
            let centre: Vec<String> = centre.iter().map(f64::to_string).collect();
            format!("within {radius} of [{}]", centre.join(", "))
        }
    };
    format!("c1 {c1}, c2 {c2}, L_H {l_h}{m_h}; {how} {place}")
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
            // What is known is a constant, though not to the accuracy that was asked for.
            Some(_) if constant.is_known() => {
                writeln!(text, "{name:<5}between {lower} and {upper}   {bounds}; not closer")
            }
            Some(reason) => writeln!(text, "{name:<5}not proved: {reason}"),
        };
    }
    text
}

/// Returns a certified distance as text.
pub(crate) fn certified(answer: &CertifiedAnswer) -> String {
    if answer.upper.value == 0.0 {
        return format!("distance    0: {}\n", answer.ended);
    }
    let (lower, upper) = (rounded_down(answer.lower.value), rounded_up(answer.upper.value));
    let mut text = format!("distance    between {lower} and {upper}, proved\n");
    let cubes: usize = answer.levels.iter().map(|level| level.cubes).sum();
    let (left, side) = (answer.corridor_cubes, answer.corridor_side.value);
    // The gap is a difference and a quotient of doubles.
    let gap = up_to((answer.gap.value * (1.0 + 2.0 * f64::EPSILON)).min(1.0), 2);
    let _ = writeln!(text, "gap         {gap} of the upper bound: {}", answer.ended);
    if answer.levels.is_empty() {
        return text;
    }
    let _ = writeln!(text, "proof       {} levels, {cubes} cubes", answer.levels.len());
    let _ = writeln!(text, "corridor    {left} cubes of side {side:e} hold every shortest curve");
    text
}

#[cfg(test)]
mod tests {
    use tautline_problem::{CertificateAnswer, GlobalMinimum, Question};

    use super::{note, places, point};

    #[test]
    fn a_refuted_minimum_may_be_due_to_a_claim() {
        let file = "[metric]\nphi = 1\n[from]\npoint = [0]\n[to]\npoint = [1]\n";
        let answer = Question::read(file).expect("a problem").solve(&mut |_| ()).expect("a line");
        let mut bounds = answer.bounds.expect("proved");
        assert_eq!(note(&bounds, true), None);
        bounds.global_minimum = GlobalMinimum::Refuted;
        for (proved, converged, is_a_claim) in
            [(true, true, false), (false, true, true), (false, false, false)]
        {
            bounds.constants.proved = proved;
            let note = note(&bounds, converged).expect("a note");
            assert_eq!(note.contains("a claimed constant is wrong"), is_a_claim, "{note}");
        }
    }

    #[test]
    fn a_gap_that_was_not_reached_leaves_room_for_a_shorter_curve() {
        let file = "[metric]\nphi = 1\n[from]\npoint = [0]\n[to]\npoint = [1]\n";
        let answer = Question::read(file).expect("a problem").solve(&mut |_| ()).expect("a line");
        let mut bounds = answer.bounds.expect("proved");
        bounds.global_minimum = GlobalMinimum::NotNeeded;
        (bounds.lower, bounds.upper) = (0.876_541.into(), 1.0.into());
        for reached in [true, false] {
            bounds.certificate = Some(CertificateAnswer { cubes: 9, reached, ended: "it ended" });
            let note = note(&bounds, true).expect("a note");
            assert!(note.contains("all curves"), "{note}");
            assert_eq!(note.contains("one shorter by 12.35 % may exist"), !reached, "{note}");
        }
        bounds.certificate = None;
        let straight = note(&bounds, true).expect("a note");
        assert_eq!(
            straight,
            "the lower bound holds for all curves; one shorter by 12.35 % may exist"
        );
        for (lower, upper) in [(0.0, 0.0), (0.9998, 1.0)] {
            (bounds.lower, bounds.upper) = (lower.into(), upper.into());
            assert_eq!(note(&bounds, true).is_none(), upper == 0.0);
        }
    }

    #[test]
    fn points_are_printed_to_six_decimals_and_tiny_ones_to_as_many_digits() {
        let print = |x: &[f64]| point(x, places(&[x]));
        assert_eq!(print(&[-0.0, 1.0, -1e-17]), "[0, 1, 0]");
        assert_eq!(print(&[0.1 + 0.2, std::f64::consts::PI]), "[0.3, 3.141593]");
        assert_eq!(print(&[-2.5e8, 0.125]), "[-250000000, 0.125]");
        assert_eq!(print(&[3e-308, 0.0]), "[3e-308, 0]");
        assert_eq!(print(&[3e-9, -1.234_567_89e-9, 1e-25]), "[3e-9, -1.234568e-9, 0]");
    }
}
