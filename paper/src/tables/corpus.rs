//! How reliably the solver converges: random problems over the gallery, and the Newton steps of
//! each.

use tautline::Rule;

use crate::{
    Failure,
    artefact::{Artefact, Seed},
    corpus::{End, Kind, Outcome, SEED, Search, corpus},
    data::{Data, Tolerance},
    layout::Layout,
    parallel,
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "corpus",
    "random problems over the gallery, by the Newton steps over all grids of the search that led \
     to the result: from the default starts, with which 99.9 % must reach the goal within 60 \
     steps, and from one straight line alone; touch: the sets have a point in common; above: it \
     converged with a decrement above 1e-18 of the energy and a residual above twice its floor; \
     stopped: it reports no convergence, or converged to a saddle; refused: an error",
    data,
    layout,
)
.seeded(Seed::One(SEED));

/// The number of problems, and the number in a quick run.
const PROBLEMS: usize = 2000;
const QUICK: usize = 200;

/// The goal: all problems except one in `ONE_IN` reach a minimiser within `STEPS` steps.
const ONE_IN: usize = 1000;
const STEPS: usize = 60;

/// This many problems may miss the goal. Each has a row, so that every machine has the same number
/// of rows.
const MISSES: usize = PROBLEMS / ONE_IN;

/// The largest number of steps in each column of the histogram except the last.
const BANDS: [usize; 5] = [5, 10, 20, 40, STEPS];

/// The name of a group of problems, and a function that recognises its members.
type Group = (&'static str, fn(&Outcome) -> bool);

const GROUPS: [Group; 10] = [
    ("all", |_| true),
    ("between points", |outcome| outcome.ends == [Kind::Point; 2]),
    ("between sets", |outcome| outcome.ends != [Kind::Point; 2]),
    ("left-endpoint rule", |outcome| outcome.rule == Rule::LEFT_ENDPOINT),
    ("trapezoidal rule", |outcome| outcome.rule == Rule::TRAPEZOIDAL),
    ("D = 1 or 2", |outcome| outcome.dimension <= 2),
    ("D = 3 to 5", |outcome| (3..=5).contains(&outcome.dimension)),
    ("D = 6 to 8", |outcome| outcome.dimension >= 6),
    ("N up to 64", |outcome| outcome.n <= 64),
    ("N above 64", |outcome| outcome.n > 64),
];

/// The tolerance of a number of problems. The elementary functions of another machine may move a
/// few problems to the next column.
const NUMBER: Tolerance = Tolerance::Close { relative: 0.05, absolute: 3.0 };

/// The columns of the histogram: the sets touch, or the goal is reached within this many steps.
const STEPS_TAKEN: &str = "touch steps_1_to_5 steps_6_to_10 steps_11_to_20 steps_21_to_40 \
                           steps_41_to_60 steps_above_60";

const COLUMNS: [(&str, Tolerance); 5] = [
    ("starts problems number", Tolerance::Exact),
    (STEPS_TAKEN, NUMBER),
    ("above stopped refused", NUMBER),
    // The hardest search of all may take another path on another machine.
    ("most_steps", Tolerance::Close { relative: 0.5, absolute: 3.0 }),
    // Which problem misses the goal, and how its search ended.
    ("what", Tolerance::Free),
];

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let cases = corpus(if sweep.quick { QUICK } else { PROBLEMS });
    let outcomes = parallel::map(&cases, |case| case.outcome());
    let outcomes: Vec<Outcome> = outcomes.into_iter().collect::<Result<_, _>>()?;
    if let Some(outcome) =
        outcomes.iter().find(|o| [&o.default, &o.straight].iter().any(|s| s.end == End::NotANumber))
    {
        return Err(Failure::Violated(format!("a number is NaN: {}", describe(outcome))));
    }
    let missed: Vec<&Outcome> =
        outcomes.iter().filter(|outcome| !outcome.default.reached_within(STEPS)).collect();
    if missed.len() * ONE_IN > outcomes.len() {
        let which: Vec<String> = missed.into_iter().map(describe).collect();
        let count = outcomes.len();
        return Err(Failure::Violated(format!(
            "{} of {count} problems miss the goal: {}",
            which.len(),
            which.join("; ")
        )));
    }
    let mut data = Data::new(&COLUMNS);
    for starts in ["default", "straight line"] {
        for (name, is_in) in GROUPS {
            let group = outcomes.iter().filter(|outcome| is_in(outcome));
            let searches: Vec<&Search> = group
                .map(|Outcome { default, straight, .. }| match starts {
                    "default" => default,
                    _ => straight,
                })
                .collect();
            data.push(histogram(starts, name, &searches));
        }
    }
    for k in 0..MISSES {
        let what = missed.get(k).map_or("none".to_owned(), |o| describe(o));
        let mut row = vec!["default".to_owned(), format!("missed {}", k + 1)];
        // The columns of numbers are empty in these rows.
        row.extend(vec![String::new(); BANDS.len() + 7]);
        row.push(what);
        data.push(row);
    }
    Ok(data)
}

