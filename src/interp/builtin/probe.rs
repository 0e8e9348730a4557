//! What expressions ask of things that have to be compiled: objects and functions. This is the
//! only file of `interp` that reaches the later stages.

use super::arguments;
use crate::interp::tuple::Tuple;
use crate::interp::value::Value;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec3;
use crate::source::Span;
use crate::syntax::{Punct, Symbol};

/// Reads the arguments of a function or spline whose name was just taken, and computes it.
pub fn call(vm: &mut Vm, called: &Value, name: Symbol, span: Span) -> Result<Tuple> {
    match called {
        Value::Spline(spline) => arguments(vm, |vm| {
            let at = vm.read_float()?;
            let kind = if vm.accept_punct(Punct::Comma)? { vm.read_spline_kind()? } else { spline.kind };
            let value = crate::math::spline::evaluate(kind, &spline.points, at);
            Ok(Tuple::new(&value[..spline.size]))
        }),
        _ => {
            let name = vm.name(name);
            Err(vm.error(span, format!("calling the function `{name}` is not supported yet")))
        }
    }
}

/// `inside(OBJECT, point)`, its name just taken.
pub fn inside(vm: &mut Vm, span: Span) -> Result<f64> {
    Err(vm.error(span, "`inside` is not supported yet"))
}

/// `trace(OBJECT, origin, direction [, normal])`, its name just taken.
pub fn trace(vm: &mut Vm, span: Span) -> Result<DVec3> {
    Err(vm.error(span, "`trace` is not supported yet"))
}

/// `min_extent` or `max_extent`, its name just taken.
pub fn extent(vm: &mut Vm, word: Word, span: Span) -> Result<DVec3> {
    Err(vm.error(span, format!("`{}` is not supported yet", word.text())))
}

/// `vturbulence(lambda, omega, octaves, point)`, its name just taken.
pub fn turbulence(vm: &mut Vm, span: Span) -> Result<DVec3> {
    Err(vm.error(span, "`vturbulence` is not supported yet"))
}
