//! `rand` and `seed`, bit for bit, docs/spec/language.md 3.11.

/// The random streams of a scene.
#[derive(Debug, Default)]
pub struct Random {
    states: Vec<u32>,
    /// Streams that were advanced since recording started, with their state before.
    advanced: Vec<(usize, u32)>,
}

impl Random {
    /// Starts a stream and gives its number.
    pub fn seed(&mut self, seed: i32) -> f64 {
        self.states.push(seed as u32);
        (self.states.len() - 1) as f64
    }

    /// The next number of a stream, 0 to 1 inclusive; `None` if there is no such stream.
    pub fn next(&mut self, stream: i32) -> Option<f64> {
        let stream = usize::try_from(stream).ok()?;
        let state = self.states.get_mut(stream)?;
        self.advanced.push((stream, *state));
        *state = state.wrapping_mul(1_812_433_253).wrapping_add(12345);
        Some(f64::from(*state) / 4_294_967_295.0)
    }

    /// From here on numbers can be taken back.
    pub fn start_recording(&mut self) {
        self.advanced.clear();
    }

    /// Takes back the numbers given since recording started.
    pub fn undo(&mut self) {
        while let Some((stream, state)) = self.advanced.pop() {
            self.states[stream] = state;
        }
    }
}
