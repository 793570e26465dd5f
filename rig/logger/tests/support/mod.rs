//! What several tests of the logger use.

use std::io::{Result, Write};

use rig_logger::journal::{Recorder, Sink};

/// A file that forgets what is written to it.
struct Nowhere;

impl Write for Nowhere {
    fn write(&mut self, bytes: &[u8]) -> Result<usize> {
        Ok(bytes.len())
    }

    fn flush(&mut self) -> Result<()> {
        Ok(())
    }
}

impl Sink for Nowhere {
    fn synchronise(&mut self) -> Result<()> {
        Ok(())
    }
}

/// A recorder whose records are kept nowhere.
pub fn recorder() -> Recorder {
    Recorder::over(Box::new(Nowhere))
}
