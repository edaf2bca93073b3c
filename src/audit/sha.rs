//! SHA-256 in hexadecimal.

use sha2::{Digest as _, Sha256};

use crate::certify::write::hex;

/// The hash of byte strings one after another, each with its length before it.
pub(crate) fn sha256<'a>(parts: impl IntoIterator<Item = &'a [u8]>) -> String {
    let mut sha = Sha256::new();
    for part in parts {
        sha.update((part.len() as u64).to_le_bytes());
        sha.update(part);
    }
    hex(&sha.finalize())
}
