//! PNG.

use std::io::Cursor;

use png::{BitDepth, Decoder, Transformations};

use super::{Array, ArrayError};

/// The first bytes of a file.
pub(crate) const MAGIC: &[u8] = b"\x89PNG\r\n\x1a\n";

pub(crate) fn read(file: &[u8]) -> Result<Array, ArrayError> {
    let failed = |error: png::DecodingError| ArrayError::Picture { what: error.to_string() };
    let mut decoder = Decoder::new(Cursor::new(file));
    // Palettes become colours, and grey numbers of one to four bits are spread over those of eight. Programs
    // that make files smaller choose among these formats, and must not change the numbers.
    decoder.set_transformations(Transformations::EXPAND);
    let mut reader = decoder.read_info().map_err(failed)?;
    // Deflate makes at most 1032 bytes of one. More would be reserved in memory for nothing.
    let (needed, possible) = (reader.info().raw_bytes(), file.len().saturating_mul(1032));
    if needed > possible {
        let what = format!("{needed} bytes of pixels cannot be in {} bytes", file.len());
        return Err(ArrayError::Picture { what });
    }
    let too_large = || ArrayError::Picture { what: "it is larger than the memory".to_owned() };
    let needed = reader.output_buffer_size().ok_or_else(too_large)?;
    // A palette and single bits take up to 32 times as many bytes as in the file, and the numbers more.
    let (mut bytes, mut values) = (Vec::new(), Vec::new());
    bytes.try_reserve_exact(needed).map_err(|_| too_large())?;
    values.try_reserve_exact(needed).map_err(|_| too_large())?;
    bytes.resize(needed, 0);
    let frame = reader.next_frame(&mut bytes).map_err(failed)?;
    bytes.truncate(frame.buffer_size());
    match frame.bit_depth {
        BitDepth::Sixteen => {
            let pairs = bytes.chunks_exact(2);
            values.extend(pairs.map(|pair| f64::from(u16::from_be_bytes([pair[0], pair[1]]))));
        }
        _ => values.extend(bytes.into_iter().map(f64::from)),
    }
    let mut shape = vec![frame.height as usize, frame.width as usize];
    if frame.color_type.samples() > 1 {
        shape.push(frame.color_type.samples());
    }
    Array::new(shape, values)
}
