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
                v * (1.0 / v.length())
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
            Ok(rotate_about(v, axis, vm.read_float()?))
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
    let turn = |angle: f64| angle.to_radians().sin_cos();
    let ((sx, cx), (sy, cy), (sz, cz)) = (turn(angles.x), turn(angles.y), turn(angles.z));
    let about_x = [[1.0, 0.0, 0.0], [0.0, cx, sx], [0.0, -sx, cx]];
    let about_y = [[cy, 0.0, -sy], [0.0, 1.0, 0.0], [sy, 0.0, cy]];
    let about_z = [[cz, sz, 0.0], [-sz, cz, 0.0], [0.0, 0.0, 1.0]];
    let product = |a: [[f64; 3]; 3], b: [[f64; 3]; 3]| a.map(|row| times(row, &b));
    times(v.to_array(), &product(product(about_x, about_y), about_z)).into()
}

/// A vector turned by an angle in degrees about an axis, by the formula whose last digits are POV-Ray's.
fn rotate_about(v: DVec3, axis: DVec3, angle: f64) -> DVec3 {
    let (s, c) = angle.to_radians().sin_cos();
    let [x, y, z] = (axis * (1.0 / axis.length())).to_array();
    let t = 1.0 - c;
    let matrix = [
        [x * x + c * (1.0 - x * x), x * y * t + z * s, x * z * t - y * s],
        [x * y * t - z * s, y * y + c * (1.0 - y * y), y * z * t + x * s],
        [x * z * t + y * s, y * z * t - x * s, z * z + c * (1.0 - z * z)],
    ];
    times(v.to_array(), &matrix).into()
}

/// A row times a matrix.
fn times(row: [f64; 3], matrix: &[[f64; 3]; 3]) -> [f64; 3] {
    std::array::from_fn(|column| {
        row[0] * matrix[0][column] + row[1] * matrix[1][column] + row[2] * matrix[2][column]
    })
}
