//! A belt map as a Functional Mock-up Unit for co-simulation (FMI 2.0.4): the shared library of the unit.
//!
//! The unit has no states: its outputs are functions of its inputs, the coordinates of the map, and change with them at
//! once. It reads its table from `resources/map.bin`, which the Python package writes; cubic Hermite interpolation and
//! its exact derivatives are those of the map itself. Nothing is extrapolated: outside the map `valid` is false, and
//! outputs are not numbers unless the parameter `hold` asks for those at the nearest point of the map's range.
//!
//! It depends on nothing but the standard library, so that it is small and loads anywhere.
#![allow(non_snake_case, reason = "names of the standard")]

use std::collections::HashMap;
use std::ffi::{CStr, CString, c_char, c_void};
use std::panic::{AssertUnwindSafe, catch_unwind};

mod table;
use table::Table;

type Status = i32;
const OK: Status = 0;
const WARNING: Status = 1;
const ERROR: Status = 3;

/// Value references: inputs from 0, then the quantities of the table, then what follows from them.
const HOLD: u32 = 1000;
const VALID: u32 = 1001;

type Logger = unsafe extern "C" fn(*mut c_void, *const c_char, Status, *const c_char, *const c_char, ...);

/// `fmi2CallbackFunctions`.
#[repr(C)]
pub struct Callbacks {
    logger: Option<Logger>,
    allocate: *const c_void,
    free: *const c_void,
    finished: *const c_void,
    environment: *mut c_void,
}

/// One unit.
struct Unit {
    name: CString,
    logger: Option<Logger>,
    environment: *mut c_void,
    table: Table,
    state: State,
}

/// What changes while it runs: all of it can be kept and put back.
#[derive(Clone)]
struct State {
    inputs: Vec<f64>,
    hold: bool,
    /// Whether the outputs are those of the inputs.
    current: bool,
    valid: bool,
    /// Whether the simulator was told that the inputs are outside.
    told: bool,
    outputs: Vec<f64>,
    /// By output, its derivative by each input.
    slopes: Vec<Vec<f64>>,
}

impl Unit {
    fn log(&self, status: Status, message: &str) {
        let Some(logger) = self.logger else { return };
        let Ok(text) = CString::new(message.replace('%', "%%")) else { return };
        // SAFETY: the simulator gave the function and its environment, and the texts live throughout the call.
        unsafe { logger(self.environment, self.name.as_ptr(), status, c"".as_ptr(), text.as_ptr()) };
    }

    /// The outputs of the inputs.
    fn update(&mut self) -> Status {
        if self.state.current {
            return OK;
        }
        self.state.current = true;
        let inside = self.table.at(&self.state.inputs);
        self.state.valid = inside.is_some();
        let held = (inside.is_none() && self.state.hold).then(|| self.table.nearest(&self.state.inputs));
        let found = inside.or_else(|| self.table.at(held.as_ref()?));
        let count = self.table.outputs();
        let none = || (vec![f64::NAN; count], vec![vec![f64::NAN; self.state.inputs.len()]; count]);
        let held = held.filter(|_| found.is_some());
        (self.state.outputs, self.state.slopes) = found.map_or_else(none, |found| self.table.derived(found));
        // What an input is held at does not move with it.
        for (axis, at) in held.iter().flatten().enumerate() {
            if *at != self.state.inputs[axis] {
                self.state.slopes.iter_mut().for_each(|slopes| slopes[axis] = 0.0);
            }
        }
        if self.state.valid {
            self.state.told = false;
            return OK;
        }
        if !self.state.told {
            self.state.told = true;
            let inputs = self.table.axes.iter().zip(&self.state.inputs);
            let inputs: Vec<String> = inputs
                .map(|(axis, value)| {
                    let (from, to) = axis.range();
                    format!("{} = {value} ({from} to {to})", axis.name)
                })
                .collect();
            self.log(WARNING, &format!("no value of the map at {}: outside its range, or slipping", inputs.join(", ")));
        }
        WARNING
    }

