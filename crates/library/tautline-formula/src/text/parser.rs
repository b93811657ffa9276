//! The parser, which turns a text into a formula.

use std::{collections::HashMap, ops::Range, sync::Arc};

use tautline_scalar::{ANY, Table};

use super::{
    Problem, TextError,
    expression::orders_of,
    form::{Form, form},
    token::{Token, Tokens},
    value::Value,
};
use crate::{
    Formula,
    operation::Function,
    recording::{Symbol, record},
};

/// The name of the function that makes a step of a number.
pub(super) const STEP: &str = "number";

impl<const D: usize> Formula<D> {
    /// Parses a formula, given values for named parameters.
    ///
    /// ```text
    /// metric = { definition ";" } ( matrix | expr "I" | form "(" row ")" )
    /// matrix = "[" row { ";" row } "]"          row = expr { "," expr }
    /// form   = "pullback" | "graph" | "phi" | "cost" | "speed" | "diag"
    /// expr   = term { ( "+" | "-" ) term }      term = factor { ( "*" | "/" ) factor }
    /// factor = "-" factor | atom [ ( "^" | "**" ) [ "-" ] integer ]
    /// atom   = number | name | function "(" expr ")" | "(" expr ")"
    /// definition = name "=" expr | name "," name "=" ( "sin_cos" | "sinh_cosh" ) "(" expr ")"
    /// ```
    ///
    /// Names are `x1` to `xD`, `pi`, parameters, and definitions, each defined once. Functions are
    /// `sqr`, `recip`, `sqrt`, `exp`, `ln`, `sin`, `cos`, `tan`, `atan`, `sinh`, `cosh`, `tanh`,
    /// and `number`, which records a number as a step.
    ///
    /// A form makes a matrix from functions, which it differentiates if necessary:
    ///
    /// * `pullback(Φ₁, …, Φₘ)` is `JᵀJ` with the derivative `J` of the map `Φ`, `m ≥ D`;
    /// * `graph(f)` is `I + ∇f ∇fᵀ`;
    /// * `phi(φ)` is `φ I`;
    /// * `cost(f)` is `f² I`, under which a curve has length `∫ f |γ'| dt`;
    /// * `speed(f)` is `f⁻² I`, under which the length of a curve is the time it takes at speed `f`;
    /// * `diag(a₁, …, a_D)` is the diagonal matrix.
    ///
    /// Definitions may reuse these names.
    ///
    /// Operands are evaluated from left to right. Arithmetic between numbers has to be finite. Unless it is
    /// exact, as in `2*pi`, it is recorded as steps, which intervals enclose, as in `2*pi/3`; so are numbers
    /// in derivatives.
    /// A text records the same tape as the same formula in Rust, provided that the definitions are
    /// in the order of the `let`s, and arithmetic between numbers is exact. The operators are taken literally: `x1^2` records a power, as
    /// `x.powi(2)` does, and `sqr(x1)` records a square, as `x.sqr()` does. The two are different
    /// formulas.
    ///
    /// ```
    /// use tautline_formula::Formula;
    /// use tautline_metrics::Metric;
    ///
    /// let valleys = Formula::<2>::parse("(a - cos(x1))^2 I", &[("a", 2.0)])?;
    /// assert_eq!(Formula::parse(&valleys.to_string(), &[]), Ok(valleys));
    /// let error = Formula::<2>::parse("(2 - cos(x3))^2 I", &[]).unwrap_err();
    /// assert_eq!(error.to_string(), "at byte 9: there is no x3 in dimension 2");
    /// assert_eq!(error.at, 9..11);
    ///
    /// let [power, square] = ["x1^2 I", "sqr(x1) I"].map(|text| Formula::<1>::parse(text, &[]));
    /// assert_ne!(power, square);
    ///
    /// let hill = Formula::<2>::parse("graph(h*exp(-(x1^2 + x2^2)/2))", &[("h", 2.0)])?;
    /// let text = "g = 2*exp(-(x1^2 + x2^2)/2); [1 + (x1*g)^2, x1*x2*g^2; x1*x2*g^2, 1 + (x2*g)^2]";
    /// let (x, by_hand) = ([0.5, -1.0].into(), Formula::<2>::parse(text, &[])?);
    /// assert!((hill.gram(&x) - by_hand.gram(&x)).amax() < 1e-15);
    /// # Ok::<(), tautline_formula::TextError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`TextError`] with the offending bytes.
    pub fn parse(text: &str, parameters: &[(&str, f64)]) -> Result<Self, TextError> {
        Self::parse_with(text, parameters, &[])
    }

