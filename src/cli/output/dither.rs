//! Dithering: rounding errors spread so that no bands show (docs/spec/camera-image.md 13).

use super::samples::{Curve, round, scale};

/// A way to dither.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Dither {
    /// A regular pattern with this many pixels to a side: 2, 3 or 4.
    Bayer(u8),
    /// The whole error goes to the next pixel.
    Next,
    /// The error goes to three neighbours.
    Simple,
    /// The error goes to four neighbours.
    FloydSteinberg,
}

impl Dither {
    /// The way POV-Ray calls by a name.
    pub fn of_name(name: &str) -> Option<Self> {
        Some(match name {
            "B2" => Self::Bayer(2),
            "B3" => Self::Bayer(3),
            "B4" => Self::Bayer(4),
            "D1" => Self::Next,
            "D2" => Self::Simple,
            "FS" => Self::FloydSteinberg,
            _ => return None,
        })
    }

    /// What POV-Ray calls it on the console.
    pub fn name(self) -> &'static str {
        match self {
            Self::Bayer(2) => "2x2 Bayer pattern",
            Self::Bayer(3) => "3x3 Bayer pattern",
            Self::Bayer(_) => "4x4 Bayer pattern",
            Self::Next => "Simple 1D error diffusion",
            Self::Simple => "Simple 2D error diffusion",
            Self::FloydSteinberg => "Floyd-Steinberg error diffusion",
        }
    }
}

/// Patterns by column, then row.
const BAYER_2: [[u8; 2]; 2] = [[1, 3], [4, 2]];
const BAYER_3: [[u8; 3]; 3] = [[3, 7, 4], [6, 1, 9], [2, 8, 5]];
const BAYER_4: [[u8; 4]; 4] = [[1, 9, 3, 11], [13, 5, 15, 7], [4, 12, 2, 10], [16, 8, 14, 6]];

/// Carries rounding errors from pixel to pixel.
#[derive(Debug)]
pub(super) struct Ditherer {
    method: Dither,
    channels: usize,
    column: usize,
    row: usize,
    /// Errors for the rest of this row, by column and channel; a spare column stands at each end.
    this: Vec<f32>,
    /// Errors for the row below.
    next: Vec<f32>,
    /// Errors for the current pixel, by channel.
    pending: Vec<f32>,
}

impl Ditherer {
    /// Starts before the first pixel of a picture.
    pub(super) fn new(method: Dither, width: u32, channels: usize) -> Self {
        let row = vec![0.0; (width as usize + 2) * channels];
        let pending = vec![0.0; channels];
        Self { method, channels, column: 0, row: 0, this: row.clone(), next: row, pending }
    }

    /// Goes on to the next pixel, which is at this place: rows follow each other in either direction.
    pub(super) fn go_to(&mut self, column: usize, row: usize) {
        (self.column, self.row) = (column, row);
        if self.method == Dither::Next {
            return;
        }
        let place = self.place(0, 0);
        self.pending.copy_from_slice(&self.this[place..place + self.channels]);
        if self.column == 0 {
            // The rows change places only after the first pixel has taken what was pending for it, so its
            // own share from the row above is lost: POV-Ray's pictures show this.
            std::mem::swap(&mut self.this, &mut self.next);
            self.next.fill(0.0);
        }
    }

    /// Rounds a channel of the current pixel.
    pub(super) fn round(&mut self, value: f32, channel: usize, bits: u8, curve: Curve) -> u16 {
        if let Dither::Bayer(edge) = self.method {
            return round(curve.encode(value) + self.pattern(edge) / scale(bits), bits);
        }
        let value = value + self.pending[channel];
        let rounded = round(curve.encode(value), bits);
        let error = value.clamp(0.0, 1.0) - curve.decode(f32::from(rounded) / scale(bits));
        self.spread(error, channel);
        rounded
    }

    /// The pattern's part of a quantum at the current pixel.
    fn pattern(&self, edge: u8) -> f32 {
        let size = usize::from(edge);
        let (x, y) = (self.column % size, self.row % size);
        let step = match edge {
            2 => BAYER_2[x][y],
            3 => BAYER_3[x][y],
            _ => BAYER_4[x][y],
        };
        f32::from(step) / f32::from(edge * edge) - 0.5
    }

    /// Hands the error of a channel to the pixels to come.
    fn spread(&mut self, error: f32, channel: usize) {
        let (right, below_left, below, below_right) = match self.method {
            Dither::Bayer(_) => return,
            Dither::Next => {
                self.pending[channel] = error;
                return;
            }
            Dither::Simple => (1.0 / 2.0, 0.0, 1.0 / 4.0, 1.0 / 4.0),
            Dither::FloydSteinberg => (7.0 / 16.0, 3.0 / 16.0, 5.0 / 16.0, 1.0 / 16.0),
        };
        let [here, to_left, to_right] = [0, -1, 1].map(|offset| self.place(offset, channel));
        self.this[to_right] += error * right;
        self.next[to_left] += error * below_left;
        self.next[here] += error * below;
        self.next[to_right] += error * below_right;
    }

    /// Where a row keeps the error of a channel, so many columns from the current one.
    fn place(&self, offset: isize, channel: usize) -> usize {
        (self.column + 1).wrapping_add_signed(offset) * self.channels + channel
    }
}
