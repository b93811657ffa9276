//! A text becomes a formula.

use std::{collections::HashMap, ops::Range};

use tautline_scalar::Scalar;

use super::{
    Problem, TextError,
    form::{Form, form},
    token::{Token, Tokens},
    value::{Value, function},
};
use crate::{
    Formula,
    recording::{Symbol, record},
};

/// So many levels of brackets; each takes some stack.
const DEEPEST: usize = 128;

impl<const D: usize> Formula<D> {
    /// Reads a formula, with numbers for the names of these parameters.
    ///
    /// ```text
    /// metric = { definition ";" } ( matrix | expr "I" | form "(" row ")" )
    /// matrix = "[" row { ";" row } "]"          row = expr { "," expr }
    /// form   = "pullback" | "graph" | "phi" | "speed" | "diag"
    /// expr   = term { ( "+" | "-" ) term }      term = factor { ( "*" | "/" ) factor }
    /// factor = "-" factor | atom [ ( "^" | "**" ) [ "-" ] integer ]
    /// atom   = number | name | function "(" expr ")" | "(" expr ")"
    /// definition = name "=" expr | name "," name "=" ( "sin_cos" | "sinh_cosh" ) "(" expr ")"
    /// ```
    ///
    /// Names are `x1` to `xD`, `pi`, those of parameters, and those that are defined, each once. Functions
    /// are `sqr`, `recip`, `sqrt`, `exp`, `ln`, `sin`, `cos`, `tan`, `atan`, `sinh`, `cosh`, `tanh`, and
    /// `number`, which makes a step of a number.
    ///
    /// A form makes the matrix of functions, of which it takes the derivatives where it needs them:
    /// `pullback(Φ₁, …, Φₘ)` is `JᵀJ` with the derivative `J` of the map `Φ`, `m ≥ D`; `graph(f)` is
    /// `I + ∇f ∇fᵀ`; `phi(φ)` is `φ I`; `speed(f)` is `f² I`, under which a curve is `∫ f |γ'| dt` long; and
    /// `diag(a₁, …, a_D)` is the diagonal matrix. A text may give their names to something else.
    ///
    /// What stands left is evaluated first, and numbers among themselves are evaluated as `f64`. A text does
    /// what the same formula does in Rust: the tapes are equal where the definitions stand in the order of
    /// the lets.
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
    /// let hill = Formula::<2>::parse("graph(h*exp(-(x1^2 + x2^2)/2))", &[("h", 2.0)])?;
    /// let text = "g = 2*exp(-(x1^2 + x2^2)/2); [1 + (x1*g)^2, x1*x2*g^2; x1*x2*g^2, 1 + (x2*g)^2]";
    /// let (x, by_hand) = ([0.5, -1.0].into(), Formula::<2>::parse(text, &[])?);
    /// assert!((hill.gram(&x) - by_hand.gram(&x)).amax() < 1e-15);
    /// # Ok::<(), tautline_formula::TextError>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`TextError`], with the bytes that are wrong.
    pub fn parse(text: &str, parameters: &[(&str, f64)]) -> Result<Self, TextError> {
        let (entries, recording) = record(D, |x| {
            let (tokens, ahead, names) = (Tokens::of(text), (Token::End, 0..0), HashMap::new());
            let mut parser = Parser { tokens, ahead, x, names, depth: 0 };
            for &(name, value) in parameters {
                parser.check_new(name)?;
                parser.names.insert(name.to_owned(), Value::Number(value));
            }
            parser.advance()?;
            parser.metric()
        });
        let end = text.len()..text.len();
        Self::of(&entries?, &recording)
            .map_err(|error| TextError { at: end, problem: error.into() })
    }
}

struct Parser<'a> {
    tokens: Tokens<'a>,
    ahead: (Token<'a>, Range<usize>),
    x: &'a [Symbol],
    names: HashMap<String, Value>,
    depth: usize,
}

impl<'a> Parser<'a> {
    fn advance(&mut self) -> Result<(Token<'a>, Range<usize>), TextError> {
        let next = self.tokens.word()?;
        Ok(std::mem::replace(&mut self.ahead, next))
    }

    fn error<T>(&self, problem: Problem) -> Result<T, TextError> {
        Err(TextError { at: self.ahead.1.clone(), problem })
    }

