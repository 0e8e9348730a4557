//! User functions print the same numbers with both programs: every internal function of functions.inc, pattern,
//! pigment, spline and transform functions, all operators and built-ins, and calls outside of their domains.

use std::fmt::Write;
use std::fs;
use std::path::Path;
use std::process::Command;

use povista_compat::program::Program;
use povista_compat::scene::Places;

/// Points each function is asked at.
const POINTS: usize = 1000;

/// Difference allowed, relative to the value where that is greater than 1.
const NEAR: f64 = 1e-9;

/// Parameters of the functions made of noise, which at random would be mostly senseless.
const OF_NOISE: [(&str, &str); 4] = [
    ("f_hetero_mf", "0.8, 2.1, 3.5, 0.6, 2, mod(I, 4)"),
    ("f_ridge", "2, 3.25, 0.5, 0.4, 0.6, mod(I, 4)"),
    ("f_ridged_mf", "0.8, 2.1, 4, 1, 2, mod(I, 4)"),
    ("f_noise_generator", "mod(I, 4)"),
];

/// What functions other than numbers can be made of, and the components they give.
const SPECIAL: [(&str, &str, &[&str]); 9] = [
    ("x, y, z", "pattern { granite turbulence 0.3 scale 0.7 sine_wave frequency 2 }", &[""]),
    ("x, y, z", "pattern { crackle form <-1, 1, 0> metric 3 rotate 20 }", &[""]),
    ("x, y, z", "pattern { wood turbulence 0.2 warp { repeat x flip x } }", &[""]),
    (
        "x, y, z",
        "pigment { bozo color_map { [0.2 rgb <1, 0.5, 0.25>] [0.6 rgbft <0.1, 0.2, 0.3, 0.4, 0.5>] } }",
        &[".red", ".green", ".blue", ".filter", ".transmit", ".gray"],
    ),
    ("x, y, z", "transform { rotate <10, 20, 30> scale <1, 2, 3> translate x }", &[".x", ".y", ".z"]),
    ("x", "spline { linear_spline -1, <1, 2, 3>, 0, <3, 2, 0>, 1.5, <0, 1, 7> }", &[".x", ".y", ".z"]),
    ("x", "spline { quadratic_spline -1, <1, 2>, 0, <3, 2>, 1, <4, 4>, 2, <0, 1> }", &[".u", ".v"]),
    ("x", "spline { cubic_spline -2, <1, 2, 3>, -1, <0, 0, 1>, 0, <3, 2, 0>, 1, <0, 1, 7>, 2, x }", &[".y"]),
    ("x", "spline { natural_spline -2, <1, 2, 3>, -1, <0, 0, 1>, 0, <3, 2, 0>, 1, <0, 1, 7> }", &[".z"]),
];

/// Operators and built-ins as bodies of functions of x, y and z.
const BODIES: [&str; 60] = [
    "x + y - z * x / 3 - -y",
    "x / y / z",
    "x - y - z",
    "2 * (x + y) * (x - z)",
    "-x * -y + -(z - 1)",
    "(x < y) + 2 * (y < z)",
    "(x <= y) + (x >= z)",
    "(x > y) * 3 - (x = y)",
    "(x != y) + (x = x)",
    "(x & y) + 2 * (x | z)",
    "(x < 0 & y < 0) + (x > 0 | y > 0)",
    "(floor(x) & floor(y)) + (int(x) | int(z))",
    "abs(x) - abs(y)",
    "acos(x / 3)",
    "acosh(1 + abs(x))",
    "asin(y / 3)",
    "asinh(x)",
    "atan(x)",
    "atanh(z / 3)",
    "atan2(x, y)",
    "ceil(x) + ceil(-y)",
    "cos(x)",
    "cosh(x)",
    "degrees(x)",
    "radians(y)",
    "div(x * 9, y)",
    "exp(x)",
    "floor(x) - floor(y)",
    "int(x * 5)",
    "ln(abs(x))",
    "log(abs(y))",
    "max(x, y)",
    "max(x, y, z, 0.5)",
    "min(x, y)",
    "min(x, y, z, -0.5)",
    "mod(x * 7, y)",
    "pow(abs(x), y)",
    "pow(x, 0)",
    "pow(x, 1)",
    "pow(x, 2)",
    "pow(x, 3)",
    "pow(x, 5)",
    "pow(x, 8)",
    "pow(x, 11)",
    "pow(x, -2)",
    "pow(abs(x), 0.5)",
    "select(x, y, z)",
    "select(floor(x), y, z, x)",
    "sin(x)",
    "sinh(x)",
    "sqrt(abs(x))",
    "tan(x)",
    "tanh(x)",
    "sum(i, 1, 5, i * x + sin(i * y))",
    "prod(i, 1, 4, x + i)",
    "sum(i, 1, 3, sum(j, 1, i, j * x))",
    "f_r(x, y, z) + f_sphere(y, z, x, 0.5)",
    "f_noise3d(x, y, z) * f_snoise3d(z, y, x)",
    "f_granite(x, y, z) + f_bozo(x, y, z)",
    "sqrt(x * x + y * y) - 0.3 * sin(atan2(x, y) * 5 + z * pi)",
];

