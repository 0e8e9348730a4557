//! An editor asks, over the language server protocol: what is wrong, what is this, where does it come from.
//!
//! - [`serve`] answers one editor until it leaves. Documents come whole, and are read anew when they have been changed
//!   and nothing else is asked for a moment, or as soon as something is asked about them.
//! - A scene is run as `povista check` runs it, with tighter limits: whatever the text is, there is an answer. What it
//!   writes goes into a folder that is gone afterwards.
//! - Include files aren't run on their own: what they need is known only to the scenes that include them, which tell
//!   what is wrong in them.

mod analysis;
mod complete;
mod place;
mod publish;
mod request;

use crate::options::LanguageOptions;
use crate::source::{Folder, Library, Permissions};
use analysis::Analysis;
use lsp_server::{Connection, ErrorCode, Message, Notification, ProtocolError, Request, Response};
use lsp_types::notification::{
    DidChangeTextDocument, DidCloseTextDocument, DidOpenTextDocument, Notification as _,
};
use lsp_types::{
    CompletionOptions, DidChangeTextDocumentParams, DidCloseTextDocumentParams, DidOpenTextDocumentParams,
    HoverProviderCapability, OneOf, ServerCapabilities, TextDocumentSyncCapability, TextDocumentSyncKind,
};
use publish::Published;
use std::collections::BTreeMap;
use std::io;
use std::path::PathBuf;
use std::time::Duration;

/// How long nothing must come before what was changed is read.
const PAUSE: Duration = Duration::from_millis(120);

/// What a scene sees besides its own text.
#[derive(Debug)]
pub struct Options {
    /// What the interpreter is told; limits among it.
    pub language: LanguageOptions,
    /// What may be read; nothing is written anywhere but to a folder of the server's own.
    pub permissions: Permissions,
}

/// A document that is open.
#[derive(Debug)]
struct Document {
    text: String,
    version: i32,
    /// What is known of it; `None` since it was changed.
    analysis: Option<Analysis>,
}

/// What is known between two messages.
struct Server<'a> {
    connection: &'a Connection,
    options: &'a Options,
    /// Where scenes write.
    scratch: tempfile::TempDir,
    /// Open documents by their addresses.
    documents: BTreeMap<String, Document>,
    published: Published,
}

