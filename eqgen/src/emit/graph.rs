//! Value numbering: every operation exists once, however often it is asked for.

use std::collections::BTreeMap;

/// An operation's place in the [`Graph`]; operands always come first.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Node(pub usize);

/// One operation on earlier nodes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Operation {
    /// A number, by its bits.
    Constant(u64),
    /// An input, by its place among the plan's inputs.
    Input(usize),
    /// a + b
    Add(Node, Node),
    /// a − b
    Sub(Node, Node),
    /// a b
    Mul(Node, Node),
    /// −a
    Neg(Node),
    /// 1/a
    Reciprocal(Node),
    /// √a
    Sqrt(Node),
    /// sin a
    Sin(Node),
    /// cos a
    Cos(Node),
    /// tanh a
    Tanh(Node),
    /// eᵃ
    Exp(Node),
    /// ln a
    Ln(Node),
    /// min(1, a)
    Saturate(Node),
    /// 1 where a < 1, else 0
    BelowOne(Node),
    /// atan2(b, a), the angle of (a, b)
    Angle(Node, Node),
    /// An angle in (−π, π] to the same in [0, 2π)
    Turn(Node),
}

impl Operation {
    /// What it is called.
    pub fn name(self) -> &'static str {
        use Operation::*;
        match self {
            Constant(_) => "number",
            Input(_) => "input",
            Add(..) => "sum",
            Sub(..) => "difference",
            Mul(..) => "product",
            Neg(_) => "negative",
            Reciprocal(_) => "reciprocal",
            Sqrt(_) => "root",
            Sin(_) => "sine",
            Cos(_) => "cosine",
            Tanh(_) => "tanh",
            Exp(_) => "exponential",
            Ln(_) => "logarithm",
            Saturate(_) => "min(1, ·)",
            BelowOne(_) => "below one",
            Angle(..) => "angle",
            Turn(_) => "turn",
        }
    }

    /// Operands.
    pub fn operands(self) -> impl Iterator<Item = Node> {
        use Operation::*;
        let (first, second) = match self {
            Constant(_) | Input(_) => (None, None),
            Add(a, b) | Sub(a, b) | Mul(a, b) | Angle(a, b) => (Some(a), Some(b)),
            Neg(a) | Reciprocal(a) | Sqrt(a) | Sin(a) | Cos(a) | Tanh(a) | Exp(a) | Ln(a) | Saturate(a)
            | BelowOne(a) | Turn(a) => (Some(a), None),
        };
        first.into_iter().chain(second)
    }
}

/// All operations of a kernel.
#[derive(Debug, Clone, Default)]
pub struct Graph {
    operations: Vec<Operation>,
    numbers: BTreeMap<Operation, Node>,
    /// Whether a node depends on nothing but constants.
    uniform: Vec<bool>,
    names: BTreeMap<Node, String>,
    /// Inputs from this place on are constants of the kernel.
    first_constant: usize,
}

impl Graph {
    /// A graph whose inputs from `first_constant` on are the same for all points of a batch.
    pub fn new(first_constant: usize) -> Self {
        Self { first_constant, ..Self::default() }
    }

    /// The operation at a node.
    pub fn operation(&self, node: Node) -> Operation {
        self.operations[node.0]
    }

    /// The node of an operation, if it exists.
    pub fn find(&self, operation: Operation) -> Option<Node> {
        self.numbers.get(&operation).copied()
    }

    /// Place of the first input that is a constant.
    pub fn first_constant(&self) -> usize {
        self.first_constant
    }

    /// Whether the node is the same for all points of a batch.
    pub fn is_uniform(&self, node: Node) -> bool {
        self.uniform[node.0]
    }

    /// The name that the notation, or the derivative it is, gives a node.
    pub fn name(&self, node: Node) -> Option<&str> {
        self.names.get(&node).map(String::as_str)
    }

    /// Names a node unless it has a name or is a number or an input.
    pub fn suggest_name(&mut self, node: Node, name: &str) {
        if !matches!(self.operation(node), Operation::Constant(_) | Operation::Input(_)) {
            self.names.entry(node).or_insert_with(|| name.to_owned());
        }
    }

