//! Which files a command reads and writes: none is written twice, and none that is read is written.

use std::{
    fs,
    path::{Path, PathBuf, absolute},
};

use crate::{draft::behind_links, error::CommandError};

/// Refuses files to write of which two are the same, or one is read, whatever their names are. What is no
/// file, such as a device, may be named twice.
pub(crate) fn check_paths(
    written: &[impl AsRef<Path>],
    read: &[impl AsRef<Path>],
) -> Result<(), CommandError> {
    let found = |path: &Path| Place::of(path).map(|place| (path.display().to_string(), place));
    let written: Vec<_> = written.iter().filter_map(|path| found(path.as_ref())).collect();
    let read: Vec<_> = read.iter().filter_map(|path| found(path.as_ref())).collect();
    for (number, (name, place)) in written.iter().enumerate() {
        if let Some((other, _)) = read.iter().find(|(_, other)| other.is(place)) {
            let is = if name == other { "is" } else { &format!("is {other}, which is") };
            let message = format!("{name} {is} read; write to another file");
            return Err(CommandError::BadArgument(message));
        }
        if let Some((other, _)) = written[..number].iter().find(|(_, other)| other.is(place)) {
            let message = format!("{other} and {name} are the same file; write to two");
            return Err(CommandError::BadArgument(message));
        }
    }
    Ok(())
}

/// Refuses a file in a folder that is not there.
pub(crate) fn check_folder(path: &Path) -> Result<(), CommandError> {
    match path.parent() {
        Some(folder) if folder != Path::new("") && !folder.is_dir() => {
            let (path, folder) = (path.display(), folder.display());
            Err(CommandError::BadArgument(format!("{path}: there is no folder {folder}")))
        }
        _ => Ok(()),
    }
}

/// Where a file is, or will be.
struct Place {
    /// The path behind all links, from the root.
    path: PathBuf,
    /// The numbers of the device and of the file, which several names may share.
    #[cfg(unix)]
    numbers: Option<(u64, u64)>,
}

impl Place {
    /// Returns the place of a file; `None` of what is no file.
    fn of(path: &Path) -> Option<Self> {
        let found = fs::metadata(path).ok();
        if found.as_ref().is_some_and(|found| !found.is_file()) {
            return None;
        }
        let path = behind_links(path);
        let folder = path.parent().filter(|folder| *folder != Path::new(""));
        // A file that is not there yet is in a folder, which may not be there, either.
        let folder = fs::canonicalize(folder.unwrap_or(Path::new("."))).ok();
        let path = match (folder, path.file_name()) {
            (Some(folder), Some(name)) => folder.join(name),
            _ => absolute(&path).unwrap_or(path),
        };
        #[cfg(unix)]
        let numbers = found.map(|found| {
            use std::os::unix::fs::MetadataExt;
            (found.dev(), found.ino())
        });
        Some(Self {
            path,
            #[cfg(unix)]
            numbers,
        })
    }

    fn is(&self, other: &Self) -> bool {
        #[cfg(unix)]
        if self.numbers.is_some() && self.numbers == other.numbers {
            return true;
        }
        self.path == other.path
    }
}

#[cfg(test)]
mod tests {
    use std::{fs, path::PathBuf};

    use super::check_paths;

    fn refused(written: &[&PathBuf], read: &[&PathBuf]) -> Option<String> {
        check_paths(written, read).err().map(|error| error.to_string())
    }

    /// A name is not a file: there are others with dots, by links and by folders that are links.
    #[test]
    fn a_file_is_known_by_all_of_its_names() {
        let folder = tempfile::tempdir().expect("a folder");
        let at = |name: &str| folder.path().join(name);
        fs::create_dir(at("in")).expect("made");
        for name in ["a", "b", "in/a"] {
            fs::write(at(name), "").expect("written");
        }
        let mut same = vec![
            (at("a"), at("a")),
            (at("a"), at("./a")),
            (at("a"), at("in/../a")),
            // They are not there yet.
            (at("new"), at("in/../new")),
            (at("none/new"), at("none/./new")),
        ];
        #[cfg(unix)]
        {
            use std::os::unix::fs::symlink;
            symlink("a", at("link")).expect("linked");
            symlink("new", at("link to new")).expect("linked");
            symlink("in", at("folder")).expect("linked");
            fs::hard_link(at("a"), at("hard")).expect("linked");
            same.extend([
                (at("a"), at("link")),
                (at("new"), at("link to new")),
                (at("in/a"), at("folder/a")),
                (at("in/new"), at("folder/new")),
                (at("hard"), at("link")),
            ]);
        }
        for (one, two) in &same {
            for [one, two] in [[one, two], [two, one]] {
                assert!(refused(&[one, two], &[]).is_some(), "{one:?} {two:?}");
                assert!(refused(&[one], &[two]).is_some_and(|why| why.contains("read")));
                assert!(refused(&[&at("b"), one], &[&at("in/a"), two]).is_some());
            }
            assert_eq!(refused(&[], &[one, two]), None);
        }
        let different = [at("a"), at("b"), at("in/b"), at("new"), at("in/new"), at("none/a")];
        let different: Vec<&PathBuf> = different.iter().collect();
        assert_eq!(refused(&different, &[&at("in/a"), &at("other")]), None);
        // A folder is no file, and neither is a device.
        let device = PathBuf::from("/dev/null");
        assert_eq!(refused(&[&device, &device], &[&device, &at("in")]), None);
    }
}
