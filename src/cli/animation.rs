//! Which frames a run renders, and what each is told (docs/spec/camera-image.md 20).

use super::settings::value::six_digits;
use super::settings::{Name, Settings};
use crate::options::{Clock, Frames};

/// The frames of a run.
#[derive(Debug, Clone, PartialEq)]
pub enum Animation {
    /// One picture, with the clock the user may have set.
    Still(Option<f32>),
    /// A series.
    Series(Series),
}

/// An animation's frames and times.
#[derive(Debug, Clone, PartialEq)]
pub struct Series {
    /// `initial_frame`, at least 0.
    pub first: i32,
    /// `final_frame` as the scene sees it: one more than given for a cyclic animation.
    pub last: i32,
    /// The first frame rendered.
    pub start: i32,
    /// The last frame that may be rendered.
    pub end: i32,
    /// From one rendered frame to the next, at least 1.
    pub step: i32,
    /// Clock of the first frame.
    pub initial_clock: f32,
    /// Clock of the last frame.
    pub final_clock: f32,
}

/// One picture of a run.
#[derive(Debug, Clone, PartialEq)]
pub struct Frame {
    /// What stands before the extension of its file's name.
    pub digits: String,
    /// What its scene is told.
    pub clock: Clock,
}

impl Animation {
    /// Reads the frames from the options.
    pub fn new(settings: &Settings) -> Self {
        let given = (settings.int(Name::InitialFrame), settings.int(Name::FinalFrame));
        // A frame that isn't given counts as 0 here, so `+KFF1` alone is an animation.
        if matches!((given.0.unwrap_or(0), given.1.unwrap_or(0)), (0, 0) | (1, 1)) {
            return Self::Still(settings.float(Name::Clock));
        }
        let first = given.0.unwrap_or(1).max(0);
        let uncycled = given.1.unwrap_or(1).max(first);
        let cyclic = settings.bool(Name::CyclicAnimation) == Some(true);
        let last = uncycled.saturating_add(i32::from(cyclic));
        let count = (f64::from(last) - f64::from(first) + 1.0) as f32;
        let frame = |limit: Option<f32>, fallback: i32| match limit {
            Some(part) if part > 0.0 && part < 1.0 => (count * part) as i32,
            Some(number) => number as i32,
            None => fallback,
        };
        let start = frame(settings.float(Name::SubsetStartFrame), first).max(first);
        let end = frame(settings.float(Name::SubsetEndFrame), uncycled).max(start);
        Self::Series(Series {
            first,
            last,
            start,
            end,
            step: settings.int(Name::FrameStep).unwrap_or(1).max(1),
            initial_clock: settings.float(Name::InitialClock).unwrap_or(0.0),
            final_clock: settings.float(Name::FinalClock).unwrap_or(1.0),
        })
    }

    /// The frames in the order they are rendered.
    pub fn frames(&self) -> Box<dyn Iterator<Item = Frame> + '_> {
        match self {
            Self::Still(clock) => {
                let clock = Clock {
                    value: f64::from(clock.unwrap_or(0.0)),
                    chosen: clock.is_some(),
                    frames: Frames::default(),
                };
                Box::new(std::iter::once(Frame { digits: String::new(), clock }))
            }
            Self::Series(series) => {
                let step = usize::try_from(series.step).unwrap_or(1);
                Box::new((series.start..=series.end).step_by(step).map(|number| series.frame(number)))
            }
        }
    }
}

impl Series {
    /// What a frame is called and told.
    fn frame(&self, number: i32) -> Frame {
        let (first, last) = (f64::from(self.initial_clock), f64::from(self.final_clock));
        // One frame alone has an infinite step and no number for a clock, as in POV-Ray.
        let delta = (last - first) / f64::from(self.last - self.first);
        let clock = first + delta * f64::from(number - self.first);
        let digits = self.last.to_string().len();
        Frame {
            digits: format!("{number:0digits$}"),
            clock: Clock {
                value: f64::from(clock as f32),
                chosen: true,
                frames: Frames {
                    number,
                    first: self.first,
                    last: self.last,
                    initial_clock: six_digits(self.initial_clock),
                    final_clock: six_digits(self.final_clock),
                    clock_delta: six_digits(delta as f32),
                },
            },
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cli::povray;

    fn frames(words: &str) -> Vec<Frame> {
        let mut settings = Settings::default();
        for word in words.split_whitespace() {
            povray::read(word, &mut settings).expect("a known switch");
        }
        Animation::new(&settings).frames().collect()
    }

    /// The rows of docs/spec/camera-image.md 20: files and clocks.
    #[test]
    fn frames_are_numbered_and_timed_as_povray_does() {
        let rows: &[(&str, &[(&str, f64)])] = &[
            ("", &[("", 0.0)]),
            ("+K0.1", &[("", 0.100000001490116)]),
            ("+KFI0", &[("", 0.0)]),
            ("+KFI1 +KFF1", &[("", 0.0)]),
            ("+KFF3", &[("1", 0.0), ("2", 0.5), ("3", 1.0)]),
            ("+KFF4 +KC", &[("1", 0.0), ("2", 0.25), ("3", 0.5), ("4", 0.75)]),
            ("+KFI2 +KFF4 +KI1.0 +KF2.0", &[("2", 1.0), ("3", 1.5), ("4", 2.0)]),
            ("+KFF10 +SF4 +EF5", &[("04", 0.3333333433), ("05", 0.4444444478)]),
            ("+KFF10 +SF0.3 +EF0.5", &[("03", 0.2222222239), ("04", 0.3333333433), ("05", 0.4444444478)]),
            ("+KFF10 +STP4", &[("01", 0.0), ("05", 0.4444444478), ("09", 0.8888888955)]),
            ("+KFF12 +SF20", &[("20", 1.7272727489)]),
            ("+KFF3 +KC +SF3 +EF5", &[("3", 0.6666666865), ("4", 1.0), ("5", 1.3333333731)]),
            ("+KFI8 +KFF10", &[("08", 0.0), ("09", 0.5), ("10", 1.0)]),
            ("+KFI0 +KFF2", &[("0", 0.0), ("1", 0.5), ("2", 1.0)]),
        ];
        for (words, expected) in rows {
            let frames = frames(words);
            assert_eq!(frames.len(), expected.len(), "{words}");
            for (frame, (digits, clock)) in frames.iter().zip(*expected) {
                assert_eq!(frame.digits, *digits, "{words}");
                assert!((frame.clock.value - clock).abs() < 1e-10, "{words}: {}", frame.clock.value);
            }
        }
    }

    #[test]
    fn a_cyclic_animation_counts_one_frame_more() {
        let frames = frames("+KFF9 +KC");
        assert_eq!(frames.len(), 9);
        assert_eq!(frames[0].digits, "01");
        assert_eq!(frames[0].clock.frames.last, 10);
        assert_eq!(frames[0].clock.frames.clock_delta, 0.111111);
    }

    #[test]
    fn a_single_frame_has_no_clock_and_an_infinite_step() {
        for words in ["+KFF1", "+KFI5 +KFF5"] {
            let frames = frames(words);
            assert_eq!(frames.len(), 1);
            assert!(frames[0].clock.value.is_nan());
            assert_eq!(frames[0].clock.frames.clock_delta, f64::INFINITY);
        }
    }

    #[test]
    fn a_still_picture_tells_its_scene_zeros() {
        let still = &frames("+K2")[0];
        assert!(still.clock.chosen);
        assert_eq!(still.clock.frames, Frames::default());
    }
}
