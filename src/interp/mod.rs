//! Nodes in, a scene out: runs the language.
//!
//! - [`interpret`] reads a whole scene. What it has to say goes to a [`Sink`]; one run finds as
//!   many independent errors as it can.
//! - A [`Vm`] is the state of a run. Readers of statements take tokens from it; by the time they
//!   see one, directives have run and macros are expanded. Scopes, arms and loops are no concern
//!   of theirs, nor is where a brace was written.
//! - Nothing in a scene can make a run last or grow without end: `limits` lists what stops it.
//!
//! # How a statement is read
//!
//! A reader takes its keyword, the brace, its parameters with optional commas between them, then
//! items as long as one fits, and the closing brace, which reports whatever did not fit:
//!
//! ```ignore
//! fn sphere(vm: &mut Vm) -> Result<Object> {
//!     let keyword = vm.next()?;                    // `sphere`: the caller peeked it
//!     let block = vm.open(keyword)?;               // `{`, or an error that says so
//!     let center = vm.read_vector()?;              // a DVec3; floats are promoted
//!     vm.comma()?;                                 // at most one
//!     let radius = vm.read_float()?;
//!     let mut object = Object::new(block.span, Shape::Sphere { center, radius });
//!     loop {
//!         match vm.peek_word()? {                  // peeking runs directives, takes nothing
//!             Some(Word::NoShadow) => { vm.next()?; object.flags |= ObjectFlags::NO_SHADOW }
//!             Some(Word::Hollow) => { vm.next()?; let on = vm.read_flag()?; /* … */ }
//!             Some(Word::Pigment) => { /* call its reader */ }
//!             _ => break,
//!         }
//!     }
//!     object.span = block.span.to(vm.close(block)?);
//!     Ok(object)
//! }
//! ```
//!
//! - Names: `vm.accept_value(|v| match v { Value::Pigment(p) => Some(p.clone()), _ => None })?`
//!   takes the name of a pigment, or an array element that is one, and nothing else.
//! - Errors: `return Err(vm.error(span, "what is wrong").help("how to mend it"))`;
//!   `Err(vm.expected("a pattern"))` names the token that was found. Warnings: `vm.warn(..)`.
//! - A reader that calls itself (a CSG in a CSG) goes through [`Vm::nested`], which guards the stack.

mod array;
pub mod builtin;
pub mod check;
mod closing;
pub mod code;
mod directive;
mod effort;
mod expr;
mod fault;
pub mod file;
pub mod format;
mod function;
pub mod limits;
mod macros;
mod memory;
pub mod notes;
mod program;
mod read;
mod recover;
pub mod scope;
mod spline;
pub mod statement;
pub mod stream;
pub mod tuple;
pub mod value;
mod word;

pub use builtin::probe::Known;
pub use closing::Experimental;
pub use fault::{Fault, Result};
pub use read::Block;
pub use stream::{Token, TokenKind};
pub use value::Value;
pub use word::Word;

use crate::diag::{self, Diagnostic, Severity, Sink};
use crate::math::gamma::Gamma;
use crate::math::pages;
use crate::options::{Declared, LanguageOptions};
use crate::scene::Scene;
use crate::scene::depth::{DEEPEST, Depth};
use crate::source::{FileId, Sources, Span};
use crate::syntax::{Punct, Symbol, Symbols};
use code::Code;
use rustc_hash::{FxHashMap, FxHashSet};
use scope::{Place, Scopes};
use std::rc::Rc;

/// How the bytes of string literals are read, `global_settings { charset }`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Charset {
    /// Bytes above 127 become spaces.
    #[default]
    Ascii,
    /// UTF-8.
    Utf8,
    /// As the platform has it, which is UTF-8 too.
    Sys,
}

