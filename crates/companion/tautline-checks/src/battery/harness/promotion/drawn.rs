//! `Drawn`: a value, parsed from its `Debug` output.

use super::cursor::Cursor;

/// A value as `#[derive(Debug)]` writes it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Drawn {
    /// A number or a name.
    Word(String),
    /// `[…]`.
    List(Vec<Drawn>),
    /// `(…)`, or `Name(…)`.
    Tuple(String, Vec<Drawn>),
    /// `Name { field: …, … }`.
    Struct(String, Vec<(String, Drawn)>),
}

impl Drawn {
    /// Parses a value; returns `None` if the text does not have this form.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut rest = Cursor(text);
        let value = read(&mut rest)?;
        rest.0.trim().is_empty().then_some(value)
    }

    /// Returns a field of a struct.
    pub(super) fn field(&self, name: &str) -> Option<&Drawn> {
        match self {
            Drawn::Struct(_, fields) => fields.iter().find(|field| field.0 == name).map(|f| &f.1),
            _ => None,
        }
    }

    /// Returns the elements of a list or a tuple.
    pub(super) fn elements(&self) -> &[Drawn] {
        match self {
            Drawn::List(elements) | Drawn::Tuple(_, elements) => elements,
            _ => &[],
        }
    }
}

fn read(rest: &mut Cursor<'_>) -> Option<Drawn> {
    if rest.eat('[') {
        return Some(Drawn::List(rest.list(']', read)?));
    }
    let name = word(rest);
    if rest.eat('(') {
        return Some(Drawn::Tuple(name, rest.list(')', read)?));
    }
    if name.is_empty() {
        return None;
    }
    if !rest.eat('{') {
        return Some(Drawn::Word(name));
    }
    let field = |rest: &mut Cursor<'_>| {
        let name = word(rest);
        if rest.eat(':') { Some((name, read(rest)?)) } else { None }
    };
    Some(Drawn::Struct(name, rest.list('}', field)?))
}

fn word(rest: &mut Cursor<'_>) -> String {
    rest.word(" ,:()[]{}").to_owned()
}

#[cfg(test)]
mod tests {
    use super::Drawn;

    #[derive(Debug)]
    #[allow(dead_code, reason = "Debug reads them")]
    enum Any {
        Empty,
        One(f64),
        Two { point: [[f64; 2]; 1], numbers: Vec<u8> },
    }

    fn drawn(value: impl std::fmt::Debug) -> Drawn {
        Drawn::read(&format!("{value:?}")).expect("as derived")
    }

    fn word(text: &str) -> Drawn {
        Drawn::Word(text.to_owned())
    }

    #[test]
    fn derived_texts_are_read() {
        let list = |words: &[&str]| Drawn::List(words.iter().map(|text| word(text)).collect());
        assert_eq!(drawn(-1e-300), word("-1e-300"));
        assert_eq!(drawn(Any::Empty), word("Empty"));
        assert_eq!(drawn(Any::One(f64::NAN)), Drawn::Tuple("One".to_owned(), vec![word("NaN")]));
        let two = drawn((Any::Two { point: [[0.5, 2.0]], numbers: vec![] }, 3));
        let [first, second] = two.elements() else { panic!("{two:?}") };
        assert_eq!(first.field("point"), Some(&Drawn::List(vec![list(&["0.5", "2.0"])])));
        assert_eq!(first.field("numbers"), Some(&list(&[])));
        assert_eq!((first.field("other"), second), (None, &word("3")));
    }

    #[test]
    fn other_texts_are_not_read() {
        for text in ["", "a b", "[1, 2", "A { 1 }", "(1))"] {
            assert_eq!(Drawn::read(text), None, "{text}");
        }
    }
}
