//! `Drawn`: a value, read from what `Debug` says of it.

/// A value as `#[derive(Debug)]` writes it.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Drawn {
    /// A number, a name.
    Word(String),
    /// `[…]`, and the number of brackets.
    List(Vec<Drawn>),
    /// `(…)`, or `Name(…)`.
    Tuple(String, Vec<Drawn>),
    /// `Name { field: …, … }`.
    Struct(String, Vec<(String, Drawn)>),
}

impl Drawn {
    /// Reads a value; `None` if the text is no such.
    pub(super) fn read(text: &str) -> Option<Self> {
        let mut rest = text;
        let value = read(&mut rest)?;
        rest.trim().is_empty().then_some(value)
    }

    /// The field of a struct.
    pub(super) fn field(&self, name: &str) -> Option<&Drawn> {
        match self {
            Drawn::Struct(_, fields) => fields.iter().find(|field| field.0 == name).map(|f| &f.1),
            _ => None,
        }
    }

    /// The elements of a list or of a tuple.
    pub(super) fn elements(&self) -> &[Drawn] {
        match self {
            Drawn::List(elements) | Drawn::Tuple(_, elements) => elements,
            _ => &[],
        }
    }
}

fn read(rest: &mut &str) -> Option<Drawn> {
    if eat(rest, '[') {
        return Some(Drawn::List(elements(rest, ']')?));
    }
    let word = word(rest);
    if eat(rest, '(') {
        return Some(Drawn::Tuple(word, elements(rest, ')')?));
    }
    if word.is_empty() {
        return None;
    }
    if !eat(rest, '{') {
        return Some(Drawn::Word(word));
    }
    let mut fields = Vec::new();
    while !eat(rest, '}') {
        let name = self::word(rest);
        if !eat(rest, ':') {
            return None;
        }
        fields.push((name, read(rest)?));
        eat(rest, ',');
    }
    Some(Drawn::Struct(word, fields))
}

fn elements(rest: &mut &str, end: char) -> Option<Vec<Drawn>> {
    let mut elements = Vec::new();
    while !eat(rest, end) {
        elements.push(read(rest)?);
        eat(rest, ',');
    }
    Some(elements)
}

fn eat(rest: &mut &str, expected: char) -> bool {
    let after = rest.trim_start().strip_prefix(expected);
    *rest = after.unwrap_or(rest);
    after.is_some()
}

fn word(rest: &mut &str) -> String {
    let text = rest.trim_start();
    let end = text.find(|c: char| " ,:()[]{}".contains(c)).unwrap_or(text.len());
    let (word, after) = text.split_at(end);
    *rest = after;
    word.to_owned()
}

#[cfg(test)]
mod tests {
    use super::Drawn;

    #[derive(Debug)]
    #[allow(dead_code, reason = "what is printed is read")]
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
    fn what_is_not_derived_is_not_read() {
        for text in ["", "a b", "[1, 2", "A { 1 }", "(1))"] {
            assert_eq!(Drawn::read(text), None, "{text}");
        }
    }
}
