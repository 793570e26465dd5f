//! The page over a real connection: it shows, escapes, and takes no orders.

#![allow(clippy::unwrap_used)]

use std::io::{Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::sync::{Arc, Mutex};

use rig_logger::calibration::Calibration;
use rig_logger::session::{OperatingLimits, Session, Status};
use rig_logger::simulated::SimulatedRig;
use rig_logger::web::serve;

mod support;

fn status() -> Status {
    let session =
        Session::new(SimulatedRig::new(false), Calibration::THESIS, OperatingLimits::RIG, support::recorder());
    session.status().clone()
}

/// Status line with headers, and body.
fn ask(address: SocketAddr, method: &str, path: &str) -> (String, String) {
    let mut stream = TcpStream::connect(address).unwrap();
    stream.set_read_timeout(Some(std::time::Duration::from_secs(20))).unwrap();
    write!(stream, "{method} {path} HTTP/1.1\r\nHost: rig\r\nContent-Length: 4\r\nConnection: close\r\n\r\nStop")
        .unwrap();
    let mut text = String::new();
    stream.read_to_string(&mut text).unwrap();
    let (head, body) = text.split_once("\r\n\r\n").unwrap();
    (head.to_owned(), body.to_owned())
}

#[test]
fn the_page_shows_escapes_and_takes_no_orders() {
    let message = "</script><img src=x onerror=alert(1)> \"quoted\"\n";
    let shown = Arc::new(Mutex::new(Status { message: message.to_owned(), torque: 21.5, ..status() }));
    let address = serve(0, Arc::clone(&shown)).unwrap();
    assert!(address.ip().is_loopback());

    let (head, page) = ask(address, "GET", "/");
    assert!(head.starts_with("HTTP/1.1 200") && head.contains("text/html"), "{head}");
    // Nothing of the state is in the page: its script fetches it and sets it as text, never as markup.
    assert!(!page.contains(message) && page.contains("textContent") && !page.contains("innerHTML"));

    let (head, json) = ask(address, "GET", "/status.json");
    assert!(
        head.starts_with("HTTP/1.1 200") && head.contains("application/json") && head.contains("nosniff"),
        "{head}"
    );
    let state: serde_json::Value = serde_json::from_str(&json).unwrap();
    assert_eq!((state["message"].as_str(), state["torque"].as_f64()), (Some(message), Some(21.5)));

    let before = shown.lock().unwrap().clone();
    for method in ["POST", "PUT", "DELETE", "PATCH", "HEAD", "OPTIONS"] {
        for path in ["/", "/status.json", "/stop"] {
            let (head, _) = ask(address, method, path);
            assert!(head.starts_with("HTTP/1.1 405"), "{method} {path}: {head}");
        }
    }
    for path in ["/stop", "/../../etc/passwd", "/status.json/..", "/%2e%2e/journal.log"] {
        assert!(ask(address, "GET", path).0.starts_with("HTTP/1.1 404"), "{path}");
    }
    assert_eq!(*shown.lock().unwrap(), before);
}
