//! Reading certificates. Everything that the format does not name is an error.

use std::sync::Arc;

use nalgebra::SVector;
use tautline_formula::{Formula, spline::Spline};
use tautline_scalar::Table;
use tautline_sets::{AxisBox, Ball, HalfSpace, Point, Shape};

use crate::{Certificate, CheckError, Cubes, Level, Place, Region};

/// A certificate whose dimension is a value.
#[derive(Clone, Debug, PartialEq)]
pub enum AnyCertificate {
    /// On the line.
    Line(Certificate<1>),
    /// In the plane.
    Plane(Certificate<2>),
    /// In space.
    Space(Certificate<3>),
    /// In four dimensions.
    Four(Certificate<4>),
}

impl AnyCertificate {
    /// Reads a certificate from its text.
    ///
    /// # Errors
    ///
    /// [`CheckError::Line`] with the place and what should be there; [`CheckError::Dimension`];
    /// the errors of cubes and levels.
    pub fn read(text: &str) -> Result<Self, CheckError> {
        let mut lines = Lines { text: text.split('\n').collect(), at: 0, bytes: text.len() };
        // What follows the last line feed is no line.
        let is_whole = lines.text.pop() == Some("");
        lines.expect("tautline-distance 1", "\"tautline-distance 1\"")?;
        if !is_whole {
            lines.at = lines.text.len() + 1;
            return Err(lines.error("a line feed at the end"));
        }
        let dimension = lines.words("dimension", "dimension D", 1)?;
        let dimension = lines.integer(dimension[0], "dimension D")?;
        match dimension {
            1 => lines.certificate().map(Self::Line),
            2 => lines.certificate().map(Self::Plane),
            3 => lines.certificate().map(Self::Space),
            4 => lines.certificate().map(Self::Four),
            _ => Err(CheckError::Dimension { dimension }),
        }
    }
}

/// The most tables.
const TABLES: usize = 1024;

/// A table and the name by which the formula calls it.
type Named = (String, Arc<dyn Table>);

/// The lines of a file, and the one to be read next.
struct Lines<'t> {
    text: Vec<&'t str>,
    at: usize,
    /// The length of the whole file.
    bytes: usize,
}

impl<'t> Lines<'t> {
    /// Returns the error that the line read last is not `expected`.
    fn error(&self, expected: &'static str) -> CheckError {
        let line = self.at.max(1);
        let found = self.text.get(line - 1).map_or("", |line| *line);
        // A file of another kind may have long lines.
        CheckError::Line { line, expected, found: found.chars().take(80).collect() }
    }

    fn next(&mut self, expected: &'static str) -> Result<&'t str, CheckError> {
        self.at += 1;
        self.text.get(self.at - 1).copied().ok_or_else(|| self.error(expected))
    }

    fn expect(&mut self, line: &str, expected: &'static str) -> Result<(), CheckError> {
        if self.next(expected)? == line { Ok(()) } else { Err(self.error(expected)) }
    }

    /// Returns whether the next line begins with this word.
    fn begins(&self, word: &str) -> bool {
        self.text.get(self.at).is_some_and(|line| line.split(' ').next() == Some(word))
    }

    /// Returns the words after `first` of the next line, of which there are `count`.
    fn words(
        &mut self,
        first: &str,
        expected: &'static str,
        count: usize,
    ) -> Result<Vec<&'t str>, CheckError> {
        let mut words = self.next(expected)?.split(' ');
        let is_first = words.next() == Some(first);
        let words: Vec<&str> = words.collect();
        if is_first && words.len() == count { Ok(words) } else { Err(self.error(expected)) }
    }

    /// Returns an integer without leading zeros or signs that are not needed.
    fn integer<T: std::str::FromStr + ToString>(
        &self,
        word: &str,
        expected: &'static str,
    ) -> Result<T, CheckError> {
        let value: Option<T> = word.parse().ok();
        value.filter(|value| value.to_string() == word).ok_or_else(|| self.error(expected))
    }

    /// Returns the doubles with these bits.
    fn doubles(&self, words: &[&str], expected: &'static str) -> Result<Vec<f64>, CheckError> {
        let is_digit = |c: u8| c.is_ascii_digit() || (b'a'..=b'f').contains(&c);
        let double = |word: &&str| {
            let is_bits = word.len() == 16 && word.bytes().all(is_digit);
            let bits = u64::from_str_radix(word, 16).ok().filter(|_| is_bits);
            bits.map(f64::from_bits).ok_or_else(|| self.error(expected))
        };
        words.iter().map(double).collect()
    }