/// The state of a run.
pub struct Vm<'a> {
    /// The files.
    pub sources: &'a mut Sources,
    /// What is known from outside the scene.
    pub options: &'a LanguageOptions,
    /// The `#version` in force, times 100.
    pub version: i32,
    /// The encoding of string literals.
    pub charset: Charset,
    /// The curve of the space colors are calculated in, once `assumed_gamma` is known.
    pub gamma: Option<Gamma>,
    /// What readers of statements keep.
    pub state: statement::State,
    /// Where the last token that was taken stands.
    pub last: Span,
    /// Objects and functions that expressions have asked about.
    compiled: builtin::probe::Compiled,
    sink: &'a mut dyn Sink,
    /// What names held, if anybody wants to know.
    notes: Option<notes::Notes>,
    symbols: Symbols,
    trees: FxHashMap<FileId, Rc<Code>>,
    frame: stream::Frame,
    frames: Vec<stream::Frame>,
    blocks: Vec<directive::Open>,
    scopes: Scopes,
    random: builtin::random::Random,
    /// The token that was peeked, and what its name stands for.
    ahead: Option<Token>,
    place: Option<Place>,
    /// The name whose value is being read: a function may call itself by it.
    declaring: Option<Symbol>,
    /// Directives at operator positions are not run.
    blocked: bool,
    /// A `#` that was no directive, for the help of the error that follows.
    dropped_hash: Option<Span>,
    /// Braces that are open.
    depth: i32,
    /// That so many are is suspicious, and was said.
    warned_of_depth: bool,
    /// Loops that are open.
    loops: u32,
    machine: program::Machine,
    /// Levels of nesting of what is being read.
    nesting: u32,
    /// What was done so far, against scenes that are never done.
    effort: effort::Effort,
    /// Bytes of big things made since it was last looked at how much memory is in use.
    added: usize,
    /// The memory in use before the run.
    memory_before: u64,
    /// Objects made so far.
    objects: u64,
    /// Experimental features the scene uses.
    experimental: Vec<Experimental>,
    /// A `#version` was met, or given from outside.
    version_written: bool,
    /// The first one came after something else.
    version_late: bool,
    /// Nothing more is read.
    stopped: bool,
    /// Why that is has been said.
    ended: bool,
    failed: bool,
    /// There was an error since the last statement that had none: what follows may belong to the one that
    /// had it.
    confused: bool,
    faults: usize,
    errors: usize,
    said: FxHashSet<(Option<Span>, String)>,
    /// Where names like one that is unknown were looked for.
    suggested: FxHashSet<Span>,
}

/// Reads a scene. `None` when it has errors, which the sink has heard of.
pub fn interpret(
    main: FileId,
    sources: &mut Sources,
    options: &LanguageOptions,
    sink: &mut dyn Sink,
) -> Option<Scene> {
    interpret_knowing(main, sources, options, sink).map(|(scene, _)| scene)
}

/// Reads a scene, and gives what of it had to be compiled for it.
pub fn interpret_knowing(
    main: FileId,
    sources: &mut Sources,
    options: &LanguageOptions,
    sink: &mut dyn Sink,
) -> Option<(Scene, Known)> {
    sources.library.paths.extend(options.library_paths.iter().cloned());
    // Statements inside each other take little stack each, but there may be many.
    stacker::grow(limits::STACK, || {
        let mut vm = Vm::new(main, sources, options, sink);
        vm.run_scene();
        let known = std::mem::take(&mut vm.compiled.known);
        let scene = if vm.failed { None } else { statement::finish(vm) };
        scene.map(|scene| (scene, known))
    })
}

/// Reads a scene and notes what its names held. What is noted is right even if the scene has errors.
pub fn interpret_noting(
    main: FileId,
    sources: &mut Sources,
    options: &LanguageOptions,
    sink: &mut dyn Sink,
) -> (Option<Scene>, notes::Notes) {
    sources.library.paths.extend(options.library_paths.iter().cloned());
    stacker::grow(limits::STACK, || {
        let mut vm = Vm::new(main, sources, options, sink);
        vm.notes = Some(notes::Notes::default());
        vm.run_scene();
        let notes = vm.notes.take().unwrap_or_default();
        (if vm.failed { None } else { statement::finish(vm) }, notes)
    })
}

