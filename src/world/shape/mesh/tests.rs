use super::super::battery::{self, battery, table};
use super::*;
use crate::math::Lanes;
use crate::world::shape::battery::Dice;

/// A mesh of flat triangles.
fn flat(vertices: &[[f64; 3]], faces: &[[u32; 3]], inside: Option<DVec3>) -> Mesh {
    let lists = Lists { vertices: vertices.iter().map(|v| DVec3::from(*v)).collect(), ..Lists::default() };
    let faces: Vec<_> = faces.iter().map(|v| face(*v)).collect();
    Mesh::new(lists, &faces, inside).unwrap()
}

fn face(vertices: [u32; 3]) -> Face {
    Face { vertices, normals: None, uvs: None, textures: None }
}

const CORNERS: [[f64; 3]; 4] = [[-1., -1., -1.], [1., -1., -1.], [0., 1., 0.], [0., -1., 1.]];
const SIDES: [[u32; 3]; 4] = [[0, 1, 2], [1, 3, 2], [3, 0, 2], [0, 3, 1]];

fn tetrahedron(inside: DVec3) -> Mesh {
    flat(&CORNERS, &SIDES, Some(inside))
}

/// A closed ball of triangles.
fn ball(size: f64, at: DVec3) -> Mesh {
    const RINGS: u32 = 16;
    const STEPS: u32 = 32;
    let mut vertices = vec![at + size * DVec3::NEG_Y];
    for ring in 1..RINGS {
        let latitude = (f64::from(ring) / f64::from(RINGS) - 0.5) * std::f64::consts::PI;
        for step in 0..STEPS {
            let longitude = f64::from(step) / f64::from(STEPS) * std::f64::consts::TAU;
            let flat = DVec3::new(longitude.cos(), 0.0, longitude.sin()) * latitude.cos();
            vertices.push(at + size * flat.with_y(latitude.sin()));
        }
    }
    let top = vertices.len() as u32;
    vertices.push(at + size * DVec3::Y);
    let corner = |ring: u32, step: u32| match ring {
        0 => 0,
        RINGS => top,
        _ => 1 + (ring - 1) * STEPS + step % STEPS,
    };
    let mut faces = Vec::new();
    for ring in 0..RINGS {
        for step in 0..STEPS {
            let [a, b] = [corner(ring, step), corner(ring, step + 1)];
            let [c, d] = [corner(ring + 1, step), corner(ring + 1, step + 1)];
            faces.push(face([a, b, d]));
            faces.push(face([a, d, c]));
        }
    }
    Mesh::new(Lists { vertices, ..Lists::default() }, &faces, Some(DVec3::new(0.1, 1.0, 0.2))).unwrap()
}

battery! {
    closed: |size, at| ball(size, at);
}

#[test]
fn probes_agree_with_povray() {
    table(
        &tetrahedron(DVec3::new(0.1, 0.3, 1.0)),
        "from <0.1,0.2,-5> dir <0,0,1> | P <0.1, 0.2, -0.4> N <0, 0.4472135955, -0.894427191>
        from <0,-0.5,0> dir <0,-1,0> | P <0, -1, 0> N <0, -1, 0>
        inside <0,-0.5,0> | 1
        inside <0,-0.5,-2> | 0
        inside <0,0.99,0> | 1
        extent | <-1, -1, -1> .. <1, 1, 1>",
    );
}

#[test]
fn an_inside_vector_through_an_edge_counts_it_once() {
    // POV-Ray counts it once for each triangle and has inside and outside exchanged.
    table(&tetrahedron(DVec3::new(0.0, 0.3, 1.0)), "inside <0,-0.5,0> | 1\ninside <0,-0.5,-2> | 0");
}

