//! How long it takes to prove the constants of the gallery.

use tautline::Quantity;

use super::{Layout, Seed, Table, layout::scientific, no_pages};
use crate::{
    Failure,
    certified::{accuracy, gallery},
    data::{Data, Tolerance},
    sweep::Sweep,
};

pub(super) const TABLE: Table = Table {
    id: "certified_times",
    shows: "how long it takes to prove the constants of the gallery to the tolerance of \
            certified_constants, on the machine that wrote the file",
    seed: Seed::None,
    data,
    layout,
    repeatable: false,
    pages: no_pages,
};

const TIME: Tolerance = Tolerance::Free;

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("metric", Tolerance::Exact),
        ("d", Tolerance::Exact),
        ("quantity", Tolerance::Exact),
        ("boxes", TIME),
        ("seconds", TIME),
        ("microseconds_per_box", TIME),
        ("threads", TIME),
    ]);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    for metric in gallery()? {
        for quantity in Quantity::ALL {
            let found = metric.find(quantity, accuracy(quantity))?;
            let seconds = found.time.as_secs_f64();
            data.push(vec![
                metric.metric.to_owned(),
                metric.d.to_string(),
                quantity.to_string(),
                found.boxes.to_string(),
                format!("{seconds:.2e}"),
                format!("{:.1}", 1e6 * seconds / found.boxes as f64),
                threads.to_string(),
            ]);
        }
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Time to prove the constants of the gallery, in seconds and in microseconds for each box.",
        &["metric", "$D$", "constant", "boxes", "seconds", "$\\mu$s a box"],
    );
    for row in data.rows() {
        layout.push(vec![
            row.text("metric").to_owned(),
            row.text("d").to_owned(),
            row.text("quantity").to_owned(),
            row.text("boxes").to_owned(),
            scientific(row.number("seconds"), 2),
            row.text("microseconds_per_box").to_owned(),
        ]);
    }
    Ok(layout)
}
