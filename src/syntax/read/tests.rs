use super::*;

fn read(text: &str) -> (Tree, Symbols) {
    let mut symbols = Symbols::new([]);
    let tree = parse(FileId(0), &Source::new("a.pov", "", text.into()), &mut symbols);
    (tree, symbols)
}

fn kinds(text: &str) -> Vec<NodeKind> {
    read(text).0.nodes.iter().map(|node| node.kind).collect()
}

#[test]
fn where_a_long_file_is_cut_makes_no_difference() {
    let tail = "#  \n declare A = \"b c\"; /* d \n e */ <1.5, -2e3, 3> 12345 # // f\n macro G() #end";
    let alone = kinds(tail);
    for cut in 0..tail.len() {
        let padded = " ".repeat((1 << 16) - cut) + tail;
        assert_eq!(kinds(&padded).len(), alone.len(), "cut before {:?}", &tail[cut..]);
    }
}

#[test]
fn a_long_line_is_not_cut_inside_a_number() {
    let numbers = 40_000;
    let (tree, _) = read(&"123456,".repeat(numbers));
    assert_eq!(tree.numbers, vec![123456.0; numbers]);
}

#[test]
fn a_vector_of_plain_numbers_is_one_node() {
    let (tree, _) = read("<1, -2.5 , +3e2,> <1 -1 0> <1,2,3,4,5,6> <1,2>= 3");
    let vectors: Vec<NodeKind> =
        tree.nodes.iter().map(|node| node.kind).filter(|kind| matches!(kind, NodeKind::Vector(..))).collect();
    assert_eq!((vectors, &tree.numbers[..3]), (vec![NodeKind::Vector(3, 0)], &[1.0, -2.5, 300.0][..]));
}

#[test]
fn what_is_nested_without_end_is_not_read_to_its_end() {
    for opener in ["(", "{", "[", "#if(1)", "#while(1)"] {
        let (tree, _) = read(&opener.repeat(1_000_000));
        assert_eq!(tree.errors.len(), 1, "{opener}");
        assert!(tree.nodes.len() < 10 * DEEPEST as usize, "{opener}: {}", tree.nodes.len());
    }
}

#[test]
fn comments_nest_but_not_without_end() {
    let nested = |levels: usize| format!("{}{} x", "/*".repeat(levels), "*/".repeat(levels));
    assert!(read(&nested(DEEPEST_COMMENT)).0.errors.is_empty());
    for levels in [DEEPEST_COMMENT + 1, 1_000_000] {
        assert_eq!(read(&nested(levels)).0.errors.len(), 1, "{levels}");
    }
    assert!(read(&"/* a / b */ ".repeat(2000)).0.errors.is_empty());
}

#[test]
fn a_vector_can_be_read_as_marks_and_numbers() {
    let text = "x<1, -.5>y";
    let source = Source::new("a.pov", "", text.into());
    let mut symbols = Symbols::new([]);
    let span = Span { file: FileId(0), start: 1, end: 9 };
    let tree = parse_marks(span, &source, &mut symbols);
    let found: Vec<&str> =
        tree.nodes.iter().map(|node| &text[node.start as usize..node.end as usize]).collect();
    assert_eq!((found, tree.numbers), (vec!["<", "1", ",", "-", ".5", ">"], vec![1.0, 0.5]));
}

#[test]
fn blocks_are_linked_and_what_crosses_files_is_not() {
    let links: Vec<u32> = kinds("#if(1) #else #while(1) #end #end #end #if(0)")
        .into_iter()
        .filter_map(|kind| match kind {
            NodeKind::Directive(_, link) => Some(link),
            _ => None,
        })
        .collect();
    assert_eq!(links, [4, 10, 9, NO_LINK, NO_LINK, NO_LINK, NO_LINK]);
}

/// Reads all of a text by pest.
fn by_pest(text: &str) -> Tree {
    let source = Source::new("a.pov", "", text.into());
    let mut symbols = Symbols::new([]);
    let mut reader = Reader::new(FileId(0), &source, &mut symbols);
    reader.piece(0, source.text());
    crate::syntax::link::link(&mut reader.tree.nodes);
    reader.tree
}

fn assert_read_alike(text: &str, name: &str) {
    let (scanned, parsed) = (read(text).0, by_pest(text));
    for (index, (a, b)) in scanned.nodes.iter().zip(&parsed.nodes).enumerate() {
        assert_eq!(a, b, "node {index} of {name}");
    }
    assert_eq!(scanned.nodes.len(), parsed.nodes.len(), "{name}");
    let bits = |tree: &Tree| tree.numbers.iter().map(|n| n.to_bits()).collect::<Vec<_>>();
    assert_eq!(bits(&scanned), bits(&parsed), "{name}");
    assert_eq!(scanned.errors, parsed.errors, "{name}");
}

#[test]
fn what_is_scanned_is_what_pest_reads() {
    let parts = [
        "1",
        "23.5",
        ".5",
        "2.",
        "1e5",
        "1E-3",
        "1e",
        "1e+",
        "..",
        ".",
        "-",
        "+",
        "<",
        ">",
        "<=",
        "=",
        ",",
        " ",
        "\n",
        "\t",
        "<1,2>",
        "<1, -2 , 3>",
        "< .5,1e2,>",
        "<1,",
        "\"s 1\"",
        "\"",
        "\\",
        "// 1\n",
        "/* 2 */",
        "/*",
        "*/",
        "#",
        "if",
        "end",
        "declare",
        "x",
        "_a1",
        "e",
        "(",
        ")",
        "é",
        "{",
        "}",
        ";",
        "\u{1a}",
    ];
    let mut state = 1_u64;
    let mut random = move |limit: usize| {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        (state >> 33) as usize % limit
    };
    for _ in 0..60_000 {
        let count = 1 + random(12);
        let text: String = (0..count).map(|_| parts[random(parts.len())]).collect();
        assert_read_alike(&text, &format!("{text:?}"));
    }
}

#[test]
fn installed_files_are_scanned_as_pest_reads_them() {
    for folder in ["/usr/share/povray-3.7/include", "/usr/share/doc/povray/examples"] {
        let mut folders = vec![std::path::PathBuf::from(folder)];
        while let Some(folder) = folders.pop() {
            for entry in std::fs::read_dir(folder).into_iter().flatten().flatten() {
                let path = entry.path();
                match path.extension().and_then(|e| e.to_str()) {
                    // The longest repeat what is in others, and pest takes its time.
                    Some("pov" | "inc") if entry.metadata().is_ok_and(|file| file.len() < 300_000) => {
                        let source = Source::new("", &path, std::fs::read(&path).unwrap());
                        assert_read_alike(source.text(), &path.display().to_string());
                    }
                    None if path.is_dir() => folders.push(path),
                    _ => {}
                }
            }
        }
    }
}

#[test]
fn numbers_are_the_nearest_doubles() {
    let mut state = 7_u64;
    for round in 0..100_000_u64 {
        state = state.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        let (whole, part) = (state >> (20 + round % 40), state >> (30 + round % 31) & 0xffff_ffff);
        let text = match round % 3 {
            0 => format!("{whole}.{part}"),
            1 => format!("{whole}.{part}e{}", (state >> 50) as i32 % 40 - 20),
            _ => format!(".{part}{whole}"),
        };
        let expected: f64 = text.parse().unwrap();
        assert_eq!(scan::number(text.as_bytes(), 0), Some((expected, text.len())), "{text}");
    }
}
