//! Builds the book with mdBook.

use std::{fs, path::Path};

use mdbook_driver::MDBook;
use mdbook_preprocessor::errors::{Error, Result};

use crate::{captions::Captions, formulas::Formulas};

/// The font of the formulas, and its licence.
const FONT: [&str; 3] = ["TautlineFormulas.woff2", "GUST-FONT-LICENSE.txt", "NOTICE.md"];

/// Builds the book whose `book.toml` is in `root` into the folder `output`.
pub(crate) fn build(root: &Path, output: &Path) -> Result<()> {
    let mut book = MDBook::load(root)?;
    book.config.build.build_dir = std::path::absolute(output)?;
    book.with_preprocessor(Captions).with_preprocessor(Formulas);
    book.build()?;
    let to = output.join("font");
    fs::create_dir_all(&to)?;
    for name in FONT {
        fs::copy(root.join("font").join(name), to.join(name))
            .map_err(|error| Error::msg(format!("{name}: {error}")))?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::{fs, path::Path};

    use super::build;

    fn built(pages: &[(&str, &str)]) -> Result<tempfile::TempDir, String> {
        let folder = tempfile::tempdir().expect("a folder");
        let root = folder.path().join("guide");
        let font = root.join("font");
        for folder in [&root.join("pages"), &font] {
            fs::create_dir_all(folder).expect("a folder");
        }
        for name in super::FONT {
            fs::write(font.join(name), "").expect("written");
        }
        let here = Path::new(env!("CARGO_MANIFEST_DIR"));
        for name in ["book.toml", "style.css"] {
            fs::copy(here.join(name), root.join(name)).expect("copied");
        }
        for (name, text) in pages {
            fs::write(root.join("pages").join(name), text).expect("written");
        }
        let done = build(&root, &folder.path().join("out"));
        done.map(|()| folder).map_err(|error| format!("{error:#}"))
    }

    #[test]
    fn a_page_has_its_formulas_and_captions() {
        let text = "# A\n\nFor $x_1 \\le \\frac12$:\n\n```toml,file=a.toml\nx = 1 # $y$\n```\n";
        let folder = built(&[("SUMMARY.md", "[A](a.md)"), ("a.md", text)]).expect("built");
        let page = fs::read_to_string(folder.path().join("out/a.html")).expect("a page");
        assert!(page.contains("<mfrac>") && page.contains("<msub>"), "{page}");
        assert!(page.contains("<div class=\"caption\">a.toml</div>"), "{page}");
        assert!(page.contains("x = 1 # $y$") && page.contains("\"language-toml\""), "{page}");
        // Nothing is fetched from anywhere.
        assert!(!page.contains("src=\"http") && !page.contains("MathJax"), "{page}");
        assert!(folder.path().join("out/font/TautlineFormulas.woff2").exists());
    }

    #[test]
    fn a_formula_that_cannot_be_read_stops_the_build_and_is_named() {
        let text = "# A\n\nText\nand $\\unheardof x$.\n";
        let error = built(&[("SUMMARY.md", "[A](a.md)"), ("a.md", text)]).expect_err("no such");
        assert!(error.contains("a.md:4") && error.contains("unheardof"), "{error}");
    }
}
