//! The reserved words, docs/spec/language.md 1.7.

use crate::syntax::{Symbol, Symbols};

/// Declares the enum and the table of its spellings in one go.
macro_rules! words {
    ($($word:ident = $text:literal),* $(,)?) => {
        /// A reserved word, named after its spelling: `sky_sphere` is `SkySphere`.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[expect(missing_docs, reason = "each is the word it is named after")]
        pub enum Word { $($word),* }

        /// Every reserved word with its spelling, in the order of the enum.
        const WORDS: &[(Word, &str)] = &[$((Word::$word, $text)),*];
    };
}

impl Word {
    /// The interner of a run: reserved words have the first symbols.
    pub fn symbols() -> Symbols {
        Symbols::new(WORDS.iter().map(|&(_, text)| text))
    }

    /// The reserved word behind a symbol; `None` when it is a free name.
    #[inline]
    pub fn of(symbol: Symbol) -> Option<Word> {
        WORDS.get(symbol.0 as usize).map(|&(word, _)| word)
    }

    /// Its spelling.
    pub fn text(self) -> &'static str {
        WORDS[self as usize].1
    }

    /// Every spelling.
    pub fn spellings() -> impl Iterator<Item = &'static str> {
        WORDS.iter().map(|&(_, text)| text)
    }
}

