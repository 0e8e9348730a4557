//! Functions that give a vector, docs/spec/language.md 3.9.

use super::arguments;
use crate::interp::tuple::Tuple;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::source::Span;

/// Whether a word is a function that gives a vector.
pub fn is_function(word: Word) -> bool {
    use Word::*;
    matches!(word, Vcross | Vnormalize | Vrotate | VaxisRotate | Vturbulence | Trace | MinExtent | MaxExtent)
}

/// Reads the arguments of a function whose name was just taken, and computes it.
pub fn call(vm: &mut Vm, word: Word, span: Span) -> Result<Tuple> {
    let vector = match word {
        Word::Vcross => {
            let [a, b] = vectors(vm)?;
            a.cross(b)
        }
        Word::Vnormalize => {
            let v = arguments(vm, Vm::read_vector)?;
            if v == DVec3::ZERO {
                if vm.version >= 350 {
                    vm.possible(
                        span.to(vm.last),
                        "`vnormalize` of the zero vector",
                        "it has no direction; the result is zero",
                    );
                }
                v
            } else {
                v / v.length()
            }
        }
        Word::Vrotate => {
            let [v, angles] = vectors(vm)?;
            rotate(v, angles)
        }
        Word::VaxisRotate => arguments(vm, |vm| {
            let v = vm.read_vector()?;
            vm.comma()?;
            let axis = vm.read_vector()?;
            vm.comma()?;
            let (sin, cos) = vm.read_float()?.to_radians().sin_cos();
            let n = axis / axis.length();
            Ok(v * cos + n.cross(v) * sin + n * n.dot(v) * (1.0 - cos))
        })?,
        Word::Vturbulence => super::probe::turbulence(vm, span)?,
        Word::Trace => super::probe::trace(vm, span)?,
        _ => super::probe::extent(vm, word, span)?,
    };
    Ok(Tuple::new(&vector.to_array()))
}

fn vectors<const N: usize>(vm: &mut Vm) -> Result<[DVec3; N]> {
    arguments(vm, |vm| {
        let mut values = [DVec3::ZERO; N];
        for (i, slot) in values.iter_mut().enumerate() {
            if i > 0 {
                vm.comma()?;
            }
            *slot = vm.read_vector()?;
        }
        Ok(values)
    })
}

/// Rotates about x, then y, then z, by degrees.
fn rotate(v: DVec3, angles: DVec3) -> DVec3 {
    let turn = |(a, b): (f64, f64), angle: f64| {
        let (sin, cos) = angle.to_radians().sin_cos();
        (a * cos - b * sin, a * sin + b * cos)
    };
    let (y, z) = turn((v.y, v.z), angles.x);
    let (z, x) = turn((z, v.x), angles.y);
    let (x, y) = turn((x, y), angles.z);
    DVec3::new(x, y, z)
}
