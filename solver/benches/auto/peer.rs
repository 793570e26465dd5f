//! AUTO-07p: found, compiled with a demo's equations, run and read.

use crate::Run;
use crate::demos::{Demo, Located, Wanted};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::{env, fmt, fs, io};

/// Names AUTO's folder, to AUTO itself too.
const VARIABLE: &str = "AUTO_DIR";
/// Where Debian puts it.
const USUAL: &str = "/usr/lib/auto-07p";

/// Where AUTO is: its object files.
pub struct Auto {
    objects: Vec<PathBuf>,
}

/// A demo's program.
pub struct Program {
    demo: &'static Demo,
    folder: PathBuf,
    /// What AUTO says of a run that ends with its first point.
    start: f64,
}

#[derive(Debug, Clone, Copy)]
pub struct Configuration {
    /// Intervals, and collocation points in each.
    intervals: usize,
    points: usize,
    /// Of Newton's iteration, and of what is located.
    tolerance: f64,
    location: f64,
    step: f64,
    largest_step: f64,
}

impl fmt::Display for Configuration {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { intervals, points, tolerance, location, step, largest_step } = self;
        write!(f, "{intervals} × {points}, {tolerance:.0e}, {location:.0e}, step {step} to {largest_step}")
    }
}

pub fn configurations(demo: &Demo) -> Vec<Configuration> {
    let mut all = Vec::new();
    for intervals in [4, 6, 8, 10, 15, 20, 30] {
        for points in [3, 4, 5, 7] {
            for (tolerance, location) in [(1e-7, 1e-6), (1e-7, 1e-8), (1e-9, 1e-10)] {
                for &largest_step in demo.largest_steps {
                    for step in [0.01, 0.2] {
                        all.push(Configuration { intervals, points, tolerance, location, step, largest_step });
                    }
                }
            }
        }
    }
    all
}

impl Auto {
    /// # Errors
    /// What is missing, in a sentence.
    pub fn found() -> Result<Self, String> {
        let folder = env::var_os(VARIABLE).map_or_else(|| PathBuf::from(USUAL), PathBuf::from).join("lib");
        let listed = fs::read_dir(&folder).map_err(|error| {
            let folder = folder.display();
            format!("AUTO's object files are not in {folder} ({error}): install auto-07p, or set {VARIABLE}")
        })?;
        let files = listed.filter_map(|entry| Some(entry.ok()?.path()));
        let objects: Vec<PathBuf> = files.filter(|file| file.extension().is_some_and(|end| end == "o")).collect();
        if objects.is_empty() {
            return Err(format!("there are no object files in {}: build AUTO first", folder.display()));
        }
        match Command::new("gfortran").arg("--version").output() {
            Ok(_) => Ok(Self { objects }),
            Err(error) => Err(format!("gfortran, which AUTO compiles equations with, does not run ({error})")),
        }
    }

    /// Writes the equations and compiles them.
    pub fn program(&self, demo: &'static Demo) -> io::Result<Program> {
        let folder = env::temp_dir().join(format!("branches-{}-{}", demo.name, std::process::id()));
        fs::create_dir_all(&folder)?;
        let zeros = "  par(1:3) = 0\n  u = 0\nend subroutine\n";
        let start = format!(
            "subroutine stpnt(ndim, u, par, t)\n  implicit none\n  integer, intent(in) :: ndim\n  double precision, \
             intent(inout) :: u(ndim), par(*)\n  double precision, intent(in) :: t\n{zeros}"
        );
        let unused = "subroutine fopt\nend subroutine\nsubroutine pvls\nend subroutine\n";
        fs::write(folder.join("equations.f90"), format!("{}\n{start}\n{unused}", demo.fortran))?;
        let mut compiler = Command::new("gfortran");
        compiler.current_dir(&folder).args(["-O2", "-fopenmp", "equations.f90"]).args(&self.objects);
        let compiled = compiler.args(["-o", "program"]).output()?;
        if !compiled.status.success() {
            return Err(io::Error::other(String::from_utf8_lossy(&compiled.stderr).into_owned()));
        }
        let mut program = Program { demo, folder, start: 0.0 };
        let some = configurations(demo)[0];
        let starts = (0..20).filter_map(|_| program.seconds(&some, 1));
        program.start = starts.fold(f64::INFINITY, f64::min);
        Ok(program)
    }
}