    fn real(&mut self, reference: u32) -> Option<f64> {
        let at = reference as usize;
        if let Some(input) = self.state.inputs.get(at) {
            return Some(*input);
        }
        self.update();
        self.state.outputs.get(at - self.state.inputs.len()).copied()
    }
}

/// The path of a `file:` URI.
fn path_of(uri: &str) -> Option<std::path::PathBuf> {
    let rest = uri.strip_prefix("file:")?;
    let rest = rest.strip_prefix("//").map_or(rest, |host| host.find('/').map_or("", |at| &host[at..]));
    let mut bytes = Vec::with_capacity(rest.len());
    let mut left = rest.bytes();
    while let Some(byte) = left.next() {
        let escaped = byte == b'%';
        bytes.push(if escaped {
            let digits = [left.next()?, left.next()?];
            u8::from_str_radix(std::str::from_utf8(&digits).ok()?, 16).ok()?
        } else {
            byte
        });
    }
    let path = String::from_utf8(bytes).ok()?;
    // On Windows, /C:/...
    let drive = path.as_bytes().get(2) == Some(&b':');
    Some(if drive { path[1..].into() } else { path.into() })
}

/// What a function does with a unit; a defect of this library ends as an error of the unit, not of the simulator.
fn with(component: *mut c_void, act: impl FnOnce(&mut Unit) -> Status) -> Status {
    if component.is_null() {
        return ERROR;
    }
    // SAFETY: the simulator hands back what `fmi2Instantiate` gave, and calls a unit from one thread at a time.
    let unit = unsafe { &mut *component.cast::<Unit>() };
    catch_unwind(AssertUnwindSafe(|| act(unit))).unwrap_or(ERROR)
}

/// A slice of what the simulator points at.
///
/// # Safety
/// `first` points at `count` values, unless there are none.
unsafe fn given<'a, T>(first: *const T, count: usize) -> &'a [T] {
    if count == 0 || first.is_null() { &[] } else { unsafe { std::slice::from_raw_parts(first, count) } }
}

