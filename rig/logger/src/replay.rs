//! A recorded run, shown again: the journal's bytes go through the same decoding as a live rig's.

use std::io::{self, Write};
use std::path::Path;

use rig_core::Frame;

use crate::journal::Record;
use crate::runs;

/// Writes one line for each second of a run, and every note in its place.
///
/// # Errors
/// If the run cannot be read, or the output not written.
pub fn replay(folder: &Path, output: &mut dyn Write) -> io::Result<()> {
    let calibration = runs::metadata(folder)?.calibration;
    let journal = runs::journal(folder)?;
    let mut next = 0;
    let mut celsius = f64::NAN;
    writeln!(output, "{:>9} {:>9} {:>9} {:>9} {:>7}", "s", "prim rpm", "sec rpm", "N·m", "°C")?;
    for record in &journal.records {
        let seconds = record.at() as f64 * 1e-6;
        match record {
            Record::Temperature { celsius: read, .. } => celsius = *read,
            Record::Note { text, .. } => writeln!(output, "{seconds:9.2} {text}")?,
            Record::Point { number, begins, .. } => {
                writeln!(output, "{seconds:9.2} point {number} {}", if *begins { "begins" } else { "ends" })?;
            }
            Record::Frame { at, bytes } => {
                let (true, Ok(frame)) = (*at >= next, Frame::from_bytes(bytes)) else { continue };
                next = *at + 1_000_000;
                let (p, s) = (frame.snapshot.primary.speed.rpm_exact(), frame.snapshot.secondary.speed.rpm_exact());
                let torque = calibration.torque(frame.snapshot.torque);
                writeln!(output, "{seconds:9.2} {p:9.1} {s:9.1} {torque:9.2} {celsius:7.1}")?;
            }
        }
    }
    if !journal.bad_lines.is_empty() {
        writeln!(output, "incomplete lines left out: {:?}", journal.bad_lines)?;
    }
    Ok(())
}
