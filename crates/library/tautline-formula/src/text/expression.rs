//! The part of the parser that reads expressions.

use std::sync::Arc;

use tautline_scalar::{Interval, Scalar, Table};

use super::{
    Problem, TextError,
    parser::{Meaning, Parser, STEP},
    token::Token,
    value::Value,
};
use crate::{
    operation::{Arithmetic, Function},
    recording::Symbol,
};

/// The largest depth of nested brackets. Each level takes stack.
const DEEPEST: usize = 128;

/// Returns the orders of a derivative of a table, given a digit for each axis.
pub(super) fn orders_of(digits: &str, table: &dyn Table) -> Option<[u8; 3]> {
    let mut orders = [0; 3];
    // Third derivatives jump.
    let is_order = |byte: u8| (b'0'..=b'2').contains(&byte);
    if digits.len() != table.axes() || !digits.bytes().all(is_order) {
        return None;
    }
    orders.iter_mut().zip(digits.bytes()).for_each(|(order, digit)| *order = digit - b'0');
    Some(orders)
}

impl Parser<'_> {
    pub(super) fn expression(&mut self) -> Result<Value, TextError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.error(Problem::TooDeep { most: DEEPEST });
        }
        let start = self.ahead.1.start;
        let mut sum = self.term()?;
        loop {
            let is_minus = self.takes('-')?;
            if !is_minus && !self.takes('+')? {
                break;
            }
            let term = self.term()?;
            let how = if is_minus { Arithmetic::Sub } else { Arithmetic::Add };
            sum = self.combined(start, how, sum, term)?;
        }
        self.depth -= 1;
        Ok(sum)
    }

    fn term(&mut self) -> Result<Value, TextError> {
        let start = self.ahead.1.start;
        let mut product = self.factor()?;
        loop {
            let is_division = self.takes('/')?;
            if !is_division && !self.takes('*')? {
                return Ok(product);
            }
            let factor = self.factor()?;
            let how = if is_division { Arithmetic::Div } else { Arithmetic::Mul };
            product = self.combined(start, how, product, factor)?;
        }
    }

    /// Returns the result of an operation whose operands begin at `start`.
    fn combined(
        &self,
        start: usize,
        how: Arithmetic,
        a: Value,
        b: Value,
    ) -> Result<Value, TextError> {
        let (Some(x), Some(y)) = (a.number(), b.number()) else { return Ok(how.of(a, b)) };
        let within = how.of(Interval::point(x), Interval::point(y));
        self.number(start, [x, y], how.of(x, y), within, || how.of(Symbol::constant(x), y))
    }

    /// Returns the result of arithmetic between numbers that begins at `start`, given its `value` in `f64`,
    /// bounds on it, and the same as steps: a number if that is exact or if numbers are needed, and the steps
    /// otherwise. `1/0` is a number, with which there is no further arithmetic.
    fn number(
        &self,
        start: usize,
        operands: [f64; 2],
        value: f64,
        within: Interval,
        steps: impl FnOnce() -> Symbol,
    ) -> Result<Value, TextError> {
        if let Some(number) = operands.iter().find(|number| !number.is_finite()) {
            let (at, number) = (start..self.ahead.1.start, number.to_string());
            return Err(TextError { at, problem: Problem::NotFinite { number } });
        }
        if !value.is_finite() {
            return Ok(Value::Number(value));
        }
        let is_exact = within.lo() == within.hi() && within.lo() == value;
        Ok(if self.are_numbers || is_exact { Value::Number(value) } else { Value::Symbol(steps()) })
    }

    fn factor(&mut self) -> Result<Value, TextError> {
        // A loop, so that many minus signs take no stack.
        let mut signs = 0_usize;
        while self.takes('-')? {
            signs += 1;
        }
        let mut value = self.power()?;
        for _ in 0..signs {
            value = -value;
        }
        Ok(value)
    }

    fn power(&mut self) -> Result<Value, TextError> {
        let start = self.ahead.1.start;
        let atom = self.atom()?;
        if !self.takes('^')? {
            return Ok(atom);
        }
        let is_negative = self.takes('-')?;
        let Token::Integer(digits) = self.ahead.0 else { return self.error(Problem::Exponent) };
        let sign = if is_negative { "-" } else { "" };
        let Ok(n) = format!("{sign}{digits}").parse::<i32>() else {
            return self.error(Problem::Exponent);
        };
        self.advance()?;
        match atom.number() {
            Some(a) => {
                let within = Interval::point(a).powi(n);
                self.number(start, [a, a], a.powi(n), within, || Symbol::constant(a).powi(n))
            }
            None => Ok(Value::Symbol(atom.symbol().powi(n))),
        }
    }

    fn bracket(&mut self) -> Result<Value, TextError> {
        self.sign('(', "(")?;
        let value = self.expression()?;
        self.sign(')', "an operator or )")?;
        Ok(value)
    }

    pub(super) fn pair(&mut self) -> Result<(Symbol, Symbol), TextError> {
        let both: fn(Symbol) -> (Symbol, Symbol) = match self.ahead.0 {
            Token::Name("sin_cos") => Scalar::sin_cos,
            Token::Name("sinh_cosh") => Scalar::sinh_cosh,
            _ => return self.unexpected("sin_cos or sinh_cosh"),
        };
        self.advance()?;
        Ok(both(self.bracket()?.symbol()))
    }

    fn atom(&mut self) -> Result<Value, TextError> {
        match self.ahead.0 {
            Token::Number(value) => {
                self.advance()?;
                Ok(Value::Number(value))
            }
            Token::Integer(digits) => {
                // The tokenizer has checked that the number is finite.
                let value = digits.parse().unwrap_or(f64::NAN);
                self.advance()?;
                Ok(Value::Number(value))
            }
            Token::Sign('(') => self.bracket(),
            Token::Name(name) => self.named(name),
            _ => self.unexpected("a number, a name, a function or ("),
        }
    }

    fn named(&mut self, name: &str) -> Result<Value, TextError> {
        match self.names.get(name) {
            Some(&Meaning::Value(value)) => return self.advance().map(|_| value),
            Some(Meaning::Table(table)) => {
                let table = Arc::clone(table);
                return self.tabulated(name, &table, [0; 3]);
            }
            None => {}
        }
        if let Some((table, orders)) = self.derivative(name) {
            return self.tabulated(name, &table, orders);
        }
        match self.builtin(name) {
            Ok(Some(value)) => return self.advance().map(|_| value),
            Ok(None) => {}
            Err(problem) => return self.error(problem),
        }
        let (next, _) = self.tokens.clone().word()?;
        if next != Token::Sign('(') {
            return self.error(Problem::UnknownName { name: name.to_owned() });
        }
        let function = Function::named(name);
        if function.is_none() && name != STEP {
            return self.error(Problem::UnknownFunction { name: name.to_owned() });
        }
        let start = self.advance()?.1.start;
        let value = self.bracket()?;
        match (function, value.number()) {
            (None, _) => Ok(Value::Symbol(value.symbol())),
            (Some(function), None) => Ok(Value::Symbol(function.of(value.symbol()))),
            (Some(function), Some(a)) => {
                let within = function.of(Interval::point(a));
                let steps = || function.of(Symbol::constant(a));
                self.number(start, [a, a], function.of(a), within, steps)
            }
        }
    }

    /// Returns the table of a name such as `height_10`, and the orders of the derivative.
    pub(super) fn derivative(&self, name: &str) -> Option<(Arc<dyn Table>, [u8; 3])> {
        let (name, digits) = name.rsplit_once('_')?;
        let Some(Meaning::Table(table)) = self.names.get(name) else { return None };
        let orders = orders_of(digits, &**table)?;
        Some((Arc::clone(table), orders))
    }

    /// Parses the arguments of a table.
    fn tabulated(
        &mut self,
        name: &str,
        table: &Arc<dyn Table>,
        orders: [u8; 3],
    ) -> Result<Value, TextError> {
        let at = self.advance()?.1;
        self.sign('(', "(")?;
        let arguments = self.row(Value::symbol)?;
        if arguments.len() != table.axes() {
            let (name, takes, found) = (name.to_owned(), table.axes(), arguments.len());
            let at = at.start..self.ahead.1.end;
            return Err(TextError { at, problem: Problem::Arguments { name, takes, found } });
        }
        self.sign(')', "an operator, a comma or )")?;
        Ok(Value::Symbol(Symbol::tabulated(table, orders, &arguments)))
    }
}