    /// The number a node is, if it is one.
    pub fn number(&self, node: Node) -> Option<f64> {
        match self.operation(node) {
            Operation::Constant(bits) => Some(f64::from_bits(bits)),
            _ => None,
        }
    }

    /// A number.
    pub fn constant(&mut self, value: f64) -> Node {
        if value < 0.0 {
            let magnitude = self.intern(Operation::Constant((-value).to_bits()));
            return self.intern(Operation::Neg(magnitude));
        }
        // Adding 0 turns −0 into 0.
        self.intern(Operation::Constant((value + 0.0).to_bits()))
    }

    /// An input.
    pub fn input(&mut self, place: usize) -> Node {
        self.intern(Operation::Input(place))
    }

    /// Whether the node is zero.
    pub fn is_zero(&self, node: Node) -> bool {
        self.number(node) == Some(0.0)
    }

    /// a + b
    pub fn add(&mut self, a: Node, b: Node) -> Node {
        use Operation::*;
        match (self.operation(a), self.operation(b)) {
            _ if self.is_zero(a) => b,
            _ if self.is_zero(b) => a,
            (Neg(a), Neg(b)) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            (_, Neg(b)) => self.sub(a, b),
            (Neg(a), _) => self.sub(b, a),
            (Constant(a), Constant(b)) => self.constant(f64::from_bits(a) + f64::from_bits(b)),
            _ => self.intern(Add(a.min(b), a.max(b))),
        }
    }

    /// a − b
    pub fn sub(&mut self, a: Node, b: Node) -> Node {
        use Operation::*;
        match (self.operation(a), self.operation(b)) {
            _ if a == b => self.constant(0.0),
            _ if self.is_zero(b) => a,
            _ if self.is_zero(a) => self.neg(b),
            (_, Neg(b)) => self.add(a, b),
            (Neg(a), _) => {
                let sum = self.add(a, b);
                self.neg(sum)
            }
            (Constant(a), Constant(b)) => self.constant(f64::from_bits(a) - f64::from_bits(b)),
            // The opposite difference may exist already; one of the two is enough.
            _ => match self.numbers.get(&Sub(b, a)) {
                Some(&opposite) => self.neg(opposite),
                None => self.intern(Sub(a, b)),
            },
        }
    }

    /// −a
    pub fn neg(&mut self, a: Node) -> Node {
        match self.operation(a) {
            _ if self.is_zero(a) => a,
            Operation::Neg(a) => a,
            _ => self.intern(Operation::Neg(a)),
        }
    }

    /// a b
    pub fn mul(&mut self, a: Node, b: Node) -> Node {
        use Operation::*;
        match (self.operation(a), self.operation(b)) {
            _ if self.is_zero(a) || self.number(b) == Some(1.0) => a,
            _ if self.is_zero(b) || self.number(a) == Some(1.0) => b,
            (Neg(a), Neg(b)) => self.mul(a, b),
            (Neg(a), _) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (_, Neg(b)) => {
                let product = self.mul(a, b);
                self.neg(product)
            }
            (Constant(a), Constant(b)) => self.constant(f64::from_bits(a) * f64::from_bits(b)),
            (Mul(c, e), Mul(d, f)) if self.is_front(c, e) && self.is_front(d, f) => {
                let (front, back) = (self.mul(c, d), self.mul(e, f));
                self.mul(front, back)
            }
            // Uniform factors gather in front, where they are multiplied once a batch.
            (_, Mul(c, d)) if self.is_uniform(a) && self.is_uniform(c) && !self.is_uniform(d) => {
                let front = self.mul(a, c);
                self.mul(front, d)
            }
            (Mul(c, d), _) if self.is_uniform(b) && self.is_uniform(c) && !self.is_uniform(d) => {
                let front = self.mul(b, c);
                self.mul(front, d)
            }
            _ => {
                let rank = |node: Node| (!self.is_uniform(node), node);
                let (first, second) = if rank(a) <= rank(b) { (a, b) } else { (b, a) };
                self.intern(Mul(first, second))
            }
        }
    }

    fn is_reciprocal(&self, node: Node) -> bool {
        matches!(self.operation(node), Operation::Reciprocal(_))
    }