/// Why serving ended early.
#[derive(Debug, thiserror::Error)]
pub enum Trouble {
    /// There is no place for what scenes write.
    #[error("cannot make a folder for what scenes write: {0}")]
    Scratch(#[from] io::Error),
    /// The editor doesn't keep to the protocol.
    #[error("{0}")]
    Protocol(#[from] ProtocolError),
}

/// Answers an editor until it leaves.
///
/// # Errors
/// The editor doesn't say hello, or goodbye, as the protocol asks for.
pub fn serve(connection: &Connection, options: &Options) -> Result<(), Trouble> {
    let capabilities = serde_json::to_value(capabilities()).unwrap_or_default();
    connection.initialize(capabilities)?;
    let mut server = Server {
        connection,
        options,
        scratch: tempfile::tempdir()?,
        documents: BTreeMap::new(),
        published: Published::default(),
    };
    server.run()
}

fn capabilities() -> ServerCapabilities {
    ServerCapabilities {
        text_document_sync: Some(TextDocumentSyncCapability::Kind(TextDocumentSyncKind::FULL)),
        hover_provider: Some(HoverProviderCapability::Simple(true)),
        definition_provider: Some(OneOf::Left(true)),
        document_symbol_provider: Some(OneOf::Left(true)),
        document_formatting_provider: Some(OneOf::Left(true)),
        completion_provider: Some(CompletionOptions {
            trigger_characters: Some(vec!["#".to_owned()]),
            ..CompletionOptions::default()
        }),
        ..ServerCapabilities::default()
    }
}

impl Server<'_> {
    fn run(&mut self) -> Result<(), Trouble> {
        loop {
            let message = if self.documents.values().any(|document| document.analysis.is_none()) {
                match self.connection.receiver.recv_timeout(PAUSE) {
                    Ok(message) => message,
                    Err(error) if error.is_timeout() => {
                        self.refresh_all();
                        continue;
                    }
                    Err(_) => return Ok(()),
                }
            } else {
                match self.connection.receiver.recv() {
                    Ok(message) => message,
                    Err(_) => return Ok(()),
                }
            };
            match message {
                Message::Request(request) => {
                    if self.connection.handle_shutdown(&request)? {
                        return Ok(());
                    }
                    self.answer(request);
                }
                Message::Notification(notification) => self.heed(notification),
                // Nothing was asked.
                Message::Response(_) => {}
            }
        }
    }

    /// Sends a message; an editor that has gone away is noticed when the next one is awaited.
    fn send(&self, message: impl Into<Message>) {
        let _ = self.connection.sender.send(message.into());
    }

    fn answer(&mut self, request: Request) {
        let id = request.id.clone();
        let response = match self.ask(&request) {
            Ok(Some(result)) => Response::new_ok(id, result),
            Ok(None) => {
                let message = format!("povista doesn't know `{}`", request.method);
                Response::new_err(id, ErrorCode::MethodNotFound as i32, message)
            }
            Err(error) => Response::new_err(id, ErrorCode::InvalidParams as i32, error.to_string()),
        };
        self.send(response);
    }

    /// Takes in what the editor tells. What makes no sense is passed over, as the protocol has it.
    fn heed(&mut self, notification: Notification) {
        match notification.method.as_str() {
            DidOpenTextDocument::METHOD => {
                if let Ok(params) =
                    notification.extract::<DidOpenTextDocumentParams>(DidOpenTextDocument::METHOD)
                {
                    let opened = params.text_document;
                    let document = Document { text: opened.text, version: opened.version, analysis: None };
                    self.documents.insert(opened.uri.as_str().to_owned(), document);
                }
            }
            DidChangeTextDocument::METHOD => {
                if let Ok(params) =
                    notification.extract::<DidChangeTextDocumentParams>(DidChangeTextDocument::METHOD)
                    && let Some(document) = self.documents.get_mut(params.text_document.uri.as_str())
                    && let Some(change) = params.content_changes.into_iter().next_back()
                {
                    *document =
                        Document { text: change.text, version: params.text_document.version, analysis: None };
                }
            }
            DidCloseTextDocument::METHOD => {
                if let Ok(params) =
                    notification.extract::<DidCloseTextDocumentParams>(DidCloseTextDocument::METHOD)
                {
                    let uri = params.text_document.uri.as_str().to_owned();
                    self.documents.remove(&uri);
                    let changed = self.published.forget(&uri);
                    self.publish(changed);
                }
            }
            _ => {}
        }
    }

    /// Reads what was changed.
    fn refresh_all(&mut self) {
        let changed: Vec<String> = self
            .documents
            .iter()
            .filter(|(_, document)| document.analysis.is_none())
            .map(|(uri, _)| uri.clone())
            .collect();
        for uri in changed {
            self.refresh(&uri);
        }
    }

    /// Reads a document if it was changed, and tells what is wrong with it.
    fn refresh(&mut self, uri: &str) {
        let library = self.library(uri);
        let Some(document) = self.documents.get_mut(uri) else { return };
        if document.analysis.is_some() {
            return;
        }
        let analysis = Analysis::new(uri, &document.text, library, &self.options.language);
        let told = publish::diagnostics(uri, &analysis);
        document.analysis = Some(analysis);
        let changed = self.published.replace(uri, told);
        self.publish(changed);
    }

    fn publish(&self, uris: Vec<String>) {
        for uri in uris {
            let version = self.documents.get(&uri).map(|document| document.version);
            if let Some(params) = self.published.params(&uri, version) {
                self.send(Notification::new("textDocument/publishDiagnostics".to_owned(), params));
            }
        }
    }

    /// Where a document's files are looked for. It writes where nobody is hurt, and finds there what it wrote.
    fn library(&self, uri: &str) -> Library {
        let folder = place::path(uri).and_then(|path| path.parent().map(PathBuf::from));
        let scratch = Folder::new(self.scratch.path(), true);
        Library {
            current: self.scratch.path().to_owned(),
            paths: folder.into_iter().collect(),
            scene: None,
            permissions: Permissions { write: Some(vec![scratch]), ..self.options.permissions.clone() },
        }
    }
}

#[cfg(test)]
mod tests;
