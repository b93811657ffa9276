//! `Written`: a metric written as several texts, for example the entries of a matrix in a file.

use std::sync::Arc;

use tautline_scalar::{ANY, Table};

use super::{
    Problem, TextError,
    form::Form,
    parser::{Meaning, Names, Parser},
    value::Value,
};
use crate::{
    Formula,
    recording::{Symbol, record},
};

/// A text, with a number by which its owner recognises it in a [`WrittenError`].
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Part<'a> {
    /// The text.
    pub text: &'a str,
    /// The number.
    pub id: usize,
}

/// A function of the coordinates, on which a weight depends.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Weight<'a> {
    /// An expression.
    Text(Part<'a>),
    /// The first entry of a recorded formula.
    Recorded(Formula<ANY>),
}

/// What is wrong with one of several texts.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("in text {id}, {error}")]
pub struct WrittenError {
    /// The number of the text.
    pub id: usize,
    /// What is wrong with it, and where.
    pub error: TextError,
}

/// A metric written as several texts. The texts are those of [`Formula::parse`]; all of them read
/// the coordinates `x1` to `xD` of the whole space, also in a factor of a product.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Written<'a> {
    /// A whole metric in one text, with definitions of its own.
    Whole(Part<'a>),
    /// All entries of the matrix, row by row.
    Matrix(Vec<Vec<Part<'a>>>),
    /// The entries of the matrix on the diagonal and to the right of it, row by row.
    Upper(Vec<Vec<Part<'a>>>),
    /// A form of some functions.
    Form(Form, Vec<Part<'a>>),
    /// The sum of metrics.
    Sum(Vec<Written<'a>>),
    /// A metric times a positive function.
    Scaled(Part<'a>, Box<Written<'a>>),
    /// A metric times a positive function of the values of other functions. It calls them `u1`, `u2`, …, and has
    /// no other names than these and the coordinates; no other text knows these names.
    Weighted(Vec<Weight<'a>>, Part<'a>, Box<Written<'a>>),
    /// Metrics in blocks along the diagonal, each with the coordinates of its block, from 0. Every
    /// coordinate belongs to one block.
    Product(Vec<(Vec<usize>, Written<'a>)>),
    /// A recorded formula, whose coordinates are those of the block.
    Recorded(Formula<ANY>),
}

impl<const D: usize> Formula<D> {
    /// Parses a metric written as several texts, given values for named parameters and definitions
    /// of further names. A definition is a pair of texts, a name and an expression, and may use the
    /// definitions before it.
    ///
    /// ```
    /// use tautline_formula::{Form, Formula, Part, Written};
    ///
    /// let part = |text| Part { text, id: 0 };
    /// let phi = Written::Form(Form::Cost, vec![part("f")]);
    /// let valleys = Formula::<2>::compose(&[("a", 2.0)], &[], &[[part("f"), part("a - cos(x1)")]], &phi)?;
    /// assert_eq!(Ok(valleys), Formula::parse("sqr(2 - cos(x1)) I", &[]));
    /// # Ok::<(), tautline_formula::WrittenError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`WrittenError`] with the number of the text and the offending bytes. An error of a shape,
    /// or of a parameter's name, is reported at the first text of the metric.
    pub fn compose(
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        metric: &Written<'_>,
    ) -> Result<Self, WrittenError> {
        Self::composed(D, parameters, tables, definitions, metric)
    }

    fn composed(
        dimension: usize,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        metric: &Written<'_>,
    ) -> Result<Self, WrittenError> {
        let id = metric.first_id();
        let (entries, recording) = record(dimension, |x| {
            let mut writer = Writer { x, names: Names::new(), id };
            writer.define(parameters, tables, definitions)?;
            writer.entries(metric, &(0..dimension).collect::<Vec<_>>())
        });
        let whole = |problem| WrittenError { id, error: TextError { at: 0..0, problem } };
        Self::of(dimension, &entries?, &recording).map_err(|error| whole(error.into()))
    }

    /// Returns the function `f` of a metric in one text that is `cost(f)` or `speed(f)`, as the metric
    /// `f I`, and which of the two it is; `None` for another metric. That of the text, `f² I` or `f⁻² I`,
    /// does not show the sign of `f`. The names are those of [`compose`](Formula::compose).
    ///
    /// ```
    /// use tautline_formula::{Form, Formula, Part};
    ///
    /// let part = |text| Part { text, id: 0 };
    /// let negative = Formula::<1>::squared_in(&[], &[], &[], part("f = -2 - cos(x1); cost(f)"))?;
    /// assert_eq!(negative, Some((Form::Cost, Formula::parse("(-2 - cos(x1)) I", &[]).unwrap())));
    /// assert_eq!(Formula::<1>::squared_in(&[], &[], &[], part("x1^2 I"))?, None);
    /// # Ok::<(), tautline_formula::WrittenError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// As for [`compose`](Formula::compose).
    pub fn squared_in(
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        text: Part<'_>,
    ) -> Result<Option<(Form, Self)>, WrittenError> {
        Self::squared(D, parameters, tables, definitions, text)
    }

    fn squared(
        dimension: usize,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        text: Part<'_>,
    ) -> Result<Option<(Form, Self)>, WrittenError> {
        let Part { id, .. } = text;
        let wrong = |error| WrittenError { id, error };
        let coordinates: Vec<usize> = (0..dimension).collect();
        let (found, recording) = record(dimension, |x| {
            let mut writer = Writer { x, names: Names::new(), id };
            writer.define(parameters, tables, definitions)?;
            let mut parser = writer.parser(text.text, &coordinates);
            let found = parser.advance().and_then(|_| parser.squared()).map_err(wrong)?;
            Ok(found.map(|(form, f)| (form, Form::Phi.entries(&[f], &coordinates))))
        });
        let Some((form, entries)) = found? else { return Ok(None) };
        let formula = Self::of(dimension, &entries, &recording);
        let formula =
            formula.map_err(|error| wrong(TextError { at: 0..0, problem: error.into() }))?;
        Ok(Some((form, formula)))
    }
}

impl Formula<ANY> {
    /// Parses a metric on `R^dimension` like [`compose`](Formula::compose).
    ///
    /// # Errors
    ///
    /// As for [`compose`](Formula::compose).
    pub fn compose_in(
        dimension: usize,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        metric: &Written<'_>,
    ) -> Result<Self, WrittenError> {
        Self::composed(dimension, parameters, tables, definitions, metric)
    }

    /// Returns the function of a text like [`squared_in`](Formula::squared_in), on `R^dimension`.
    ///
    /// # Errors
    ///
    /// As for [`squared_in`](Formula::squared_in).
    pub fn squared_of(
        dimension: usize,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
        text: Part<'_>,
    ) -> Result<Option<(Form, Self)>, WrittenError> {
        Self::squared(dimension, parameters, tables, definitions, text)
    }
}

impl<'a> Written<'a> {
    /// Returns the number of the first text, or 0 if there is none.
    fn first_id(&self) -> usize {
        let first = |parts: &[Part<'a>]| parts.first().map_or(0, |part| part.id);
        match self {
            Written::Whole(part) | Written::Scaled(part, _) => part.id,
            Written::Matrix(rows) | Written::Upper(rows) => {
                rows.first().map_or(0, |row| first(row))
            }
            Written::Form(_, parts) => first(parts),
            Written::Sum(metrics) => metrics.first().map_or(0, Written::first_id),
            Written::Weighted(_, _, metric) => metric.first_id(),
            Written::Product(blocks) => blocks.first().map_or(0, |(_, block)| block.first_id()),
            Written::Recorded(_) => 0,
        }
    }
}

/// Writes a metric to the tape of this thread.
struct Writer<'x> {
    x: &'x [Symbol],
    names: Names,
    /// The number of the text at which errors of a shape are reported.
    id: usize,
}

impl Writer<'_> {
    fn parser<'p>(&'p mut self, text: &'p str, coordinates: &'p [usize]) -> Parser<'p> {
        Parser::new(text, self.x, coordinates, &mut self.names)
    }

    /// Gives the parameters, the tables and the definitions their names.
    fn define(
        &mut self,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
        definitions: &[[Part<'_>; 2]],
    ) -> Result<(), WrittenError> {
        let id = self.id;
        let whole = |error: TextError| WrittenError { id, error };
        for &(name, value) in parameters {
            self.parser("", &[]).define(name, Value::Number(value)).map_err(whole)?;
        }
        for (name, table) in tables {
            self.parser("", &[]).define_table(name, table).map_err(whole)?;
        }
        for [name, value] in definitions {
            let value = self.expression(*value)?;
            let named = self.parser(name.text, &[]).define_itself(value);
            named.map_err(|error| WrittenError { id: name.id, error })?;
        }
        Ok(())
    }

    fn expression(&mut self, part: Part<'_>) -> Result<Value, WrittenError> {
        let value = self.parser(part.text, &[]).whole_expression();
        value.map_err(|error| WrittenError { id: part.id, error })
    }

    fn expressions(&mut self, parts: &[Part<'_>]) -> Result<Vec<Value>, WrittenError> {
        parts.iter().map(|&part| self.expression(part)).collect()
    }

    /// Returns the entries of the block of these coordinates, column by column.
    fn entries(
        &mut self,
        metric: &Written<'_>,
        coordinates: &[usize],
    ) -> Result<Vec<Symbol>, WrittenError> {
        let dimension = coordinates.len();
        match metric {
            Written::Whole(part) => {
                // Its definitions are its own.
                let names = self.names.clone();
                let mut parser = self.parser(part.text, coordinates);
                let entries = parser.advance().and_then(|_| parser.metric());
                self.names = names;
                entries.map_err(|error| WrittenError { id: part.id, error })
            }
            Written::Matrix(rows) => {
                let rows = self.rows(rows, |_| dimension, dimension)?;
                Ok(by_columns(dimension, |i, j| rows[i][j]))
            }
            Written::Upper(rows) => {
                let rows = self.rows(rows, |row| dimension - row, dimension)?;
                Ok(by_columns(dimension, |i, j| rows[i.min(j)][i.abs_diff(j)]))
            }
            Written::Form(form, parts) => {
                let functions = self.expressions(parts)?;
                if !form.takes(functions.len(), dimension) {
                    let (form, takes) = form.takes_what(dimension);
                    let found = functions.len();
                    return self.refuse(Problem::Functions { form, takes, found, dimension });
                }
                Ok(form.entries(&functions, coordinates))
            }
            Written::Sum(metrics) => {
                let mut terms = metrics.iter().map(|metric| self.entries(metric, coordinates));
                let Some(first) = terms.next() else {
                    return self.refuse(Problem::Shape { found: 0, what: "terms", dimension });
                };
                let add = |sum: Vec<Symbol>, term: Result<Vec<Symbol>, _>| {
                    Ok(sum.into_iter().zip(term?).map(|(a, b)| a + b).collect())
                };
                terms.try_fold(first?, add)
            }
            Written::Scaled(by, metric) => {
                let by = self.expression(*by)?.symbol();
                Ok(self.entries(metric, coordinates)?.into_iter().map(|h| by * h).collect())
            }
            Written::Weighted(values, by, metric) => {
                let named = |(i, value)| (format!("u{}", i + 1), Meaning::Value(value));
                let values = values.iter().map(|value| self.weight(value));
                let values: Vec<Value> = values.collect::<Result<_, _>>()?;
                let own = values.into_iter().enumerate().map(named).collect();
                let names = std::mem::replace(&mut self.names, own);
                let by = self.expression(*by);
                self.names = names;
                let by = by?.symbol();
                Ok(self.entries(metric, coordinates)?.into_iter().map(|h| by * h).collect())
            }
            Written::Product(blocks) => self.product(blocks, coordinates),
            Written::Recorded(formula) => self.recorded(formula, coordinates),
        }
    }

    fn weight(&mut self, weight: &Weight<'_>) -> Result<Value, WrittenError> {
        match weight {
            Weight::Text(part) => self.expression(*part),
            Weight::Recorded(formula) => {
                let coordinates: Vec<usize> = (0..self.x.len()).collect();
                Ok(Value::Symbol(self.recorded(formula, &coordinates)?[0]))
            }
        }
    }

    /// Returns the entries of a recorded formula on a block of coordinates, column by column.
    fn recorded(
        &self,
        formula: &Formula<ANY>,
        coordinates: &[usize],
    ) -> Result<Vec<Symbol>, WrittenError> {
        let (found, dimension) = (formula.dimension(), coordinates.len());
        if found != dimension {
            let what = "coordinates of a recorded formula";
            return self.refuse(Problem::Shape { found, what, dimension });
        }
        let x: Vec<Symbol> = coordinates.iter().map(|&i| self.x[i]).collect();
        let tape = formula.tape();
        let values = tape.values(&x);
        Ok(tape.entries.iter().map(|&entry| values[entry as usize]).collect())
    }

    fn product(
        &mut self,
        blocks: &[(Vec<usize>, Written<'_>)],
        coordinates: &[usize],
    ) -> Result<Vec<Symbol>, WrittenError> {
        let dimension = coordinates.len();
        let zero = Value::Number(0.0).symbol();
        let mut product = vec![None; dimension * dimension];
        for (own, block) in blocks {
            // The places of the block's coordinates among these.
            let places = own.iter().map(|i| coordinates.iter().position(|j| i == j));
            let places: Option<Vec<usize>> = places.collect();
            let is_new = |places: &Vec<usize>| {
                let mut distinct = (1..places.len()).map(|k| !places[..k].contains(&places[k]));
                places.iter().all(|i| product[i * (dimension + 1)].is_none())
                    && distinct.all(|is_distinct| is_distinct)
            };
            let Some(places) = places.filter(is_new) else {
                let what = "coordinates of a block that are not those of another";
                return self.refuse(Problem::Shape { found: own.len(), what, dimension });
            };
            let entries = self.entries(block, own)?;
            for (j, column) in places.iter().zip(entries.chunks(own.len().max(1))) {
                for (i, &entry) in places.iter().zip(column) {
                    product[j * dimension + i] = Some(entry);
                }
            }
        }
        let found = (0..dimension).filter(|i| product[i * (dimension + 1)].is_some()).count();
        if found < dimension {
            let what = "coordinates in the blocks of a product";
            return self.refuse(Problem::Shape { found, what, dimension });
        }
        Ok(product.into_iter().map(|entry| entry.unwrap_or(zero)).collect())
    }

    /// Parses the entries of a matrix, after a check that there are as many rows as columns, and
    /// that each has its `length`.
    fn rows(
        &mut self,
        rows: &[Vec<Part<'_>>],
        length: impl Fn(usize) -> usize,
        dimension: usize,
    ) -> Result<Vec<Vec<Symbol>>, WrittenError> {
        if rows.len() != dimension {
            return self.refuse(Problem::Shape { found: rows.len(), what: "rows", dimension });
        }
        if let Some((_, row)) = rows.iter().enumerate().find(|(i, row)| row.len() != length(*i)) {
            let (found, what) = (row.len(), "entries in a row");
            return self.refuse(Problem::Shape { found, what, dimension });
        }
        let mut entry = |part: &Part<'_>| self.expression(*part).map(Value::symbol);
        rows.iter().map(|row| row.iter().map(&mut entry).collect()).collect()
    }

    fn refuse<T>(&self, problem: Problem) -> Result<T, WrittenError> {
        Err(WrittenError { id: self.id, error: TextError { at: 0..0, problem } })
    }
}

fn by_columns(dimension: usize, entry: impl Fn(usize, usize) -> Symbol) -> Vec<Symbol> {
    let places = (0..dimension).flat_map(|j| (0..dimension).map(move |i| (i, j)));
    places.map(|(i, j)| entry(i, j)).collect()
}

/// Returns the value of an expression of numbers and parameters, such as `2*pi/3`, in `f64`.
///
/// # Errors
///
/// [`TextError`] with the offending bytes, if the text is not an expression without coordinates, or does
/// arithmetic with a number that is not finite.
pub fn number(text: &str, parameters: &[(&str, f64)]) -> Result<f64, TextError> {
    let mut names = Names::new();
    let mut parser = Parser::new(text, &[], &[], &mut names);
    parser.are_numbers = true;
    for &(name, value) in parameters {
        parser.define(name, Value::Number(value))?;
    }
    // Only `number(…)` makes a step without coordinates.
    parser.whole_expression()?.number().ok_or_else(|| {
        let problem = Problem::UnknownFunction { name: super::parser::STEP.to_owned() };
        TextError { at: 0..text.len(), problem }
    })
}
