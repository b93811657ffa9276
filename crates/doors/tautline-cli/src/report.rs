//! An answer as text for a person.

use std::fmt::Write;

use tautline_problem::{
    Answer, Bounds, CertifiedAnswer, ConstantsAnswer, Estimated, GlobalMinimum, IF_IT_SETTLES,
    UsedConstants,
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
        line("", format!("from {} to {}", point(first), point(last)));
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
    for doubt in &answer.doubts {
        let mut name = "warning";
        for part in wrapped(&doubt.text) {
            line(std::mem::take(&mut name), part);
        }
    }
    let (search, others) = (&answer.search, &answer.other_minima);
    if answer.length.value > 0.0 {
        line("search", format!("{}, Hessian {}", search.stop, search.hessian));
    } else {
        line("search", search.stop.to_owned());
    }
    line(
        "residual",
        format!("{:.1e}; rounding alone {:.1e}", search.residual, search.residual_floor),
    );
    if let Some(used) = answer.bounds.as_ref().and_then(|bounds| bounds.constants.as_ref()) {
        line("constants", constants(used));
    }
    let (ties, other): (Vec<_>, Vec<_>) = others.iter().partition(|other| other.ties_with(answer));
    match ties.len() {
        0 => {}
        1 => line("tie", "another curve is as short".to_owned()),
        ties => line("tie", format!("{ties} other curves are as short")),
    }
    if !other.is_empty() {
        let lengths = other.iter().map(|other| nearest(other.length.value));
        line("other minima", lengths.collect::<Vec<_>>().join(", "));
    }
    text
}

/// The width of a warning, beside its name.
const WIDTH: usize = 67;

/// Breaks a sentence into lines.
fn wrapped(text: &str) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if line.len() + 1 + word.len() <= WIDTH => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_owned()),
        }
    }
    lines
}

fn counted(chords: usize) -> String {
    if chords == 1 { "1 chord".to_owned() } else { format!("{chords} chords") }
}

/// The most digits of a coordinate that is printed as it is, since somebody typed it.
const TYPED: usize = 12;

/// Coordinates that are smaller than the largest one by this factor are rounding.
const ROUNDING: f64 = 1e-13;

