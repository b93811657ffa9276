//! A picture on a page, which a command of the page makes.

use std::{fs, path::Path};

use pulldown_cmark::{Event, Parser, Tag, TagEnd};

/// The folder of pictures, next to the page.
const FOLDER: &str = "pictures/";

/// A picture from the folder of pictures.
#[derive(Debug)]
pub(crate) struct Picture {
    /// The name of its file.
    pub(crate) name: String,
    /// What it says to those who do not see it.
    alt: String,
}

/// Returns the pictures from `pictures/` that a page shows, in order.
pub(crate) fn pictures(page: &str) -> Vec<Picture> {
    let mut pictures: Vec<Picture> = Vec::new();
    let mut open = false;
    for event in Parser::new(page) {
        match event {
            Event::Start(Tag::Image { dest_url, .. }) => {
                if let Some(name) = dest_url.strip_prefix(FOLDER) {
                    pictures.push(Picture { name: name.to_owned(), alt: String::new() });
                    open = true;
                }
            }
            Event::End(TagEnd::Image) => open = false,
            Event::Text(text) | Event::Code(text) if open => {
                if let Some(picture) = pictures.last_mut() {
                    picture.alt.push_str(&text);
                }
            }
            _ => {}
        }
    }
    pictures
}

impl Picture {
    /// Compares the picture beside `page` with the one that the commands of the page wrote in
    /// `folder`. If `bless` is set, the latter replaces the former.
    pub(crate) fn compare(&self, page: &Path, folder: &Path, bless: bool) -> Result<(), String> {
        let Self { name, alt } = self;
        if alt.trim().is_empty() {
            return Err(format!("{name} has no text that says what is seen"));
        }
        let made = fs::read(folder.join(name))
            .map_err(|_| format!("no command of the page writes {name}"))?;
        let shown = page.with_file_name(FOLDER).join(name);
        match fs::read(&shown) {
            Ok(bytes) if bytes == made => Ok(()),
            _ if bless => replace(&shown, &made).map_err(|error| format!("{name}: {error}")),
            Ok(_) => Err(format!(
                "{name} is not the file that the commands of the page write; TAUTLINE_BLESS=1 \
                 copies it into the guide"
            )),
            Err(error) => {
                Err(format!("{name}: {error}; TAUTLINE_BLESS=1 copies it into the guide"))
            }
        }
    }
}

/// Writes a file in one step: an interrupted run leaves the old one.
fn replace(path: &Path, bytes: &[u8]) -> std::io::Result<()> {
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let fresh = path.with_extension("new");
    fs::write(&fresh, bytes)?;
    fs::rename(fresh, path)
}
