//! The four regions of the belt loop, and how a kernel's local constants are bound to those of the drive.

use generated::RegionKernel;

use crate::model::{Constant, RegionConstant};

/// A region of the belt loop, in the order in which the belt runs through them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(usize)]
pub enum RegionId {
    /// Contact with the primary pulley.
    Primary,
    /// Span from the primary to the secondary.
    SlackSpan,
    /// Contact with the secondary pulley.
    Secondary,
    /// Span from the secondary to the primary.
    TightSpan,
}

impl RegionId {
    /// All regions, in order.
    pub const ALL: [Self; 4] = [Self::Primary, Self::SlackSpan, Self::Secondary, Self::TightSpan];

    /// Place in the problem's list of regions.
    pub const fn index(self) -> usize {
        self as usize
    }

    /// Whether the belt lies in a groove here.
    pub const fn is_contact(self) -> bool {
        matches!(self, Self::Primary | Self::Secondary)
    }

    /// Name that messages, results and files use.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::SlackSpan => "slack_span",
            Self::Secondary => "secondary",
            Self::TightSpan => "tight_span",
        }
    }

    /// Where in a sentence.
    pub(crate) const fn place(self) -> &'static str {
        match self {
            Self::Primary => "on the primary",
            Self::SlackSpan => "in the slack span",
            Self::Secondary => "on the secondary",
            Self::TightSpan => "in the tight span",
        }
    }

    /// What stands for a kernel's local constant in this region; `None` if it has no meaning here.
    pub(crate) const fn source(self, local: RegionConstant) -> Option<Source> {
        let constant = match (local, self) {
            (RegionConstant::PulleySpeedRatio, Self::Primary) => return Some(Source::One),
            (RegionConstant::PulleySpeedRatio, Self::Secondary) => Constant::SpeedRatio,
            (RegionConstant::WrapAngle, Self::Primary) => Constant::PrimaryWrap,
            (RegionConstant::WrapAngle, Self::Secondary) => Constant::SecondaryWrap,
            (RegionConstant::PulleyRadius, Self::Primary) => Constant::PrimaryRadius,
            (RegionConstant::PulleyRadius, Self::Secondary) => Constant::SecondaryRadius,
            (RegionConstant::SpanLength, Self::TightSpan) => Constant::TightLength,
            (RegionConstant::SpanLength, Self::SlackSpan) => Constant::SlackLength,
            (
                RegionConstant::PulleySpeedRatio | RegionConstant::WrapAngle | RegionConstant::PulleyRadius,
                Self::TightSpan | Self::SlackSpan,
            )
            | (RegionConstant::SpanLength, Self::Primary | Self::Secondary) => return None,
            (RegionConstant::Flow, _) => Constant::Flow,
            (RegionConstant::LongitudinalStiffness, _) => Constant::LongitudinalStiffness,
            (RegionConstant::BendingStiffness, _) => Constant::BendingStiffness,
            (RegionConstant::RadialStiffness, _) => Constant::RadialStiffness,
            (RegionConstant::MassPerLength, _) => Constant::MassPerLength,
            (RegionConstant::PrimaryRadius, _) => Constant::PrimaryRadius,
            (RegionConstant::HalfAngle, _) => Constant::HalfAngle,
            (RegionConstant::FrictionCoefficient, _) => Constant::FrictionCoefficient,
            (RegionConstant::SlipThreshold, _) => Constant::SlipThreshold,
            (RegionConstant::PrimarySpeed, _) => Constant::PrimarySpeed,
        };
        Some(Source::Constant(constant.index()))
    }
}

/// What a local constant of a kernel stands for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Source {
    /// This constant of the drive.
    Constant(usize),
    /// The number one (the primary's own speed ratio).
    One,
}

/// A kernel with its local constants bound.
#[derive(Debug, Clone)]
pub(super) struct BoundRegion {
    pub kernel: &'static RegionKernel,
    sources: Vec<Source>,
    /// For each entry of the region's own pattern, the kernel's entries that add up to it.
    gather: Vec<[Option<usize>; 2]>,
    /// Derivatives `(row, constant)` in the drive's constants.
    pub pattern: Vec<(usize, usize)>,
    /// Leading entries of `pattern` that come of default unknowns alone.
    pub default_entries: usize,
    /// The kernel's entries are the region's, one for one, so far as those of default unknowns go.
    direct: bool,
}

impl BoundRegion {
    /// Binds `kernel` in `region`; `None` when a local constant has no meaning there.
    pub fn new(region: RegionId, kernel: &'static RegionKernel) -> Option<Self> {
        Self::bound(kernel, |local| region.source(local))
    }

    /// Binds `kernel` to what `source` says; `None` when that knows no meaning of a local constant.
    pub fn bound(kernel: &'static RegionKernel, source: impl Fn(RegionConstant) -> Option<Source>) -> Option<Self> {
        let sources = kernel.constants.iter().map(|local| source(*local)).collect::<Option<Vec<_>>>()?;
        let (mut pattern, mut gather) = (Vec::new(), Vec::<[Option<usize>; 2]>::new());
        let mut default_entries = 0;
        for (entry, &(row, local)) in kernel.constant_pattern.iter().enumerate() {
            if let Source::Constant(constant) = sources[local] {
                match pattern.iter().position(|&seen| seen == (row, constant)) {
                    Some(at) => gather[at][1] = Some(entry),
                    None => {
                        pattern.push((row, constant));
                        gather.push([Some(entry), None]);
                    }
                }
            }
            if entry + 1 == kernel.default_entries {
                default_entries = pattern.len();
            }
        }
        let direct = gather[..default_entries].iter().enumerate().all(|(at, entries)| entries[0] == Some(at))
            && gather[..default_entries].len() == kernel.default_entries;
        Some(Self { kernel, sources, gather, pattern, default_entries, direct })
    }

    /// The kernel's local constants.
    pub fn local(&self, constants: &[f64]) -> Vec<f64> {
        let value = |source: &Source| match *source {
            Source::Constant(constant) => constants.get(constant).copied().unwrap_or(f64::NAN),
            Source::One => 1.0,
        };
        self.sources.iter().map(value).collect()
    }

    /// Whether the derivatives in default unknowns can be written by the kernel straight into the region's.
    pub fn direct(&self) -> bool {
        self.direct
    }

    /// Adds the kernel's derivatives up to those of the region: `entries` of them, `stride` apart.
    pub fn gather(&self, entries: usize, stride: usize, local: &[f64], out: &mut [f64]) {
        for (sum, from) in out.chunks_exact_mut(stride).zip(&self.gather).take(entries) {
            let mut terms = from.iter().flatten().map(|&entry| &local[entry * stride..(entry + 1) * stride]);
            if let Some(first) = terms.next() {
                sum.copy_from_slice(first);
            }
            for term in terms {
                sum.iter_mut().zip(term).for_each(|(sum, term)| *sum += term);
            }
        }
    }
}
