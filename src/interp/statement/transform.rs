//! `translate`, `rotate`, `scale`, `matrix`, `transform` (docs/spec/primitives.md 1.1).

use std::sync::Arc;

use crate::interp::value::Value;
use crate::interp::{Result, Token, Vm, Word};
use crate::math::{DVec3, Transform};
use crate::source::Span;

/// Reads one transform, if one comes next.
pub(in crate::interp) fn item(vm: &mut Vm<'_>) -> Result<Option<Transform>> {
    Ok(Some(match vm.peek_word()? {
        Some(Word::Translate) => Transform::translate(vm.after_word(Vm::read_vector)?),
        Some(Word::Rotate) => Transform::rotate(vm.after_word(Vm::read_vector)?),
        Some(Word::Scale) => scale(vm)?,
        Some(Word::Matrix) => matrix(vm)?,
        Some(Word::Transform) => *value(vm)?,
        _ => return Ok(None),
    }))
}

/// Reads `transform ID` or `transform { … }`.
pub(in crate::interp) fn value(vm: &mut Vm<'_>) -> Result<Arc<Transform>> {
    let keyword = vm.next()?;
    match variable(vm)? {
        Some(named) => Ok(named),
        None => body(vm, keyword),
    }
}

/// Reads `transform { … }`.
pub(super) fn braced(vm: &mut Vm<'_>) -> Result<Arc<Transform>> {
    let keyword = vm.next()?;
    body(vm, keyword)
}

fn body(vm: &mut Vm<'_>, keyword: Token) -> Result<Arc<Transform>> {
    let block = vm.open(keyword)?;
    let (mut transform, mut inverse) = (Transform::IDENTITY, false);
    loop {
        if vm.accept(Word::Inverse)? {
            inverse = true;
        } else if let Some(named) = variable(vm)? {
            transform = transform.then(&named);
        } else if let Some(next) = item(vm)? {
            transform = transform.then(&next);
        } else {
            break;
        }
    }
    vm.close(block)?;
    Ok(Arc::new(if inverse { transform.inverted() } else { transform }))
}

fn variable(vm: &mut Vm<'_>) -> Result<Option<Arc<Transform>>> {
    vm.accept_value(|value| match value {
        Value::Transform(transform) => Some(Arc::clone(transform)),
        _ => None,
    })
}

fn scale(vm: &mut Vm<'_>) -> Result<Transform> {
    vm.next()?;
    let (mut by, place) = vm.located(Vm::read_vector)?;
    for (axis, name) in ["x", "y", "z"].iter().enumerate() {
        if by[axis] == 0.0 {
            by[axis] = 1.0;
            vm.warn(place, format!("`scale` by 0 along {name} would leave nothing"), "1 is taken instead");
        }
    }
    Ok(Transform::scale(by))
}

fn matrix(vm: &mut Vm<'_>) -> Result<Transform> {
    vm.next()?;
    let (numbers, place) = vm.located(|vm| vm.read_components(12))?;
    let mut rows = [0.0; 12];
    rows.copy_from_slice(&numbers);
    mend_columns(vm, &mut rows, place);
    match Transform::from_rows(rows) {
        Some(transform) => Ok(transform),
        None => Err(vm
            .error(place, "this matrix has no inverse")
            .help("it squashes space flat: its first three rows must not lie in one plane")),
    }
}

/// A column of zeros gets a 1 on the diagonal.
fn mend_columns(vm: &mut Vm<'_>, rows: &mut [f64; 12], place: Span) {
    const ZERO: f64 = 1e-10;
    for column in 0..3 {
        let entries = DVec3::new(rows[column], rows[3 + column], rows[6 + column]);
        if entries.abs().max_element() < ZERO {
            rows[column * 4] = 1.0;
            vm.warn(
                place,
                format!("column {} of this matrix is zero", column + 1),
                "1 is put on its diagonal",
            );
        }
    }
}