    /// Parses a formula like [`parse`](Formula::parse), with tables as further functions: `height(x1,
    /// x2)` is the value of the table `height`, and `height_10(x1, x2)` its derivative along the first
    /// axis. Along each axis the order is at most 2, since third derivatives may jump.
    ///
    /// # Errors
    ///
    /// [`TextError`] with the offending bytes.
    pub fn parse_with(
        text: &str,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
    ) -> Result<Self, TextError> {
        Self::parsed(D, text, parameters, tables)
    }

    fn parsed(
        dimension: usize,
        text: &str,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
    ) -> Result<Self, TextError> {
        let (entries, recording) = record(dimension, |x| {
            let mut names = Names::new();
            let coordinates: Vec<usize> = (0..dimension).collect();
            let mut parser = Parser::new(text, x, &coordinates, &mut names);
            for &(name, value) in parameters {
                parser.define(name, Value::Number(value))?;
            }
            for (name, table) in tables {
                parser.define_table(name, table)?;
            }
            parser.advance()?;
            parser.metric()
        });
        let end = text.len()..text.len();
        Self::of(dimension, &entries?, &recording)
            .map_err(|error| TextError { at: end, problem: error.into() })
    }
}

impl Formula<ANY> {
    /// Parses a formula in `R^dimension` like [`parse_with`](Formula::parse_with).
    ///
    /// # Errors
    ///
    /// [`TextError`] with the offending bytes.
    pub fn parse_in(
        dimension: usize,
        text: &str,
        parameters: &[(&str, f64)],
        tables: &[(&str, Arc<dyn Table>)],
    ) -> Result<Self, TextError> {
        Self::parsed(dimension, text, parameters, tables)
    }
}

/// The parameters, tables and definitions so far.
pub(super) type Names = HashMap<String, Meaning>;

/// What a name stands for.
#[derive(Clone)]
pub(super) enum Meaning {
    Value(Value),
    Table(Arc<dyn Table>),
}

pub(super) struct Parser<'a> {
    pub(super) tokens: Tokens<'a>,
    pub(super) ahead: (Token<'a>, Range<usize>),
    x: &'a [Symbol],
    /// The coordinates that have a row and a column of the matrix.
    coordinates: &'a [usize],
    pub(super) names: &'a mut Names,
    /// The number of levels of brackets that are open.
    pub(super) depth: usize,
    /// Whether all values are numbers of `f64`, and none is a step.
    pub(super) are_numbers: bool,
}

impl<'a> Parser<'a> {
    pub(super) fn new(
        text: &'a str,
        x: &'a [Symbol],
        coordinates: &'a [usize],
        names: &'a mut Names,
    ) -> Self {
        let (tokens, ahead) = (Tokens::of(text), (Token::End, 0..0));
        Self { tokens, ahead, x, coordinates, names, depth: 0, are_numbers: false }
    }

    pub(super) fn define(&mut self, name: &str, value: Value) -> Result<(), TextError> {
        self.check_new(name)?;
        self.names.insert(name.to_owned(), Meaning::Value(value));
        Ok(())
    }

    /// Gives a table a name.
    pub(super) fn define_table(
        &mut self,
        name: &str,
        table: &Arc<dyn Table>,
    ) -> Result<(), TextError> {
        self.check_new(name)?;
        // `height_1` would be the derivative of `height` and something else.
        let is_derivative = |other: &&String| {
            let digits = other.strip_prefix(name).and_then(|rest| rest.strip_prefix('_'));
            digits.is_some_and(|digits| orders_of(digits, &**table).is_some())
        };
        if let Some(name) = self.names.keys().find(is_derivative) {
            return self.error(Problem::TakenName { name: name.clone() });
        }
        self.names.insert(name.to_owned(), Meaning::Table(Arc::clone(table)));
        Ok(())
    }

    /// Defines the name that is the whole text.
    pub(super) fn define_itself(&mut self, value: Value) -> Result<(), TextError> {
        self.advance()?;
        let name = self.new_name()?;
        self.names.insert(name, Meaning::Value(value));
        if self.ahead.0 == Token::End { Ok(()) } else { self.unexpected("the end of a name") }
    }

