//! The belt drive solver as a WebAssembly module: JSON in, JSON out.
//!
//! What is asked and answered, `sheave::live` says. Texts pass through one buffer in the module's memory: the page asks
//! for room (`room`), writes its question there as UTF-8, calls `answer`, and reads the answer where `text` says. Three
//! functions of numbers are the whole interface; it needs no generated glue, no imports, and no compiler of its own.

use std::cell::RefCell;

use sheave::live::Live;

/// What the module keeps between calls.
#[derive(Default)]
struct Module {
    live: Live,
    /// The question, then the answer.
    text: Vec<u8>,
}

thread_local! {
    static MODULE: RefCell<Module> = RefCell::default();
}

/// Longest question, bytes.
const LONGEST: usize = 4 << 20;

/// Makes room for a question of `length` bytes and says where; null if that is too long.
#[unsafe(no_mangle)]
pub extern "C" fn room(length: usize) -> *mut u8 {
    MODULE.with_borrow_mut(|module| {
        module.text.clear();
        if length > LONGEST {
            return std::ptr::null_mut();
        }
        module.text.resize(length, 0);
        module.text.as_mut_ptr()
    })
}

/// Answers the question and says how many bytes the answer has.
#[unsafe(no_mangle)]
pub extern "C" fn answer() -> usize {
    MODULE.with_borrow_mut(|module| {
        let question = std::mem::take(&mut module.text);
        module.text = module.live.answer(&String::from_utf8_lossy(&question)).into_bytes();
        module.text.len()
    })
}

/// Where the answer begins; it stays until the next call.
#[unsafe(no_mangle)]
pub extern "C" fn text() -> *const u8 {
    MODULE.with_borrow(|module| module.text.as_ptr())
}
