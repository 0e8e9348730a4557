//! Compiles patterns and warps.

use std::sync::Arc;

use super::Unsupported;
use super::texture::TextureCompiler;
use crate::math::DVec3;
use crate::math::noise::Octaves;
use crate::scene::pattern as from;
use crate::world::pattern as to;
use crate::world::pattern::agate::OwnTurbulence;
use crate::world::pattern::crackle::Metric;
use crate::world::pattern::density_file::Interpolation;
use crate::world::pattern::mandel::Iteration;
use crate::world::pattern::penrose::Penrose;
use crate::world::pattern::tiling::Tiling;
use crate::world::pattern::{Formula, Pattern};
use crate::world::warp::{self, Mapping, Projection, Warps};

impl TextureCompiler<'_> {
    /// A pattern in the space it was written in.
    ///
    /// # Errors
    /// What it uses that povista lacks, or a file that can't be read.
    pub fn pattern(&mut self, field: &from::Field) -> Result<Pattern, Unsupported> {
        Ok(Pattern {
            warps: self.warps(field),
            formula: self.nested(field.span, |this| this.formula(field))?,
            frequency: f64::from(field.frequency),
            phase: f64::from(field.phase),
            wave: wave(field.wave),
        })
    }

    /// The way to a pattern, in the order a point goes: what was written last comes first, the classic
    /// turbulence last (docs/spec/patterns-textures.md 5.1).
    pub(super) fn warps(&self, field: &from::Field) -> Warps {
        let classic = field.turbulence.filter(|turbulence| {
            // These take the turbulence into their formula instead.
            let in_formula = matches!(*field.pattern, from::Pattern::Marble | from::Pattern::Wood);
            !in_formula && turbulence.amount != DVec3::ZERO
        });
        let classic =
            classic.map(|turbulence| warp::Warp::Turbulence(turbulence.amount, octaves(&turbulence)));
        Warps::new(field.warps.iter().rev().filter_map(warp).chain(classic))
    }

    fn formula(&mut self, field: &from::Field) -> Result<Formula, Unsupported> {
        use from::Pattern as From;
        let generator = field.noise_generator.filter(|g| *g != 0).unwrap_or(self.settings.noise_generator);
        // No amount leaves a formula as it is without any turbulence.
        let own = field.turbulence.as_ref().filter(|turbulence| turbulence.amount != DVec3::ZERO);
        let own = own.map(|turbulence| OwnTurbulence {
            amount: turbulence.amount,
            octaves: octaves(turbulence),
            generator,
        });
        self.uses_normals |= matches!(*field.pattern, From::Aoi | From::Slope(_));
        Ok(match &*field.pattern {
            From::Agate { turbulence } => Formula::Agate(to::agate::Agate {
                strength: f64::from(*turbulence),
                octaves: octaves(&field.turbulence.unwrap_or_default()),
                generator,
            }),
            From::Aoi => Formula::Aoi,
            From::Average => Formula::Average,
            From::Boxed => Formula::Boxed,
            From::Bozo | From::Spotted => Formula::Bozo(generator),
            From::Brick { size, mortar } => Formula::Brick(to::brick::Brick::new(*size, *mortar)),
            From::Bumps => Formula::Bumps(generator),
            From::Cells => Formula::Cells,
            From::Checker => Formula::Checker,
            From::Crackle { form, metric, offset, solid } => {
                Formula::Crackle(Box::new(to::crackle::Crackle {
                    form: *form,
                    metric: Metric::new(*metric),
                    offset: *offset,
                    solid: solid.then_some(generator),
                }))
            }
            From::Cubic => Formula::Cubic,
            From::Cylindrical => Formula::Cylindrical,
            From::DensityFile { file, interpolate } => density_file(field, file, *interpolate)?,
            From::Dents => Formula::Dents(generator),
            From::Facets { size, coords, metric } => Formula::Facets(Box::new(to::crackle::Facets {
                size: *size,
                coords: *coords,
                metric: Metric::new(*metric),
            })),
            From::Fractal(fractal) => Formula::Fractal(Box::new(to::mandel::Fractal {
                iteration: match fractal.kind {
                    from::FractalKind::Mandel => Iteration::power(fractal.exponent),
                    from::FractalKind::Magnet1 => Iteration::Magnet1,
                    from::FractalKind::Magnet2 => Iteration::Magnet2,
                },
                julia: fractal.julia,
                iterations: fractal.iterations,
                interior: fractal.interior,
                exterior: fractal.exterior,
            })),
            From::Function(function) => Formula::Function(self.function(function)?),
            From::Gradient(direction) => Formula::Gradient(*direction),
            From::Granite => Formula::Granite(generator),
            From::Hexagon => Formula::Hexagon,
            From::Image(map) => Formula::Image(Box::new(self.image_map(map, false)?)),
            From::Leopard => Formula::Leopard,
            From::Marble => Formula::Marble(to::agate::Marble { turbulence: own }),
            From::Object(object) => Formula::Object(self.inside(field, object)?),
            From::Onion => Formula::Onion,
            From::Pavement(p) => {
                let floor = [p.sides, p.tiles, p.pattern];
                let pavement = to::pavement::Pavement::new(floor, p.exterior, p.interior, p.form);
                let message = "there is no `pavement` with these numbers";
                let pavement = pavement.ok_or_else(|| Unsupported::broken(field.span, message))?;
                Formula::Pavement(Box::new(pavement))
            }
            From::Pigment(pigment) => Formula::Pigment(self.pigment(pigment)?),
            From::Planar => Formula::Planar,
            From::Quilted { control0, control1 } => Formula::Quilted(to::quilted::Quilted {
                control0: f64::from(*control0),
                control1: f64::from(*control1),
            }),
            From::Radial => Formula::Radial,
            From::Ripples => Formula::Ripples(self.ripples(field)),
            From::Slope(slope) => Formula::Slope(Box::new(self::slope(slope))),
            From::Spherical => Formula::Spherical,
            From::Spiral1(arms) => {
                Formula::Spiral1(to::spiral::Spiral { arms: f64::from(*arms), turbulence: own })
            }
            From::Spiral2(arms) => {
                Formula::Spiral2(to::spiral::Spiral { arms: f64::from(*arms), turbulence: own })
            }
            From::Square => Formula::Square,
            From::Tiling(number) => {
                let periodic = Tiling::new(*number).map(Formula::Tiling);
                let message = format!("there is no `tiling {number}`");
                periodic
                    .or_else(|| Penrose::new(*number).map(Formula::Penrose))
                    .ok_or_else(|| Unsupported::broken(field.span, message))?
            }
            From::Triangular => Formula::Triangular,
            From::Waves => Formula::Waves(self.ripples(field)),
            From::Wood => Formula::Wood(to::wood::Wood { turbulence: own }),
            From::Wrinkles => Formula::Wrinkles(generator),
        })
    }

    fn ripples(&mut self, field: &from::Field) -> to::ripples::Ripples {
        to::ripples::Ripples {
            sources: self.wave_sources(),
            frequency: f64::from(field.frequency),
            phase: f64::from(field.phase),
        }
    }
}