#[test]
fn an_inside_vector_along_a_seam_passes_over_its_gap() {
    // The first and last meridian of a ball made by loops are apart by the rounding of a full turn.
    let seam = |z: f64| [[0.0, -1.0, 0.0], [1.0, 0.0, z], [0.0, 1.0, 0.0]];
    for gap in [3e-16, -3e-16] {
        let rest = [[0.0, 0.0, -1.0], [-1.0, 0.0, 0.0], [0.0, 0.0, 1.0]];
        let corners: Vec<_> = seam(0.0).into_iter().chain(seam(gap)).chain(rest).collect();
        // Octants of the front from the exact meridian, of the back from the rounded one.
        let faces = [[1, 6, 2], [1, 6, 0], [6, 7, 2], [6, 7, 0], [4, 8, 2], [4, 8, 0], [8, 7, 2], [8, 7, 0]];
        let mesh = flat(&corners, &faces, Some(DVec3::Y));
        for z in [0.0, 1e-16, -1e-16, 2e-16, -2e-16] {
            assert!(mesh.inside(DVec3::new(0.3, 0.1, z)), "gap {gap}, z {z}");
            assert!(!mesh.inside(DVec3::new(0.3, -0.8, z)), "gap {gap}, z {z}");
            assert!(!mesh.inside(DVec3::new(1.2, -0.8, z)), "gap {gap}, z {z}");
        }
    }
}

#[test]
fn without_an_inside_vector_a_mesh_is_a_surface() {
    let surface = flat(&CORNERS, &SIDES, None);
    assert!(!surface.is_solid() && !surface.inside(DVec3::new(0.0, -0.5, 0.0)));
}

fn quad(normals: &[[f64; 3]], uvs: &[[f64; 2]], faces: Vec<Face>) -> Mesh {
    let vertices = [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.], [0., 1., 0.5]];
    let lists = Lists {
        vertices: vertices.map(DVec3::from).to_vec(),
        normals: normals.iter().map(|n| DVec3::from(*n)).collect(),
        uvs: uvs.iter().map(|uv| DVec2::from(*uv)).collect(),
    };
    Mesh::new(lists, &faces, None).unwrap()
}

#[test]
fn normals_are_interpolated_as_povray_does() {
    let same = |v: [u32; 3]| Face { normals: Some(v), uvs: Some(v), ..face(v) };
    let normals = [[-0.3, -0.3, -1.0], [0.3, -0.3, -1.0], [0.3, 0.3, -1.0], [-0.3, 0.3, -1.0]];
    let uvs = [[0.0, 0.0], [1.0, 0.0], [1.0, 1.0], [0.0, 1.0]];
    let smooth = quad(&normals, &uvs, vec![same([0, 1, 2]), same([0, 2, 3])]);
    // POV-Ray stores normals in single precision: it has 0.1183084585, -0.9859037566 here and
    // 0.1835978179, -0.9830014452 below.
    table(
        &smooth,
        "from <0.7,0.3,-5> dir <0,0,1> | P <0.7, 0.3, 0> N <0.118308451, -0.118308451, -0.985903758>
        from <1.0001,0.5,-5> dir <0,0,1> | miss",
    );
    battery::uv(&smooth, [0.7, 0.3, -5.0], [0.0, 0.0, 1.0], [0.70001, 0.30001]);
    battery::uv(&smooth, [0.3, 0.7, -5.0], [0.0, 0.0, 1.0], [0.30001, 0.70001]);

    let own = Face { normals: Some([0, 1, 0]), ..face([0, 1, 2]) };
    table(
        &quad(&[[0.0, 0.0, -1.0], [0.5, 0.0, -1.0]], &[], vec![own, face([0, 2, 3])]),
        "from <0.7,0.3,-5> dir <0,0,1> | P <0.7, 0.3, 0> N <0.1835978192, 0, -0.9830014449>
        from <0.3,0.7,-5> dir <0,0,1> | P <0.3, 0.7, 0.2> N <-0.4082482905, 0.4082482905, -0.8164965809>",
    );
}

#[test]
fn uv_indices_differ_from_those_of_the_corners() {
    let uvs = [[0.1, 0.2], [0.9, 0.3], [0.4, 0.8]];
    let own = |vertices, uvs| Face { uvs: Some(uvs), ..face(vertices) };
    let mesh = quad(&[], &uvs, vec![own([0, 1, 2], [0, 1, 2]), own([0, 2, 3], [2, 1, 0])]);
    battery::uv(&mesh, [0.7, 0.3, -5.0], [0.0, 0.0, 1.0], [0.51, 0.42]);
    battery::uv(&mesh, [0.3, 0.7, -5.0], [0.0, 0.0, 1.0], [0.43, 0.40999]);
}

