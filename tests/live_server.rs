//! `sheave live` from outside: what it serves, what it answers, whom it refuses.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

use serde_json::{Value, json};
use std::io::{BufRead, BufReader, Read, Write};
use std::net::TcpStream;
use std::process::{Child, Command, Stdio};
use std::time::Duration;

/// The running program; it ends with the test.
struct Server {
    child: Child,
    port: u16,
}

impl Drop for Server {
    fn drop(&mut self) {
        let _ = self.child.kill();
        let _ = self.child.wait();
    }
}

impl Server {
    fn start() -> Self {
        let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
        let mut child = command.args(["live", "--port", "0"]).stdout(Stdio::piped()).spawn().unwrap();
        let mut line = String::new();
        BufReader::new(child.stdout.take().unwrap()).read_line(&mut line).unwrap();
        let port = line.split("127.0.0.1:").nth(1).unwrap().split('/').next().unwrap().parse().unwrap();
        Self { child, port }
    }

    /// Status, headers and body of a request whose headers are given.
    fn request(&self, head: &str, headers: &[&str], body: &str) -> (u16, String, String) {
        let mut stream = TcpStream::connect(("127.0.0.1", self.port)).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(60))).unwrap();
        let mut text = format!("{head} HTTP/1.1\r\nconnection: close\r\ncontent-length: {}\r\n", body.len());
        headers.iter().for_each(|header| text += &format!("{header}\r\n"));
        stream.write_all(format!("{text}\r\n{body}").as_bytes()).unwrap();
        let mut answer = String::new();
        stream.read_to_string(&mut answer).unwrap();
        let (head, body) = answer.split_once("\r\n\r\n").unwrap();
        let status = head.split(' ').nth(1).unwrap().parse().unwrap();
        (status, head.to_lowercase(), body.to_owned())
    }

    fn host(&self) -> String {
        format!("host: 127.0.0.1:{}", self.port)
    }

    fn ask(&self, page: &str, question: &Value) -> Value {
        let headers = [&*self.host(), "content-type: application/json"];
        let (status, _, body) = self.request(&format!("POST /ask/{page}"), &headers, &question.to_string());
        assert_eq!(status, 200, "{body}");
        serde_json::from_str(&body).unwrap()
    }
}

#[test]
fn the_page_is_served_with_a_policy_and_its_engine_asks_the_server() {
    let server = Server::start();
    let (status, head, body) = server.request("GET /", &[&server.host()], "");
    assert_eq!(status, 200);
    assert!(head.contains("content-security-policy: default-src 'none'") && head.contains("nosniff"), "{head}");
    assert!(!head.contains("unsafe"), "{head}");
    // Whatever the page names, it gets.
    let named: Vec<&str> = body.split('"').filter(|text| text.ends_with(".js") || text.ends_with(".css")).collect();
    assert!(named.len() >= 2, "{named:?}");
    let mut left: Vec<String> = named.into_iter().map(str::to_owned).collect();
    let mut seen = Vec::new();
    while let Some(file) = left.pop() {
        let (status, head, body) = server.request(&format!("GET /{file}"), &[&server.host()], "");
        assert_eq!(status, 200, "{file}");
        assert!(head.contains(if file.ends_with(".js") { "text/javascript" } else { "text/css" }), "{head}");
        seen.push(file);
        let imports = body.split("from \"./").skip(1).filter_map(|rest| rest.split('"').next());
        left.extend(imports.filter(|file| !seen.iter().any(|other| other == file)).map(str::to_owned));
    }
    assert!(seen.len() > 8, "{seen:?}");
    let (_, _, engine) = server.request("GET /engine.js", &[&server.host()], "");
    assert!(engine.contains("fetch(new URL(`ask/"));
    assert_eq!(server.request("GET /../Cargo.toml", &[&server.host()], "").0, 404);
}

#[test]
fn it_answers_as_the_library_does_and_remembers_each_page_for_itself() {
    let server = Server::start();
    let question = json!({ "ask": "solve", "case": "", "tolerance": 1e-3 });
    let mut live = sheave::live::Live::default();
    let expected: Value = serde_json::from_str(&live.answer(&question.to_string())).unwrap();
    let answer = server.ask("a", &question);
    let force = |answer: &Value| answer["result"]["primary"]["axial_force"].as_f64().unwrap();
    assert_eq!(force(&answer).to_bits(), force(&expected).to_bits());
    // The profile is that of the page's own last solution.
    let profile = |page| server.ask(page, &json!({ "ask": "profile" }))["csv"].as_str().unwrap().len();
    assert!(profile("a") > 10_000);
    assert_eq!(profile("b"), 0);
}

#[test]
fn other_sites_and_other_computers_are_refused() {
    let server = Server::start();
    let port = server.port;
    let question = r#"{"ask": "keys"}"#;
    let ask = |headers: &[&str]| server.request("POST /ask/a", headers, question).0;
    let json = "content-type: application/json";
    let host = server.host();
    assert_eq!(ask(&[&host, json]), 200);
    assert_eq!(ask(&[&host, json, &format!("origin: http://localhost:{port}")]), 200);
    assert_eq!(ask(&[&host, json, "origin: https://example.org"]), 403);
    assert_eq!(ask(&[&host, json, "origin: null"]), 403);
    assert_eq!(ask(&[&host, "content-type: text/plain"]), 400);
    assert_eq!(ask(&[&format!("host: example.org:{port}"), json]), 403);
    assert_eq!(ask(&[&host, json, &format!("origin: http://127.0.0.1:{port}.example.org")]), 403);
    let long = format!("POST /ask/{}", "a".repeat(100));
    assert_eq!(server.request(&long, &[&host, json], question).0, 400);
    let nonsense = server.request("POST /ask/a", &[&host, json], "{");
    assert!(nonsense.2.contains("not understood"), "{}", nonsense.2);
}

#[test]
fn a_port_that_is_taken_is_said() {
    let server = Server::start();
    let mut command = Command::new(env!("CARGO_BIN_EXE_sheave"));
    let output = command.args(["live", "--port", &server.port.to_string()]).output().unwrap();
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8_lossy(&output.stderr).contains("is taken"), "{output:?}");
}