    /// Parses a text that is an expression and nothing else.
    pub(super) fn whole_expression(&mut self) -> Result<Value, TextError> {
        self.advance()?;
        let value = self.expression()?;
        if self.ahead.0 == Token::End {
            Ok(value)
        } else {
            self.unexpected("an operator or the end")
        }
    }

    pub(super) fn advance(&mut self) -> Result<(Token<'a>, Range<usize>), TextError> {
        let next = self.tokens.word()?;
        Ok(std::mem::replace(&mut self.ahead, next))
    }

    pub(super) fn error<T>(&self, problem: Problem) -> Result<T, TextError> {
        Err(TextError { at: self.ahead.1.clone(), problem })
    }

    pub(super) fn unexpected<T>(&self, expected: &'static str) -> Result<T, TextError> {
        let found = match self.ahead.0 {
            Token::Number(value) => format!("{value:?}"),
            Token::Integer(word) | Token::Name(word) => word.to_owned(),
            Token::Sign(sign) => sign.to_string(),
            Token::End => "the end".to_owned(),
        };
        self.error(Problem::Unexpected { found, expected })
    }

    pub(super) fn sign(&mut self, sign: char, expected: &'static str) -> Result<(), TextError> {
        if self.takes(sign)? { Ok(()) } else { self.unexpected(expected) }
    }

    /// Consumes this sign if it comes next, and returns whether it did.
    pub(super) fn takes(&mut self, sign: char) -> Result<bool, TextError> {
        let is_next = self.is(sign);
        if is_next {
            self.advance()?;
        }
        Ok(is_next)
    }

    fn is(&self, sign: char) -> bool {
        self.ahead.0 == Token::Sign(sign)
    }

    /// Parses the matrix, and returns its entries column by column.
    pub(super) fn metric(&mut self) -> Result<Vec<Symbol>, TextError> {
        while self.is_definition()? {
            self.definition()?;
        }
        let entries = if self.is('[') {
            self.matrix()?
        } else if let Some(form) = self.named_form()? {
            self.form(form)?
        } else {
            self.multiple_of_identity()?
        };
        match self.ahead.0 {
            Token::End => Ok(entries),
            _ => self.unexpected("the end"),
        }
    }

    /// Returns whether the next two words are a name and an `=` or a comma.
    fn is_definition(&self) -> Result<bool, TextError> {
        let Token::Name(_) = self.ahead.0 else { return Ok(false) };
        let (next, _) = self.tokens.clone().word()?;
        Ok(matches!(next, Token::Sign('=' | ',')))
    }

    fn definition(&mut self) -> Result<(), TextError> {
        let first = self.new_name()?;
        if self.takes(',')? {
            let second = self.new_name()?;
            if first == second {
                return self.error(Problem::TakenName { name: second });
            }
            self.sign('=', "=")?;
            let (a, b) = self.pair()?;
            self.names.insert(first, Meaning::Value(Value::Symbol(a)));
            self.names.insert(second, Meaning::Value(Value::Symbol(b)));
        } else {
            self.sign('=', "=")?;
            let value = self.expression()?;
            self.names.insert(first, Meaning::Value(value));
        }
        self.sign(';', "an operator or ;")
    }

    fn new_name(&mut self) -> Result<String, TextError> {
        let Token::Name(name) = self.ahead.0 else { return self.unexpected("a name") };
        self.check_new(name)?;
        self.advance()?;
        Ok(name.to_owned())
    }

    pub(super) fn check_new(&self, name: &str) -> Result<(), TextError> {
        let is_word = ["I", "sin_cos", "sinh_cosh", STEP].contains(&name);
        if is_word
            || Function::named(name).is_some()
            || self.names.contains_key(name)
            || self.derivative(name).is_some()
            || !matches!(self.builtin(name), Ok(None))
        {
            return self.error(Problem::TakenName { name: name.to_owned() });
        }
        Ok(())
    }

