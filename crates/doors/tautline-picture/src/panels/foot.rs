//! Remarks below the panels of a figure.

use crate::{
    colours::palette::INK,
    error::DrawingError,
    math_text::{Align, TextBlock, typeset},
    measures::SMALL,
    picture::Scene,
};

/// Remarks, broken into lines.
pub(crate) struct Foot {
    lines: Vec<TextBlock>,
}

/// Distance from the panels to the first line, and between baselines, in px.
const ABOVE: f64 = 4.0;
const LEADING: f64 = 1.35 * SMALL;

impl Foot {
    /// Breaks each remark at its spaces outside of formulas, into lines that are at most `width` px
    /// wide if possible.
    pub(crate) fn of_remarks(remarks: &[String], width: f64) -> Result<Foot, DrawingError> {
        let mut lines = Vec::new();
        for remark in remarks {
            let mut line = String::new();
            for word in words(remark) {
                let longer = if line.is_empty() { word.clone() } else { format!("{line} {word}") };
                if !line.is_empty() && set(&longer)?.extent.width() > width {
                    lines.push(set(&line)?);
                    line = word;
                } else {
                    line = longer;
                }
            }
            lines.push(set(&line)?);
        }
        Ok(Foot { lines })
    }

    /// Returns the height, in px, including the space above.
    pub(crate) fn height(&self) -> f64 {
        if self.lines.is_empty() { 0.0 } else { ABOVE + LEADING * self.lines.len() as f64 }
    }

    /// Writes the lines below `top`.
    pub(crate) fn draw(&self, scene: &mut Scene, (left, top): (f64, f64)) {
        for (k, line) in self.lines.iter().enumerate() {
            // A line extends 0.3 em below its baseline at most.
            let baseline = top + ABOVE + (k as f64 + 1.0) * LEADING - 0.3 * SMALL - 2.0;
            scene.write(line, (left, baseline), INK);
        }
    }
}

/// Splits a remark at its spaces, except those inside a formula.
fn words(remark: &str) -> Vec<String> {
    let mut words: Vec<String> = Vec::new();
    let mut inside = false;
    for part in remark.split_whitespace() {
        match words.last_mut() {
            Some(word) if inside => *word += &format!(" {part}"),
            _ => words.push(part.to_owned()),
        }
        inside ^= part.matches('$').count() % 2 == 1;
    }
    words
}

fn set(line: &str) -> Result<TextBlock, DrawingError> {
    typeset(line, SMALL, Align::Left)
}

#[cfg(test)]
mod tests {
    use super::{Foot, Scene, words};

    #[test]
    fn formulas_are_not_broken() {
        let remark = "Here $a + b = c$, and there it is not.";
        assert_eq!(words(remark)[..2], ["Here", "$a + b = c$,"]);
        assert!(Foot::of_remarks(&[remark.to_owned()], 1.0).is_ok());
    }

    #[test]
    fn long_remarks_are_broken_and_do_not_overlap() {
        let remarks = ["Hatched: $H$ is not defined there.", "Not drawn: a set that covers all."];
        let foot = Foot::of_remarks(&remarks.map(str::to_owned), 120.0).expect("ASCII");
        assert!(foot.lines.len() >= 4 && foot.lines.iter().all(|l| l.extent.width() <= 120.0));
        let mut scene = Scene::new(120.0, foot.height() + 10.0, "test");
        foot.draw(&mut scene, (0.0, 5.0));
        assert_eq!(scene.check_labels(), Ok(()));
        assert_eq!(Foot::of_remarks(&[], 120.0).expect("nothing").height(), 0.0);
    }
}
