//! What a scene doesn't need isn't computed, and threads never change a picture.

use povista::options::{Antialias, RenderOptions};
use povista::render::Statistics;

use crate::table::{picture, scene};

fn statistics(sdl: &str) -> Statistics {
    picture(&scene(sdl, "3.7"), &RenderOptions::new(16, 12)).unwrap().statistics
}

#[test]
fn no_shadow_ray_starts_where_the_surface_faces_away() {
    let counts = statistics("light_source{9*z rgb 1} FLOOR");
    assert_eq!((counts.shadow_rays, counts.lights_behind), (0, 192));
}

#[test]
fn shadowless_lights_and_surfaces_without_diffuse_need_no_shadow_rays() {
    assert_eq!(statistics("light_source{0 rgb 1 shadowless} FLOOR").shadow_rays, 0);
    let glowing = "light_source{0 rgb 1} WALL(pigment{rgb 1} finish{ambient 1 diffuse 0})";
    assert_eq!(statistics(glowing).shadow_rays, 0);
}

#[test]
fn where_a_mirror_has_no_highlight_nothing_asks_for_its_shadow() {
    let mirror = |finish: &str, pigment: &str| {
        let finish = format!("finish{{ambient 0 diffuse 0 specular 1 roughness .001 {finish}}}");
        statistics(&format!("light_source{{0 rgb 1}} WALL(pigment{{{pigment}}} {finish})"))
    };
    for pigment in ["rgb 1", "rgbt 1", "rgb .5 transmit .5"] {
        let counts = mirror("", pigment);
        assert_eq!(counts.shadow_rays + counts.lights_open + counts.lights_unseen, 192, "{pigment}");
        assert!((1..192).contains(&counts.lights_unseen), "{pigment}: {}", counts.lights_unseen);
    }
    assert_eq!(mirror("diffuse .1", "rgb 1").lights_unseen, 0);
    // What lets all light pass scatters none.
    assert_ne!(mirror("diffuse .1", "rgbt 1").lights_unseen, 0);
}

#[test]
fn dark_and_faded_lights_cost_nothing() {
    for light in [
        "light_source{0 rgb 0}",
        "light_source{0 rgb 1e-12}",
        "light_source{0 rgb 1 fade_distance 1e-3 fade_power 9}",
        "light_source{0 rgb 1 cylinder point_at z radius .001 falloff .001 translate 9*x}",
        "light_source{0 rgb 1 spotlight point_at -z}",
        "light_source{-9*z rgb 1 parallel point_at -12*z cylinder radius 1 falloff 1}",
    ] {
        let counts = statistics(&format!("{light} FLOOR"));
        assert_eq!((counts.shadow_rays, counts.lights_dark), (0, 192), "{light}");
    }
}

#[test]
fn where_there_are_no_media_none_are_walked_through() {
    let ball = |more: &str| {
        format!("light_source{{-9*z rgb 1}} FLOOR sphere{{4*z,1 hollow pigment{{rgbt 1}} {more}}}")
    };
    let walked = |more: &str| statistics(&ball(more)).media_stretches;
    assert_eq!(walked(""), 0);
    assert_eq!(walked("interior{ior 1.1 fade_distance 1 fade_power 1}"), 0);
    // Those inside one object are walked through there, and nowhere else.
    let inside = walked("interior{media{emission 1}}");
    assert!((1..192).contains(&inside), "{inside}");
    // Media keep out of what isn't hollow, and of the air around.
    assert_eq!(statistics(&ball("interior{media{emission 1}}").replace("hollow", "")).media_stretches, 0);
}

#[test]
fn lights_out_of_reach_cost_nothing() {
    let spot = "light_source{<0,0,0> rgb 1 spotlight point_at -z radius 10 falloff 20} FLOOR";
    assert_eq!(statistics(spot).shadow_rays, 0);
}

#[test]
fn only_the_nearest_surface_is_textured() {
    let hidden = "FLOOR plane{-z,-6 pigment{rgb 1}} plane{-z,-7 pigment{rgb 1}}";
    assert_eq!(statistics(hidden).texture_evaluations, 192);
}

