//! PNG.

use png::{BitDepth, ColorType, Encoder};
use tautline_array::{Array, ArrayError};

/// Returns a picture of three pixels in a row, in two rows.
fn picture(color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 3, 2);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![1, 2, 3, 9, 8, 7]);
    }
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(data).expect("data");
    writer.finish().expect("an end");
    file
}

#[test]
fn a_grey_picture_is_its_rows_from_the_top() {
    let file = picture(ColorType::Grayscale, BitDepth::Eight, &[0, 1, 2, 253, 254, 255]);
    let array = Array::read(&file).expect("a picture");
    assert_eq!(array.shape(), [2, 3]);
    assert_eq!(array.values(), [0.0, 1.0, 2.0, 253.0, 254.0, 255.0]);
}

#[test]
fn sixteen_bits_are_numbers_up_to_65535() {
    let data = [0, 0, 0, 1, 1, 0, 0xff, 0xfe, 0xff, 0xff, 0x80, 0];
    let array = Array::read(&picture(ColorType::Grayscale, BitDepth::Sixteen, &data));
    let expected = [0.0, 1.0, 256.0, 65534.0, 65535.0, 32768.0];
    assert_eq!(array.expect("a picture").values(), expected);
}

#[test]
fn one_bit_is_0_or_255() {
    let array =
        Array::read(&picture(ColorType::Grayscale, BitDepth::One, &[0b101 << 5, 0b010 << 5]));
    let expected = [255.0, 0.0, 255.0, 0.0, 255.0, 0.0];
    assert_eq!(array.expect("a picture").values(), expected);
}

#[test]
fn channels_are_the_last_axis() {
    let data: Vec<u8> = (0..18).collect();
    let array = Array::read(&picture(ColorType::Rgb, BitDepth::Eight, &data)).expect("a picture");
    assert_eq!(array.shape(), [2, 3, 3]);
    let green = array.component(&[1]).expect("green");
    assert_eq!(
        (green.shape(), green.values()),
        (&[2, 3][..], &[1.0, 4.0, 7.0, 10.0, 13.0, 16.0][..])
    );
    let data: Vec<u8> = (0..12).collect();
    let array = Array::read(&picture(ColorType::GrayscaleAlpha, BitDepth::Eight, &data));
    assert_eq!(array.expect("a picture").shape(), [2, 3, 2]);
    // A palette is a table of colours.
    let data = [0b0100_0000, 0b1010_0000];
    let array = Array::read(&picture(ColorType::Indexed, BitDepth::One, &data)).expect("a picture");
    assert_eq!(array.component(&[0]).expect("red").values(), [1.0, 9.0, 1.0, 9.0, 1.0, 9.0]);
}

/// Its pixels take 1000 times as many bytes as the file.
#[test]
fn a_blank_picture_is_small_in_its_file() {
    let mut file = Vec::new();
    let encoder = Encoder::new(&mut file, 1000, 1000);
    let mut writer = encoder.write_header().expect("a header");
    // One byte for eight pixels would be one bit; the default is eight bits of grey.
    writer.write_image_data(&vec![0; 1_000_000]).expect("data");
    writer.finish().expect("an end");
    assert!(file.len() < 20_000, "{}", file.len());
    let array = Array::read(&file).expect("a picture");
    assert_eq!((array.shape(), array.values().iter().sum::<f64>()), (&[1000, 1000][..], 0.0));
}

#[test]
fn a_broken_picture_is_refused() {
    let whole = picture(ColorType::Grayscale, BitDepth::Eight, &[0, 1, 2, 253, 254, 255]);
    // Without its last chunk, which is empty, a picture is complete.
    for end in 8..whole.len() - 16 {
        assert!(matches!(Array::read(&whole[..end]), Err(ArrayError::Picture { .. })), "{end}");
    }
}

/// Memory for it would be reserved before the decoder sees that the pixels are missing.
#[test]
fn a_picture_that_promises_more_than_it_can_hold_is_refused() {
    for side in [1_u32 << 20, (1 << 31) - 1] {
        let mut file = Vec::new();
        let mut writer = Encoder::new(&mut file, side, side).write_header().expect("a header");
        writer.write_chunk(png::chunk::IDAT, &[0; 9]).expect("a chunk");
        drop(writer);
        let error = Array::read(&file).expect_err("a picture").to_string();
        assert!(
            error.contains("bytes of pixels cannot be in") || error.contains("imit"),
            "{error}"
        );
    }
}
