//! Plans, blocks and their merging.

mod blocks;
mod merging;
mod plans;
mod rows;
mod tables;

use tautline_problem::sweep::{Plan, Runner};

/// A sweep of this section over problems with the parameters `height`, `x`, `y` and `twice`, which is
/// twice the height.
fn file(sweep: &str) -> String {
    format!(
        "[parameters]\nheight = 1\nx = -2\ny = 0.1\ntwice = \"2*height\"\n\n[metric]\n\
         cost = \"1 + height*exp(-(x1^2 + x2^2))\"\n\n[from]\npoint = [\"x\", \"y\"]\n\n[to]\n\
         ball = {{ centre = [2, 0], radius = \"twice/4\" }}\n\n[solve]\nn = 16\n\n[sweep]\n{sweep}\n"
    )
}

fn plan(sweep: &str) -> Plan {
    Plan::read(&file(sweep)).unwrap_or_else(|error| panic!("{sweep}: {error}"))
}

/// Returns the results of all problems, by one thread.
fn whole(plan: &Plan) -> String {
    let runner = Runner::new(plan, 1).expect("a thread");
    runner.solved(0..plan.count()).expect("results")
}
