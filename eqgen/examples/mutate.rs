//! Breaks the physics in many small ways and counts how many the tests notice.
//!
//! ```text
//! cargo run -p sheave-eqgen --example mutate [-- WORDS]
//! ```
//!
//! Works on a copy of the workspace under the target folder. Each mutation replaces one piece of text in
//! `eqgen/src/physics`; it counts as found if generation refuses it (a dimension, a divisor) or if a test fails that
//! knows nothing of the committed copy. WORDS keep only mutations whose description holds one of them.

use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

/// File, text, what it becomes, what that is.
type Mutation = (&'static str, &'static str, &'static str, &'static str);

const MUTATIONS: &[Mutation] = &[
    ("kinematics", "F - G*V - {tractive}", "F + G*V - {tractive}", "sign of the momentum flow"),
    ("kinematics", "G/m_o*(1 + F/EA)", "G/m_o*(1 - F/EA)", "sign of the strain"),
    ("kinematics", "G/m_o*(1 + F/EA)", "2*G/m_o*(1 + F/EA)", "factor of the belt speed"),
    ("kinematics", "\"(R - x)/cos(theta)\"", "\"(R + x)/cos(theta)\"", "sign of the penetration in ds/dφ"),
    ("kinematics", "\"(R - x)/cos(theta)\"", "\"(R - x)*cos(theta)\"", "cosine on the wrong side in ds/dφ"),
    ("kinematics", "\"phi - theta\"", "\"phi + theta\"", "sign of θ in ψ"),
    ("kinematics", "\"-(R - x)*sin(theta)/cos(theta)\"", "\"(R - x)*sin(theta)/cos(theta)\"", "sign of x'"),
    ("kinematics", "\"-(R - x)*sin(theta)/cos(theta)\"", "\"-R*sin(theta)/cos(theta)\"", "dropped term in x'"),
    ("kinematics", "\"V*sin(theta)\"", "\"V*cos(theta)\"", "sine for cosine in v_r"),
    ("kinematics", "V*cos(theta) - (R - x)*omega", "V*cos(theta) + (R - x)*omega", "sign of the pulley's speed"),
    ("kinematics", "V*cos(theta) - (R - x)*omega", "V - (R - x)*omega", "dropped factor in v_t"),
    ("kinematics", "\"sigma*omega_P\"", "\"omega_P/sigma\"", "speed ratio upside down"),
    ("kinematics", "flow*m_o*R_P*omega_P", "flow*m_o*R_P*omega_P/2", "factor of the mass flow"),
    ("friction", "&[\"slip\"], \"Fig. 3.6\"", "&[\"2*slip\"], \"Fig. 3.6\"", "factor of the threshold"),
    ("friction", "&[\"4*slip\"]", "&[\"2*slip\"]", "factor of the smooth law"),
    ("friction", "\"mu*v_r/face_speed\"", "\"-mu*v_r/face_speed\"", "sign of radial friction"),
    ("friction", "\"mu*v_t/face_speed\"", "\"mu*v_r/face_speed\"", "swapped component of friction"),
    ("friction", "\"mu*v_t/face_speed\"", "\"mu*v_t/speed\"", "apparent sheave angle forgotten"),
    ("friction", "2*(cos(beta) + f_r", "2*(cos(beta) - f_r", "sign of friction in the pressure"),
    ("friction", "2*(cos(beta) + f_r", "(cos(beta) + f_r", "factor of the pressure"),
    (
        "friction",
        "\"q*(sin(beta) - f_r + f_t*tan_theta)\"",
        "\"q*(sin(beta) + f_r + f_t*tan_theta)\"",
        "sign of f_r in n",
    ),
    ("friction", "\"q*(sin(beta) - f_r + f_t*tan_theta)\"", "\"q*(sin(beta) - f_r)\"", "dropped term in n"),
    ("friction", "\"q*(f_t + (f_r - sin(beta))*tan_theta)\"", "\"q*(f_t - (f_r - sin(beta))*tan_theta)\"", "sign in t"),
    (
        "friction",
        "\"q*(f_t + (f_r - sin(beta))*tan_theta)\"",
        "\"q*(f_t + (f_r - cos(beta))*tan_theta)\"",
        "cosβ for sinβ in t",
    ),
    (
        "beam",
        "\"theta_2\", \"x\", \"x_1\", \"x_2\"]",
        "\"theta_2\", \"x\", \"x_1\", \"theta_3\"]",
        "what is small in (3.37)",
    ),
    ("beam", "let moment = read(\"M_b\", \"EI\")?", "let moment = read(\"M_b\", \"-EI\")?", "sign of the moment"),
    (
        "contact",
        "\"T*(1 - theta_1) - n - Q_theta3",
        "\"T*(1 - theta_1) - n + Q_theta3",
        "sign of Q' (as (3.28) prints it)",
    ),
    ("contact", "\"T*(1 - theta_1) - n - Q_theta3", "\"T*(1 + theta_1) - n - Q_theta3", "sign of θ' across the belt"),
    ("contact", "\"t - Q*(1 - theta_1)\"", "\"t + Q*(1 - theta_1)\"", "sign of Q along the belt"),
    ("contact", "\"t - Q*(1 - theta_1)\"", "\"t - Q\"", "dropped term along the belt"),
    ("contact", "\"theta1/Phi\"", "\"theta1*Phi\"", "Φ on the wrong side"),
    ("contact", "\"Phi^3*theta_3\"", "\"Phi^2*theta_3\"", "power of Φ"),
    ("span", "\"tau_1 + Q*vartheta_1\"", "\"tau_1 - Q*vartheta_1\"", "sign of Q along a span"),
    ("span", "\"tau*vartheta_1 - EI*vartheta_3\"", "\"tau*vartheta_1 + EI*vartheta_3\"", "sign of Q' across a span"),
    ("span", "\"L^3\"", "\"L^2\"", "power of L"),
    ("energy", "\"Phi*q*f_t*arc\"", "\"Phi*q*f_r*arc\"", "component of friction in the torque"),
    ("energy", "\"k*x/2\"", "\"k*x\"", "factor of the axial force"),
    ("energy", "\"Phi*arc/stretch\"", "\"Phi*arc*stretch\"", "stretch upside down"),
    ("energy", "\"2*p*f_r*v_r/cos(beta)^2\"", "\"2*p*f_r*v_r\"", "the sheave's slope in the loss"),
    ("energy", "\"A_hat_1*r*sin(Phi*s)\"", "\"A_hat_1*r*cos(Phi*s)\"", "moment about the wrong axis"),
    (
        "boundary",
        "direction: \"C_P + pi/2 - theta_P1\"",
        "direction: \"C_P + pi/2 + theta_P1\"",
        "sign of θ at the primary's entry",
    ),
    (
        "boundary",
        "3*pi/2 - C_S - Phi_S*s_2 - theta_S1",
        "3*pi/2 - C_S - Phi_S*s_2 + theta_S1",
        "sign of θ_S1 (as (5.23) prints it)",
    ),
    ("boundary", "[\"R_P*cos(C_P)\", \"R_P*sin(C_P)\"]", "[\"R_P*sin(C_P)\", \"R_P*cos(C_P)\"]", "swapped coordinates"),
    ("boundary", "\"R_S*sin(C_S + Phi_S*s_2)\"", "\"R_S*sin(C_S)\"", "dropped wrap angle"),
    ("boundary", "span: \"t2\"", "span: \"t1\"", "wrong end of the tight span"),
    ("boundary", "\"M_P + M_in\"", "\"M_P - M_in\"", "sign of the driving torque"),
    ("boundary", "\"T_P2 - T_slack\"", "\"T_P1 - T_slack\"", "slack tension at the wrong end"),
    ("string", "\"T*(1 - theta_1) - n\"", "\"T*(1 + theta_1) - n\"", "sign of θ' across a string"),
    ("string", "\"Phi*theta_1\"", "\"2*Phi*theta_1\"", "factor of the angle along a string"),
    ("outputs", "\"Phi_P*s_2\"", "\"-Phi_P*s_2\"", "sign of the wrap angle"),
    (
        "outputs",
        "(cos(C_P)*A_x_P - sin(C_P)*A_y_P)/A_P",
        "(cos(C_P)*A_x_P + sin(C_P)*A_y_P)/A_P",
        "sign in the resultant",
    ),
    ("outputs", "\"speed_ratio*R_S/R_P\"", "\"speed_ratio*R_P/R_S\"", "speed efficiency upside down"),
    (
        "outputs",
        "\"L_o_P + L_o_s + L_o_S + L_o_t\"",
        "\"L_o_P + L_o_s + L_o_S\"",
        "a span forgotten in the belt's length",
    ),
];

