//! What was probably meant by a word that is not known.

/// The least similarity of two words of which one may be a slip of the pen, from 0 to 1.
const ALIKE: f64 = 0.6;

/// Returns the known word that is most like this one, if one is.
///
/// ```
/// use tautline_formula::probably_meant;
///
/// assert_eq!(probably_meant("raduis", ["centre", "radius"]), Some("radius"));
/// assert_eq!(probably_meant("x", ["centre", "radius"]), None);
/// ```
#[must_use]
pub fn probably_meant<'w>(word: &str, known: impl IntoIterator<Item = &'w str>) -> Option<&'w str> {
    let likeness = |other: &str| strsim::normalized_damerau_levenshtein(word, other);
    let alike = known.into_iter().map(|other| (likeness(other), other));
    let best = alike.fold(None, |best: Option<(f64, &str)>, (likeness, other)| match best {
        Some((most, _)) if most >= likeness => best,
        _ => Some((likeness, other)),
    });
    best.filter(|&(likeness, _)| likeness >= ALIKE).map(|(_, other)| other)
}

#[cfg(test)]
mod tests {
    use super::probably_meant;

    #[test]
    fn a_slip_of_the_pen_is_recognised() {
        let known = ["trapezoidal", "left_endpoint", "ball", "box"];
        for (word, meant) in [
            ("trapezodial", Some("trapezoidal")),
            ("left_end_point", Some("left_endpoint")),
            ("bal", Some("ball")),
            ("simpson", None),
        ] {
            assert_eq!(probably_meant(word, known), meant, "{word}");
        }
    }
}