    fn unexpected<T>(&self, expected: &'static str) -> Result<T, TextError> {
        let found = match self.ahead.0 {
            Token::Number(value) => format!("{value:?}"),
            Token::Integer(word) | Token::Name(word) => word.to_owned(),
            Token::Sign(sign) => sign.to_string(),
            Token::End => "the end".to_owned(),
        };
        self.error(Problem::Unexpected { found, expected })
    }

    fn sign(&mut self, sign: char, expected: &'static str) -> Result<(), TextError> {
        if self.ahead.0 == Token::Sign(sign) {
            self.advance()?;
            return Ok(());
        }
        self.unexpected(expected)
    }

    fn is(&self, sign: char) -> bool {
        self.ahead.0 == Token::Sign(sign)
    }

    /// The entries, column by column.
    fn metric(&mut self) -> Result<Vec<Symbol>, TextError> {
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

    /// Whether a name and an `=` or a comma stand next: a look at two words.
    fn is_definition(&self) -> Result<bool, TextError> {
        let Token::Name(_) = self.ahead.0 else { return Ok(false) };
        let (next, _) = self.tokens.clone().word()?;
        Ok(matches!(next, Token::Sign('=' | ',')))
    }

    fn definition(&mut self) -> Result<(), TextError> {
        let first = self.new_name()?;
        if self.is(',') {
            self.advance()?;
            let second = self.new_name()?;
            if first == second {
                return self.error(Problem::TakenName { name: second });
            }
            self.sign('=', "=")?;
            let (a, b) = self.pair()?;
            self.names.insert(first, Value::Symbol(a));
            self.names.insert(second, Value::Symbol(b));
        } else {
            self.sign('=', "=")?;
            let value = self.expression()?;
            self.names.insert(first, value);
        }
        self.sign(';', "an operator or ;")
    }

    fn new_name(&mut self) -> Result<String, TextError> {
        let Token::Name(name) = self.ahead.0 else { return self.unexpected("a name") };
        self.check_new(name)?;
        self.advance()?;
        Ok(name.to_owned())
    }

    fn check_new(&self, name: &str) -> Result<(), TextError> {
        let is_word = ["I", "sin_cos", "sinh_cosh"].contains(&name) || function(name).is_some();
        if is_word || self.names.contains_key(name) || !matches!(self.builtin(name), Ok(None)) {
            return self.error(Problem::TakenName { name: name.to_owned() });
        }
        Ok(())
    }

    /// The value of `pi` and of a coordinate.
    fn builtin(&self, name: &str) -> Result<Option<Value>, Problem> {
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
            // Not `x01`.
            Some(&x) if !digits.starts_with('0') => Ok(Some(Value::Symbol(x))),
            _ => Err(Problem::NoCoordinate { name: name.to_owned(), dimension: self.x.len() }),
        }
    }

    fn matrix(&mut self) -> Result<Vec<Symbol>, TextError> {
        let dimension = self.x.len();
        let at = self.advance()?.1;
        let mut rows: Vec<Vec<Symbol>> = Vec::new();
        loop {
            let start = self.ahead.1.start;
            let mut row = vec![self.expression()?.symbol()];
            while self.is(',') {
                self.advance()?;
                row.push(self.expression()?.symbol());
            }
            if !self.is(';') && !self.is(']') {
                return self.unexpected("an operator, a comma, ; or ]");
            }
            if row.len() != dimension {
                let problem =
                    Problem::Shape { found: row.len(), what: "entries in a row", dimension };
                return Err(TextError { at: start..self.ahead.1.start, problem });
            }
            rows.push(row);
            if !self.is(';') {
                break;
            }
            self.advance()?;
        }
        let end = self.advance()?.1.end;
        if rows.len() != dimension {
            let problem = Problem::Shape { found: rows.len(), what: "rows", dimension };
            return Err(TextError { at: at.start..end, problem });
        }
        Ok((0..dimension).flat_map(|j| rows.iter().map(move |row| row[j])).collect())
    }

    /// The form of which the name and a bracket stand next.
    fn named_form(&self) -> Result<Option<Form>, TextError> {
        let Token::Name(name) = self.ahead.0 else { return Ok(None) };
        let (next, _) = self.tokens.clone().word()?;
        let is_form = next == Token::Sign('(') && !self.names.contains_key(name);
        Ok(form(name).filter(|_| is_form))
    }