#[test]
fn opaque_blockers_are_not_textured() {
    let counts = statistics("light_source{-10*z rgb 1} FLOOR disc{-2*z,z,30 pigment{rgb 1}}");
    assert_eq!((counts.shadow_rays, counts.shadow_textures), (192, 0));
    let clear = statistics("light_source{-10*z rgb 1} FLOOR disc{-2*z,z,30 pigment{rgbt .5}}");
    assert_eq!(clear.shadow_textures, 192);
}

#[test]
fn faint_reflections_are_not_traced() {
    let faint = "WALL(pigment{rgb 1} finish{reflection .003})";
    let counts = statistics(faint);
    assert_eq!((counts.reflected_rays, counts.bailed_out), (0, 192));
    assert_eq!(statistics("WALL(pigment{rgb 1} finish{reflection 0})").bailed_out, 0);
}

#[test]
fn a_blend_of_clear_textures_goes_on_once() {
    let blend = "plane{z,5 texture{average texture_map{[1 pigment{rgbt 1}][1 pigment{rgbt .5}]}}} \
        plane{z,6 pigment{rgb 1}}";
    assert_eq!(statistics(blend).transmitted_rays, 192);
}

#[test]
fn straight_ways_are_followed_without_end_and_without_levels() {
    let panes: String = (0..3000).map(|i| format!("plane{{z,{} pigment{{rgbt 1}}}}\n", 5 + i)).collect();
    let options = RenderOptions::new(1, 1);
    let rendered = picture(&scene(&format!("background{{rgb .5}} {panes}"), "3.7"), &options).unwrap();
    assert_eq!(rendered.image.pixels[0], [0.5, 0.5, 0.5, 1.0]);
    assert_eq!(rendered.statistics.transmitted_rays, 3000);
}

/// A wall in a texture, seen by 192 rays.
fn wall(texture: &str) -> Statistics {
    statistics(&format!("plane{{z,5 {texture}}}"))
}

#[test]
fn a_scene_of_plain_colours_evaluates_nothing_else() {
    let counts = wall("pigment{rgb <1,.5,.2>}");
    assert_eq!((counts.texture_evaluations, counts.patterns, counts.bumps, counts.functions), (192, 0, 0, 0));
    assert_eq!((counts.noise, counts.vector_noise, counts.image_lookups, counts.images), (0, 0, 0, 0));
    assert_eq!(counts.texture_coordinates, 0);
}

#[test]
fn what_is_evaluated_is_counted() {
    let counts = wall("texture{pigment{granite turbulence .5 octaves 3} normal{bumps .3}}");
    assert_eq!((counts.patterns, counts.bumps, counts.noise), (192, 192, 192 * 6));
    assert_eq!(counts.vector_noise, 192 * (3 + 1));
    let called = wall("pigment{function{x+y}}").functions;
    assert!(called >= 192, "{called} calls");
    let mapped = "sphere{5*z,3 pigment{uv_mapping checker rgb 0 rgb 1}}";
    let counts = statistics(mapped);
    assert!(counts.texture_coordinates > 0 && counts.texture_coordinates == counts.texture_evaluations);
}

#[test]
fn what_is_not_near_a_ray_is_not_asked() {
    let balls =
        |count: usize| (0..count).map(|i| format!("sphere{{<{},50,9>,1}}", 3 * i)).collect::<String>();
    // Boxes are held against tiles of pixels, eight at a time.
    let few = statistics(&format!("{} FLOOR", balls(5)));
    assert_eq!((few.boxes, few.primitives), (4 * 8, 192));
    let many = statistics(&format!("{} FLOOR", balls(500)));
    assert!(many.boxes <= 192 * 8 && many.primitives == 192, "{many:?}");
}

#[test]
fn turbulence_without_an_amount_is_not_evaluated() {
    for pattern in [
        "bozo turbulence 0",
        "bozo warp{turbulence 0}",
        "gradient x turbulence <0,0,0>",
        "wood turbulence 0",
        "marble turbulence 0",
        "spiral1 3 turbulence 0",
        "agate agate_turb 0",
    ] {
        let counts = wall(&format!("pigment{{{pattern} color_map{{[0 rgb 0][1 rgb 1]}}}}"));
        let of_bozo = if pattern.starts_with("bozo") { 192 } else { 0 };
        assert_eq!((counts.vector_noise, counts.noise), (0, of_bozo), "{pattern}");
    }
    assert_eq!(wall("pigment{bozo turbulence .1}").vector_noise, 192 * 6);
}

