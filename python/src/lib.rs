//! `sheave` for Python: the functions and types of the module `sheave._sheave`, from which the package `sheave` is
//! made. What is Python's own affair (units of pint, tables of pandas, figures of matplotlib) is written in Python, in
//! `sheave/`; here stands what touches the Rust library.

mod beltmap;
mod bench;
mod bvp;
mod case;
mod convert;
mod design;
mod equilibrium;
mod error;
mod figure;
mod file;
mod fmu;
mod interrupt;
mod parts;
mod profile;
mod result;
mod study;
mod table;
mod tune;

use pyo3::prelude::*;

/// The extension module.
#[pymodule]
mod _sheave {
    #[pymodule_export]
    use crate::beltmap::{BeltMap, map};
    #[pymodule_export]
    use crate::bench::{belt, compare, dyno};
    #[pymodule_export]
    use crate::bvp::{BvpSolution, solve_bvp};
    #[pymodule_export]
    use crate::case::{Case, keys, rebuild_case};
    #[pymodule_export]
    use crate::design::{limit, optimum};
    #[pymodule_export]
    use crate::equilibrium::{ShiftBranches, drive, shift};
    #[pymodule_export]
    use crate::fmu::fmu_library;
    #[pymodule_export]
    use crate::profile::{Profile, Region};
    #[pymodule_export]
    use crate::result::{
        BeltResult, Efficiency, Energy, Harmonics, Heat, Hysteresis, Losses, MeshIntervals, OtherSolution, Pulley,
        Result, SolverReport, Span, bare_seconds, solve,
    };
    #[pymodule_export]
    use crate::study::{Study, rebuild_study};
    #[pymodule_export]
    use crate::table::{Table, rebuild_table};
    #[pymodule_export]
    use crate::tune::{Ranked, tune};
    use pyo3::prelude::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
