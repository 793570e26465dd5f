//! What is wrong with a case, shown as a diagnostic: the place underlined, and what to do about it.

use super::error::{CaseError, Source};
use miette::{Diagnostic, LabeledSpan, SourceCode};
use std::fmt;

impl Diagnostic for CaseError {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.hint()?))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(&*self.places().first()?.source as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let first = self.places().first()?;
        // One text can be shown: the one at fault.
        let shown = self.places().iter().enumerate().filter(|(_, place)| place.source == first.source);
        Some(Box::new(shown.map(|(index, place)| {
            let span = self.span(place);
            LabeledSpan::new_with_span(Some(self.label(index).into()), (span.start, span.len()))
        })))
    }
}

impl SourceCode for Source {
    fn read_span<'a>(
        &'a self,
        span: &miette::SourceSpan,
        context_lines_before: usize,
        context_lines_after: usize,
    ) -> Result<Box<dyn miette::SpanContents<'a> + 'a>, miette::MietteError> {
        let contents = self.text.read_span(span, context_lines_before, context_lines_after)?;
        Ok(Box::new(miette::MietteSpanContents::new_named(
            self.name.clone(),
            contents.data(),
            *contents.span(),
            contents.line(),
            contents.column(),
            contents.line_count(),
        )))
    }
}
