"""Belt maps as Functional Mock-up Units, for Simulink, Modelica tools, FMPy and other simulators.

A unit is for co-simulation by FMI 2.0. Its inputs are the axes of the map, its outputs what the map tells, all in SI
units; outputs follow their inputs at once, with exact derivatives (``fmi2GetDirectionalDerivative``). Nothing is
extrapolated: outside the map ``valid`` is false and the outputs are not numbers, or those at the nearest point of the
map's range with the parameter ``hold``.
"""

from __future__ import annotations

import struct
import uuid
import zipfile
from pathlib import Path
from typing import TYPE_CHECKING, Union
from xml.etree import ElementTree as xml

from ._files import appearing
from ._sheave import fmu_library

if TYPE_CHECKING:
    from os import PathLike

    from ._sheave import BeltMap

__all__ = ["export"]

_HOLD, _VALID = 1000, 1001
_DERIVED = {
    "secondary.speed": ("rad/s", "Speed of the secondary"),
    "slip_reserve": ("1", "Share of the friction at hand that is left over"),
    "efficiency.overall": ("1", "Power out over power in, of the pulley that drives the other, friction alone counted"),
}
_DERIVED_OF_LOSSES = {
    "efficiency.overall_with_losses": ("1", "The same, less hysteresis, drag and gears"),
}
_LOSSES = "losses.total"
_UNITS = {
    "N": {"kg": 1, "m": 1, "s": -2},
    "N*m": {"kg": 1, "m": 2, "s": -2},
    "rad/s": {"s": -1, "rad": 1},
    "rad": {"rad": 1},
    "m": {"m": 1},
    "W": {"kg": 1, "m": 2, "s": -3},
    "1": {},
}


def export(belt_map: BeltMap, path: Union[str, PathLike[str]], *, name: str = "Drive") -> Path:
    """Writes a map as a Functional Mock-up Unit for this platform; the file appears whole.

    ``name`` is the model's, a name of C. The same map gives the same bytes.
    """
    if not name.isidentifier() or not name.isascii():
        raise ValueError(f"name = {name!r}: expected a name of C, such as Drive")
    target = Path(path)
    if target.suffix != ".fmu":
        raise ValueError("expected a file name that ends in .fmu")
    platform, file_ending, library = fmu_library()
    table = belt_map.table_bytes()
    guid = str(uuid.uuid5(uuid.NAMESPACE_OID, f"sheave {name} {_digest(table)}"))
    entries = {
        "modelDescription.xml": _description(belt_map, name, guid),
        "resources/map.bin": b"SHEAVEM1" + _text(guid) + table,
        f"binaries/{platform}/{name}{file_ending}": library,
    }
    with appearing(target) as beside, zipfile.ZipFile(beside, "w", zipfile.ZIP_DEFLATED) as archive:
        for entry, content in entries.items():
            info = zipfile.ZipInfo(entry)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, content)
    return target


def _digest(content: bytes) -> str:
    """What identifies some bytes."""
    import hashlib

    return hashlib.sha256(content).hexdigest()


def _text(text: str) -> bytes:
    encoded = text.encode()
    return struct.pack("<I", len(encoded)) + encoded


def _description(belt_map: BeltMap, name: str, guid: str) -> bytes:
    report = belt_map.report
    root = xml.Element(
        "fmiModelDescription",
        fmiVersion="2.0",
        modelName=name,
        guid=guid,
        description=f"Rubber V-belt drive from a belt map; largest error {report['error']['largest']:.1e}",
        generationTool="sheave",
        variableNamingConvention="structured",
    )
    xml.SubElement(
        root,
        "CoSimulation",
        modelIdentifier=name,
        canHandleVariableCommunicationStepSize="true",
        canInterpolateInputs="false",
        maxOutputDerivativeOrder="0",
        canBeInstantiatedOnlyOncePerProcess="false",
        canNotUseMemoryManagementFunctions="true",
        canGetAndSetFMUstate="true",
        canSerializeFMUstate="false",
        providesDirectionalDerivative="true",
    )
    outputs: dict[str, tuple[str, str]] = {key: (unit, "") for key, unit in belt_map.quantities.items()}
    outputs.update(_DERIVED)
    if _LOSSES in belt_map.quantities:
        outputs.update(_DERIVED_OF_LOSSES)
    inputs = belt_map.units
    used = {*(unit for unit, _ in outputs.values()), *inputs.values()}
    definitions = xml.SubElement(root, "UnitDefinitions")
    for unit in sorted(used):
        element = xml.SubElement(definitions, "Unit", name=unit)
        if unit in _UNITS:
            xml.SubElement(element, "BaseUnit", {base: str(power) for base, power in _UNITS[unit].items()})
    _declare_variables(root, belt_map, outputs)
    _declare_structure(root, len(inputs), len(outputs))
    xml.indent(root)
    text: bytes = xml.tostring(root, encoding="utf-8", xml_declaration=True)
    return text


def _declare_variables(root: xml.Element, belt_map: BeltMap, outputs: dict[str, tuple[str, str]]) -> None:
    """The inputs, the outputs with their units and meanings, and the two truths."""
    variables = xml.SubElement(root, "ModelVariables")
    inputs = belt_map.units

    def declare(kind: str, of_kind: dict[str, str], /, **attributes: str) -> None:
        xml.SubElement(xml.SubElement(variables, "ScalarVariable", attributes), kind, of_kind)

    for reference, (key, unit) in enumerate(inputs.items()):
        places = belt_map.breakpoints[key]
        least, start, most = (repr(float(places[at])) for at in (0, len(places) // 2, -1))
        declare(
            "Real",
            {"unit": unit, "min": least, "max": most, "start": start},
            name=f"inputs.{key}",
            valueReference=str(reference),
            causality="input",
            variability="continuous",
        )
    for reference, (key, (unit, meaning)) in enumerate(outputs.items(), start=len(inputs)):
        described = {"description": meaning} if meaning else {}
        declare(
            "Real",
            {"unit": unit},
            name=key,
            valueReference=str(reference),
            causality="output",
            variability="continuous",
            initial="calculated",
            **described,
        )
    declare(
        "Boolean",
        {"start": "false"},
        name="hold",
        valueReference=str(_HOLD),
        description="Outside the map, give the outputs at the nearest point of its range",
        causality="parameter",
        variability="tunable",
        initial="exact",
    )
    declare(
        "Boolean",
        {},
        name="valid",
        valueReference=str(_VALID),
        description="Whether the map has values for the inputs",
        causality="output",
        variability="discrete",
        initial="calculated",
    )


def _declare_structure(root: xml.Element, inputs: int, outputs: int) -> None:
    """What depends on what: every output and ``valid``, which stands behind ``hold``, on all inputs."""
    structure = xml.SubElement(root, "ModelStructure")
    first, behind = inputs + 1, inputs + outputs + 1
    # Of parameters, on which outputs depend too, only the structure at the beginning tells.
    for kind, last in (("Outputs", []), ("InitialUnknowns", [behind])):
        dependencies = " ".join(str(place) for place in [*range(1, inputs + 1), *last])
        unknowns = xml.SubElement(structure, kind)
        for place in [*range(first, behind), behind + 1]:
            xml.SubElement(unknowns, "Unknown", index=str(place), dependencies=dependencies)
