use super::*;
use crate::math::{Bounds, DVec2};
use crate::world::shape::Crossing;
use crate::world::shape::battery::table;
use crate::world::{Range, Ray};

/// A compiled shape seen from the space it was written in, after a further transform.
#[derive(Debug)]
struct Placed {
    primitive: Primitive,
    transform: Transform,
}

impl Placed {
    fn new(description: &scene::Shape, further: Transform) -> Self {
        let Compiled { primitive, transform } = shape(description).unwrap();
        Self { primitive, transform: transform.unwrap_or_default().then(&further) }
    }
}

impl Shape for Placed {
    fn bounds(&self) -> Bounds {
        self.primitive.bounds().transformed(&self.transform)
    }

    fn extent(&self) -> Bounds {
        self.primitive.extent().transformed(&self.transform)
    }

    fn crossings(&self, ray: &Ray, range: Range, out: &mut Vec<Crossing>) {
        self.primitive.crossings(&ray.to_inner(&self.transform), range, out);
    }

    fn inside(&self, point: DVec3) -> bool {
        self.primitive.inside(self.transform.inverse_point(point))
    }

    fn normal(&self, point: DVec3, crossing: &Crossing) -> DVec3 {
        self.transform.normal(self.primitive.normal(self.transform.inverse_point(point), crossing))
    }

    fn uv(&self, point: DVec3, crossing: &Crossing) -> Option<DVec2> {
        self.primitive.uv(self.transform.inverse_point(point), crossing)
    }
}

fn cylinder(base: [f64; 3], cap: [f64; 3], radius: f64, open: bool) -> scene::Shape {
    scene::Shape::Cylinder(Box::new(scene::Cone {
        base: base.into(),
        base_radius: radius,
        cap: cap.into(),
        cap_radius: radius,
        open,
    }))
}

fn cone(base: [f64; 3], base_radius: f64, cap: [f64; 3], cap_radius: f64, open: bool) -> scene::Shape {
    let (base, cap) = (base.into(), cap.into());
    scene::Shape::Cone(Box::new(scene::Cone { base, base_radius, cap, cap_radius, open }))
}

#[track_caller]
fn probes(shape: &scene::Shape, rows: &str) {
    table(&Placed::new(shape, Transform::IDENTITY), rows);
}

#[track_caller]
fn probes_after(shape: &scene::Shape, further: Transform, rows: &str) {
    table(&Placed::new(shape, further), rows);
}

#[test]
fn cylinders_agree_with_povray() {
    probes(
        &cylinder([0.0, 0.0, -1.0], [0.0, 1.0, 2.0], 0.5, false),
        "from <0,0.3,-5> dir <0.01,0.02,1> | P <0.038741721854305, 0.377483443708609, -1.125827814569536> N <0, -0.316227766016838, -0.948683298050514>
        from <3,0.4,0.6> dir <-1,0,0> | P <0.483735464897913, 0.4, 0.6> N <0.967470929795826, -0.24, 0.08>
        from <0,0.5,0.5> dir <1,0.1,0.2> | P <0.499750187343887, 0.549975018734389, 0.599950037468777> N <0.999500374687773, 0.029985011240633, -0.009995003746878>
        extent | <-0.5, -0.474341660737991, -1.158113837242126> .. <0.5, 1.474341630935669, 2.158113956451416>
        inside <0,0.5,0.5> | 1",
    );
    probes(
        &cylinder([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], 1.0, false),
        "from <0,5,0.3> dir <0,-1,0> | P <0, 1, 0.3> N <0, 1, 0>
        from <5,1,0> dir <-1,0,0> | P <1, 1, 0> N <1, 0, 0>
        from <5,0,1> dir <-1,0,0> | P <0, 0, 1> N <0, 0, 1>
        from <5,0,0.9999999> dir <-1,0,0> | P <0.000447213586197, 0, 0.9999999> N <0.000447213586197, 0, 0.999999899999999>
        inside <1,0,0> | 0
        inside <0,1,0> | 0
        inside <0.9999999999,0,0> | 1",
    );
    probes(
        &cylinder([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], 1.0, true),
        "from <0,5,0.3> dir <0,-1,0> | miss
        from <0.3,5,0> dir <0.05,-1,0> | miss
        inside <1,0,0> | 1
        inside <0,1,0> | 1
        inside <1.00000000001,0,0> | 1",
    );
    probes_after(
        &cylinder([0.0; 3], [0.0, 0.0, 1.0], 1.0, false),
        Transform::scale(DVec3::new(1.0, 2.0, 3.0)).then(&Transform::rotate(DVec3::Y * 45.0)),
        "from <0,5,0> dir <0.1,-1,0.1> | P <0.3, 2, 0.3> N <0, 1, 0>
        extent | <-0.70710676908493, -2, -0.70710676908493> .. <2.828427076339722, 2, 2.828427076339722>",
    );
    probes(
        &cylinder([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], -1.0, false),
        "from <0,0.5,-5> dir <0,0,1> | P <0, 0.5, -1> N <0, 0, -1>
        from <0,5,0> dir <0,-1,0> | P <0, 1, 0> N <0, 1, 0>",
    );
}

