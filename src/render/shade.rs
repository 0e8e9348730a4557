//! The colour of a surface: layers, what shines through, what is mirrored
//! (docs/spec/shading.md 6, 7, 10 and 14).

use std::ops::Range as Span;

use super::dispersion::{self, Band};
use super::finish::{Surface, iridescence};
use super::layered::Foreseen;
use super::mirror::{self, Reflectivity};
use super::refract::{self, Inside, Passage};
use super::shadow::Target;
use super::textures;
use super::trace::{Path, Seen, Tracer};
use crate::math::color::grey;
use crate::math::{DVec3, Rgb, Rgbft};
use crate::world::hit::Hit;
use crate::world::object::{Leaf, LeafFlags};
use crate::world::sample::Sample;
use crate::world::texture::{Finish, Irid, Layer};
use crate::world::{Intersection, Ray, RayKind};

/// A surface being shaded.
#[derive(Debug)]
pub(super) struct At<'a> {
    /// The ray that met it.
    pub(super) path: &'a Path,
    /// How.
    pub(super) hit: &'a Hit,
    /// Where.
    pub(super) surface: &'a Intersection,
    /// What.
    pub(super) leaf: &'a Leaf,
    /// What the filling takes of light that came through it to the surface.
    attenuation: Rgb,
    /// What happens to light that goes through; `None` until something does.
    passage: Option<Passage>,
    /// Whether one layer of one texture is all there is to be lit.
    pub(super) plain: bool,
    /// What is known of it already.
    foreseen: Option<Foreseen>,
    /// The lamps' light, by index into the tracer's list; `None` until a layer asks.
    pub(super) arrivals: Option<Span<usize>>,
}

impl At<'_> {
    /// What lamps shine on.
    pub(super) fn target(&self) -> Target<'_> {
        Target { surface: self.surface, hit: Some(self.hit), inside: &self.path.inside, among: None }
    }
}

/// What a ray sees of a surface, and where it goes on straight.
#[derive(Debug)]
pub(super) struct Shaded {
    /// Light from the surface, mirrors and bent rays.
    pub(super) color: Rgb,
    /// Transparency behind bent rays.
    pub(super) transmit: f32,
    /// The straight way on.
    pub(super) onward: Option<Onward>,
}

/// The straight continuation of a ray.
#[derive(Debug)]
pub(super) struct Onward {
    pub(super) ray: Ray,
    pub(super) weight: f32,
    pub(super) inside: Inside,
    /// What the surface leaves of the light behind it.
    pub(super) left: Rgb,
    /// What it leaves of the transparency behind it.
    pub(super) clear: f32,
}

/// The reflection of a layer, traced after all layers.
#[derive(Clone, Debug)]
pub(super) struct Mirror {
    normal: DVec3,
    share: Rgb,
    weight: f32,
    exponent: f32,
    irid: Option<Irid>,
}

impl Mirror {
    /// What a layer mirrors that ways of this weight come to, where it reflects.
    fn of(finish: &Finish, reflectivity: Option<Reflectivity>, normal: DVec3, weight: f32) -> Option<Self> {
        let (Some(reflection), Some(reflectivity)) = (&finish.reflection, reflectivity) else { return None };
        Some(Self {
            normal,
            share: reflectivity.color,
            weight: weight * reflectivity.weight,
            exponent: reflection.exponent.recip(),
            irid: finish.irid,
        })
    }
}

/// What shines through the members of a blend.
#[derive(Default)]
struct Sum {
    color: Rgb,
    transmit: f32,
    left: Rgb,
    clear: f32,
    weight: f32,
}

/// Light about to be bent.
struct Bent {
    /// The top layer's normal.
    normal: DVec3,
    /// The top layer's film.
    irid: Option<Irid>,
    weight: f32,
    /// What the surface leaves of light and transparency behind it.
    left: Rgb,
    clear: f32,
}

/// The layers of one plain texture, from the top down.
struct Stack {
    color: Rgb,
    /// What the layers so far let through.
    through: Rgb,
    /// Its grey.
    share: f32,
    /// The topmost layer's normal.
    top: Option<DVec3>,
}

