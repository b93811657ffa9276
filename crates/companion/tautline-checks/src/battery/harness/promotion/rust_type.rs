//! `RustType`: a type, parsed from its name.

use std::{any::type_name, fmt};

use super::cursor::Cursor;

/// A type as `type_name` prints it, but without the paths.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RustType {
    Tuple(Vec<RustType>),
    /// `[T; N]`.
    Array(Box<RustType>, String),
    /// A name with its arguments, which may be numbers.
    Named(String, Vec<RustType>),
}

impl RustType {
    pub(super) fn of<T>() -> Self {
        read(&mut Cursor(type_name::<T>()))
    }

    /// Returns the numbers of rows and columns of a matrix of `nalgebra`.
    pub(super) fn shape(&self) -> Option<[&str; 2]> {
        match self {
            RustType::Named(name, arguments) if name == "Matrix" => {
                Some([arguments.get(1)?.number()?, arguments.get(2)?.number()?])
            }
            _ => None,
        }
    }

    /// Returns the `N` of `Const<N>`.
    fn number(&self) -> Option<&str> {
        match self {
            RustType::Named(name, arguments) if name == "Const" => match arguments.first()? {
                RustType::Named(number, _) => Some(number),
                _ => None,
            },
            _ => None,
        }
    }
}

/// Writes the type as in code that has its names in scope.
impl fmt::Display for RustType {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let joined = |types: &[RustType]| {
            types.iter().map(RustType::to_string).collect::<Vec<_>>().join(", ")
        };
        match (self, self.shape()) {
            (_, Some([rows, "1"])) => write!(f, "SVector<f64, {rows}>"),
            (_, Some([rows, columns])) => write!(f, "SMatrix<f64, {rows}, {columns}>"),
            (RustType::Tuple(types), _) => write!(f, "({})", joined(types)),
            (RustType::Array(element, count), _) => write!(f, "[{element}; {count}]"),
            (RustType::Named(name, types), _) if types.is_empty() => write!(f, "{name}"),
            (RustType::Named(name, types), _) => write!(f, "{name}<{}>", joined(types)),
        }
    }
}

/// Parses the name of a type. The compiler wrote the name, so it is well-formed.
fn read(rest: &mut Cursor<'_>) -> RustType {
    let arguments = |rest: &mut Cursor<'_>, end| {
        rest.list(end, |rest| (!rest.0.is_empty()).then(|| read(rest))).unwrap_or_default()
    };
    if rest.eat('(') {
        return RustType::Tuple(arguments(rest, ')'));
    }
    if rest.eat('[') {
        let element = read(rest);
        rest.eat(';');
        let count = word(rest);
        rest.eat(']');
        return RustType::Array(Box::new(element), count.to_owned());
    }
    let name = word(rest).rsplit("::").next().unwrap_or_default().to_owned();
    let arguments = if rest.eat('<') { arguments(rest, '>') } else { Vec::new() };
    RustType::Named(name, arguments)
}

fn word<'a>(rest: &mut Cursor<'a>) -> &'a str {
    rest.word(" ,;()[]<>")
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroUsize;

    use nalgebra::{SMatrix, SVector};
    use tautline::gallery::{Separable, Shear};
    use tautline_statements::{Known, Units};

    use super::RustType;

    #[test]
    fn a_type_is_printed_as_it_is_written_in_code() {
        type Nested = ((Known<Separable<3>, 3>, [SVector<f64, 2>; 2]), Units);
        assert_eq!(
            RustType::of::<Nested>().to_string(),
            "((Known<Separable<3>, 3>, [SVector<f64, 2>; 2]), Units)"
        );
        type Other = (Vec<[f64; 2]>, SMatrix<f64, 2, 3>, NonZeroUsize, (Shear, bool));
        let written = "(Vec<[f64; 2]>, SMatrix<f64, 2, 3>, NonZero<usize>, (Shear, bool))";
        assert_eq!(RustType::of::<Other>().to_string(), written);
    }
}
