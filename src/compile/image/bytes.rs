//! A file's bytes, taken from the front.

use super::file::Fault;

/// What is left of a file.
pub(super) struct Bytes<'a>(pub(super) &'a [u8]);

impl<'a> Bytes<'a> {
    /// The next `count` bytes.
    ///
    /// # Errors
    /// Fewer are left.
    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], Fault> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or("the file ends too early")?;
        self.0 = rest;
        Ok(taken)
    }

    /// The next bytes, as an array.
    ///
    /// # Errors
    /// Fewer are left.
    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], Fault> {
        Ok(self.take(N)?.try_into()?)
    }

    pub(super) fn byte(&mut self) -> Result<u8, Fault> {
        Ok(self.array::<1>()?[0])
    }

    pub(super) fn u16_le(&mut self) -> Result<u16, Fault> {
        Ok(u16::from_le_bytes(self.array()?))
    }

    pub(super) fn u32_le(&mut self) -> Result<u32, Fault> {
        Ok(u32::from_le_bytes(self.array()?))
    }

    pub(super) fn u16_be(&mut self) -> Result<u16, Fault> {
        Ok(u16::from_be_bytes(self.array()?))
    }

    pub(super) fn u32_be(&mut self) -> Result<u32, Fault> {
        Ok(u32::from_be_bytes(self.array()?))
    }

    /// The bytes up to `end`, which is passed over.
    ///
    /// # Errors
    /// There is no `end`.
    pub(super) fn line(&mut self, end: u8) -> Result<&'a [u8], Fault> {
        let length = self.0.iter().position(|&byte| byte == end).ok_or("the file ends too early")?;
        let line = self.take(length)?;
        self.byte()?;
        Ok(line)
    }
}

/// Pixels from packed rows: each of `width` numbers of `bits` (1, 2, 4 or 8), the first in the
/// highest bits, in rows of `line` bytes.
pub(super) fn unpacked(rows: &[u8], line: usize, bits: usize, width: usize) -> Vec<u8> {
    let mask = (0xff_u16 >> (8 - bits)) as u8;
    let pixel = move |row: &[u8], x: usize| {
        let bit = x * bits;
        row[bit / 8] >> (8 - bits - bit % 8) & mask
    };
    rows.chunks_exact(line.max(1)).flat_map(|row| (0..width).map(move |x| pixel(row, x))).collect()
}
