//! NPY.

use tautline_problem::array::{Array, ArrayError};

/// Returns a file of version 1 with this header.
fn file(header: &str, data: &[u8]) -> Vec<u8> {
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), data].concat()
}

/// Returns the header of an array, as NumPy writes it.
fn header(descr: &str, shape: &str) -> String {
    format!("{{'descr': '{descr}', 'fortran_order': False, 'shape': {shape}, }}\n")
}

/// `np.save` of `np.array([[1.5, -2], [3, 4]])`, of `np.asfortranarray(np.arange(6, dtype=">i4")
/// .reshape(2, 3))` and of `np.array([True, False])`, by NumPy 2.
#[test]
fn files_of_numpy_are_read() {
    let blanks = |count| " ".repeat(count);
    let first = header("<f8", "(2, 2)").replace('\n', &(blanks(58) + "\n"));
    let data: Vec<u8> = [1.5_f64, -2.0, 3.0, 4.0].iter().flat_map(|x| x.to_le_bytes()).collect();
    let array = Array::read(&file(&first, &data)).expect("an array");
    assert_eq!((array.shape(), array.values()), (&[2, 2][..], &[1.5, -2.0, 3.0, 4.0][..]));

    let by_column = header(">i4", "(2, 3)").replace("False", "True");
    let data = b"\x00\x00\x00\x00\x00\x00\x00\x03\x00\x00\x00\x01\x00\x00\x00\x04\x00\x00\x00\x02\x00\x00\x00\x05";
    let array = Array::read(&file(&by_column, data)).expect("an array");
    assert_eq!((array.shape(), array.values()), (&[2, 3][..], &[0.0, 1.0, 2.0, 3.0, 4.0, 5.0][..]));

    let array = Array::read(&file(&header("|b1", "(2,)"), b"\x01\x00")).expect("an array");
    assert_eq!((array.shape(), array.values()), (&[2][..], &[1.0, 0.0][..]));
}

/// Python 2 wrote `(2L, 3L)`.
#[test]
fn lengths_may_end_in_the_letter_of_long_integers() {
    let array = Array::read(&file(&header("|u1", "(2L, 1L)"), &[4, 5])).expect("an array");
    assert_eq!((array.shape(), array.values()), (&[2, 1][..], &[4.0, 5.0][..]));
    assert!(Array::read(&file(&header("|u1", "(L, 2)"), &[4, 5])).is_err());
}

#[test]
fn each_type_of_number_is_read_in_both_orders_of_its_bytes() {
    macro_rules! check {
        ($($code:literal $type:ty),*) => {$(
            let (least, most) = (<$type>::MIN, <$type>::MAX);
            for (order, bytes) in [
                ("<", [least.to_le_bytes(), most.to_le_bytes()].concat()),
                (">", [least.to_be_bytes(), most.to_be_bytes()].concat()),
            ] {
                let header = header(&format!("{order}{}", $code), "(2,)");
                let array = Array::read(&file(&header, &bytes)).expect($code);
                assert_eq!(array.values(), [least as f64, most as f64], "{order}{}", $code);
            }
        )*};
    }
    check!("f4" f32, "f8" f64, "i2" i16, "i4" i32, "i8" i64, "u2" u16, "u4" u32, "u8" u64);
    let of_bytes = |code| Array::read(&file(&header(code, "(2,)"), &[0x80, 0xff])).expect(code);
    assert_eq!(of_bytes("|i1").values(), [-128.0, -1.0]);
    assert_eq!(of_bytes("|u1").values(), [128.0, 255.0]);
}

#[test]
fn an_array_on_three_axes_column_by_column_is_turned() {
    // The entry at (i, j, k) is 100 i + 10 j + k; the first index varies fastest.
    let indices = (0..4).flat_map(|k| (0..3).flat_map(move |j| (0..2).map(move |i| [i, j, k])));
    let data: Vec<u8> = indices.map(|[i, j, k]| 100 * i + 10 * j + k).collect();
    let header = header("|u1", "(2, 3, 4)").replace("False", "True");
    let array = Array::read(&file(&header, &data)).expect("an array");
    let expected = (0..2).flat_map(|i| (0..3).flat_map(move |j| (0..4).map(move |k| [i, j, k])));
    let expected: Vec<f64> = expected.map(|[i, j, k]| f64::from(100 * i + 10 * j + k)).collect();
    assert_eq!(array.values(), expected);
}

