//! One solution as a page that a person reads in a minute: no other file, no network.

mod loss;
mod page;
mod reproduction;

pub use loss::{LossSplit, Mechanisms, losses};
pub use page::{document, page};
pub use reproduction::{REPRODUCED, Reproduction};