    /// Reads `count` doubles on a line.
    fn row(&mut self, expected: &'static str, count: usize) -> Result<Vec<f64>, CheckError> {
        let words: Vec<&str> = self.next(expected)?.split(' ').collect();
        if words.len() != count {
            return Err(self.error(expected));
        }
        self.doubles(&words, expected)
    }

    /// Reads what follows the dimension.
    fn certificate<const D: usize>(mut self) -> Result<Certificate<D>, CheckError> {
        let tables = self.tables()?;
        let formula = self.formula(&tables)?;
        let sets = [self.set("from")?, self.set("to")?];
        let hi = self.words("hi", "hi BITS", 1)?;
        let hi = self.doubles(&hi, "hi BITS")?[0];
        let region = self.region()?;
        let mut curve = None;
        if self.begins("curve") {
            let expected = "curve COUNT";
            let count = self.words("curve", expected, 1)?;
            let count: usize = self.integer(count[0], expected)?;
            let mut points = Vec::new();
            for _ in 0..count {
                points.push(SVector::from_iterator(self.row("a point of the curve", D)?));
            }
            curve = Some(points);
        }
        let mut levels = Vec::new();
        while self.begins("level") {
            levels.push(self.level(levels.len())?);
        }
        self.expect("end", "\"level\" or \"end\"")?;
        if self.at < self.text.len() {
            self.at += 1;
            return Err(self.error("nothing after \"end\""));
        }
        Ok(Certificate { formula, sets, hi, region, curve, levels })
    }

    /// Reads the tables that the formula calls.
    fn tables(&mut self) -> Result<Vec<Named>, CheckError> {
        let expected = "table with one to three lengths";
        let mut tables: Vec<Named> = Vec::new();
        while self.begins("table") {
            let shape: Vec<&str> = self.next(expected)?.split(' ').skip(1).collect();
            // Each call of the formula is compared with all tables.
            if tables.len() == TABLES {
                return Err(self.error("at most 1024 tables"));
            }
            let shape: Vec<usize> =
                shape.iter().map(|word| self.integer(word, expected)).collect::<Result<_, _>>()?;
            let Some((&last, others)) = shape.split_last() else {
                return Err(self.error(expected));
            };
            let rows = others.iter().try_fold(1_usize, |rows, &n| rows.checked_mul(n));
            let rows = rows.ok_or_else(|| self.error(expected))?;
            let at = self.at;
            let mut numbers = Vec::new();
            for _ in 0..rows {
                numbers.extend(self.row("a row of a table", last)?);
            }
            let spline = Spline::new(&shape, numbers).map_err(|_| {
                self.at = at;
                self.error("a table with one to three lengths and finite numbers")
            })?;
            tables.push((format!("table{}", tables.len() + 1), Arc::new(spline)));
        }
        Ok(tables)
    }

    /// Reads the formula, which has to be printed as the checker prints it.
    fn formula<const D: usize>(&mut self, tables: &[Named]) -> Result<Formula<D>, CheckError> {
        let expected = "metric COUNT";
        let count = self.words("metric", expected, 1)?;
        let count: usize = self.integer(count[0], expected)?;
        let expected = "a line of a formula";
        let first = self.at;
        for _ in 0..count {
            self.next(expected)?;
        }
        let lines = &self.text[first..self.at];
        let named: Vec<(&str, Arc<dyn Table>)> =
            tables.iter().map(|(name, table)| (name.as_str(), Arc::clone(table))).collect();
        let formula = Formula::parse_with(&lines.join("\n"), &[], &named).ok();
        let printed = formula.as_ref().map(ToString::to_string).unwrap_or_default();
        // Infinite numbers are printed as quotients.
        let is_line = |(line, printed): (&&str, &str)| *line == printed && !line.contains("/0)");
        let good = lines.iter().zip(printed.split('\n')).take_while(|&pair| is_line(pair)).count();
        let is_whole = good == count && printed.split('\n').count() == count;
        let calls_all = |formula: &Formula<D>| formula.tables().len() == tables.len();
        formula.filter(|formula| is_whole && calls_all(formula)).ok_or_else(|| {
            self.at = first + good + 1;
            self.error(expected)
        })
    }

