//! Blocks become one table only if every problem is there once.

use tautline_chance::{Random, cases, seed};
use tautline_problem::sweep::{Block, Head, MergeError, Runner, in_order, merged};

use super::{plan, whole};

fn head(start: u64, end: u64) -> Head {
    Head {
        version: "0.1.0".to_owned(),
        plan: "a".repeat(64),
        count: 10,
        ids: start..end,
        columns: "id,x".to_owned(),
    }
}

fn heads(ids: &[(u64, u64)]) -> Vec<Head> {
    ids.iter().map(|&(start, end)| head(start, end)).collect()
}

/// Blocks of random sizes in a random order, some of them empty.
#[test]
fn any_blocks_that_cover_the_plan_give_the_same_bytes() {
    let plan = plan("vary = { height = [1, 2], y = { from = -1, to = 1, count = 7 } }");
    let (expected, count) = (whole(&plan), plan.count());
    let runner = Runner::new(&plan, 2).expect("threads");
    let mut random = Random(seed(20_261_126));
    for _ in 0..cases(20) {
        let mut cuts: Vec<u64> =
            (0..random.bits() % 6).map(|_| random.bits() % (count + 1)).collect();
        cuts.extend([0, count]);
        cuts.sort_unstable();
        let mut texts: Vec<String> =
            cuts.windows(2).map(|ids| runner.solved(ids[0]..ids[1]).expect("results")).collect();
        for i in (1..texts.len()).rev() {
            texts.swap(i, (random.bits() % (i as u64 + 1)) as usize);
        }
        let blocks: Vec<Block<'_>> =
            texts.iter().map(|text| Block::read(text).expect("a block")).collect();
        assert_eq!(merged(&blocks).expect("a table"), expected, "{cuts:?}");
    }
}

#[test]
fn what_is_missing_or_doubled_is_named() {
    for (blocks, message) in [
        (&[(0, 4)][..], "ids 4 to 9 are missing"),
        (&[(4, 10)], "ids 0 to 3 are missing"),
        (&[(0, 3), (4, 10)], "ids 3 to 3 are missing"),
        (&[(0, 4), (4, 10), (0, 4)], "ids 0 to 3 are both in block 1 and in block 3"),
        (&[(0, 4), (3, 10)], "ids 3 to 3 are both in block 1 and in block 2"),
        (&[(0, 10), (4, 6)], "ids 4 to 5 are both in block 1 and in block 2"),
        (
            &[(0, 10), (4, 6), (5, 7)],
            "ids 4 to 5 are both in block 1 and in block 2\nids 5 to 6 are both in block 1 and in block 3",
        ),
        (
            &[(6, 8), (1, 3), (2, 3)],
            "ids 0 to 0 are missing\nids 3 to 5 are missing\nids 8 to 9 are missing\nids 2 to 2 are both in block 2 and in block 3",
        ),
        (&[(0, 0)], "ids 0 to 9 are missing"),
    ] {
        let error = in_order(&heads(blocks)).expect_err(message);
        assert_eq!(error.to_string(), message, "{blocks:?}");
    }
    assert_eq!(in_order(&heads(&[(4, 10), (2, 2), (0, 4)])), Ok(vec![2, 0]));
    assert_eq!(in_order(&[]), Err(MergeError::Nothing));
    // Of very many, the first ones are listed.
    let many: Vec<Head> =
        (0..100).map(|k| Head { count: 200, ids: 2 * k..2 * k + 1, ..head(0, 0) }).collect();
    let message = in_order(&many).expect_err("gaps").message(|block| format!("{block}.csv"));
    assert!(message.starts_with("ids 1 to 1 are missing\n"), "{message}");
    assert!(message.ends_with("and 80 more such ranges") && message.lines().count() == 21);
}

#[test]
fn blocks_of_other_plans_or_versions_are_refused() {
    let good = [head(0, 4), head(4, 10)];
    assert_eq!(in_order(&good), Ok(vec![0, 1]));
    type Change = fn(&mut Head);
    let changes: [(&str, Change); 4] = [
        ("plan", |head| head.plan = "b".repeat(64)),
        ("version", |head| head.version = "0.2.0".to_owned()),
        ("columns", |head| head.columns = "id,y".to_owned()),
        ("number of problems", |head| head.count = 11),
    ];
    for (what, change) in changes {
        let mut heads = good.clone();
        change(&mut heads[1]);
        let error = in_order(&heads).expect_err(what).message(|block| format!("{block}.csv"));
        assert!(error.starts_with(&format!("2.csv has the {what} ")), "{error}");
        assert!(error.contains(", but 1.csv has "), "{error}");
    }
}
