//! The server without a process around it; `tests/lsp.rs` drives the program.

use super::*;
use lsp_server::RequestId;
use serde_json::{Value, json};

const SCENE: &str = "#version 3.7;
global_settings { assumed_gamma 1 }
#declare Radius = 1 + 2; // é𝄞
#macro Ball(Size)
  #local Twice = 2*Size;
  sphere { 0, Twice*Radius }
#end
union { Ball(2) Ball(5) }
camera { location -9*z }
";

/// Asks a server about documents that it has open, and gives its answers and what it told by itself.
fn talk(messages: Vec<Message>) -> (Vec<Value>, Vec<Value>) {
    let (ours, theirs) = Connection::memory();
    let options = Options {
        language: LanguageOptions { max_steps: 10_000, ..LanguageOptions::default() },
        permissions: Permissions::default(),
    };
    let hello = Request::new(RequestId::from(-1), "initialize".to_owned(), json!({ "capabilities": {} }));
    let goodbye = Request::new(RequestId::from(-2), "shutdown".to_owned(), Value::Null);
    ours.sender.send(hello.into()).unwrap();
    ours.sender.send(Notification::new("initialized".to_owned(), json!({})).into()).unwrap();
    messages.into_iter().for_each(|message| ours.sender.send(message).unwrap());
    ours.sender.send(goodbye.into()).unwrap();
    ours.sender.send(Notification::new("exit".to_owned(), Value::Null).into()).unwrap();
    serve(&theirs, &options).unwrap();
    drop(theirs);
    let said: Vec<Value> =
        ours.receiver.iter().map(|message| serde_json::to_value(message).unwrap()).collect();
    said.into_iter()
        .filter(|message| message["id"].as_i64().is_none_or(|id| id >= 0))
        .partition(|message| !message["id"].is_null())
}

fn open(text: &str) -> Message {
    let document = json!({ "uri": "file:///nowhere/a.pov", "languageId": "pov", "version": 1, "text": text });
    Notification::new(DidOpenTextDocument::METHOD.to_owned(), json!({ "textDocument": document })).into()
}

/// A question about the place where a mark stands.
fn ask(id: i32, method: &str, text: &str, mark: &str) -> Message {
    let position = place::position(text, text.find(mark).unwrap());
    let params = json!({ "textDocument": { "uri": "file:///nowhere/a.pov" }, "position": position });
    Request::new(RequestId::from(id), format!("textDocument/{method}"), params).into()
}

#[test]
fn questions_about_a_scene_are_answered() {
    let (answers, told) = talk(vec![
        open(SCENE),
        ask(0, "hover", SCENE, "Twice*"),
        ask(1, "definition", SCENE, "Ball(5)"),
        ask(2, "completion", SCENE, "Twice*"),
        ask(3, "documentSymbol", SCENE, "Twice*"),
        ask(4, "unheardOf", SCENE, "Twice*"),
    ]);
    assert_eq!(answers.len(), 5);
    let hover = answers[0]["result"]["contents"]["value"].as_str().unwrap();
    assert!(hover.contains("holds `10` here") && hover.contains("a.pov:5"), "{hover}");
    assert_eq!(answers[1]["result"]["range"]["start"], json!({ "line": 3, "character": 7 }));
    let items = answers[2]["result"].as_array().unwrap();
    assert!(
        ["Twice", "Size", "Ball", "sphere"]
            .iter()
            .all(|name| items.iter().any(|item| item["label"] == **name))
    );
    let names: Vec<&Value> =
        answers[3]["result"].as_array().unwrap().iter().map(|symbol| &symbol["name"]).collect();
    assert_eq!(names, ["global_settings", "Radius", "Ball", "union", "camera"]);
    assert_eq!(answers[4]["error"]["code"], -32601);
    assert_eq!(told[0]["params"]["diagnostics"], json!([]), "{told:?}");
}

#[test]
fn what_is_wrong_is_told_with_its_place() {
    let text = SCENE.replace("-9*z", "-9*Zed");
    let (_, told) = talk(vec![open(&text), ask(0, "hover", &text, "Zed")]);
    let told = told[0]["params"]["diagnostics"].as_array().unwrap();
    assert_eq!(told.len(), 1, "{told:?}");
    assert_eq!(told[0]["range"]["start"], json!({ "line": 8, "character": 21 }));
    assert_eq!((&told[0]["severity"], &told[0]["code"]), (&json!(1), &json!("povista::error")));
}

#[test]
fn every_beginning_of_a_scene_is_answered() {
    let mut messages = Vec::new();
    for (at, _) in SCENE.char_indices() {
        messages.push(open(&SCENE[..at]));
        messages.push(ask(at as i32, "hover", &SCENE[..at], ""));
        messages.push(ask(at as i32, "documentSymbol", &SCENE[..at], ""));
    }
    let count = messages.len() / 3 * 2;
    assert_eq!(talk(messages).0.len(), count);
}