    /// Reads the pieces of a set, one on each line.
    fn set<const D: usize>(&mut self, name: &'static str) -> Result<Shape<D>, CheckError> {
        let expected = "from or to, and point, ball, box or half-space";
        let mut pieces = Vec::new();
        while self.begins(name) {
            let words: Vec<&str> = self.next(expected)?.split(' ').collect();
            let Some((&kind, bits)) = words.get(1..).and_then(|words| words.split_first()) else {
                return Err(self.error(expected));
            };
            let numbers = self.doubles(bits, expected)?;
            let vector = |first: usize| {
                let part = numbers.get(first..first + D);
                part.map(|part| SVector::<f64, D>::from_iterator(part.iter().copied()))
            };
            let last = numbers.get(D).copied();
            let piece = match (kind, numbers.len()) {
                ("point", n) if n == D => {
                    vector(0).and_then(|x| Point::new(x).ok()).map(Shape::Point)
                }
                ("ball", n) if n == D + 1 => vector(0)
                    .zip(last)
                    .and_then(|(centre, r)| Ball::new(centre, r).ok())
                    .map(Shape::Ball),
                ("box", n) if n == 2 * D => vector(0)
                    .zip(vector(D))
                    .and_then(|(lower, upper)| AxisBox::from_corners(lower, upper).ok())
                    .map(Shape::AxisBox),
                ("half-space", n) if n == D + 1 => vector(0)
                    .zip(last)
                    .and_then(|(normal, offset)| HalfSpace::new(normal, offset).ok())
                    .map(Shape::HalfSpace),
                _ => None,
            };
            pieces.push(piece.ok_or_else(|| self.error(expected))?);
        }
        match pieces.len() {
            0 => {
                self.at += 1;
                Err(self.error(expected))
            }
            1 => Ok(pieces.remove(0)),
            _ => Ok(Shape::Union(pieces)),
        }
    }

    fn region(&mut self) -> Result<Region, CheckError> {
        let expected = "region tubes, declared, exit-one or exit-two";
        let words: Vec<&str> = self.next(expected)?.split(' ').collect();
        let Some(("region", words)) = words.split_first().map(|(first, rest)| (*first, rest))
        else {
            return Err(self.error(expected));
        };
        match words {
            ["tubes", radius, c1] => {
                let numbers = self.doubles(&[radius, c1], expected)?;
                Ok(Region::Tubes { radius: numbers[0], c1: numbers[1] })
            }
            ["declared", c1] => Ok(Region::Declared { c1: self.doubles(&[c1], expected)?[0] }),
            ["exit-one"] => Ok(Region::ExitOne),
            ["exit-two"] => Ok(Region::ExitTwo),
            _ => Err(self.error(expected)),
        }
    }

    fn level<const D: usize>(&mut self, number: usize) -> Result<Level<D>, CheckError> {
        let expected = "level EXPONENT RUNS NODES";
        let words = self.words("level", expected, 3)?;
        let exponent = self.integer(words[0], expected)?;
        let (runs, nodes): (usize, usize) =
            (self.integer(words[1], expected)?, self.integer(words[2], expected)?);
        // Every node has a line of two doubles, and there are more nodes than cubes: no more memory is
        // taken than the file is long.
        if nodes > (self.text.len() - self.at).min(self.bytes / 34) {
            return Err(self.error("no more nodes than lines"));
        }
        let expected = "a run of cubes after the one before";
        let mut places: Vec<Place<D>> = Vec::new();
        for _ in 0..runs {
            let words: Vec<&str> = self.next(expected)?.split(' ').collect();
            let numbers: Vec<i32> =
                words.iter().map(|word| self.integer(word, expected)).collect::<Result<_, _>>()?;
            let Some((&length, first)) = numbers.split_last().filter(|_| numbers.len() == D + 1)
            else {
                return Err(self.error(expected));
            };
            let fits = usize::try_from(length).is_ok_and(|length| places.len() + length <= nodes);
            if length < 1 || !fits {
                return Err(self.error(expected));
            }
            for step in 0..length {
                let mut place: Place<D> = std::array::from_fn(|i| first[i]);
                place[D - 1] = place[D - 1].saturating_add(step);
                if places.last().is_some_and(|last| *last >= place) {
                    return Err(self.error(expected));
                }
                places.push(place);
            }
        }
        let cubes = Cubes::new(exponent, places)?;
        let (mut u, mut v) = (Vec::new(), Vec::new());
        for _ in 0..nodes {
            let row = self.row("two values of a node", 2)?;
            u.push(row[0]);
            v.push(row[1]);
        }
        Level::new(number, cubes, [u, v])
    }
}
