//! What functions can call, docs/spec/language.md 4.2 and 4.5.

use crate::interp::Word;
use crate::scene::function::Builtin;

/// How many parameters each `internal` function takes after `x, y, z`.
pub(super) const INTERNAL: [u8; 79] = [
    5, 5, 5, 5, 2, 2, 5, 4, 2, 1, 4, 1, 1, 1, 1, 6, 6, 3, 1, 4, 3, 6, 1, 1, 10, 7, 7, 1, 1, 6, 1, 3, 4, 3, 6,
    1, 1, 4, 1, 6, 5, 1, 1, 1, 4, 1, 3, 0, 1, 1, 7, 5, 6, 1, 1, 1, 3, 0, 6, 6, 4, 1, 5, 4, 6, 1, 4, 7, 2, 0,
    2, 3, 1, 1, 2, 6, 0, 0, 1,
];

/// Least and most arguments of a function that a body can call.
pub(super) fn builtin(word: Word) -> Option<(Builtin, usize, usize)> {
    Some(match word {
        Word::Abs => (Builtin::Abs, 1, 1),
        Word::Acos => (Builtin::Acos, 1, 1),
        Word::Acosh => (Builtin::Acosh, 1, 1),
        Word::Asin => (Builtin::Asin, 1, 1),
        Word::Asinh => (Builtin::Asinh, 1, 1),
        Word::Atan => (Builtin::Atan, 1, 1),
        Word::Atan2 => (Builtin::Atan2, 2, 2),
        Word::Atanh => (Builtin::Atanh, 1, 1),
        Word::Ceil => (Builtin::Ceil, 1, 1),
        Word::Cos => (Builtin::Cos, 1, 1),
        Word::Cosh => (Builtin::Cosh, 1, 1),
        Word::Degrees => (Builtin::Degrees, 1, 1),
        Word::Div => (Builtin::Div, 2, 2),
        Word::Exp => (Builtin::Exp, 1, 1),
        Word::Floor => (Builtin::Floor, 1, 1),
        Word::Int => (Builtin::Int, 1, 1),
        Word::Ln => (Builtin::Ln, 1, 1),
        Word::Log => (Builtin::Log, 1, 1),
        Word::Max => (Builtin::Max, 2, usize::MAX),
        Word::Min => (Builtin::Min, 2, usize::MAX),
        Word::Mod => (Builtin::Mod, 2, 2),
        Word::Pow => (Builtin::Pow, 2, 2),
        Word::Radians => (Builtin::Radians, 1, 1),
        Word::Select => (Builtin::Select, 3, 4),
        Word::Sin => (Builtin::Sin, 1, 1),
        Word::Sinh => (Builtin::Sinh, 1, 1),
        Word::Sqrt => (Builtin::Sqrt, 1, 1),
        Word::Tan => (Builtin::Tan, 1, 1),
        Word::Tanh => (Builtin::Tanh, 1, 1),
        _ => return None,
    })
}
