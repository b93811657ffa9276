//! The axes of a sweep, from the section of a file to numbers.

use tautline::formula::probably_meant;

use crate::{
    Axis, Diagnostic, Sweep, Values,
    file::{
        ProblemFile,
        placed::Placed,
        sweep::{EntryFile, RangeFile, SweepFile, ValuesFile},
    },
    reading::numbers::{Numbers, counted},
};

/// Returns what varies, with its numbers evaluated for the parameters as they stand in the file.
pub(crate) fn axes(
    sweep: &Placed<SweepFile>,
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
) -> Result<Sweep, Diagnostic> {
    let SweepFile { draws, seed, vary } = sweep.get_ref();
    if vary.is_empty() {
        return Err(Diagnostic::new("nothing varies", sweep.span())
            .help("a section such as [sweep.vary] with height = [1, 2, 4]"));
    }
    let known: Vec<&str> = problem.parameters.keys().map(|name| name.get_ref().as_str()).collect();
    let mut vary: Vec<_> = vary.iter().collect();
    vary.sort_by_key(|(name, _)| name.span().start);
    let mut axes: Vec<Axis> = Vec::new();
    for (key, values) in vary {
        let names: Vec<String> = key.get_ref().split(',').map(|it| it.trim().to_owned()).collect();
        for (index, name) in names.iter().enumerate() {
            let before = axes.iter().flat_map(|axis| &axis.names).chain(&names[..index]);
            if before.into_iter().any(|taken| taken == name) {
                return Err(Diagnostic::new(format!("{name} varies twice"), key.span()));
            }
            if !known.contains(&name.as_str()) {
                let message = format!("{name} is no parameter");
                let diagnostic = Diagnostic::new(message, key.span());
                return Err(match probably_meant(name, known) {
                    Some(meant) => diagnostic.help(format!("did you mean {meant}?")),
                    None => diagnostic.help(format!("write {name} = 0, say, in [parameters]")),
                });
            }
        }
        let values = self::values(values, names.len(), numbers)?;
        axes.push(Axis { names, values });
    }
    let is_random = axes.iter().any(|axis| matches!(axis.values, Values::Uniform { .. }));
    let draws = match draws {
        Some(none) if *none.get_ref() == 0 => {
            return Err(Diagnostic::new("no draws", none.span()).label("expected 1 or more"));
        }
        Some(draws) if !is_random => {
            return Err(Diagnostic::new("draws, but nothing is random", draws.span())
                .help("a parameter is drawn by { uniform = [0, 1] }"));
        }
        draws => draws.as_ref().map_or(1, |draws| *draws.get_ref()),
    };
    Ok(Sweep { axes, draws, seed: *seed })
}

/// Returns the values of an axis of this many parameters.
fn values(
    values: &Placed<ValuesFile>,
    parameters: usize,
    numbers: &Numbers<'_>,
) -> Result<Values, Diagnostic> {
    let RangeFile { from, to, count, uniform } = match values.get_ref() {
        ValuesFile::List(entries) if entries.is_empty() => {
            return Err(Diagnostic::new("a list of no values", values.span()));
        }
        ValuesFile::List(entries) => {
            let entry = |entry| self::entry(entry, parameters, numbers);
            return Ok(Values::List(entries.iter().map(entry).collect::<Result<_, _>>()?));
        }
        ValuesFile::Table(range) => range,
    };
    if parameters > 1 {
        return Err(Diagnostic::new("parameters that vary together have a list", values.span())
            .label(format!("expected a list of lists of {}", counted(parameters, "number"))));
    }
    match (from, to, count, uniform) {
        (Some(from), Some(to), Some(count), None) => {
            let (first, last) = (numbers.number(from)?, numbers.number(to)?);
            let size = *count.get_ref();
            if size == 0 || (size == 1 && first != last) {
                return Err(Diagnostic::new(counted(size as usize, "value"), count.span())
                    .label("expected 2 or more, from one end to the other"));
            }
            if !(last - first).is_finite() {
                return Err(Diagnostic::new("too long an interval", to.span()));
            }
            Ok(Values::Grid { from: first, to: last, count: size })
        }
        (None, None, None, Some(ends)) => {
            let [least, most] = ends.get_ref();
            let (least, most) = (numbers.number(least)?, numbers.number(most)?);
            if !(least < most && (most - least).is_finite()) {
                let message = format!("from {least} to {most} is no interval");
                return Err(Diagnostic::new(message, ends.span())
                    .label("expected the lower end, then the upper one"));
            }
            Ok(Values::Uniform { least, most })
        }
        _ => Err(Diagnostic::new("no values", values.span())
            .label("expected from, to and count, or uniform alone")),
    }
}

/// Returns the numbers of an entry of a list, one for each parameter.
fn entry(
    entry: &Placed<EntryFile>,
    parameters: usize,
    numbers: &Numbers<'_>,
) -> Result<Vec<f64>, Diagnostic> {
    let values = match entry.get_ref() {
        EntryFile::One(expression) => {
            vec![numbers.number(&Placed::at(entry.span(), expression.clone()))?]
        }
        EntryFile::Several(texts) => numbers.all(texts)?,
    };
    if values.len() == parameters {
        return Ok(values);
    }
    Err(Diagnostic::new(counted(values.len(), "number"), entry.span())
        .label(format!("expected {}, one for each parameter", counted(parameters, "number"))))
}
