//! The command `tautline`.
use tautline_problem::{Question, Failure};
fn main() {
    let path = std::env::args().nth(1).unwrap();
    let file = std::fs::read_to_string(&path).unwrap();
    let answer = Question::read(&file).map_err(Failure::from).and_then(|q| q.solve(&mut |_| ()));
    match answer {
        Ok(a) => println!("{:#?}", tautline_problem::Answer { curve: vec![], ..a }),
        Err(Failure::BadInput(d)) => println!("{}", d.render(&path, &file, false)),
        Err(e) => println!("{e}"),
    }
}
