//! Files are compared byte by byte, and none is left half-written.

use paper::output::Output;

#[test]
fn a_file_is_compared_byte_by_byte() {
    let folder = std::env::temp_dir().join(format!("tautline-output-{}", std::process::id()));
    let output = Output::at(&folder);
    output.write("data/some.csv", b"n\n1\n").expect("a folder for temporary files");
    assert!(output.compare("data/some.csv", b"n\n1\n").is_ok());
    assert!(output.compare("data/some.csv", b"n\n2\n").is_err());
    assert!(output.compare("data/other.csv", b"n\n1\n").is_err());
    let files = std::fs::read_dir(folder.join("data")).expect("it was written").count();
    assert_eq!(files, 1, "no temporary file is left");
    std::fs::remove_dir_all(folder).expect("it was written");
}