#[test]
fn the_length_of_a_header_has_four_bytes_from_version_2_on() {
    let header = header("|u1", "(1,)");
    for version in [2, 3] {
        let mut file = b"\x93NUMPY".to_vec();
        file.extend([version, 0]);
        file.extend((header.len() as u32).to_le_bytes());
        file.extend(header.as_bytes());
        file.push(7);
        assert_eq!(Array::read(&file).expect("an array").values(), [7.0]);
    }
}

#[test]
fn another_version_is_refused() {
    for version in [0, 4, 255] {
        let mut wrong = file(&header("|u1", "(1,)"), &[7]);
        wrong[6] = version;
        let error = Array::read(&wrong).expect_err("a version").to_string();
        assert!(error.contains(&format!("its version is {version}; expected 1 to 3")), "{error}");
    }
}

/// `np.save` of `np.float64(2.5)`: no axis, and one number.
#[test]
fn a_single_number_is_an_array_without_axes() {
    let array = Array::read(&file(&header("<f8", "()"), &2.5_f64.to_le_bytes())).expect("a number");
    assert_eq!((array.shape(), array.values()), (&[][..], &[2.5][..]));
    assert_eq!(array.component(&[]).expect("the number"), array);
    assert!(Array::read(&file(&header("<f8", "()"), &[])).is_err());
}

/// Other writers than NumPy write their keys in double quotes, in another order and without the last comma.
#[test]
fn headers_of_other_writers_are_read() {
    let header = r#"{"shape": (1, 2), "fortran_order": False, "descr": "|u1"}"#;
    let array = Array::read(&file(header, &[4, 5])).expect("an array");
    assert_eq!((array.shape(), array.values()), (&[1, 2][..], &[4.0, 5.0][..]));
    // A quote ends where the same one stands again.
    let mixed = header.replace("\"descr\"", "'descr\"");
    assert!(Array::read(&file(&mixed, &[4, 5])).is_err());
}

/// A byte of memory that was seen as a boolean may hold any number: all but 0 are true.
#[test]
fn a_boolean_is_0_or_1() {
    let array = Array::read(&file(&header("|b1", "(4,)"), &[0, 1, 2, 255])).expect("an array");
    assert_eq!(array.values(), [0.0, 1.0, 1.0, 1.0]);
}

#[test]
fn a_file_that_ends_early_or_late_is_refused() {
    let whole = file(&header("<f8", "(3,)"), &[0; 24]);
    assert!(Array::read(&whole).is_ok());
    for end in 0..whole.len() {
        assert!(Array::read(&whole[..end]).is_err(), "{end} bytes are an array");
    }
    let error = ArrayError::Length { shape: vec![3], expected: 24, found: 25 };
    assert_eq!(Array::read(&[whole, vec![0]].concat()), Err(error));
}

#[test]
fn a_wrong_header_is_explained() {
    for (header, says) in [
        (header("<f8", "(18446744073709551615, 2)"), "larger than any memory"),
        (header("<f8", "(99999999999999999999,)"), "expected a tuple of lengths"),
        (header("<f8", "(-1,)"), "expected a tuple of lengths"),
        (header("<f8", "3"), "expected a tuple of lengths, found \"3"),
        (header("<c16", "(1,)"), "the NPY file holds <c16"),
        (header("<f2", "(1,)"), "the NPY file holds <f2"),
        (header("|O", "(1,)"), "the NPY file holds |O"),
        (header("<f8", "(1,)").replace("False", "Never"), "expected True or False"),
        (header("<f8", "(1,)").replace("shape", "shapes"), "its key \"shapes\" is unknown"),
        (header("<f8", "(1,)").replace("'shape': (1,),", ""), "it has no shape"),
        (header("<f8", "(1,)").replace('{', "["), "expected a dictionary in braces"),
        (header("<f8", "(1,)").replace("'descr'", "descr"), "expected a key in quotes"),
        (header("<f8", "(1,)").replace("'descr':", "'descr'="), "expected :"),
        ("{'descr': [('x', '<f8')], 'shape': (1,), }".to_owned(), "the NPY file holds [('x'"),
        ("é".to_owned(), "expected a dictionary"),
    ] {
        let header = header.replace("'descr': [", "'fortran_order': False, 'descr': [");
        let error = Array::read(&file(&header, &[0; 8])).expect_err(&header).to_string();
        assert!(error.contains(says), "{header}: {error}");
    }
}