/// Returns a point: coordinates of few digits as they are, others to six decimals, and tiny ones to seven
/// digits.
fn point(x: &[f64]) -> String {
    let largest = x.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let coordinate = |&x: &f64| {
        if x.abs() <= ROUNDING * largest {
            return "0".to_owned();
        }
        let typed = format!("{x:e}");
        let digits = typed.split('e').next().unwrap_or_default();
        let is_typed = digits.chars().filter(char::is_ascii_digit).count() <= TYPED;
        let decimals = if x.abs() < 1e-2 { 6 - x.abs().log10().floor() as i32 } else { 6 } as usize;
        // The text rounds where a scale would overflow.
        let x: f64 = if is_typed { x } else { format!("{x:.decimals$}").parse().unwrap_or(x) };
        if x.abs() < 1e-5 { format!("{x:e}") } else { x.to_string() }
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
    let note = about_the_minimum(bounds, converged).unwrap_or_default() + bounds.left_open();
    let note = note.trim_start_matches("; ");
    (!note.is_empty()).then(|| note.to_owned())
}

/// Returns what the lower bound has to do with the minimum that was found.
fn about_the_minimum(bounds: &Bounds, converged: bool) -> Option<String> {
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
        GlobalMinimum::Refuted if !bounds.rests_on_claims() || !converged => {
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
    let UsedConstants { c1, c2, l_h, m_h, proved, within, if_it_settles } = constants;
    // A claim is what was typed.
    let down = |x: &f64| if *proved { shortly_down(*x, SHORT) } else { x.to_string() };
    let up = |x: &f64| if *proved { shortly_up(*x, SHORT) } else { x.to_string() };
    let (c1, c2, l_h) = (down(c1), up(c2), up(l_h));
    let m_h = m_h.as_ref().map_or(String::new(), |m_h| format!(", M_H {}", up(m_h)));
    let how = if *proved { "proved" } else { "claimed" };
    let place = match within {
        None if *if_it_settles => format!("on all of space, {IF_IT_SETTLES}"),
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
    if let Some(note) = &answer.note {
        let _ = writeln!(text, "note        {note}");
    }
    let _ = writeln!(text, "proof       {} levels, {cubes} cubes", answer.levels.len());
    let _ = writeln!(text, "corridor    {left} cubes of side {side:e} hold every shortest curve");
    text
}

#[cfg(test)]
mod tests {
    use tautline_problem::{
        Answer, BallAnswer, CertificateAnswer, CertifiedAnswer, ConstantAnswer, ConstantsAnswer,
        Doubt, DoubtAnswer, Estimated, Float, GlobalMinimum, LevelAnswer, OtherMinimum, Question,
        UsedConstants,
    };

    use super::{answer, certified, constants, note, point, proved_constants};

    /// The answer to a problem of length 1.
    fn unit() -> Answer {
        let file = "[metric]\nphi = 1\n[from]\npoint = [0]\n[to]\npoint = [1]\n";
        Question::read(file).expect("a problem").solve(&mut |_| ()).expect("a line")
    }

    /// Returns what stands after a name, on its first line.
    fn said(text: &str, name: &str) -> Option<String> {
        let line = text.lines().find(|line| line.starts_with(name))?;
        Some(line[name.len()..].trim_start().to_owned())
    }

    /// The value is printed to ten digits: what that rounds off, 4·10⁻¹¹ here, is added to the error.
    #[test]
    fn an_estimate_is_printed_with_its_error_and_that_of_printing() {
        for (value, error, least, most) in [
            (1.000_000_000_04, 1e-12, 4.1e-11, 5e-11),
            (1.0, 1.5e-3, 1.5e-3, 2e-3),
            (2.0, 0.0, 0.0, 0.0),
        ] {
            let extrapolated = Some(Estimated { value, error });
            let text = answer(&Answer { extrapolated, ..unit() });
            let line = said(&text, "extrapolated").expect("an estimate");
            let printed = line.split_once(" ± ").expect("an error").1;
            let printed: f64 = printed.split(',').next().unwrap_or_default().parse().expect("one");
            // The decimals are those of the doubles up to rounding.
            assert!(printed >= least * (1.0 - 1e-5) && printed <= most * (1.0 + 1e-5), "{line}");
        }
        assert_eq!(said(&answer(&Answer { extrapolated: None, ..unit() }), "extrapolated"), None);
    }

    #[test]
    fn each_doubt_has_a_warning_of_its_own() {
        let warnings = |change: &dyn Fn(&mut Answer)| {
            let mut changed = unit();
            change(&mut changed);
            let text = answer(&changed);
            (text.lines().filter(|line| line.starts_with("warning")).count(), text)
        };
        assert_eq!(warnings(&|_| ()).0, 0);
        let other = |length: f64| {
            let length = Estimated { value: length, error: 0.0 };
            OtherMinimum { length, curve: Vec::new() }
        };
        for kind in Doubt::KEYS {
            let text = format!("of {kind} ").repeat(9);
            let doubt = DoubtAnswer { kind, text: text.trim_end().to_owned() };
            let (count, printed) = warnings(&|answer| answer.doubts = vec![doubt.clone()]);
            let words: Vec<_> = printed.split_whitespace().filter(|word| *word == kind).collect();
            assert!(count == 1 && words.len() == 9, "{printed}");
            assert!(printed.lines().all(|line| line.len() <= 80), "{printed}");
        }
        // Two ties, and one that is longer.
        let (count, text) =
            warnings(&|answer| answer.other_minima = [1.0, 1.0, 1.25].map(other).to_vec());
        assert!(count == 0 && text.contains("2 other curves are as short"), "{text}");
        // To as many digits as all lengths: these differ in the eighth, and a tiny one is not 0.
        let close = [1.0, 1.250_000_3, 1.250_000_4, 1.25e9].map(other);
        let (_, text) = warnings(&|answer| answer.other_minima = close.to_vec());
        let printed = "1.250000300, 1.250000400, 1250000000";
        assert_eq!(said(&text, "other minima").as_deref(), Some(printed));
        let (_, text) = warnings(&|answer| {
            answer.length.value = 1e-9;
            answer.other_minima = vec![other(1.25e-9)];
        });
        let tiny = said(&text, "other minima").expect("printed");
        assert!((tiny.parse::<f64>().expect("a number") - 1.25e-9).abs() < 1e-24, "{tiny}");
        let (_, text) = warnings(&|answer| answer.other_minima = vec![other(1.0)]);
        assert!(text.contains("another curve is as short"), "{text}");
        assert_eq!(said(&text, "other minima"), None);
        let (_, text) = warnings(&|answer| {
            (answer.bounds, answer.no_bounds) = (None, Some("why not".to_owned()));
        });
        assert_eq!(said(&text, "distance").as_deref(), Some("no bounds: why not"));
        let (_, text) = warnings(&|answer| answer.length = Estimated { value: 0.0, error: 1.1e-9 });
        assert!(text.contains("length       0 ± 2e-9 of a curve"), "{text}");
    }

    /// A third is no decimal: it is printed smaller as a lower bound and larger as an upper one. A claim is
    /// printed as it was typed.
    #[test]
    fn constants_are_rounded_outwards_if_they_are_proved() {
        let third = 1.0 / 3.0;
        let with = |proved, within| UsedConstants {
            c1: third,
            c2: third,
            l_h: third,
            m_h: Some(third),
            proved,
            within,
            if_it_settles: false,
        };
        assert_eq!(
            constants(&with(true, None)),
            "c1 0.33333, c2 0.33334, L_H 0.33334, M_H 0.33334; proved on all of space"
        );
        let claimed = constants(&with(false, None));
        assert_eq!(claimed.matches("0.3333333333333333").count(), 4, "{claimed}");
        assert!(claimed.ends_with("; claimed on all of space"), "{claimed}");
        let declared = UsedConstants { if_it_settles: true, ..with(true, None) };
        let settled = "proved on all of space, if the metric settles within a distance of 2^100";
        assert!(constants(&declared).ends_with(settled));
        let ball = BallAnswer { centre: vec![0.25, -1.0], radius: third };
        let within = constants(&with(true, Some(ball)));
        assert!(within.ends_with("; proved within 0.33333 of [0.25, -1]"), "{within}");
    }

    #[test]
    fn each_constant_is_printed_with_what_is_known_of_it() {
        let third = || Some(Float::from(1.0 / 3.0));
        let with = |name: &str, lower, upper, reason: Option<&str>| ConstantAnswer {
            name: name.to_owned(),
            bounds: "what it bounds",
            proved: reason.is_none(),
            lower,
            upper,
            at: None,
            reason: reason.map(str::to_owned),
        };
        let text = proved_constants(&ConstantsAnswer {
            region: "a box".to_owned(),
            if_it_settles: false,
            constants: vec![
                with("c1", third(), third(), None),
                with("c2", None, third(), Some("too many boxes")),
                with("L_H", third(), None, Some("it grows")),
                with("M_H", third(), third(), Some("too many boxes")),
            ],
        });
        let between = "between 0.3333333333 and 0.3333333334   what it bounds";
        assert_eq!(text.lines().next(), Some("constants on a box"));
        assert_eq!(said(&text, "c1").as_deref(), Some(between));
        let open = "between -∞ and 0.3333333334   what it bounds; not closer";
        assert_eq!(said(&text, "c2").as_deref(), Some(open));
        assert_eq!(said(&text, "L_H").as_deref(), Some("not proved: it grows"));
        assert_eq!(said(&text, "M_H"), Some(format!("{between}; not closer")));
    }

    #[test]
    fn a_certified_distance_is_printed_outwards_with_its_proof() {
        let level = |cubes: usize| LevelAnswer { cubes, lower: 0.5.into() };
        let (lower, upper) = (1.0 / 3.0, 2.0 / 3.0);
        let found = CertifiedAnswer {
            lower: lower.into(),
            upper: upper.into(),
            gap: ((upper - lower) / upper).into(),
            reached: false,
            ended: "it ended",
            levels: vec![level(30), level(4), level(500)],
            corridor_cubes: 77,
            corridor_side: 0.125.into(),
            note: Some("a word of care".to_owned()),
            certificate: String::new(),
            curve: Vec::new(),
            other_minima: Vec::new(),
            corridor: Vec::new(),
        };
        let text = certified(&found);
        let bounds = "between 0.3333333333 and 0.6666666667, proved";
        assert_eq!(said(&text, "distance").as_deref(), Some(bounds));
        let gap = said(&text, "gap").expect("a gap");
        let printed: f64 = gap.split(' ').next().unwrap_or_default().parse().expect("a number");
        assert!(printed > 0.5 && printed <= 0.52 && gap.ends_with(": it ended"), "{gap}");
        assert_eq!(said(&text, "proof").as_deref(), Some("3 levels, 534 cubes"));
        assert_eq!(said(&text, "note").as_deref(), Some("a word of care"));
        let corridor = said(&text, "corridor").expect("a corridor");
        assert!(corridor.starts_with("77 cubes of side 1.25e-1 hold every"), "{corridor}");
        // Sets that nearly touch have a bound and no proof; those that touch have the distance 0.
        let nearly = CertifiedAnswer { levels: Vec::new(), lower: 0.0.into(), ..found.clone() };
        let text = certified(&nearly);
        assert!(said(&text, "proof").is_none() && said(&text, "corridor").is_none(), "{text}");
        assert!(said(&text, "distance").is_some_and(|it| it.starts_with("between 0 and 0.66")));
        let touching = CertifiedAnswer { upper: 0.0.into(), ..nearly };
        assert_eq!(certified(&touching), "distance    0: it ended\n");
    }

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
            bounds.constants.as_mut().expect("proved").proved = proved;
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
    fn points_are_printed_as_typed_or_to_six_decimals_and_tiny_ones_to_seven_digits() {
        let third = 1.0 / 3.0;
        for (x, printed) in [
            (&[-0.0, 1.0, -1e-17][..], "[0, 1, 0]"),
            (&[0.1 + 0.2, std::f64::consts::PI], "[0.3, 3.141593]"),
            (&[-2.5e8, 0.125], "[-250000000, 0.125]"),
            (&[3e-308, 0.0], "[3e-308, 0]"),
            (&[3e-9, -third * 1e-9, 1e-25], "[3e-9, -3.333333e-10, 0]"),
            (&[1e-8, 0.0, 1.0], "[1e-8, 0, 1]"),
            (&[0.999_999_9, 1e6 * third, 4_200_050.25], "[0.9999999, 333333.333333, 4200050.25]"),
            (&[0.0], "[0]"),
        ] {
            assert_eq!(point(x), printed);
        }
    }
}
