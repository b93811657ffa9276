//! A page of the guide, whose blocks run in one fresh folder.

use std::{
    fs,
    ops::Range,
    path::{Path, PathBuf},
};

use crate::{
    bless,
    block::{Block, Kind, blocks},
    command,
    picture::{Picture, pictures},
    root,
};

/// A page.
#[derive(Debug)]
pub(crate) struct Page {
    path: PathBuf,
    /// Its path below the folder of all pages.
    pub(crate) name: String,
    text: String,
    pub(crate) blocks: Vec<Block>,
    pub(crate) pictures: Vec<Picture>,
}

/// The outcomes of the blocks and of the pictures of a page, in their order.
#[derive(Debug)]
pub(crate) struct Outcomes {
    pub(crate) blocks: Vec<Result<(), String>>,
    pub(crate) pictures: Vec<Result<(), String>>,
}

impl Page {
    /// Reads all pages below `folder`, in the order of their names.
    pub(crate) fn all(folder: &Path) -> Result<Vec<Self>, String> {
        let mut pages = Vec::new();
        let mut pending = vec![folder.to_owned()];
        while let Some(next) = pending.pop() {
            let entries = fs::read_dir(&next).map_err(|error| at(&next, error))?;
            for entry in entries {
                let path = entry.map_err(|error| at(&next, error))?.path();
                if path.is_dir() {
                    pending.push(path);
                } else if path.extension().is_some_and(|extension| extension == "md") {
                    let text = fs::read_to_string(&path).map_err(|error| at(&path, error))?;
                    let name = path.strip_prefix(folder).unwrap_or(&path).display().to_string();
                    let (blocks, pictures) = (blocks(&text), pictures(&text));
                    pages.push(Self { path, name, text, blocks, pictures });
                }
            }
        }
        pages.sort_by(|a, b| a.name.cmp(&b.name));
        Ok(pages)
    }

    /// Runs all blocks in order, compares the pictures, and returns the outcome of each. If `bless`
    /// is set, answers and pictures that differ are written into the guide and are no failures.
    pub(crate) fn run(&self, tautline: fn() -> Result<PathBuf, String>, bless: bool) -> Outcomes {
        let folder = match tempfile::tempdir() {
            Ok(folder) => folder,
            Err(error) => return self.failed(&error.to_string()),
        };
        let mut edits: Vec<(Range<usize>, String)> = Vec::new();
        let mut outcomes: Vec<Result<(), String>> = Vec::new();
        for block in &self.blocks {
            outcomes.push(match &block.kind {
                Err(why) => Err(why.clone()),
                Ok(Kind::Ignored) => Ok(()),
                Ok(Kind::Rust) => self.is_documented(),
                Ok(Kind::File(name)) => fs::write(folder.path().join(name), &block.text)
                    .map_err(|error| format!("{name}: {error}")),
                Ok(Kind::Console) => match command::run(&block.text, folder.path(), tautline) {
                    Ok(transcript) if transcript.agrees() => Ok(()),
                    Ok(transcript) if bless && self.text[block.range.clone()] == block.text => {
                        edits.push((block.range.clone(), transcript.as_answered()));
                        Ok(())
                    }
                    Ok(transcript) => Err(transcript.differences()),
                    Err(why) => Err(why),
                },
            });
        }
        if !edits.is_empty()
            && let Err(why) = bless::rewrite(&self.path, &self.text, &edits)
        {
            return self.failed(&why);
        }
        let written = |name: &str| {
            self.blocks.iter().any(|block| block.kind == Ok(Kind::File(name.to_owned())))
        };
        let pictures = self.pictures.iter().map(|picture| {
            if written(&picture.name) {
                return Err(format!("{} is a block of the page, and no picture", picture.name));
            }
            picture.compare(&self.path, folder.path(), bless)
        });
        Outcomes { pictures: pictures.collect(), blocks: outcomes }
    }

    /// Returns the outcomes of a page that did not run.
    fn failed(&self, why: &str) -> Outcomes {
        let all = |count| vec![Err(why.to_owned()); count];
        Outcomes { blocks: all(self.blocks.len()), pictures: all(self.pictures.len()) }
    }

    /// Checks that the page is a documentation test, which compiles and runs its Rust.
    fn is_documented(&self) -> Result<(), String> {
        let library = root().join("crates/library/tautline/src/lib.rs");
        let text = fs::read_to_string(&library).map_err(|error| at(&library, error))?;
        let line = format!("#[doc = include_str!(\"../../../../guide/pages/{}\")]", self.name);
        if text.contains(&line) {
            Ok(())
        } else {
            Err(format!(
                "its Rust is no documentation test: crates/library/tautline/src/lib.rs needs\n{line}"
            ))
        }
    }
}

fn at(path: &Path, error: std::io::Error) -> String {
    format!("{}: {error}", path.display())
}

/// Returns the names of the pages that `SUMMARY.md` does not link to: they would not be built.
pub(crate) fn orphans(pages: &[Page]) -> Vec<String> {
    let summary = pages.iter().find(|page| page.name == "SUMMARY.md");
    let summary = summary.map_or("", |page| page.text.as_str());
    let others = pages.iter().map(|page| &page.name).filter(|name| *name != "SUMMARY.md");
    others.filter(|name| !summary.contains(&format!("]({name})"))).cloned().collect()
}