fn density_file(
    field: &from::Field,
    file: &Arc<from::DensityFile>,
    interpolate: u32,
) -> Result<Formula, Unsupported> {
    let bytes = file.size.iter().try_fold(file.width, |product, side| product.checked_mul(*side));
    if file.voxels.is_empty() || bytes != Some(file.voxels.len()) || !matches!(file.width, 1 | 2 | 4) {
        return Err(Unsupported::broken(field.span, format!("`{}` has no voxels to show", file.name)));
    }
    Ok(Formula::DensityFile(Box::new(to::density_file::DensityFile {
        size: file.size,
        width: file.width,
        voxels: file.voxels.as_slice().into(),
        interpolation: match interpolate % 10 {
            0 => Interpolation::Nearest,
            1 => Interpolation::Trilinear,
            _ => Interpolation::Tricubic,
        },
    })))
}

fn octaves(turbulence: &from::Turbulence) -> Octaves {
    Octaves {
        count: turbulence.octaves.clamp(1, 10),
        omega: f64::from(turbulence.omega),
        lambda: f64::from(turbulence.lambda),
    }
}

fn wave(wave: from::Wave) -> to::Wave {
    match wave {
        from::Wave::Ramp => to::Wave::Ramp,
        from::Wave::Triangle => to::Wave::Triangle,
        from::Wave::Sine => to::Wave::Sine,
        from::Wave::Scallop => to::Wave::Scallop,
        from::Wave::Cubic => to::Wave::Cubic,
        from::Wave::Poly(exponent) => to::Wave::Poly(f64::from(exponent)),
    }
}

