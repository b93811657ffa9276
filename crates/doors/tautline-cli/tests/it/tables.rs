//! Files with tables of numbers, found from the folder of the problem file.

use std::{fs, path::Path};

use crate::{folder, tautline, text};

const FILE: &str = "\
[tables]
h = { file = \"data/h.npy\" }
[metric]
cost = \"1 + h(x1, x2)\"
[from]
point = [0, 0]
[to]
point = [2, 1]
[solve]
n = 32
";

/// Writes a problem with a table of three rows to a folder in this one.
fn problem(folder: &Path, file: &str) {
    let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (3, 2), }\n";
    let length = (header.len() as u16).to_le_bytes();
    let npy = [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), &[1, 2, 3, 4, 2, 1]].concat();
    fs::create_dir_all(folder.join("in/data")).expect("a folder");
    fs::write(folder.join("in/data/h.npy"), npy).expect("written");
    fs::write(folder.join("in/problem.toml"), file).expect("written");
}

#[test]
fn a_table_in_a_file_is_the_same_as_its_numbers_in_the_problem() {
    let folder = folder("tables");
    problem(&folder, FILE);
    let inline = FILE.replace("file = \"data/h.npy\"", "values = [[1, 2], [3, 4], [2, 1]]");
    fs::write(folder.join("inline.toml"), inline).expect("written");
    let answer = |file: &str| {
        let output = tautline(&folder, &["solve", file]);
        assert!(output.status.success(), "{}", text(&output.stderr));
        text(&output.stdout)
    };
    assert_eq!(answer("in/problem.toml"), answer("inline.toml"));
}

#[test]
fn a_sweep_finds_its_tables_too() {
    let folder = folder("sweep_of_tables");
    let sweep = "[sweep.vary]\na = { from = 1, to = 2, count = 3 }\n";
    problem(&folder, &format!("[parameters]\na = 1\n{}{sweep}", FILE.replace("1 + h", "a + h")));
    for arguments in [
        &["plan", "in/problem.toml", "-o", "in/plan.csv"][..],
        &["run", "in/plan.csv", "--to", "results"],
        &["merge", "results", "-o", "results.csv"],
    ] {
        let output = tautline(&folder, arguments);
        assert!(output.status.success(), "{arguments:?}: {}", text(&output.stderr));
    }
    let results = fs::read_to_string(folder.join("results.csv")).expect("results");
    assert_eq!(results.matches(",solved,").count(), 3, "{results}");
    // Another table under the same name is noticed before anything is solved.
    let table = folder.join("in/data/h.npy");
    let mut bytes = fs::read(&table).expect("a table");
    *bytes.last_mut().expect("a number") += 1;
    fs::write(&table, bytes).expect("written");
    let output = tautline(&folder, &["run", "in/plan.csv", "--to", "others"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(text(&output.stderr).contains("a file with its tables was changed"));
}

#[test]
fn a_table_that_is_not_there_is_underlined() {
    let folder = folder("no_table");
    problem(&folder, &FILE.replace("h.npy", "g.npy"));
    let output = tautline(&folder, &["solve", "in/problem.toml"]);
    assert_eq!(output.status.code(), Some(2));
    let said = text(&output.stderr);
    assert!(
        said.contains("error: data/g.npy: ") && said.contains("in/problem.toml:2:14"),
        "{said}"
    );
    assert!(said.contains("^^^^^^^^^^^^"), "{said}");
}
