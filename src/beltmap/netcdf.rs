//! Maps as NetCDF in its classic format: one array a quantity over the axes' breakpoints, as lookup tables take them.

use super::axis::MapAxis;
use super::map::BeltMap;
use super::quantity::{Node, Quantity};
use super::record::{ATTRIBUTE, STATUS, flag_meanings};
use netcdf3::{DataSet, FileWriter, InvalidDataSet, Version, WriteError};
use std::io::{self, Write};

/// A variable with its numbers.
struct Variable {
    name: String,
    unit: String,
    values: Vec<f64>,
}

/// Writes a map. Dimensions and variables are named as keys and quantities, with `_` for dots and without sections
/// where that is one of the map's axes: `primary_axial_force(ratio, primary_torque, slack_tension)`; derivatives as
/// `primary_axial_force_by_ratio`. A quantity that is an axis is told by its breakpoints alone. A node without a
/// solution is not a number, and `status` says why. (Without an attribute `_FillValue`: the crate finds a variable by
/// comparing it, and not a number equals nothing.)
pub(super) fn write(map: &BeltMap, to: &mut (dyn Write + Send + '_)) -> io::Result<()> {
    let axes: Vec<String> = map.axes.iter().map(|axis| axis.key().entry().name().to_owned()).collect();
    let variables = variables(map, &axes);
    let status: Vec<i8> = map.nodes.iter().map(Node::number).collect();
    let data = data_set(map, map.head()?, &axes, &variables).map_err(refused)?;
    // The crate writes where it can seek.
    let file = tempfile::NamedTempFile::new()?;
    let written = || -> Result<(), WriteError> {
        let mut writer = FileWriter::open(file.path())?;
        writer.set_def(&data, Version::Classic, 0)?;
        for (axis, name) in map.axes.iter().zip(&axes) {
            writer.write_var_f64(name, axis.breakpoints())?;
        }
        writer.write_var_i8(STATUS, &status)?;
        for variable in &variables {
            writer.write_var_f64(&variable.name, &variable.values)?;
        }
        writer.close()
    };
    written().map_err(unwritten)?;
    io::copy(&mut file.reopen()?, to)?;
    Ok(())
}

/// A data set that the crate does not take, in words: its names and sizes are this program's.
fn refused(error: InvalidDataSet) -> io::Error {
    tracing::debug!("NetCDF: {error:?}");
    io::Error::other("internal error: a name or a size of the map is none in NetCDF; please report this case")
}

/// What went wrong while the file was written, in words.
fn unwritten(error: WriteError) -> io::Error {
    match error {
        WriteError::IOErrorKind(kind) => kind.into(),
        WriteError::ClassicVersionNotPossible => {
            io::Error::other("the map is too large for NetCDF's classic format: write it as CSV")
        }
        other => {
            tracing::debug!("NetCDF: {other:?}");
            io::Error::other("internal error: the map does not fit its own data set in NetCDF; please report this case")
        }
    }
}

fn name(of: &str) -> String {
    of.replace('.', "_")
}

fn variables(map: &BeltMap, axes: &[String]) -> Vec<Variable> {
    let value = |at: usize| move |node: &Node| node.sample().map_or(f64::NAN, |sample| sample.values[at]);
    let slope = |at: usize| move |node: &Node| node.sample().map_or(f64::NAN, |sample| sample.slopes[at]);
    // What an axis prescribes stands there, under that name.
    let is_axis = |quantity: &Quantity| axes.contains(&name(quantity.name()));
    let quantities = || map.quantities.iter().enumerate().filter(|(_, quantity)| !is_axis(quantity));
    let mut variables = Vec::new();
    for (at, quantity) in quantities() {
        let values = map.nodes.iter().map(value(at)).collect();
        variables.push(Variable { name: name(quantity.name()), unit: quantity.unit().into(), values });
    }
    for (at, derived) in map.derived_names().iter().enumerate() {
        let values = map.nodes.iter().map(|node| map.derived(node)[at]).collect();
        variables.push(Variable { name: name(derived), unit: "1".into(), values });
    }
    for (at, quantity) in quantities() {
        for (k, (axis, along)) in map.axes.iter().zip(axes).enumerate() {
            let values = map.nodes.iter().map(slope(at * axes.len() + k)).collect();
            let unit = slope_unit(*quantity, axis);
            variables.push(Variable { name: format!("{}_by_{along}", name(quantity.name())), unit, values });
        }
    }
    variables
}

fn slope_unit(quantity: Quantity, axis: &MapAxis) -> String {
    match axis.unit().as_ref() {
        "1" => quantity.unit().to_owned(),
        unit => format!("{}/({unit})", quantity.unit()),
    }
}

/// The file without its numbers; `head` is what it says of the map, as one line.
fn data_set(map: &BeltMap, head: String, axes: &[String], variables: &[Variable]) -> Result<DataSet, InvalidDataSet> {
    let mut data = DataSet::new();
    data.add_global_attr_string("title", "belt map of a rubber V-belt CVT")?;
    data.add_global_attr_string("source", concat!("sheave ", env!("CARGO_PKG_VERSION")))?;
    data.add_global_attr_f64("accuracy", vec![map.report.accuracy])?;
    data.add_global_attr_f64("largest_error", vec![map.report.error.largest])?;
    data.add_global_attr_f64("largest_error_of_linear_interpolation", vec![map.report.linear_error.largest])?;
    data.add_global_attr_string(ATTRIBUTE, head)?;
    for (axis, name) in map.axes.iter().zip(axes) {
        data.add_fixed_dim(name, axis.len())?;
    }
    for (axis, name) in map.axes.iter().zip(axes) {
        data.add_var_f64(name, &[name])?;
        data.add_var_attr_string(name, "units", axis.unit().as_ref())?;
        data.add_var_attr_string(name, "long_name", axis.key().entry().doc)?;
    }
    data.add_var_i8(STATUS, axes)?;
    data.add_var_attr_i8(STATUS, "flag_values", vec![0, 1, 2, 3])?;
    data.add_var_attr_string(STATUS, "flag_meanings", flag_meanings())?;
    for variable in variables {
        data.add_var_f64(&variable.name, axes)?;
        data.add_var_attr_string(&variable.name, "units", &variable.unit)?;
    }
    Ok(data)
}
