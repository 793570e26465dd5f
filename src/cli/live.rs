//! `sheave live`: the page, served to this computer alone.

use super::stop::Stop;
use axum::Router;
use axum::body::{Body, Bytes};
use axum::extract::{DefaultBodyLimit, Path, Request, State};
use axum::http::{HeaderMap, HeaderValue, Response, StatusCode, header};
use axum::middleware::{Next, from_fn_with_state};
use axum::routing::{get, post};
use axum::serve::ListenerExt;
use clap::Args;
use sheave::live::Live;
use sheave::{Cancel, cancellable};
use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::num::NonZero;
use std::sync::{Arc, Mutex, PoisonError};
use tokio::net::TcpListener;
use tokio::sync::Semaphore;

/// Serve the page that shows a drive while its sliders move, to this computer alone
///
/// The page is the one that needs no server; here its questions are answered natively. It listens on the loopback
/// interface only, and nothing leaves the machine. Ctrl-C ends it.
#[derive(Debug, Args)]
pub struct Arguments {
    /// Port to listen on; 0 takes any that is free
    #[arg(long, default_value_t = 8377, value_name = "N")]
    port: u16,
}

/// Longest question, bytes.
const LONGEST: usize = 4 << 20;
/// Pages that are remembered; one more, and the oldest starts from nothing.
const PAGES: usize = 16;
/// Longest name of a page.
const LONGEST_NAME: usize = 64;

/// What the page's own `meta` element says, but for the module, which is not there.
const POLICY: &str = "default-src 'none'; script-src 'self'; style-src 'self'; img-src 'self' data:; \
                      connect-src 'self'; base-uri 'none'; form-action 'none'; frame-ancestors 'none'";

/// A file of the page: where it is asked for, what it is, and its text.
struct File(&'static str, &'static str, &'static str);

const SCRIPT: &str = "text/javascript; charset=utf-8";

/// The page. Its engine is the one that asks this program.
const FILES: [File; 19] = [
    File("/", "text/html; charset=utf-8", include_str!("../../web/page/index.html")),
    File("/index.html", "text/html; charset=utf-8", include_str!("../../web/page/index.html")),
    File("/style.css", "text/css; charset=utf-8", include_str!("../../web/page/style.css")),
    File("/icon.svg", "image/svg+xml", include_str!("../../web/page/icon.svg")),
    File("/engine.js", SCRIPT, include_str!("../../web/page/live-engine.js")),
    File("/main.js", SCRIPT, include_str!("../../web/page/main.js")),
    File("/dom.js", SCRIPT, include_str!("../../web/page/dom.js")),
    File("/format.js", SCRIPT, include_str!("../../web/page/format.js")),
    File("/colors.js", SCRIPT, include_str!("../../web/page/colors.js")),
    File("/drive.js", SCRIPT, include_str!("../../web/page/drive.js")),
    File("/chart.js", SCRIPT, include_str!("../../web/page/chart.js")),
    File("/controls.js", SCRIPT, include_str!("../../web/page/controls.js")),
    File("/readouts.js", SCRIPT, include_str!("../../web/page/readouts.js")),
    File("/share.js", SCRIPT, include_str!("../../web/page/share.js")),
    File("/belt.js", SCRIPT, include_str!("../../web/page/belt.js")),
    File("/shift.js", SCRIPT, include_str!("../../web/page/shift.js")),
    File("/whole.js", SCRIPT, include_str!("../../web/page/whole.js")),
    File("/tune.js", SCRIPT, include_str!("../../web/page/tune.js")),
    File("/gx9.toml", "text/plain; charset=utf-8", include_str!("../../web/page/gx9.toml")),
];

/// What is kept between the questions of one page.
type Kept = Arc<Mutex<Live>>;

/// What is kept between questions, for each page that is open, by its name.
#[derive(Clone)]
struct Pages {
    open: Arc<Mutex<Vec<(String, Kept)>>>,
    /// As many are answered at once as there are cores.
    cores: Arc<Semaphore>,
    address: SocketAddr,
}

impl Pages {
    fn new(address: SocketAddr) -> Self {
        let cores = std::thread::available_parallelism().map_or(1, NonZero::get);
        Self { open: Arc::default(), cores: Arc::new(Semaphore::new(cores)), address }
    }

    /// What is kept of a page.
    fn page(&self, name: &str) -> Kept {
        let mut open = self.open.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some((_, live)) = open.iter().find(|(other, _)| other == name) {
            return live.clone();
        }
        if open.len() >= PAGES {
            open.remove(0);
        }
        let live = Kept::default();
        open.push((name.to_owned(), live.clone()));
        live
    }

    /// Forgets a page whose question ended in a defect of the program.
    fn forget(&self, name: &str) {
        self.open.lock().unwrap_or_else(PoisonError::into_inner).retain(|(other, _)| other != name);
    }

    /// Whether a request comes from the page itself: by a name of this computer, and from no other site. A site whose
    /// name is made to lead here is refused.
    fn is_own(&self, headers: &HeaderMap) -> bool {
        let port = self.address.port();
        let names = ["127.0.0.1", "localhost"].map(|name| format!("{name}:{port}"));
        let text = |name| headers.get(name).map(|value| value.to_str().unwrap_or("?"));
        let host = text(header::HOST).is_some_and(|host| names.iter().any(|name| name == host));
        let origin = text(header::ORIGIN)
            .is_none_or(|origin| names.iter().any(|name| origin.strip_prefix("http://") == Some(name.as_str())));
        host && origin
    }
}

pub fn run(arguments: &Arguments) -> Result<(), Stop> {
    let runtime = tokio::runtime::Builder::new_multi_thread().enable_io().build();
    let runtime = runtime.map_err(|error| Stop::Write("the threads of the server".into(), error))?;
    let asked = SocketAddr::from((Ipv4Addr::LOCALHOST, arguments.port));
    let served = runtime.block_on(serve(asked));
    served.map_err(|error| match error.kind() {
        io::ErrorKind::AddrInUse => {
            Stop::Usage(format!("port {} is taken: give another with --port, or 0 for any", asked.port()))
        }
        _ => Stop::Write(format!("to {asked}"), error),
    })
}

async fn serve(asked: SocketAddr) -> io::Result<()> {
    let listener = TcpListener::bind(asked).await?;
    let address = listener.local_addr()?;
    let text = format!("The page is at http://{address}/ for this computer alone; Ctrl-C ends it.\n");
    if let Err(Stop::Write(_, error)) = super::output::print(&text) {
        return Err(error);
    }
    // An answer goes out at once, whatever of the one before has not been acknowledged.
    let listener = listener.tap_io(|stream| {
        if let Err(error) = stream.set_nodelay(true) {
            tracing::debug!("answers may be sent late: {error}");
        }
    });
    axum::serve(listener, router(Pages::new(address))).await
}

fn router(pages: Pages) -> Router {
    let router = FILES.into_iter().fold(Router::new(), |router, File(path, kind, text)| {
        router.route(path, get(move || async move { ([(header::CONTENT_TYPE, kind)], text) }))
    });
    router
        .route("/ask/{page}", post(ask))
        .layer(DefaultBodyLimit::max(LONGEST))
        .layer(from_fn_with_state(pages.clone(), guard))
        .with_state(pages)
}

/// Refuses what does not come from the page, and says to the browser what the page may do.
async fn guard(State(pages): State<Pages>, request: Request, next: Next) -> Response<Body> {
    let mut response = if pages.is_own(request.headers()) {
        next.run(request).await
    } else {
        refused(StatusCode::FORBIDDEN, "this page is for the computer on which it runs")
    };
    let headers = response.headers_mut();
    for (name, value) in [
        (header::CONTENT_SECURITY_POLICY, POLICY),
        (header::X_CONTENT_TYPE_OPTIONS, "nosniff"),
        (header::REFERRER_POLICY, "no-referrer"),
        (header::CACHE_CONTROL, "no-store"),
    ] {
        headers.insert(name, HeaderValue::from_static(value));
    }
    response
}

fn refused(status: StatusCode, reason: &'static str) -> Response<Body> {
    let mut response = Response::new(Body::from(reason));
    *response.status_mut() = status;
    response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("text/plain; charset=utf-8"));
    response
}

