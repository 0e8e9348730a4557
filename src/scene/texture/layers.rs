//! Layers of a texture and their colours, in little room: scenes have millions.

use std::ops::{Deref, DerefMut};
use std::sync::Arc;

use super::{Layer, Pigment};
use crate::math::Rgbft;
use crate::scene::pigment::PigmentKind;

/// One or more layers, the lowest first; most textures have one.
#[derive(Clone, Debug)]
#[expect(missing_docs, reason = "the variants say how many there are")]
pub enum Layers {
    One(Layer),
    Several(Vec<Layer>),
}

impl Layers {
    /// Puts others over these.
    pub fn extend(&mut self, others: impl IntoIterator<Item = Layer>) {
        let mut all = self.to_vec();
        all.extend(others);
        *self = Self::Several(all);
    }
}

impl Deref for Layers {
    type Target = [Layer];

    fn deref(&self) -> &[Layer] {
        match self {
            Self::One(layer) => std::slice::from_ref(layer),
            Self::Several(layers) => layers,
        }
    }
}

impl DerefMut for Layers {
    fn deref_mut(&mut self) -> &mut [Layer] {
        match self {
            Self::One(layer) => std::slice::from_mut(layer),
            Self::Several(layers) => layers,
        }
    }
}

/// Where the colour of a layer comes from.
#[derive(Clone, Debug)]
pub enum Paint {
    /// A pigment of nothing but one colour: red, green, blue, filter, transmit.
    Color([f32; 5]),
    /// Any pigment, which others may share.
    Pigment(Arc<Pigment>),
}

impl Paint {
    /// As a pigment.
    pub fn pigment(&self) -> Arc<Pigment> {
        match self {
            Self::Color(color) => Arc::new(Pigment::color(Rgbft::new(*color))),
            Self::Pigment(pigment) => Arc::clone(pigment),
        }
    }

    /// Changes it as a pigment.
    pub fn change<R>(&mut self, change: impl FnOnce(&mut Arc<Pigment>) -> R) -> R {
        let mut pigment = self.pigment();
        let changed = change(&mut pigment);
        *self = pigment.into();
        changed
    }
}

impl From<Arc<Pigment>> for Paint {
    /// What others share stays shared.
    fn from(mut pigment: Arc<Pigment>) -> Self {
        match Arc::get_mut(&mut pigment) {
            Some(Pigment { kind: PigmentKind::Color(color), quick_color: None }) => {
                Self::Color(color.to_array())
            }
            _ => Self::Pigment(pigment),
        }
    }
}
