//! What is wrong with a text that was given, shown as a diagnostic: the place underlined, and what to do about it.

use super::error::CaseError;
use super::place::{Place, Placed, Source};
use crate::text::printable;
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
        // One text can be shown: the one at fault. Of a long line, one place in it.
        let shown: Vec<(usize, &Place)> =
            self.places().iter().enumerate().filter(|(_, place)| place.source == first.source).collect();
        let cut = shown.iter().any(|(_, place)| place.source.excerpt(self.span(place).start).is_some());
        let shown = shown.into_iter().take(if cut { 1 } else { usize::MAX });
        Some(Box::new(shown.filter_map(|(index, place)| {
            let span = place.source.shown(self.span(place))?;
            Some(LabeledSpan::new_with_span(Some(self.label(index).into()), (span.start, span.len())))
        })))
    }
}

impl<P: fmt::Debug + fmt::Display> Diagnostic for Placed<P> {
    fn help<'a>(&'a self) -> Option<Box<dyn fmt::Display + 'a>> {
        Some(Box::new(self.advice()?))
    }

    fn source_code(&self) -> Option<&dyn SourceCode> {
        Some(self.place()?.source.as_ref() as &dyn SourceCode)
    }

    fn labels(&self) -> Option<Box<dyn Iterator<Item = LabeledSpan> + '_>> {
        let place = self.place()?;
        let span = if place.value.is_empty() { place.key.clone() } else { place.value.clone() };
        let span = place.source.shown(span)?;
        Some(Box::new(std::iter::once(LabeledSpan::new_with_span(Some("here".into()), (span.start, span.len())))))
    }
}

impl SourceCode for Source {
    fn read_span<'a>(
        &'a self,
        span: &miette::SourceSpan,
        context_lines_before: usize,
        context_lines_after: usize,
    ) -> Result<Box<dyn miette::SpanContents<'a> + 'a>, miette::MietteError> {
        // Of a text on one endless line a part is shown, and nothing that a terminal would act on.
        let excerpt = self.excerpt(span.offset()).map(|excerpt| (excerpt.start, excerpt.len()));
        let (span, before, after) = match &excerpt {
            Some(excerpt) => (&(*excerpt).into(), 0, 0),
            None => (span, context_lines_before, context_lines_after),
        };
        let contents = self.text.read_span(span, before, after)?;
        let (start, length) = (contents.span().offset(), contents.span().len());
        let data = self.shown_text().get(start..start + length).unwrap_or_default().as_bytes();
        let name = printable(&self.name).into_owned();
        let (line, column) = (contents.line(), contents.column());
        Ok(Box::new(miette::MietteSpanContents::new_named(
            name,
            data,
            *contents.span(),
            line,
            column,
            contents.line_count(),
        )))
    }
}
