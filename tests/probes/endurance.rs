//! Long ways of light, and the same picture whatever finds the objects.

use povista::options::{Accelerator, Antialias, AntialiasMethod, Filter, RenderOptions, Sampling};

use crate::table::{picture, scene};

#[test]
fn parallel_mirrors_are_followed_250_levels_deep() {
    let mirror = "pigment{rgb 1} finish{ambient .001 diffuse 0 reflection 1}";
    let sdl = format!(
        "camera{{location 0 direction z+.01*x}} global_settings{{max_trace_level 250 adc_bailout 0}}
        plane{{z,-5 {mirror}}} plane{{-z,-5 {mirror}}}"
    );
    let rendered = picture(&scene(&sdl, "3.7"), &RenderOptions::new(16, 12)).unwrap();
    let statistics = rendered.statistics;
    assert_eq!((statistics.reflected_rays, statistics.too_deep), (250 * 192, 192));
    for [red, green, blue, _] in rendered.image.pixels {
        // Each of 250 mirrors adds a thousandth.
        assert!((red - 0.25).abs() < 1e-4 && red == green && green == blue, "{red} {green} {blue}");
    }
}

#[test]
fn what_one_solid_of_any_shape_and_convex_ones_share_looks_and_shades_the_same_on_every_way() {
    // Many far balls beside a cutter make a compound of it, of which all crossings are asked.
    for (solid, cutter) in [
        ("cylinder{-2*y,2*y,1 open rotate 20*z}", "plane{y,.5}"),
        ("cylinder{-2*y,0,1 open}", "plane{y,1}"),
        ("cone{-2*y,1.5,y,.3 open rotate 30*x}", "box{<-3,-.8,-3>,<3,.4,3>}"),
        (
            "height_field{function 16,16{.5+.4*sin(9*x)*cos(7*y)} translate -.5 scale 3 rotate 25*y}",
            "plane{y,-.4}",
        ),
        (
            "height_field{function 16,16{x*y} translate -.5 scale 2 rotate <5,30,9>}",
            "box{<-1.5,-2,-.5>,<1.5,.2,.6>}",
        ),
        ("disc{0,y,1.2 rotate 15*x}", "box{-.8,.9}"),
        ("prism{linear_spline 0,1,4,<-1,-1>,<1,-1>,<0,1>,<-1,-1> open rotate 25*z}", "plane{y,.4}"),
        ("torus{.8,.3 rotate 50*x}", "sphere{<.3,.2,-.4>,.8 inverse}"),
    ] {
        let [short, general] = ["", "#for(I,1,17) sphere{1e4*x+I,.1} #end"].map(|beside| {
            let cutter = if beside.is_empty() { cutter.to_owned() } else { format!("union{{{cutter} {beside}}}") };
            let sdl = format!(
                "camera{{location <0,1.5,-7> look_at 0}} light_source{{<2,9,-3> rgb 1}} light_source{{<-3,-1.5,-6> rgb .5}}
                intersection{{{solid} {cutter} pigment{{rgb <1,.7,.2>}}}} plane{{y,-2.5 pigment{{rgb 1}}}}"
            );
            picture(&scene(&sdl, "3.7"), &RenderOptions::new(64, 48)).unwrap().image
        });
        let unlike = short.pixels.iter().zip(&general.pixels).filter(|(a, b)| a != b).count();
        assert_eq!(unlike, 0, "{solid} {cutter}");
    }
}