/// Calls outside of the domain of something: POV-Ray says nothing, and both give the same.
const OUTSIDE: [(&str, &str); 24] = [
    ("sqrt(x)", "-1"),
    ("ln(x)", "0"),
    ("ln(x)", "-1"),
    ("log(x)", "0"),
    ("acos(x)", "2"),
    ("asin(x)", "-2"),
    ("acosh(x)", "0.5"),
    ("atanh(x)", "1"),
    ("atanh(x)", "2"),
    ("pow(x, 0.5)", "-2"),
    ("pow(0, x)", "-1"),
    ("pow(x, x)", "0"),
    ("atan2(x, x)", "0"),
    ("1 / x", "0"),
    ("-1 / x", "0"),
    ("x / x", "0"),
    ("mod(5, x)", "0"),
    ("div(5, x)", "0"),
    ("int(x)", "1e12"),
    ("int(x)", "-1e12"),
    ("exp(x)", "1000"),
    ("x * x", "1e200"),
    ("max(x, sqrt(x))", "-1"),
    ("select(sqrt(x), 1, 2, 3)", "-1"),
];

/// Names and numbers of parameters of the internal functions, from the table that describes them.
fn internal() -> Vec<(String, usize)> {
    let language = fs::read_to_string(Places::here().repository.join("docs/spec/language.md")).unwrap();
    let rows = language.lines().filter_map(|line| {
        let cells: Vec<&str> = line.trim_matches('|').split(" | ").map(str::trim).collect();
        let [_, name, count, ..] = cells[..] else { return None };
        Some((name.to_owned(), count.parse().ok()?))
    });
    rows.filter(|(name, _)| name.starts_with("f_")).collect()
}

/// A scene that writes a line for each value: what it is of, and the number.
fn scene() -> String {
    let mut text = String::from(
        "#version 3.7;\nglobal_settings { assumed_gamma 1 }\n#include \"functions.inc\"\ncamera { }\n\
         #declare S = seed(7);\n#macro P() (4 * rand(S) - 2) #end\n#macro Q() (0.3 + 1.4 * rand(S)) #end\n\
         #fopen OUT \"values.txt\" write\n#macro Show(Name, V) #write(OUT, Name, \" \", str(V, 0, 17), \"\\n\") #end\n",
    );
    let mut show = |name: &str, call: &str| {
        writeln!(text, "#for (I, 1, {POINTS}) Show(\"{name}\", {call}) #end").unwrap();
    };
    for (name, count) in internal() {
        let known = OF_NOISE.iter().find(|(of, _)| *of == name).map(|(_, parameters)| *parameters);
        let parameters = match known {
            Some(parameters) => format!(", {parameters}"),
            None => ", Q()".repeat(count),
        };
        show(&name, &format!("{name}(P(), P(), P(){parameters})"));
    }
    let mut declared = String::new();
    for (number, (parameters, body, members)) in SPECIAL.iter().enumerate() {
        writeln!(declared, "#declare Special{number} = function {{ {body} }}").unwrap();
        let points = vec!["P()"; parameters.split(',').count()].join(", ");
        for member in *members {
            show(&format!("special{number}{member}"), &format!("Special{number}({points}){member}"));
        }
    }
    for (number, body) in BODIES.iter().enumerate() {
        writeln!(declared, "#declare Body{number} = function(x, y, z) {{ {body} }}").unwrap();
        show(&format!("body{number}"), &format!("Body{number}(P(), P(), P())"));
    }
    for (number, (body, at)) in OUTSIDE.iter().enumerate() {
        writeln!(declared, "#declare Outside{number} = function(x) {{ {body} }}").unwrap();
        writeln!(text, "Show(\"outside{number}\", Outside{number}({at}))").unwrap();
    }
    text.push_str("#fclose OUT\n");
    text.replacen("#declare S =", &format!("{declared}#declare S ="), 1)
}