/// As [`given`], to be written.
///
/// # Safety
/// As there.
unsafe fn wanted<'a, T>(first: *mut T, count: usize) -> &'a mut [T] {
    if count == 0 || first.is_null() { &mut [] } else { unsafe { std::slice::from_raw_parts_mut(first, count) } }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetTypesPlatform() -> *const c_char {
    c"default".as_ptr()
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetVersion() -> *const c_char {
    c"2.0".as_ptr()
}

/// # Safety
/// As the standard has it: texts end with a zero, `callbacks` outlives the unit.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2Instantiate(
    name: *const c_char,
    _kind: i32,
    guid: *const c_char,
    resources: *const c_char,
    callbacks: *const Callbacks,
    _visible: i32,
    _logging: i32,
) -> *mut c_void {
    let text = |at: *const c_char| if at.is_null() { None } else { unsafe { CStr::from_ptr(at) }.to_str().ok() };
    let name = text(name).and_then(|name| CString::new(name).ok()).unwrap_or_default();
    let (logger, environment) = match unsafe { callbacks.as_ref() } {
        Some(callbacks) => (callbacks.logger, callbacks.environment),
        None => (None, std::ptr::null_mut()),
    };
    let read = || -> Result<Table, String> {
        let uri = text(resources).ok_or("no place of resources is given")?;
        let folder = path_of(uri).ok_or_else(|| format!("{uri} is no file: URI"))?;
        let path = folder.join("map.bin");
        let bytes = std::fs::read(&path).map_err(|error| format!("cannot read {}: {error}", path.display()))?;
        let table = Table::read(&bytes).ok_or_else(|| format!("{} is no table of a belt map", path.display()))?;
        match text(guid) {
            Some(guid) if guid == table.guid => Ok(table),
            other => Err(format!("the unit's GUID is {}, not {}", table.guid, other.unwrap_or("none"))),
        }
    };
    let table = catch_unwind(read).unwrap_or_else(|_| Err("the table cannot be read".into()));
    let refused = |message: &str| {
        let told = CString::new(message.replace('%', "%%")).unwrap_or_default();
        if let Some(logger) = logger {
            // SAFETY: as in `Unit::log`.
            unsafe { logger(environment, name.as_ptr(), ERROR, c"".as_ptr(), told.as_ptr()) };
        }
        std::ptr::null_mut()
    };
    match table {
        Err(message) => refused(&message),
        Ok(table) => {
            let state = State::of(&table);
            Box::into_raw(Box::new(Unit { name, logger, environment, table, state })).cast()
        }
    }
}

impl State {
    /// In the middle of the map.
    fn of(table: &Table) -> Self {
        let inputs = table.axes.iter().map(|axis| axis.start).collect();
        Self { inputs, hold: false, current: false, valid: false, told: false, outputs: Vec::new(), slopes: Vec::new() }
    }
}

/// # Safety
/// `component` is a unit that is not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeInstance(component: *mut c_void) {
    if !component.is_null() {
        drop(unsafe { Box::from_raw(component.cast::<Unit>()) });
    }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetDebugLogging(_: *mut c_void, _: i32, _: usize, _: *const *const c_char) -> Status {
    OK
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetupExperiment(_: *mut c_void, _: i32, _: f64, _: f64, _: i32, _: f64) -> Status {
    OK
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2EnterInitializationMode(component: *mut c_void) -> Status {
    with(component, |_| OK)
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2ExitInitializationMode(component: *mut c_void) -> Status {
    with(component, Unit::update)
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2Terminate(component: *mut c_void) -> Status {
    with(component, |_| OK)
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2Reset(component: *mut c_void) -> Status {
    with(component, |unit| {
        unit.state = State::of(&unit.table);
        OK
    })
}

/// # Safety
/// As the standard has it: the arrays have `count` elements each.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetReal(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut f64,
) -> Status {
    let (references, values) = unsafe { (given(references, count), wanted(values, count)) };
    with(component, |unit| {
        for (reference, value) in references.iter().zip(values) {
            let Some(found) = unit.real(*reference) else { return ERROR };
            *value = found;
        }
        OK
    })
}

/// # Safety
/// As [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetReal(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const f64,
) -> Status {
    let (references, values) = unsafe { (given(references, count), given(values, count)) };
    with(component, |unit| {
        for (reference, value) in references.iter().zip(values) {
            let Some(input) = unit.state.inputs.get_mut(*reference as usize) else { return ERROR };
            *input = *value;
            unit.state.current = false;
        }
        OK
    })
}

/// # Safety
/// As [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *mut i32,
) -> Status {
    let (references, values) = unsafe { (given(references, count), wanted(values, count)) };
    with(component, |unit| {
        for (reference, value) in references.iter().zip(values) {
            *value = i32::from(match *reference {
                HOLD => unit.state.hold,
                VALID => {
                    unit.update();
                    unit.state.valid
                }
                _ => return ERROR,
            });
        }
        OK
    })
}

/// # Safety
/// As [`fmi2GetReal`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetBoolean(
    component: *mut c_void,
    references: *const u32,
    count: usize,
    values: *const i32,
) -> Status {
    let (references, values) = unsafe { (given(references, count), given(values, count)) };
    with(component, |unit| {
        for (reference, value) in references.iter().zip(values) {
            if *reference != HOLD {
                return ERROR;
            }
            unit.state.hold = *value != 0;
            unit.state.current = false;
        }
        OK
    })
}

/// There are no integers and no texts.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetInteger(_: *mut c_void, _: *const u32, count: usize, _: *mut i32) -> Status {
    if count == 0 { OK } else { ERROR }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetInteger(_: *mut c_void, _: *const u32, count: usize, _: *const i32) -> Status {
    if count == 0 { OK } else { ERROR }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetString(_: *mut c_void, _: *const u32, count: usize, _: *mut *const c_char) -> Status {
    if count == 0 { OK } else { ERROR }
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetString(_: *mut c_void, _: *const u32, count: usize, _: *const *const c_char) -> Status {
    if count == 0 { OK } else { ERROR }
}

/// # Safety
/// `state` points at a place for a state.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetFMUstate(component: *mut c_void, state: *mut *mut c_void) -> Status {
    with(component, |unit| {
        let Some(place) = (unsafe { state.as_mut() }) else { return ERROR };
        if place.is_null() {
            *place = Box::into_raw(Box::new(unit.state.clone())).cast();
        } else {
            // SAFETY: a state that this function gave, whose content is freed.
            unsafe { *(*place).cast::<State>() = unit.state.clone() };
        }
        OK
    })
}

/// # Safety
/// `state` is one of this unit's.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2SetFMUstate(component: *mut c_void, state: *mut c_void) -> Status {
    with(component, |unit| {
        let Some(kept) = (unsafe { state.cast::<State>().as_ref() }) else { return ERROR };
        unit.state = kept.clone();
        OK
    })
}

/// # Safety
/// `state` is one of this unit's, and not used again.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2FreeFMUstate(_: *mut c_void, state: *mut *mut c_void) -> Status {
    if let Some(place) = unsafe { state.as_mut() }
        && !place.is_null()
    {
        drop(unsafe { Box::from_raw((*place).cast::<State>()) });
        *place = std::ptr::null_mut();
    }
    OK
}

/// States are not written into bytes: `canSerializeFMUstate` is false.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializedFMUstateSize(_: *mut c_void, _: *mut c_void, _: *mut usize) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2SerializeFMUstate(_: *mut c_void, _: *mut c_void, _: *mut u8, _: usize) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2DeSerializeFMUstate(_: *mut c_void, _: *const u8, _: usize, _: *mut *mut c_void) -> Status {
    ERROR
}

