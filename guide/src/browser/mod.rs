//! Opens every page of the built guide in headless Chromium, and lists what is wrong.
//!
//! At two widths of the window it reports missing pictures, formulas that are errors, raw, empty or
//! too wide, whatever leaves the page sideways, errors of scripts, and requests that leave the
//! folder. Then it compares the links with the pages and the anchors that exist. Links to the web
//! are not tried.

mod links;
mod page;

use std::{
    ffi::OsStr,
    fs,
    path::{Path, PathBuf},
};

use headless_chrome::{Browser, LaunchOptions, browser::default_executable};
use mdbook_preprocessor::errors::{Error, Result};
use page::Visit;

/// The widths of the window, in pixels: a desk and a telephone.
const WIDTHS: [u32; 2] = [1200, 400];

/// No network, no first run, nothing in the background.
const FLAGS: [&str; 4] = [
    "--disable-quic",
    "--disable-component-update",
    "--disable-background-networking",
    "--hide-scrollbars",
];

/// Checks the guide in `folder`, and writes a picture of each page at each width to `pictures`.
pub(crate) fn check(folder: &Path, pictures: &Path) -> Result<()> {
    let pages = pages(folder)?;
    let found = findings(folder, &pages, Some(pictures))?;
    println!("{} pages in {}", pages.len(), pictures.display());
    if found.is_empty() { Ok(()) } else { Err(Error::msg(found.join("\n"))) }
}

/// Returns what is wrong with the pages.
fn findings(folder: &Path, pages: &[PathBuf], pictures: Option<&Path>) -> Result<Vec<String>> {
    let folder = fs::canonicalize(folder)?;
    if let Some(pictures) = pictures {
        fs::create_dir_all(pictures)?;
    }
    let mut found = Vec::new();
    for width in WIDTHS {
        // A fresh profile for each, which headless_chrome makes and removes.
        let browser = launch()?;
        let mut visits: Vec<Visit> = Vec::new();
        for page in pages {
            let name = page.strip_prefix(&folder).unwrap_or(page).display().to_string();
            let picture = pictures.map(|pictures| {
                pictures.join(format!("{}-{width}.png", name.replace(['/', '.'], "-")))
            });
            let visit = page::visit(&browser, &folder, page, width, picture.as_deref())
                .map_err(|error| Error::msg(format!("{name}: {error:#}")))?;
            found.extend(visit.findings.iter().map(|what| format!("{name} at {width} px: {what}")));
            visits.push(visit);
        }
        // Links are the same at each width.
        if width == WIDTHS[0] {
            found.extend(links::broken(&folder, &visits));
        }
    }
    Ok(found)
}

fn launch() -> Result<Browser> {
    let path = default_executable().map_err(|_| {
        Error::msg(
            "no Chromium: install it (`apt-get install chromium`, or Chrome), or name the program in \
             the environment variable CHROME",
        )
    })?;
    let options = LaunchOptions {
        path: Some(path),
        // In a container, and as root, the sandbox does not start. The pages are our own.
        sandbox: false,
        args: FLAGS.iter().map(OsStr::new).collect(),
        ..LaunchOptions::default()
    };
    Browser::new(options)
}

/// Returns all pages below `folder`, sorted.
fn pages(folder: &Path) -> Result<Vec<PathBuf>> {
    let mut pages = Vec::new();
    let mut pending = vec![fs::canonicalize(folder)?];
    while let Some(folder) = pending.pop() {
        for entry in fs::read_dir(folder)? {
            let path = entry?.path();
            if path.is_dir() {
                pending.push(path);
            } else if path.extension().is_some_and(|extension| extension == "html") {
                pages.push(path);
            }
        }
    }
    pages.sort();
    if pages.is_empty() { Err(Error::msg("no pages")) } else { Ok(pages) }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{findings, pages};

    /// One page with every mistake, and one without.
    #[test]
    fn every_mistake_is_reported_and_a_good_page_is_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let write = |name: &str, body: &str| {
            let head =
                "<!DOCTYPE html><meta charset=utf-8><link rel=icon href=data:,><title>t</title>";
            let text = format!("{head}<body><main>{body}</main></body>");
            fs::write(folder.path().join(name), text).expect("written");
        };
        write("good.html", "<h1 id=a>Good</h1><p><math><mi>x</mi></math> <a href=#a>a</a></p>");
        let bad = "<img src=none.png>
            <math><merror><mtext>oops</mtext></merror></math>
            <math><mrow></mrow></math>
            <math><mspace width=2000px height=1px></mspace><mi>y</mi></math>
            <p>left over: $x$ and \\frac</p>
            <p><span style='display:inline-block;width:1500px'>long</span></p>
            <a href=missing.html>m</a> <a href=good.html#nowhere>n</a> <a href=../outside.html>o</a>
            <script src=http://127.0.0.1:9/x.js></script>
            <script>console.error('said')</script>
            <script>undefinedFunction()</script>";
        write("bad.html", bad);
        let found = findings(folder.path(), &pages(folder.path()).expect("pages"), None);
        let found = found.expect("a browser");
        let expected = [
            "missing picture none.png",
            "formula \"oops\" is an error",
            "formula \"\" has no size",
            "px wide, the page has ",
            "raw formula in \"left over: $x$ and \\frac\"",
            "the page is ",
            "<span> \"long\" leaves the page at the right",
            "link to missing.html: no such file",
            "link to good.html#nowhere: no such anchor",
            "link to ../outside.html: leaves the folder",
            "request to http://127.0.0.1:9/x.js leaves the folder",
            "console error: said",
            "undefinedFunction is not defined",
        ];
        let text = found.join("\n");
        for what in expected {
            assert!(text.contains(what), "{what:?} is not in:\n{text}");
        }
        assert!(found.iter().all(|line| line.starts_with("bad.html")), "{text}");
    }
}
