//! The table of all keys.

use super::super::range::{Range, RangeEnd};
use super::{Entry, Key, ValueKind};
use crate::model::{
    Choice, Edition, Ends, FlyweightKind, Free, Friction, HelixAngleFrom, Include, SecondaryKind, Shear, Spans,
};
use crate::quantity::{Dimension, Unit};

/// Of a belt and the air around it, K. A bare number below is one of degrees Celsius.
const TEMPERATURES: Range = Range::within(150.0, 2000.0);
const NUMBER: Unit = Unit::decimal("", 0, Dimension::NONE);
const PERCENT: Unit = Unit::decimal("%", -2, Dimension::NONE);
const MM: Unit = Unit::MILLIMETRE;
const KG_PER_M: Unit = Unit::decimal("kg/m", 0, Dimension::MASS_PER_LENGTH);
const N: Unit = Unit::decimal("N", 0, Dimension::FORCE);
const KN: Unit = Unit::decimal("kN", 3, Dimension::FORCE);
const NM: Unit = Unit::decimal("N*m", 0, Dimension::TORQUE);
const NM2: Unit = Unit::decimal("N*m^2", 0, Dimension::BENDING_STIFFNESS);
const MPA: Unit = Unit::decimal("MPa", 6, Dimension::PRESSURE);
const DEG: Unit = Unit::DEGREE;
const M_PER_S: Unit = Unit::decimal("m/s", 0, Dimension::SPEED);
const NM_S: Unit = Unit::decimal("N*m*s", 0, Dimension::DRAG_PER_SPEED);
const K: Unit = Unit::decimal("K", 0, Dimension::TEMPERATURE);
const PER_K: Unit = Unit::decimal("1/K", 0, Dimension::PER_TEMPERATURE);
const W_PER_K: Unit = Unit::decimal("W/K", 0, Dimension::HEAT_TRANSFER);
const G: Unit = Unit::decimal("g", -3, Dimension::MASS);
const KG: Unit = Unit::decimal("kg", 0, Dimension::MASS);
const N_PER_MM: Unit = Unit::decimal("N/mm", 3, Dimension::SPRING_RATE);
const NM_PER_RAD: Unit = Unit::decimal("N*m/rad", 0, Dimension::TORSION_RATE);
const M2: Unit = Unit::decimal("m^2", 0, Dimension::AREA);
const KG_PER_M3: Unit = Unit::decimal("kg/m^3", 0, Dimension::DENSITY);
const W_PER_M2_K: Unit = Unit::decimal("W/(m^2*K)", 0, Dimension::HEAT_TRANSFER_PER_AREA);
const RPM: Unit = Unit::RPM;

/// A quantity of the base case.
const fn base(unit: Unit, range: Range, value: f64) -> ValueKind {
    ValueKind::Quantity { unit, range, example: value, base: true }
}

/// A quantity that the base case does not have.
const fn other(unit: Unit, range: Range, example: f64) -> ValueKind {
    ValueKind::Quantity { unit, range, example, base: false }
}

const fn list(unit: Unit, range: Range, example: &'static str) -> ValueKind {
    ValueKind::List { unit, range, example }
}

const fn choice(choices: &'static [Choice], default: Option<&'static str>) -> ValueKind {
    ValueKind::Choice { choices, default }
}

const fn entry(key: Key, path: &'static str, symbol: &'static str, kind: ValueKind, doc: &'static str) -> Entry {
    Entry { key, path, symbol, doc, kind }
}