    /// Whether a product is a uniform factor in front of a varying one.
    fn is_front(&self, front: Node, back: Node) -> bool {
        self.is_uniform(front) && !self.is_uniform(back)
    }

    /// 1/a
    pub fn reciprocal(&mut self, a: Node) -> Node {
        match self.operation(a) {
            Operation::Neg(a) => {
                let positive = self.reciprocal(a);
                self.neg(positive)
            }
            Operation::Reciprocal(a) => a,
            Operation::Constant(bits) => self.constant(1.0 / f64::from_bits(bits)),
            Operation::Mul(a, b) if self.is_reciprocal(a) || self.is_reciprocal(b) => {
                let (a, b) = (self.reciprocal(a), self.reciprocal(b));
                self.mul(a, b)
            }
            // 1/(u a) with u uniform: one division a batch and one a point, both shared with others.
            Operation::Mul(u, a) if self.is_uniform(u) => {
                let (u, a) = (self.reciprocal(u), self.reciprocal(a));
                self.mul(u, a)
            }
            _ => self.intern(Operation::Reciprocal(a)),
        }
    }

    /// aⁿ, by multiplication; negative powers share 1/a.
    pub fn power(&mut self, a: Node, exponent: i64) -> Node {
        let base = if exponent < 0 { self.reciprocal(a) } else { a };
        let one = self.constant(1.0);
        (0..exponent.unsigned_abs()).fold(one, |product, _| self.mul(product, base))
    }

    /// Product of many factors: numbers and uniform ones first, then the others in order.
    pub fn product(&mut self, mut factors: Vec<Node>) -> Node {
        factors.sort_by_key(|&node| (!self.is_uniform(node), node));
        let one = self.constant(1.0);
        let split = factors.iter().position(|&node| !self.is_uniform(node)).unwrap_or(factors.len());
        let (uniform, varying) = factors.split_at(split);
        let front = uniform.iter().fold(one, |all, &factor| self.mul(all, factor));
        let back = varying.iter().fold(one, |all, &factor| self.mul(all, factor));
        self.mul(front, back)
    }

    /// Sum of many terms, uniform ones first; positive terms before negative ones.
    pub fn sum(&mut self, mut terms: Vec<Node>) -> Node {
        let is_negative = |graph: &Self, node| matches!(graph.operation(node), Operation::Neg(_));
        terms.sort_by_key(|&node| (!self.is_uniform(node), is_negative(self, node), node));
        let zero = self.constant(0.0);
        terms.into_iter().fold(zero, |all, term| self.add(all, term))
    }

    /// √a, sin a and the like.
    pub fn function(&mut self, operation: Operation) -> Node {
        match operation {
            Operation::Sin(a) if matches!(self.operation(a), Operation::Neg(_)) => {
                let positive = self.neg(a);
                let value = self.intern(Operation::Sin(positive));
                self.neg(value)
            }
            Operation::Cos(a) if matches!(self.operation(a), Operation::Neg(_)) => {
                let positive = self.neg(a);
                self.intern(Operation::Cos(positive))
            }
            _ => self.intern(operation),
        }
    }

    /// What the roots take at every point: an operation counts 1, a division or function more.
    pub fn cost(&self, roots: &[Node]) -> usize {
        let (mut seen, mut open) = (vec![false; self.operations.len()], roots.to_vec());
        let mut cost = 0;
        while let Some(node) = open.pop() {
            if std::mem::replace(&mut seen[node.0], true) || self.is_uniform(node) {
                continue;
            }
            let operation = self.operation(node);
            cost += match operation {
                Operation::Input(_) | Operation::Neg(_) => 0,
                Operation::Reciprocal(_) | Operation::Sqrt(_) => 6,
                _ => 1,
            };
            open.extend(operation.operands());
        }
        cost
    }

    fn intern(&mut self, operation: Operation) -> Node {
        if let Some(&node) = self.numbers.get(&operation) {
            return node;
        }
        let uniform = match operation {
            Operation::Constant(_) => true,
            Operation::Input(place) => place >= self.first_constant,
            _ => operation.operands().all(|operand| self.is_uniform(operand)),
        };
        let node = Node(self.operations.len());
        self.operations.push(operation);
        self.uniform.push(uniform);
        self.numbers.insert(operation, node);
        node
    }
}
