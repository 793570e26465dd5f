//! The AD7171, a 16-bit sigma-delta converter read over two wires (thesis, section 8.2.2).
//!
//! It converts continuously at 125 Hz and pulls its data line low when a result is ready. 24 clock pulses then bring
//! the
//! result, most significant bit first, and eight status bits: RDY, 0, ERR, ID1, ID0, PAT2, PAT1, PAT0 (data sheet).

/// The status byte of a good conversion: ready (0), no error (0), identity 01, pattern 101.
pub const GOOD_STATUS: u8 = 0b0000_1101;

/// Why a conversion cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ConversionError {
    /// The status says that no result was ready.
    NotReady,
    /// The converter reports an error: its input is out of range, the result is clamped.
    Reported,
    /// The constant bits of the status are wrong: the transfer was disturbed, or no AD7171 is there.
    Garbled,
}

/// The result in 24 bits as they were clocked out: offset binary, 0x8000 at zero input.
///
/// # Errors
/// See [`ConversionError`]; the status byte is checked whole.
pub fn decode(bits: u32) -> Result<u16, ConversionError> {
    let status = bits as u8;
    let constant_bits = 0b0101_1111;
    if status & constant_bits != GOOD_STATUS & constant_bits {
        Err(ConversionError::Garbled)
    } else if status & 0x80 != 0 {
        Err(ConversionError::NotReady)
    } else if status & 0x20 != 0 {
        Err(ConversionError::Reported)
    } else {
        Ok((bits >> 8) as u16)
    }
}

/// The two wires to the converter.
pub trait Wires {
    /// Whether the data line is high.
    fn data_is_high(&mut self) -> bool;
    /// One clock pulse, low then high; whether the data line was high at its end.
    fn clock_pulse(&mut self) -> bool;
}

/// Reads a conversion if one is ready; never waits.
pub fn poll(wires: &mut impl Wires) -> Option<Result<u16, ConversionError>> {
    if wires.data_is_high() {
        return None;
    }
    let mut bytes = [0u8; 4];
    for byte in bytes.iter_mut().skip(1) {
        for _ in 0..8 {
            *byte = (*byte << 1) | u8::from(wires.clock_pulse());
        }
    }
    Some(decode(u32::from_be_bytes(bytes)))
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Shifted {
        bits: u32,
        left: u8,
    }

    impl Wires for Shifted {
        fn data_is_high(&mut self) -> bool {
            self.left != 24
        }

        fn clock_pulse(&mut self) -> bool {
            self.left -= 1;
            self.bits >> self.left & 1 == 1
        }
    }

    #[test]
    fn a_conversion_is_read_with_its_status() {
        let mut wires = Shifted { bits: 35_145 << 8 | u32::from(GOOD_STATUS), left: 24 };
        assert_eq!(poll(&mut wires), Some(Ok(35_145)));
        assert_eq!(poll(&mut wires), None);
    }

    #[test]
    fn every_status_byte_but_one_is_refused() {
        let good = (0..=255u32).filter(|status| decode((0x1234 << 8) | status).is_ok()).collect::<std::vec::Vec<_>>();
        assert_eq!(good, [u32::from(GOOD_STATUS)]);
        assert_eq!(decode(0x0012_342d), Err(ConversionError::Reported));
        assert_eq!(decode(0x0012_348d), Err(ConversionError::NotReady));
        assert_eq!(decode(0x00ff_ffff), Err(ConversionError::Garbled));
        assert_eq!(decode(0), Err(ConversionError::Garbled));
    }

    extern crate std;
}