fn warp(warp: &from::Warp) -> Option<warp::Warp> {
    let mapping = |projection, orientation: &DVec3, dist_exp: f64| {
        Some(warp::Warp::Mapping(Box::new(Mapping { projection, orientation: *orientation, dist_exp })))
    };
    match warp {
        from::Warp::Transform(transform) => {
            (!transform.is_identity()).then(|| warp::Warp::Transform(Box::new(**transform)))
        }
        from::Warp::Turbulence(turbulence) => (turbulence.amount != DVec3::ZERO)
            .then(|| warp::Warp::Turbulence(turbulence.amount, octaves(turbulence))),
        from::Warp::Repeat { width, offset, flip } => {
            Some(warp::Warp::Repeat(Box::new(warp::Repeat::new(*width, *offset, *flip))))
        }
        from::Warp::BlackHole(hole) => {
            (hole.kind == 0).then(|| warp::Warp::BlackHole(Box::new(black_hole(hole))))
        }
        from::Warp::Spherical { orientation, dist_exp } => {
            mapping(Projection::Spherical, orientation, *dist_exp)
        }
        from::Warp::Cylindrical { orientation, dist_exp } => {
            mapping(Projection::Cylindrical, orientation, *dist_exp)
        }
        from::Warp::Toroidal { orientation, dist_exp, major_radius } => {
            mapping(Projection::Toroidal(*major_radius), orientation, *dist_exp)
        }
        from::Warp::Planar { orientation, distance } => {
            mapping(Projection::Planar(*distance), orientation, 0.0)
        }
        from::Warp::Cubic => Some(warp::Warp::Cubic),
    }
}

/// A repeated hole must fit into its block: the middle is raised to the radius, the block enlarged
/// (docs/spec/patterns-textures.md 5.2).
fn black_hole(hole: &from::BlackHole) -> warp::BlackHole {
    let (mut center, mut repeat) = (hole.center, hole.repeat);
    if let Some(size) = &mut repeat {
        for k in (0..3).filter(|&k| hole.repeat.is_some_and(|size| size[k] > 0.0)) {
            center[k] = center[k].max(hole.radius);
            size[k] = size[k].max(center[k] + hole.radius + hole.turbulence[k]);
        }
    }
    warp::BlackHole {
        center,
        radius: hole.radius,
        strength: hole.strength,
        falloff: hole.falloff,
        inverse: hole.inverse,
        repeat,
        turbulence: hole.turbulence,
    }
}

fn slope(slope: &from::Slope) -> to::slope::Slope {
    let (altitude, altitude_range) = slope.altitude.unwrap_or((DVec3::ZERO, [0.0; 2]));
    let (long, high) = (slope.direction.length(), altitude.length());
    // In single precision, as POV-Ray does: which of two formulas serves depends on the rounding.
    let share = if slope.point_at { 1.0 } else { long / f64::from((long + high) as f32) };
    to::slope::Slope {
        target: match slope.point_at {
            true => to::slope::Target::Point(slope.direction),
            false => to::slope::Target::Direction(slope.direction.normalize_or_zero()),
        },
        range: slope.range,
        weights: [share, 1.0 - share],
        altitude: (altitude.normalize_or_zero(), altitude_range),
    }
}
