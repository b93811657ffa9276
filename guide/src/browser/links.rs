//! Compares links with the pages and anchors that exist.

use std::{collections::BTreeMap, path::Path};

use super::page::Visit;

/// Returns the broken links of the visited pages.
pub(super) fn broken(folder: &Path, visits: &[Visit]) -> Vec<String> {
    let anchors: BTreeMap<&str, &[String]> =
        visits.iter().map(|visit| (visit.url.as_str(), visit.ids.as_slice())).collect();
    let mut found = Vec::new();
    for visit in visits {
        for link in &visit.links {
            let Some(path) = link.to.to_file_path().ok().filter(|_| link.to.scheme() == "file")
            else {
                continue;
            };
            let why = if !path.starts_with(folder) {
                "leaves the folder"
            } else if !path.is_file() {
                "no such file"
            } else if let Some(ids) = anchors.get(link.to.as_str())
                && !link.anchor.is_empty()
                && !ids.contains(&link.anchor)
            {
                "no such anchor"
            } else {
                continue;
            };
            let line = format!("{}: link to {}: {why}", visit.name(folder), link.text);
            if !found.contains(&line) {
                found.push(line);
            }
        }
    }
    found
}
