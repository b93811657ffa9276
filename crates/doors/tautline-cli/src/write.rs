//! Files that are written whole or not at all, and what is printed.

use std::{
    fmt::Display,
    io::{self, Write},
    path::Path,
};

use tautline_problem::{Scene, pdf, png, svg};

use crate::{draft::Draft, error::CommandError, paths::check_folder};

/// Writes a file as a [`Draft`].
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), CommandError> {
    let mut draft = Draft::of(path)?;
    draft.write(bytes)?;
    draft.finish()
}

/// The formats of pictures.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Format {
    Svg,
    Png,
    Pdf,
}

impl Format {
    fn of(path: &Path) -> Result<Self, CommandError> {
        let extension = path.extension().unwrap_or_default().to_string_lossy().to_lowercase();
        match extension.as_str() {
            "svg" => Ok(Format::Svg),
            "png" => Ok(Format::Png),
            "pdf" => Ok(Format::Pdf),
            _ => Err(CommandError::BadArgument(format!(
                "{}: a picture ends in .svg, .png or .pdf",
                path.display()
            ))),
        }
    }
}

/// Checks the names of pictures and their folders, before anything is computed.
pub(crate) fn check_pictures(paths: &[impl AsRef<Path>]) -> Result<(), CommandError> {
    paths.iter().map(AsRef::as_ref).try_for_each(|path| {
        Format::of(path)?;
        check_folder(path)
    })
}

/// Writes a picture in the format that its name asks for.
pub(crate) fn write_picture(path: &Path, scene: &Scene) -> Result<(), CommandError> {
    let bytes = match Format::of(path)? {
        Format::Svg => Ok(svg(scene)),
        Format::Png => png(scene),
        Format::Pdf => Ok(pdf(scene)),
    };
    write(path, &bytes.map_err(|error| CommandError::NotDone(error.to_string()))?)
}

/// Prints a text.
///
/// # Errors
///
/// [`CommandError::Unread`] if the reader has gone away, as `head` does; another one if the output is
/// full or closed.
pub(crate) fn print(text: &str) -> Result<(), CommandError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() == io::ErrorKind::BrokenPipe => Err(CommandError::Unread),
        Err(error) => Err(CommandError::File { path: "standard output".into(), error }),
        Ok(()) => Ok(()),
    }
}

/// Returns a value as a JSON document.
pub(crate) fn json(value: &impl serde::Serialize) -> Result<String, CommandError> {
    let json = serde_json::to_string_pretty(value);
    Ok(json.map_err(|error| CommandError::NotDone(error.to_string()))? + "\n")
}

/// Says something to the person at the terminal. Nobody may listen: that is no reason to fail, and the
/// exit code says what counts.
pub(crate) fn say(message: impl Display) {
    let _ = writeln!(io::stderr(), "{message}");
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Format, check_pictures, json};

    #[test]
    fn a_picture_has_the_format_of_its_name() {
        for (name, format) in [
            ("a.svg", Some(Format::Svg)),
            ("a.b.PNG", Some(Format::Png)),
            ("folder.svg/a.Pdf", Some(Format::Pdf)),
            ("a.svg.gz", None),
            ("svg", None),
        ] {
            assert_eq!(Format::of(Path::new(name)).ok(), format, "{name}");
        }
    }

    /// Before anything is computed, every name counts, not the first alone.
    #[test]
    fn all_pictures_are_checked() {
        let folder = tempfile::tempdir().expect("a folder");
        let good = folder.path().join("a.svg");
        let nowhere = folder.path().join("none/a.svg");
        let wrong = folder.path().join("a.gif");
        assert!(check_pictures(&[&good, &good]).is_ok() && check_pictures(&[""; 0]).is_ok());
        assert!(check_pictures(&["a.svg"]).is_ok());
        for bad in [&nowhere, &wrong] {
            assert!(check_pictures(&[bad]).is_err());
            assert!(
                check_pictures(&[&good, bad]).is_err() && check_pictures(&[bad, &good]).is_err()
            );
        }
    }

    #[test]
    fn a_document_ends_with_a_line_break() {
        assert_eq!(json(&[1.5]).expect("JSON"), "[\n  1.5\n]\n");
    }
}
