//! Texts from files and arguments, made fit to be shown.

use std::borrow::Cow;

/// Whether a terminal would act on a character instead of showing it: control characters but for line feed and tab, and
/// those that change the direction of writing.
fn acts(c: char) -> bool {
    let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
    turns || (c.is_control() && c != '\n' && c != '\t')
}

/// The text with every character on which a terminal would act written as `\u{..}`.
///
/// ```
/// assert_eq!(sheave::text::printable("red: \u{1b}[31m"), "red: \\u{1b}[31m");
/// ```
pub fn printable(text: &str) -> Cow<'_, str> {
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len() + 8);
    for c in text.chars() {
        if acts(c) { shown.extend(c.escape_unicode()) } else { shown.push(c) }
    }
    Cow::Owned(shown)
}

/// As [`printable`], with line feeds and tabs written out, too: a text that stays within its line, or its cell.
///
/// ```
/// assert_eq!(sheave::text::on_one_line("run\t1\n\u{1b}[2J"), "run\\t1\\n\\u{1b}[2J");
/// ```
pub fn on_one_line(text: &str) -> String {
    printable(text).replace('\n', "\\n").replace('\t', "\\t")
}

/// The text with every character on which a terminal would act replaced by one of as many bytes, so that places in it
/// stay what they are; line feeds and the carriage returns before them are kept.
pub fn printable_in_place(text: &str) -> Cow<'_, str> {
    if !text.contains(acts) {
        return Cow::Borrowed(text);
    }
    let mut shown = String::with_capacity(text.len());
    let mut rest = text.chars().peekable();
    while let Some(c) = rest.next() {
        shown.push(match c {
            '\r' if rest.peek() == Some(&'\n') => c,
            c if !acts(c) => c,
            c if c.len_utf8() == 1 => '?',
            c if c.len_utf8() == 2 => '¿',
            _ => '\u{fffd}',
        });
    }
    Cow::Owned(shown)
}

/// Characters that are quoted of a text.
const QUOTED: usize = 120;

/// The beginning of a text that is too long to be quoted whole.
///
/// ```
/// assert_eq!(sheave::text::quoted(&"x".repeat(500)).chars().count(), 121);
/// ```
pub fn quoted(text: &str) -> Cow<'_, str> {
    match text.char_indices().nth(QUOTED) {
        None => Cow::Borrowed(text),
        Some((end, _)) => Cow::Owned(format!("{}…", text.get(..end).unwrap_or_default())),
    }
}

/// The text without one pair of quotes around it.
///
/// ```
/// assert_eq!(sheave::text::unquoted("\"3 kg\""), "3 kg");
/// ```
pub fn unquoted(text: &str) -> &str {
    let inside = |quote| text.strip_prefix(quote)?.strip_suffix(quote);
    inside('"').or_else(|| inside('\'')).unwrap_or(text)
}

/// A symbol with every index as `_{..}`, as texts of figures have it.
///
/// ```
/// assert_eq!(sheave::text::subscripted("R_S/R_P"), "R_{S}/R_{P}");
/// ```
pub fn subscripted(symbol: &str) -> String {
    let mut parts = symbol.split('_');
    let mut text = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (index, rest) = part.split_at(part.find(|c: char| !c.is_alphanumeric()).unwrap_or(part.len()));
        text += &format!("_{{{index}}}{rest}");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn terminals_are_given_nothing_to_act_on() {
        let text = "a\u{1b}[2J\u{7}\u{9b}31m\u{202e}b\r\nc\td\r";
        assert_eq!(printable(text), "a\\u{1b}[2J\\u{7}\\u{9b}31m\\u{202e}b\\u{d}\nc\td\\u{d}");
        let shown = printable_in_place(text);
        assert_eq!(shown.len(), text.len());
        assert_eq!(shown, "a?[2J?¿31m\u{fffd}b\r\nc\td?");
        assert!(matches!(printable("plain µ·²\n"), Cow::Borrowed(_)));
        assert!(matches!(printable_in_place("plain µ·²\n"), Cow::Borrowed(_)));
    }
}
