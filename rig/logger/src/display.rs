//! The live display in the terminal. It runs on a thread of its own, which only looks at the latest state and passes
//! keys on: a slow terminal never holds up the interlock.

use std::collections::VecDeque;
use std::io;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::Sender;
use std::sync::{Arc, Mutex};
use std::thread::JoinHandle;
use std::time::Duration;

use ratatui::Frame;
use ratatui::crossterm::event::{self, Event, KeyCode, KeyEventKind};
use ratatui::layout::{Constraint, Layout};
use ratatui::style::{Color, Modifier, Style, Stylize};
use ratatui::text::{Line, Span};
use ratatui::widgets::{Block, Gauge, Paragraph, Row, Sparkline, Table};

use crate::interlock::Command;
use crate::session::{OperatingLimits, Status};

/// How often the display is drawn.
const EVERY: Duration = Duration::from_millis(100);
/// Values that the course of the torque shows: the last two minutes, one each second.
const COURSE: usize = 120;

/// The course of the torque.
#[derive(Clone, Debug, Default)]
pub struct Course {
    /// Hundredths of N·m, one for each second, the latest last.
    values: VecDeque<u64>,
    last: Option<u64>,
}

impl Course {
    /// Takes a state in, at most once for each second of its time.
    pub fn add(&mut self, status: &Status) {
        let second = status.time / 1_000_000;
        if self.last == Some(second) {
            return;
        }
        self.last = Some(second);
        self.values.push_back((status.torque.max(0.0) * 100.0) as u64);
        if self.values.len() > COURSE {
            self.values.pop_front();
        }
    }
}

/// The key's meaning; no key opens the throttle without the interlock agreeing.
#[must_use]
pub fn command(key: KeyCode) -> Option<Command> {
    match key {
        KeyCode::Char('g') => Some(Command::Go),
        KeyCode::Char('s' | 'q' | ' ') | KeyCode::Esc => Some(Command::Stop),
        KeyCode::Char('a') => Some(Command::Acknowledge),
        _ => None,
    }
}

fn colour(mode: &str) -> Color {
    match mode {
        "Running" => Color::Green,
        "Ready" => Color::Yellow,
        "Stopping" | "Tripped" => Color::Red,
        _ => Color::Gray,
    }
}

/// Draws a state.
pub fn draw(frame: &mut Frame<'_>, status: &Status, limits: &OperatingLimits, course: &Course) {
    let [head, numbers, rotor, torque, foot] = Layout::vertical([
        Constraint::Length(4),
        Constraint::Length(9),
        Constraint::Length(3),
        Constraint::Min(4),
        Constraint::Length(1),
    ])
    .areas(frame.area());
    let seconds = status.time / 1_000_000;
    let title = Line::from(vec![
        Span::styled(format!(" {} ", status.mode), Style::new().bg(colour(&status.mode)).fg(Color::Black).bold()),
        Span::raw(format!("  {:02}:{:02}:{:02}", seconds / 3600, seconds / 60 % 60, seconds % 60)),
    ]);
    let message = Paragraph::new(vec![title, Line::from(status.message.as_str())]);
    frame.render_widget(message.block(Block::bordered().title(" sheave-rig ")), head);
    let ratio = if status.secondary_rpm > 0.0 {
        format!("{:.3}", status.primary_rpm / status.secondary_rpm)
    } else {
        "–".to_owned()
    };
    let rows = [
        ("Primary", format!("{:.0} rpm", status.primary_rpm)),
        ("Secondary", format!("{:.0} rpm", status.secondary_rpm)),
        ("Speed ratio", ratio),
        ("Torque", format!("{:.2} N·m", status.torque)),
        ("Output power", format!("{:.0} W", status.power)),
        ("Operating point", status.point.to_string()),
        ("Bad transfers", format!("{} of {}", status.bad_transfers, status.frames + status.bad_transfers)),
    ]
    .map(|(name, value)| Row::new([name.to_owned(), format!("{value:>16}")]));
    let widths = [Constraint::Length(18), Constraint::Length(18)];
    let table = Table::new(rows, widths).block(Block::bordered().title(" Measured "));
    frame.render_widget(table.add_modifier(Modifier::BOLD), numbers);
    let (share, label) = match status.rotor_celsius {
        Some(celsius) => (
            (celsius / limits.rotor_celsius).clamp(0.0, 1.0),
            format!("{celsius:.0} °C of {:.0} °C", limits.rotor_celsius),
        ),
        None => (0.0, "not read".to_owned()),
    };
    let heat = if share < 0.8 { Color::Blue } else { Color::Red };
    let gauge = Gauge::default().ratio(share).label(label).gauge_style(heat);
    frame.render_widget(gauge.block(Block::bordered().title(" Brake rotor ")), rotor);
    let values: Vec<u64> = course.values.iter().copied().collect();
    let line = Sparkline::default().data(&values).block(Block::bordered().title(" Torque, last two minutes "));
    frame.render_widget(line.fg(Color::Cyan), torque);
    frame.render_widget(Line::from(" g open the throttle   s stop   The emergency stop is the red button."), foot);
}

