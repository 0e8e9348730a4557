//! What most rays meet: a surface of one opaque layer that has no bumps and wears no film. Its colour is what
//! [`Tracer::shade`] would make of it, on a shorter way.

use super::finish::Surface;
use super::shadow::Target;
use super::textures;
use super::trace::{Path, Tracer};
use crate::math::Rgb;
use crate::world::hit::Hit;
use crate::world::light::is_dark;
use crate::world::object::{Leaf, LeafFlags};
use crate::world::texture::{Finish, Layer, Pigment};

impl<'w> Tracer<'w> {
    /// The layer of a leaf that is that simple; its colour may still be transparent.
    #[inline]
    fn plain_layer(&self, leaf: &Leaf) -> Option<&'w Layer> {
        let world: &'w _ = self.world;
        let one = leaf.interior_texture.get().is_none() && leaf.own_textures.is_empty();
        let plain = self.plain && one && leaf.flags.contains(LeafFlags::OPAQUE);
        let number = leaf.texture.get().filter(|_| plain)?;
        match world.textures[number as usize].layers_in_place() {
            Some([layer]) if layer.normal.is_none() => Some(layer),
            _ => None,
        }
    }

    /// The colour of the surface that a ray met, if it is that simple.
    #[inline]
    pub(super) fn plain(&mut self, path: &Path, hit: &Hit) -> Option<Rgb> {
        let world = self.world;
        let leaf = world.geometry.parts().leaf(hit.leaf);
        let layer = self.plain_layer(leaf)?;
        let finish: &Finish = &layer.finish;
        if finish.irid.is_some() || finish.crand != 0.0 {
            return None;
        }
        let surface = world.geometry.surface(&path.ray, hit);
        let color = match &*layer.pigment {
            Pigment::Color(color) => *color,
            pigment => pigment.color(&textures::sample(world, &path.ray, hit, &surface))?,
        };
        if color.filter != 0.0 || color.transmit != 0.0 {
            return None;
        }
        self.statistics.texture_evaluations += 1;
        let own = finish.ambient * world.settings.ambient_light + finish.emission;
        let lit = Surface {
            finish,
            color: color.rgb,
            opacity: 1.0,
            normal: &surface.normal,
            direction: &path.ray.direction,
        };
        let mut direct = Rgb::ZERO;
        if finish.diffuse > 0.0 || finish.diffuse_back > 0.0 || finish.specular > 0.0 || finish.phong > 0.0 {
            let at = Target { surface: &surface, hit: Some(hit), inside: &path.inside, among: None };
            for &number in &world.light_sets[leaf.lights as usize] {
                direct += self.plain_light(&at, leaf, &lit, number);
            }
        }
        let seen = color.rgb * own + direct;
        if finish.reflection.is_none() {
            return Some(seen);
        }
        Some(seen + self.mirrored_by(path, hit, &surface, finish, color.rgb))
    }

    /// The light that a lamp makes a layer send to the eye.
    #[inline]
    fn plain_light(&mut self, at: &Target, leaf: &Leaf, lit: &Surface, number: u32) -> Rgb {
        let light = &self.world.lights[number as usize];
        let incident = light.reaching(at.surface.point);
        if incident.is_dark() {
            self.statistics.lights_dark += 1;
            return Rgb::ZERO;
        }
        let facing = lit.faces(leaf, &incident.direction);
        if !facing && lit.finish.diffuse_back <= 0.0 {
            self.statistics.lights_behind += 1;
            return Rgb::ZERO;
        }
        if !lit.answers(&incident.direction, !facing) {
            self.statistics.lights_unseen += 1;
            return Rgb::ZERO;
        }
        let color = self.arriving(at, number, &incident);
        if is_dark(color) {
            return Rgb::ZERO;
        }
        self.answer(lit, &incident.direction, color, !facing, light.shadowless)
    }
}
