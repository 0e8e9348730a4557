//! An editor's side of the language server protocol, spoken to the real program.

use serde_json::{Value, json};
use std::fs;
use std::io::{BufRead, BufReader, Write};
use std::path::Path;
use std::process::{Child, ChildStdin, Command, Stdio};
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// How long an answer may take on a machine with a lot to do.
const PATIENCE: Duration = Duration::from_secs(60);

/// An editor with one folder.
struct Editor {
    folder: tempfile::TempDir,
    server: Child,
    to_server: ChildStdin,
    from_server: Receiver<Value>,
    /// Notifications that came while an answer was awaited.
    told: Vec<Value>,
    id: i64,
}

impl Editor {
    fn new() -> Self {
        let folder = tempfile::tempdir().unwrap();
        let mut server = Command::new(env!("CARGO_BIN_EXE_povista"))
            .args(["lsp", "--max-steps", "20000", "--max-memory", "300"])
            .current_dir(folder.path())
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .spawn()
            .unwrap();
        let to_server = server.stdin.take().unwrap();
        let mut output = BufReader::new(server.stdout.take().unwrap());
        let (sender, from_server) = channel();
        std::thread::spawn(move || {
            while let Some(message) = read(&mut output) {
                if sender.send(message).is_err() {
                    return;
                }
            }
        });
        let mut editor = Self { folder, server, to_server, from_server, told: Vec::new(), id: 0 };
        let answer =
            editor.request("initialize", json!({ "processId": null, "rootUri": null, "capabilities": {} }));
        assert_eq!(answer["capabilities"]["textDocumentSync"], 1, "{answer}");
        editor.notify("initialized", json!({}));
        editor
    }

    fn write(&mut self, message: &Value) {
        let body = message.to_string();
        write!(self.to_server, "Content-Length: {}\r\n\r\n{body}", body.len()).unwrap();
        self.to_server.flush().unwrap();
    }

    fn notify(&mut self, method: &str, params: Value) {
        self.write(&json!({ "jsonrpc": "2.0", "method": method, "params": params }));
    }

    /// The whole answer to a request.
    fn ask(&mut self, method: &str, params: Value) -> Value {
        self.id += 1;
        let id = self.id;
        self.write(&json!({ "jsonrpc": "2.0", "id": id, "method": method, "params": params }));
        loop {
            let message = self.from_server.recv_timeout(PATIENCE).expect("no answer");
            if message["id"] == id {
                return message;
            }
            self.told.push(message);
        }
    }

    fn request(&mut self, method: &str, params: Value) -> Value {
        let answer = self.ask(method, params);
        assert!(answer["error"].is_null(), "{method}: {answer}");
        answer["result"].clone()
    }

    fn uri(&self, name: &str) -> String {
        format!("file://{}", self.folder.path().join(name).display())
    }

    fn open(&mut self, name: &str, text: &str) {
        let document = json!({ "uri": self.uri(name), "languageId": "pov", "version": 1, "text": text });
        self.notify("textDocument/didOpen", json!({ "textDocument": document }));
    }

    fn change(&mut self, name: &str, text: &str) {
        let document = json!({ "uri": self.uri(name), "version": 2 });
        let params = json!({ "textDocument": document, "contentChanges": [{ "text": text }] });
        self.notify("textDocument/didChange", params);
    }

    /// Asks about the place in a text where `mark` stands, `into` it.
    fn at(&mut self, method: &str, name: &str, text: &str, mark: &str, into: usize) -> Value {
        let before = &text[..text.find(mark).unwrap_or_else(|| panic!("no {mark}")) + into];
        let line = before.matches('\n').count();
        let character = before.rsplit('\n').next().unwrap().encode_utf16().count();
        let params = json!({
            "textDocument": { "uri": self.uri(name) },
            "position": { "line": line, "character": character },
        });
        self.request(method, params)
    }

    /// What is told of a file next.
    fn diagnostics(&mut self, name: &str) -> Vec<Value> {
        let uri = self.uri(name);
        let is_it = |message: &Value| {
            message["method"] == "textDocument/publishDiagnostics" && message["params"]["uri"] == *uri
        };
        let end = Instant::now() + PATIENCE;
        loop {
            if let Some(place) = self.told.iter().position(is_it) {
                return self.told.remove(place)["params"]["diagnostics"].as_array().unwrap().clone();
            }
            let message = self.from_server.recv_timeout(end - Instant::now()).expect("nothing was told");
            self.told.push(message);
        }
    }

    /// Says goodbye; the program has to end well.
    fn leave(mut self) {
        assert!(self.request("shutdown", Value::Null).is_null());
        self.notify("exit", Value::Null);
        assert!(self.server.wait().unwrap().success());
    }
}

/// The next message; none at the end.
fn read(input: &mut impl BufRead) -> Option<Value> {
    let mut length = 0;
    loop {
        let mut line = String::new();
        if input.read_line(&mut line).ok()? == 0 {
            return None;
        }
        match line.trim() {
            "" => break,
            header => {
                if let Some(value) = header.strip_prefix("Content-Length: ") {
                    length = value.parse().ok()?;
                }
            }
        }
    }
    let mut body = vec![0; length];
    input.read_exact(&mut body).ok()?;
    serde_json::from_slice(&body).ok()
}

