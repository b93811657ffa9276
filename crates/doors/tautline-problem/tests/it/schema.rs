//! Examples and answers against the schemas that are generated from their types.

use jsonschema::Validator;
use tautline_problem::{
    EXAMPLES, Question, Schema, answer_schema, constants_schema, problem_schema,
};

fn validator(schema: Schema) -> Validator {
    jsonschema::validator_for(&schema.to_value()).expect("a schema")
}

/// Returns a file as JSON.
fn json(file: &str) -> serde_json::Value {
    let table: toml::Table = toml::from_str(file).expect("TOML");
    serde_json::to_value(table).expect("JSON")
}

#[test]
fn every_example_is_a_problem_by_the_schema() {
    let schema = validator(problem_schema());
    for example in EXAMPLES {
        let errors: Vec<String> =
            schema.iter_errors(&json(example.text)).map(|error| error.to_string()).collect();
        assert_eq!(errors, [""; 0], "{}", example.name);
    }
}

#[test]
fn the_schema_refuses_what_the_reader_refuses() {
    let schema = validator(problem_schema());
    let good = "[metric]\nphi = \"1\"\n[from]\npoint = [0]\n[to]\npoint = [1]\n";
    assert!(schema.is_valid(&json(good)) && Question::read(good).is_ok());
    for (from, to) in [
        ("phi = \"1\"", "psi = \"1\""),
        ("phi = \"1\"", ""),
        ("phi = \"1\"", "phi = \"1\"\ncost = \"1\""),
        ("[from]\npoint", "[from]\npiont"),
        ("point = [0]", "ball = { centre = [0] }"),
        ("point = [0]", "point = [true]"),
        ("[metric]", "dimension = -1\n[metric]"),
        ("[to]", "[solve]\nrule = \"midpoint\"\n[to]"),
        ("[to]", "[solve]\nchords = 3\n[to]"),
        ("[to]", "[sweep]\ndraw = 3\n[to]"),
        ("[to]", "[parameters]\na = 1\n[sweep.vary]\na = true\n[to]"),
        ("[to]", "[parameters]\na = 1\n[sweep.vary]\na = [[true]]\n[to]"),
        ("[to]", "[parameters]\na = 1\n[sweep.vary]\na = { from = 0, to = 1, cuont = 2 }\n[to]"),
    ] {
        let bad = good.replace(from, to);
        assert!(!schema.is_valid(&json(&bad)), "{bad}");
        assert!(Question::read(&bad).is_err(), "{bad}");
    }
}

#[test]
fn answers_and_constants_are_as_their_schemas_say() {
    let example = EXAMPLES.iter().find(|example| example.name == "sets").expect("an example");
    let question = Question::read(example.text).expect("a problem");
    let answer = question.solve(&mut |_| ()).expect("solved");
    let answer = serde_json::to_value(&answer).expect("JSON");
    assert!(validator(answer_schema()).is_valid(&answer));
    let constants = serde_json::to_value(question.constants().expect("proved")).expect("JSON");
    assert!(validator(constants_schema()).is_valid(&constants));
    // The schemas are not those of anything.
    assert!(!validator(answer_schema()).is_valid(&constants));
    assert!(!validator(constants_schema()).is_valid(&answer));
}
