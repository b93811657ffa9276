//! `tautline examples`: commented problem files, each for a question.

use std::{fmt::Write, process::ExitCode};

use crate::{
    arguments::Examples,
    error::CommandError,
    write::{print, write},
};

/// A problem file.
struct Example {
    name: &'static str,
    text: &'static str,
}

impl Example {
    /// Returns the question, which is the first line of the file.
    fn question(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }
}

/// Lists the examples, which are files of the folder `problems`.
macro_rules! examples {
    ($($name:literal)*) => {
        [$(Example { name: $name, text: include_str!(concat!("../problems/", $name, ".toml")) }),*]
    };
}

const EXAMPLES: [Example; 3] = examples! { "valleys" "two_channels" "robot_arm" };

/// Lists, prints or writes examples.
pub(crate) fn examples(arguments: &Examples) -> Result<ExitCode, CommandError> {
    let named = |name: &String| {
        EXAMPLES.iter().find(|example| example.name == name).ok_or_else(|| {
            let names = EXAMPLES.map(|example| example.name).join(", ");
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
        for example in &EXAMPLES {
            // Writing to a string does not fail.
            let _ = writeln!(list, "{:<20}{}", example.name, example.question());
        }
        print(&list)?;
    }
    for example in chosen {
        let Some(folder) = &arguments.to else {
            print(example.text)?;
            continue;
        };
        let path = folder.join(format!("{}.toml", example.name));
        if path.exists() {
            let message = format!("{} exists already; it is left as it is", path.display());
            return Err(CommandError::BadArgument(message));
        }
        write(&path, example.text.as_bytes())?;
        print(&format!("wrote {}\n", path.display()))?;
    }
    Ok(ExitCode::SUCCESS)
}