    /// Returns the value of `pi` or of a coordinate.
    pub(super) fn builtin(&self, name: &str) -> Result<Option<Value>, Problem> {
        if name == "pi" {
            return Ok(Some(Value::Number(std::f64::consts::PI)));
        }
        let digits = name.strip_prefix('x').filter(|digits| !digits.is_empty());
        let Some(digits) = digits.filter(|digits| digits.bytes().all(|byte| byte.is_ascii_digit()))
        else {
            return Ok(None);
        };
        let place = digits.parse::<usize>().ok().and_then(|i| i.checked_sub(1));
        match place.and_then(|i| self.x.get(i)) {
            // `x01` is not a coordinate.
            Some(&x) if !digits.starts_with('0') => Ok(Some(Value::Symbol(x))),
            _ => Err(Problem::NoCoordinate { name: name.to_owned(), dimension: self.x.len() }),
        }
    }

    fn matrix(&mut self) -> Result<Vec<Symbol>, TextError> {
        let dimension = self.coordinates.len();
        let at = self.advance()?.1;
        let mut rows: Vec<Vec<Symbol>> = Vec::new();
        loop {
            let start = self.ahead.1.start;
            let row = self.row(Value::symbol)?;
            if !self.is(';') && !self.is(']') {
                return self.unexpected("an operator, a comma, ; or ]");
            }
            if row.len() != dimension {
                let problem =
                    Problem::Shape { found: row.len(), what: "entries in a row", dimension };
                return Err(TextError { at: start..self.ahead.1.start, problem });
            }
            rows.push(row);
            if !self.takes(';')? {
                break;
            }
        }
        let end = self.advance()?.1.end;
        if rows.len() != dimension {
            let problem = Problem::Shape { found: rows.len(), what: "rows", dimension };
            return Err(TextError { at: at.start..end, problem });
        }
        Ok((0..dimension).flat_map(|j| rows.iter().map(move |row| row[j])).collect())
    }

    /// Parses expressions between commas, and applies `of` to each before it parses the next.
    pub(super) fn row<T>(&mut self, of: fn(Value) -> T) -> Result<Vec<T>, TextError> {
        let mut row = vec![of(self.expression()?)];
        while self.takes(',')? {
            row.push(of(self.expression()?));
        }
        Ok(row)
    }

    /// Returns the form whose name comes next, if a bracket follows.
    fn named_form(&self) -> Result<Option<Form>, TextError> {
        let Token::Name(name) = self.ahead.0 else { return Ok(None) };
        let (next, _) = self.tokens.clone().word()?;
        let is_form = next == Token::Sign('(') && !self.names.contains_key(name);
        Ok(form(name).filter(|_| is_form))
    }

    /// Parses a metric that is `cost(f)` or `speed(f)`, and returns which one it is, and `f`; `None` for
    /// another metric, which is not parsed to its end.
    pub(super) fn squared(&mut self) -> Result<Option<(Form, Value)>, TextError> {
        while self.is_definition()? {
            self.definition()?;
        }
        let Some(form @ (Form::Cost | Form::Speed)) = self.named_form()? else { return Ok(None) };
        // There is one function.
        Ok(self.functions(form)?.pop().map(|function| (form, function)))
    }

    /// Parses the functions of a form in brackets, and returns the entries of its matrix.
    fn form(&mut self, form: Form) -> Result<Vec<Symbol>, TextError> {
        let functions = self.functions(form)?;
        Ok(form.entries(&functions, self.coordinates))
    }

    /// Parses a form with its functions in brackets, and returns them.
    fn functions(&mut self, form: Form) -> Result<Vec<Value>, TextError> {
        let at = self.advance()?.1;
        self.sign('(', "(")?;
        let functions = self.row(|value| value)?;
        if !self.is(')') {
            return self.unexpected("an operator, a comma or )");
        }
        let end = self.advance()?.1.end;
        let dimension = self.coordinates.len();
        if !form.takes(functions.len(), dimension) {
            let (found, (form, takes)) = (functions.len(), form.takes_what(dimension));
            let problem = Problem::Functions { form, takes, found, dimension };
            return Err(TextError { at: at.start..end, problem });
        }
        Ok(functions)
    }

    fn multiple_of_identity(&mut self) -> Result<Vec<Symbol>, TextError> {
        let value = self.expression()?.symbol();
        if self.ahead.0 != Token::Name("I") {
            return self.unexpected("an operator, or the identity I");
        }
        self.advance()?;
        let dimension = self.coordinates.len();
        let places = (0..dimension).flat_map(|j| (0..dimension).map(move |i| i == j));
        let zero = Value::Number(0.0).symbol();
        Ok(places.map(|is_diagonal| if is_diagonal { value } else { zero }).collect())
    }
}
