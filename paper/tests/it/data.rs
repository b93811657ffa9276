//! Tables of numbers: written, read back, compared column by column.

use paper::data::{Data, Tolerance};

const CLOSE: Tolerance = Tolerance::Close { relative: 1e-9, absolute: 0.0 };

fn data(n: &str, value: &str, noise: &str) -> Data {
    let mut data =
        Data::new(&[("n", Tolerance::Exact), ("value", CLOSE), ("noise", Tolerance::AtMost(1e-6))]);
    data.push([n, value, noise].map(str::to_owned).to_vec());
    data
}

#[test]
fn a_free_column_is_not_compared_and_the_others_are() {
    let data = |place: &str, value: &str| {
        let mut data = Data::new(&[("place", Tolerance::Free), ("value", CLOSE)]);
        data.push([place, value].map(str::to_owned).to_vec());
        data
    };
    assert!(data("x = 1", "2").compare(&data("x = 3", "2")).is_ok());
    assert!(data("x = 1", "2").compare(&data("x = 1", "3")).is_err());
}

#[test]
fn a_file_is_read_back_as_it_was() {
    let written = data("4", "1.5", "1e-12");
    let bytes = written.to_csv("two\nlines").expect("in memory");
    assert!(bytes.starts_with(b"# two\n# lines\nn,value,noise\n"));
    assert_eq!(written.read(&bytes).expect("our own"), written);
}

#[test]
fn each_tolerance_accepts_and_refuses() {
    let reference = data("4", "1.5", "1e-12");
    assert!(data("4", "1.5000000001", "9e-7").compare(&reference).is_ok());
    assert!(data("5", "1.5", "1e-12").compare(&reference).is_err());
    assert!(data("4", "1.50001", "1e-12").compare(&reference).is_err());
    assert!(data("4", "NaN", "1e-12").compare(&reference).is_err());
    assert!(data("4", "", "1e-12").compare(&reference).is_err());
    assert!(data("4", "1.5", "2e-6").compare(&reference).is_err());
    assert!(data("4", "1.5", "NaN").compare(&reference).is_err());
    assert!(data("4", "1.5", "-1e-9").compare(&reference).is_err());
    let mut longer = reference.clone();
    longer.push(["8", "1.5", "0"].map(str::to_owned).to_vec());
    assert!(longer.compare(&reference).is_err());
    assert!(reference.compare(&longer).is_err());
}

#[test]
fn other_columns_are_refused() {
    let bytes = b"n,other\n1,2\n";
    assert!(data("4", "1.5", "0").read(bytes).is_err());
}
