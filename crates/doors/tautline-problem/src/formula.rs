//! The formula of the metric of a file.

use std::{ops::Range, sync::Arc};

use tautline::{
    ANY, Formula, Table,
    formula::{Form, Part, Weight, Written, WrittenError},
};

use crate::{
    Diagnostic,
    file::{
        ProblemFile,
        expression::{Expression, Text},
        metric::{BlockFile, MetricFile, ScaledFile},
        placed::Placed,
    },
    gallery,
    reading::{
        numbers::{Numbers, counted},
        obstacles::{Distance, Obstacles, obstacles},
        tables::Tables,
    },
};

/// The texts of a metric, numbered by their order.
struct Texts<'f> {
    numbers: &'f Numbers<'f>,
    /// The bytes of each text.
    places: Vec<Range<usize>>,
}

/// Returns the formula of the metric.
pub(crate) fn formula(
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    tables: &Tables,
    dimension: usize,
) -> Result<Formula<ANY>, Diagnostic> {
    let obstacles = obstacles(problem, numbers, dimension)?;
    let metric = problem.metric.get_ref();
    formula_of(metric, problem, numbers, tables, dimension, obstacles.as_ref())
}

/// Returns the formula of a metric with the definitions of a file, and with these obstacles.
pub(crate) fn formula_of(
    metric: &MetricFile,
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    tables: &Tables,
    dimension: usize,
    obstacles: Option<&Obstacles<'_>>,
) -> Result<Formula<ANY>, Diagnostic> {
    let mut texts = Texts { numbers, places: Vec::new() };
    let definitions = texts.definitions(problem);
    let coordinates: Vec<usize> = (1..=dimension).collect();
    let mut metric = texts.written(metric, &coordinates)?;
    if let Some(Obstacles { distances, factor, place }) = obstacles {
        let parts = distances.iter().map(|distance| match distance {
            Distance::Own(text) => Weight::Text(texts.numbered(text, place.clone())),
            Distance::Given(text) => Weight::Text(texts.part(text)),
        });
        let distances = parts.collect();
        let factor = texts.numbered(factor, place.clone());
        metric = Written::Weighted(distances, factor, Box::new(metric));
    }
    let (parameters, tables_by_name) = (numbers.by_name(), by_name(tables));
    let formula =
        Formula::compose_in(dimension, &parameters, &tables_by_name, &definitions, &metric);
    formula.map_err(|error| texts.explain(&error, problem, tables))
}

/// Returns the function `f` of a text that is `cost(f)` or `speed(f)`, as the metric `f I`, and which of
/// the two it is; `None` for another metric.
pub(crate) fn squared_in(
    text: &Text,
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    tables: &Tables,
    dimension: usize,
) -> Result<Option<(Form, Formula<ANY>)>, Diagnostic> {
    let mut texts = Texts { numbers, places: Vec::new() };
    let definitions = texts.definitions(problem);
    let text = texts.part(text);
    let (parameters, tables_by_name) = (numbers.by_name(), by_name(tables));
    let found = Formula::squared_of(dimension, &parameters, &tables_by_name, &definitions, text);
    found.map_err(|error| texts.explain(&error, problem, tables))
}

fn by_name(tables: &Tables) -> Vec<(&str, Arc<dyn Table>)> {
    tables.iter().map(|(name, table)| (name.as_str(), Arc::clone(table))).collect()
}

/// Returns the definitions of a file, in their order.
fn defined(problem: &ProblemFile) -> Vec<(&Placed<String>, &Text)> {
    let mut definitions: Vec<_> = problem.definitions.iter().collect();
    definitions.sort_by_key(|(name, _)| name.span().start);
    definitions
}

