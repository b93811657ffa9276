//! Text, Markdown and JSON.

use serde_json::Value;

use crate::program::{file, run, run_on};

#[test]
fn the_text_begins_with_the_lie() {
    let ran = run(&[&file("wrong_c2")]);
    let lines: Vec<&str> = ran.out.lines().collect();
    assert!(lines[0].starts_with("A claim is false: c2. Of 52 laws: "), "{}", lines[0]);
    let lie = "  c2 = 2.7 is claimed, but wᵀ H(x) w = 3 at x = (1.57";
    assert!(lines[1].starts_with(lie), "{}", lines[1]);
    assert!(lines[1].contains("in the direction w = (") && lines[1].ends_with("10 % too small"));
    for part in
        ["constants  c1 = 1, ", "samples    256 for each law, seed 1", "The laws that fail:"]
    {
        assert!(ran.out.contains(part), "{}", ran.out);
    }
}

#[test]
fn the_document_has_the_text() {
    let document = run(&[&file("wrong_c2"), "--json"]).json();
    assert_eq!(document["text"], run(&[&file("wrong_c2")]).out);
}

#[test]
fn seed_and_cases_of_the_arguments_replace_those_of_the_file() {
    let problem = "dimension = 1\n[metric]\nphi = 2\n[audit]\ncases = 7\nseed = 5\n";
    let said = |arguments: &[&str]| {
        let audit = run_on(arguments, problem).json();
        [audit["cases"].as_u64(), audit["seed"].as_u64()].map(|number| number.expect("a number"))
    };
    assert_eq!(said(&["-", "--json"]), [7, 5]);
    assert_eq!(said(&["-", "--json", "--cases", "9", "--seed", "6"]), [9, 6]);
}

#[test]
fn the_markdown_has_whole_tables() {
    let ran = run(&[&file("right_line"), "--markdown"]);
    assert_eq!(ran.code, 0, "{}", ran.err);
    assert!(ran.out.starts_with("# Audit of a metric in 1 dimensions\n\nAll laws hold."));
    let mut rows = 0;
    let mut cells = 0;
    for line in ran.out.lines() {
        // Bars inside of cells are escaped.
        let found = line.replace("\\|", "").matches('|').count();
        assert!(found == 0 || cells == 0 || found == cells, "{line}");
        cells = found;
        rows += usize::from(found > 0);
    }
    // 50 laws hold.
    assert!(rows > 60, "{rows} rows");
}

#[test]
fn the_schema_describes_every_key_of_a_report() {
    let schema = run(&["--schema"]).json();
    for name in ["wrong_l_h", "right_ball", "wrong_indefinite"] {
        let audit = run(&[&file(name), "--json"]).json();
        assert_described(&audit, &schema, &schema);
    }
}

/// Checks that the keys of all objects are those of the schema, and that none that it requires is
/// missing.
fn assert_described(value: &Value, schema: &Value, root: &Value) {
    let schema = match schema["$ref"].as_str() {
        Some(name) => &root["$defs"][name.rsplit('/').next().expect("a name")],
        None => schema,
    };
    // An optional object is described as itself or null.
    let choices = schema["anyOf"].as_array();
    if let Some(choices) = choices {
        let other = choices.iter().find(|choice| choice["type"] != "null").expect("a type");
        if !value.is_null() {
            assert_described(value, other, root);
        }
        return;
    }
    if let Some(object) = value.as_object() {
        let properties = schema["properties"].as_object().expect("an object");
        assert!(object.keys().eq(properties.keys()), "{object:?} {properties:?}");
        object.iter().for_each(|(key, value)| assert_described(value, &properties[key], root));
    }
    for value in value.as_array().into_iter().flatten() {
        assert_described(value, &schema["items"], root);
    }
    if let (Some(word), Some(words)) = (value.as_str(), schema["enum"].as_array()) {
        assert!(words.iter().any(|known| known == word), "{word}");
    }
}