#[rustfmt::skip]
words! {
    AaLevel = "aa_level", AaThreshold = "aa_threshold", Abs = "abs", Absorption = "absorption",
    Accuracy = "accuracy", Acos = "acos", Acosh = "acosh", Adaptive = "adaptive",
    AdcBailout = "adc_bailout", Agate = "agate", AgateTurb = "agate_turb", Albedo = "albedo",
    All = "all", AllIntersections = "all_intersections", Alpha = "alpha", Altitude = "altitude",
    AlwaysSample = "always_sample", Ambient = "ambient", AmbientLight = "ambient_light",
    Angle = "angle", Anisotropy = "anisotropy", Aoi = "aoi", Aperture = "aperture",
    Append = "append", ArcAngle = "arc_angle", AreaIllumination = "area_illumination",
    AreaLight = "area_light", Array = "array", Asc = "asc", Ascii = "ascii", Asin = "asin",
    Asinh = "asinh", AssumedGamma = "assumed_gamma", Atan = "atan", Atan2 = "atan2",
    Atanh = "atanh", Autostop = "autostop", Average = "average", BSpline = "b_spline",
    Background = "background", BezierSpline = "bezier_spline", BicubicPatch = "bicubic_patch",
    BitwiseAnd = "bitwise_and", BitwiseOr = "bitwise_or", BitwiseXor = "bitwise_xor",
    BlackHole = "black_hole", Blob = "blob", Blue = "blue", BlurSamples = "blur_samples",
    Bmp = "bmp", Bokeh = "bokeh", BoundedBy = "bounded_by", Box = "box", Boxed = "boxed",
    Bozo = "bozo", Break = "break", Brick = "brick", BrickSize = "brick_size",
    Brightness = "brightness", Brilliance = "brilliance", BumpMap = "bump_map",
    BumpSize = "bump_size", Bumps = "bumps", Camera = "camera", Case = "case",
    Caustics = "caustics", Ceil = "ceil", Cells = "cells", Charset = "charset", Checker = "checker",
    Chr = "chr", Circular = "circular", ClippedBy = "clipped_by", Clock = "clock",
    ClockOn = "clock_on", Collect = "collect", Color = "color", ColorMap = "color_map",
    Colour = "colour", ColourMap = "colour_map", Component = "component", Composite = "composite",
    Concat = "concat", Cone = "cone", Confidence = "confidence", ConicSweep = "conic_sweep",
    ConserveEnergy = "conserve_energy", ContainedBy = "contained_by", Control0 = "control0",
    Control1 = "control1", Coords = "coords", Cos = "cos", Cosh = "cosh", Count = "count",
    Crackle = "crackle", Crand = "crand", Cube = "cube", Cubic = "cubic",
    CubicSpline = "cubic_spline", CubicWave = "cubic_wave", CutawayTextures = "cutaway_textures",
    Cylinder = "cylinder", Cylindrical = "cylindrical", Datetime = "datetime", Debug = "debug",
    Declare = "declare", Default = "default", Defined = "defined", Degrees = "degrees",
    Density = "density", DensityFile = "density_file", DensityMap = "density_map", Dents = "dents",
    Deprecated = "deprecated", Df3 = "df3", Difference = "difference", Diffuse = "diffuse",
    DimensionSize = "dimension_size", Dimensions = "dimensions", Direction = "direction",
    Disc = "disc", Dispersion = "dispersion", DispersionSamples = "dispersion_samples",
    DistExp = "dist_exp", Distance = "distance", Div = "div",
    DoubleIlluminate = "double_illuminate", Dtag = "dtag", Eccentricity = "eccentricity",
    Else = "else", Elseif = "elseif", Emission = "emission", End = "end", Error = "error",
    ErrorBound = "error_bound", Evaluate = "evaluate", Exp = "exp",
    ExpandThresholds = "expand_thresholds", Exponent = "exponent", Exr = "exr",
    Exterior = "exterior", Extinction = "extinction", FaceIndices = "face_indices",
    Facets = "facets", FadeColor = "fade_color", FadeColour = "fade_colour",
    FadeDistance = "fade_distance", FadePower = "fade_power", Falloff = "falloff",
    FalloffAngle = "falloff_angle", False = "false", Fclose = "fclose", FileExists = "file_exists",
    Filter = "filter", Finish = "finish", Fisheye = "fisheye", Flatness = "flatness", Flip = "flip",
    Floor = "floor", FocalPoint = "focal_point", Fog = "fog", FogAlt = "fog_alt",
    FogOffset = "fog_offset", FogType = "fog_type", Fopen = "fopen", For = "for", Form = "form",
    Frequency = "frequency", Fresnel = "fresnel", Function = "function", Gamma = "gamma",
    Gather = "gather", Gif = "gif", GlobalLights = "global_lights",
    GlobalSettings = "global_settings", Gradient = "gradient", Granite = "granite", Gray = "gray",
    GrayThreshold = "gray_threshold", Green = "green", Hdr = "hdr", HeightField = "height_field",
    Hexagon = "hexagon", HfGray16 = "hf_gray_16", Hierarchy = "hierarchy", Hollow = "hollow",
    Hypercomplex = "hypercomplex", If = "if", Ifdef = "ifdef", Iff = "iff", Ifndef = "ifndef",
    ImageMap = "image_map", ImagePattern = "image_pattern", Importance = "importance",
    Include = "include", Inside = "inside", InsideVector = "inside_vector", Int = "int",
    Interior = "interior", InteriorTexture = "interior_texture", Internal = "internal",
    Interpolate = "interpolate", Intersection = "intersection", Intervals = "intervals",
    Inverse = "inverse", Ior = "ior", Irid = "irid", IridWavelength = "irid_wavelength",
    Isosurface = "isosurface", Jitter = "jitter", Jpeg = "jpeg", Julia = "julia",
    JuliaFractal = "julia_fractal", Lambda = "lambda", Lathe = "lathe", Leopard = "leopard",
    LightGroup = "light_group", LightSource = "light_source", LinearSpline = "linear_spline",
    LinearSweep = "linear_sweep", Ln = "ln", LoadFile = "load_file", Local = "local",
    Location = "location", Log = "log", LookAt = "look_at", LooksLike = "looks_like",
    LowErrorFactor = "low_error_factor", Macro = "macro", Magnet = "magnet",
    MajorRadius = "major_radius", Mandel = "mandel", MapType = "map_type", Marble = "marble",
    Material = "material", MaterialMap = "material_map", Matrix = "matrix", Max = "max",
    MaxExtent = "max_extent", MaxGradient = "max_gradient", MaxIntersections = "max_intersections",
    MaxIteration = "max_iteration", MaxSample = "max_sample", MaxTrace = "max_trace",
    MaxTraceLevel = "max_trace_level", MaximumReuse = "maximum_reuse", Media = "media",
    MediaAttenuation = "media_attenuation", MediaInteraction = "media_interaction", Merge = "merge",
    Mesh = "mesh", Mesh2 = "mesh2", MeshCamera = "mesh_camera", Metallic = "metallic",
    Method = "method", Metric = "metric", Min = "min", MinExtent = "min_extent",
    MinimumReuse = "minimum_reuse", MmPerUnit = "mm_per_unit", Mod = "mod", Mortar = "mortar",
    NaturalSpline = "natural_spline", NearestCount = "nearest_count", No = "no",
    NoBumpScale = "no_bump_scale", NoImage = "no_image", NoRadiosity = "no_radiosity",
    NoReflection = "no_reflection", NoShadow = "no_shadow", NoiseGenerator = "noise_generator",
    Normal = "normal", NormalIndices = "normal_indices", NormalMap = "normal_map",
    NormalVectors = "normal_vectors", Now = "now", NumberOfSides = "number_of_sides",
    NumberOfTiles = "number_of_tiles", NumberOfWaves = "number_of_waves", Object = "object",
    Octaves = "octaves", Off = "off", Offset = "offset", Omega = "omega", Omnimax = "omnimax",
    On = "on", Once = "once", Onion = "onion", Open = "open", Orient = "orient",
    Orientation = "orientation", Orthographic = "orthographic", Ovus = "ovus",
    Panoramic = "panoramic", Parallel = "parallel", Parametric = "parametric",
    PassThrough = "pass_through", Pattern = "pattern", Pavement = "pavement",
    Perspective = "perspective", Pgm = "pgm", Phase = "phase", Phong = "phong",
    PhongSize = "phong_size", Photons = "photons", Pi = "pi", Pigment = "pigment",
    PigmentMap = "pigment_map", PigmentPattern = "pigment_pattern", Planar = "planar",
    Plane = "plane", Png = "png", PointAt = "point_at", Poly = "poly", PolyWave = "poly_wave",
    Polygon = "polygon", Polynomial = "polynomial", Pot = "pot", Pow = "pow", Ppm = "ppm",
    Precision = "precision", Precompute = "precompute", Premultiplied = "premultiplied",
    PretraceEnd = "pretrace_end", PretraceStart = "pretrace_start", Prism = "prism", Prod = "prod",
    ProjectedThrough = "projected_through", Pwr = "pwr", QuadraticSpline = "quadratic_spline",
    Quadric = "quadric", Quartic = "quartic", Quaternion = "quaternion", QuickColor = "quick_color",
    QuickColour = "quick_colour", Quilted = "quilted", Radial = "radial", Radians = "radians",
    Radiosity = "radiosity", Radius = "radius", Rainbow = "rainbow", RampWave = "ramp_wave",
    Rand = "rand", Range = "range", Ratio = "ratio", Read = "read", Reciprocal = "reciprocal",
    RecursionLimit = "recursion_limit", Red = "red", Reflection = "reflection",
    ReflectionExponent = "reflection_exponent", Refraction = "refraction", Render = "render",
    Repeat = "repeat", Rgb = "rgb", Rgbf = "rgbf", Rgbft = "rgbft", Rgbt = "rgbt", Right = "right",
    Ripples = "ripples", Rotate = "rotate", Roughness = "roughness", Samples = "samples",
    SaveFile = "save_file", Scale = "scale", ScallopWave = "scallop_wave",
    Scattering = "scattering", Seed = "seed", Select = "select", Shadowless = "shadowless",
    Sin = "sin", SineWave = "sine_wave", Sinh = "sinh", Sint16be = "sint16be",
    Sint16le = "sint16le", Sint32be = "sint32be", Sint32le = "sint32le", Sint8 = "sint8",
    Size = "size", Sky = "sky", SkySphere = "sky_sphere", Slice = "slice", Slope = "slope",
    SlopeMap = "slope_map", Smooth = "smooth", SmoothTriangle = "smooth_triangle", Solid = "solid",
    Sor = "sor", Spacing = "spacing", Specular = "specular", Sphere = "sphere",
    SphereSweep = "sphere_sweep", Spherical = "spherical", Spiral1 = "spiral1", Spiral2 = "spiral2",
    Spline = "spline", SplitUnion = "split_union", Spotlight = "spotlight", Spotted = "spotted",
    Sqr = "sqr", Sqrt = "sqrt", Square = "square", Srgb = "srgb", Srgbf = "srgbf",
    Srgbft = "srgbft", Srgbt = "srgbt", Statistics = "statistics", Steps = "steps", Str = "str",
    Strcmp = "strcmp", Strength = "strength", Strlen = "strlen", Strlwr = "strlwr",
    Strupr = "strupr", Sturm = "sturm", Substr = "substr", Subsurface = "subsurface", Sum = "sum",
    Superellipsoid = "superellipsoid", Switch = "switch", Sys = "sys", T = "t", Tan = "tan",
    Tanh = "tanh", Target = "target", Text = "text", Texture = "texture",
    TextureList = "texture_list", TextureMap = "texture_map", Tga = "tga", Thickness = "thickness",
    Threshold = "threshold", Tiff = "tiff", Tightness = "tightness", Tile2 = "tile2",
    Tiles = "tiles", Tiling = "tiling", Tolerance = "tolerance", Toroidal = "toroidal",
    Torus = "torus", Trace = "trace", Transform = "transform", Translate = "translate",
    Translucency = "translucency", Transmit = "transmit", Triangle = "triangle",
    TriangleWave = "triangle_wave", Triangular = "triangular", True = "true", Ttf = "ttf",
    TurbDepth = "turb_depth", Turbulence = "turbulence", Type = "type", U = "u", USteps = "u_steps",
    Uint16be = "uint16be", Uint16le = "uint16le", Uint8 = "uint8",
    UltraWideAngle = "ultra_wide_angle", Undef = "undef", Union = "union", Up = "up",
    UseAlpha = "use_alpha", UseColor = "use_color", UseColour = "use_colour",
    UseIndex = "use_index", Utf8 = "utf8", UvIndices = "uv_indices", UvMapping = "uv_mapping",
    UvVectors = "uv_vectors", V = "v", VSteps = "v_steps", Val = "val", Variance = "variance",
    VaxisRotate = "vaxis_rotate", Vcross = "vcross", Vdot = "vdot", Version = "version",
    VertexVectors = "vertex_vectors", Vlength = "vlength", Vnormalize = "vnormalize",
    Vrotate = "vrotate", Vstr = "vstr", Vturbulence = "vturbulence", Warning = "warning",
    Warp = "warp", WaterLevel = "water_level", Waves = "waves", While = "while", Width = "width",
    Wood = "wood", Wrinkles = "wrinkles", Write = "write", X = "x", Xyz = "xyz", Y = "y",
    Yes = "yes", Z = "z",
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_are_found_by_their_spelling_and_case_counts() {
        let mut symbols = Word::symbols();
        let sphere = symbols.intern("sphere");
        assert_eq!(Word::of(sphere), Some(Word::Sphere));
        let other = symbols.intern("Sphere");
        assert_eq!(Word::of(other), None);
    }

    #[test]
    fn the_table_is_in_the_order_of_the_enum() {
        for (index, &(word, _)) in WORDS.iter().enumerate() {
            assert_eq!(word as usize, index);
        }
    }
}
