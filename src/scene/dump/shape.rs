//! Shapes.

use super::block::Block;
use super::value::{list, number, switch, transform, vec2, vec3, vec4};
use super::{function, pattern, texture};
use crate::scene::Shape;
use crate::scene::shape::*;

pub(super) fn dump(shape: &Shape) -> Block {
    match shape {
        Shape::Sphere { center, radius } => {
            Block::new("sphere").line(format!("{}, {}", vec3(*center), number(*radius)))
        }
        Shape::Box { min, max } => Block::new("box").line(format!("{}, {}", vec3(*min), vec3(*max))),
        Shape::Cylinder(c) => Block::new("cylinder")
            .line(format!("{}, {}, {}", vec3(c.base), vec3(c.cap), number(c.base_radius)))
            .flag("open", c.open),
        Shape::Cone(c) => Block::new("cone")
            .line(format!("{}, {}", vec3(c.base), number(c.base_radius)))
            .line(format!("{}, {}", vec3(c.cap), number(c.cap_radius)))
            .flag("open", c.open),
        Shape::Torus { major, minor } => {
            Block::new("torus").line(format!("{}, {}", number(*major), number(*minor)))
        }
        Shape::Plane { normal, distance } => {
            Block::new("plane").line(format!("{}, {}", vec3(*normal), number(*distance)))
        }
        Shape::Disc(d) => Block::new("disc").line(format!(
            "{}, {}, {}, {}",
            vec3(d.center),
            vec3(d.normal),
            number(d.radius),
            number(d.hole)
        )),
        Shape::Triangle(t) => triangle(t),
        Shape::Polygon(points) => {
            Block::new("polygon").line(format!("{}, {}", points.len(), list(points.iter().map(|&p| vec3(p)))))
        }
        Shape::Quadric(q) => Block::new("quadric").line(format!(
            "{}, {}, {}, {}",
            vec3(q.squares),
            vec3(q.products),
            vec3(q.linear),
            number(q.constant)
        )),
        Shape::Poly(p) => Block::new("poly").line(format!(
            "{}, <{}>",
            p.order,
            list(p.coefficients.iter().map(|&c| number(c)))
        )),
        Shape::BicubicPatch(p) => bicubic_patch(p),
        Shape::Blob(b) => blob(b),
        Shape::HeightField(h) => Block::new("height_field")
            .block(pattern::image_source(&h.image))
            .field("water_level", number(h.water_level))
            .field("smooth", switch(h.smooth)),
        Shape::Isosurface(i) => isosurface(i),
        Shape::JuliaFractal(j) => julia_fractal(j),
        Shape::Lathe(l) => Block::new("lathe").line(contour(l.spline)).line(points(&l.points)),
        Shape::Prism(p) => Block::new("prism")
            .line(if p.conic { "conic_sweep" } else { "linear_sweep" })
            .line(contour(p.spline))
            .line(format!("{}, {}, {}", number(p.heights[0]), number(p.heights[1]), points(&p.points)))
            .flag("open", p.open),
        Shape::Sor(s) => Block::new("sor").line(points(&s.points)).flag("open", s.open),
        Shape::SphereSweep(s) => sphere_sweep(s),
        Shape::Superellipsoid { east, north } => {
            Block::new("superellipsoid").line(format!("<{}, {}>", number(*east), number(*north)))
        }
        Shape::Ovus { bottom, top } => {
            Block::new("ovus").line(format!("{}, {}", number(*bottom), number(*top)))
        }
        Shape::Text(t) => text(t),
        Shape::Mesh(m) => mesh(m),
        Shape::Parametric(p) => parametric(p),
        Shape::Csg(_) | Shape::Light(_) | Shape::LightGroup(_) => Block::new("object"),
    }
}

fn triangle(t: &Triangle) -> Block {
    let [a, b, c] = t.corners.map(vec3);
    match t.normals {
        None => Block::new("triangle").line(format!("{a}, {b}, {c}")),
        Some(normals) => {
            let [k, l, m] = normals.map(vec3);
            Block::new("smooth_triangle").line(format!("{a}, {k}, {b}, {l}, {c}, {m}"))
        }
    }
}

fn bicubic_patch(p: &BicubicPatch) -> Block {
    Block::new("bicubic_patch")
        .field("type", p.kind)
        .field("flatness", number(p.flatness))
        .field("u_steps", p.steps[0])
        .field("v_steps", p.steps[1])
        .field("accuracy", number(p.accuracy))
        .optional("uv_vectors", p.uv.map(|uv| uv.map(vec2).join(", ")))
        .line(list(p.points.iter().map(|&p| vec3(p))))
}

fn blob(b: &Blob) -> Block {
    Block::new("blob").field("threshold", number(b.threshold)).blocks(b.components.iter().map(|c| {
        let block = match c.kind {
            BlobKind::Sphere { center, radius } => {
                Block::new("sphere").line(format!("{}, {}", vec3(center), number(radius)))
            }
            BlobKind::Cylinder { base, cap, radius } => {
                Block::new("cylinder").line(format!("{}, {}, {}", vec3(base), vec3(cap), number(radius)))
            }
        };
        let block = block.field("strength", number(c.strength));
        let block = match &c.transform {
            Some(by) => block.line(transform(by)),
            None => block,
        };
        block.blocks(c.texture.as_ref().map(|surface| texture::dump("texture", surface)))
    }))
}

