//! `julia_fractal { <a,b,c,d> … }` (docs/spec/primitives.md 5.3).

use std::sync::Arc;

use crate::interp::limits::MOST_ITERATIONS;
use crate::interp::{Result, Vm, Word};
use crate::math::DVec4;
use crate::scene::Shape;
use crate::scene::shape::{JuliaFractal, JuliaFunction};

use super::Block;

/// Reads the parameter and the settings.
pub(super) fn read(vm: &mut Vm<'_>, block: &Block) -> Result<Shape> {
    let parameter = vm.read_vec4()?;
    let mut julia = JuliaFractal {
        parameter,
        hypercomplex: false,
        function: JuliaFunction::Sqr,
        max_iteration: 20,
        precision: 20.0,
        slice: (DVec4::W, 0.0),
    };
    while let Some(word) = vm.peek_word()? {
        match word {
            Word::Quaternion | Word::Hypercomplex => {
                vm.next()?;
                julia.hypercomplex = word == Word::Hypercomplex;
            }
            Word::MaxIteration => {
                vm.next()?;
                julia.max_iteration = vm.read_at_most("max_iteration", MOST_ITERATIONS)?.max(0) as u32;
            }
            Word::Precision => julia.precision = vm.after_word(Vm::read_float)?,
            Word::Slice => {
                vm.next()?;
                julia.slice = slice(vm)?;
            }
            Word::Pwr => {
                vm.next()?;
                vm.expect(crate::syntax::Punct::OpenParen)?;
                let re = vm.read_float()?;
                vm.comma()?;
                let im = vm.read_float()?;
                vm.expect(crate::syntax::Punct::CloseParen)?;
                julia.function = JuliaFunction::Pwr(re, im);
            }
            _ => match function(word) {
                Some(function) => {
                    vm.next()?;
                    julia.function = function;
                }
                None => break,
            },
        }
    }
    let for_quaternions = matches!(julia.function, JuliaFunction::Sqr | JuliaFunction::Cube);
    if !julia.hypercomplex && !for_quaternions {
        return Err(vm
            .error(block.span, "quaternions know only `sqr` and `cube`")
            .help("add `hypercomplex` to use this function"));
    }
    Ok(Shape::JuliaFractal(Arc::new(julia)))
}

fn slice(vm: &mut Vm<'_>) -> Result<(DVec4, f64)> {
    let (normal, place) = vm.located(Vm::read_vec4)?;
    if normal.length() == 0.0 || normal.w == 0.0 {
        return Err(vm.error(place, "this slice is not a three-dimensional one").help(
            "the fourth component of the slice's normal must not be zero, as in `slice <0,0,0,1>, 0`",
        ));
    }
    vm.comma()?;
    Ok((normal, vm.read_float()?))
}

fn function(word: Word) -> Option<JuliaFunction> {
    use JuliaFunction::*;
    Some(match word {
        Word::Sqr => Sqr,
        Word::Cube => Cube,
        Word::Exp => Exp,
        Word::Reciprocal => Reciprocal,
        Word::Sin => Sin,
        Word::Asin => Asin,
        Word::Sinh => Sinh,
        Word::Asinh => Asinh,
        Word::Cos => Cos,
        Word::Acos => Acos,
        Word::Cosh => Cosh,
        Word::Acosh => Acosh,
        Word::Tan => Tan,
        Word::Atan => Atan,
        Word::Tanh => Tanh,
        Word::Atanh => Atanh,
        Word::Ln => Ln,
        _ => return None,
    })
}
