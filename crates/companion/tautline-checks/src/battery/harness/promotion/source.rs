//! Writes values as Rust expressions, using the constructors of the types that the suite draws.

use std::collections::BTreeSet;

use super::{drawn::Drawn, rust_type::RustType};

/// Returns an expression of this type, which assumes that the [`names`] of its types are in scope.
pub(super) fn expression(value: &Drawn, kind: &RustType) -> String {
    match (kind, value) {
        _ if kind.shape().is_some() => matrix(value),
        (RustType::Tuple(kinds), Drawn::Tuple(_, values)) => {
            let sources = values.iter().zip(kinds).map(|(value, kind)| expression(value, kind));
            format!("({})", joined(sources))
        }
        (RustType::Array(kind, _), Drawn::List(values)) => {
            format!("[{}]", joined(values.iter().map(|value| expression(value, kind))))
        }
        (RustType::Named(name, kinds), Drawn::List(values)) if name == "Vec" => {
            let sources = values.iter().map(|value| expression(value, &kinds[0]));
            format!("vec![{}]", joined(sources))
        }
        (RustType::Named(name, _), number) if name == "NonZero" => {
            let number = plain(number);
            format!("{kind}::new({number}).expect(\"drawn\")").replacen('<', "::<", 1)
        }
        (RustType::Named(name, _), Drawn::Word(word)) if name == "Pace" => format!("Pace::{word}"),
        _ => constructed(value),
    }
}

fn joined(sources: impl Iterator<Item = String>) -> String {
    sources.collect::<Vec<_>>().join(", ")
}

/// Returns the sorted paths of the types that occur in the sources.
pub(super) fn names(sources: &[&String]) -> Vec<String> {
    let mut paths = BTreeSet::new();
    for source in sources {
        let part_of_a_name = |c: char| c.is_alphanumeric() || c == '_' || c == ':';
        for path in source.split(|c: char| !part_of_a_name(c)) {
            // This is Pace for Pace::Even, and no type for f64::INFINITY.
            let name = path.split(':').next().unwrap_or_default();
            let is_a_type = name.starts_with(|c: char| c.is_ascii_uppercase());
            if is_a_type && !["Some", "None", "Vec"].contains(&name) {
                paths.insert(format!("{}::{name}", home(name)));
            }
        }
    }
    paths.into_iter().collect()
}

/// Returns the module of a type.
fn home(name: &str) -> &'static str {
    match name {
        "NonZero" => "std::num",
        "Shear" | "Ramp" | "Bump" | "Lens" | "Hill" | "Separable" | "Constant" | "Valleys"
        | "Sphere" | "Hyperbolic" | "GaussianFisher" => "tautline::gallery",
        "Known" | "Units" | "WithConstants" => "tautline_statements",
        "SmoothCurve" | "KinkedCurve" | "Clock" | "Pace" => "tautline_statements::curves",
        "AnySetting" | "Nonnegatives" | "AnyTwoForms" => "tautline_checks::arbitrary",
        _ => "tautline",
    }
}

