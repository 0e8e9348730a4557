//! Expressions compiled for replay.
//!
//! In a loop or macro the same nodes are read again and again. An expression without directives,
//! macros, strings and user functions is compiled the second time it is met, with the sizes its
//! operands have then; from the third time on it runs as a list of operations on a stack of
//! floats. Whenever something is not as it was (a name has another size), or is to be reported
//! (a division by zero), the program gives up without a trace, and the expression is read from
//! its tokens as ever: so there is one place for messages.

mod compile;
mod run;
