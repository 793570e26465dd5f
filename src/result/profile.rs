//! Every state and derived field along the belt, as CSV.

use std::collections::BTreeSet;
use std::io::Write;

use generated::Symbol;

use super::Outcome;
use super::compute::Sampled;
use crate::drive::RegionId;

/// Points inside each mesh interval, besides its nodes.
const INNER: usize = 1;

/// A column's header: name and unit.
fn header(symbol: &Symbol) -> String {
    if symbol.unit.is_empty() { symbol.name.to_owned() } else { format!("{} [{}]", symbol.name, symbol.unit) }
}

/// Writes one row a point: region, position in `[0, 1]`, then every state and derived field; a quantity that a region
/// does not have is left empty. Headers carry units.
///
/// # Errors
/// What the writer says.
pub fn write_profile(outcome: &Outcome, to: impl Write) -> Result<(), csv::Error> {
    let (belt, solution) = (&outcome.solved.belt, &outcome.solved.solution);
    let regions = RegionId::ALL.map(|region| Sampled::new(belt, solution, region, INNER));
    let mut seen = BTreeSet::new();
    let symbols = regions.iter().flat_map(Sampled::columns).map(|(symbol, _)| symbol);
    let symbols: Vec<&Symbol> = symbols.filter(|symbol| seen.insert(symbol.name)).collect();
    let mut writer = csv::Writer::from_writer(to);
    let headers =
        ["region", "position"].map(str::to_owned).into_iter().chain(symbols.iter().map(|symbol| header(symbol)));
    writer.write_record(headers)?;
    for sampled in &regions {
        let own: Vec<(&Symbol, &[f64])> = sampled.columns().collect();
        let column = |symbol: &&Symbol| own.iter().find(|(other, _)| other == symbol).map(|(_, samples)| *samples);
        let columns: Vec<Option<&[f64]>> = symbols.iter().map(column).collect();
        for (row, s) in sampled.s.iter().enumerate() {
            let cell = |column: &Option<&[f64]>| column.map_or(String::new(), |samples| samples[row].to_string());
            let start = [sampled.region.name().to_owned(), s.to_string()];
            writer.write_record(start.into_iter().chain(columns.iter().map(cell)))?;
        }
    }
    writer.flush()?;
    Ok(())
}
