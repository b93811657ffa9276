//! Every method with one usual setting on the three problems.

use crate::{
    Failure,
    artefact::{Artefact, Times},
    data::Data,
    layout::{Layout, or_dash, scientific},
    methods::{self, Method, problems},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "methods",
    "the relative error of the distance, the steps and the time on one thread, of every method with \
     one usual setting, on three problems whose distance is known",
    data,
    layout,
)
.timed(Times::Free);

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = methods::columns();
    for problem in problems()? {
        for method in Method::ALL {
            let setting = method.usual(problem.dimension);
            data.push(problem.row(method, setting, sweep.repeats));
        }
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Relative error of the distance, steps and time in ms on one thread, of every method: with \
         128 chords, the tolerance $10^{-9}$ for shooting and $10^{-4}$ for collocation, 128 cells \
         along each axis in the plane, 64 for classes, and in space 24 for paths, 32 for marches and \
         16 for classes. An error of more than 0.3 is that of another geodesic; where there is none, \
         the method has no answer. Steps are those of all searches, or the nodes of a lattice that \
         were opened.",
        "method & sphere, $D = 2$: error & steps & ms & stirred, $D = 3$: error & steps & ms & \
         waves, $D = 6$: error & steps & ms",
    );
    for method in Method::ALL {
        let mut cells = vec![method.name().to_owned()];
        for row in data.rows_with("method", method.name()) {
            cells.push(scientific(row.number("error"), 1));
            if row.number("error").is_nan() {
                cells.extend(["–", "–"].map(str::to_owned));
            } else {
                cells.push(or_dash(row.text("steps")));
                cells.push(format!("{:.2}", 1e3 * row.number("seconds")));
            }
        }
        layout.push(cells);
    }
    Ok(layout)
}
