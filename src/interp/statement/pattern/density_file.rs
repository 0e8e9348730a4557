//! `density_file df3 "name"` (docs/spec/patterns-textures.md 2.4).

use std::sync::Arc;

use crate::interp::{Result, Vm, Word};
use crate::scene::Pattern;
use crate::scene::pattern::DensityFile;
use crate::source::FileKind;

/// Reads the statement and the file.
pub(super) fn read(vm: &mut Vm<'_>) -> Result<Pattern> {
    vm.next()?;
    if !vm.accept(Word::Df3)? {
        return Err(vm.expected("`df3`"));
    }
    let (name, place) = vm.located(Vm::read_string)?;
    let bytes = vm.load_file(&name, FileKind::Other(&[".df3", ".DF3"]), place)?;
    match decode(&bytes) {
        Some((size, values)) => {
            let file = Arc::new(DensityFile { name: name.to_string(), size, values });
            Ok(Pattern::DensityFile { file, interpolate: 0 })
        }
        None => Err(vm
            .error(place, format!("`{name}` is no density file"))
            .help("a df3 file holds three sizes of two bytes, then 1, 2 or 4 bytes for each voxel")),
    }
}

/// Sizes and values: big-endian samples of 4, 2 or 1 bytes, whichever fits the length of the file.
fn decode(bytes: &[u8]) -> Option<([usize; 3], Vec<f32>)> {
    let (header, data) = bytes.split_at_checked(6)?;
    let size: [usize; 3] =
        std::array::from_fn(|i| usize::from(u16::from_be_bytes([header[2 * i], header[2 * i + 1]])));
    let count = size.iter().product::<usize>();
    let width = [4, 2, 1].into_iter().find(|width| count * width == data.len() && count > 0)?;
    let greatest = (256f64.powi(width as i32) - 1.0) as f32;
    let sample = |bytes: &[u8]| bytes.iter().fold(0u32, |value, &byte| value << 8 | u32::from(byte));
    Some((size, data.chunks_exact(width).map(|bytes| sample(bytes) as f32 / greatest).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_length_tells_how_wide_the_samples_are() {
        let (size, values) = decode(&[0, 2, 0, 1, 0, 1, 0, 255]).unwrap();
        assert_eq!((size, values), ([2, 1, 1], vec![0.0, 1.0]));
        let (_, values) = decode(&[0, 1, 0, 1, 0, 1, 0xff, 0xff]).unwrap();
        assert_eq!(values, [1.0]);
        assert!(decode(&[0, 2, 0, 1, 0, 1, 0, 0, 0]).is_none());
        assert!(decode(&[0, 0]).is_none());
    }
}
