//! `tautline merge`.

use std::{
    fs, io,
    path::{Path, PathBuf},
    process::ExitCode,
};

use tautline_problem::sweep::{Block, BlockError, BlockWriter, Head, in_order, plain};

use crate::{
    arguments::Merge, draft::Draft, error::CommandError, paths::check_paths, write::print,
};

/// Joins the results of all shards. One file at a time is in memory.
pub(crate) fn merge(arguments: &Merge) -> Result<ExitCode, CommandError> {
    let mut files = Vec::new();
    for path in &arguments.results {
        files.extend(results(path)?);
    }
    check_paths(arguments.output.as_slice(), &files)?;
    let (mut heads, mut wrong): (Vec<Head>, Vec<String>) = Default::default();
    for path in &files {
        let text = read(path)?;
        match Block::read(&text) {
            Ok(block) => heads.push(block.head),
            Err(error @ BlockError::NoResults { .. }) => {
                return Err(CommandError::BadArgument(format!("{}: {error}", path.display())));
            }
            Err(error) => wrong.push(format!("{}: {error}", path.display())),
        }
    }
    if !wrong.is_empty() {
        return Err(CommandError::NotDone(wrong.join("\n")));
    }
    let name = |index: usize| files[index - 1].display().to_string();
    let order = in_order(&heads).map_err(|error| CommandError::NotDone(error.message(name)))?;
    let mut draft = arguments.output.as_ref().map(|path| Draft::of(path)).transpose()?;
    let mut put = |text: &str| match &mut draft {
        Some(draft) => draft.write(text),
        None => print(text),
    };
    let (mut writer, head) = BlockWriter::new(&heads[0].whole());
    put(&head)?;
    for index in order {
        let (path, text) = (&files[index], read(&files[index])?);
        let changed = || CommandError::NotDone(format!("{} was changed", path.display()));
        let block = Block::read(&text).map_err(|_| changed())?;
        if block.head != heads[index] {
            return Err(changed());
        }
        put(&writer.rows(block.rows.to_owned()))?;
    }
    put(&writer.end())?;
    if let (Some(draft), Some(path)) = (draft, &arguments.output) {
        draft.finish()?;
        print(&format!("wrote {} with {} problems\n", path.display(), heads[0].count))?;
    }
    Ok(ExitCode::SUCCESS)
}

/// Returns the files of results in a folder, or the file.
fn results(path: &Path) -> Result<Vec<PathBuf>, CommandError> {
    if !path.is_dir() {
        return Ok(vec![path.to_owned()]);
    }
    let failed = |error: io::Error| CommandError::File { path: path.to_owned(), error };
    let entries = fs::read_dir(path).and_then(Iterator::collect::<io::Result<Vec<_>>>);
    let mut files: Vec<PathBuf> = entries.map_err(failed)?.iter().map(fs::DirEntry::path).collect();
    let is_result = |path: &PathBuf| {
        let is_hidden =
            path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
        !is_hidden && path.extension().is_some_and(|extension| extension == "csv")
    };
    files.retain(is_result);
    files.sort();
    Ok(files)
}

fn read(path: &Path) -> Result<String, CommandError> {
    let text = fs::read_to_string(path);
    let text = text.map_err(|error| CommandError::File { path: path.to_owned(), error })?;
    Ok(plain(&text).into_owned())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::results;

    /// A draft of a process that still writes is hidden, and no result.
    #[test]
    fn the_results_of_a_folder_are_its_tables_in_order() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        for name in ["2-of-3.csv", "1-of-3.csv", ".hidden.csv", ".a.csv.7-1.part", "times.txt"] {
            fs::write(path(name), "").expect("written");
        }
        let found = results(folder.path()).ok();
        assert_eq!(found, Some(vec![path("1-of-3.csv"), path("2-of-3.csv")]));
        // What is named itself is taken as it is.
        assert_eq!(results(&path("times.txt")).ok(), Some(vec![path("times.txt")]));
    }
}
