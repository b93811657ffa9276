//! Reads the name and the dependencies from a `Cargo.toml`. It is not a TOML parser; it knows only
//! the two ways in which the manifests here are written.

use std::path::Path;

/// The name of a package and its dependencies.
#[derive(Debug, Default, PartialEq)]
pub(super) struct Manifest {
    pub(super) name: String,
    /// The names in `[dependencies]` and `[build-dependencies]`, for any target.
    pub(super) dependencies: Vec<String>,
    pub(super) dev_dependencies: Vec<String>,
}

impl Manifest {
    pub(super) fn read(path: &Path) -> Self {
        Self::parse(&super::read(path))
    }

    fn parse(text: &str) -> Self {
        let mut manifest = Self::default();
        let mut table = String::new();
        for line in text.lines().map(str::trim) {
            if let Some(header) = line.strip_prefix('[') {
                table = header.trim_matches(['[', ']']).to_owned();
                // [dependencies.name]
                if let Some((head, name)) = table.rsplit_once('.')
                    && head.ends_with("dependencies")
                {
                    let (head, name) = (head.to_owned(), name.to_owned());
                    manifest.add(&head, name);
                    table.clear();
                }
            } else if let Some((key, value)) = line.split_once('=')
                && !line.starts_with('#')
            {
                // name.workspace = true, or name = "…"
                let key = key.trim().split('.').next().unwrap_or_default().trim_matches('"');
                if table == "package" && key == "name" {
                    value.trim().trim_matches('"').clone_into(&mut manifest.name);
                } else {
                    manifest.add(&table, key.to_owned());
                }
            }
        }
        manifest
    }

    fn add(&mut self, table: &str, name: String) {
        if table.ends_with("dev-dependencies") {
            self.dev_dependencies.push(name);
        } else if table.ends_with("dependencies") {
            self.dependencies.push(name);
        }
    }

    /// Returns the dependencies of all tables.
    pub(super) fn all(&self) -> impl Iterator<Item = &str> {
        self.dependencies.iter().chain(&self.dev_dependencies).map(String::as_str)
    }
}

#[test]
fn both_ways_to_write_a_dependency_are_read() {
    let manifest = Manifest::parse(
        "[package]\nname = \"a\"\n[dependencies]\nb.workspace = true\n# c = \"1\"\n\
         d = { path = \"x\" }\n[dependencies.e]\nversion = \"1\"\n[dev-dependencies]\n\
         f.workspace = true\n[target.'cfg(unix)'.dependencies]\ng = \"1\"\n[features]\nh = []\n",
    );
    assert_eq!(manifest.name, "a");
    assert_eq!(manifest.dependencies, ["b", "d", "e", "g"]);
    assert_eq!(manifest.dev_dependencies, ["f"]);
    assert_eq!(manifest.all().collect::<Vec<_>>(), ["b", "d", "e", "g", "f"]);
}