impl Program {
    /// `None` if AUTO fails.
    pub fn run(&self, configuration: &Configuration, reference: &Located) -> Option<Run> {
        let seconds = self.seconds(configuration, 400)?;
        let (located, points) = read(&self.folder.join("fort.7"))?;
        Some(Run { seconds: seconds - self.start, error: self.demo.wanted.error(&located, reference), points })
    }

    /// The time that AUTO prints.
    fn seconds(&self, configuration: &Configuration, most: usize) -> Option<f64> {
        fs::write(self.folder.join("fort.2"), constants(self.demo, configuration, most)).ok()?;
        let mut command = Command::new(Path::new("./program"));
        command.current_dir(&self.folder).env("OMP_NUM_THREADS", "1").stderr(Stdio::null());
        let output = command.output().ok()?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        let line = text.lines().rev().find(|line| line.contains("Total Time"))?;
        line.split_whitespace().last()?.parse().ok()
    }
}

impl Drop for Program {
    fn drop(&mut self) {
        // What is left in the folder for temporary files is no failure.
        let _ = fs::remove_dir_all(&self.folder);
    }
}

/// AUTO's file of constants: those of its demos, but for what a configuration says.
fn constants(demo: &Demo, configuration: &Configuration, most: usize) -> String {
    let &Configuration { intervals, points, tolerance, location, step, largest_step } = configuration;
    let [boundary, integral] = demo.conditions;
    let double = |value: f64| format!("{value:e}").replace('e', "D");
    let (branch_points, end) = match demo.wanted {
        Wanted::Fold { at, .. } => (1, format!("UZR = {{1: [{at:?}]}}, STOP = ['UZ2']")),
        Wanted::BranchPoints { to, .. } => (2, format!("UZSTOP = {{1: {to:?}}}")),
    };
    let [tolerance, location] = [tolerance, location].map(double);
    format!(
        "NDIM = 2, IPS = 4, IRS = 0, ILP = 1\nICP = [1]\nNTST = {intervals}, NCOL = {points}, IAD = 3, ISP = \
         {branch_points}, ISW = 1, IPLT = 0, NBC = {boundary}, NINT = {integral}\nNMX = {most}, NPR = 0, MXBF = 10, \
         IID = 0, ITMX = 20, ITNW = 8, NWTN = 3, JAC = 1\nEPSL = {tolerance}, EPSU = {tolerance}, EPSS = \
         {location}\nDS = {step}, DSMIN = 0.0001, DSMAX = {largest_step}, IADS = 1\nNPAR = 3, THL = {{}}, THU = \
         {{}}\n{end}\n"
    )
}

/// What AUTO has located, and its points: of each its number, its kind, its label, λ, a norm of u, and the largest u
/// and u', which u'(0) is here.
fn read(file: &Path) -> Option<(Located, usize)> {
    let text = fs::read_to_string(file).ok()?;
    let (mut located, mut points) = (Located::default(), 0);
    for line in text.lines() {
        let fields: Vec<f64> = line.split_whitespace().map_while(|field| field.parse().ok()).collect();
        let [branch, _, kind, _, lambda, _, _, slope, ..] = fields[..] else { continue };
        if branch == 0.0 {
            continue;
        }
        points += 1;
        match kind as i64 % 10 {
            -4 => located.met.push([lambda, slope]),
            5 => located.folds.push(lambda),
            6 => located.branch_points.push(lambda),
            _ => {}
        }
    }
    Some((located, points))
}