#[test]
fn bumps_without_a_height_are_not_made() {
    for normal in
        ["bumps 0", "granite 0", "wrinkles bump_size 0", "gradient y 0 slope_map{[0 <0,1>][1 <1,0>]}"]
    {
        let counts = wall(&format!("pigment{{rgb 1}} normal{{{normal}}}"));
        assert_eq!((counts.bumps, counts.vector_noise, counts.noise), (0, 0, 0), "{normal}");
    }
    // Facets are flat pieces of a size, whatever their height.
    assert_eq!(wall("pigment{rgb 1} normal{facets 0 size 1}").bumps, 192);
}

#[test]
fn what_has_no_weight_is_not_evaluated() {
    let low = "gradient z scale 100";
    for texture in [
        format!(
            "texture{{{low} texture_map{{[.5 pigment{{rgb 1}}][.5 pigment{{granite}} normal{{bumps}}]}}}}"
        ),
        format!("pigment{{{low} pigment_map{{[.5 rgb 1][.5 granite]}}}}"),
        format!("pigment{{rgb 1}} normal{{{low} normal_map{{[.5 facets size 1][.5 bumps]}}}}"),
        "texture{average texture_map{[1 pigment{rgb 1}][0 pigment{granite} normal{bumps}]}}".to_owned(),
        "pigment{average pigment_map{[1 rgb 1][0 granite]}}".to_owned(),
        "pigment{rgb 1} normal{average normal_map{[1 facets size 1][0 granite]}}".to_owned(),
        "texture{pigment{granite} normal{bumps}} texture{pigment{rgb 1}}".to_owned(),
    ] {
        let counts = wall(&texture);
        assert_eq!((counts.texture_evaluations, counts.noise, counts.vector_noise), (192, 0, 0), "{texture}");
    }
}

#[test]
fn images_that_nothing_shows_are_not_decoded() {
    let folder = tempfile::tempdir().unwrap();
    let file = folder.path().join("two.ppm");
    std::fs::write(&file, "P3\n2 1\n255\n10 20 30  200 100 50\n").unwrap();
    let image = format!("pigment{{image_map{{ppm \"{}\"}}}}", file.display());
    let unused = statistics(&format!("#declare T=texture{{{image}}} plane{{z,5 pigment{{rgb 1}}}}"));
    assert_eq!((unused.images, unused.image_lookups), (0, 0));
    let shown = wall(&image);
    assert_eq!((shown.images, shown.image_lookups, shown.texture_coordinates), (1, 192, 0));
}

/// Mirrors, glass, a jittered area light, grain, antialiasing: everything that asks for numbers.
#[test]
fn threads_do_not_change_the_picture() {
    let busy = "global_settings{max_trace_level 8} \
        light_source{<-5,8,-6> rgb 1 area_light 3*x,3*z,3,3 jitter adaptive 1} \
        plane{y,-1 pigment{checker rgb 1 rgb .2} finish{crand .2 reflection .3}} \
        sphere{<0,0,5>,1 pigment{rgbf <1,.8,.8,.9>} finish{reflection{0,1 fresnel}} interior{ior 1.5}} \
        sphere{<1.5,0,6>,1 pigment{rgb <.3,.5,.9>} finish{phong 1 reflection .4}} \
        sky_sphere{pigment{gradient y}}";
    let text = scene(busy, "3.7");
    let with = |threads| {
        let antialias = Some(Antialias { threshold: 0.1, ..Antialias::default() });
        let options =
            RenderOptions { threads: Some(threads), block_size: 8, antialias, ..RenderOptions::new(60, 45) };
        picture(&text, &options).unwrap()
    };
    let one = with(1);
    for threads in [2, 8] {
        let rendered = with(threads);
        assert!(rendered.image == one.image, "{threads} threads make another picture");
        assert_eq!(rendered.statistics, one.statistics, "{threads} threads");
    }
}

/// A ball of media before a floor, lit by one lamp.
fn media(media: &str, more: &str) -> Statistics {
    let ball = format!("sphere{{4*z,1 hollow pigment{{rgbt 1}} interior{{media{{{media}}}}}}}");
    statistics(&format!("light_source{{<-9,9,-9> rgb 1}} {ball} {more}"))
}