#[test]
fn cones_agree_with_povray() {
    probes(
        &cone([0.0, 0.0, -1.0], 1.0, [0.0, 0.0, 2.0], 0.25, false),
        "from <0,0.3,-5> dir <0.01,0.02,1> | P <0.04, 0.38, -1> N <0, 0, -1>
        from <3,0,0> dir <-1,0.1,0> | P <0.71432260821482, 0.228567739178518, 0> N <0.923992961391811, 0.295657703918951, 0.242535625036332>
        from <0,0.1,5> dir <0,0,-1> | P <0, 0.1, 2> N <0, 0, 1>
        from <0,0,0> dir <1,0.2,0.3> | P <0.685054189282337, 0.137010837856467, 0.205516256784701> N <0.951302988308988, 0.190260597661798, 0.242535625036333>
        extent | <-1, -1, -1> .. <1, 1, 2>
        inside <0,0.5,0> | 1
        inside <0,0.76,0> | 0",
    );
    probes(
        &cone([0.0; 3], 0.0, [0.0, 1.0, 0.0], 1.0, false),
        "from <3,0.5,0> dir <-1,0,0> | P <0.5, 0.5, 0> N <0.707106781186547, -0.707106781186547, 0>
        from <0.2,-1,0> dir <0,1,0> | P <0.2, 0.2, 0> N <0.707106781186547, -0.707106781186548, 0>
        from <0,-1,0> dir <0,1,0> | P <0, 0, 0> N <0, -1, 0>
        from <-1,-1,0.5> dir <1,1,0> | miss
        from <-1,-0.5,0> dir <1,1,0> | P <-0.25, 0.25, 0> N <-0.707106781186547, -0.707106781186547, 0>
        extent | <-1, 0, -1> .. <1, 1, 1>
        inside <0,0,0> | 0
        inside <0,0.5,0> | 1",
    );
    probes(
        &cone([0.0, -1.0, 0.0], 1.0, [0.0, 1.0, 0.0], 0.5, true),
        "from <0.1,3,0> dir <0,-1,0> | miss
        from <0.7,3,0> dir <0,-1,0> | P <0.7, 0.2, 0> N <0.970142500145332, 0.242535625036333, 0>
        from <0,0,0> dir <0.2,1,0> | miss",
    );
    probes(
        &cone([0.0, 0.0, -1.0], 1.0, [0.0, 0.0, 1.0], -1.0, false),
        "from <0,0.5,-5> dir <0,0,1> | P <0, 0.5, -1> N <0, 0, -1>
        from <0,3,0.4> dir <0,-1,0> | P <0, 0.4, 0.4> N <0, 0.707106781186548, -0.707106781186548>
        inside <0,0,0.5> | 1",
    );
    probes_after(
        &cone([0.0, -1.0, 0.0], 1.0, [0.0, 1.0, 0.0], 0.2, false),
        Transform::scale(DVec3::new(1.0, 1.0, 3.0)).then(&Transform::rotate(DVec3::X * 30.0)),
        "from <0.1,0.2,-5> dir <0,0.02,1> | P <0.1, 0.251294889668244, -2.435255516587814> N <0, -0.866025403784439, -0.5>
        extent | <-1, -2.366025447845459, -3.098076343536377> .. <1, 2.366025447845459, 3.098075866699219>",
    );
    probes(
        &cone([0.0; 3], 1.0, [0.0, 1.0, 0.0], 1.0, false),
        "from <3,0.5,0.1> dir <-1,0,0> | P <0.99498743710662, 0.5, 0.1> N <0.99498743710662, 0, 0.1>",
    );
}

#[test]
fn discs_agree_with_povray() {
    let disc = |center: [f64; 3], normal: DVec3, radius, hole| {
        let center = center.into();
        scene::Shape::Disc(Box::new(scene::Disc { center, normal: normal.normalize(), radius, hole }))
    };
    probes(
        &disc([0.0, 1.0, 0.0], DVec3::new(0.0, 1.0, 1.0), 2.0, 0.5),
        "from <0.6,5,1> dir <0,-1,-0.2> | P <0.6, 0.833333333333332, 0.166666666666666> N <0, 0.707106781186547, 0.707106781186547>
        from <0,1,-5> dir <0,0,1> | miss
        from <0,2,-5> dir <0,0,1> | P <0, 2, -1> N <0, 0.707106781186547, 0.707106781186547>
        from <0,-2,-1> dir <0,1,0.2> | miss
        inside <0,0,0> | 1
        inside <0,3,0> | 0
        inside <0,1,0> | 0
        extent | <-2, -0.414920657873154, -1.414920687675476> .. <2, 2.414920806884766, 1.414920687675476>",
    );
    probes_after(
        &disc([0.0; 3], DVec3::Z, 1.0, 0.0),
        Transform::scale(DVec3::new(2.0, 1.0, 3.0)).then(&Transform::rotate(DVec3::X * 30.0)),
        "from <1.5,0.2,-5> dir <0,0,1> | P <1.5, 0.2, 0.115470053837925> N <0, -0.5, 0.866025403784439>
        extent | <-2, -0.867525398731232, -0.50259804725647> .. <2, 0.867525398731232, 0.50259804725647>",
    );
}