fn container(container: &Container) -> Block {
    Block::new("contained_by").block(match *container {
        Container::Box { min, max } => Block::new("box").line(format!("{}, {}", vec3(min), vec3(max))),
        Container::Sphere { center, radius } => {
            Block::new("sphere").line(format!("{}, {}", vec3(center), number(radius)))
        }
    })
}

fn isosurface(i: &Isosurface) -> Block {
    let block = Block::new("isosurface")
        .block(function::dump(&i.function))
        .block(container(&i.container))
        .field("threshold", number(i.threshold))
        .field("accuracy", number(i.accuracy))
        .field("max_gradient", number(i.max_gradient))
        .optional("evaluate", i.evaluate.map(|e| e.map(number).join(", ")));
    match i.max_trace {
        Some(count) => block.field("max_trace", count),
        None => block.line("all_intersections"),
    }
    .flag("open", i.open)
}

fn julia_fractal(j: &JuliaFractal) -> Block {
    let function = match j.function {
        JuliaFunction::Pwr(re, im) => format!("pwr({}, {})", number(re), number(im)),
        other => format!("{other:?}").to_lowercase(),
    };
    Block::new("julia_fractal")
        .line(vec4(j.parameter))
        .line(if j.hypercomplex { "hypercomplex" } else { "quaternion" })
        .line(function)
        .field("max_iteration", j.max_iteration)
        .field("precision", number(j.precision))
        .line(format!("slice {}, {}", vec4(j.slice.0), number(j.slice.1)))
}

fn contour(spline: ContourSpline) -> &'static str {
    match spline {
        ContourSpline::Linear => "linear_spline",
        ContourSpline::Quadratic => "quadratic_spline",
        ContourSpline::Cubic => "cubic_spline",
        ContourSpline::Bezier => "bezier_spline",
    }
}

fn points(points: &[crate::math::DVec2]) -> String {
    format!("{}, {}", points.len(), list(points.iter().map(|&p| vec2(p))))
}

fn sphere_sweep(s: &SphereSweep) -> Block {
    let spline = match s.spline {
        SweepSpline::Linear => "linear_spline",
        SweepSpline::Cubic => "cubic_spline",
        SweepSpline::BSpline => "b_spline",
    };
    let spheres =
        list(s.spheres.iter().map(|(center, radius)| format!("{}, {}", vec3(*center), number(*radius))));
    Block::new("sphere_sweep")
        .line(spline)
        .line(format!("{}, {spheres}", s.spheres.len()))
        .field("tolerance", number(s.tolerance))
}

fn text(t: &Text) -> Block {
    let font = match &t.font {
        Font::File(name, _) => format!("ttf {name:?}"),
        Font::Internal(number, _) => format!("internal {number}"),
    };
    Block::new("text").line(font).line(format!("{:?}", String::from_utf16_lossy(&t.text))).line(format!(
        "{}, {}",
        number(t.thickness),
        vec3(t.offset)
    ))
}

fn mesh(m: &Mesh) -> Block {
    let block =
        |word: &str, count: usize, entries: String| Block::new(word).line(format!("{count}, {entries}"));
    let index = |[a, b, c]: [u32; 3]| format!("<{a}, {b}, {c}>");
    let mut mesh = Block::new("mesh2").block(block(
        "vertex_vectors",
        m.vertices.len(),
        list(m.vertices.iter().map(|&v| vec3(v))),
    ));
    if !m.normals.is_empty() {
        mesh = mesh.block(block("normal_vectors", m.normals.len(), list(m.normals.iter().map(|&v| vec3(v)))));
    }
    if !m.uvs.is_empty() {
        mesh = mesh.block(block("uv_vectors", m.uvs.len(), list(m.uvs.iter().map(|&v| vec2(v)))));
    }
    if !m.textures.is_empty() {
        mesh = mesh
            .block(Block::new("texture_list").blocks(m.textures.iter().map(|t| texture::dump("texture", t))));
    }
    let faces = list(m.faces.iter().map(|face| {
        let mut text = index(face.vertices);
        for (word, indices) in [("normals", face.normals), ("uvs", face.uvs)] {
            if let Some(indices) = indices {
                text.push_str(&format!(" {word} {}", index(indices)));
            }
        }
        match face.textures {
            FaceTextures::Inherited => {}
            FaceTextures::One(texture) => text.push_str(&format!(" texture {texture}")),
            FaceTextures::Three(textures) => text.push_str(&format!(" textures {}", index(textures))),
        }
        text
    }));
    mesh.block(block("face_indices", m.faces.len(), faces))
        .optional("inside_vector", m.inside_vector.map(vec3))
}

fn parametric(p: &Parametric) -> Block {
    let precompute = p.precompute.map(|(depth, axes)| {
        let names: Vec<_> =
            ["x", "y", "z"].into_iter().zip(axes).filter(|(_, on)| *on).map(|(name, _)| name).collect();
        format!("{depth}, {}", names.join(", "))
    });
    Block::new("parametric")
        .blocks(p.functions.iter().map(|f| function::dump(f)))
        .line(format!("{}, {}", vec2(p.from), vec2(p.to)))
        .block(container(&p.container))
        .field("accuracy", number(p.accuracy))
        .field("max_gradient", number(p.max_gradient))
        .optional("precompute", precompute)
}
