//! Certificates as text. The format is described in `FORMAT.md` of this crate.

use std::fmt::{self, Display, Formatter};

use tautline_sets::Shape;

use crate::{Certificate, Level, Place, Region};

/// The bits of a double as 16 hexadecimal digits.
struct Bits(f64);

impl Display for Bits {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "{:016x}", self.0.to_bits())
    }
}

/// Numbers, each after a space.
struct All<'n>(&'n [f64]);

impl Display for All<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.0.iter().try_for_each(|&number| write!(f, " {}", Bits(number)))
    }
}

impl<const D: usize> Display for Certificate<D> {
    /// Writes the file that [`AnyCertificate::read`](crate::AnyCertificate::read) reads.
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        self.write_statement(f)?;
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
    fn write_statement(&self, f: &mut impl fmt::Write) -> fmt::Result {
        let formula = self.formula.to_string();
        writeln!(f, "tautline-distance 1")?;
        writeln!(f, "dimension {D}")?;
        writeln!(f, "metric {}", formula.lines().count())?;
        formula.lines().try_for_each(|line| writeln!(f, "{line}"))?;
        for (name, set) in ["from", "to"].into_iter().zip(&self.sets) {
            set.pieces().into_iter().try_for_each(|piece| write_piece(f, name, piece))?;
        }
        writeln!(f, "hi {}", Bits(self.hi))?;
        match self.region {
            Region::Tubes { radius, c1 } => writeln!(f, "region tubes{}", All(&[radius, c1])),
            Region::Declared { c1 } => writeln!(f, "region declared {}", Bits(c1)),
            Region::ExitOne => writeln!(f, "region exit-one"),
            Region::ExitTwo => writeln!(f, "region exit-two"),
        }
    }

    /// Returns the text of what the certificate is about: the metric, the sets, `hi` and the region.
    /// Two certificates with the same text make statements about the same distance.
    #[must_use]
    pub fn statement(&self) -> String {
        let mut text = String::new();
        // Writing to a string does not fail.
        let _ = self.write_statement(&mut text);
        text
    }
}

fn write_piece<const D: usize>(
    f: &mut impl fmt::Write,
    name: &str,
    piece: &Shape<D>,
) -> fmt::Result {
    let of = |vector: &nalgebra::SVector<f64, D>| All(vector.as_slice()).to_string();
    match piece {
        Shape::Point(point) => writeln!(f, "{name} point{}", of(point.position())),
        Shape::Ball(ball) => writeln!(f, "{name} ball{} {}", of(ball.centre()), Bits(ball.r())),
        Shape::AxisBox(side) => writeln!(f, "{name} box{}{}", of(side.lower()), of(side.upper())),
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given();
            writeln!(f, "{name} half-space{} {}", of(normal), Bits(offset))
        }
        // Its pieces are written, each on its own line.
        Shape::Union(_) => Ok(()),
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
    let (first, rest) = numbers.split_first().ok_or(fmt::Error)?;
    writeln!(f, "{}{}", Bits(*first), All(rest))
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
