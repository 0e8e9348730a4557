//! Splines, docs/spec/language.md 5.

use super::stream::TokenKind;
use super::value::Value;
use super::{Experimental, Result, Vm, Word};
use crate::scene::Spline;
use crate::scene::spline::SplineKind;
use crate::syntax::Punct;
use std::collections::VecDeque;
use std::sync::Arc;

/// Points that are copied in the time of a step.
const POINTS_A_STEP: u64 = 16;

fn kind_of(word: Word) -> Option<SplineKind> {
    Some(match word {
        Word::LinearSpline => SplineKind::Linear,
        Word::QuadraticSpline => SplineKind::Quadratic,
        Word::CubicSpline => SplineKind::Cubic,
        Word::NaturalSpline => SplineKind::Natural,
        _ => return None,
    })
}

impl Vm<'_> {
    /// Reads the word for a kind of spline.
    pub(super) fn read_spline_kind(&mut self) -> Result<SplineKind> {
        match self.peek_word()?.and_then(kind_of) {
            Some(kind) => {
                self.next()?;
                Ok(kind)
            }
            None => Err(self.expected("a kind of spline, such as `natural_spline`")),
        }
    }

    /// Reads `spline {..}` as a value; the word is peeked.
    pub(super) fn read_spline_value(&mut self) -> Result<Value> {
        Ok(Value::Spline(Arc::new(self.read_spline()?)))
    }

    /// Reads `spline {..}`; the word is peeked.
    pub(super) fn read_spline(&mut self) -> Result<Spline> {
        let keyword = self.next()?;
        let block = self.open(keyword)?;
        self.note_experimental(Experimental::Spline);
        let copied = self.accept_value(|value| match value {
            Value::Spline(spline) => Some(Spline::clone(spline)),
            _ => None,
        })?;
        let mut spline = copied.unwrap_or(Spline { kind: SplineKind::Linear, points: Vec::new(), size: 2 });
        // Points may come in any order: at either end they are added fast.
        let mut points = VecDeque::from(std::mem::take(&mut spline.points));
        self.work(points.len() as u64 / POINTS_A_STEP, keyword.span)?;
        while self.peek_word()?.and_then(kind_of).is_some() {
            spline.kind = self.read_spline_kind()?;
        }
        // A component that is not given keeps what the point before had.
        let mut vector = [0.0; 5];
        while self.at_number()? {
            let key = self.read_float()?;
            self.comma()?;
            if self.at_color()? && !matches!(self.peek()?.kind, TokenKind::Name(_)) {
                let fault = self.expected("a vector");
                return Err(fault.help("declare the color, and write its name here"));
            }
            let value = self.full(2)?;
            vector[..usize::from(value.n)].copy_from_slice(value.components());
            spline.size = spline.size.max(usize::from(value.n));
            insert(&mut points, key, vector);
            self.accept_punct(Punct::Comma)?;
        }
        if points.is_empty() {
            let fault = self.expected("the first point of the spline");
            return Err(fault.help("a spline needs at least one point: `0, <1, 2, 3>`"));
        }
        self.close(block)?;
        spline.points = points.into();
        Ok(spline)
    }
}

/// Adds a point by its key. A key that is there already gets the new vector, except the largest.
fn insert(points: &mut VecDeque<(f64, [f64; 5])>, key: f64, vector: [f64; 5]) {
    let at = points.partition_point(|point| point.0 < key);
    let last = at + 1 == points.len();
    match points.get_mut(at).filter(|point| point.0 == key) {
        Some(point) if !last => point.1 = vector,
        Some(_) => {}
        None => points.insert(at, (key, vector)),
    }
}
