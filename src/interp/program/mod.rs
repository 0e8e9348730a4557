//! Expressions and declarations compiled for replay.
//!
//! In a loop or macro the same nodes are read again and again. An expression without strings and user
//! functions, or a declaration of one, is compiled the second time it is met, with the sizes its
//! operands have then; from the third time on it runs as a list of operations on a stack of
//! floats. Whenever something is not as it was (a name has another size), or is to be reported
//! (a division by zero), the program gives up without a trace, and the expression is read from
//! its tokens as ever: so there is one place for messages.

mod compile;
mod declaration;
mod inline;
mod machine;
mod run;
mod text;

pub(super) use machine::Machine;

use super::directive::PATIENCE;
