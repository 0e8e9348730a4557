//! What a scene may use up before it is stopped with an error.

/// Macro calls and include files inside each other. POV-Ray stops at 98; a recursive macro that
/// needs a thousand levels is rather one that never ends.
pub const MOST_SCOPES: u32 = 1000;

/// Directives with an `#end` inside each other.
pub const MOST_BLOCKS: usize = 2000;

/// Parentheses, vectors and statements inside each other.
pub const MOST_NESTING: u32 = 1000;

/// Braces inside each other that are worth a warning.
pub const SUSPICIOUS_NESTING: i32 = 199;

/// Stack of a run, in bytes: 64 KiB for each level of nesting. Only what is used takes memory.
pub const STACK: usize = (MOST_NESTING as usize) << 16;

/// Objects a scene may make in all: a loop without end that makes them is stopped before the
/// memory of an ordinary machine is used up.
pub const MOST_OBJECTS: u64 = 20_000_000;

/// Elements of one array: with more, the memory of an ordinary machine would not do.
pub const MOST_ELEMENTS: usize = 20_000_000;

/// Characters of one string.
pub const MOST_CHARACTERS: usize = 1 << 24;

/// Errors that are shown before reading stops.
pub const MOST_ERRORS: usize = 50;

/// Statements that may fail, shown or not, before reading stops: each turn of a loop can.
pub const MOST_FAULTS: usize = 10_000;

/// Steps of the way into macros and includes that are shown with an error.
pub const MOST_STEPS: usize = 12;

/// Parameters of a macro.
pub const MOST_PARAMETERS: usize = 55;

/// Parameters of a function.
pub const MOST_FUNCTION_PARAMETERS: usize = 56;

/// Terms of a sum between two numbers that are known when a function is defined: no evaluation
/// could take so many steps (`world::function::Budget`).
pub const MOST_TERMS: f64 = 5e7;

/// Turns of a formula at one point, in patterns and solids made of them: more would keep it busy for ever.
pub const MOST_ITERATIONS: i32 = 10_000_000;

/// Rays of one pixel through a lens.
pub const MOST_BLUR_SAMPLES: i32 = 1_000_000;

/// Intervals of media along a ray, and samples of each.
pub const MOST_MEDIA_SAMPLES: i32 = 10_000;

/// Points of an area light.
pub const MOST_LIGHTS: u64 = 1_000_000;

/// Colors that light is split into where it is dispersed.
pub const MOST_COLORS: i32 = 10_000;

/// How often each side of a patch is halved.
pub const MOST_PATCH_STEPS: i32 = 8;

/// How often media are looked at more closely.
pub const MOST_MEDIA_LEVELS: i32 = 20;

/// Dimensions of an array.
pub const MOST_DIMENSIONS: usize = 5;
