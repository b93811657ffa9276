//! NPY files as NumPy writes them, pictures as the encoder writes them, and files that are neither.

mod npy;
mod pictures;

use tautline_problem::array::{Array, ArrayError};

#[test]
fn a_component_is_an_entry_of_the_last_axes() {
    let values: Vec<f64> = (0..24).map(f64::from).collect();
    let array = Array::new(vec![2, 3, 4], values).expect("an array");
    let channel = array.component(&[1]).expect("a channel");
    assert_eq!(channel.shape(), [2, 3]);
    assert_eq!(channel.values(), [1.0, 5.0, 9.0, 13.0, 17.0, 21.0]);
    let entry = array.component(&[2, 3]).expect("an entry");
    assert_eq!((entry.shape(), entry.values()), (&[2][..], &[11.0, 23.0][..]));
    assert_eq!(array.component(&[]).expect("the array"), array);
    for index in [&[4][..], &[3, 0], &[0, 0, 0, 0]] {
        let error = ArrayError::Component { index: index.to_vec(), shape: vec![2, 3, 4] };
        assert_eq!(array.component(index), Err(error));
    }
    // The product of the last axes overflows, and no number is there.
    let huge = Array::new(vec![0, 1 << 40, 1 << 40], Vec::new()).expect("an array");
    assert_eq!(huge.component(&[0, 0]).expect("an entry of nothing").shape(), [0]);
    let empty = Array::new(vec![0, 2], Vec::new()).expect("an array");
    assert_eq!(empty.component(&[1]).expect("a column").shape(), [0]);
}

#[test]
fn a_shape_says_how_many_numbers_there_are() {
    let error = ArrayError::Count { shape: vec![2, 2], found: 3 };
    assert_eq!(Array::new(vec![2, 2], vec![0.0; 3]), Err(error));
    // The product of these lengths is 0 in 64 bits.
    assert!(Array::new(vec![1 << 33, 1 << 33], Vec::new()).is_err());
}

#[test]
fn another_file_is_refused() {
    for file in [&b""[..], b"\x93NUMP", b"PK\x03\x04", b"\xff\xd8\xff\xe0", b"1,2\n3,4\n"] {
        assert_eq!(Array::read(file), Err(ArrayError::Unknown));
    }
}
