//! The interactive page: one HTML file that holds its style, its scripts and the compiled solver.

use std::{
    env, fmt, fs,
    io::{self, Write},
    path::{Path, PathBuf},
    process::Command,
};

use base64::{Engine, prelude::BASE64_STANDARD};
use flate2::{Compression, write::GzEncoder};
use wasm_bindgen_cli_support::Bindgen;

#[cfg(test)]
mod tests;

/// The target of the compiled solver.
const TARGET: &str = "wasm32-unknown-unknown";

/// The name of the file.
pub(crate) const FILE: &str = "interactive.html";

/// Flags of the compiler: two numbers in one register, as in every browser since 2023.
const FLAGS: &str = "-Ctarget-feature=+simd128";

/// What became of the page.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Built {
    /// The page was written.
    Written {
        /// The file.
        file: PathBuf,
        /// Its size, in bytes.
        bytes: usize,
    },
    /// The compiler has no standard library for the target, so that there is no page.
    NoTarget,
}

impl fmt::Display for Built {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Written { file, bytes } => {
                write!(f, "the page that computes: {}, {} kB", file.display(), bytes.div_ceil(1000))
            }
            Self::NoTarget => write!(
                f,
                "no interactive page: the target {TARGET} is not installed; \
                 `rustup target add {TARGET}` installs it"
            ),
        }
    }
}

/// Why the page could not be built.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub(crate) enum Error {
    /// A program did not start.
    #[error("`{program}` did not start: {error}")]
    NotStarted {
        /// The program.
        program: String,
        /// What the system said.
        error: io::Error,
    },
    /// The solver does not compile.
    #[error("the solver does not compile for {TARGET}:\n{messages}")]
    Compilation {
        /// What the compiler said.
        messages: String,
    },
    /// A file could not be read or written.
    #[error("{}: {error}", file.display())]
    File {
        /// The file.
        file: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// There is no glue for the compiled solver.
    #[error("no glue for the compiled solver: {reason}")]
    Glue {
        /// What wasm-bindgen said.
        reason: String,
    },
    /// A part would end the script that holds it.
    #[error("{part} contains `</script`, which would end the script around it")]
    EndsScript {
        /// The part.
        part: &'static str,
    },
}

/// Compiles the solver for the browser, and writes the page to `out/interactive.html`.
///
/// Without a standard library for the target there is no page, which is not an error.
///
/// # Errors
///
/// [`Error`] if the solver does not compile, or if a file cannot be read or written. An existing
/// page is then left as it was.
pub(crate) fn build(out: &Path) -> Result<Built, Error> {
    if !has_target()? {
        return Ok(Built::NoTarget);
    }
    let program = compile()?;
    let page = assemble(program)?;
    let file = out.join(FILE);
    let written = fs::create_dir_all(out).and_then(|()| {
        let unfinished = out.join(format!("{FILE}.unfinished"));
        fs::write(&unfinished, &page)?;
        fs::rename(&unfinished, &file)
    });
    match written {
        Ok(()) => Ok(Built::Written { file, bytes: page.len() }),
        Err(error) => Err(Error::File { file, error }),
    }
}

/// Returns whether the compiler has a standard library for the target.
fn has_target() -> Result<bool, Error> {
    let rustc = env::var("RUSTC").unwrap_or_else(|_| "rustc".into());
    let output =
        Command::new(&rustc).args(["--print", "target-libdir", "--target", TARGET]).output();
    let output = output.map_err(|error| Error::NotStarted { program: rustc, error })?;
    let folder = String::from_utf8_lossy(&output.stdout);
    Ok(output.status.success() && Path::new(folder.trim()).is_dir())
}

/// Compiles the solver, and returns the program.
fn compile() -> Result<Vec<u8>, Error> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let folder = root.join("target/page");
    let cargo = env::var("CARGO").unwrap_or_else(|_| "cargo".into());
    let output = Command::new(&cargo)
        .args(["build", "--package", "tautline-page", "--profile", "page", "--target", TARGET])
        .arg("--target-dir")
        .arg(&folder)
        .env("CARGO_ENCODED_RUSTFLAGS", FLAGS)
        .current_dir(&root)
        .output()
        .map_err(|error| Error::NotStarted { program: cargo, error })?;
    if !output.status.success() {
        let messages = String::from_utf8_lossy(&output.stderr).into_owned();
        return Err(Error::Compilation { messages });
    }
    let file = folder.join(TARGET).join("page/tautline_page.wasm");
    fs::read(&file).map_err(|error| Error::File { file, error })
}

/// Returns the page: the glue, the compressed program and our own parts in one text.
fn assemble(program: Vec<u8>) -> Result<String, Error> {
    let glue = |error: &dyn fmt::Display| Error::Glue { reason: format!("{error:#}") };
    let mut bindgen = Bindgen::new();
    bindgen.input_bytes("tautline_page", program).typescript(false).remove_name_section(true);
    let mut output = bindgen
        .no_modules(true)
        .and_then(|bindgen| bindgen.generate_output())
        .map_err(|error| glue(&error))?;
    let program = output.wasm_mut().emit_wasm();
    let mut compressor = GzEncoder::new(Vec::new(), Compression::best());
    let compressed = compressor
        .write_all(&program)
        .and_then(|()| compressor.finish())
        .map_err(|error| glue(&error))?;
    let parts = [
        ("style.css", include_str!("../interactive/style.css")),
        ("program", &BASE64_STANDARD.encode(compressed)),
        ("glue", output.js()),
        ("worker.js", include_str!("../interactive/worker.js")),
        ("examples.js", include_str!("../interactive/examples.js")),
        ("picture.js", include_str!("../interactive/picture.js")),
        ("prover.js", include_str!("../interactive/prover.js")),
        ("page.js", include_str!("../interactive/page.js")),
    ];
    let mut page = include_str!("../interactive/page.html").to_owned();
    for (part, text) in parts {
        if text.contains("</script") || text.contains("</style") {
            return Err(Error::EndsScript { part });
        }
        page = page.replacen(&format!("{{{{ {part} }}}}"), text.trim_end(), 1);
    }
    Ok(page)
}
