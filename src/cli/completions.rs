//! `sheave completions` and `sheave man`: what a shell completes, and the manual.

use super::output;
use super::stop::Stop;
use clap::{Args, CommandFactory};
use std::path::PathBuf;

/// Print what a shell needs to complete the command's arguments
///
/// For bash: sheave completions bash > ~/.local/share/bash-completion/completions/sheave
#[derive(Debug, Args)]
pub struct CompletionsArguments {
    /// The shell
    shell: clap_complete::Shell,
}

/// Print the manual page, or write those of all commands
#[derive(Debug, Args)]
pub struct ManArguments {
    /// Write sheave.1, sheave-solve.1 and so on into this folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

pub fn completions(arguments: &CompletionsArguments) -> Result<(), Stop> {
    let mut text = Vec::new();
    clap_complete::generate(arguments.shell, &mut super::Arguments::command(), "sheave", &mut text);
    output::print(&String::from_utf8_lossy(&text))
}

pub fn man(arguments: &ManArguments) -> Result<(), Stop> {
    let command = super::Arguments::command();
    match &arguments.out {
        Some(folder) => {
            output::create_folder(folder)?;
            let written = clap_mangen::generate_to(command, folder);
            written.map_err(|error| Stop::Write(folder.display().to_string(), error))
        }
        None => {
            let mut text = Vec::new();
            let rendered = clap_mangen::Man::new(command).render(&mut text);
            rendered.map_err(|error| Stop::Write("the manual page".into(), error))?;
            output::print(&String::from_utf8_lossy(&text))
        }
    }
}