#[test]
fn compounds_that_are_asked_member_by_member_look_the_same_as_those_of_which_all_is_asked() {
    let parts = "#declare Foot=lathe{cubic_spline 7,<0,-1>,<0,-1>,<.6,-.9>,<.2,-.2>,<.5,.4>,<0,.8>,<0,.8>}
        #declare Star=prism{linear_spline -.4,.5,5,<-.9,-.6>,<.8,-.5>,<.2,.1>,<.1,.9>,<-.9,-.6> rotate 20*x}
        #declare Chest=superellipsoid{<.05,.05>}";
    for solid in [
        "difference{object{Chest} difference{object{Foot} box{<0,.2,-1>,<1,.4,1> rotate 45*z}} rotate 30*y}",
        "difference{object{Chest} union{object{Foot} difference{object{Star} cylinder{-z,z,.3 translate .3*y}
            cylinder{<-.5,-1,.2>,<-.5,1,.2>,.1} box{-.2,.2 rotate 45*y}}} rotate <20,40,0>}",
        "difference{superellipsoid{<.6,1.3>} object{Foot} rotate 50*x}",
        "difference{superellipsoid{<2.5,.4>} sphere{.2,.4} torus{.6,.1}}",
        "merge{object{Foot} object{Star} torus{.7,.2}}",
        "intersection{sphere{0,.9} union{object{Foot} torus{.6,.3 rotate 60*x}}}",
        "intersection{object{Foot} object{Star} scale 1.5}",
        "difference{box{-.8,.8} merge{torus{.6,.3} sphere{.5*y,.4}} rotate 30}",
        "difference{box{-.8,.8} difference{sphere{0,.9} box{-.5,.5} cylinder{-2*z,2*z,.3}}}",
        // Faces that coincide.
        "difference{box{<-1,-.4,-1>,<1,.5,1>} object{Star} torus{.7,.2 translate .3*y} rotate 15*x}",
        "merge{lathe{linear_spline 4,<0,0>,<.7,0>,<.7,.8>,<0,.8>} torus{.7,.2} cylinder{-.8*y,0,.7}}",
        // What has no box.
        "intersection{plane{y,.4} union{object{Foot} torus{.7,.2}} plane{-x,.5}}",
        "difference{plane{y,-.3} object{Foot} torus{.8,.3 translate -.3*y}}",
        "intersection{object{Foot} torus{.4,.3} clipped_by{sphere{.3*x,.8}}}",
        // What is left where there is no surface.
        "difference{box{-.8,.8} merge{object{Foot} cylinder{-y,y,.4 open} rotate 40*z}}",
        "difference{torus{.7,.5} merge{torus{.2,.5} height_field{function 9,9{x*y} translate -.5}}}",
        // What fills all space but a hole is in a union with what has surfaces inside of it.
        "merge{union{superellipsoid{<.1,.6>} box{-.6,.6 inverse translate<-.6,-.4,-1>}} sphere{0,.4}}",
        "merge{union{torus{.8,.3} sphere{3*y,.2 inverse}} object{Star} box{-.2,.2 translate x}}",
    ] {
        for finish in ["rgb<1,.7,.2>", "rgbf<.9,1,.9,.9>} finish{reflection{0,1 fresnel}} interior{ior 1.4"] {
            // Far balls make a compound of too many solids to be asked one by one.
            let [all, alone, beside] = [17, 0, 1].map(|balls| {
                let sdl = format!(
                    "{parts} global_settings{{max_trace_level 6}} camera{{location <0,1.5,-4> look_at 0 angle 40}}
                    light_source{{<2,9,-3> rgb 1}} light_source{{<-3,-1.5,-6> rgb .5}}
                    intersection{{{solid} #for(I,1,{balls}) sphere{{1e4*x+I,.1 inverse}} #end pigment{{{finish}}}}}
                    plane{{y,-2.5 pigment{{checker rgb 1 rgb .3}}}}"
                );
                picture(&scene(&sdl, "3.7"), &RenderOptions::new(64, 48)).unwrap().image
            });
            for short in [alone, beside] {
                let unlike = short.pixels.iter().zip(&all.pixels).filter(|(a, b)| a != b).count();
                assert_eq!(unlike, 0, "{solid} {finish}");
            }
        }
    }
}

#[test]
fn linear_search_octree_and_tree_of_boxes_make_the_same_picture() {
    let sdl = "camera{location <0,3,-12> look_at 0} light_source{<5,9,-8> rgb 1}
        #declare R=seed(4); #declare N=function(x){sin(x*12.9898)*43758.5453-int(sin(x*12.9898)*43758.5453)};
        #macro Place(I) translate 4*<N(I),N(I+.3),N(I+.6)> #end
        #for(I,1,60) sphere{0,.5 pigment{rgbt<1,.7,.2,.3*mod(I,2)>} finish{phong .5 reflection .2} Place(I)} #end
        #for(I,61,90) difference{box{-.5,.5} sphere{.4,.5} cylinder{-y,y,.2} pigment{rgb<.3,.6,1>} Place(I)} #end
        #for(I,91,99) merge{sphere{0,.5} sphere{.4*x,.4} pigment{rgbf<1,1,1,.8>} interior{ior 1.4} Place(I)} #end
        plane{y,-4 pigment{checker rgb 1 rgb .2}}";
    let kinds = [Accelerator::Linear, Accelerator::Octree, Accelerator::Bvh, Accelerator::Auto];
    let [linear, others @ ..] = kinds.map(|accelerator| {
        let options = RenderOptions { accelerator, ..RenderOptions::new(64, 48) };
        picture(&scene(sdl, "3.7"), &options).unwrap().image
    });
    for other in others {
        assert!(other == linear);
    }
}

#[test]
fn pixels_that_are_looked_at_together_show_what_they_show_alone() {
    // Only trees of boxes let rays travel together.
    let objects = "light_source{<5,9,-8> rgb 1} light_source{<-9,2,-3> rgb .3}
        plane{y,-.9 pigment{checker rgb 1 rgb .2}}
        #for(I,-3,3) torus{.5,.2 rotate <40*I,70*I,0> translate <I,.4*I,I> pigment{rgb<.5+.1*I,.6,.7>}} #end
        blob{threshold .5 sphere{<0,0,-2>,.7,1} sphere{<.5,.2,-2>,.6,1} cylinder{<-1,0,-2>,<0,.5,-2>,.3,.8}
            sphere{<.1,.3,-2.3>,.4,-.6} pigment{rgbt<.4,.8,.5,.2>}}
        quartic{<4,0,0,-4,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 0,0,0,0,0, 1,0,0,0,0, 0,0,1,0,0>
            bounded_by{box{<-.01,-.7,-.7>,<1.01,.7,.7>}} rotate 60*z translate <1.2,-.6,-2> pigment{rgb<.8,.3,.3>}}
        sphere{<-1,1.6,0>,.4 pigment{rgbt<1,.7,.2,.5>} finish{reflection .3}}";
    for (antialias, fog) in [(None, ""), (Some(Antialias::default()), "fog{distance 20 rgb .5}")] {
        let sdl = format!("camera{{location <0,1.5,-6> look_at 0}} {fog} {objects}");
        let [linear, tree, auto] =
            [Accelerator::Linear, Accelerator::Bvh, Accelerator::Auto].map(|accelerator| {
                let options = RenderOptions { accelerator, antialias, ..RenderOptions::new(67, 41) };
                picture(&scene(&sdl, "3.7"), &options).unwrap().image
            });
        assert!(tree == linear && auto == linear, "{fog}");
    }
}

#[test]
fn rays_from_the_eye_meet_together_what_they_meet_alone() {
    // Only the tree of boxes lets rays travel together.
    let objects = "light_source{<5,9,-8> rgb 1} plane{y,-.5 pigment{checker rgb 1 rgb .2} finish{Floor}}
        #for(I,-3,3) sphere{<I,0,I>,.5 pigment{rgb<.5+.1*I,.6,.7>} finish{phong .5}}
            box{-.4,.4 translate <I,-.1,2-I> pigment{rgb<.3,.6,1>} finish{reflection .2}} #end
        torus{.6,.2 translate <0,1,-1> pigment{rgb<1,.5,.2>}} sphere{<-1,1,0>,.3 pigment{rgbt<1,.7,.2,.5>}}
        difference{box{-.5,.5} sphere{.4,.5} rotate 30*y translate <1.5,1,0> pigment{bozo}}
        cylinder{<-2,0,1>,<-2,2,1>,.2 pigment{rgb .5} normal{bumps}}";
    let even = "background{rgb <.2,.3,.5>}";
    for (camera, floor, sky) in [
        ("", "", even),
        ("", "reflection{.1,.9 falloff 3 exponent 1.5}", even),
        ("aperture .4 focal_point 0 blur_samples 19", "", even),
        ("aperture .4 focal_point 0 blur_samples 19", "reflection{.3 metallic} metallic", even),
        (
            "aperture 1.5 focal_point <0,0,-2> blur_samples 40 variance .001",
            "reflection{0,1}",
            "sky_sphere{pigment{gradient y}}",
        ),
        ("aperture .4 focal_point 0 blur_samples 10 normal{bumps .1}", "", ""),
        ("orthographic angle 50", "reflection{.1,.9 falloff 3 exponent 1.5}", even),
        // Its rays start on either side of the floor.
        ("orthographic angle 120", "", "fog{distance 20 rgb .5}"),
    ] {
        let sdl = format!(
            "#declare Floor=finish{{{floor}}} camera{{{camera} location <0,2,-7> look_at 0}} {sky} {objects}"
        );
        let of = |accelerator, sampling, method: Option<AntialiasMethod>| {
            let antialias = method.map(|method| Antialias { method, threshold: 0.02, ..Default::default() });
            let options = RenderOptions { accelerator, sampling, antialias, ..RenderOptions::new(48, 36) };
            picture(&scene(&sdl, "3.7"), &options).unwrap().image
        };
        let even = Sampling::Even { samples: 6, filter: Filter::Gaussian };
        let refined = [
            (None, Some(AntialiasMethod::Neighbours)),
            (None, Some(AntialiasMethod::Adaptive)),
            (Some(even), None),
            (Some(Sampling::Corners), None),
            (Some(Sampling::Edges { error: 4.0, most: 64 }), None),
        ];
        // Samples of a lens are none of the sampling's.
        for (sampling, method) in refined.into_iter().filter(|_| !camera.contains("aperture")) {
            let [linear, tree] = [Accelerator::Linear, Accelerator::Bvh].map(|a| of(a, sampling, method));
            assert!(tree == linear, "{floor} {sampling:?} {method:?}");
        }
        let [linear, tree] = [Accelerator::Linear, Accelerator::Bvh].map(|a| of(a, None, None));
        assert!(tree == linear, "{camera} {floor}");
        let rgb = |[r, g, b, _]: &[f32; 4]| (r + g + b).to_bits();
        let colors: std::collections::HashSet<u32> = tree.pixels.iter().map(rgb).collect();
        assert!(colors.len() > 300, "{camera}: {} colours", colors.len());
    }
}

#[test]
fn rays_through_glass_see_together_what_they_see_alone() {
    // Only where the kind of search is left open, and objects are few, do they go on together.
    let sdl = |glass: &str, filling: &str, others: &str| {
        format!(
            "global_settings{{max_trace_level 7 adc_bailout .002}} camera{{location <0,1.5,-6> look_at <0,.4,0>}}
            light_source{{<5,9,-8> rgb 1}} light_source{{<-9,4,-3> rgb .4 spotlight point_at 0 radius 9 falloff 12}}
            background{{rgb <.2,.3,.5>}} plane{{y,-.6 pigment{{gradient x color_map{{[.5 rgb 1][.5 rgb .2]}}}}}}
            #declare Glass=texture{{pigment{{rgbf<.95,1,.9,.9>}} finish{{{glass}}}}}
            #declare Filling=interior{{ior 1.5 {filling}}}
            sphere{{0,.6 texture{{Glass}} interior{{Filling}}}} {others}"
        )
    };
    let fresnel = "specular .8 roughness .01 reflection{.05,.9 fresnel} conserve_energy";
    for (glass, filling, others) in [
        (fresnel, "", "sphere{<1,.3,.6>,.5 texture{Glass} interior{Filling}}"),
        (
            fresnel,
            "fade_distance 1 fade_power 2 caustics 1",
            "sphere{.2*y,.3 texture{Glass} interior{ior 1}}",
        ),
        (
            "phong 1 reflection{.2,1 falloff 2 exponent 1.3 metallic}",
            "",
            "box{-.4,.3 rotate 20*y pigment{rgb .6}}",
        ),
        ("diffuse .4 .3 reflection .3", "", "box{<-2,-.4,-1>,<-.8,.6,0> texture{Glass} interior{ior 2.2}}"),
        ("phong .5", "", "sphere{<-1,.5,0>,.4 pigment{rgb<1,.5,.2>} finish{reflection .4} no_shadow}"),
        (
            "specular .4",
            "",
            "torus{.7,.1 rotate 70*x pigment{rgb .8}} plane{-z,-3 texture{Glass} interior{ior 1.2}}",
        ),
        ("reflection .2", "dispersion 1.1", "sphere{x,.3 pigment{rgb x} finish{crand .3}}"),
        ("reflection .2", "", "sphere{x,.3 pigment{rgb x} finish{crand .3}}"),
    ] {
        let sdl = sdl(glass, filling, others);
        let of = |accelerator, sampling, antialias| {
            let options = RenderOptions { accelerator, sampling, antialias, ..RenderOptions::new(67, 41) };
            picture(&scene(&sdl, "3.7"), &options).unwrap().image
        };
        for (sampling, antialias) in [
            (None, None),
            (None, Some(Antialias::default())),
            (Some(Sampling::Edges { error: 4.0, most: 64 }), None),
        ] {
            let [alone, together] =
                [Accelerator::Linear, Accelerator::Auto].map(|a| of(a, sampling, antialias));
            assert!(alone == together, "{glass}, {filling}, {others}, {sampling:?}");
        }
    }
}

#[test]
fn rays_of_a_mesh_camera_meet_together_what_they_meet_alone() {
    let objects = "light_source{<5,9,-8> rgb 1} background{rgb <.2,.3,.5>}
        plane{y,-.5 pigment{checker rgb 1 rgb .2} finish{reflection .2}}
        #for(I,-3,3) sphere{<I,0,I>,.5 pigment{rgb<.5+.1*I,.6,.7>} finish{phong .5}} #end
        torus{.6,.2 translate <0,1,-1> pigment{rgb<1,.5,.2>}} sphere{<-1,1,0>,.3 pigment{rgbt<1,.7,.2,.5>}}";
    // Its middle; how far its rays come apart; where they end.
    for (place, spread, reach) in
        [("<0,1,-4>", 0.0, 0.0), ("<0,1,-4>", 0.2, 0.0), ("0", 0.1, 0.0), ("<0,1,-4>", 0.0, 4.0)]
    {
        let film = format!(
            "#declare Film=mesh{{#for(J,0,35) #for(I,0,47) #declare P=<(I-23.5)/12,(17.5-J)/12,0>;
            triangle{{P,P+<.08,.08+{spread}*.08,0>,P+<.08,0,{spread}*P.x*.1>}} #end #end}}"
        );
        let mesh = format!("mesh{{Film translate <mod(I,3)/36,div(I,3)/36,0>+{place}}}");
        let sdl = format!("{film} camera{{mesh_camera{{9 0 {reach} #for(I,0,8) {mesh} #end}}}} {objects}");
        let [linear, tree] = [Accelerator::Linear, Accelerator::Bvh].map(|accelerator| {
            let options = RenderOptions { accelerator, ..RenderOptions::new(48, 36) };
            picture(&scene(&sdl, "3.7"), &options).unwrap().image
        });
        assert!(tree == linear, "{place} {spread} {reach}");
        let rgb = |[r, g, b, _]: &[f32; 4]| (r + g + b).to_bits();
        let colors: std::collections::HashSet<u32> = tree.pixels.iter().map(rgb).collect();
        assert!(colors.len() > 200, "{place} {spread} {reach}: {} colours", colors.len());
    }
}

#[test]
fn light_through_a_pattern_is_the_same_whether_or_not_some_pattern_asks_for_normals() {
    for shape in [
        "sphere{0,1 rotate 30}",
        "box{-.8,.7 rotate <20,40,0>}",
        "torus{.7,.3 rotate 40*x}",
        "cone{-y,.8,y,.2 rotate 25*z}",
        "polygon{5,<-1,-1>,<1,-1>,<1,1>,<-1,1>,<-1,-1> rotate 80*x scale <1,1,.7>}",
        "superellipsoid{<.4,.3> rotate 35}",
        "blob{threshold .4 sphere{<-.3,0,0>,1,1} sphere{<.5,0,0>,.8,1} rotate 20}",
        "isosurface{function{x*x+y*y*2+z*z-.6} contained_by{box{-1,1}} max_gradient 6 rotate 15}",
        "mesh{triangle{<-1,0,-1>,<1,0,-1>,<0,.3,1>} smooth_triangle{<-1,.5,-1>,y,<1,.5,-1>,x+y,<0,.6,1>,y-z}}",
        "intersection{sphere{0,1} cylinder{-y,y,.7} bounded_by{box{-1,1}} scale <1,.8,1>}",
        "difference{sphere{0,.9} plane{y,-.2}}",
    ] {
        let [plain, asked] = ["", "sphere{1e5,.1 pigment{slope{y} color_map{[0 rgb 0][1 rgb 1]}}}"].map(|beside| {
            let sdl = format!(
                "camera{{location <0,5,-5> look_at -y}} light_source{{<1,9,-2> rgb 1}} {beside} plane{{y,-2 pigment{{rgb 1}}}}
                object{{{shape} pigment{{bozo scale .4 color_map{{[.3 rgbf <1,.2,.1,.9>][.6 rgbt <.2,.6,1,.5>]}}}}}}
                object{{{shape} translate 2.5*x texture{{pigment{{checker rgbt 1, rgbf <1,1,0,.7> scale .3}}}}
                    interior_texture{{pigment{{rgbt <0,1,0,.5>}}}}}}
                object{{{shape} translate -2.5*x texture{{gradient y texture_map{{[.4 pigment{{rgbt <1,0,1,.4>}}]
                    [.6 pigment{{marble color_map{{[0 rgbt 1][1 rgbf <.3,.9,.5,1>]}}}}]}}}}}}"
            );
            picture(&scene(&sdl, "3.7"), &RenderOptions::new(64, 48)).unwrap().image
        });
        let unlike = plain.pixels.iter().zip(&asked.pixels).filter(|(a, b)| a != b).count();
        assert_eq!(unlike, 0, "{shape}");
    }
}
