//! `Draft`: a file that appears under its name once it is complete and on the disk.

use std::{
    ffi::OsString,
    fs::{self, File, TryLockError},
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
    process,
    time::{SystemTime, UNIX_EPOCH},
};

use crate::error::CommandError;

/// The end of the names of drafts.
const DRAFT: &str = ".part";

/// A file that is written under another name next to its own, and gets its own once it is complete and on
/// the disk. A draft that is dropped is removed. What is no file, such as a pipe or a device, is written
/// to; a symbolic link remains one, and a file keeps its permissions.
#[derive(Debug)]
pub(crate) struct Draft {
    /// It is there until the draft is finished.
    file: Option<BufWriter<File>>,
    path: PathBuf,
    /// `None` if the path is no file.
    temporary: Option<PathBuf>,
}

impl Draft {
    /// Begins a file, and removes drafts of it whose processes have ended.
    pub(crate) fn of(path: &Path) -> Result<Self, CommandError> {
        let failed = |error| CommandError::File { path: path.to_owned(), error };
        if fs::metadata(path).is_ok_and(|found| !found.is_file()) {
            let file = File::options().write(true).open(path).map_err(failed)?;
            return Ok(Self {
                file: Some(BufWriter::new(file)),
                path: path.to_owned(),
                temporary: None,
            });
        }
        let path = behind_links(path);
        // A file that must not be written to must not be replaced, either.
        let before = match File::options().write(true).open(&path) {
            Ok(file) => file.metadata().ok(),
            Err(error) if error.kind() == io::ErrorKind::NotFound => None,
            Err(error) => return Err(failed(error)),
        };
        remove_abandoned(&path);
        // Processes of several machines may write to one folder.
        let since = SystemTime::now().duration_since(UNIX_EPOCH).unwrap_or_default();
        let own = format!(".{}-{}{DRAFT}", process::id(), since.as_nanos());
        let mut name = start_of_name(&path);
        name.push(own);
        let temporary = path.with_file_name(name);
        let file = File::create_new(&temporary).map_err(failed)?;
        let draft = Self { file: Some(BufWriter::new(file)), path, temporary: Some(temporary) };
        if let Some(file) = draft.file.as_ref().map(BufWriter::get_ref) {
            // The lock only says that the draft is in use. Where there are no locks, drafts of processes
            // that were killed remain.
            let _ = file.try_lock();
            if let Some(before) = before {
                inherit(file, &before).map_err(failed)?;
            }
        }
        Ok(draft)
    }

    /// Appends to the file.
    pub(crate) fn write(&mut self, bytes: impl AsRef<[u8]>) -> Result<(), CommandError> {
        let written = self.file.as_mut().map_or(Ok(()), |file| file.write_all(bytes.as_ref()));
        written.map_err(|error| CommandError::File { path: self.path.clone(), error })
    }

    /// Brings the file to the disk, and only then under its name.
    pub(crate) fn finish(mut self) -> Result<(), CommandError> {
        let done = (|| {
            let Some(mut file) = self.file.take() else { return Ok(()) };
            file.flush()?;
            let Some(temporary) = &self.temporary else { return Ok(()) };
            file.get_ref().sync_all()?;
            fs::rename(temporary, &self.path)?;
            sync_folder(&self.path)
        })();
        done.map_err(|error| CommandError::File { path: self.path.clone(), error })
    }
}

impl Drop for Draft {
    fn drop(&mut self) {
        // What was buffered is not written any more: a full disk has refused it once.
        if let Some(file) = self.file.take() {
            let _ = file.into_parts();
        }
        // After it was renamed, there is none.
        if let Some(temporary) = &self.temporary {
            let _ = fs::remove_file(temporary);
        }
    }
}

/// Returns the path of the file itself, behind all symbolic links, also if it is not there yet.
pub(crate) fn behind_links(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    // A circle of links is found out when the file is opened.
    for _ in 0..40 {
        if let Ok(found) = fs::canonicalize(&path) {
            return found;
        }
        let Ok(target) = fs::read_link(&path) else { break };
        path = folder(&path).join(target);
    }
    path
}

/// Gives a file the permissions of the file that it will replace, and its owner where that is allowed.
fn inherit(file: &File, before: &fs::Metadata) -> io::Result<()> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::{MetadataExt, fchown};
        let _ = fchown(file, Some(before.uid()), Some(before.gid()));
    }
    // After the owner: a change of the owner takes some permissions away.
    file.set_permissions(before.permissions())
}

/// Returns how the names of the drafts of a file begin.
fn start_of_name(path: &Path) -> OsString {
    let mut name = OsString::from(".");
    name.push(path.file_name().unwrap_or_default());
    name
}

