use super::probe;

#[test]
fn nothing_nests_without_end() {
    let many = 1_000_000;
    probe(&[
        (&format!("F({}", "(".repeat(many)), "E"),
        (&format!("F({}1)", "-".repeat(many)), "E"),
        (&"/*".repeat(many), "E"),
        (&"#if(1)".repeat(many), "E"),
        (&"#macro M()".repeat(10_000), "E"),
        (&"<".repeat(many), "E"),
        (&"A[".repeat(10_000), "E"),
        ("#declare A=array[1]{1} F(A[A[A[A[0]-1]-1]-1])", "1"),
        (&"#declare A=".repeat(10_000), "E"),
        (&"{".repeat(many), "E"),
        (&"union {".repeat(many), "E"),
        (&format!("sphere {{ 0, 1 {}", "pigment { checker ".repeat(many / 10)), "E"),
        (&"texture { gradient x texture_map { [0 ".repeat(many / 10), "E"),
        (&"normal { average normal_map { [1 ".repeat(many / 10), "E"),
    ]);
}

#[test]
fn what_is_no_text_is_no_scene() {
    use povista::interp::check::check_with;
    let bytes: Vec<u8> = (0..4096_u32).map(|n| (n.wrapping_mul(2_654_435_761) >> 13) as u8).collect();
    let source = povista::source::Source::new("noise.pov", "", bytes);
    let checked = check_with(source, Default::default(), &Default::default());
    assert!(checked.failed());
    assert_eq!(checked.diagnostics.len(), 1, "{checked}");
}