/// Writes a call of the constructor if the type has private fields, and otherwise a literal.
fn constructed(value: &Drawn) -> String {
    let name = match value {
        Drawn::Struct(name, _) | Drawn::Tuple(name, _) => name.as_str(),
        _ => return plain(value),
    };
    let field = |name| value.field(name).map_or(String::new(), plain);
    let point = |name| value.field(name).map_or(String::new(), coordinates);
    let points = |name: &str| {
        let all = value.field(name).map(Drawn::elements).unwrap_or_default();
        format!("vec![{}]", joined(all.iter().map(matrix)))
    };
    let made =
        |arguments: &[String]| format!("{name}::new({}).expect(\"drawn\")", arguments.join(", "));
    match name {
        "Shear" | "Ramp" => made(&[field("amplitude"), field("wave_number")]),
        "Bump" | "Lens" | "Hill" => made(&[field("height"), field("width")]),
        "Separable" => made(&[point("amplitudes"), point("wave_numbers")]),
        "Constant" => made(&[value.field("matrix").map_or(String::new(), matrix)]),
        "Ball" => made(&[point("centre"), field("r")]),
        "HalfSpace" => made(&[point("given_normal"), field("given_offset")]),
        "Point" => made(&[point("position")]),
        "Ends" if field("points") == "true" => {
            let place = |end| {
                let position = value.field(end).and_then(|point| point.field("position"));
                position.map_or(String::new(), coordinates)
            };
            format!("Ends::points({}, {}).expect(\"drawn\")", place("first"), place("second"))
        }
        "Ends" => made(&[field("first"), field("second")]),
        "AxisBox" => {
            let (lower, upper) = (point("lower"), point("upper"));
            format!("AxisBox::from_corners({lower}, {upper}).expect(\"drawn\")")
        }
        "FiniteSet" => {
            let points = value.field("points").map(Drawn::elements).unwrap_or_default();
            let places = points.iter().filter_map(|point| point.field("position"));
            made(&[format!("[{}]", joined(places.map(coordinates)))])
        }
        "Constants" => constants(value),
        "PointSequence" => {
            let numbers = value.field("coordinates").map(Drawn::elements).unwrap_or_default();
            let dimension = field("dimension").parse().unwrap_or(1);
            let point = |x: &[Drawn]| format!("SVector::from([{}])", joined(x.iter().map(plain)));
            made(&[format!("vec![{}]", joined(numbers.chunks(dimension).map(point)))])
        }
        "SmoothCurve" => {
            let waves = value.field("waves").map(Drawn::elements).unwrap_or_default();
            let pair = |wave: &Drawn| {
                let [sine, cosine] = wave.elements() else { return plain(wave) };
                format!("[{}, {}]", matrix(sine), matrix(cosine))
            };
            let waves = joined(waves.iter().map(pair));
            format!("SmoothCurve::new({}, vec![{waves}])", points("powers"))
        }
        "KinkedCurve" => kinked(value),
        "Clock" => {
            let (knots, pace) = (field("knots"), field("pace"));
            format!("Clock::through(&{knots}, Pace::{pace}).expect(\"drawn\")")
        }
        "AnySetting" | "Nonnegatives" | "AnyTwoForms" => {
            let numbers = match value {
                Drawn::Struct(_, fields) => joined(fields.iter().map(|field| plain(&field.1))),
                _ => joined(value.elements().iter().flat_map(Drawn::elements).map(plain)),
            };
            format!("{name}::of([{numbers}].into())")
        }
        _ => literal(name, value),
    }
}

/// Writes a struct whose fields are public.
fn literal(name: &str, value: &Drawn) -> String {
    match value {
        Drawn::Struct(_, fields) => {
            let fields = fields.iter().map(|(name, value)| format!("{name}: {}", plain(value)));
            format!("{name} {{ {} }}", joined(fields))
        }
        _ => format!("{name}({})", joined(value.elements().iter().map(plain))),
    }
}

fn constants(value: &Drawn) -> String {
    let field = |name| value.field(name).map_or(String::new(), plain);
    let numbers = ["c1", "c2", "l_h"].map(field).join(", ");
    let mut source = format!("Constants::new({numbers}).expect(\"drawn\")");
    if let Some([m_h]) = value.field("m_h").map(Drawn::elements) {
        source = format!("{source}.with_m_h({}).expect(\"drawn\")", plain(m_h));
    }
    for (flag, method) in [("isotropic", "isotropic"), ("local", "on_a_region")] {
        if field(flag) == "true" {
            source = format!("{source}.{method}()");
        }
    }
    source
}

fn kinked(value: &Drawn) -> String {
    let list = |name| value.field(name).map(Drawn::elements).unwrap_or_default();
    let (times, points) = (list("times"), list("points"));
    let [first, stops @ .., last] = points else { return plain(value) };
    let stops = times.iter().skip(1).zip(stops);
    let stops = joined(stops.map(|(time, point)| format!("({}, {})", plain(time), matrix(point))));
    format!(
        "KinkedCurve::new({}, [{stops}], {}).expect(\"drawn\")",
        coordinates(first),
        coordinates(last)
    )
}

/// Writes a value without knowing more about its type.
fn plain(value: &Drawn) -> String {
    match value {
        Drawn::Word(word) => match word.as_str() {
            "inf" => "f64::INFINITY".to_owned(),
            "-inf" => "f64::NEG_INFINITY".to_owned(),
            "NaN" => "f64::NAN".to_owned(),
            _ => word.clone(),
        },
        Drawn::List(elements) => {
            format!("[{}]", joined(elements.iter().map(plain)))
        }
        Drawn::Tuple(name, elements) if name.is_empty() => {
            format!("({})", joined(elements.iter().map(plain)))
        }
        _ => constructed(value),
    }
}

/// Writes a matrix of `nalgebra`; `Debug` prints its columns.
fn matrix(value: &Drawn) -> String {
    match value.elements() {
        [_] => format!("SVector::from({})", coordinates(value)),
        _ => format!("SMatrix::from({})", plain(value)),
    }
}

