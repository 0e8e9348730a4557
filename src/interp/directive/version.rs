//! `#version`, docs/spec/language.md 2.11.

use crate::interp::stream::TokenKind;
use crate::interp::{Result, Vm};
use crate::source::Span;
use crate::syntax::Punct;

/// The newest version of the language, times 100.
const NEWEST: i32 = 370;

impl Vm<'_> {
    /// `#version`, just read.
    pub(in crate::interp) fn set_version(&mut self, span: Span) -> Result<()> {
        let first = self.last.end == 0;
        if let TokenKind::Name(symbol) = self.peek_raw().kind
            && &**self.symbols.name(symbol) == "unofficial"
        {
            self.next_raw();
        }
        let start = self.peek_raw().span;
        self.blocked = true;
        let value = self.arith(1)?;
        let value = self.fit(value, 1, "a float", start)?.c[0];
        let semicolon = self.operator()? == Some(Punct::Semicolon);
        self.blocked = false;
        let version = (100.0 * value + 0.5) as i32;
        if semicolon {
            self.next_raw();
        } else if version >= 310 {
            self.missing_semicolon("`#version` needs a `;` at its end");
        }
        if version > NEWEST {
            let fault =
                self.error(span.to(self.last), format!("version {value} of the language is not known"));
            return Err(fault.help("povista reads scenes up to version 3.7"));
        }
        self.version = version;
        if !self.version_written {
            (self.version_written, self.version_late) = (true, !first);
        }
        Ok(())
    }
}
