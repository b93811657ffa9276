//! How often each method finds the shortest way through random obstacles, and what it needs.

use crate::{
    Failure,
    artefact::{Artefact, Seed},
    data::{Data, Row, Tolerance},
    layout::Layout,
    methods::{
        Method,
        random::{METHODS, N, SEED, errors_by_group},
    },
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "failure_rates",
    "how far each method is from the shortest curve that any of them finds, on random fields of \
     obstacles in 2, 3 and 6 dimensions, and what it needs and can do",
    data,
    layout,
)
.seeded(Seed::One(SEED));

/// The relative errors up to which an answer is counted as near, and as nearer.
const NEAR: [f64; 2] = [1e-3, 1e-2];

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    // Beside a ridge of the energy, or in a shot that winds through the obstacles, a last bit decides
    // where a search goes: a problem or two of a group may change sides on another machine.
    let count = Tolerance::Close { relative: 0.0, absolute: 2.0 };
    let mut data = Data::new(&[
        ("group number method derivatives lattice sets certificate", Tolerance::Exact),
        ("within_1e-3 within_1e-2 farther none", count),
    ]);
    for (group, problems) in errors_by_group()? {
        for (k, method) in METHODS.into_iter().enumerate() {
            let errors: Vec<Option<f64>> = problems.iter().map(|errors| errors[k]).collect();
            let found = || errors.iter().flatten().map(|error| error.abs());
            let [nearer, near] = NEAR.map(|limit| found().filter(|error| *error <= limit).count());
            let farther = found().count() - near;
            let counts = [nearer, near - nearer, farther, errors.len() - found().count()];
            let traits = method.traits();
            let yes = |does: bool| if does { "yes" } else { "" }.to_owned();
            let mut row = vec![group.name(), errors.len().to_string()];
            row.extend([method.name().to_owned(), traits.derivatives.to_owned()]);
            row.extend([traits.lattice, traits.sets, traits.certificate].map(yes));
            row.extend(counts.map(|count| count.to_string()));
            data.push(row);
        }
    }
    check(&data)?;
    Ok(data)
}

/// Among few obstacles the solver must find the shortest curve from its own starts, and among many from
/// those of classes, where there is a lattice; one problem may have two curves that are as short but
/// for the grid. Among many its own starts are too few.
fn check(data: &Data) -> Result<(), Failure> {
    let must = |row: &Row<'_>| {
        let (group, method) = (row.text("group"), row.text("method"));
        method == Method::Trapezoidal.name() && group.starts_with("4 ")
            || method == Method::Classes.name() && !group.ends_with("D = 6")
    };
    for row in data.rows().filter(must) {
        let missed = row.number("farther") + row.number("none");
        if !(missed <= 1.0) {
            let (group, method) = (row.text("group"), row.text("method"));
            return Err(Failure::Violated(format!("{group}: {method} misses {missed} problems")));
        }
    }
    Ok(())
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let numbers: Vec<&str> = data
        .rows_with("method", Method::Trapezoidal.name())
        .map(|row| row.text("number"))
        .collect();
    let numbers = numbers.join(", ");
    let caption = format!(
        "What each method needs and can do, and on how many of {numbers} random fields of obstacles \
         its distance is within $10^{{-3}}$ of the shortest that is known, within $10^{{-2}}$, \
         farther, or missing. Sequences have {N} chords, which alone leave an error up to $10^{{-3}}$ by the \
         trapezoidal and up to $10^{{-2}}$ by the left-endpoint rule. Derivatives are those of $H$, \
         or the Christoffel symbols $Γ$ with their derivatives. Certificates exist in up to four \
         dimensions. Shots have the tolerance $10^{{-6}}$."
    );
    let mut layout = Layout::new(
        caption,
        "method & derivatives & lattice & between sets & certificate & few, $D = 2$ & many, \
         $D = 2$ & few, $D = 3$ & few, $D = 6$",
    );
    for method in METHODS {
        let rows: Vec<_> = data.rows_with("method", method.name()).collect();
        let Some(first) = rows.first() else { continue };
        let mut cells = vec![method.name().to_owned()];
        let needs = first.texts("derivatives lattice sets certificate");
        cells.extend(needs.iter().map(|text| crate::layout::or_dash(text)));
        for row in &rows {
            cells.push(row.texts("within_1e-3 within_1e-2 farther none").join(", "));
        }
        layout.push(cells);
    }
    Ok(layout)
}
