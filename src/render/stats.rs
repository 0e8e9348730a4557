//! What ran while a picture was made: counts that don't depend on threads.

use std::ops::AddAssign;

use crate::math::tally::Tally;

macro_rules! counters {
    ($($(#[$doc:meta])* $name:ident: $label:literal,)*) => {
        /// Counts of a render.
        #[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
        pub struct Statistics {
            $($(#[$doc])* pub $name: u64,)*
        }

        impl Statistics {
            /// Every count with its name, in the order to show them.
            pub fn rows(&self) -> Vec<(&'static str, u64)> {
                vec![$(($label, self.$name)),*]
            }
        }

        impl AddAssign for Statistics {
            fn add_assign(&mut self, other: Self) {
                $(self.$name += other.$name;)*
            }
        }
    };
}

counters! {
    /// Pixels rendered.
    pixels: "pixels",
    /// Samples taken by antialiasing or one for each pixel.
    samples: "samples",
    /// Rays from the camera.
    camera_rays: "camera rays",
    /// Rays from mirrors, total reflection among them.
    reflected_rays: "reflected rays",
    /// Rays bent by a surface.
    refracted_rays: "refracted rays",
    /// Rays that went straight through a surface.
    transmitted_rays: "transmitted rays",
    /// Rays towards lights.
    shadow_rays: "shadow rays",
    /// Rays not traced for their small weight.
    bailed_out: "rays under adc_bailout",
    /// Rays not traced for their depth.
    too_deep: "rays over max_trace_level",
    /// Textures shaded, one for each member of a blend.
    texture_evaluations: "textures shaded",
    /// Textures evaluated only for what they let through to a shadow.
    shadow_textures: "textures in shadows",
    /// Lights skipped because the surface faces away.
    lights_behind: "lights behind surfaces",
    /// Lights skipped because the surface has highlights only, and none there.
    lights_unseen: "lights without a highlight",
    /// Lights skipped because they don't reach the point.
    lights_dark: "lights out of reach",
    /// Lights that needed no shadow ray.
    lights_shadowless: "shadowless lights",
    /// Lights that needed no shadow ray because nothing can be between.
    lights_open: "lights with nothing between",
    /// Stretches of rays through media.
    media_stretches: "stretches through media",
    /// Places where media were asked for their densities.
    media_samples: "samples of media",
    /// Sky lookups.
    sky_evaluations: "sky evaluations",
    /// Boxes held against rays.
    boxes: "boxes tested",
    /// Primitives asked where rays meet them.
    primitives: "primitives tested",
    /// Texture coordinates worked out.
    texture_coordinates: "texture coordinates",
    /// Values of patterns.
    patterns: "patterns evaluated",
    /// Normals bent by bumps.
    bumps: "normals bent",
    /// Values of noise.
    noise: "values of noise",
    /// Values of vector noise.
    vector_noise: "values of vector noise",
    /// Calls of user functions.
    functions: "function calls",
    /// Colours looked up in images.
    image_lookups: "colours from images",
    /// Numbers taken by what is random.
    random_numbers: "random numbers",
    /// Images that some texture in the world refers to; no others are decoded.
    images: "images decoded",
}

impl Statistics {
    /// Adds what the thread counted.
    pub(super) fn add(&mut self, tally: Tally) {
        let Tally {
            boxes,
            primitives,
            noise,
            vector_noise,
            patterns,
            bumps,
            texture_coordinates,
            functions,
            image_lookups,
            random_numbers,
        } = tally;
        self.boxes += boxes;
        self.primitives += primitives;
        self.noise += noise;
        self.vector_noise += vector_noise;
        self.patterns += patterns;
        self.bumps += bumps;
        self.texture_coordinates += texture_coordinates;
        self.functions += functions;
        self.image_lookups += image_lookups;
        self.random_numbers += random_numbers;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_of_threads_add_up() {
        let mut sum = Statistics { camera_rays: 2, ..Statistics::default() };
        sum += Statistics { camera_rays: 3, shadow_rays: 1, ..Statistics::default() };
        assert_eq!((sum.camera_rays, sum.shadow_rays), (5, 1));
        assert!(sum.rows().contains(&("camera rays", 5)));
    }
}
