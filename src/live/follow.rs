//! From solution to solution, as far as there are any.

use crate::case::{Case, Key, Resolved, Setting};
use crate::clock::Stopwatch;
use crate::drive::{Failure, SolveOptions, TRAIL, solve_along};
use crate::result::{self, Outcome};

/// Halvings of the way to a case after which it counts as ended, however long it was.
const HALVINGS: usize = 14;
/// Share of the change asked for below which the way counts as ended, in relation to the values themselves.
const RESOLUTION: f64 = 1e-3;

/// The last solutions, the newest last, all of one model.
#[derive(Debug, Default)]
pub(super) struct Follower {
    trail: Vec<(Resolved, Outcome)>,
    wall: Option<Wall>,
    /// The share of the way to these values that was gone last.
    toward: Option<(Vec<(Key, f64)>, f64)>,
}

/// Where a way ended.
#[derive(Debug)]
struct Wall {
    from: Vec<(Key, f64)>,
    /// The nearest values without a solution.
    beyond: Vec<(Key, f64)>,
    fixed: Vec<(Key, Setting)>,
    message: String,
}

/// What was found.
pub(super) enum Found {
    /// The case is solved.
    Arrived(Box<Outcome>),
    /// A case on the way to it is; the same question goes on from there.
    OnTheWay(Box<Outcome>),
    /// There is no solution, or none was found; the last that there is.
    Lost { failure: Lost, last: Option<Box<Outcome>> },
}

/// Why there is none.
pub(super) enum Lost {
    /// What the solver says.
    Failure(Failure),
    /// The way from the last solution ended before the case, and what the solver said of the next step.
    Ended(String),
}

/// The numbers of a case, and what is no number: names and tables.
type Split = (Vec<(Key, f64)>, Vec<(Key, Setting)>);

fn split(case: &Resolved) -> Split {
    let mut split = Split::default();
    for (key, setting) in case.settings() {
        match setting {
            Setting::Number(value) => split.0.push((key, value)),
            other => split.1.push((key, other)),
        }
    }
    split
}

/// Whether one step goes on in the direction of another from the same values, at least as far.
fn is_beyond(from: &[(Key, f64)], wall: &[(Key, f64)], to: &[(Key, f64)]) -> bool {
    let same_keys = from.len() == to.len() && from.iter().zip(to).all(|((a, _), (b, _))| a == b);
    same_keys
        && from.iter().zip(wall).zip(to).all(
            |(((_, from), (_, wall)), (_, to))| {
                if wall == from { to == from } else { (to - from) / (wall - from) >= 1.0 }
            },
        )
}

/// A case part of the way between two.
fn between(from: &Split, to: &Split, share: f64) -> Option<Resolved> {
    let mut case = Case::base();
    for (key, setting) in &to.1 {
        case.put("between", *key, setting).ok()?;
    }
    for ((key, from), (_, to)) in from.0.iter().zip(&to.0) {
        case.set_si(*key, from + share * (to - from)).ok()?;
    }
    case.resolve().ok()
}

impl Follower {
    /// The newest solution.
    pub(super) fn last(&self) -> Option<&Outcome> {
        self.trail.last().map(|(_, outcome)| outcome)
    }

    fn lost(&self, failure: Lost) -> Found {
        Found::Lost { failure, last: self.last().cloned().map(Box::new) }
    }

    /// Keeps a solution: beside those of the same model, in place of one of the same case.
    fn keep(&mut self, case: &Resolved, outcome: &Outcome) {
        self.trail.retain(|(before, _)| before.model == case.model && before != case);
        if self.trail.len() >= TRAIL {
            self.trail.remove(0);
        }
        self.trail.push((case.clone(), outcome.clone()));
        self.wall = None;
    }

    /// The case from the last solutions, if it is near them.
    fn warm(&self, case: &Resolved, options: &SolveOptions) -> Result<Outcome, Failure> {
        let start = Stopwatch::start();
        if case.operating_point.margin.is_some() {
            return result::run(case, options);
        }
        let near: Vec<_> = self.trail.iter().filter(|(before, _)| before.model == case.model).collect();
        let near: Vec<_> = near.into_iter().map(|(_, outcome)| &outcome.solved).collect();
        let solved = solve_along(&near, case, options)?;
        result::interpret(case, options, solved, start)
    }

    /// Solves a case, from the last solutions if it is near them, else from nothing.
    pub(super) fn solve(&mut self, case: &Resolved, options: &SolveOptions) -> Found {
        let outcome = self.warm(case, options).or_else(|_| result::run(case, options));
        match outcome {
            Ok(outcome) => {
                self.keep(case, &outcome);
                Found::Arrived(Box::new(outcome))
            }
            Err(failure) => self.lost(Lost::Failure(failure)),
        }
    }

    /// Goes one step from the last solution towards a case, as long as there is a solution. Where there is none to
    /// start from, or what differs is more than numbers, the case is solved from nothing.
    pub(super) fn follow(&mut self, case: &Resolved, options: &SolveOptions) -> Found {
        let Some((before, _)) = self.trail.last() else { return self.solve(case, options) };
        let (from, to) = (split(before), split(case));
        let alike = from.1 == to.1
            && from.0.len() == to.0.len()
            && from.0.iter().zip(&to.0).all(|((a, _), (b, _))| a == b)
            && before.swaps == case.swaps;
        if !alike || case.operating_point.margin.is_some() {
            return self.solve(case, options);
        }
        if let Some(wall) = &self.wall
            && wall.fixed == to.1
            && wall.from == from.0
            && is_beyond(&from.0, &wall.beyond, &to.0)
        {
            return self.lost(Lost::Ended(wall.message.clone()));
        }
        self.walk(case, from, to, options)
    }

    /// The step of [`Follower::follow`]: half as long as often as there is no solution at its end.
    fn walk(&mut self, case: &Resolved, from: Split, to: Split, options: &SolveOptions) -> Found {
        let mut share = match self.toward.take() {
            // Twice the last step, as a share of what is left.
            Some((target, share)) if target == to.0 && share < 1.0 => (2.0 * share / (1.0 - share)).min(1.0),
            _ => 1.0,
        };
        let mut message = String::new();
        for _ in 0..HALVINGS {
            let step = if share == 1.0 { Some(case.clone()) } else { between(&from, &to, share) };
            let Some(step) = step else { return self.solve(case, options) };
            match self.warm(&step, options) {
                Ok(outcome) => {
                    self.keep(&step, &outcome);
                    if share == 1.0 {
                        return Found::Arrived(Box::new(outcome));
                    }
                    self.toward = Some((to.0, share));
                    return Found::OnTheWay(Box::new(outcome));
                }
                Err(failure) => message = failure.to_string(),
            }
            let beyond = split(&step).0;
            if is_close(&from.0, &beyond) {
                self.wall = Some(Wall { from: from.0, beyond, fixed: to.1, message: message.clone() });
                break;
            }
            share *= 0.5;
        }
        self.lost(Lost::Ended(message))
    }
}

/// Whether two sets of values are the same but for little.
fn is_close(a: &[(Key, f64)], b: &[(Key, f64)]) -> bool {
    a.iter().zip(b).all(|((_, a), (_, b))| (a - b).abs() <= RESOLUTION * a.abs().max(b.abs()))
}