/// Ends what is computed for a page that no longer waits for it: the server drops what would have answered.
struct Gone(Cancel);

impl Drop for Gone {
    fn drop(&mut self) {
        self.0.cancel();
    }
}

/// Answers a page's question.
async fn ask(State(pages): State<Pages>, Path(name): Path<String>, headers: HeaderMap, body: Bytes) -> Response<Body> {
    // Other sites cannot send this type without asking first.
    let is_json =
        headers.get(header::CONTENT_TYPE).is_some_and(|kind| kind.as_bytes().starts_with(b"application/json"));
    let Ok(question) = String::from_utf8(body.to_vec()) else {
        return refused(StatusCode::BAD_REQUEST, "the question is no text");
    };
    if !is_json || name.len() > LONGEST_NAME {
        return refused(StatusCode::BAD_REQUEST, "a question is sent as application/json");
    }
    let Ok(place) = pages.cores.clone().acquire_owned().await else {
        return refused(StatusCode::SERVICE_UNAVAILABLE, "the server is ending");
    };
    let live = pages.page(&name);
    let gone = Gone(Cancel::new());
    let cancel = gone.0.clone();
    let answer = tokio::task::spawn_blocking(move || {
        let mut live = live.lock().unwrap_or_else(PoisonError::into_inner);
        let answer = cancellable(&cancel, || live.answer(&question));
        drop(place);
        answer
    });
    let answered = answer.await;
    drop(gone);
    match answered {
        Ok(answer) => {
            let mut response = Response::new(Body::from(answer));
            response.headers_mut().insert(header::CONTENT_TYPE, HeaderValue::from_static("application/json"));
            response
        }
        Err(_) => {
            pages.forget(&name);
            refused(StatusCode::INTERNAL_SERVER_ERROR, "a defect of the program; its message is on standard error")
        }
    }
}