/// The display while it is shown; the terminal is given back when this is dropped.
pub struct Display {
    ended: Arc<AtomicBool>,
    thread: Option<JoinHandle<()>>,
}

impl Display {
    /// Takes the terminal and shows the state until this is dropped; keys become commands.
    ///
    /// # Errors
    /// If there is no terminal.
    pub fn start(shown: Arc<Mutex<Status>>, limits: OperatingLimits, commands: Sender<Command>) -> io::Result<Self> {
        let mut terminal = ratatui::try_init()?;
        let ended = Arc::new(AtomicBool::new(false));
        let ends = Arc::clone(&ended);
        let thread = std::thread::spawn(move || {
            let mut course = Course::default();
            while !ends.load(Ordering::SeqCst) {
                let Ok(status) = shown.lock().map(|status| status.clone()) else { break };
                course.add(&status);
                // A terminal that cannot be drawn on is no reason to stop the rig.
                let _ = terminal.draw(|frame| draw(frame, &status, &limits, &course));
                if let Ok(true) = event::poll(EVERY)
                    && let Ok(Event::Key(key)) = event::read()
                    && key.kind == KeyEventKind::Press
                    && let Some(command) = command(key.code)
                    && commands.send(command).is_err()
                {
                    break;
                }
            }
        });
        Ok(Self { ended, thread: Some(thread) })
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        self.ended.store(true, Ordering::SeqCst);
        if let Some(thread) = self.thread.take() {
            let _ = thread.join();
        }
        ratatui::restore();
    }
}

#[cfg(test)]
mod tests {
    use ratatui::Terminal;
    use ratatui::backend::TestBackend;

    use super::*;

    fn status() -> Status {
        Status {
            time: 3_723_000_000,
            mode: "Running".to_owned(),
            message: "reading".to_owned(),
            primary_rpm: 2991.2,
            secondary_rpm: 1585.3,
            torque: 21.456,
            power: 3562.0,
            rotor_celsius: Some(151.0),
            point: 7,
            frames: 9998,
            bad_transfers: 2,
        }
    }

    fn drawn(status: &Status, course: &Course, (width, height): (u16, u16)) -> String {
        let mut terminal = Terminal::new(TestBackend::new(width, height)).unwrap();
        terminal.draw(|frame| draw(frame, status, &OperatingLimits::RIG, course)).unwrap();
        terminal.backend().to_string()
    }

    #[test]
    fn every_number_stands_on_the_screen() {
        let mut course = Course::default();
        for second in 0..300 {
            course.add(&Status { time: second * 1_000_000, torque: second as f64 / 10.0, ..status() });
        }
        let text = drawn(&status(), &course, (80, 24));
        for shown in [
            "Running",
            "01:02:03",
            "reading",
            "2991 rpm",
            "1585 rpm",
            "1.887",
            "21.46 N·m",
            "3562 W",
            "151 °C of 300 °C",
        ] {
            assert!(text.contains(shown), "{shown} is missing:\n{text}");
        }
        assert!(text.contains("2 of 10000") && text.contains('█'), "{text}");
        println!("{text}");
    }

    #[test]
    fn nothing_known_and_no_room_are_no_trouble() {
        let nothing = Status { secondary_rpm: 0.0, rotor_celsius: None, torque: f64::NAN, ..status() };
        let mut course = Course::default();
        course.add(&nothing);
        assert!(drawn(&nothing, &course, (80, 24)).contains("not read"));
        for size in [(1, 1), (10, 3), (200, 5)] {
            drawn(&nothing, &course, size);
        }
    }

    #[test]
    fn keys_ask_for_what_they_say() {
        assert_eq!(command(KeyCode::Char('g')), Some(Command::Go));
        for key in [KeyCode::Char('s'), KeyCode::Char(' '), KeyCode::Esc, KeyCode::Char('q')] {
            assert_eq!(command(key), Some(Command::Stop));
        }
        assert_eq!(command(KeyCode::Char('x')), None);
    }
}
