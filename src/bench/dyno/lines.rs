//! Lines of files of any size and content, in bounded memory; compressed files are read as they are.

use flate2::read::MultiGzDecoder;
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read};
use std::path::Path;

/// Longest line that is read; what is behind is skipped.
pub const LONGEST: usize = 1 << 16;

/// Reads line after line.
pub struct Lines {
    reader: Box<dyn BufRead>,
    line: Vec<u8>,
    number: u64,
    bytes: u64,
}

/// What stands where a line is.
pub enum Line<'a> {
    /// The line without its end, and its number from 1.
    Text(u64, &'a [u8]),
    /// Longer than [`LONGEST`].
    TooLong(u64),
}

impl Lines {
    /// Opens a file; one that begins as gzip does is decompressed.
    ///
    /// # Errors
    /// The system's.
    pub fn open(path: &Path) -> io::Result<Self> {
        Self::new(File::open(path)?)
    }

    /// From anything that can be read.
    ///
    /// # Errors
    /// The reader's.
    pub fn new(source: impl Read + 'static) -> io::Result<Self> {
        let mut reader = BufReader::with_capacity(LONGEST, source);
        let gzip = reader.fill_buf()?.starts_with(&[0x1f, 0x8b]);
        let reader: Box<dyn BufRead> = if gzip {
            Box::new(BufReader::with_capacity(LONGEST, MultiGzDecoder::new(reader)))
        } else {
            Box::new(reader)
        };
        Ok(Self { reader, line: Vec::new(), number: 0, bytes: 0 })
    }

    /// The next line; `None` at the end.
    ///
    /// # Errors
    /// The reader's: a compressed file that is broken off.
    pub fn next_line(&mut self) -> io::Result<Option<Line<'_>>> {
        self.line.clear();
        let mut too_long = false;
        loop {
            let available = self.reader.fill_buf()?;
            if available.is_empty() {
                if self.line.is_empty() && !too_long {
                    return Ok(None);
                }
                break;
            }
            let end = available.iter().position(|byte| *byte == b'\n');
            let take = end.unwrap_or(available.len());
            let room = LONGEST - self.line.len();
            too_long |= take > room;
            self.line.extend_from_slice(available.get(..take.min(room)).unwrap_or_default());
            let used = end.map_or(take, |end| end + 1);
            self.reader.consume(used);
            self.bytes += used as u64;
            if end.is_some() {
                break;
            }
        }
        self.number += 1;
        if self.line.last() == Some(&b'\r') {
            self.line.pop();
        }
        Ok(Some(if too_long { Line::TooLong(self.number) } else { Line::Text(self.number, &self.line) }))
    }

    /// Bytes read so far, decompressed.
    pub fn bytes(&self) -> u64 {
        self.bytes
    }
}
