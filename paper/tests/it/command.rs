//! Arguments that the commands refuse.

use paper::Failure;
use paper::command::run;

#[test]
fn arguments_that_mean_nothing_are_refused() {
    for arguments in [
        vec!["figures", "--check", "--quick"],
        vec!["figures", "--nope"],
        vec!["figures", "nope"],
        vec!["nope"],
        vec![],
    ] {
        let refused = run(arguments.iter().map(|&a| a.to_owned()));
        assert!(matches!(refused, Err(Failure::Usage(_))), "{arguments:?}");
    }
}
