//! What there is to say about single words.

/// Something POV-Ray renders and povista may not yet.
pub(super) struct Feature {
    pub(super) name: &'static str,
    /// A scene that needs it; `compile` knows whether it is missing.
    pub(super) scene: &'static str,
    /// The words that mean nothing without it.
    pub(super) words: &'static [&'static str],
}

/// What may be missing.
pub(super) const FEATURES: &[Feature] = &[
    Feature {
        name: "radiosity",
        scene: "#version 3.7; global_settings { assumed_gamma 1 radiosity { adc_bailout 0.01 always_sample off brightness 1 \
                count 35 error_bound 1.8 gray_threshold 0 low_error_factor 0.5 max_sample -1 maximum_reuse 0.2 \
                minimum_reuse 0.015 nearest_count 5 pretrace_start 0.08 pretrace_end 0.04 recursion_limit 2 } } \
                sphere { 0, 1 no_radiosity radiosity { importance 0.5 } }",
        words: &[
            "radiosity",
            "always_sample",
            "brightness",
            "error_bound",
            "gray_threshold",
            "low_error_factor",
            "max_sample",
            "maximum_reuse",
            "minimum_reuse",
            "nearest_count",
            "pretrace_start",
            "pretrace_end",
            "recursion_limit",
            "importance",
            "no_radiosity",
        ],
    },
    Feature {
        name: "photons",
        scene: "#version 3.7; global_settings { assumed_gamma 1 photons { spacing 0.1 gather 20, 100 media 10 \
                autostop 0 expand_thresholds 0.2, 40 max_trace_level 5 radius 0.1, 2 } } \
                sphere { 0, 1 photons { target reflection on refraction on collect off pass_through } } \
                light_source { 9, 1 photons { reflection on refraction on area_light } }",
        words: &["photons", "gather", "autostop", "expand_thresholds", "target", "collect", "pass_through"],
    },
    Feature {
        name: "subsurface",
        scene: "#version 3.7; global_settings { assumed_gamma 1 mm_per_unit 10 subsurface { samples 50, 50 } } \
                sphere { 0, 1 finish { subsurface { translucency 0.1 } } } light_source { 9, 1 }",
        words: &["subsurface", "translucency"],
    },
];

/// Words that are reserved, and nothing else.
pub(super) const IDLE: &[&str] = &["steps"];

/// What povista does differently on purpose.
pub(super) const DIFFERENT: &[(&str, &str)] = &[
    ("area_light", "`jitter` is the same in every run and with any number of threads"),
    ("bounded_by", "never needed: povista finds its own bounds; it is kept where it changes the picture"),
    ("crand", "its grain is the same in every run and with any number of threads"),
    (
        "fopen",
        "writes only below the current folder, the scene's and the picture's, unless `--allow-write` permits another",
    ),
    ("function", "may call itself, if it ends"),
    ("hierarchy", "read and without effect: there always is one"),
    ("include", "looks into the folder of the scene too, last of all"),
    ("internal", "needs POV-Ray's font files"),
    ("jitter", "is the same in every run and with any number of threads"),
    ("macro", "calls inside each other have a limit, and an error that says so"),
    ("render", "as a directive it writes to the debug stream"),
    ("save_file", "read; nothing is written"),
    ("load_file", "read; nothing is loaded"),
    ("split_union", "without effect on the picture"),
    ("statistics", "writes to the debug stream"),
    ("sturm", "read and without effect: povista's solver is exact enough"),
    ("sys", "as a charset it is UTF-8; as a format of images it is refused"),
    ("version", "without its `#` the rest of the scene is read too"),
    ("while", "a loop that provably never ends is an error at once, others are counted"),
];
