//! Options a scene's text can see (docs/spec/camera-image.md 16, 20; language.md 3.7).

use std::path::PathBuf;

/// What the interpreter is told besides the scene.
///
/// Numbers a scene reads by name are already rounded to what POV-Ray hands its parser:
/// six significant digits for declared constants and frame data, single precision for `clock`.
#[derive(Debug, Clone, PartialEq)]
pub struct LanguageOptions {
    /// Folders searched for a file that the current folder does not hold, in order.
    pub library_paths: Vec<PathBuf>,
    /// A file read before the scene.
    pub include_header: Option<PathBuf>,
    /// Global identifiers, in the order they were given.
    pub declares: Vec<(String, Declared)>,
    /// The version that counts as set before the first line, times 100 (370 for 3.7).
    pub version: Option<u32>,
    /// What `input_file_name` holds: the file's name without its folder.
    pub input_file_name: String,
    /// Width in pixels, which the scene reads as `image_width`.
    pub image_width: u32,
    /// Height in pixels, which the scene reads as `image_height`.
    pub image_height: u32,
    /// The moment of this picture.
    pub clock: Clock,
    /// Whether things that cannot be rendered yet are left out with a warning.
    pub skip_unsupported: bool,
    /// Steps (directives, calls of macros) that may be run in a row without making anything (a
    /// statement, an element of an array) by loops whose end is not in sight; then the scene is
    /// stopped with an error. In all fifty times as many may be run.
    pub max_steps: u64,
    /// Bytes of memory that reading a scene may take; then it is stopped with an error.
    pub max_memory: u64,
}

/// A constant declared from outside the scene.
#[derive(Debug, Clone, PartialEq)]
pub enum Declared {
    /// A number, in single precision and to six significant digits.
    Number(f64),
    /// A string.
    Text(String),
}

/// Where a picture stands in an animation.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Clock {
    /// `clock`.
    pub value: f64,
    /// `clock_on`: whether somebody chose the value.
    pub chosen: bool,
    /// The frame data; a still picture has zeros.
    pub frames: Frames,
}

/// What an animation tells each of its frames; all zero for a still picture.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Frames {
    /// `frame_number`.
    pub number: i32,
    /// `initial_frame`.
    pub first: i32,
    /// `final_frame`.
    pub last: i32,
    /// `initial_clock`.
    pub initial_clock: f64,
    /// `final_clock`.
    pub final_clock: f64,
    /// `clock_delta`: clock from one frame to the next; infinite for a single frame.
    pub clock_delta: f64,
}

impl Default for LanguageOptions {
    /// An 800 by 600 still picture, nothing declared, nothing installed.
    fn default() -> Self {
        Self {
            library_paths: Vec::new(),
            include_header: None,
            declares: Vec::new(),
            version: None,
            input_file_name: String::new(),
            image_width: 800,
            image_height: 600,
            clock: Clock::default(),
            skip_unsupported: false,
            max_steps: 4_000_000,
            max_memory: 4 << 30,
        }
    }
}
