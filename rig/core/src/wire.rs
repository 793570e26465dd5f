//! What the bus master may say to the device, byte by byte.
//!
//! A write selects what the next read answers. Its first byte is a register; register [`REGISTER_PERMIT`] takes a
//! second
//! byte that grants the run permit ([`GRANT`]) or withdraws it (anything else), and selects the versioned frame. Any
//! other
//! register, and a read without a write before it, answer with the thesis's frame, so that old loggers need no change.

/// The thesis's frame.
pub const REGISTER_LEGACY: u8 = 0x00;
/// The versioned frame.
pub const REGISTER_FRAME: u8 = 0x01;
/// The identity.
pub const REGISTER_IDENTITY: u8 = 0x02;
/// The run permit; the versioned frame is then read.
pub const REGISTER_PERMIT: u8 = 0x10;
/// The byte that grants the run permit.
pub const GRANT: u8 = 0xa5;
/// A byte that withdraws it.
pub const WITHDRAW: u8 = 0x00;

/// What is answered.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Selected {
    /// The thesis's frame.
    #[default]
    Legacy,
    /// The versioned frame.
    Frame,
    /// The identity.
    Identity,
}

/// What a byte asks for beside the selection.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Request {
    /// Nothing.
    None,
    /// The run permit is granted.
    Grant,
    /// The run permit is withdrawn.
    Withdraw,
}

/// The state between the bytes of one write.
#[derive(Clone, Copy, Debug, Default)]
pub struct Selection {
    /// What the next read answers.
    pub selected: Selected,
    position: u8,
    permit: bool,
}

impl Selection {
    /// Nothing selected: the thesis's frame.
    #[must_use]
    pub const fn new() -> Self {
        Self { selected: Selected::Legacy, position: 0, permit: false }
    }

    /// The master addresses the device to write.
    pub fn start_write(&mut self) {
        self.position = 0;
        self.permit = false;
    }

    /// A byte of the write.
    pub fn byte(&mut self, byte: u8) -> Request {
        let position = self.position;
        self.position = self.position.saturating_add(1);
        match (position, byte) {
            (0, REGISTER_FRAME) => self.selected = Selected::Frame,
            (0, REGISTER_IDENTITY) => self.selected = Selected::Identity,
            (0, REGISTER_PERMIT) => {
                self.selected = Selected::Frame;
                self.permit = true;
            }
            (0, _) => self.selected = Selected::Legacy,
            (1, GRANT) if self.permit => return Request::Grant,
            (1, _) if self.permit => return Request::Withdraw,
            _ => {}
        }
        Request::None
    }

    /// A read has ended: the next one without a selection answers with the thesis's frame.
    pub fn end_read(&mut self) {
        self.selected = Selected::Legacy;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write(selection: &mut Selection, bytes: &[u8]) -> Request {
        selection.start_write();
        bytes.iter().map(|byte| selection.byte(*byte)).last().unwrap_or(Request::None)
    }

    #[test]
    fn old_loggers_get_the_frame_they_know() {
        let mut selection = Selection::new();
        assert_eq!(selection.selected, Selected::Legacy);
        write(&mut selection, &[REGISTER_FRAME]);
        assert_eq!(selection.selected, Selected::Frame);
        selection.end_read();
        assert_eq!(selection.selected, Selected::Legacy);
        write(&mut selection, &[0]);
        assert_eq!(selection.selected, Selected::Legacy);
    }

    #[test]
    fn only_the_whole_phrase_grants_the_permit() {
        let mut selection = Selection::new();
        assert_eq!(write(&mut selection, &[REGISTER_PERMIT, GRANT]), Request::Grant);
        assert_eq!(selection.selected, Selected::Frame);
        assert_eq!(write(&mut selection, &[REGISTER_PERMIT, WITHDRAW]), Request::Withdraw);
        for bytes in [&[REGISTER_PERMIT][..], &[GRANT], &[REGISTER_FRAME, GRANT], &[0, REGISTER_PERMIT, GRANT]] {
            assert_ne!(write(&mut selection, bytes), Request::Grant, "{bytes:?}");
        }
    }
}
