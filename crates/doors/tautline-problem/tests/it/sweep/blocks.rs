//! Blocks of results that were cut or changed.

use tautline_problem::sweep::{Block, BlockError, BlockWriter, Head, Plan, Runner, in_order};

use super::{plan, whole};

#[test]
fn a_block_says_what_it_is() {
    let plan = plan("vary = { height = [1, 2, 3, 4] }");
    let text = Runner::new(&plan, 1).expect("a thread").solved(1..3).expect("results");
    let block = Block::read(&text).expect("a block");
    assert_eq!((block.head.ids.clone(), block.head.count), (1..3, 4));
    assert_eq!(block.head.plan, plan.hash());
    assert_eq!(block.rows.lines().count(), 2);
    assert!(plan.has(&block.head, 1..3));
    assert!(!plan.has(&block.head, 0..3) && !plan.has(&block.head, 1..4));
    let other = super::plan("vary = { height = [1, 2, 3, 5] }");
    assert!(!other.has(&block.head, 1..3));
    assert!(Runner::new(&plan, 1).expect("a thread").solved(3..5).is_err());
}

/// A file counts as done, and is merged, only if its head names this plan, these ids and this version. A
/// right hash does not help a file with another head.
#[test]
fn results_count_as_done_only_if_every_line_of_their_head_agrees() {
    let plan = plan("vary = { height = [1, 2, 3, 4] }");
    let text = Runner::new(&plan, 1).expect("a thread").solved(1..3).expect("results");
    let head = Block::read(&text).expect("a block").head;
    assert!(plan.has(&head, 1..3));
    type Change = fn(&mut Head);
    let changes: [(&str, Change); 9] = [
        ("version", |head| head.version += "1"),
        ("an empty version", |head| head.version.clear()),
        ("plan", |head| head.plan.replace_range(..1, "x")),
        ("the end of the plan", |head| head.plan.replace_range(63.., "x")),
        ("number of problems", |head| head.count += 1),
        ("first id", |head| head.ids.start += 1),
        ("end of the ids", |head| head.ids.end += 1),
        ("columns", |head| head.columns += ",more"),
        ("their order", |head| {
            head.columns = head.columns.replace("length,length_error", "length_error,length")
        }),
    ];
    for (what, change) in changes {
        let mut other = head.clone();
        change(&mut other);
        assert_ne!(other, head, "{what}");
        assert!(!plan.has(&other, 1..3), "{what}");
        let (mut writer, begin) = BlockWriter::new(&other);
        let written = begin
            + &writer.rows(Block::read(&text).expect("a block").rows.to_owned())
            + &writer.end();
        if let Ok(block) = Block::read(&written) {
            assert!(!plan.has(&block.head, 1..3), "{what}");
        }
        if other.ids == head.ids {
            assert!(in_order(&[head.clone(), other]).is_err(), "{what}");
        }
    }
    // The parameters, the metric, the sets, the grid and the rule are all in the hash of the plan.
    let sweep = "vary = { height = [1, 2, 3, 4] }";
    for (from, to) in [
        ("y = 0.1", "y = 0.2"),
        ("height*exp(", "height*exp(0+"),
        ("centre = [2, 0]", "centre = [3, 0]"),
        ("n = 16", "n = 17"),
        ("n = 16", "n = 16\nrule = \"left_endpoint\""),
        ("[1, 2, 3, 4]", "[1, 2, 3, 4.5]"),
        ("[sweep]", "[sweep]\nseed = 2"),
    ] {
        let changed = super::file(sweep).replace(from, to);
        assert_ne!(changed, super::file(sweep));
        let other = Plan::read(&changed).expect(to);
        assert!(!other.has(&head, 1..3), "{to}");
    }
}

#[test]
fn no_byte_of_a_block_can_be_changed_or_be_missing() {
    let text = whole(&plan("vary = { height = [1, 2] }"));
    for at in 0..text.len() {
        let mut bytes = text.clone().into_bytes();
        bytes[at] = if bytes[at] == b'1' { b'0' } else { b'1' };
        let changed = String::from_utf8(bytes).expect("ASCII");
        assert!(Block::read(&changed).is_err(), "byte {at} is now {:?}", &changed[at..=at]);
        assert!(Block::read(&text[..at]).is_err(), "{at} bytes are complete");
    }
    for (more, error) in [("\n", BlockError::Incomplete), ("1,2\n", BlockError::Incomplete)] {
        assert_eq!(Block::read(&format!("{text}{more}")), Err(error));
    }
    assert!(matches!(Block::read("id,x\n1,2\n"), Err(BlockError::NoResults { line: 1, .. })));
}

/// The hash of these blocks is right: they were written with other rows.
#[test]
fn the_ids_of_a_block_are_those_of_its_head_in_their_order() {
    let text = whole(&plan("vary = { height = [1, 2, 3] }"));
    let block = Block::read(&text).expect("a block");
    let lines: Vec<&str> = block.rows.lines().collect();
    let of = |rows: &[usize]| {
        let (mut writer, head) = BlockWriter::new(&block.head);
        let rows = rows.iter().map(|&i| lines[i].to_owned() + "\n").collect();
        head + &writer.rows(rows) + &writer.end()
    };
    assert_eq!(of(&[0, 1, 2]), text);
    for (rows, row) in [
        (&[0, 2, 1][..], 2),
        (&[0, 1], 3),
        (&[0, 1, 2, 2], 4),
        (&[1, 2], 1),
        (&[0, 0, 1, 2], 2),
        (&[], 1),
    ] {
        let error = Block::read(&of(rows)).map(|_| ()).expect_err("refused");
        assert!(matches!(error, BlockError::Id { row: found, .. } if found == row), "{error}");
    }
}
