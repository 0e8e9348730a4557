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
    match layout(&bytes) {
        Some((size, width)) => {
            let voxels = bytes[HEADER..].to_vec();
            let file = Arc::new(DensityFile { name: name.to_string(), size, width, voxels });
            Ok(Pattern::DensityFile { file, interpolate: 0 })
        }
        None => Err(vm
            .error(place, format!("`{name}` is no density file"))
            .help("a df3 file holds three sizes of two bytes, then 1, 2 or 4 bytes for each voxel")),
    }
}

/// Bytes before the voxels: three sizes.
const HEADER: usize = 6;

/// Voxels along the axes, and bytes of a voxel: 4, 2 or 1, whichever fits the length of the file.
fn layout(bytes: &[u8]) -> Option<([usize; 3], usize)> {
    let (header, data) = bytes.split_at_checked(HEADER)?;
    let size: [usize; 3] =
        std::array::from_fn(|i| usize::from(u16::from_be_bytes([header[2 * i], header[2 * i + 1]])));
    let count = size.iter().product::<usize>();
    let width = [4, 2, 1].into_iter().find(|width| count * width == data.len() && count > 0)?;
    Some((size, width))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_length_tells_how_wide_the_samples_are() {
        assert_eq!(layout(&[0, 2, 0, 1, 0, 1, 0, 255]), Some(([2, 1, 1], 1)));
        assert_eq!(layout(&[0, 1, 0, 1, 0, 1, 0xff, 0xff]), Some(([1, 1, 1], 2)));
        assert_eq!(layout(&[0, 2, 0, 1, 0, 1, 0, 0, 0]), None);
        assert_eq!(layout(&[0, 0]), None);
    }
}