impl<'f> Texts<'f> {
    fn definitions<'t>(&mut self, problem: &'t ProblemFile) -> Vec<[Part<'t>; 2]> {
        let parts = |(name, text): (&'t Placed<String>, &'t Text)| {
            let name = self.numbered(name.get_ref(), name.span());
            [name, self.part(text)]
        };
        defined(problem).into_iter().map(parts).collect()
    }

    /// Explains an error in one of the texts.
    fn explain(
        &self,
        WrittenError { id, error }: &WrittenError,
        problem: &ProblemFile,
        tables: &Tables,
    ) -> Diagnostic {
        let span = self.places.get(*id).cloned().unwrap_or(problem.metric.span());
        let definitions = defined(problem);
        let definitions = definitions.iter().map(|(name, _)| name.get_ref().as_str());
        let names = definitions.chain(tables.iter().map(|(name, _)| name.as_str()));
        self.numbers.explain(error, span, &names.collect::<Vec<_>>())
    }

    fn numbered<'t>(&mut self, text: &'t str, place: Range<usize>) -> Part<'t> {
        self.places.push(place);
        Part { text, id: self.places.len() - 1 }
    }

    fn part<'t>(&mut self, text: &'t Text) -> Part<'t> {
        let Expression(expression) = text.get_ref();
        self.numbered(expression, text.span())
    }

    fn parts<'t>(&mut self, texts: &'t [Text]) -> Vec<Part<'t>> {
        texts.iter().map(|text| self.part(text)).collect()
    }

    /// Returns the metric of the block of these coordinates, numbered from 1.
    fn written<'t>(
        &mut self,
        metric: &'t MetricFile,
        coordinates: &[usize],
    ) -> Result<Written<'t>, Diagnostic> {
        let dimension = coordinates.len();
        let one = |form, part| Written::Form(form, vec![part]);
        Ok(match metric {
            MetricFile::Formula(text) => Written::Whole(self.part(text)),
            MetricFile::Matrix(rows) => {
                Written::Matrix(self.rows(rows, |_| dimension, dimension)?)
            }
            MetricFile::Upper(rows) => {
                Written::Upper(self.rows(rows, |row| dimension - row, dimension)?)
            }
            MetricFile::Diag(texts) => {
                let found = texts.get_ref().len();
                expect_count(found, "entry", dimension, found == dimension, texts.span())?;
                Written::Form(Form::Diag, self.parts(texts.get_ref()))
            }
            MetricFile::Pullback(texts) => {
                let found = texts.get_ref().len();
                expect_count(found, "function", dimension, found >= dimension, texts.span())?;
                Written::Form(Form::Pullback, self.parts(texts.get_ref()))
            }
            MetricFile::Phi(text) => one(Form::Phi, self.part(text)),
            MetricFile::Cost(text) => one(Form::Cost, self.part(text)),
            MetricFile::Speed(text) => one(Form::Speed, self.part(text)),
            MetricFile::Graph(text) => one(Form::Graph, self.part(text)),
            MetricFile::Sum(metrics) if metrics.get_ref().is_empty() => {
                return Err(Diagnostic::new("a sum of no metrics", metrics.span()));
            }
            MetricFile::Sum(metrics) => {
                let written = |metric| self.written(metric, coordinates);
                Written::Sum(metrics.get_ref().iter().map(written).collect::<Result<_, _>>()?)
            }
            MetricFile::Scaled(ScaledFile { by, metric }) => {
                let by = self.part(by);
                Written::Scaled(by, Box::new(self.written(metric, coordinates)?))
            }
            MetricFile::Product(blocks) => {
                self.product(blocks.get_ref(), blocks.span(), coordinates)?
            }
            MetricFile::Gallery(metric) => {
                let place = metric.span();
                Written::Recorded(gallery::formula(
                    &metric.get_ref().0,
                    place,
                    self.numbers,
                    dimension,
                )?)
            }
        })
    }

    fn product<'t>(
        &mut self,
        blocks: &'t [BlockFile],
        place: Range<usize>,
        coordinates: &[usize],
    ) -> Result<Written<'t>, Diagnostic> {
        let mut taken = Vec::new();
        let mut written = Vec::new();
        for BlockFile { coordinates: own, metric } in blocks {
            for coordinate in own.get_ref() {
                let wrong = if !coordinates.contains(coordinate) {
                    format!("there is no coordinate {coordinate} here")
                } else if taken.contains(coordinate) {
                    format!("coordinate {coordinate} belongs to two blocks")
                } else {
                    taken.push(*coordinate);
                    continue;
                };
                let all: Vec<String> = coordinates.iter().map(usize::to_string).collect();
                return Err(Diagnostic::new(wrong, own.span())
                    .label(format!("expected each of {} in one block", all.join(", "))));
            }
            if own.get_ref().is_empty() {
                return Err(Diagnostic::new("a block without coordinates", own.span()));
            }
            let block = self.written(metric, own.get_ref())?;
            written.push((own.get_ref().iter().map(|i| i - 1).collect(), block));
        }
        match coordinates.iter().find(|coordinate| !taken.contains(coordinate)) {
            Some(missing) => {
                Err(Diagnostic::new(format!("coordinate {missing} belongs to no block"), place))
            }
            None => Ok(Written::Product(written)),
        }
    }

    fn rows<'t>(
        &mut self,
        rows: &'t Placed<Vec<Placed<Vec<Text>>>>,
        length: impl Fn(usize) -> usize,
        dimension: usize,
    ) -> Result<Vec<Vec<Part<'t>>>, Diagnostic> {
        let found = rows.get_ref().len();
        expect_count(found, "row", dimension, found == dimension, rows.span())?;
        for (i, row) in rows.get_ref().iter().enumerate() {
            let (found, length) = (row.get_ref().len(), length(i));
            expect_count(found, "entry", length, found == length, row.span())?;
        }
        Ok(rows.get_ref().iter().map(|row| self.parts(row.get_ref())).collect())
    }
}

/// Refuses a wrong number of entries, rows or functions.
fn expect_count(
    found: usize,
    what: &str,
    expected: usize,
    is_right: bool,
    at: Range<usize>,
) -> Result<(), Diagnostic> {
    if is_right {
        return Ok(());
    }
    let or_more = if what == "function" { " or more" } else { "" };
    Err(Diagnostic::new(format!("{} here", counted(found, what)), at)
        .label(format!("expected {}{or_more}", counted(expected, what))))
}
