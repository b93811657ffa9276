//! `Output`: a folder in which every file is written completely or not at all.

use std::{
    fs::{self, File},
    io::Write,
    path::{Path, PathBuf},
};

use crate::Failure;

/// The folder that holds `data`, `figures` and `tables`.
#[derive(Clone, Debug)]
pub struct Output {
    root: PathBuf,
}

impl Output {
    /// Returns the folder of this package, whose files are committed.
    #[must_use]
    pub fn committed() -> Output {
        Output { root: PathBuf::from(env!("CARGO_MANIFEST_DIR")) }
    }

    /// Returns the folder of a quick run, which must not overwrite committed files.
    #[must_use]
    pub fn quick() -> Output {
        Output { root: Path::new(env!("CARGO_MANIFEST_DIR")).join("../target/quick") }
    }

    /// Returns any other folder.
    #[must_use]
    pub fn at(root: impl Into<PathBuf>) -> Output {
        Output { root: root.into() }
    }

    /// Writes a file under a temporary name, brings it to the disk and renames it, so that an
    /// interrupted run and a full disk leave the old file intact.
    ///
    /// # Errors
    ///
    /// If the system reports an error.
    pub fn write(&self, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        let path = self.root.join(file);
        let temporary = path.with_extension(format!("{}.part", std::process::id()));
        let attempt = || {
            fs::create_dir_all(path.parent().unwrap_or(&self.root))?;
            let mut file = File::create(&temporary)?;
            file.write_all(bytes)?;
            file.sync_all()?;
            fs::rename(&temporary, &path)
        };
        attempt().map_err(|source| {
            // An error in removing the temporary file adds nothing to the error reported.
            let _ = fs::remove_file(&temporary);
            Failure::File { path: path.clone(), source }
        })
    }

    /// Reads a file.
    ///
    /// # Errors
    ///
    /// If it does not exist or cannot be read.
    pub fn read(&self, file: &str) -> Result<Vec<u8>, Failure> {
        let path = self.root.join(file);
        fs::read(&path).map_err(|source| Failure::File { path, source })
    }

    /// Compares a file with its recomputed content.
    ///
    /// # Errors
    ///
    /// If the file does not exist, or if a byte differs.
    pub fn compare(&self, file: &str, bytes: &[u8]) -> Result<(), Failure> {
        if self.read(file)? == bytes {
            return Ok(());
        }
        Err(Failure::Differs(format!("{file} does not follow from its data")))
    }
}