/// Writes the coordinates of a vector as an array. A vector of `nalgebra` is a list with one column.
fn coordinates(value: &Drawn) -> String {
    match value.elements() {
        [column @ Drawn::List(_)] => plain(column),
        _ => plain(value),
    }
}

#[cfg(test)]
mod tests {
    use std::num::NonZero;

    use nalgebra::{SMatrix, SVector};
    use tautline::{
        AxisBox, Ball, Constants, Ends, FiniteSet, HalfSpace, PointSequence,
        gallery::{Bump, Constant, Hill, Lens, Ramp, Separable, Shear, Valleys},
    };
    use tautline_statements::{
        Known, Units, WithConstants,
        curves::{Clock, KinkedCurve, Pace, SmoothCurve},
    };

    use super::super::Case;
    use crate::arbitrary::{AnySetting, AnyTwoForms, Nonnegatives};

    /// Compiles an expression of a type, and checks that the printed case has the same type and the
    /// same expression.
    macro_rules! reads_as_it_is_written {
        ($($kind:ty = $expression:expr;)*) => {
            $({
                let value: $kind = $expression;
                let same = |text: &str| text.split_whitespace().collect::<String>();
                let expected = [stringify!($kind), stringify!($expression)].map(same);
                assert_eq!(Case::new(0, &value).code.map(|text| same(&text)), expected);
            })*
        };
    }

    /// Each line compiles as written, and is what a failure would print.
    #[test]
    fn sources_compile_to_their_values() {
        reads_as_it_is_written! {
            (f64, i32, [bool; 2], f64) = (0.5, 3, [true, false], -1e-300);
            f64 = f64::INFINITY;
            (SVector<f64, 2>, SMatrix<f64, 2, 2>) =
                (SVector::from([1.0, 2.0]), SMatrix::from([[1.0, 2.0], [3.0, 4.0]]));
            [SVector<f64, 1>; 2] = [SVector::from([1.0]), SVector::from([2.0])];
            Shear = Shear::new(0.5, 2.0).expect("drawn");
            Ramp = Ramp::new(0.5, 2.0).expect("drawn");
            Bump = Bump::new(0.5, 2.0).expect("drawn");
            Lens = Lens::new(0.5, 2.0).expect("drawn");
            Hill = Hill::new(0.5, 2.0).expect("drawn");
            Separable<2> = Separable::new([0.5, 0.25], [1.0, 2.0]).expect("drawn");
            Constant<2> = Constant::new(SMatrix::from([[2.0, 0.0], [0.0, 1.0]])).expect("drawn");
            PointSequence<1> =
                PointSequence::new(vec![SVector::from([1.0]), SVector::from([2.0])]).expect("drawn");
            SmoothCurve<1> = SmoothCurve::new(
                vec![SVector::from([1.0])],
                vec![[SVector::from([1.0]), SVector::from([2.0])]]
            );
            KinkedCurve<1> =
                KinkedCurve::new([0.0], [(0.5, SVector::from([1.0]))], [2.0]).expect("drawn");
            Clock = Clock::through(&[[0.0, 0.0], [0.25, 0.5], [1.0, 1.0]], Pace::Smooth)
                .expect("drawn");
            Ball<2> = Ball::new([0.0, 1.0], 0.5).expect("drawn");
            HalfSpace<2> = HalfSpace::new([3.0, 4.0], 0.1).expect("drawn");
            Constants = Constants::new(1.0, 2.0, 3.0).expect("drawn")
                .with_m_h(4.0).expect("drawn").isotropic().on_a_region();
            Nonnegatives = Nonnegatives::of([1, 2].into());
            AnyTwoForms<1> = AnyTwoForms::of([1, 2, 3, 4, 5, 6, 7, 8].into());
            AnySetting = AnySetting::of([1, 2, 3, 4, 5, 6].into());
            NonZero<usize> = NonZero::<usize>::new(2).expect("drawn");
            Known<WithConstants<Valleys>, 2> = Known {
                metric: WithConstants {
                    metric: Valleys,
                    constants: Constants::new(1.0, 9.0, 4.0).expect("drawn")
                },
                ends: Ends::new(
                    AxisBox::from_corners([0.0, 0.0], [1.0, 1.0]).expect("drawn"),
                    FiniteSet::new([[2.0, 0.0], [3.0, 0.5]]).expect("drawn")
                ).expect("drawn"),
                distance: 1.5,
                distance_error: 1e-15
            };
            Ends<2> = Ends::points([0.0, 0.5], [1.0, 2.0]).expect("drawn");
            Units = Units { ell: 0.5, m: 2.0 };
        }
    }
}