#[test]
fn transformed_primitives_agree_with_povray() {
    probes_after(
        &scene::Shape::Sphere { center: DVec3::ZERO, radius: 1.0 },
        Transform::scale(DVec3::new(1.0, 2.0, 3.0))
            .then(&Transform::rotate(DVec3::new(10.0, 20.0, 30.0)))
            .then(&Transform::translate(DVec3::ONE)),
        "from <0,0,-10> dir <.1,.1,1> | P <0.864777941482347, 0.864777941482347, -1.352220585176524> N <0.682141709529517, 0.28260167227663, -0.674402686046401>
        from <1,1,1> dir <1,0,0> | P <2.172985125635098, 1, 1> N <0.883854874128486, 0.347585581741411, -0.313025278284042>
        inside <1,1,3> | 1
        inside <1,1,3.9> | 0
        extent | <-1.831303834915161, -1.289059519767761, -2.444621801376343> .. <3.831303834915161, 3.289059162139893, 4.444622039794922>",
    );
    probes_after(
        &scene::Shape::Box { min: DVec3::NEG_ONE, max: DVec3::ONE },
        Transform::rotate(DVec3::Y * 30.0).then(&Transform::scale(DVec3::new(1.0, 2.0, 1.0))),
        "from <0,0.3,-5> dir <0.05,0.1,1> | P <0.186870486788491, 0.673740973576982, -1.262590264230183> N <-0.5, 0, -0.866025403784439>
        extent | <-1.366025447845459, -2, -1.366025447845459> .. <1.366025447845459, 2, 1.366025447845459>",
    );
    probes_after(
        &scene::Shape::Torus { major: 1.0, minor: 0.3 },
        Transform::scale(DVec3::new(1.0, 2.0, 1.5))
            .then(&Transform::rotate(DVec3::new(30.0, 40.0, 50.0)))
            .then(&Transform::translate(DVec3::X)),
        "from <0,0,-5> dir <0.1,0.05,1> | P <0.341594249124792, 0.170797124562396, -1.584057508752077> N <-0.022055576387417, 0.229739848698257, -0.973002134360619>
        extent | <-1.358864545822144, -1.449423551559448, -2.359094381332397> .. <3.358864545822144, 1.449423551559448, 2.359094381332397>",
    );
    let plane = scene::Shape::Plane { normal: DVec3::Y, distance: 0.0 };
    let sheared = [1.0, 0.5, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 2.0, 0.0];
    probes_after(
        &plane,
        Transform::from_rows(sheared).unwrap(),
        "from <1,5,0> dir <0,-1,0> | P <1, 2.5, 0> N <-0.447213595499958, 0.894427190999916, 0>
        inside <0,2,0> | 1
        inside <0,1.9,0> | 1",
    );
}

#[test]
fn what_povray_accepts_and_never_hits_compiles_to_nothing() {
    let never = [
        scene::Shape::Sphere { center: DVec3::ZERO, radius: 0.0 },
        cylinder([0.0; 3], [0.0, 1.0, 0.0], 0.0, false),
        cone([0.0; 3], 0.0, [0.0, 1.0, 0.0], 0.0, false),
        scene::Shape::Torus { major: 1.0, minor: 0.0 },
        scene::Shape::Torus { major: 0.0, minor: 1.0 },
        scene::Shape::Disc(Box::new(scene::Disc {
            center: DVec3::ZERO,
            normal: DVec3::ZERO,
            radius: 1.0,
            hole: 0.0,
        })),
        scene::Shape::Polygon(Arc::new([DVec3::ZERO, DVec3::X, DVec3::ZERO])),
    ];
    for description in &never {
        let Compiled { primitive, .. } = shape(description).unwrap();
        assert!(primitive.bounds().is_empty(), "{description:?}");
        assert!(!primitive.occludes(&Ray::new(-5.0 * DVec3::Z, DVec3::Z), Range::LINE));
        assert!(!primitive.inside(DVec3::ZERO));
    }
}

#[test]
fn a_tiny_cylinder_far_from_the_camera_is_hit() {
    // POV-Ray loses it beyond 1e7 of its own radius.
    let tiny = Placed::new(&cylinder([0.0, -1.0, 0.0], [0.0, 1.0, 0.0], 1e-6, false), Transform::IDENTITY);
    assert!(tiny.occludes(&Ray::new(-11.0 * DVec3::Z, DVec3::Z), Range::AHEAD));
}
