//! The table of a plan, read back and changed.

use tautline_problem::sweep::{Plan, PlanError, TableHead};

use super::{file, plan};

const SWEEP: &str = "vary = { height = [1, 2.5e-9], y = { from = -1, to = 1, count = 4 }, x = { uniform = [-3, -2] } }";

/// Reads the lines of a head.
fn read<'l>(lines: impl IntoIterator<Item = &'l str>) -> Result<Plan, PlanError> {
    let mut head = TableHead::default();
    for line in lines {
        if let Some(plan) = head.line(line, &mut |_| unreachable!("no tables"))? {
            return Ok(plan);
        }
    }
    Err(PlanError::NoPlan { line: 0, expected: "more lines".to_owned() })
}

/// Line ends are `\n`, whatever they were: a table is read line by line.
#[test]
fn a_table_has_its_sweep_file_byte_by_byte() {
    let file = file(SWEEP);
    let hash = plan(SWEEP).hash().to_owned();
    for file in [
        file.clone(),
        file.trim_end().to_owned(),
        file.clone() + "\n  # blanks, and an empty line \n\n",
        file.replace("[metric]", "#| not the mark of a table\n[metric]"),
    ] {
        let plan = Plan::read(&file).expect("a plan");
        let head = plan.head();
        assert!(TableHead::begins(&head) && !TableHead::begins(&file));
        let again = read(head.split('\n')).expect("the same plan");
        assert_eq!((again.file(), again.hash()), (file.as_str(), plan.hash()));
        assert_eq!(again.lines(0..8), plan.lines(0..8));
        assert_eq!(Plan::of_text(&file).expect("a plan").hash(), plan.hash());
    }
    let windows = file.replace('\n', "\r\n");
    for other in [&windows, &format!("\u{feff}{file}"), &format!("\u{feff}{windows}")] {
        let plan = Plan::read(other).expect("a plan");
        assert_eq!((plan.file(), plan.hash()), (file.as_str(), hash.as_str()));
        let again = read(plan.head().lines()).expect("the same plan");
        assert_eq!((again.file(), again.hash()), (file.as_str(), hash.as_str()));
        // The place of an error is one in the text that comes with it.
        let wrong = other.replace("[metric]", "[metrics]");
        let Err(PlanError::File { diagnostic, file }) = Plan::read(&wrong) else {
            panic!("a plan")
        };
        assert_eq!(&file[diagnostic.at], "metrics");
    }
}

/// A table that another system has saved is that of its plan.
#[test]
fn the_line_ends_of_a_table_do_not_count() {
    let plan = plan(SWEEP);
    let table = plan.head() + &plan.lines(0..8).expect("rows");
    let windows = table.replace('\n', "\r\n");
    for other in [&windows, &format!("\u{feff}{table}"), &format!("\u{feff}{windows}")] {
        assert!(TableHead::begins(other));
        assert_eq!(Plan::of_text(other).expect("a plan").hash(), plan.hash());
    }
}

#[test]
fn a_text_is_the_whole_table_or_none() {
    let plan = plan(SWEEP);
    let table = plan.head() + &plan.lines(0..8).expect("rows");
    assert_eq!(Plan::of_text(&table).expect("a plan").file(), plan.file());
    for at in (0..table.len() - 1).filter(|&at| table.is_char_boundary(at)) {
        assert!(Plan::of_text(&table[..at]).is_err(), "{at} bytes are a plan");
    }
    assert!(Plan::of_text(&(table + "8,1.0,0.0,-2.0\n")).is_err());
}

#[test]
fn plans_with_different_files_have_different_hashes() {
    let first = plan(SWEEP);
    assert_ne!(first.hash(), plan(&SWEEP.replace("count = 4", "count = 5")).hash());
    let chords = file(SWEEP).replace("n = 16", "n = 17");
    assert_ne!(first.hash(), Plan::read(&chords).expect("a plan").hash());
}