const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 }
#include \"parts.inc\"
#declare Radius = 1 + 2; // é𝄞
#macro Ball(Size)
  #local Twice = 2*Size;
  sphere { 0, Twice*Radius }
#end
union { Ball(2) Ball(5) Part(Radius) }
camera { location -9*z }
";

const PARTS: &str = "#macro Part(Edge)\n  box { 0, Edge }\n#end\n";

fn editor_with_scene() -> Editor {
    let mut editor = Editor::new();
    fs::write(editor.folder.path().join("parts.inc"), PARTS).unwrap();
    editor.open("a.pov", SCENE);
    editor
}

fn hover(editor: &mut Editor, mark: &str) -> String {
    let answer = editor.at("textDocument/hover", "a.pov", SCENE, mark, 0);
    answer["contents"]["value"].as_str().unwrap_or_default().to_owned()
}

#[test]
fn hovering_tells_what_a_name_holds_and_where_it_is_declared() {
    let mut editor = editor_with_scene();
    let radius = hover(&mut editor, "Radius }");
    for part in ["#declare Radius = 1 + 2;", "`Radius` holds `3` here", "a.pov:4"] {
        assert!(radius.contains(part), "{part} is not in {radius}");
    }
    // Macros are called more than once: the last call counts.
    assert!(hover(&mut editor, "Twice*").contains("holds `10` here"));
    assert!(hover(&mut editor, "Size;").contains("holds `5` here"));
    assert!(hover(&mut editor, "Ball(2)").contains("#macro Ball(Size)"));
    assert!(hover(&mut editor, "Part(R").contains("parts.inc:1"));
    assert!(hover(&mut editor, "union").contains("reserved word"));
    assert_eq!(hover(&mut editor, "{ 0, Twice"), "");
    editor.leave();
}

#[test]
fn definitions_are_found_in_the_document_and_in_what_it_includes() {
    let mut editor = editor_with_scene();
    let mut line = |mark: &str, file: &str| {
        let answer = editor.at("textDocument/definition", "a.pov", SCENE, mark, 1);
        assert!(answer["uri"].as_str().is_some_and(|uri| uri.ends_with(file)), "{mark}: {answer}");
        answer["range"]["start"]["line"].as_u64().unwrap()
    };
    assert_eq!(line("Ball(5)", "a.pov"), 4);
    assert_eq!(line("Twice*", "a.pov"), 5);
    assert_eq!(line("Size;", "a.pov"), 4);
    assert_eq!(line("Part(R", "parts.inc"), 0);
    assert_eq!(line("\"parts.inc", "parts.inc"), 0);
    editor.leave();
}

#[test]
fn what_is_wrong_is_told_as_the_text_changes() {
    let mut editor = editor_with_scene();
    assert_eq!(editor.diagnostics("a.pov"), Vec::<Value>::new());
    editor.change("a.pov", &SCENE.replace("-9*z }", "-9*Zed }\n#declare Idle = 1;"));
    let told = editor.diagnostics("a.pov");
    assert_eq!(told.len(), 1, "{told:?}");
    assert!(told[0]["message"].as_str().unwrap().contains("`Zed`"), "{told:?}");
    assert_eq!((&told[0]["severity"], &told[0]["code"]), (&json!(1), &json!("povista::error")));
    assert_eq!(
        told[0]["range"],
        json!({
            "start": { "line": 9, "character": 21 }, "end": { "line": 9, "character": 24 }
        })
    );
    editor.change("a.pov", &format!("{SCENE}#declare Idle = 1;"));
    let told = editor.diagnostics("a.pov");
    assert_eq!((told.len(), &told[0]["code"]), (1, &json!("povista::lint::unused")), "{told:?}");
    editor.leave();
}

#[test]
fn a_mistake_in_an_included_file_is_told_of_that_file_until_it_is_mended() {
    let mut editor = Editor::new();
    let parts = editor.folder.path().join("parts.inc");
    fs::write(&parts, PARTS.replace("box", "bax")).unwrap();
    editor.open("a.pov", SCENE);
    let told = editor.diagnostics("parts.inc");
    assert_eq!(told.len(), 1, "{told:?}");
    let from = &told[0]["relatedInformation"];
    assert!(from.to_string().contains("in macro `Part`"), "{from}");
    fs::write(&parts, PARTS).unwrap();
    editor.change("a.pov", SCENE);
    assert_eq!(editor.diagnostics("parts.inc"), Vec::<Value>::new());
    editor.leave();
}

