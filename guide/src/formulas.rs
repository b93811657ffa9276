//! Turns `$…$` and `$$…$$` into MathML while the guide is built.

use math_core::{
    LatexToMathML, MathCoreConfig,
    MathDisplay::{self, Block, Inline},
};
use mdbook_preprocessor::{Preprocessor, PreprocessorContext, book::Book, errors::Result};
use pulldown_cmark::{Event, Options, Parser};

use crate::page;

/// The preprocessor.
pub(crate) struct Formulas;

impl Preprocessor for Formulas {
    fn name(&self) -> &str {
        "formulas"
    }

    fn run(&self, _: &PreprocessorContext, book: Book) -> Result<Book> {
        page::each_page(book, with_mathml)
    }
}

/// Returns the page with MathML in place of its formulas, or where a formula cannot be read, and
/// why.
fn with_mathml(text: &str) -> Result<String, (usize, String)> {
    // Tables, since a formula ends at the end of its cell.
    let options = Options::ENABLE_MATH | Options::ENABLE_TABLES | Options::ENABLE_FOOTNOTES;
    let converter = LatexToMathML::new(MathCoreConfig::default());
    let converter = converter.map_err(|error| (0, format!("{error:?}")))?;
    let mut edits = Vec::new();
    for (event, range) in Parser::new_ext(text, options).into_offset_iter() {
        let mathml = match event {
            Event::InlineMath(latex) => mathml(&converter, &latex, Inline),
            Event::DisplayMath(latex) => mathml(&converter, &latex, Block),
            _ => continue,
        };
        let mathml = mathml.map_err(|why| (range.start, why))?;
        edits.push((range, mathml));
    }
    Ok(page::replaced(text, edits))
}

/// Returns the MathML of a formula, to be put into Markdown, or why there is none.
fn mathml(converter: &LatexToMathML, latex: &str, display: MathDisplay) -> Result<String, String> {
    let converted = converter.convert_with_local_state(latex, display);
    let converted = converted.map_err(|error| format!("`{latex}`: {error}"))?;
    Ok(verbatim(&converted.mathml))
}

/// Writes punctuation between the tags as numbers of characters: Markdown would take `*`, `_` or
/// `|` for its own.
fn verbatim(mathml: &str) -> String {
    let mut result = String::with_capacity(mathml.len());
    let (mut in_tag, mut in_entity) = (false, false);
    for c in mathml.chars() {
        match c {
            '<' => in_tag = true,
            '&' if !in_tag => in_entity = true,
            _ => {}
        }
        if c == '\n' {
            result.push(' ');
        } else if c.is_ascii_punctuation() && !in_tag && !in_entity {
            result.push_str(&format!("&#{};", u32::from(c)));
        } else {
            result.push(c);
        }
        match c {
            '>' => in_tag = false,
            ';' => in_entity = false,
            _ => {}
        }
    }
    result
}

#[cfg(test)]
mod tests {
    use super::{verbatim, with_mathml};

    /// All that the guide writes: fractions, roots, integrals, matrices, Greek, dots, bold, hats.
    #[test]
    fn what_the_guide_writes_is_understood() {
        let formulas = [
            (r"E(\gamma) = \int_0^1 \dot\gamma^\top H(\gamma)\,\dot\gamma \,dt", "∫"),
            (r"\frac{k\,\delta}{2N}", "<mfrac>"),
            (r"\sqrt{(\mu_1 - \mu_2)^2}", "<msqrt>"),
            (r"\begin{pmatrix} 1 & k \\ k & 1 + k^2 \end{pmatrix}", "<mtable"),
            (r"\ddot\gamma", "<mover"),
            (r"\hat\mu + \bar d + \tilde x", "<mover"),
            (r"\mathbf{R}^D \ni x", "<msup>"),
            (r"d^2 \le L(\gamma^{\mathrm{pl}})^2 \le E", "≤"),
            (r"\lVert\beta_n\rVert \cdot \lvert x \rvert", "‖"),
            (r"\sum_{n=0}^{N-1} \beta_n^\top H\left(\tfrac{x_n+x_{n+1}}{2}\right) \beta_n", "∑"),
            (r"c_1 I \preceq H(x) \preceq c_2 I,\quad \nabla u \approx 0", "⪯"),
            (r"\begin{aligned} a &= b \\ &= c \end{aligned}", "<mtable"),
            (r"\begin{cases} 1 & x > 0 \\ 0 & \text{otherwise} \end{cases}", "<mtable"),
            (r"\operatorname{arg\,min}_{x \in X} f(x) \propto N^{-1/2}", "<msup>"),
        ];
        for (latex, part) in formulas {
            for text in [format!("${latex}$"), format!("$${latex}$$")] {
                let mathml = with_mathml(&text).expect(latex);
                assert!(mathml.starts_with("<math") && mathml.contains(part), "{latex}: {mathml}");
            }
        }
    }

    #[test]
    fn code_and_escaped_dollars_are_left_alone() {
        let text = "Costs \\$5 and `$x$`.\n\n```console\n$ tautline solve\n```\n";
        assert_eq!(with_mathml(text).as_deref(), Ok(text));
    }

    #[test]
    fn markdown_does_not_read_a_formula() {
        let text = verbatim("<mi mathvariant=\"normal\">a*b_c|d&lt;e</mi>");
        assert_eq!(text, "<mi mathvariant=\"normal\">a&#42;b&#95;c&#124;d&lt;e</mi>");
    }

    #[test]
    fn an_error_has_its_place() {
        let (at, why) = with_mathml("one $x$\n\ntwo $\\nonsense$").expect_err("no such command");
        assert_eq!(at, 13);
        assert!(why.contains("nonsense"), "{why}");
    }
}