/// What `program` writes for the scene: a name and a number on each line.
fn values(program: &Program, folder: &Path, text: &str) -> Vec<String> {
    fs::create_dir_all(folder).unwrap();
    fs::write(folder.join("functions.pov"), text).unwrap();
    let arguments = ["+Ifunctions.pov", "+W1", "+H1", "-D", "-F", "+WT1"];
    let output = Command::new(&program.path).args(arguments).current_dir(folder).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    let written = fs::read_to_string(folder.join("values.txt"));
    let written =
        written.unwrap_or_else(|error| panic!("{} wrote nothing ({error}): {said}", program.version));
    assert!(output.status.success(), "{}: {said}", program.version);
    written.lines().map(str::to_owned).collect()
}

/// What a line is about: the text of the function instead of its number.
fn about(name: &str) -> String {
    let number = |prefix: &str| name.strip_prefix(prefix).and_then(|number| number.parse::<usize>().ok());
    match (number("body"), number("outside")) {
        (Some(number), _) => BODIES[number].to_owned(),
        (_, Some(number)) => format!("{} at {}", OUTSIDE[number].0, OUTSIDE[number].1),
        _ => name.to_owned(),
    }
}

/// Whether two printed numbers are the same for all purposes; of what is no number only that counts.
fn same(a: &str, b: &str) -> bool {
    match (a.parse::<f64>(), b.parse::<f64>()) {
        (Ok(a), Ok(b)) if a.is_finite() && b.is_finite() => (a - b).abs() <= NEAR * a.abs().max(1.0),
        (Ok(a), Ok(b)) => a == b || (a.is_nan() && b.is_nan()),
        _ => a.trim_start_matches('-') == b.trim_start_matches('-'),
    }
}

#[test]
fn functions_give_the_same_numbers() {
    let names = internal();
    assert!(names.len() >= 78, "only {} internal functions are described", names.len());
    let folder = tempfile::tempdir().unwrap();
    let text = scene();
    let povray = Program::povray().unwrap_or_else(|error| panic!("{error}"));
    let povista = Program::povista().unwrap_or_else(|error| panic!("{error}"));
    let expected = values(&povray, &folder.path().join("povray"), &text);
    let found = values(&povista, &folder.path().join("povista"), &text);
    assert_eq!(found.len(), expected.len());
    assert!(found.len() > (names.len() + BODIES.len()) * POINTS);
    let mut wrong: Vec<(String, usize, String)> = Vec::new();
    for (found, expected) in found.iter().zip(&expected) {
        let ((name, found), (of, expected)) =
            (found.split_once(' ').unwrap(), expected.split_once(' ').unwrap());
        assert_eq!(name, of);
        if !same(found, expected) {
            match wrong.iter_mut().find(|(known, _, _)| known == name) {
                Some((_, count, _)) => *count += 1,
                None => wrong.push((name.to_owned(), 1, format!("{found}, not {expected}"))),
            }
        }
    }
    let lines: Vec<String> = wrong
        .iter()
        .map(|(name, count, first)| format!("{}: {count} differ, the first is {first}", about(name)))
        .collect();
    assert!(lines.is_empty(), "{}", lines.join("\n"));
}
