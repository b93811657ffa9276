//! SHA-256, as text.

use sha2::{Digest, Sha256};

/// The number of digits of a hash.
pub(crate) const DIGITS: usize = 64;

/// A hash of texts that come one after the other.
#[derive(Clone, Debug, Default)]
pub(crate) struct Hash(Sha256);

impl Hash {
    pub(crate) fn add(&mut self, text: &str) {
        self.0.update(text.as_bytes());
    }

    pub(crate) fn add_bytes(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Returns the hash of all texts so far, in hexadecimal.
    pub(crate) fn digits(&self) -> String {
        let bytes = self.0.clone().finalize();
        bytes.iter().map(|byte| format!("{byte:02x}")).collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{DIGITS, Hash};

    /// The example of FIPS 180-4, in two parts.
    #[test]
    fn the_hash_is_that_of_the_standard() {
        let mut hash = Hash::default();
        hash.add("a");
        hash.add("bc");
        let expected = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!((hash.digits().as_str(), expected.len()), (expected, DIGITS));
    }
}