#[test]
fn names_words_and_directives_complete() {
    let mut editor = editor_with_scene();
    let mut labels = |mark: &str, into: usize| {
        let answer = editor.at("textDocument/completion", "a.pov", SCENE, mark, into);
        let items = answer.as_array().unwrap().clone();
        items.iter().map(|item| item["label"].as_str().unwrap().to_owned()).collect::<Vec<_>>()
    };
    let inside = labels("Twice*", 2);
    for name in ["Twice", "Size", "Radius", "Ball", "Part", "sphere", "light_source"] {
        assert_eq!(inside.iter().filter(|label| *label == name).count(), 1, "{name}");
    }
    let outside = labels("location", 3);
    assert!(outside.contains(&"Radius".to_owned()));
    assert!(!outside.contains(&"Twice".to_owned()) && !outside.contains(&"Edge".to_owned()));
    let directives = labels("#macro", 3);
    assert!(directives.contains(&"macro".to_owned()) && !directives.contains(&"sphere".to_owned()));
    editor.leave();
}

#[test]
fn the_outline_has_declarations_in_their_macros_and_statements() {
    let mut editor = editor_with_scene();
    let uri = editor.uri("a.pov");
    let answer = editor.request("textDocument/documentSymbol", json!({ "textDocument": { "uri": uri } }));
    let names = |symbols: &Value| -> Vec<String> {
        let symbols = symbols.as_array().cloned().unwrap_or_default();
        symbols.iter().map(|symbol| symbol["name"].as_str().unwrap().to_owned()).collect()
    };
    assert_eq!(names(&answer), ["global_settings", "Radius", "Ball", "union", "camera"]);
    assert_eq!(names(&answer[2]["children"]), ["Twice"]);
    assert_eq!(answer[2]["range"]["end"], json!({ "line": 7, "character": 4 }));
    editor.leave();
}

#[test]
fn documents_are_laid_out() {
    let mut editor = Editor::new();
    editor.open("b.pov", "sphere{0,1}\n");
    let uri = editor.uri("b.pov");
    let options = json!({ "tabSize": 4, "insertSpaces": true });
    let params = json!({ "textDocument": { "uri": uri }, "options": options });
    let edits = editor.request("textDocument/formatting", params.clone());
    assert_eq!(edits[0]["newText"], "sphere { 0, 1 }\n");
    editor.change("b.pov", "\"never closed");
    assert!(editor.request("textDocument/formatting", params).is_null());
    editor.leave();
}

#[test]
fn a_scene_writes_nothing_where_its_author_would_find_it() {
    let mut editor = Editor::new();
    let outside = editor.folder.path().join("outside.txt");
    let text = format!(
        "#version 3.7;\n#fopen F \"inside.txt\" write\n#write (F, \"1,\")\n#fclose F\n\
         #fopen F \"inside.txt\" read\n#read (F, Back)\n#declare Seen = Back;\n#fopen G \"{}\" write\n",
        outside.display()
    );
    editor.open("a.pov", &text);
    let seen = editor.at("textDocument/hover", "a.pov", &text, "Seen", 0);
    assert!(seen["contents"]["value"].as_str().unwrap().contains("`1`"), "{seen}");
    let told = editor.diagnostics("a.pov");
    assert!(told.iter().any(|told| told["message"].as_str().unwrap().contains("not permitted")), "{told:?}");
    assert!(!outside.exists() && !editor.folder.path().join("inside.txt").exists());
    assert!(!Path::new("inside.txt").exists());
    editor.leave();
}

#[test]
fn no_text_and_no_message_is_too_odd() {
    let mut editor = editor_with_scene();
    let ends = SCENE.char_indices().map(|(at, _)| SCENE[..at].to_owned());
    let starts = SCENE.char_indices().step_by(7).map(|(at, _)| SCENE[at..].to_owned());
    let odd = [
        "#while (1) #end".to_owned(),
        "#macro M() M() #end M()".to_owned(),
        "#include \"a.pov\"".to_owned(),
        "#declare A = array[1e12];".to_owned(),
        "#declare S = \"ab\"; #while (1) #declare S = concat(S, S); #end".to_owned(),
        "(".repeat(100_000),
        "{".repeat(100_000),
        "union { ".repeat(20_000),
        "\u{feff}sphere\0\u{1a}é𝄞".to_owned(),
        "\r\r\n\n\r".to_owned(),
    ];
    for text in ends.chain(starts).chain(odd) {
        editor.change("a.pov", &text);
        let last = text.lines().count().saturating_sub(1);
        let place = json!({ "textDocument": { "uri": editor.uri("a.pov") }, "position": { "line": last, "character": 3 } });
        for method in ["hover", "definition", "completion"] {
            editor.request(&format!("textDocument/{method}"), place.clone());
        }
        editor.request("textDocument/documentSymbol", place);
    }
    let answer = editor.ask("textDocument/hover", json!({ "nonsense": 1 }));
    assert_eq!(answer["error"]["code"], -32602);
    let answer = editor.ask("textDocument/unheardOf", json!({}));
    assert_eq!(answer["error"]["code"], -32601);
    editor.notify("textDocument/didChange", json!([]));
    editor.change("a.pov", SCENE);
    assert!(hover(&mut editor, "Radius }").contains("holds `3`"));
    editor.leave();
}
