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
    let columns = |region: RegionId| {
        let kernel = belt.kernel(region);
        kernel.states.iter().chain(kernel.fields).map(header).collect::<Vec<_>>()
    };
    let mut seen = BTreeSet::new();
    let headers: Vec<String> =
        RegionId::ALL.into_iter().flat_map(columns).filter(|name| seen.insert(name.clone())).collect();
    let mut writer = csv::Writer::from_writer(to);
    writer.write_record(["region", "position"].into_iter().chain(headers.iter().map(String::as_str)))?;
    for region in RegionId::ALL {
        let sampled = Sampled::new(belt, solution, region, INNER);
        let own = columns(region);
        let values: Vec<&Vec<f64>> = sampled.states.iter().chain(&sampled.fields).collect();
        let places: Vec<Option<usize>> =
            headers.iter().map(|name| own.iter().position(|column| column == name)).collect();
        for (row, s) in sampled.s.iter().enumerate() {
            let cell = |place: &Option<usize>| place.map_or(String::new(), |at| values[at][row].to_string());
            let start = [region.name().to_owned(), s.to_string()];
            writer.write_record(start.into_iter().chain(places.iter().map(cell)))?;
        }
    }
    writer.flush()?;
    Ok(())
}