impl Tracer<'_> {
    /// Shades the surface a ray met, of which something may be `foreseen`.
    pub(super) fn shade(&mut self, path: &Path, hit: &Hit, foreseen: Option<Foreseen>) -> Shaded {
        let world = self.world;
        let surface = match foreseen {
            Some(foreseen) => *self.foreseen_surface(foreseen),
            None => world.geometry.surface(&path.ray, hit),
        };
        let leaf = world.geometry.parts().leaf(hit.leaf);
        let attenuation = self.attenuation(path, hit, leaf);
        if leaf.flags.contains(LeafFlags::INVISIBLE) && self.quality.transmission && !self.quality.flat {
            let passage = path.inside.pass(leaf.interior, &world.interiors);
            if passage.is_straight() {
                let onward = Onward {
                    ray: Ray::new(surface.leave(path.ray.direction), path.ray.direction),
                    weight: path.weight,
                    inside: passage.inside,
                    left: attenuation,
                    clear: grey(attenuation),
                };
                return Shaded { color: Rgb::ZERO, transmit: 0.0, onward: Some(onward) };
            }
        }
        let surface = &surface;
        let mut at = At {
            path,
            hit,
            surface,
            leaf,
            attenuation,
            passage: None,
            plain: false,
            foreseen,
            arrivals: None,
        };
        let mut sum = Sum::default();
        if let Some(layers) = textures::layers(world, leaf, surface) {
            self.statistics.texture_evaluations += 1;
            // What looks the same everywhere need not know where it is.
            let mut sample = match layers.iter().all(Layer::is_even) {
                true => Sample::at(DVec3::ZERO),
                false => textures::sample(world, &path.ray, hit, surface),
            };
            self.texture(&mut at, 1.0, layers, &mut sample, &mut sum);
        } else {
            textures::resolve(world, &path.ray, hit, surface, &mut |weight, layers, sample| {
                self.statistics.texture_evaluations += 1;
                self.texture(&mut at, weight, layers, sample, &mut sum);
            });
        }
        if let Some(arrivals) = at.arrivals {
            self.arrivals.truncate(arrivals.start);
        }
        let onward = at.passage.filter(|_| sum.weight > 0.0).map(|passage| Onward {
            ray: Ray::new(surface.leave(path.ray.direction), path.ray.direction),
            weight: sum.weight,
            inside: passage.inside,
            left: sum.left,
            clear: sum.clear,
        });
        Shaded { color: sum.color, transmit: sum.transmit, onward }
    }

    /// What the filling of a leaf takes of light that came through it to a hit.
    #[inline]
    pub(super) fn attenuation(&self, path: &Path, hit: &Hit, leaf: &Leaf) -> Rgb {
        let interior = &self.world.interiors[leaf.interior as usize];
        let fade = interior.fade.as_ref().filter(|_| path.inside.contains(leaf.interior));
        fade.map_or(Rgb::ONE, |fade| fade.attenuation(hit.t)) * interior.refraction
    }

    /// Shades one plain texture, a member of a blend with the share `blend`.
    fn texture(&mut self, at: &mut At, blend: f32, layers: &[Layer], sample: &mut Sample, sum: &mut Sum) {
        at.plain = blend == 1.0 && layers.len() == 1;
        let bailout = self.world.settings.adc_bailout;
        let mut stack = Stack { color: Rgb::ZERO, through: Rgb::ONE, share: 1.0, top: None };
        let first_mirror = self.mirrors.len();
        // Most textures have one layer, the mirror of which need not be kept for later.
        let mut mirror = None;
        if let [only] = layers {
            if bailout < 1.0 {
                let known = at.foreseen.and_then(|foreseen| self.foreseen_color(foreseen, 0));
                mirror = self.layer(at, only, known, sample, &mut stack);
            }
        } else {
            for (place, layer) in layers.iter().rev().enumerate() {
                if stack.share <= bailout {
                    break;
                }
                let known = at.foreseen.and_then(|foreseen| self.foreseen_color(foreseen, place));
                let mirror = self.layer(at, layer, known, sample, &mut stack);
                self.mirrors.extend(mirror);
            }
        }
        let mut suppressed = None;
        if self.quality.transmission && stack.share > bailout {
            let irid = layers.last().and_then(|layer| layer.finish.irid);
            suppressed = self.behind(at, blend, &stack, irid, sum);
        }
        sum.color += blend * stack.color;
        let seen = |mirror: &Mirror| suppressed.is_none_or(|top| !mirror.normal.abs_diff_eq(top, 1e-10));
        if let Some(mirror) = mirror.as_ref().filter(|mirror| seen(mirror)) {
            sum.color += blend * self.reflection(at, mirror);
        }
        for index in first_mirror..self.mirrors.len() {
            let mirror = self.mirrors[index].clone();
            if seen(&mirror) {
                sum.color += blend * self.reflection(at, &mirror);
            }
        }
        self.mirrors.truncate(first_mirror);
    }

    /// Adds the light of a layer, the colour of which may be `known`, to those above it; what it mirrors is left to be
    /// traced.
    fn layer(
        &mut self,
        at: &mut At,
        layer: &Layer,
        known: Option<Option<Rgbft>>,
        sample: &mut Sample,
        stack: &mut Stack,
    ) -> Option<Mirror> {
        let finish: &Finish = &layer.finish;
        let bent;
        let normal = match &layer.normal {
            Some(_) if self.quality.reflection => {
                bent = layer.bend(sample);
                &bent
            }
            _ => &at.surface.normal,
        };
        if stack.top.is_none() {
            stack.top = Some(*normal);
        }
        let given = known.unwrap_or_else(|| layer.paint.color(sample));
        let color = given.unwrap_or(Rgbft::new([1.0, 1.0, 1.0, 0.0, 1.0]));
        if self.quality.flat {
            // The lowest layer that is looked at shows its plain colour.
            stack.color = color.rgb;
        } else {
            let opacity = self.opacity(&color);
            let own = finish.ambient * self.world.settings.ambient_light + finish.emission;
            let direction = &at.path.ray.direction;
            let surface = Surface { finish, color: color.rgb, opacity, normal, direction };
            let direct = self.direct(at, &surface);
            stack.color += stack.through * (color.rgb * own * opacity + direct);
        }
        let reflectivity = self.reflectivity(at.path, at.leaf, finish, normal, color.rgb);
        let mirror = Mirror::of(finish, reflectivity, *normal, at.path.weight * stack.share);
        if given.is_some() {
            stack.through *= color.through();
        }
        if let Some(reflectivity) = reflectivity.filter(|_| finish.conserve_energy && given.is_some()) {
            stack.through *= (Rgb::ONE - reflectivity.color).min(Rgb::ONE);
        }
        stack.share = grey(stack.through).abs().min(1.0);
        mirror
    }

    /// How much of its own light a layer shows (docs/spec/shading.md 7).
    #[inline]
    pub(super) fn opacity(&self, color: &Rgbft) -> f32 {
        if self.world.settings.version >= 370 {
            color.opacity()
        } else {
            1.0 - (color.filter * color.rgb.max_element() + color.transmit)
        }
    }

    /// How much of what it sees a finish of a leaf mirrors, where it does.
    #[inline]
    pub(super) fn reflectivity(
        &self,
        path: &Path,
        leaf: &Leaf,
        finish: &Finish,
        normal: &DVec3,
        color: Rgb,
    ) -> Option<Reflectivity> {
        let reflection = finish.reflection.as_ref().filter(|_| self.quality.reflection)?;
        let index = if reflection.fresnel {
            path.inside.fresnel_index(leaf.interior, &self.world.interiors)
        } else {
            1.0
        };
        let cosine = -path.ray.direction.dot(*normal);
        Some(mirror::reflectivity(reflection, cosine, index, color))
    }

    /// Adds what is seen through a texture; straight ways are only noted, for one ray serves all
    /// members of a blend. The top layer's normal comes back where light is totally reflected.
    fn behind(
        &mut self,
        at: &mut At,
        blend: f32,
        stack: &Stack,
        irid: Option<Irid>,
        sum: &mut Sum,
    ) -> Option<DVec3> {
        let world = self.world;
        let passage =
            at.passage.get_or_insert_with(|| at.path.inside.pass(at.leaf.interior, &world.interiors));
        let weight = at.path.weight * stack.through.abs().max_element();
        let left = at.attenuation * stack.through * blend;
        let clear = grey(at.attenuation) * stack.share * blend;
        if passage.is_straight() {
            sum.left += left;
            sum.clear += clear;
            sum.weight = sum.weight.max(weight);
            return None;
        }
        let normal = stack.top.unwrap_or(at.surface.normal);
        let Passage { ratio, dispersion, .. } = *passage;
        let bent = Bent { normal, irid, weight, left, clear };
        match at.path.wavelength {
            _ if dispersion == 1.0 => self.bend(at, blend, &bent, ratio, sum),
            Some(wavelength) => {
                self.bend(at, blend, &bent, dispersion::ratio(ratio, dispersion, wavelength), sum)
            }
            None => {
                self.disperse(at, &bent, (ratio, dispersion), sum);
                None
            }
        }
    }

    /// Follows light of one colour through a bending surface.
    fn bend(&mut self, at: &At, blend: f32, bent: &Bent, ratio: f64, sum: &mut Sum) -> Option<DVec3> {
        match self.refracted(at, bent, ratio, at.path.wavelength) {
            Some(seen) => {
                sum.color += bent.left * seen.color;
                sum.transmit += bent.clear * seen.transmit;
                None
            }
            None => {
                let seen = self.totally_reflected(at, bent, at.path.wavelength);
                sum.color += blend * at.attenuation * seen.color;
                Some(bent.normal)
            }
        }
    }

    /// Follows white light, split into the colours that the interior asks for.
    fn disperse(&mut self, at: &At, bent: &Bent, (ratio, dispersion): (f64, f64), sum: &mut Sum) {
        let interiors = &self.world.interiors;
        let own = &interiors[at.leaf.interior as usize];
        let around = at.passage.as_ref().and_then(|passage| passage.inside.last());
        let beyond = around.map_or(0, |number| interiors[number as usize].dispersion_samples);
        for Band { wavelength, share } in dispersion::bands(own.dispersion_samples.max(beyond)) {
            let ratio = dispersion::ratio(ratio, dispersion, wavelength);
            let seen = self
                .refracted(at, bent, ratio, Some(wavelength))
                .unwrap_or_else(|| self.totally_reflected(at, bent, Some(wavelength)));
            sum.color += bent.left * share * seen.color;
            sum.transmit += bent.clear * grey(share) * seen.transmit;
        }
    }

    /// What is seen through a bending surface; `None` beyond the critical angle.
    fn refracted(&mut self, at: &At, bent: &Bent, ratio: f64, wavelength: Option<f64>) -> Option<Seen> {
        let direction = refract::refracted(at.path.ray.direction, bent.normal, ratio)?;
        self.statistics.refracted_rays += 1;
        Some(self.trace(&mut Path {
            ray: Ray::new(at.surface.leave(direction), direction),
            level: at.path.level,
            weight: bent.weight,
            kind: at.path.kind,
            wavelength,
            inside: at.passage.as_ref().map(|passage| passage.inside.clone()).unwrap_or_default(),
        }))
    }

    fn totally_reflected(&mut self, at: &At, bent: &Bent, wavelength: Option<f64>) -> Seen {
        let direction = mirror::mirrored(at.path.ray.direction, bent.normal, at.surface.normal);
        let mut seen = self.mirrored((at.path, at.surface), direction, bent.weight, wavelength);
        seen.color *= self.film(at, bent.irid.as_ref(), bent.normal, direction);
        seen
    }

    /// What a surface mirrors of which an opaque layer without bumps and film is all.
    pub(super) fn mirrored_by(
        &mut self,
        path: &Path,
        hit: &Hit,
        surface: &Intersection,
        finish: &Finish,
        color: Rgb,
    ) -> Rgb {
        let leaf = self.world.geometry.parts().leaf(hit.leaf);
        let attenuation = Rgb::ONE;
        let at = At {
            path,
            hit,
            surface,
            leaf,
            attenuation,
            passage: None,
            plain: true,
            foreseen: None,
            arrivals: None,
        };
        let reflectivity = self.reflectivity(path, leaf, finish, &surface.normal, color);
        let mirror = Mirror::of(finish, reflectivity, surface.normal, path.weight);
        mirror.map_or(Rgb::ZERO, |mirror| self.reflection(&at, &mirror))
    }

    /// What a layer mirrors.
    fn reflection(&mut self, at: &At, mirror: &Mirror) -> Rgb {
        if mirror.share == Rgb::ZERO {
            return Rgb::ZERO;
        }
        let direction = mirror::mirrored(at.path.ray.direction, mirror.normal, at.surface.normal);
        let mut color =
            self.mirrored((at.path, at.surface), direction, mirror.weight, at.path.wavelength).color;
        color *= self.film(at, mirror.irid.as_ref(), mirror.normal, direction);
        if mirror.exponent != 1.0 {
            color = color.powf(mirror.exponent);
        }
        mirror.share * color
    }

    /// What a film leaves of the light mirrored from a direction.
    fn film(&self, at: &At, irid: Option<&Irid>, normal: DVec3, direction: DVec3) -> Rgb {
        let settings = &self.world.settings;
        irid.map_or(Rgb::ONE, |irid| {
            iridescence(
                irid,
                settings.irid_wavelength,
                at.surface.point,
                normal,
                direction,
                at.path.ray.direction,
                settings.noise_generator,
            )
        })
    }

    /// What is seen from a surface that a path met, in a direction to which it mirrors.
    pub(super) fn mirrored(
        &mut self,
        (path, surface): (&Path, &Intersection),
        direction: DVec3,
        weight: f32,
        wavelength: Option<f64>,
    ) -> Seen {
        if weight < self.world.settings.adc_bailout {
            self.statistics.bailed_out += 1;
            return Seen::NOTHING;
        }
        self.statistics.reflected_rays += 1;
        self.trace(&mut Path {
            ray: Ray::new(surface.leave(direction), direction),
            level: path.level,
            weight,
            kind: RayKind::REFLECTION,
            wavelength,
            inside: path.inside.clone(),
        })
    }
}
