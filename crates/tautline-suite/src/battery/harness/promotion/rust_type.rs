//! `RustType`: a type, read from its name.

use std::{any::type_name, fmt};

/// A type as `type_name` writes it, without the paths.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum RustType {
    Tuple(Vec<RustType>),
    /// `[T; N]`.
    Array(Box<RustType>, String),
    /// A name with its arguments, of which some are numbers.
    Named(String, Vec<RustType>),
}

impl RustType {
    pub(super) fn of<T>() -> Self {
        let mut rest = type_name::<T>();
        read(&mut rest)
    }

    /// The rows and columns of a matrix of `nalgebra`.
    pub(super) fn shape(&self) -> Option<[&str; 2]> {
        match self {
            RustType::Named(name, arguments) if name == "Matrix" => {
                Some([arguments.get(1)?.number()?, arguments.get(2)?.number()?])
            }
            _ => None,
        }
    }

    /// `N` of `Const<N>`.
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

/// As one writes it where the names are in scope.
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

fn read(rest: &mut &str) -> RustType {
    if eat(rest, '(') {
        return RustType::Tuple(arguments(rest, ')'));
    }
    if eat(rest, '[') {
        let element = read(rest);
        eat(rest, ';');
        let count = word(rest);
        eat(rest, ']');
        return RustType::Array(Box::new(element), count);
    }
    let name = word(rest);
    let name = name.rsplit("::").next().unwrap_or_default().to_owned();
    let arguments = if eat(rest, '<') { arguments(rest, '>') } else { Vec::new() };
    RustType::Named(name, arguments)
}

fn arguments(rest: &mut &str, end: char) -> Vec<RustType> {
    let mut all = Vec::new();
    while !rest.is_empty() && !eat(rest, end) {
        all.push(read(rest));
        eat(rest, ',');
    }
    all
}

fn eat(rest: &mut &str, expected: char) -> bool {
    let after = rest.trim_start().strip_prefix(expected);
    *rest = after.unwrap_or(rest);
    after.is_some()
}

fn word(rest: &mut &str) -> String {
    let text = rest.trim_start();
    let end = text.find(|c: char| " ,;()[]<>".contains(c)).unwrap_or(text.len());
    let (word, after) = text.split_at(end);
    *rest = after;
    word.to_owned()
}

#[cfg(test)]
mod tests {
    use std::num::NonZeroUsize;

    use nalgebra::{SMatrix, SVector};
    use tautline::gallery::{Separable, Shear};
    use tautline_statements::{Known, Units};

    use super::RustType;

    #[test]
    fn a_type_reads_as_one_writes_it() {
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
