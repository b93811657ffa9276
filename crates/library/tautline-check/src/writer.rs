//! Certificates as text. The format is described in `FORMAT.md` of this crate.

use std::{
    any::Any,
    fmt::{self, Display, Formatter},
};

use sha2::{Digest, Sha256};
use tautline_formula::spline::Spline;
use tautline_sets::Shape;

use crate::{Certificate, Level, Place, Region};

/// How doubles are written, each after a space.
type Written = fn(&[f64]) -> String;

/// The bits of each double as 16 hexadecimal digits.
fn bits(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!(" {:016x}", number.to_bits())).collect()
}

/// The shortest decimals that are read as these doubles.
fn decimals(numbers: &[f64]) -> String {
    numbers.iter().map(|number| format!(" {number:?}")).collect()
}

impl<const D: usize> Display for Certificate<D> {
    /// Writes the file that [`AnyCertificate::read`](crate::AnyCertificate::read) reads.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.write_statement(f, bits, write_table)?;
        if let Some(points) = &self.curve {
            writeln!(f, "curve {}", points.len())?;
            points.iter().try_for_each(|x| write_row(f, x.as_slice()))?;
        }
        self.levels.iter().try_for_each(|level| write_level(f, level))?;
        writeln!(f, "end")
    }
}

impl<const D: usize> Certificate<D> {
    /// Writes what the certificate is about: the metric, the sets, `hi` and the region.
    fn write_statement<W: fmt::Write>(
        &self,
        f: &mut W,
        numbers: Written,
        table: impl Fn(&mut W, &Spline) -> fmt::Result,
    ) -> fmt::Result {
        let formula = self.formula.to_string();
        writeln!(f, "tautline-distance 1")?;
        writeln!(f, "dimension {D}")?;
        for known in self.formula.tables() {
            match (&**known as &dyn Any).downcast_ref() {
                Some(spline) => table(f, spline)?,
                // No reader accepts it.
                None => writeln!(f, "table unknown")?,
            }
        }
        writeln!(f, "metric {}", formula.lines().count())?;
        formula.lines().try_for_each(|line| writeln!(f, "{line}"))?;
        for (name, set) in ["from", "to"].into_iter().zip(&self.sets) {
            set.pieces().into_iter().try_for_each(|piece| write_piece(f, name, piece, numbers))?;
        }
        writeln!(f, "hi{}", numbers(&[self.hi]))?;
        match self.region {
            Region::Tubes { radius, c1 } => writeln!(f, "region tubes{}", numbers(&[radius, c1])),
            Region::Declared { c1 } => writeln!(f, "region declared{}", numbers(&[c1])),
            Region::ExitOne => writeln!(f, "region exit-one"),
            Region::ExitTwo => writeln!(f, "region exit-two"),
        }
    }

    /// Returns the first lines of the certificate, with decimals: the metric, the sets, `hi` and the
    /// region. Of a table it has the shape and a SHA-256 of the numbers. Two certificates with the same
    /// lines make statements about the same distance.
    #[must_use]
    pub fn statement(&self) -> String {
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = self.write_statement(&mut text, decimals, write_hash);
        text
    }
}

/// Writes the shape of a table and its numbers, those along the last axis on a line.
fn write_table(f: &mut impl fmt::Write, spline: &Spline) -> fmt::Result {
    write_shape(f, spline)?;
    writeln!(f)?;
    let last = spline.shape().last().copied().unwrap_or(1);
    let mut rows = spline.coefficients().chunks(last);
    rows.try_for_each(|row| writeln!(f, "{}", bits(row).trim_start()))
}

/// Writes the shape of a table, and the SHA-256 of its numbers, 8 bytes each, the lowest first.
fn write_hash(f: &mut impl fmt::Write, spline: &Spline) -> fmt::Result {
    let mut hash = Sha256::new();
    spline.coefficients().iter().for_each(|number| hash.update(number.to_bits().to_le_bytes()));
    write_shape(f, spline)?;
    f.write_str(" sha256 ")?;
    hash.finalize().iter().try_for_each(|byte| write!(f, "{byte:02x}"))?;
    writeln!(f)
}

fn write_shape(f: &mut impl fmt::Write, spline: &Spline) -> fmt::Result {
    f.write_str("table")?;
    spline.shape().iter().try_for_each(|length| write!(f, " {length}"))
}

fn write_piece<const D: usize>(
    f: &mut impl fmt::Write,
    name: &str,
    piece: &Shape<D>,
    numbers: Written,
) -> fmt::Result {
    let of = |vector: &nalgebra::SVector<f64, D>| numbers(vector.as_slice());
    let one = |number: f64| numbers(&[number]);
    match piece {
        Shape::Point(point) => writeln!(f, "{name} point{}", of(point.position())),
        Shape::Ball(ball) => writeln!(f, "{name} ball{}{}", of(ball.centre()), one(ball.r())),
        Shape::AxisBox(side) => writeln!(f, "{name} box{}{}", of(side.lower()), of(side.upper())),
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given();
            writeln!(f, "{name} half-space{}{}", of(normal), one(offset))
        }
        // Its pieces are written, each on its own line.
        Shape::Union(_) => Ok(()),
        // No reader accepts it.
        other => writeln!(f, "{name} {}", other.name()),
    }
}

fn write_level<const D: usize>(f: &mut Formatter<'_>, level: &Level<D>) -> fmt::Result {
    let cubes = level.cubes();
    let runs = runs(cubes.places());
    writeln!(f, "level {} {} {}", cubes.exponent(), runs.len(), level.nodes().len())?;
    for (first, length) in runs {
        first.iter().try_for_each(|k| write!(f, "{k} "))?;
        writeln!(f, "{length}")?;
    }
    let [u, v] = level.values();
    u.iter().zip(v).try_for_each(|(&u, &v)| write_row(f, &[u, v]))
}

fn write_row(f: &mut Formatter<'_>, numbers: &[f64]) -> fmt::Result {
    writeln!(f, "{}", bits(numbers).trim_start())
}

/// Returns the runs of cubes along the last axis: the first place and the number of cubes.
fn runs<const D: usize>(places: &[Place<D>]) -> Vec<(Place<D>, usize)> {
    let mut runs: Vec<(Place<D>, usize)> = Vec::new();
    for place in places {
        if let Some((first, length)) = runs.last_mut()
            && first[..D - 1] == place[..D - 1]
            && first[D - 1] + *length as i32 == place[D - 1]
        {
            *length += 1;
        } else {
            runs.push((*place, 1));
        }
    }
    runs
}
