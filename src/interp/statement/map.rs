//! Maps: `color_map { [position color] … }` and its kin (docs/spec/language.md 6.10).

use std::sync::Arc;

use super::pattern::Owner;
use super::{color, normal, pigment, texture};
use crate::interp::value::Value;
use crate::interp::{Fault, Result, Vm, Word};
use crate::math::{DVec2, Rgbft};
use crate::scene::depth::Depth;
use crate::scene::pigment::BlendMap;
use crate::scene::{Normal, Pigment, Texture};
use crate::source::Span;
use crate::syntax::Punct;

/// POV-Ray's limit on the entries of a map.
const MOST_ENTRIES: usize = 256;

/// Reads `word { ID }` or `word { [ … ] … }`; `entry` reads the inside of one pair of brackets.
fn read<T: Depth>(
    vm: &mut Vm<'_>,
    named: impl Fn(&Value) -> Option<Arc<BlendMap<T>>>,
    mut entry: impl FnMut(&mut Vm<'_>, &mut Vec<(f32, T)>) -> Result<()>,
) -> Result<Arc<BlendMap<T>>> {
    let block = vm.enter()?;
    if let Some(map) = vm.accept_value(named)? {
        vm.close(block)?;
        return Ok(map);
    }
    let mut entries = Vec::new();
    while vm.accept_punct(Punct::OpenBracket)? {
        let open = vm.last;
        entry(vm, &mut entries)?;
        if !vm.accept_punct(Punct::CloseBracket)? {
            return Err(vm.expected("`]`").see(open, "to close this"));
        }
        if entries.len() > MOST_ENTRIES {
            return Err(vm.error(open, format!("a map has at most {MOST_ENTRIES} entries")));
        }
        vm.comma()?;
    }
    if entries.is_empty() {
        return Err(vm.expected("`[`").help("a map consists of entries such as `[0.5 rgb 1]`"));
    }
    vm.close(block)?;
    Ok(Arc::new(BlendMap::new(entries)))
}

/// Reads the position before an entry. For `average` it is a weight and may be left out.
fn position(vm: &mut Vm<'_>, average: bool) -> Result<f32> {
    if average && !vm.at_number()? && !vm.at_color()? {
        return Ok(1.0);
    }
    let position = vm.read_float()? as f32;
    vm.comma()?;
    Ok(position)
}

/// Reads a `color_map`.
pub(in crate::interp) fn colors(vm: &mut Vm<'_>) -> Result<Arc<BlendMap<Rgbft>>> {
    let named = |value: &Value| match value {
        Value::ColorMap(map) => Some(Arc::clone(map)),
        _ => None,
    };
    read(vm, named, |vm, entries| {
        let at = vm.read_float()? as f32;
        vm.comma()?;
        if vm.at_color()? {
            let entry = (at, color::rgbft(vm)?);
            if entries.last() != Some(&entry) {
                entries.push(entry);
            }
            return Ok(());
        }
        let (value, place) = vm.located(|vm| vm.full(1))?;
        match value.n {
            5 => entries.push((at, Rgbft::new(value.c.map(|c| c as f32)))),
            // The old form: two positions and their colours.
            1 => {
                for at in [at, value.c[0] as f32] {
                    vm.comma()?;
                    if !matches!(vm.peek_word()?, Some(Word::Color | Word::Colour)) {
                        return Err(vm.expected("`color`"));
                    }
                    entries.push((at, color::rgbft(vm)?));
                }
            }
            _ => {
                let fault = vm.error(place, "a color is needed here, not a vector");
                return Err(fault.help("write `rgb` or `color` before it"));
            }
        }
        Ok(())
    })
}

/// Reads a `pigment_map` or, for a density, a `density_map`; entries start from `default`.
pub(in crate::interp) fn pigments(
    vm: &mut Vm<'_>,
    owner: Owner,
    default: &Arc<Pigment>,
    average: bool,
) -> Result<Arc<BlendMap<Arc<Pigment>>>> {
    let named = |value: &Value| match (value, owner) {
        (Value::PigmentMap(map), Owner::Pigment) | (Value::DensityMap(map), Owner::Density) => {
            Some(Arc::clone(map))
        }
        _ => None,
    };
    read(vm, named, |vm, entries| {
        let at = position(vm, average)?;
        entries.push((at, pigment::body(vm, default, owner)?));
        Ok(())
    })
}

/// Reads a `normal_map`.
pub(in crate::interp) fn normals(vm: &mut Vm<'_>, average: bool) -> Result<Arc<BlendMap<Arc<Normal>>>> {
    let default = vm.state.normal();
    let named = |value: &Value| match value {
        Value::NormalMap(map) => Some(Arc::clone(map)),
        _ => None,
    };
    read(vm, named, |vm, entries| {
        let at = position(vm, average)?;
        entries.push((at, normal::body(vm, default.as_ref())?));
        Ok(())
    })
}

/// Reads a `texture_map`.
pub(in crate::interp) fn textures(vm: &mut Vm<'_>, average: bool) -> Result<Arc<BlendMap<Texture>>> {
    let named = |value: &Value| match value {
        Value::TextureMap(map) => Some(Arc::clone(map)),
        _ => None,
    };
    read(vm, named, |vm, entries| {
        let at = position(vm, average)?;
        entries.push((at, texture::body(vm)?));
        Ok(())
    })
}

/// Reads a `slope_map`: heights and slopes.
pub(in crate::interp) fn slopes(vm: &mut Vm<'_>) -> Result<Arc<BlendMap<DVec2>>> {
    let named = |value: &Value| match value {
        Value::SlopeMap(map) => Some(Arc::clone(map)),
        _ => None,
    };
    read(vm, named, |vm, entries| {
        let at = position(vm, false)?;
        entries.push((at, vm.read_uv()?));
        Ok(())
    })
}

/// The error for a map on a pattern that takes a list.
pub(super) fn for_list(vm: &Vm<'_>, word: Word, place: Span) -> Fault {
    vm.error(place, format!("this pattern takes a list, not a `{}`", word.text()))
        .help("write the entries directly after the pattern: `checker rgb 0 rgb 1`")
}