#[test]
fn textures_of_corners_are_blended_by_nearness() {
    let mesh = quad(&[], &[], vec![Face { textures: Some([7, 8, 9]), ..face([0, 1, 2]) }]);
    let mut found = Vec::new();
    let crossing = Crossing { t: 1.0, part: 0, at: [0.25, 0.5] };
    mesh.textures(DVec3::ZERO, &crossing, &mut |texture, weight| found.push((texture, weight)));
    assert_eq!(found, [(7, 0.25), (8, 0.25), (9, 0.5)]);
}

#[test]
fn no_ray_slips_through_an_edge_or_corner() {
    let mesh = ball(1.0, DVec3::ZERO);
    for number in 0..3000 {
        let mut dice = Dice::new(number);
        let corners = mesh.corners(number as u32 % mesh.faces.len() as u32);
        let on = corners[0].lerp(corners[1], [0.0, 1.0, dice.unit()][number as usize % 3]);
        let origin = [0.0, 1e-6, 0.3][number as usize / 3 % 3] * dice.cube();
        let ray = Ray::new(origin, on - origin);
        assert!(mesh.nearest(&ray, Range::AHEAD).is_some(), "ray {number}");
    }
}

#[test]
fn the_hierarchy_finds_what_a_list_finds() {
    let mesh = ball(1.0, DVec3::ZERO);
    for number in 0..2000 {
        let mut dice = Dice::new(number);
        let ray = Ray::new(3.0 * dice.cube(), dice.cube());
        let sheared = Sheared::new(&ray);
        let parts = 0..mesh.faces.len() as u32;
        let hits = parts.filter_map(|part| sheared.meet(mesh.corners(part))).map(|hit| hit.t);
        let expected = hits.filter(|t| *t > 0.0).min_by(f64::total_cmp);
        assert_eq!(mesh.nearest(&ray, Range::AHEAD).map(|hit| hit.t), expected, "ray {number}");
        assert_eq!(mesh.occludes(&ray, Range::AHEAD), expected.is_some(), "ray {number}");
    }
}

#[test]
fn faces_that_refer_to_nothing_make_no_mesh() {
    let lists = Lists { vertices: vec![DVec3::ZERO], ..Lists::default() };
    assert!(Mesh::new(lists, &[face([0, 0, 1])], None).is_none());
}

#[test]
fn half_a_million_parts_in_one_place_make_a_hierarchy() {
    let boxes = vec![(Bounds::new(DVec3::ZERO, DVec3::ONE), 0); 500_000];
    let mut visited = 0;
    Bvh::with_runs(boxes, RUN).0.runs_along(&Ray::new(DVec3::NEG_Z, DVec3::Z), Range::AHEAD, |run| {
        visited += run.len();
        f64::INFINITY
    });
    assert_eq!(visited, 500_000);
}

#[test]
fn what_lines_hold_of_a_mesh_that_is_not_closed() {
    // Three sides of the four, so that what is inside goes on below.
    let open = flat(&CORNERS, &SIDES[..3], Some(DVec3::new(0.1, 1.0, 0.2)));
    assert!(!open.inside(DVec3::new(0.0, -0.5, -2.0)) && open.inside(DVec3::new(-0.3, -3.0, -0.8)));
    let (mut sure, mut insides) = (0, 0);
    for number in 0..4000 {
        let mut dice = Dice::new(number);
        let mut point = |size: f64| size * DVec3::from_array([(); 3].map(|()| 2.0 * dice.unit() - 1.0));
        let (middle, along) = (point(2.0) - DVec3::Y, point(1.0) * 0.5_f64.powi((number % 12) as i32));
        let line = [0, 1, 2].map(|i| Band::line(Lanes::splat(middle[i]), Lanes::splat(along[i])));
        let band = open.inside_along(&line);
        let (low, high) = (band.low().0[0], band.high().0[0]);
        if high - low < 0.5 {
            sure += 1;
            for share in -8..=8 {
                let inside = open.inside(middle + along * f64::from(share) / 8.0);
                insides += u32::from(inside);
                assert!((low..=high).contains(&f64::from(inside)), "{middle} {along} at {share}/8");
            }
        }
    }
    // Short lines hardly ever cross anything.
    assert!(sure > 3000 && insides > 1000, "{sure} {insides}");
}
