//! The povista command.

use std::io;
use std::process::ExitCode;

fn main() -> ExitCode {
    // A panic is povista's fault, whatever the scene; say so, and what to do about it.
    let report = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        eprintln!("povista: a mistake of povista's own, not of the scene; please report it with the scene");
        report(panic);
    }));
    ExitCode::from(povista::cli::main(std::env::args_os(), &mut io::stdout(), &mut io::stderr()))
}
