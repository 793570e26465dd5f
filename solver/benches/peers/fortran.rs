//! The peers, compiled from their sources and loaded.

use std::ffi::{CString, c_char, c_int, c_void};
use std::path::Path;
use std::process::Command;
use std::sync::OnceLock;

pub type Rhs = extern "C" fn(*const c_int, *const f64, *const f64, *mut f64, *mut f64, *mut c_int);
pub type Boundary = extern "C" fn(*const c_int, *const c_int, *const f64, *mut f64, *mut f64, *mut c_int);
pub type Guess = extern "C" fn(*const f64, *mut f64, *mut f64, *mut f64, *mut c_int);

/// `COLNEW (NCOMP, M, ALEFT, ARIGHT, ZETA, ISET, LTOL, TOL, FIXPNT, ISPACE, FSPACE, IFLAG, FSUB, DFSUB, GSUB, DGSUB,
/// GUESS, RPAR, IPAR, ICOUNT)`
pub type Colnew = unsafe extern "C" fn(
    *const c_int,
    *const c_int,
    *const f64,
    *const f64,
    *const f64,
    *mut c_int,
    *const c_int,
    *const f64,
    *const f64,
    *mut c_int,
    *mut f64,
    *mut c_int,
    Rhs,
    Rhs,
    Boundary,
    Boundary,
    Guess,
    *mut f64,
    *mut c_int,
    *mut c_int,
);
/// `APPSLN (X, Z, FSPACE, ISPACE)`
pub type Appsln = unsafe extern "C" fn(*mut f64, *mut f64, *mut f64, *mut c_int);
/// `twpbvpc(ncomp, nlbc, aleft, aright, nfxpnt, fixpnt, ntol, ltol, tol, linear, givmsh, giveu, nmsh, nxxdim, xx,
/// nudim, u, nmax, lwrkfl, wrk, lwrkin, iwrk, precis, fsub, dfsub, gsub, dgsub, ckappa1, gamma1, sigma, ckappa,
/// ckappa2, rpar, ipar, iflbvp, liseries, iseries, indnms, full, useC, nmguess, xguess, nygdim, yguess, iset)`
pub type Twpbvpc = unsafe extern "C" fn(
    *const c_int,
    *const c_int,
    *const f64,
    *const f64,
    *const c_int,
    *const f64,
    *const c_int,
    *const c_int,
    *const f64,
    *const c_int,
    *const c_int,
    *const c_int,
    *mut c_int,
    *const c_int,
    *mut f64,
    *const c_int,
    *mut f64,
    *mut c_int,
    *const c_int,
    *mut f64,
    *const c_int,
    *mut c_int,
    *const f64,
    Rhs,
    Rhs,
    Boundary,
    Boundary,
    *mut f64,
    *mut f64,
    *mut f64,
    *mut f64,
    *mut f64,
    *mut f64,
    *mut c_int,
    *mut c_int,
    *const c_int,
    *mut c_int,
    *mut c_int,
    *const c_int,
    *const c_int,
    *const c_int,
    *const f64,
    *const c_int,
    *const f64,
    *mut c_int,
);

/// The peers' entry points.
pub struct Peers {
    pub colnew: Colnew,
    pub appsln: Appsln,
    pub twpbvpc: Twpbvpc,
}

static PEERS: OnceLock<Peers> = OnceLock::new();

/// Once [`load`] has succeeded.
pub fn peers() -> &'static Peers {
    PEERS.get().unwrap()
}

/// The routines through which the sources print to R do nothing here.
const SILENT: &str = "
      subroutine rprintf(m)
      character*(*) m
      end
      subroutine rprintfi1(m, i)
      character*(*) m
      end
      subroutine rprintfi2(m, i, j)
      character*(*) m
      end
      subroutine rprintfi3(m, i, j, k)
      character*(*) m
      end
      subroutine rprintfi4(m, i, j, k, l)
      character*(*) m
      end
      subroutine rprintfid(m, i, d)
      character*(*) m
      double precision d
      end
      subroutine rprintfdi(m, d, i)
      character*(*) m
      double precision d
      end
      subroutine rprintfdid(m, d, i, e)
      character*(*) m
      double precision d, e
      end
      subroutine rprintfd1(m, d)
      character*(*) m
      double precision d
      end
      subroutine rprintfd2(m, d, e)
      character*(*) m
      double precision d, e
      end
      subroutine rprintfd3(m, d, e, f)
      character*(*) m
      double precision d, e, f
      end
      subroutine rprintfd4(m, d, e, f, g)
      character*(*) m
      double precision d, e, f, g
      end
";

unsafe extern "C" {
    fn dlopen(path: *const c_char, flags: c_int) -> *mut c_void;
    fn dlsym(library: *mut c_void, name: *const c_char) -> *mut c_void;
}

/// Compiles the sources in `folder` and loads what comes out.
pub fn load(folder: &Path) -> Result<(), String> {
    let work = std::env::temp_dir().join(format!("sheave-solver-peers-{}", std::process::id()));
    std::fs::create_dir_all(&work).map_err(|error| error.to_string())?;
    let loaded = compile(folder, &work).and_then(|library| find(&library));
    // What is loaded stays loaded without its file.
    let _ = std::fs::remove_dir_all(&work);
    let _ = PEERS.set(loaded?);
    Ok(())
}

fn compile(folder: &Path, work: &Path) -> Result<std::path::PathBuf, String> {
    let (silent, library) = (work.join("silent.f"), work.join("libpeers.so"));
    std::fs::write(&silent, SILENT).map_err(|error| error.to_string())?;
    let sources = ["colnewR.f", "twpbvpc.f", "twpbvpa.f", "errmsg.f"].map(|name| folder.join(name));
    if let Some(missing) = sources.iter().find(|source| !source.is_file()) {
        return Err(format!("{} is missing: name the folder src of github.com/cran/bvpSolve", missing.display()));
    }
    let options = ["-O2", "-march=native", "-fPIC", "-shared", "-std=legacy", "-w", "-o"];
    let output = Command::new("gfortran").args(options).arg(&library).args(&sources).arg(&silent).output();
    let output = output.map_err(|error| format!("gfortran: {error} (apt-get install gfortran)"))?;
    if !output.status.success() {
        return Err(String::from_utf8_lossy(&output.stderr).into_owned());
    }
    Ok(library)
}

fn find(library: &Path) -> Result<Peers, String> {
    let c = |text: &str| CString::new(text).map_err(|error| error.to_string());
    let path = c(&library.to_string_lossy())?;
    // SAFETY: a string with its end; 2 binds all symbols now.
    let library = unsafe { dlopen(path.as_ptr(), 2) };
    if library.is_null() {
        return Err("what gfortran made cannot be loaded".to_owned());
    }
    let symbol = |name: &str| -> Result<*mut c_void, String> {
        let text = c(name)?;
        // SAFETY: a loaded library and a string with its end.
        let found = unsafe { dlsym(library, text.as_ptr()) };
        if found.is_null() { Err(format!("{name} is not among what was compiled")) } else { Ok(found) }
    };
    // SAFETY: the types above are those of the sources.
    unsafe {
        Ok(Peers {
            colnew: std::mem::transmute::<*mut c_void, Colnew>(symbol("colnew_")?),
            appsln: std::mem::transmute::<*mut c_void, Appsln>(symbol("appsln_")?),
            twpbvpc: std::mem::transmute::<*mut c_void, Twpbvpc>(symbol("twpbvpc_")?),
        })
    }
}