    /// A matrix of functions, which stand in brackets behind its name.
    fn form(&mut self, form: Form) -> Result<Vec<Symbol>, TextError> {
        let at = self.advance()?.1;
        self.sign('(', "(")?;
        let mut functions = vec![self.expression()?];
        while self.is(',') {
            self.advance()?;
            functions.push(self.expression()?);
        }
        if !self.is(')') {
            return self.unexpected("an operator, a comma or )");
        }
        let end = self.advance()?.1.end;
        let dimension = self.x.len();
        if !form.takes(functions.len(), dimension) {
            let (found, (form, takes)) = (functions.len(), form.takes_what(dimension));
            let problem = Problem::Functions { form, takes, found, dimension };
            return Err(TextError { at: at.start..end, problem });
        }
        Ok(form.entries(&functions, dimension))
    }

    fn multiple_of_identity(&mut self) -> Result<Vec<Symbol>, TextError> {
        let value = self.expression()?.symbol();
        if self.ahead.0 != Token::Name("I") {
            return self.unexpected("an operator, or the identity I");
        }
        self.advance()?;
        let dimension = self.x.len();
        let places = (0..dimension).flat_map(|j| (0..dimension).map(move |i| i == j));
        let zero = Symbol::constant(0.0);
        Ok(places.map(|is_diagonal| if is_diagonal { value } else { zero }).collect())
    }

    fn expression(&mut self) -> Result<Value, TextError> {
        self.depth += 1;
        if self.depth > DEEPEST {
            return self.error(Problem::TooDeep { most: DEEPEST });
        }
        let mut sum = self.term()?;
        loop {
            let is_minus = self.is('-');
            if !(is_minus || self.is('+')) {
                break;
            }
            self.advance()?;
            let term = self.term()?;
            sum = if is_minus { sum - term } else { sum + term };
        }
        self.depth -= 1;
        Ok(sum)
    }

    fn term(&mut self) -> Result<Value, TextError> {
        let mut product = self.factor()?;
        loop {
            let is_division = self.is('/');
            if !(is_division || self.is('*')) {
                return Ok(product);
            }
            self.advance()?;
            let factor = self.factor()?;
            product = if is_division { product / factor } else { product * factor };
        }
    }

    fn factor(&mut self) -> Result<Value, TextError> {
        // In a loop: a row of minus signs is no bracket.
        let mut signs = 0_usize;
        while self.is('-') {
            self.advance()?;
            signs += 1;
        }
        let mut value = self.power()?;
        for _ in 0..signs {
            value = -value;
        }
        Ok(value)
    }

    fn power(&mut self) -> Result<Value, TextError> {
        let atom = self.atom()?;
        if !self.is('^') {
            return Ok(atom);
        }
        self.advance()?;
        let is_negative = self.is('-');
        if is_negative {
            self.advance()?;
        }
        let Token::Integer(digits) = self.ahead.0 else { return self.error(Problem::Exponent) };
        let sign = if is_negative { "-" } else { "" };
        let Ok(n) = format!("{sign}{digits}").parse::<i32>() else {
            return self.error(Problem::Exponent);
        };
        self.advance()?;
        Ok(atom.powi(n))
    }

    fn bracket(&mut self) -> Result<Value, TextError> {
        self.sign('(', "(")?;
        let value = self.expression()?;
        self.sign(')', "an operator or )")?;
        Ok(value)
    }

    fn pair(&mut self) -> Result<(Symbol, Symbol), TextError> {
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
                // Digits are a number of `f64`, finite as the word was read.
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
        if let Some(&value) = self.names.get(name) {
            self.advance()?;
            return Ok(value);
        }
        match self.builtin(name) {
            Ok(Some(value)) => {
                self.advance()?;
                return Ok(value);
            }
            Ok(None) => {}
            Err(problem) => return self.error(problem),
        }
        let (next, _) = self.tokens.clone().word()?;
        if next != Token::Sign('(') {
            return self.error(Problem::UnknownName { name: name.to_owned() });
        }
        let Some(function) = function(name) else {
            return self.error(Problem::UnknownFunction { name: name.to_owned() });
        };
        self.advance()?;
        Ok(self.bracket()?.under(function))
    }
}