/// Derivatives of outputs by inputs, times a direction.
///
/// # Safety
/// As the standard has it.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn fmi2GetDirectionalDerivative(
    component: *mut c_void,
    unknowns: *const u32,
    unknown_count: usize,
    knowns: *const u32,
    known_count: usize,
    direction: *const f64,
    derivatives: *mut f64,
) -> Status {
    let (unknowns, knowns) = unsafe { (given(unknowns, unknown_count), given(knowns, known_count)) };
    let (direction, derivatives) = unsafe { (given(direction, known_count), wanted(derivatives, unknown_count)) };
    with(component, |unit| {
        let status = unit.update();
        let inputs = unit.state.inputs.len();
        let places = knowns.iter().map(|known| *known as usize);
        let along: HashMap<usize, f64> = places.zip(direction.iter().copied()).collect();
        for (unknown, derivative) in unknowns.iter().zip(derivatives) {
            let row = (*unknown as usize).checked_sub(inputs).and_then(|at| unit.state.slopes.get(at));
            let Some(row) = row else { return ERROR };
            *derivative = row.iter().enumerate().map(|(k, slope)| slope * along.get(&k).copied().unwrap_or(0.0)).sum();
        }
        status
    })
}

/// Inputs are held over a step: `maxOutputDerivativeOrder` is 0, and inputs are not interpolated.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2SetRealInputDerivatives(
    _: *mut c_void,
    _: *const u32,
    _: usize,
    _: *const i32,
    _: *const f64,
) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealOutputDerivatives(
    _: *mut c_void,
    _: *const u32,
    _: usize,
    _: *const i32,
    _: *mut f64,
) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2DoStep(component: *mut c_void, _time: f64, _step: f64, _keep: i32) -> Status {
    with(component, Unit::update)
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2CancelStep(_: *mut c_void) -> Status {
    ERROR
}

/// No step is ever pending.
#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStatus(_: *mut c_void, _: i32, _: *mut i32) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetRealStatus(_: *mut c_void, _: i32, _: *mut f64) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetIntegerStatus(_: *mut c_void, _: i32, _: *mut i32) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetBooleanStatus(_: *mut c_void, _: i32, _: *mut i32) -> Status {
    ERROR
}

#[unsafe(no_mangle)]
pub extern "C" fn fmi2GetStringStatus(_: *mut c_void, _: i32, _: *mut *const c_char) -> Status {
    ERROR
}
