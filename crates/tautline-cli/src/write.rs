//! Files that are written whole or not at all.

use std::{
    ffi::OsString,
    fs,
    io::{self, Write},
    path::Path,
    process,
};

use tautline_problem::{Scene, pdf, png, svg};

use crate::error::CommandError;

/// Writes a file under a temporary name next to it, and renames it. What is no file, such as a pipe or
/// a device, is written to; a symbolic link remains one.
pub(crate) fn write(path: &Path, bytes: &[u8]) -> Result<(), CommandError> {
    let failed = |error| CommandError::File { path: path.to_owned(), error };
    if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
        return fs::write(path, bytes).map_err(failed);
    }
    let path = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name.push(format!(".{}", process::id()));
    let temporary = path.with_file_name(name);
    let written = fs::write(&temporary, bytes).and_then(|()| fs::rename(&temporary, &path));
    written.map_err(|error| {
        let _ = fs::remove_file(&temporary);
        failed(error)
    })
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
        match path.parent() {
            Some(folder) if folder != Path::new("") && !folder.is_dir() => {
                let (path, folder) = (path.display(), folder.display());
                Err(CommandError::BadArgument(format!("{path}: there is no folder {folder}")))
            }
            _ => Ok(()),
        }
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

/// Prints a text. A reader that has gone away, such as `head`, is no error.
pub(crate) fn print(text: &str) -> Result<(), CommandError> {
    let mut out = io::stdout().lock();
    match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => {
            Err(CommandError::File { path: "standard output".into(), error })
        }
        _ => Ok(()),
    }
}
