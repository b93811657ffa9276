//! The time limit is kept, and what is known by then is reported.

use std::time::{Duration, Instant};

use crate::program::{file, run, with_status};

#[test]
fn a_time_limit_is_kept_and_what_is_known_is_reported() {
    let start = Instant::now();
    // All laws in twelve dimensions take minutes with so many samples.
    let ran = run(&[&file("wrong_c1"), "--json", "--time-limit", "0.7", "--cases", "20000"]);
    // A busy machine takes a while to start a program.
    assert!(start.elapsed() < Duration::from_secs(3), "{:?}", start.elapsed());
    let audit = ran.json();
    let untried = with_status(&audit, "not_tried");
    assert!(untried.contains(&"theorem_1_1"), "{untried:?}");
    let laws = audit["laws"].as_array().expect("an array");
    let law = laws.iter().find(|law| law["law"] == "theorem_1_1").expect("a law");
    assert_eq!(law["reason"], "time ran out");
    assert_eq!(ran.code, 1);
}