/// Tests that know nothing of the committed copy.
const TESTS: [(&str, &[&str]); 2] =
    [("eqgen", &["printed_forms", "checks"]), ("generated", &["appendix", "naive", "outputs", "differences"])];

fn main() -> ExitCode {
    match run() {
        Ok((found, of)) => {
            println!("{found} of {of} mutations found");
            if found == of { ExitCode::SUCCESS } else { ExitCode::FAILURE }
        }
        Err(error) => {
            eprintln!("{error}");
            ExitCode::FAILURE
        }
    }
}

fn run() -> std::io::Result<(usize, usize)> {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("..");
    let copy = std::env::temp_dir().join("sheave-mutants");
    mirror(&source, &copy)?;
    if let Some(reason) = killed(&copy)? {
        return Err(std::io::Error::other(format!("the tests fail before anything is broken: {reason}")));
    }
    let wanted = |mutation: &&Mutation| words.is_empty() || words.iter().any(|word| mutation.3.contains(word.as_str()));
    let (mut found, mut of) = (0, 0);
    for (file, from, to, what) in MUTATIONS.iter().filter(wanted) {
        let path = copy.join(format!("eqgen/src/physics/{file}.rs"));
        let text = std::fs::read_to_string(&path)?;
        let times = text.matches(from).count();
        if times == 0 {
            println!("STALE   {file}: {what}: `{from}` stands nowhere");
            of += 1;
            continue;
        }
        std::fs::write(&path, text.replacen(from, to, 1))?;
        let killer = killed(&copy)?;
        std::fs::write(&path, &text)?;
        of += 1;
        match killer {
            Some(killer) => {
                found += 1;
                println!("found   {file}: {what} ({killer})");
            }
            None => println!("MISSED  {file}: {what}"),
        }
    }
    Ok((found, of))
}

