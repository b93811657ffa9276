//! Times to prove the constants of the gallery.

use tautline::Quantity;

use crate::{
    Failure,
    artefact::{Artefact, Times},
    certified::{accuracy, gallery},
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "certified_times",
    "the time to prove the constants of the gallery to the tolerance of certified_constants, on \
     the machine that wrote the file",
    data,
    layout,
)
.timed(Times::Unchecked);

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("metric d quantity", Tolerance::Exact),
        ("boxes seconds microseconds_per_box threads", Tolerance::Free),
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
        "metric & $D$ & constant & boxes & seconds & $\\mu$s a box",
    );
    for row in data.rows() {
        let mut cells = row.texts("metric d quantity boxes");
        cells.push(scientific(row.number("seconds"), 2));
        cells.extend(row.texts("microseconds_per_box"));
        layout.push(cells);
    }
    Ok(layout)
}
