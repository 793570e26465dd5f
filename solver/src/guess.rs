//! Where an iteration starts.

use crate::by_region::ByRegion;
use crate::collocation::Iterate;
use crate::collocation::grid::Grid;
use crate::error::GuessError;
use crate::mesh;
use crate::problem::Layout;
use crate::solution::{RegionSolution, Solution};

/// One region of a [`Guess`].
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct RegionGuess {
    /// `N + 1` increasing nodes that span the region's interval.
    pub mesh: Vec<f64>,
    /// For each state its values at the nodes.
    pub states: Vec<Vec<f64>>,
}

/// An initial guess: meshes, states and all constants. Given constants keep their values.
#[derive(Debug, Clone, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Guess {
    /// One for each region.
    pub regions: Vec<RegionGuess>,
    /// All constants of the layout, given and unknown.
    pub constants: Vec<f64>,
}

impl Guess {
    /// Samples `f(region, s, y)`, which writes the region's states, on uniform meshes.
    pub fn uniform(
        layout: &Layout,
        intervals: usize,
        constants: &[f64],
        f: impl FnMut(usize, f64, &mut [f64]),
    ) -> Self {
        let meshes = layout.regions.iter().map(|region| mesh::uniform(region.interval, intervals)).collect();
        Self::on(layout, meshes, constants, f)
    }

    /// Samples `f(region, s, y)`, which writes the region's states, on given meshes.
    pub fn on(
        layout: &Layout,
        meshes: Vec<Vec<f64>>,
        constants: &[f64],
        mut f: impl FnMut(usize, f64, &mut [f64]),
    ) -> Self {
        let regions = meshes.into_iter().zip(&layout.regions).enumerate().map(|(index, (mesh, region))| {
            let mut y = vec![0.0; region.states.len()];
            let mut states: Vec<Vec<f64>> = y.iter().map(|_| Vec::with_capacity(mesh.len())).collect();
            for &s in &mesh {
                f(index, s, &mut y);
                states.iter_mut().zip(&y).for_each(|(values, y)| values.push(*y));
            }
            RegionGuess { mesh, states }
        });
        Self { regions: regions.collect(), constants: constants.to_vec() }
    }

    /// # Errors
    /// The first thing that does not fit the layout.
    pub fn check(&self, layout: &Layout) -> Result<(), GuessError> {
        expect(|| "regions in the guess".to_owned(), self.regions.len(), layout.regions.len())?;
        expect(|| "constants in the guess".to_owned(), self.constants.len(), layout.constants.len())?;
        if let Some(index) = self.constants.iter().position(|c| !c.is_finite()) {
            return Err(GuessError::NotFinite(format!("constant {}", layout.constants[index].name)));
        }
        for (guess, region) in self.regions.iter().zip(&layout.regions) {
            check_mesh(&guess.mesh, region.interval)
                .map_err(|problem| GuessError::Mesh { region: region.name.clone(), problem })?;
            expect(|| format!("states of region {}", region.name), guess.states.len(), region.states.len())?;
            for (values, state) in guess.states.iter().zip(&region.states) {
                let what = || format!("values of {} in region {}", state.name, region.name);
                expect(what, values.len(), guess.mesh.len())?;
                if values.iter().any(|y| !y.is_finite()) {
                    return Err(GuessError::NotFinite(format!("{} of region {}", state.name, region.name)));
                }
            }
        }
        Ok(())
    }

    pub(crate) fn grids(&self) -> Vec<Grid> {
        self.regions.iter().map(|region| Grid::new(region.mesh.clone())).collect()
    }

    pub(crate) fn iterate(&self, grids: &[Grid]) -> Iterate {
        let pack = |(region, grid): (&RegionGuess, &Grid)| grid.pack_all(&region.states);
        let y = self.regions.iter().zip(grids).map(pack).collect();
        Iterate { y, inner: ByRegion::default(), constants: self.constants.clone() }
    }

    /// Intervals of all regions.
    pub fn intervals(&self) -> usize {
        self.regions.iter().map(|region| region.mesh.len().saturating_sub(1)).sum()
    }
}

impl From<&Solution> for Guess {
    fn from(solution: &Solution) -> Self {
        let regions = solution.regions().iter().map(RegionGuess::from).collect();
        Self { regions, constants: solution.constants().to_vec() }
    }
}

impl From<&RegionSolution> for RegionGuess {
    fn from(region: &RegionSolution) -> Self {
        let states = (0..region.states()).map(|i| region.state(i).to_vec()).collect();
        Self { mesh: region.mesh().to_vec(), states }
    }
}

/// What is counted is put into words only where the count is wrong.
fn expect(what: impl Fn() -> String, given: usize, expected: usize) -> Result<(), GuessError> {
    if given == expected { Ok(()) } else { Err(GuessError::Shape { what: what(), given, expected }) }
}

fn check_mesh(mesh: &[f64], (a, b): (f64, f64)) -> Result<(), String> {
    if mesh.len() < 2 {
        return Err("has fewer than two nodes".to_owned());
    }
    if let Some(pair) = mesh.windows(2).find(|pair| !(pair[0] < pair[1])) {
        return Err(format!("does not increase from {} to {}", pair[0], pair[1]));
    }
    if mesh[0] != a || mesh[mesh.len() - 1] != b {
        return Err(format!("spans [{}, {}], not [{a}, {b}]", mesh[0], mesh[mesh.len() - 1]));
    }
    Ok(())
}
