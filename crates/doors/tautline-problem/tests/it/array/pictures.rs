//! PNG.

use png::{BitDepth, ColorType, Encoder};
use tautline_problem::array::{Array, ArrayError};

/// Returns a picture of three pixels in a row, in two rows.
fn picture(color: ColorType, depth: BitDepth, data: &[u8]) -> Vec<u8> {
    picture_with(color, depth, None, data)
}

/// Returns such a picture, in which some grey number or colours count as transparent.
fn picture_with(color: ColorType, depth: BitDepth, trns: Option<&[u8]>, data: &[u8]) -> Vec<u8> {
    let mut file = Vec::new();
    let mut encoder = Encoder::new(&mut file, 3, 2);
    encoder.set_color(color);
    encoder.set_depth(depth);
    if color == ColorType::Indexed {
        encoder.set_palette(vec![1, 2, 3, 9, 8, 7]);
    }
    if let Some(trns) = trns {
        encoder.set_trns(trns.to_vec());
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

/// White is 255 in up to eight bits, as it is in a palette: programs that make a file smaller choose the
/// number of bits, and must not change a table. A number of `b` bits is multiplied by `255/(2ᵇ − 1)`.
#[test]
fn numbers_of_fewer_bits_are_spread_over_0_to_255() {
    for (depth, data, expected) in [
        (BitDepth::One, &[0b1010_0000, 0b0100_0000][..], [255.0, 0.0, 255.0, 0.0, 255.0, 0.0]),
        (BitDepth::Two, &[0b0001_1000, 0b1100_0100], [0.0, 85.0, 170.0, 255.0, 0.0, 85.0]),
        (BitDepth::Four, &[0x01, 0x20, 0x7e, 0xf0], [0.0, 17.0, 34.0, 119.0, 238.0, 255.0]),
        (BitDepth::Eight, &[0, 1, 2, 127, 254, 255], [0.0, 1.0, 2.0, 127.0, 254.0, 255.0]),
    ] {
        let array = Array::read(&picture(ColorType::Grayscale, depth, data)).expect("a picture");
        assert_eq!((array.shape(), array.values()), (&[2, 3][..], &expected[..]), "{depth:?}");
    }
}

/// The same pixels, as grey numbers of one and of eight bits and by a palette of black and white.
#[test]
fn a_picture_is_the_same_table_in_every_format_that_can_hold_it() {
    let bits = [0b1010_0000, 0b0100_0000];
    let bytes = [255, 0, 255, 0, 255, 0];
    let one = Array::read(&picture(ColorType::Grayscale, BitDepth::One, &bits)).expect("one bit");
    let eight = picture(ColorType::Grayscale, BitDepth::Eight, &bytes);
    assert_eq!(Array::read(&eight), Ok(one.clone()));
    for depth in [BitDepth::One, BitDepth::Two, BitDepth::Four, BitDepth::Eight] {
        let places: Vec<u8> = bytes.iter().map(|byte| u8::from(*byte > 0)).collect();
        let width = depth as usize;
        // The places of a row, from the high bits of its first byte on.
        let rows = places.chunks(3).flat_map(|row| {
            let mut packed = vec![0_u8; (3 * width).div_ceil(8)];
            for (i, place) in row.iter().enumerate() {
                packed[i * width / 8] |= place << (8 - width - i * width % 8);
            }
            packed
        });
        let rows: Vec<u8> = rows.collect();
        let mut file = Vec::new();
        let mut encoder = Encoder::new(&mut file, 3, 2);
        encoder.set_color(ColorType::Indexed);
        encoder.set_depth(depth);
        encoder.set_palette(vec![0, 0, 0, 255, 255, 255]);
        let mut writer = encoder.write_header().expect("a header");
        writer.write_image_data(&rows).expect("data");
        writer.finish().expect("an end");
        let array = Array::read(&file).expect("a picture");
        assert_eq!(array.shape(), [2, 3, 3]);
        for channel in 0..3 {
            assert_eq!(array.component(&[channel]), Ok(one.clone()), "{depth:?}, {channel}");
        }
    }
}

/// A grey number or a colour that counts as transparent is a channel more, whose numbers have as many bits.
#[test]
fn transparency_is_a_channel() {
    let transparent = |color, depth, trns: &[u8], data: &[u8]| {
        Array::read(&picture_with(color, depth, Some(trns), data)).expect("a picture")
    };
    let bits = [0b1010_0000, 0b0100_0000];
    let opaque = [255.0, 0.0, 255.0, 0.0, 255.0, 0.0];
    let grey = transparent(ColorType::Grayscale, BitDepth::One, &[0, 0], &bits);
    assert_eq!(grey.shape(), [2, 3, 2]);
    assert_eq!(
        [0, 1].map(|i| grey.component(&[i]).expect("a channel").values().to_vec()),
        [opaque, opaque]
    );
    let colours = transparent(ColorType::Indexed, BitDepth::One, &[0, 51], &bits);
    assert_eq!(colours.shape(), [2, 3, 4]);
    let alpha = colours.component(&[3]).expect("alpha");
    assert_eq!(alpha.values(), [51.0, 0.0, 51.0, 0.0, 51.0, 0.0]);
    let data = [0, 7, 1, 0, 0xff, 0xff, 0, 7, 0, 0, 0, 1];
    let wide = transparent(ColorType::Grayscale, BitDepth::Sixteen, &[0, 7], &data);
    let channels = [0, 1].map(|i| wide.component(&[i]).expect("a channel").values().to_vec());
    assert_eq!(channels[0], [7.0, 256.0, 65535.0, 7.0, 0.0, 1.0]);
    assert_eq!(channels[1], [0.0, 65535.0, 65535.0, 0.0, 65535.0, 65535.0]);
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