/// What notices the mutation: the first line that says so.
fn killed(copy: &Path) -> std::io::Result<Option<String>> {
    for (package, tests) in TESTS {
        let mut cargo = Command::new(env!("CARGO"));
        cargo.args(["test", "--quiet", "--package", package]).current_dir(copy).stdout(Stdio::piped());
        tests.iter().for_each(|test| {
            cargo.args(["--test", test]);
        });
        let output = cargo.env("RUST_BACKTRACE", "0").stderr(Stdio::piped()).output()?;
        if !output.status.success() {
            let text =
                format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
            return Ok(Some(reason(&text)));
        }
    }
    Ok(None)
}

fn reason(text: &str) -> String {
    let refused = text.lines().find(|line| line.trim_start().starts_with("Error: "));
    let failed = text.lines().find(|line| line.contains(" panicked at "));
    let line = refused.or(failed).unwrap_or("does not compile").trim();
    let short: String = line.chars().take(110).collect();
    short.replace("thread ", "")
}

/// Copies the workspace without its history and build results; files that are the same are left alone.
fn mirror(from: &Path, to: &Path) -> std::io::Result<()> {
    std::fs::create_dir_all(to)?;
    for entry in std::fs::read_dir(from)? {
        let entry = entry?;
        let (path, target): (PathBuf, PathBuf) = (entry.path(), to.join(entry.file_name()));
        if entry.file_type()?.is_dir() {
            if entry.file_name() != "target" && entry.file_name() != ".git" {
                mirror(&path, &target)?;
            }
        } else {
            let bytes = std::fs::read(&path)?;
            if !std::fs::read(&target).is_ok_and(|old| old == bytes) {
                std::fs::write(&target, bytes)?;
            }
        }
    }
    Ok(())
}