/// Returns the row of a group.
fn histogram(starts: &str, name: &str, searches: &[&Search]) -> Vec<String> {
    let count = |is: &dyn Fn(&Search) -> bool| searches.iter().filter(|s| is(s)).count();
    let reached = |from: usize, to: usize| {
        count(&|s| s.end == End::Reached && (from..=to).contains(&s.iterations))
    };
    let mut numbers = vec![searches.len(), count(&|s| s.end == End::Touch)];
    let mut from = 0;
    for to in BANDS.into_iter().chain([usize::MAX]) {
        numbers.push(reached(from, to));
        from = to.saturating_add(1);
    }
    numbers.push(count(&|s| matches!(s.end, End::Above { .. })));
    numbers.push(count(&|s| matches!(s.end, End::Stopped(_) | End::Saddle { .. })));
    numbers.push(count(&|s| matches!(s.end, End::Refused(_))));
    numbers.push(searches.iter().map(|s| s.iterations).max().unwrap_or(0));
    let mut row = vec![starts.to_owned(), name.to_owned()];
    row.extend(numbers.iter().map(usize::to_string));
    row.push(String::new());
    row
}

/// Describes a problem, and how the search from the default starts ended.
fn describe(outcome: &Outcome) -> String {
    let Outcome { index, metric, dimension, ends: [first, second], rule, n, default, .. } = outcome;
    let rule = rule.name().replace('_', "-");
    let end = match &default.end {
        End::Touch => "the ends touch".to_owned(),
        End::Reached => "reached".to_owned(),
        End::Above { decrement, residual } => {
            format!("decrement {decrement:.0e} and residual {residual:.0e} times its floor")
        }
        End::Saddle { negative } => format!("a saddle with {negative} ways down"),
        End::Stopped(stop) => format!("{stop:?}"),
        End::Refused(error) => error.to_string(),
        End::NotANumber => "NaN".to_owned(),
    };
    let steps = default.iterations;
    format!(
        "problem {index}: {metric} with D = {dimension} from {first:?} to {second:?}, {rule} rule \
         with N = {n}: {end} after {steps} steps"
    )
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Random problems by the Newton steps, over all grids, of the search that led to the \
         result: from the default starts, with which 99.9 % must reach the goal within 60 steps, \
         and from one straight line alone. The problems are drawn in `paper/src/corpus`. Ends \
         touch: the sets have a point in common. Not converged: the search gave up, ended at a \
         saddle, or left both a decrement above 1e-18 of the energy and a residual above twice \
         its floor.",
        "starts & problems & number & ends touch & 1–5 & 6–10 & 11–20 & 21–40 & 41–60 & > \
         60 & not converged & errors & most steps",
    );
    for row in data.rows().filter(|row| !row.text("number").is_empty()) {
        let starts = row.text("starts");
        let mut cells = vec![if layout.group_by(starts) { starts } else { "" }.to_owned()];
        cells.extend(row.texts("problems number"));
        cells.extend(row.texts(STEPS_TAKEN));
        cells.push(format!("{}", row.number("above") + row.number("stopped")));
        cells.extend(row.texts("refused most_steps"));
        layout.push(cells);
    }
    Ok(layout)
}
