//! Which generated kernels a model stands for (model: editions).

use generated::{BoundaryKernel, OutputKernel, RegionKernel};

use crate::case::{Bending, Ends, Friction, ModelChoices, Shear, Spans};

/// The generated kernels of a model.
#[derive(Debug, Clone, Copy)]
pub(super) struct Kernels {
    pub contact: &'static RegionKernel,
    pub span: &'static RegionKernel,
    pub boundary: &'static BoundaryKernel,
    /// What the drive may be asked for.
    pub outputs: &'static OutputKernel,
}

impl Kernels {
    /// Those of `model`; `None` for a model that has none.
    pub fn of(model: &ModelChoices) -> Option<Self> {
        let Some(Bending { shear, ends, spans }) = model.bending else { return Some(Self::string(model.friction)) };
        let contact = match (shear, model.friction) {
            (Shear::Linearised, Friction::ViscousCoulomb) => &generated::CONTACT_LINEARISED_VISCOUS_COULOMB,
            (Shear::Linearised, Friction::Tanh) => &generated::CONTACT_LINEARISED_TANH,
            (Shear::Full, Friction::ViscousCoulomb) => &generated::CONTACT_FULL_VISCOUS_COULOMB,
            (Shear::Full, Friction::Tanh) => &generated::CONTACT_FULL_TANH,
        };
        let span = match spans {
            Spans::Derived => &generated::SPAN_DERIVED,
            Spans::AsPrinted => &generated::SPAN_AS_PRINTED,
        };
        let boundary = match (ends, shear) {
            (Ends::Zero, Shear::Linearised) => &generated::BOUNDARY_ZERO_LINEARISED,
            (Ends::Zero, Shear::Full) => &generated::BOUNDARY_ZERO_FULL,
            (Ends::Continuous, Shear::Linearised) => &generated::BOUNDARY_CONTINUOUS_LINEARISED,
            (Ends::Continuous, Shear::Full) => &generated::BOUNDARY_CONTINUOUS_FULL,
            (Ends::AsPrinted, Shear::Linearised) => &generated::BOUNDARY_AS_PRINTED,
            (Ends::AsPrinted, Shear::Full) => return None,
        };
        Some(Self { contact, span, boundary, outputs: &generated::OUTPUTS })
    }

    /// Those of a belt without bending stiffness.
    fn string(friction: Friction) -> Self {
        let contact = match friction {
            Friction::ViscousCoulomb => &generated::CONTACT_STRING_VISCOUS_COULOMB,
            Friction::Tanh => &generated::CONTACT_STRING_TANH,
        };
        let (span, boundary) = (&generated::SPAN_STRING, &generated::BOUNDARY_STRING);
        Self { contact, span, boundary, outputs: &generated::OUTPUTS_STRING }
    }
}
