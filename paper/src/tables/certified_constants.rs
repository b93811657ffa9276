//! The constants of the gallery, stated and proved.

use tautline::Quantity;

use crate::{
    Failure,
    artefact::Artefact,
    certified::{Certified, Found, accuracy, gallery},
    data::{Data, Tolerance},
    layout::Layout,
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "certified_constants",
    "the constants of the gallery, stated and with the bounds that its formulas prove; on all of \
     space, by periods or because the metric settles, or on a ball",
    data,
    layout,
);

/// With another library of elementary functions, the search takes another path to equally close
/// bounds.
const BOUND: Tolerance = Tolerance::relative(1e-3);
const BOXES: Tolerance = Tolerance::Close { relative: 0.25, absolute: 20.0 };

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("metric d quantity", Tolerance::Exact),
        ("stated", Tolerance::relative(1e-12)),
        ("certified_lower certified_upper", BOUND),
        ("boxes", BOXES),
        ("stated_is on", Tolerance::Exact),
    ]);
    for metric in gallery()? {
        for (quantity, (stated, exact)) in Quantity::ALL.into_iter().zip(metric.stated) {
            let found = metric.find(quantity, accuracy(quantity))?;
            agrees(&metric, quantity, (stated, exact), &found)?;
            data.push([
                metric.metric.to_owned(),
                metric.d.to_string(),
                quantity.to_string(),
                stated.to_string(),
                found.lower.to_string(),
                found.upper.to_string(),
                found.boxes.to_string(),
                if exact { "exact" } else { "a bound" }.to_owned(),
                metric.on.clone(),
            ]);
        }
    }
    Ok(data)
}

/// Refuses a stated constant that contradicts the bounds, and bounds that are too far apart.
fn agrees(
    metric: &Certified,
    quantity: Quantity,
    (stated, exact): (f64, bool),
    found: &Found,
) -> Result<(), Failure> {
    // A closed form is evaluated in doubles, with a few roundings.
    let (below, above) = (stated * (1.0 - 1e-14), stated * (1.0 + 1e-14));
    let holds = match (exact, quantity) {
        (true, _) => found.lower <= above && below <= found.upper,
        (false, Quantity::C1) => below <= found.upper,
        (false, _) => found.lower <= above,
    };
    // In three dimensions, the bounds on L_H and M_H overestimate unless the metric is a multiple
    // of the identity.
    let limit = match quantity {
        Quantity::C1 | Quantity::C2 => 1.0011,
        Quantity::LH => 1.0021,
        Quantity::MH => 1.02,
    };
    let close = found.upper <= found.lower * limit;
    if holds && close {
        return Ok(());
    }
    let (name, d) = (metric.metric, metric.d);
    Err(Failure::Violated(format!(
        "{quantity} of {name}, D = {d}: stated {stated}, proved between {} and {}",
        found.lower, found.upper
    )))
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Constants of the gallery, stated and with the bounds that the formula proves. A stated \
         constant that is only a bound need not lie between them.",
        "metric & $D$ & constant & stated &  & proved from & to & boxes & on",
    );
    for row in data.rows() {
        let digits = |name: &str| format!("{:.6}", row.number(name));
        layout.push([
            row.text("metric").to_owned(),
            row.text("d").to_owned(),
            match row.text("quantity") {
                "c1" => "$c_1$",
                "c2" => "$c_2$",
                "L_H" => "$L_H$",
                _ => "$M_H$",
            }
            .to_owned(),
            digits("stated"),
            row.text("stated_is").to_owned(),
            digits("certified_lower"),
            digits("certified_upper"),
            row.text("boxes").to_owned(),
            row.text("on").to_owned(),
        ]);
    }
    Ok(layout)
}
