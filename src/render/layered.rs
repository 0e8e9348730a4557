//! Textures that rays of a bundle meet together and that are not [plain](super::plain), for they have several layers,
//! bumps, or let light through: their pigments are evaluated side by side before the rays are shaded one after the other.

use super::plain::Bundle;
use super::textures;
use super::trace::Tracer;
use crate::math::color::FourColors;
use crate::math::{Lanes, Rgbft};
use crate::world::Intersection;
use crate::world::object::LeafFlags;
use crate::world::sample::Samples;
use crate::world::texture::{Layer, Paint};

/// Surfaces of one texture, and the colours of its topmost layers there: kept where they are, for what is copied when it
/// was only just written is waited for.
#[derive(Debug)]
pub(super) struct Layered {
    surfaces: [Intersection; Lanes::COUNT],
    /// From the top down.
    colors: [FourColors; Self::MOST],
    /// How many of the layers are known.
    known: usize,
    /// The place in these lists of each ray of the bundle that met the texture.
    places: [Option<u8>; Lanes::COUNT],
}

impl Layered {
    /// So many layers are looked at beforehand.
    const MOST: usize = 4;

    const NOTHING: Self = Self {
        surfaces: [Intersection::NOWHERE; Lanes::COUNT],
        colors: [FourColors::NONE; Self::MOST],
        known: 0,
        places: [None; Lanes::COUNT],
    };
}

/// A surface of which something is known before it is shaded.
#[derive(Clone, Copy, Debug)]
pub(super) struct Foreseen {
    /// Which of the tracer's lists of surfaces it is in, and where.
    list: usize,
    place: usize,
}

impl Tracer<'_> {
    /// Looks at the surfaces of a texture that more than one ray of a bundle meets, of those whose bits are `open`,
    /// and keeps them until [`Self::forget`].
    pub(super) fn look_at_layers<const N: usize>(&mut self, bundle: &Bundle<N>, open: u32) {
        if self.layered.len() == self.bundles {
            self.layered.push(Layered::NOTHING);
        }
        // Out of the list meanwhile, but not moved.
        let mut lists = std::mem::take(&mut self.layered);
        let list = &mut lists[self.bundles];
        list.places = [None; Lanes::COUNT];
        self.fill(list, bundle, open);
        self.layered = lists;
        self.bundles += 1;
    }

    /// Ends what was begun last by [`Self::look_at_layers`].
    pub(super) fn forget(&mut self) {
        self.bundles -= 1;
    }

    /// What is known of the surface that a ray of the innermost bundle met.
    pub(super) fn foresee(&self, lane: usize) -> Option<Foreseen> {
        let list = self.bundles.checked_sub(1)?;
        let place = self.layered[list].places.get(lane).copied().flatten()?;
        Some(Foreseen { list, place: usize::from(place) })
    }

    /// The surface.
    pub(super) fn foreseen_surface(&self, Foreseen { list, place }: Foreseen) -> &Intersection {
        &self.layered[list].surfaces[place]
    }

    /// The colour of a layer, counted from the top, if that is known.
    #[inline]
    pub(super) fn foreseen_color(
        &self,
        Foreseen { list, place }: Foreseen,
        layer: usize,
    ) -> Option<Option<Rgbft>> {
        let list = &self.layered[list];
        (layer < list.known).then(|| list.colors[layer].get(place))
    }

    #[inline(never)]
    fn fill<const N: usize>(&self, list: &mut Layered, bundle: &Bundle<N>, open: u32) {
        let world = self.world;
        // Where there are fewer than four, the first stands for the others.
        let (mut texture, mut lanes, mut count) = (None, [0; Lanes::COUNT], 0);
        for (lane, hit) in bundle.hits.iter().enumerate() {
            let Some(hit) = hit.filter(|_| open >> lane & 1 == 1) else { continue };
            let leaf = world.geometry.parts().leaf(hit.leaf);
            let whole = leaf.texture.get().filter(|_| !leaf.flags.contains(LeafFlags::SEVERAL));
            if whole.is_none() || (texture.is_some() && whole != texture) || count == Lanes::COUNT {
                continue;
            }
            if count == 0 {
                (texture, lanes) = (whole, [lane; Lanes::COUNT]);
            }
            lanes[count] = lane;
            count += 1;
        }
        let Some(texture) = texture.filter(|_| count > 1).map(|number| &world.textures[number as usize])
        else {
            return;
        };
        let Some(layers) = texture.layers().filter(|layers| is_worth_while(layers, world.needs.normals))
        else {
            return;
        };
        let [Some(a), Some(b), Some(c), Some(d)] = lanes.map(|lane| bundle.hits[lane]) else { return };
        let hits = [a, b, c, d];
        for (place, surface) in list.surfaces[..count].iter_mut().enumerate() {
            *surface = world.geometry.surface(&bundle.rays[lanes[place]], hits[place]);
        }
        let sample = |place: usize| {
            let surface = &list.surfaces[if place < count { place } else { 0 }];
            textures::sample(world, &bundle.rays[lanes[place]], hits[place], surface)
        };
        let samples = [sample(0), sample(1), sample(2), sample(3)];
        let mut samples = Samples::of(&samples);
        if let Some(way) = texture.placement() {
            samples = samples.moved(way.four(&samples.point));
        }
        list.known = 0;
        for (layer, colors) in layers.iter().rev().zip(&mut list.colors) {
            *colors = match &layer.paint {
                Paint::Even(color) => FourColors::all(Rgbft::new(*color)),
                Paint::Pigment(pigment) => pigment.colors(&samples),
            };
            list.known += 1;
            let covers = |color: Rgbft| color.filter == 0.0 && color.transmit == 0.0;
            // Nobody asks for what is beneath.
            if (0..count).all(|place| colors.get(place).is_some_and(covers)) {
                break;
            }
        }
        for (place, &lane) in lanes[..count].iter().enumerate() {
            list.places[lane] = Some(place as u8);
        }
    }
}

/// Whether there is a pattern, and no bumps where patterns see `normals`.
fn is_worth_while(layers: &[Layer], normals: bool) -> bool {
    let patterned =
        |layer: &Layer| matches!(&layer.paint, Paint::Pigment(pigment) if !pigment.is_soon_known());
    layers.iter().any(patterned) && !(normals && layers.iter().any(|layer| layer.normal.is_some()))
}
