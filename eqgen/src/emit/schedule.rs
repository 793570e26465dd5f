//! The order of a function's statements.
//!
//! A chunk of points lives in the machine's 16 or 32 vector registers; a Jacobian has hundreds of intermediate values.
//! What does not fit is stored to memory and loaded again, and a core stores one vector a cycle at most. Emitting a
//! statement when an output first asks for it leaves many values waiting for their last use. Here the next statement
//! is always one that ends the life of as many values as possible and begins that of as few (list scheduling for
//! register pressure: J. R. Goodman and W.-C. Hsu, Proc. Int. Conf. on Supercomputing (1988) 442-452). The arithmetic
//! is the same to the bit, as no expression changes.

use std::collections::{BTreeMap, BTreeSet};

use super::graph::Node;

/// What a statement does with its expression.
#[derive(Debug, Clone)]
pub enum Target {
    /// It gives values a name: one, or a sine and a cosine.
    Values(Vec<Node>),
    /// It stores an output, told by its place.
    Output(usize),
}

/// What a statement binds and reads.
#[derive(Debug, Clone)]
pub struct Statement {
    /// What becomes of its expression.
    pub target: Target,
    /// Named values in its expression, each once.
    pub reads: BTreeSet<Node>,
}

impl Statement {
    fn binds(&self) -> &[Node] {
        match &self.target {
            Target::Values(nodes) => nodes,
            Target::Output(_) => &[],
        }
    }
}

/// An order of the statements, as places in `statements`, in which each stands behind those that bind what it reads.
/// Values that no statement binds are taken to be there from the beginning.
pub fn order(statements: &[Statement]) -> Vec<usize> {
    let binders: BTreeMap<Node, usize> = statements
        .iter()
        .enumerate()
        .flat_map(|(place, it)| it.binds().iter().map(move |&node| (node, place)))
        .collect();
    let sources: Vec<BTreeSet<Node>> = statements
        .iter()
        .map(|it| it.reads.iter().copied().filter(|node| binders.contains_key(node)).collect())
        .collect();
    let mut readers: BTreeMap<Node, Vec<usize>> = BTreeMap::new();
    for (place, reads) in sources.iter().enumerate() {
        for &node in reads {
            readers.entry(node).or_default().push(place);
        }
    }
    let mut unread: BTreeMap<Node, usize> = readers.iter().map(|(&node, places)| (node, places.len())).collect();
    let mut waits_for: Vec<usize> = sources.iter().map(BTreeSet::len).collect();
    let mut ready: BTreeSet<usize> = (0..statements.len()).filter(|&place| waits_for[place] == 0).collect();
    let mut rank_of: BTreeMap<Node, usize> = BTreeMap::new();
    let mut order = Vec::with_capacity(statements.len());
    // Lives begun less lives ended; then what reads the youngest value, so that a chain is followed; then the old
    // order.
    let key = |place: usize, unread: &BTreeMap<Node, usize>, rank_of: &BTreeMap<Node, usize>| {
        let begun = statements[place].binds().iter().filter(|node| readers.contains_key(node)).count();
        let ended = sources[place].iter().filter(|node| unread.get(node) == Some(&1)).count();
        let youngest = sources[place].iter().filter_map(|node| rank_of.get(node)).max();
        (begun as isize - ended as isize, std::cmp::Reverse(youngest.copied()), place)
    };
    while let Some(place) = ready.iter().copied().min_by_key(|&place| key(place, &unread, &rank_of)) {
        ready.remove(&place);
        for node in &sources[place] {
            unread.entry(*node).and_modify(|left| *left -= 1);
        }
        for &node in statements[place].binds() {
            rank_of.insert(node, order.len());
            for &reader in readers.get(&node).map_or(&[][..], Vec::as_slice) {
                waits_for[reader] -= 1;
                if waits_for[reader] == 0 {
                    ready.insert(reader);
                }
            }
        }
        order.push(place);
    }
    order
}

/// The most values that are bound and still to be read at once.
#[cfg(test)]
fn pressure(statements: &[Statement], order: &[usize]) -> usize {
    let last = |node: &Node| order.iter().rposition(|&place| statements[place].reads.contains(node));
    let mut deaths: BTreeMap<usize, usize> = BTreeMap::new();
    let (mut alive, mut most) = (0, 0);
    for (rank, &place) in order.iter().enumerate() {
        alive -= deaths.remove(&rank).unwrap_or(0);
        for death in statements[place].binds().iter().filter_map(last) {
            *deaths.entry(death).or_insert(0) += 1;
            alive += 1;
        }
        most = most.max(alive);
    }
    most
}

#[cfg(test)]
mod tests {
    use super::*;

    fn statement(binds: &[usize], reads: &[usize]) -> Statement {
        let nodes = |places: &[usize]| places.iter().copied().map(Node).collect::<Vec<_>>();
        let target = if binds.is_empty() { Target::Output(0) } else { Target::Values(nodes(binds)) };
        Statement { target, reads: nodes(reads).into_iter().collect() }
    }

    /// Ten values that are all bound first and stored in the end need ten registers; bound and stored in turn, one.
    #[test]
    fn lives_are_short() {
        let bound = (0..10).map(|value| statement(&[value], &[100]));
        let stored = (0..10).map(|value| statement(&[], &[value]));
        let statements: Vec<_> = bound.chain(stored).collect();
        let as_written: Vec<usize> = (0..20).collect();
        assert_eq!((pressure(&statements, &as_written), pressure(&statements, &order(&statements))), (10, 1));
    }

    /// Every statement stands once, behind what it reads, whatever the graph.
    #[test]
    fn what_is_read_is_bound_before() {
        let mut state = 7_u64;
        let mut draw = |below: usize| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        for size in [1, 2, 30, 200] {
            let statements: Vec<_> = (0..size)
                .map(|place| {
                    let reads: Vec<usize> =
                        (0..draw(4)).map(|_| draw(place + 1)).filter(|&read| read < place).collect();
                    if draw(5) == 0 { statement(&[], &reads) } else { statement(&[place], &reads) }
                })
                .collect();
            let order = order(&statements);
            let rank: BTreeMap<usize, usize> = order.iter().enumerate().map(|(rank, &place)| (place, rank)).collect();
            assert_eq!((order.len(), rank.len()), (size, size));
            for (place, statement) in statements.iter().enumerate() {
                for read in statement.reads.iter().filter(|read| !statements[read.0].binds().is_empty()) {
                    assert!(rank[&read.0] < rank[&place], "{place} stands before {}", read.0);
                }
            }
        }
    }
}