impl<'a> Vm<'a> {
    fn new(
        main: FileId,
        sources: &'a mut Sources,
        options: &'a LanguageOptions,
        sink: &'a mut dyn Sink,
    ) -> Vm<'a> {
        let mut symbols = Word::symbols();
        let tree = Code::new(crate::syntax::parse(main, sources.get(main), &mut symbols));
        let last = Span { file: main, ..Span::default() };
        let frame = stream::Frame { end: tree.nodes.len(), tree, pos: 0, entered: None, blocks: 0 };
        let mut vm = Vm {
            sources,
            options,
            version: options.version.map_or(370, |version| version as i32),
            charset: Charset::default(),
            gamma: None,
            state: statement::State::default(),
            last,
            compiled: builtin::probe::Compiled::default(),
            sink,
            notes: None,
            symbols,
            trees: FxHashMap::default(),
            frame,
            frames: Vec::new(),
            blocks: Vec::new(),
            scopes: Scopes::default(),
            random: Default::default(),
            ahead: None,
            place: None,
            declaring: None,
            blocked: false,
            dropped_hash: None,
            depth: 0,
            warned_of_depth: false,
            loops: 0,
            machine: program::Machine::default(),
            nesting: 0,
            effort: effort::Effort::default(),
            added: 0,
            memory_before: pages::used(),
            objects: 0,
            experimental: Vec::new(),
            version_written: options.version.is_some(),
            version_late: false,
            stopped: false,
            ended: false,
            failed: false,
            confused: false,
            faults: 0,
            errors: 0,
            said: FxHashSet::default(),
            suggested: FxHashSet::default(),
        };
        vm.declare_options();
        for error in &Rc::clone(&vm.frame.tree).errors {
            vm.report(error.clone());
        }
        vm
    }

    /// Binds what the outside declares, docs/spec/language.md 3.7.
    fn declare_options(&mut self) {
        let options = self.options;
        let frames = options.clock.frames;
        let numbers = [
            ("image_width", f64::from(options.image_width)),
            ("image_height", f64::from(options.image_height)),
            ("frame_number", f64::from(frames.number)),
            ("initial_frame", f64::from(frames.first)),
            ("final_frame", f64::from(frames.last)),
            ("initial_clock", frames.initial_clock),
            ("final_clock", frames.final_clock),
            ("clock_delta", frames.clock_delta),
        ];
        for (name, value) in numbers {
            self.declare_name(name, Value::Float(value));
        }
        self.declare_name("input_file_name", Value::Text(options.input_file_name.as_str().into()));
        for (name, declared) in &options.declares {
            let value = match declared {
                Declared::Number(number) => Value::Float(*number),
                Declared::Text(text) => Value::Text(text.as_str().into()),
            };
            self.declare_name(name, value);
        }
    }

    fn declare_name(&mut self, name: &str, value: Value) {
        let symbol = self.symbols.intern(name);
        if Word::of(symbol).is_none() {
            self.scopes.bind_global(symbol, Place::new(value));
        }
    }

    /// Reads the scene from its first token to its last.
    fn run_scene(&mut self) {
        self.include_header();
        while !self.stopped {
            let depth = self.depth;
            match self.top_level() {
                Ok(true) => self.confused = false,
                Ok(false) => break,
                Err(fault) => {
                    self.settle(fault);
                    if !self.stopped {
                        self.skip_statement(depth);
                    }
                }
            }
        }
        if !self.stopped {
            self.check_end();
        }
    }

    /// Starts with the file that is to be read before the scene.
    fn include_header(&mut self) {
        let Some(header) = &self.options.include_header else { return };
        let start = Span { end: 0, ..self.frame.tree.span(0) };
        if let Err(fault) = self.include_file(&header.display().to_string(), start, start) {
            self.settle(fault);
        }
    }

    /// Reads one statement; `false` at the end of the scene.
    fn top_level(&mut self) -> Result<bool> {
        let token = self.peek()?;
        match token.kind {
            TokenKind::End => Ok(false),
            TokenKind::Word(word @ (Word::Declare | Word::Include | Word::Version | Word::Default)) => {
                self.take(token);
                self.without_hash(word, token.span)?;
                Ok(true)
            }
            _ if statement::read_top_level(self)? => Ok(true),
            _ if self.is_left_over(token) => Err(Fault::reported()),
            TokenKind::Punct(Punct::Semicolon) => {
                let fault = self.error(token.span, "a `;` on its own means nothing here");
                Err(fault.help("it only ends `#declare`, `#local` and `#version`; remove it"))
            }
            TokenKind::Text => {
                let fault = self.error(token.span, "expected an object or a directive, found a string");
                // A file that is not included would only be missed from here on.
                self.stop();
                Err(fault.help("is this a file to read? write `#include` before it"))
            }
            TokenKind::Name(symbol) if self.at_node(Punct::Equal) && !self.scopes.is_bound(symbol) => {
                let fault = self.expected("an object or a directive");
                self.poison(symbol);
                Err(fault.help(format!("write `#declare {} = …`", self.symbols.name(symbol))))
            }
            _ => Err(self.expected("an object or a directive")),
        }
    }

    /// A directive without its `#`, which old scenes have at the top level.
    fn without_hash(&mut self, word: Word, span: Span) -> Result<()> {
        let message = format!("`{}` without its `#`", word.text());
        match word {
            Word::Declare if self.version >= 350 => self.possible(span, message, "write a `#` before it"),
            Word::Include | Word::Version if self.version >= 350 => {
                self.deprecated(span, message, "write a `#` before it");
            }
            _ => {}
        }
        match word {
            Word::Declare => self.declare(false),
            Word::Include => self.include(span),
            Word::Version => self.set_version(span),
            _ => self.set_default(span),
        }
    }

    /// Reports what is still open at the end of the scene.
    fn check_end(&mut self) {
        if let Some(open) = self.blocks.last() {
            let word = self.sources.text(open.span).to_owned();
            let fault = self.error(open.span, format!("`{word}` without `#end`"));
            self.settle(fault.help("add `#end` where its last arm ends"));
        }
        // A scene with errors has more urgent things to hear.
        if self.failed {
            return;
        }
        self.closing_remarks();
    }

    /// Reads something that can contain itself: checks that it does not go too deep, and that
    /// there is stack left.
    pub fn nested<T>(&mut self, span: Span, read: impl FnOnce(&mut Self) -> Result<T>) -> Result<T> {
        /// Stack that must be left before going deeper, and how much is added when it is not.
        const RED_ZONE: usize = 128 << 10;
        const MORE: usize = 2 << 20;
        if self.nesting >= limits::MOST_NESTING {
            return Err(self.too_deep(span));
        }
        self.nesting += 1;
        let result = stacker::maybe_grow(RED_ZONE, MORE, || read(self));
        self.nesting -= 1;
        result
    }

    /// Reads a value that can hold others of its kind: checks also how deep those hold others,
    /// which were declared before it.
    pub fn nested_value<T: Depth>(
        &mut self,
        span: Span,
        read: impl FnOnce(&mut Self) -> Result<T>,
    ) -> Result<T> {
        let value = self.nested(span, read)?;
        self.check_depth(&value, span)?;
        Ok(value)
    }

    /// Refuses a value in which others stand in each other too deep.
    fn check_depth(&mut self, value: &impl Depth, span: Span) -> Result<()> {
        if value.depth() <= DEEPEST {
            return Ok(());
        }
        let message = format!("this is nested more than {DEEPEST} levels deep, counting what it names");
        Err(self.fatal(span, message).help("each holds the one before: does a loop add to it?"))
    }

    /// The error for what is nested too deep.
    fn too_deep(&mut self, span: Span) -> Fault {
        let message = format!("nested more than {} levels deep here", limits::MOST_NESTING);
        self.fatal(span, message).help("name parts of it with `#declare`, and use the names")
    }

    /// Counts an object that is made.
    fn count_object(&mut self, span: Span) -> Result<()> {
        self.objects += 1;
        if self.objects > limits::MOST_OBJECTS {
            let message = format!("more than {} objects", limits::MOST_OBJECTS);
            return Err(self.fatal(span, message).help("does the loop that makes them ever end?"));
        }
        Ok(())
    }

    /// Notes that something concerns the scene as a whole.
    pub fn remark(&mut self, severity: Severity, message: &str, help: &str) {
        self.report(Diagnostic::new(severity, None, message).help(help));
    }

    /// Notes that the scene does not say which version it is in, where it should.
    fn remark_missing_version(&mut self, message: &str) {
        let help = "start it with `#version 3.7;`, or what it was written for";
        self.report(
            Diagnostic::new(Severity::Warning, None, message).code(diag::Code::MissingVersion).help(help),
        );
    }
}