/// Every key, in the order of [`Key`]. Defaults are those of Table 6.1; upper bounds lie far beyond any drive and catch
/// numbers written without their unit.
#[rustfmt::skip]
pub static TABLE: [Entry; 104] = [
    entry(Key::Edition, "edition", "", choice(Edition::CHOICES, Some(Edition::Consistent.name())),
        "set of modelling choices"),
    entry(Key::Shear, "model.shear", "", choice(Shear::CHOICES, None),
        "shear force in the contact regions, in place of the edition's"),
    entry(Key::Ends, "model.ends", "", choice(Ends::CHOICES, None),
        "shear force at the ends of the contact regions, in place of the edition's"),
    entry(Key::Spans, "model.spans", "", choice(Spans::CHOICES, None),
        "equations of the free spans, in place of the edition's"),
    entry(Key::Friction, "model.friction", "", choice(Friction::CHOICES, None),
        "friction law, in place of the edition's"),
    entry(Key::BeltLength, "belt.length", "L_belt", base(MM, Range::positive_to(1e5), 857.2),
        "unstretched length of the belt"),
    entry(Key::MassPerLength, "belt.mass_per_length", "m_o", base(KG_PER_M, Range::positive_to(1e3), 0.4375),
        "mass per length of the unstretched belt"),
    entry(Key::LongitudinalStiffness, "belt.longitudinal_stiffness", "EA", base(KN, Range::POSITIVE, 243.5),
        "force over longitudinal strain"),
    entry(Key::BendingStiffness, "belt.bending_stiffness", "EI", base(NM2, Range::POSITIVE, 0.2602),
        "bending moment over curvature; not used by `edition = \"string\"`"),
    entry(Key::RadialStiffness, "belt.radial_stiffness", "k", base(MPA, Range::POSITIVE, 18.71),
        "radial force per length over radial penetration"),
    entry(Key::Perimeter, "belt.perimeter", "", base(MM, Range::positive_to(1e4), 77.3),
        "length around the belt's section; with the belt's length, the surface that gives off heat"),
    entry(Key::LossTangent, "belt.loss_tangent", "tan δ", base(NUMBER, Range::up_to(10.0), 1.0 / 8.2),
        "loss over storage modulus of bending and squeezing; 0: no hysteresis"),
    entry(Key::CordLossTangent, "belt.cord_loss_tangent", "tan δ_c", base(NUMBER, Range::up_to(10.0), 0.0),
        "loss over storage modulus of the cord's stretching"),
    entry(Key::HalfAngle, "sheave.half_angle", "β", base(DEG, Range::positive_below(45.0), 12.0),
        "half the angle between the flanks of the groove"),
    entry(Key::FrictionCoefficient, "sheave.friction_coefficient", "μ_k", base(NUMBER, Range::positive_to(5.0), 0.4),
        "kinetic friction coefficient of belt on sheave"),
    entry(Key::SlipThreshold, "sheave.slip_threshold", "v_thr", base(M_PER_S, Range::positive_to(100.0), 1e-4),
        "sliding speed at which friction is fully developed"),
    entry(Key::CenterDistance, "drive.center_distance", "L_c", base(MM, Range::positive_to(1e4), 214.0),
        "distance between the centres of the pulleys"),
    entry(Key::PrimaryRadius, "drive.primary_radius", "R_P", base(MM, Range::positive_to(1e4), 68.309),
        "nominal radius of the belt on the primary"),
    entry(Key::SecondaryRadius, "drive.secondary_radius", "R_S", base(MM, Range::positive_to(1e4), 68.309),
        "nominal radius of the belt on the secondary"),
    entry(Key::Ratio, "drive.ratio", "R_S/R_P", other(NUMBER, Range::positive_to(100.0), 1.0),
        "in place of both radii, which then follow from belt.length (6.12)"),
    entry(Key::Free, "drive.free", "", choice(Free::CHOICES, None),
        "radii solved for, so that the unstretched belt in the drive has belt.length"),
    entry(Key::PrimarySpeed, "operating_point.primary_speed", "ω_P", base(RPM, Range::POSITIVE, 3400.0),
        "speed of the primary"),
    entry(Key::SecondarySpeed, "operating_point.secondary_speed", "ω_S", other(RPM, Range::POSITIVE, 3380.0),
        "speed of the secondary: the speed, or beside primary_speed the load"),
    entry(Key::PrimaryTorque, "operating_point.primary_torque", "M_in", base(NM, Range::ANY, 18.0),
        "torque into the primary; negative in engine braking"),
    entry(Key::SecondaryTorque, "operating_point.secondary_torque", "M_out", other(NM, Range::ANY, 17.0),
        "torque out of the secondary; negative in engine braking"),
    entry(Key::SpeedRatio, "operating_point.speed_ratio", "ω_S/ω_P", other(NUMBER, Range::positive_to(100.0), 0.99),
        "speed of the secondary over that of the primary"),
    entry(Key::SlackTension, "operating_point.slack_tension", "T_slack", base(N, Range::POSITIVE, 100.0),
        "tractive tension at the exit of the primary"),
    entry(Key::TightTension, "operating_point.tight_tension", "T_tight", other(N, Range::POSITIVE, 360.0),
        "tractive tension at the entry of the primary"),
    entry(Key::PrimaryAxialForce, "operating_point.primary_axial_force", "A_P", other(N, Range::POSITIVE, 900.0),
        "force that pushes the sheaves of the primary together"),
    entry(Key::SecondaryAxialForce, "operating_point.secondary_axial_force", "A_S", other(N, Range::POSITIVE, 550.0),
        "force that pushes the sheaves of the secondary together"),
    entry(Key::SlipReserve, "operating_point.slip_reserve", "", other(PERCENT, Range::positive_below(100.0), 20.0),
        "share of the friction at hand that is to be left over: the clamp that does it is found"),
    entry(Key::FrictionUtilization, "operating_point.friction_utilization", "", other(PERCENT,
        Range::positive_below(100.0), 80.0),
        "share of the friction at hand that is to be used, 1 less the slip reserve"),
    entry(Key::Losses, "losses.include", "", choice(Include::CHOICES, None),
        "whether losses besides friction are told; on unless the edition has none"),
    entry(Key::PrimaryDrag, "losses.primary_drag", "M_dP", base(NM, Range::up_to(1e4), 0.0),
        "torque that bearings and seals of the primary take at every speed"),
    entry(Key::SecondaryDrag, "losses.secondary_drag", "M_dS", base(NM, Range::up_to(1e4), 0.0),
        "torque that bearings and seals of the secondary take at every speed"),
    entry(Key::PrimaryDragPerSpeed, "losses.primary_drag_per_speed", "c_P", base(NM_S, Range::up_to(1e3), 0.0),
        "torque that drags at the primary, over its speed"),
    entry(Key::SecondaryDragPerSpeed, "losses.secondary_drag_per_speed", "c_S", base(NM_S, Range::up_to(1e3), 0.0),
        "torque that drags at the secondary, over its speed"),
    entry(Key::GearEfficiency, "losses.gear_efficiency", "η_g", base(NUMBER, Range::positive_to(1.0), 1.0),
        "efficiency of gears between the secondary and the shaft of interest"),
    entry(Key::Ambient, "thermal.ambient", "T_a", other(K, TEMPERATURES, 298.15),
        "temperature of the air around the belt; degC and degF are understood"),
    entry(Key::HeatTransfer, "thermal.heat_transfer", "h", other(W_PER_K, Range::positive_to(1e5), 10.0),
        "heat that the belt gives off over its excess of temperature"),
    entry(Key::HeatTransferPerArea, "thermal.heat_transfer_per_area", "", other(W_PER_M2_K, Range::positive_to(1e6),
        150.0),
        "the same over the belt's surface, in place of thermal.heat_transfer"),
    entry(Key::FrictionShare, "thermal.friction_share", "", base(NUMBER, Range::up_to(1.0), 0.5),
        "share of the friction loss that heats the belt; the rest heats the sheaves"),
    entry(Key::ReferenceTemperature, "thermal.reference", "T_0", base(K, TEMPERATURES, 333.15),
        "temperature at which the belt's stiffnesses are given"),
    entry(Key::BendingSoftening, "thermal.bending_softening", "", base(PER_K, Range::up_to(1.0), 0.0125),
        "share by which the bending stiffness falls per kelvin"),
    entry(Key::RadialSoftening, "thermal.radial_softening", "", base(PER_K, Range::up_to(1.0), 0.0125),
        "share by which the radial stiffness falls per kelvin"),
    entry(Key::StartRadius, "primary.start_radius", "R_P0", other(MM, Range::positive_to(1e4), 33.0),
        "radius of the belt on the primary where its sheave's travel is zero; where the belt fits with the secondary \
        closed, if not given"),
    entry(Key::PrimaryTravel, "primary.travel", "s_P", other(MM, Range::positive_to(1e4), 18.0),
        "travel of the primary's movable sheave at which it is closed to its stop"),
    entry(Key::Flyweights, "primary.actuator.type", "", choice(FlyweightKind::CHOICES, None),
        "what presses on the primary"),
    entry(Key::FlyweightCount, "primary.actuator.count", "N", other(NUMBER, Range::positive_to(100.0), 3.0),
        "number of flyweights"),
    entry(Key::FlyweightMass, "primary.actuator.mass", "m", other(G, Range::positive_to(1e5), 72.0),
        "mass of one flyweight"),
    entry(Key::FlyweightFriction, "primary.actuator.friction_angle", "ρ", other(DEG, Range::up_to(45.0), 3.0),
        "friction angle of the flyweights' contact; 0 if not given"),
    entry(Key::FlyweightLost, "primary.actuator.friction_loss", "", other(NUMBER, Range { low: RangeEnd::Closed(0.0),
        high: RangeEnd::Open(1.0) }, 0.05),
        "table: share of the flyweights' force that friction takes; 0 if not given"),
    entry(Key::FlyweightTravels, "primary.actuator.travels", "s", list(MM, Range::ANY, "0, 7.2, 14.4, 21.6, 28.8 mm"),
        "table, ramp: travels at which the next list holds"),
    entry(Key::FlyweightCoefficients, "primary.actuator.coefficients", "r dr/ds", list(MM, Range::POSITIVE,
        "39.5, 39.3, 38.4, 37.4, 38 mm"),
        "table: r dr/ds of a flyweight over the travels; r sin θ of a bench"),
    entry(Key::FlyweightRadii, "primary.actuator.radii", "r", list(MM, Range::POSITIVE, "38, 40, 43, 46, 48 mm"),
        "ramp: radius of a flyweight's centre of mass over the travels"),
    entry(Key::PivotRadius, "primary.actuator.pivot_radius", "R_p", other(MM, Range::positive_to(1e4), 41.88),
        "arm, cam: radius of the arm's pivot from the shaft"),
    entry(Key::ArmLength, "primary.actuator.arm_length", "l_r", other(MM, Range::positive_to(1e4), 33.02),
        "arm: from the pivot to the roller's centre"),
    entry(Key::MassDistance, "primary.actuator.mass_distance", "l_m", other(MM, Range::positive_to(1e4), 33.02),
        "arm, cam: from the pivot to the centre of mass"),
    entry(Key::MassAngle, "primary.actuator.mass_angle", "δ", other(DEG, Range::within(-360.0, 360.0), 0.0),
        "arm, cam: angle of the centre of mass in the arm; 0 if not given"),
    entry(Key::RampStart, "primary.actuator.ramp_start", "x_0", other(MM, Range::within(-1e4, 1e4), 37.88),
        "arm: place on the ramp that the pivot faces at no travel"),
    entry(Key::RampPlaces, "primary.actuator.ramp_places", "x", list(MM, Range::ANY, "0, 10, 20, 30 mm"),
        "arm: places along the ramp at which the next list holds"),
    entry(Key::RampRadii, "primary.actuator.ramp_radii", "h", list(MM, Range::POSITIVE, "40, 45, 49, 51 mm"),
        "arm: radius from the shaft to which the ramp lets the roller's centre"),
    entry(Key::RollerRadius, "primary.actuator.roller_radius", "R_r", other(MM, Range::positive_to(1e4), 52.0),
        "cam: radius of the fixed roller's centre from the shaft"),
    entry(Key::RollerStart, "primary.actuator.roller_start", "z_0", other(MM, Range::within(-1e4, 1e4), 25.0),
        "cam: along the shaft from the pivot to the roller's centre at no travel"),
    entry(Key::PitchDistances, "primary.actuator.pitch_distances", "d", list(MM, Range::POSITIVE, "24, 30, 36, 44 mm"),
        "cam: distances from the pivot at which the next list holds"),
    entry(Key::PitchAngles, "primary.actuator.pitch_angles", "ξ", list(DEG, Range::ANY, "34, 18, 0, -22 deg"),
        "cam: angle in the arm at which the roller's centre lies at that distance"),
    entry(Key::PrimaryServoForce, "primary.actuator.force", "F_P", other(N, Range::POSITIVE, 2000.0),
        "servo: axial force on the primary"),
    entry(Key::PrimaryServoPosition, "primary.actuator.position", "", other(MM, Range::up_to(1e4), 6.0),
        "servo: travel at which the primary is held, in place of a force"),
    entry(Key::PrimarySpringRate, "primary.spring.rate", "c_P", other(N_PER_MM, Range::positive_to(1e5), 8.2),
        "rate of the spring against the flyweights"),
    entry(Key::PrimarySpringPreload, "primary.spring.preload", "F_P0", other(N, Range::up_to(1e6), 385.0),
        "its force at no travel"),
    entry(Key::PrimarySpringFree, "primary.spring.free_length", "", other(MM, Range::positive_to(1e4), 106.0),
        "its free length, in place of the preload"),
    entry(Key::PrimarySpringInstalled, "primary.spring.installed_length", "", other(MM, Range::positive_to(1e4), 59.0),
        "its length at no travel, beside the free length"),
    entry(Key::PrimarySpringSolid, "primary.spring.solid_length", "", other(MM, Range::positive_to(1e4), 25.0),
        "its length when its turns touch"),
    entry(Key::ClosedRadius, "secondary.closed_radius", "R_S0", other(MM, Range::positive_to(1e4), 88.0),
        "radius of the belt on the secondary where its sheaves are closed to their stop"),
    entry(Key::SecondaryTravel, "secondary.travel", "s_S", other(MM, Range::positive_to(1e4), 18.0),
        "travel at which the secondary's movable sheave is open to its stop"),
    entry(Key::SecondaryActuator, "secondary.actuator.type", "", choice(SecondaryKind::CHOICES, None),
        "what presses on the secondary"),
    entry(Key::HelixRadius, "secondary.actuator.helix_radius", "r_h", other(MM, Range::positive_to(1e4), 46.04),
        "radius at which the helix bears"),
    entry(Key::HelixAngle, "secondary.actuator.helix_angle", "α", other(DEG, Range { low: RangeEnd::Open(0.0),
        high: RangeEnd::Open(90.0) }, 38.0),
        "helix angle"),
    entry(Key::HelixOpenings, "secondary.actuator.helix_openings", "s", list(MM, Range::ANY, "0, 9, 18 mm"),
        "varying helix: openings of the secondary at which the next list holds"),
    entry(Key::HelixAngles, "secondary.actuator.helix_angles", "α", list(DEG, Range { low: RangeEnd::Open(0.0),
        high: RangeEnd::Open(90.0) }, "42, 38, 34 deg"),
        "varying helix: helix angle over the openings, in place of one angle"),
    entry(Key::HelixAngleFrom, "secondary.actuator.angle_from", "", choice(HelixAngleFrom::CHOICES,
        Some(HelixAngleFrom::Rotation.name())),
        "from where helix angles are measured"),
    entry(Key::HelixFriction, "secondary.actuator.friction_angle", "ρ", other(DEG, Range::up_to(45.0), 3.0),
        "friction angle of the helix's flanks; 0 if not given"),
    entry(Key::TorqueShare, "secondary.actuator.torque_share", "ζ", other(NUMBER, Range::up_to(1.0), 0.5),
        "share of the belt's torque that the movable sheave carries; 0.5 if not given"),
    entry(Key::SecondaryServoForce, "secondary.actuator.force", "F_S", other(N, Range::POSITIVE, 1500.0),
        "servo: axial force on the secondary"),
    entry(Key::SecondarySpringRate, "secondary.spring.rate", "c_S", other(N_PER_MM, Range::up_to(1e5), 2.57),
        "axial rate of the secondary's spring; 0 if not given"),
    entry(Key::SecondarySpringPreload, "secondary.spring.preload", "F_S0", other(N, Range::up_to(1e6), 77.0),
        "its axial force where the secondary is closed; 0 if not given"),
    entry(Key::SecondarySpringFree, "secondary.spring.free_length", "", other(MM, Range::positive_to(1e4), 75.0),
        "its free length, in place of the preload"),
    entry(Key::SecondarySpringInstalled, "secondary.spring.installed_length", "", other(MM, Range::positive_to(1e4),
        45.0),
        "its length where the secondary is closed, beside the free length"),
    entry(Key::SecondarySpringSolid, "secondary.spring.solid_length", "", other(MM, Range::positive_to(1e4), 20.0),
        "its length when its turns touch"),
    entry(Key::TorsionRate, "secondary.spring.torsion_rate", "κ_t", other(NM_PER_RAD, Range::up_to(1e4), 3.83),
        "rate of the spring in torsion; 0 if not given"),
    entry(Key::Pretension, "secondary.spring.pretension", "φ_0", other(DEG, Range::up_to(3600.0), 60.0),
        "angle by which the spring is wound up when installed; 0 if not given"),
    entry(Key::EngineSpeeds, "engine.speeds", "n", list(RPM, Range::POSITIVE, "1800, 2400, 3000, 3400, 3800 rpm"),
        "speeds at which the next list holds"),
    entry(Key::EngineTorques, "engine.torques", "M", list(NM, Range::ANY, "24, 26, 26.4, 24.8, 22 N*m"),
        "torque at full throttle over the speeds"),
    entry(Key::Throttle, "engine.throttle", "", other(NUMBER, Range::positive_to(1.0), 1.0),
        "factor on the torque: part throttle; 1 if not given"),
    entry(Key::GovernedSpeed, "engine.governed_speed", "", other(RPM, Range::POSITIVE, 3700.0),
        "speed from which the governor takes torque away"),
    entry(Key::NoLoadSpeed, "engine.no_load_speed", "", other(RPM, Range::POSITIVE, 3950.0),
        "speed at which the governor leaves none"),
    entry(Key::VehicleMass, "vehicle.mass", "m_v", other(KG, Range::positive_to(1e6), 227.0),
        "mass of the vehicle with its driver"),
    entry(Key::FinalRatio, "vehicle.final_ratio", "i_f", other(NUMBER, Range::positive_to(1e3), 8.32),
        "turns of the secondary for a turn of the wheel"),
    entry(Key::WheelRadius, "vehicle.wheel_radius", "r_w", other(MM, Range::positive_to(1e4), 279.0),
        "rolling radius of the wheel"),
    entry(Key::RollingResistance, "vehicle.rolling_resistance", "c_r", other(NUMBER, Range::up_to(1.0), 0.03),
        "coefficient of rolling resistance; 0 if not given"),
    entry(Key::DragArea, "vehicle.drag_area", "C_d A", other(M2, Range::up_to(1e3), 0.55),
        "drag area; 0 if not given"),
    entry(Key::Grade, "vehicle.grade", "", other(NUMBER, Range::within(-10.0, 10.0), 0.0),
        "grade of the ground, rise over run; 0 if not given"),
    entry(Key::AirDensity, "vehicle.air_density", "ρ_air", other(KG_PER_M3, Range::up_to(100.0), 1.2),
        "density of the air; 1.2 kg/m³ if not given"),
    entry(Key::FinalEfficiency, "vehicle.final_efficiency", "η_f", other(NUMBER, Range::positive_to(1.0), 0.95),
        "efficiency of the final drive; 1 if not given"),
];
