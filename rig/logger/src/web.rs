//! The read-only page: the state of the rig for a browser on the same machine. It listens on the loopback address
//! alone and
//! answers nothing but GET; there is nothing in it that could command anything.

use std::io;
use std::net::{Ipv4Addr, SocketAddr};
use std::sync::{Arc, Mutex};
use std::thread;

use crate::session::Status;

const PAGE: &str = include_str!("page.html");

/// Starts the page on a port of 127.0.0.1 (0: any free one) and returns its address.
///
/// # Errors
/// If the port cannot be had.
pub fn serve(port: u16, status: Arc<Mutex<Status>>) -> io::Result<SocketAddr> {
    let server = tiny_http::Server::http((Ipv4Addr::LOCALHOST, port)).map_err(io::Error::other)?;
    let address = server.server_addr().to_ip().ok_or_else(|| io::Error::other("no address"))?;
    thread::spawn(move || {
        for request in server.incoming_requests() {
            let (code, kind, body) = answer(request.method() == &tiny_http::Method::Get, request.url(), &status);
            let mut response = tiny_http::Response::from_string(body).with_status_code(code);
            // Whatever a message contains, a browser takes it for what its type says.
            for (name, value) in [("Content-Type", kind), ("X-Content-Type-Options", "nosniff")] {
                if let Ok(header) = tiny_http::Header::from_bytes(name, value) {
                    response.add_header(header);
                }
            }
            // A browser that has gone away is no fault of the rig.
            let _ = request.respond(response);
        }
    });
    Ok(address)
}

fn answer(is_get: bool, url: &str, status: &Mutex<Status>) -> (u16, &'static str, String) {
    match (is_get, url) {
        (false, _) => (405, "text/plain", "this page is read-only".to_owned()),
        (true, "/") => (200, "text/html; charset=utf-8", PAGE.to_owned()),
        (true, "/status.json") => match status.lock().map(|status| serde_json::to_string(&*status)) {
            Ok(Ok(text)) => (200, "application/json", text),
            _ => (500, "text/plain", "the state cannot be shown".to_owned()),
        },
        (true, _) => (404, "text/plain", "there is / and /status.json".to_owned()),
    }
}
