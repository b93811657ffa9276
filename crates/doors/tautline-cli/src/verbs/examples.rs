//! `tautline examples`: commented problem files, each for a question.

use std::{fmt::Write, path::PathBuf, process::ExitCode};

use tautline_problem::{EXAMPLES, Example};

use crate::{
    arguments::Examples,
    error::CommandError,
    paths::check_paths,
    write::{print, write},
};

/// Lists, prints or writes examples.
pub(crate) fn examples(arguments: &Examples) -> Result<ExitCode, CommandError> {
    let named = |name: &String| {
        Example::named(name).ok_or_else(|| {
            let names: Vec<&str> = EXAMPLES.iter().map(|example| example.name).collect();
            let names = names.join(", ");
            CommandError::BadArgument(format!("there is no example {name}; there are {names}"))
        })
    };
    let chosen = if arguments.all {
        EXAMPLES.iter().collect()
    } else {
        arguments.names.iter().map(named).collect::<Result<Vec<_>, _>>()?
    };
    if chosen.is_empty() {
        let mut list = String::new();
        for example in EXAMPLES {
            // Writing to a string does not fail.
            let _ = writeln!(list, "{:<22}{}", example.name, example.question());
        }
        print(&list)?;
    }
    let Some(folder) = &arguments.to else {
        return chosen
            .iter()
            .try_for_each(|example| print(example.text))
            .map(|()| ExitCode::SUCCESS);
    };
    let path = |example: &&Example| folder.join(format!("{}.toml", example.name));
    let paths: Vec<PathBuf> = chosen.iter().map(path).collect();
    if let Some(path) = paths.iter().find(|path| path.exists()) {
        let message = format!("{} exists already; it is left as it is", path.display());
        return Err(CommandError::BadArgument(message));
    }
    check_paths(&paths, &[""; 0])?;
    for (path, example) in paths.into_iter().zip(chosen) {
        write(&path, example.text.as_bytes())?;
        print(&format!("wrote {}\n", path.display()))?;
    }
    Ok(ExitCode::SUCCESS)
}