/// Returns the folder of a file.
fn folder(path: &Path) -> &Path {
    path.parent().filter(|folder| *folder != Path::new("")).unwrap_or(Path::new("."))
}

/// Brings the entry of a file in its folder to the disk, where folders can be opened.
fn sync_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) { File::open(folder(path))?.sync_all() } else { Ok(()) }
}

/// Removes drafts of a file that no process has locked any more. What cannot be removed remains.
fn remove_abandoned(path: &Path) {
    let start = start_of_name(path).to_string_lossy().into_owned() + ".";
    for entry in fs::read_dir(folder(path)).into_iter().flatten().flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !(name.starts_with(&start) && name.ends_with(DRAFT)) {
            continue;
        }
        let Ok(file) = File::open(entry.path()) else { continue };
        match file.try_lock() {
            Ok(()) => {
                let _ = fs::remove_file(entry.path());
            }
            Err(TryLockError::WouldBlock | TryLockError::Error(_)) => {}
        }
    }
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::Draft;

    #[test]
    fn a_file_appears_when_it_is_complete() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.csv");
        let count = || fs::read_dir(folder.path()).expect("a folder").count();
        let mut draft = Draft::of(&path).expect("a draft");
        draft.write("one\n").expect("written");
        assert!(!path.exists() && count() == 1);
        draft.finish().expect("renamed");
        assert_eq!((fs::read_to_string(&path).expect("a file").as_str(), count()), ("one\n", 1));
        // One that is given up leaves what was there.
        let mut draft = Draft::of(&path).expect("a draft");
        draft.write("two\n").expect("written");
        drop(draft);
        assert_eq!((fs::read_to_string(&path).expect("a file").as_str(), count()), ("one\n", 1));
    }

    #[cfg(unix)]
    #[test]
    fn links_to_files_that_are_not_there_yet_remain_links() {
        use std::os::unix::fs::symlink;
        let folder = tempfile::tempdir().expect("a folder");
        let in_folder = |name: &str| folder.path().join(name);
        fs::create_dir(in_folder("deep")).expect("made");
        symlink("deep/two", in_folder("one")).expect("linked");
        symlink("../three", in_folder("deep/two")).expect("linked");
        let mut draft = Draft::of(&in_folder("one")).expect("a draft");
        draft.write("here\n").expect("written");
        draft.finish().expect("renamed");
        assert_eq!(fs::read_to_string(in_folder("three")).expect("a file"), "here\n");
        assert!(["one", "deep/two"].iter().all(|name| in_folder(name).is_symlink()));
        // A circle has no file.
        symlink("a", in_folder("b")).expect("linked");
        symlink("b", in_folder("a")).expect("linked");
        assert!(Draft::of(&in_folder("a")).is_err());
    }

    #[cfg(unix)]
    #[test]
    fn a_file_keeps_its_permissions() {
        use std::os::unix::fs::PermissionsExt;
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("a.cert");
        fs::write(&path, "one\n").expect("written");
        for mode in [0o600, 0o640, 0o755] {
            fs::set_permissions(&path, fs::Permissions::from_mode(mode)).expect("set");
            let mut draft = Draft::of(&path).expect("a draft");
            draft.write("two\n").expect("written");
            draft.finish().expect("renamed");
            let found = fs::metadata(&path).expect("a file").permissions().mode();
            assert_eq!(found & 0o777, mode);
        }
        // Whoever may write to any file, such as root, may replace it.
        fs::set_permissions(&path, fs::Permissions::from_mode(0o400)).expect("set");
        let may_write = fs::File::options().write(true).open(&path).is_ok();
        assert_eq!(Draft::of(&path).is_ok(), may_write);
        assert_eq!(fs::read_dir(folder.path()).expect("a folder").count(), 1);
    }

    /// A draft of a killed process has no lock.
    #[test]
    fn abandoned_drafts_are_removed_and_others_are_not() {
        let folder = tempfile::tempdir().expect("a folder");
        let (path, other) = (folder.path().join("a.csv"), folder.path().join("b.csv"));
        let abandoned = [".a.csv.7-1.part", ".b.csv.7-1.part", ".a.csv.txt"];
        abandoned.iter().for_each(|name| fs::write(folder.path().join(name), "").expect("written"));
        let living = Draft::of(&path).expect("a draft");
        let own = Draft::of(&path).expect("another draft");
        let temporary = living.temporary.as_ref().expect("a draft");
        assert!(temporary.exists() && own.temporary != living.temporary);
        let remain = abandoned.map(|name| folder.path().join(name).exists());
        assert_eq!(remain, [false, true, true]);
        drop(Draft::of(&other).expect("a draft"));
        assert!(!folder.path().join(abandoned[1]).exists());
        // Both finish: the last one stays.
        living.finish().expect("renamed");
        own.finish().expect("renamed");
    }
}
