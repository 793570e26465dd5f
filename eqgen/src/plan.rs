//! An evaluation plan: named steps, each a small expression in what stands before it.
//!
//! Physics writes plans; nothing is ever expanded into one huge expression. Derivatives go by the chain rule over
//! the steps (see [`crate::emit`]).

use symbolica::atom::Atom;
use symbolica::try_parse;

use crate::dimension::{self, Dimension, Dimensions};
use crate::error::Error;
use crate::physics::notation;

/// Functions that Symbolica need not know: their derivatives are steps of the same plan's graph.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Function {
    /// √u
    Sqrt,
    /// tan u; its derivative is 1 + tan² u.
    Tan,
    /// tanh u
    Tanh,
    /// eᵘ
    Exp,
    /// ln u
    Ln,
    /// min(1, u); its derivative is 1 below u = 1 and 0 from there on.
    Saturate,
    /// The angle of the vector (u, v) in (−π, π]: atan2(v, u).
    Angle,
    /// An angle in (−π, π] to the same in [0, 2π).
    Turn,
}

/// How a step gets its value.
#[derive(Debug, Clone)]
pub enum Definition {
    /// An expression in earlier symbols.
    Expression(Atom),
    /// A function of expressions in earlier symbols.
    Function(Function, Vec<Atom>),
    /// A fixed number.
    Number(f64),
}

/// Where a step comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Origin {
    /// Typed in: a definition or a law of nature.
    Primitive,
    /// Follows from other steps by symbolic work.
    Derived,
    /// Typed in as a source prints it, slips included: dimensions are not checked.
    Printed,
}

/// One named step.
#[derive(Debug, Clone)]
pub struct Step {
    /// Its symbol in the notation.
    pub name: String,
    /// Its value.
    pub definition: Definition,
    /// Typed in or derived.
    pub origin: Origin,
    /// Number in the thesis, or what it is.
    pub source: &'static str,
}

/// A law that is typed in as a balance, and that steps are solved from: `left = right`.
#[derive(Debug, Clone)]
pub struct Law {
    /// Left side.
    pub left: Atom,
    /// Right side.
    pub right: Atom,
    /// Number in the thesis.
    pub source: &'static str,
}

/// A divisor that is known to stay away from zero.
#[derive(Debug, Clone)]
pub struct Guard {
    /// The expression.
    pub divisor: Atom,
    /// Why it does not vanish.
    pub reason: &'static str,
}

/// Named steps in order of evaluation.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Symbols that come from outside.
    pub inputs: Vec<String>,
    /// Steps.
    pub steps: Vec<Step>,
    /// Laws that steps are derived from.
    pub laws: Vec<Law>,
    /// Divisors that do not vanish.
    pub guards: Vec<Guard>,
    own: Vec<notation::Symbol>,
    notation: Dimensions,
    known: Dimensions,
}

impl Plan {
    /// A plan without steps, on these inputs; `extra` symbols extend the notation.
    ///
    /// # Errors
    /// [`Error::UnknownSymbol`] for an input that has no row in the notation.
    pub fn new(inputs: Vec<String>, extra: Dimensions) -> Result<Self, Error> {
        let mut notation = notation::dimensions();
        notation.extend(extra);
        Self::on(inputs, Vec::new(), notation)
    }

    /// A plan without steps in a notation of its own: no symbol of the belt is known in it.
    ///
    /// # Errors
    /// [`Error::UnknownSymbol`] for an input that has no row in `notation`.
    pub fn in_notation_of(inputs: &[&str], notation: Vec<notation::Symbol>) -> Result<Self, Error> {
        let dimensions = notation.iter().map(|symbol| (symbol.name.clone(), symbol.dimension)).collect();
        Self::on(inputs.iter().map(|&name| name.into()).collect(), notation, dimensions)
    }

    fn on(inputs: Vec<String>, own: Vec<notation::Symbol>, notation: Dimensions) -> Result<Self, Error> {
        let mut plan = Self {
            inputs: Vec::new(),
            steps: Vec::new(),
            laws: Vec::new(),
            guards: Vec::new(),
            own,
            notation,
            known: Dimensions::new(),
        };
        for input in inputs {
            let dimension = plan.in_notation("inputs", &input)?;
            plan.known.insert(input.clone(), dimension);
            plan.inputs.push(input);
        }
        Ok(plan)
    }

    /// Types in `name = text`.
    ///
    /// # Errors
    /// If `text` cannot be read, uses an unknown symbol or has a term of the wrong dimension.
    pub fn primitive(&mut self, name: &str, text: &str, source: &'static str) -> Result<(), Error> {
        let value = read(name, text)?;
        self.push(name, Definition::Expression(value), Origin::Primitive, source)
    }

    /// Types in the law `left = right`, from which steps are derived.
    ///
    /// # Errors
    /// If a side cannot be read, uses an unknown symbol, or has a term of another dimension than the other side.
    pub fn law(&mut self, left: &str, right: &str, source: &'static str) -> Result<(), Error> {
        let (left, right) = (read("law", left)?, read("law", right)?);
        let dimension = dimension::dimension("law", &left, &self.notation)?;
        dimension::check("law", &right, dimension, &self.notation)?;
        self.laws.push(Law { left, right, source });
        Ok(())
    }