#[test]
fn no_media_are_sampled_where_there_are_none() {
    let counts = statistics("light_source{-10*z rgb 1} FLOOR sphere{4*z,1 hollow pigment{rgbt 1}}");
    assert_eq!((counts.media_stretches, counts.media_samples), (0, 0));
    let beside = statistics("FLOOR sphere{-9*z,1 hollow pigment{rgbt 1} interior{media{emission 1}}}");
    assert_eq!((beside.media_stretches, beside.media_samples), (0, 0));
}

#[test]
fn media_that_are_the_same_everywhere_are_not_sampled() {
    for plain in ["absorption 1", "emission 1 absorption .5", "absorption 1 density{rgb .4}"] {
        let counts = media(plain, "FLOOR");
        assert!(counts.media_stretches > 0, "{plain}");
        assert_eq!(counts.media_samples, 0, "{plain}");
    }
    assert!(media("emission 1 density{spherical}", "FLOOR").media_samples > 0);
}

#[test]
fn media_without_scattering_ask_no_lamp() {
    let counts = media("emission 1 absorption 1 density{spherical}", "");
    assert_eq!((counts.shadow_rays, counts.lights_open), (0, 0));
}

#[test]
fn lamps_with_nothing_between_need_no_shadow_rays() {
    let inside = "light_source{4*z rgb 1} camera{location 3.5*z} \
        sphere{4*z,1 hollow pigment{rgbt 1} interior{media{scattering{1,1}}}} \
        plane{y,-2 pigment{rgb 1} finish{diffuse 0}}";
    let counts = statistics(inside);
    assert_eq!(counts.shadow_rays, 0);
    assert!(counts.lights_open > 1000);
    // What stands aside changes nothing, what stands between does.
    let aside = format!("{inside} sphere{{<8,0,4>,1}}");
    assert_eq!(statistics(&aside).shadow_rays, 0);
    let between = format!("{inside} sphere{{<.05,.03,3.8>,.05}}");
    assert!(statistics(&between).shadow_rays > 0);
}

#[test]
fn lamps_are_asked_for_only_where_something_may_be_between() {
    let open = statistics("light_source{0 rgb 1} FLOOR");
    assert_eq!(open.shadow_rays + open.lights_open, 192);
    assert!(open.shadow_rays < 60, "{}", open.shadow_rays);
    // A ball aside changes nothing, one between does.
    let with = |place: &str| statistics(&format!("light_source{{0 rgb 1}} FLOOR sphere{{{place},.3}}"));
    assert_eq!(with("<9,9,-9>").shadow_rays, open.shadow_rays);
    assert!(with("2*z").shadow_rays > open.shadow_rays);
}

#[test]
fn clear_surfaces_are_not_textured() {
    let counts = media("absorption 1", "");
    assert_eq!((counts.texture_evaluations, counts.shadow_textures, counts.shadow_rays), (0, 0, 0));
    assert!(counts.transmitted_rays > 0);
    let glossy = "sphere{4*z,1 pigment{rgbt 1} finish{specular .5}} light_source{-9*z rgb 1}";
    assert!(statistics(glossy).texture_evaluations > 0);
}

#[test]
fn area_lights_are_refined_only_where_their_corners_differ() {
    let bare = "FLOOR light_source{-10*z rgb 1 area_light 2*x,2*y,17,17 adaptive 1}";
    let counts = statistics(bare);
    assert_eq!((counts.shadow_rays, counts.lights_open), (0, 192));
    // All light comes through the hole of a ring.
    let floor = &format!("{bare} disc{{-2*z,z,60,50}}");
    let even = statistics(floor).shadow_rays;
    // Nine places of the grid are the corners of its four quarters.
    assert_eq!(even, 9 * 192);
    // However many there are, and whatever stands aside.
    assert_eq!(statistics(&floor.replace("17,17", "65,65")).shadow_rays, even);
    assert_eq!(statistics(&format!("{floor} sphere{{<9,9,-5>,1}}")).shadow_rays, even);
    assert!(statistics(&format!("{floor} disc{{<.3,.2,-2>,z,.5}}")).shadow_rays > even);
}