/// Returns a picture of two by two pixels of this brightness.
fn picture(grey: u8) -> Vec<u8> {
    let mut file = Vec::new();
    let mut writer = png::Encoder::new(&mut file, 2, 2).write_header().expect("a header");
    writer.write_image_data(&[grey; 4]).expect("data");
    writer.finish().expect("an end");
    file
}

/// A picture ends before its file does, so that two pairs of files may be the same bytes in a row.
#[test]
fn the_end_of_one_file_is_not_the_beginning_of_the_next() {
    let tables = "[tables.f]\nfile = \"f.png\"\n[tables.g]\nfile = \"g.png\"\n";
    let text = file(SWEEP).replace("[metric]", &format!("{tables}[metric]"));
    let text = text.replace("\"1 + height*", "\"f(x1, x2) + g(x1, x2) + height*");
    let hash = |f: Vec<u8>, g: Vec<u8>| {
        let mut open = |name: &str| Ok(if name == "f.png" { f.clone() } else { g.clone() });
        Plan::read_with(&text, &mut open).expect("a plan").hash().to_owned()
    };
    let [one, two, three] = [1, 2, 3].map(picture);
    let early = hash(one.clone(), [two.clone(), three.clone()].concat());
    let late = hash([one.clone(), two.clone()].concat(), three.clone());
    assert_ne!(early, late);
    // The rest of a file counts, and each of the two does.
    assert_ne!(hash(one.clone(), two.clone()), early);
    assert_ne!(hash(one.clone(), two.clone()), hash(one.clone(), three));
    assert_eq!(hash(one.clone(), two.clone()), hash(one, two));
}

/// A digit or a letter is changed in each line of the head, one at a time.
#[test]
fn no_line_of_a_head_can_be_changed() {
    let head = plan(SWEEP).head();
    let lines: Vec<&str> = head.lines().collect();
    let mut changed = 0;
    for index in 0..lines.len() {
        let Some(at) = lines[index].rfind(|c: char| c.is_ascii_alphanumeric()) else { continue };
        let mut line = lines[index].to_owned();
        let other = if line[at..].starts_with('1') { "0" } else { "1" };
        line.replace_range(at..=at, other);
        let mut lines = lines.clone();
        lines[index] = &line;
        assert!(read(lines).is_err(), "{line}");
        changed += 1;
    }
    assert!(changed > 15, "{changed} lines");
    // A line of the file that is missing, and one that is new.
    for with in [&[][..], &["#| # one line more"][..]] {
        let at = lines.iter().position(|line| line.starts_with("#| n = ")).expect("a line");
        let lines: Vec<&str> = [&lines[..at + with.len()], with, &lines[at + 1..]].concat();
        assert!(matches!(read(lines), Err(PlanError::Hash { .. })), "{with:?}");
    }
}

#[test]
fn rows_read_back_exactly_and_cannot_be_changed() {
    let plan = plan(SWEEP);
    for id in 0..plan.count() {
        let line = plan.line(id);
        let mut fields = line.split(',');
        assert_eq!(fields.next(), Some(id.to_string().as_str()));
        let values: Vec<u64> =
            fields.map(|field| field.parse::<f64>().expect("a number").to_bits()).collect();
        let expected: Vec<u64> = plan.row(id).into_iter().map(f64::to_bits).collect();
        assert_eq!(values, expected, "{line}");
        assert_eq!(plan.check_line(id, Some(&line)), Ok(()));
        assert!(plan.check_line(id, Some(&plan.line((id + 1) % 8))).is_err());
        assert!(plan.check_line(id, Some(&format!("{line}0"))).is_err());
        assert!(plan.check_line(id, None).is_err());
    }
    assert_eq!(plan.check_line(8, None), Ok(()));
    assert!(plan.check_line(8, Some("8,1,1,1")).is_err());
    assert!(plan.lines(7..8).is_ok() && plan.lines(7..9).is_err());
}