    /// Types in `name = value`, where `value` is put together from texts.
    ///
    /// # Errors
    /// As [`Plan::primitive`].
    pub fn typed(&mut self, name: &str, value: Atom, source: &'static str) -> Result<(), Error> {
        self.push(name, Definition::Expression(value), Origin::Primitive, source)
    }

    /// Adds `name = value`, found by symbolic work.
    ///
    /// # Errors
    /// If `value` uses an unknown symbol or has a term of the wrong dimension.
    pub fn derived(&mut self, name: &str, value: Atom, source: &'static str) -> Result<(), Error> {
        self.push(name, Definition::Expression(value), Origin::Derived, source)
    }

    /// Adds `name = value` as a source prints it, without a check of dimensions.
    ///
    /// # Errors
    /// If `name` is unknown or defined already.
    pub fn as_printed(&mut self, name: &str, value: Atom, source: &'static str) -> Result<(), Error> {
        self.push(name, Definition::Expression(value), Origin::Printed, source)
    }

    /// Types in `name = function(arguments)`.
    ///
    /// # Errors
    /// As [`Plan::primitive`].
    pub fn apply(&mut self, name: &str, function: Function, texts: &[&str], source: &'static str) -> Result<(), Error> {
        let arguments = texts.iter().map(|text| read(name, text)).collect::<Result<_, _>>()?;
        self.push(name, Definition::Function(function, arguments), Origin::Primitive, source)
    }

    /// Gives `name` a fixed value.
    ///
    /// # Errors
    /// If the notation does not list `name`, or it is defined already.
    pub fn number(&mut self, name: &str, value: f64, source: &'static str) -> Result<(), Error> {
        self.push(name, Definition::Number(value), Origin::Primitive, source)
    }

    /// Declares that the expression `text` does not vanish.
    ///
    /// # Errors
    /// If `text` cannot be read.
    pub fn nonzero(&mut self, text: &str, reason: &'static str) -> Result<(), Error> {
        let divisor = read("guard", text)?;
        self.guards.push(Guard { divisor, reason });
        Ok(())
    }

    /// The step of that name.
    pub fn step(&self, name: &str) -> Option<&Step> {
        self.steps.iter().find(|step| step.name == name)
    }

    /// The symbol of that name: the plan's own, or in the belt's notation.
    pub fn symbol(&self, name: &str) -> Option<notation::Symbol> {
        let own = self.own.iter().find(|symbol| symbol.name == name).cloned();
        if self.own.is_empty() { notation::find(name) } else { own }
    }

    /// Checks that `value` has the dimension that the notation gives `name`.
    ///
    /// # Errors
    /// [`Error::Dimension`] names the offending term.
    pub fn check_dimensions(&self, name: &str, value: &Atom) -> Result<(), Error> {
        dimension::check(name, value, self.in_notation(name, name)?, &self.known)
    }

    fn push(&mut self, name: &str, definition: Definition, origin: Origin, source: &'static str) -> Result<(), Error> {
        let expected = self.in_notation(name, name)?;
        if self.known.contains_key(name) {
            return Err(Error::Redefined { step: name.into() });
        }
        if origin != Origin::Printed {
            self.check(name, &definition, expected)?;
        }
        self.known.insert(name.into(), expected);
        self.steps.push(Step { name: name.into(), definition, origin, source });
        Ok(())
    }

    fn check(&self, name: &str, definition: &Definition, expected: Dimension) -> Result<(), Error> {
        match definition {
            Definition::Number(_) => Ok(()),
            Definition::Expression(value) => dimension::check(name, value, expected, &self.known),
            Definition::Function(Function::Sqrt, arguments) => arguments
                .iter()
                .try_for_each(|argument| dimension::check(name, argument, expected.squared(), &self.known)),
            Definition::Function(Function::Angle, arguments) => {
                let Some((first, rest)) = arguments.split_first() else { return Ok(()) };
                let common = dimension::dimension(name, first, &self.known)?;
                rest.iter().try_for_each(|argument| dimension::check(name, argument, common, &self.known))
            }
            Definition::Function(_, arguments) => {
                arguments.iter().try_for_each(|argument| dimension::check(name, argument, Dimension::ONE, &self.known))
            }
        }
    }

    fn in_notation(&self, step: &str, name: &str) -> Result<Dimension, Error> {
        let unknown = || Error::UnknownSymbol { step: step.into(), symbol: name.into() };
        self.notation.get(name).copied().ok_or_else(unknown)
    }
}

/// Reads an expression.
///
/// # Errors
/// [`Error::Parse`] with what the parser says.
pub fn read(step: &str, text: &str) -> Result<Atom, Error> {
    try_parse!(text).map_err(|error| Error::Parse { step: step.into(), text: text.into(), message: error.to_string() })
}
