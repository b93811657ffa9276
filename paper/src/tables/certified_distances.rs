//! Distances over the gallery, with certificates.

use tautline::{check::Verdict, distance::Ended};

use crate::{
    Failure,
    artefact::{Artefact, Times},
    certificates::{Pair, pairs},
    data::{Data, Tolerance},
    layout::{Layout, or_dash, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "certified_distances",
    "certificates of distances over the gallery: the bounds, the distance where it is known in closed \
     form, and the time to find and to check them on the machine that wrote the file",
    data,
    layout,
)
.timed(Times::Unchecked);

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("metric d from to gap_wanted", Tolerance::Exact),
        ("gap lower upper known cubes bytes ended", Tolerance::Free),
        ("search_seconds check_seconds threads", Tolerance::Free),
    ]);
    let threads = std::thread::available_parallelism().map_or(1, usize::from);
    for pair in pairs()? {
        let Pair { metric, d, known, gap, ends: [from, to], .. } = &pair;
        let mut row = vec![(*metric).to_owned(), d.to_string(), joined(from), joined(to)];
        row.push(format!("{gap:e}"));
        match pair.search()? {
            Ok(found) => {
                let Verdict { lower, upper, gap, .. } = found.verdict;
                let text = |number: Option<f64>| number.map_or(String::new(), |x| x.to_string());
                row.push(gap.map_or(String::new(), |gap| format!("{gap:.1e}")));
                row.extend([lower.to_string(), text(upper), text(*known)]);
                row.extend([found.cubes.to_string(), found.text.len().to_string()]);
                row.push(found.ended.map_or("the gap is reached", reason).to_owned());
                row.extend([found.search_seconds, found.check_seconds].map(|s| format!("{s:.2e}")));
            }
            Err(error) => {
                row.extend(vec![String::new(); 6]);
                row.push(error);
                row.extend(vec![String::new(); 2]);
            }
        }
        row.push(threads.to_string());
        data.push(row);
    }
    Ok(data)
}

fn joined(point: &[f64]) -> String {
    point.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn reason(ended: Ended) -> &'static str {
    match ended {
        Ended::Stalled => "the gap no longer falls",
        Ended::TooManyCubes => "too many cubes",
        Ended::TooFar => "too far from the origin",
        Ended::TooMuchWork => "too much work to check",
        _ => "stopped",
    }
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Certified distances over the gallery: no curve is shorter than the lower bound, and one has at \
         most the length of the upper bound. The last columns are the cubes of all levels, the kilobytes \
         of the certificate, and the seconds to find and to check it.",
        "metric & $D$ & gap & lower & upper & known & ended & cubes & kB & find & check",
    );
    for row in data.rows() {
        let mut cells = row.texts("metric d");
        cells.push(scientific(row.number("gap"), 1));
        // Outward, so that what is printed is true.
        let outward = |value: f64, round: fn(f64) -> f64| {
            if value.is_nan() { String::new() } else { format!("{:.6}", round(value * 1e6) / 1e6) }
        };
        cells.push(or_dash(&outward(row.number("lower"), f64::floor)));
        cells.push(or_dash(&outward(row.number("upper"), f64::ceil)));
        let known = row.number("known");
        cells.push(if known.is_nan() { or_dash("") } else { format!("{known:.6}") });
        cells.push(row.text("ended").to_owned());
        cells.push(or_dash(row.text("cubes")));
        let kilobytes = row.number("bytes") / 1e3;
        cells.push(if kilobytes.is_nan() { or_dash("") } else { format!("{kilobytes:.0}") });
        cells.push(scientific(row.number("search_seconds"), 1));
        cells.push(scientific(row.number("check_seconds"), 1));
        layout.push(cells);
    }
    Ok(layout)
}
