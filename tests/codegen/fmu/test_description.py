"""What an FMU says of itself is what the manifest says of the model, and what its binary does."""

from __future__ import annotations

import subprocess
import xml.etree.ElementTree as ElementTree
import zipfile
from pathlib import Path

import numpy as np
import pytest

import cardan as cd
from cardan.codegen.fmu import platforms
from cardan.codegen.fmu.variables import per_second
from cardan.scene.units import unit as unit_of
from codegen.fmu.importing import Instance, description, model_of, problems, unit
from codegen.fmu.scenes import CASES
from codegen.running import STRICT, compilers

pytestmark = pytest.mark.skipif(not compilers(), reason="needs a C compiler")

QUICK = {("door", "3.0"), ("four_bar", "2.0"), ("tumbling", "3.0")}
PAIRS = [
    pytest.param(name, version, marks=[] if (name, version) in QUICK else [pytest.mark.slow])
    for version in ("3.0", "2.0")
    for name in CASES
]
SLOW = [pytest.param(n, marks=pytest.mark.slow) for n in ("gauges", "pendulum", "cart")]
VERSION = pytest.mark.parametrize("version", ["3.0", pytest.param("2.0", marks=pytest.mark.slow)])
BASES = ("kg", "m", "s", "A", "K")


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_variables_are_those_of_the_manifest(name: str, version: str) -> None:
    about, manifest = description(unit(name, version)), model_of(name).manifest
    variables = {v.name: v for v in about.modelVariables}
    assert [v.valueReference for v in about.modelVariables] == list(range(len(variables)))
    states = [*manifest.coordinates, *manifest.speeds, *manifest.z]
    assert about.numberOfContinuousStates == (0 if manifest.absolute else len(states))
    causalities = {"parameters": "parameter", "inputs": "input", "outputs": "output"}
    rows = [(row, ("output", "local")) for row in states]
    rows += [(row, (c,)) for block, c in causalities.items() for row in getattr(manifest, block)]
    for row, allowed in rows:
        variable = variables.pop(row.name)
        assert variable.causality in allowed
        assert (variable.unit or "") == row.unit
        if variable.causality in ("parameter", "input"):
            assert float(variable.start) == row.default
    for row in states if not manifest.absolute else ():
        rate = variables.pop(f"der({row.name})")
        assert rate.derivative.name == row.name
    modes = [v for v in variables.values() if v.variability == "discrete"]
    assert len(modes) == len(manifest.s)
    signs = [row.name for row in manifest.events if row.kind in ("mode", "impact", "end")]
    events = [n for n in variables if n.startswith("event.")]
    assert events == ([] if manifest.absolute else [f"event.{n}" for n in signs])
    left = {*variables} - {*events, *(v.name for v in modes), "time"}
    assert {n for n in left if not n.startswith("energy.")} <= {
        row.name for row in manifest.outputs
    }


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_units_have_their_exponents(name: str, version: str) -> None:
    about = description(unit(name, version))
    for one in about.unitDefinitions:
        dimension = dict(zip(BASES, unit_of(one.name).dimension, strict=True))
        base = one.baseUnit
        assert {b: getattr(base, b) for b in BASES} == dimension
        assert base.rad == unit_of(one.name).si.count("rad") or "/rad" in one.name
        shown = {d.name: d.factor for d in one.displayUnits}
        if one.name == "rad":
            assert shown == {"deg": pytest.approx(180 / np.pi)}


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_starts_are_those_of_a_run(name: str, version: str) -> None:
    """The description says what the binary starts from, and that is where simulate() starts."""
    case, model = CASES[name], model_of(name)
    x = model.simulate(np.linspace(0, 1e-3, 3), q=dict(case.q), u=dict(case.u)).x[0, : model.nx]
    about = description(unit(name, version))
    names = [*model.coordinates, *model.speeds, *model.internals]
    said = {v.name: float(v.start) for v in about.modelVariables if v.start is not None}
    # loops are closed to the last bit where the run begins
    assert [said[n] for n in names] == pytest.approx(x.tolist(), abs=1e-11)
    with Instance(unit(name, version)) as one:
        one.enter()
        assert one.get(*names) == pytest.approx(x.tolist(), abs=1e-11)


@pytest.mark.parametrize(("name", "version"), PAIRS)
def test_energies_and_outputs_are_those_of_the_model(name: str, version: str) -> None:
    model = model_of(name)
    names = [*model.coordinates, *model.speeds, *model.internals]
    with Instance(unit(name, version)) as one:
        one.begin()
        one.step(0.0, 0.1)
        q, u, _ = model.parts_of(np.array(one.get(*names)))
        t, r = 0.1, [row.default for row in model.manifest.inputs]
        given = {"t": t, **({"r": np.array(r)} if r else {})}
        expected = model.energy(q, u, **given)
        values = one.get("energy.kinetic", "energy.potential", "energy.total")
        assert values == pytest.approx(
            [float(expected.kinetic), float(expected.potential), float(expected.total)], rel=1e-9
        )


@pytest.mark.parametrize("name", ["tumbling", *SLOW])
def test_what_is_no_dependency_changes_nothing(name: str) -> None:
    """Zeros of the structure are zeros of the derivatives, at random states."""
    path = unit(name)
    about = description(path)
    with Instance(path, "me") as one:
        one.begin()
        one.update()
        one.fmu.enterContinuousTimeMode()
        rng = np.random.default_rng(2)
        x = one.states() + 0.3 * rng.standard_normal(len(one.state_names()))
        one.set_states(x)
        inputs = [v.name for v in about.modelVariables if v.causality == "input"]
        knowns = [*one.state_names(), *inputs]
        for row in (*about.derivatives, *about.outputs):
            on = {v.name for v in row.dependencies}
            others = [n for n in knowns if n not in on]
            for known in others:
                assert one.derivative([row.variable.name], [known], [1.0])[0] == 0
        lengths = [len(row.dependencies) for row in about.derivatives]
        assert min(lengths) < len(knowns)


def hostile_scene() -> cd.Scene:
    """Names that mean something to XML, HTML and C."""
    scene = cd.Scene('a <b> & "c" */')
    body = scene.body("body", mass=1.0, inertia=(0.1, 0.1, 0.1))
    scene.joint("<q> & 'r'", cd.Revolute("z"), scene.ground, body)
    scene.input('push "hard" %s', unit="N*m")
    return scene


@VERSION
def test_names_are_escaped(version: str, tmp_path: Path) -> None:
    path = cd.derive(hostile_scene()).export(tmp_path / "x.fmu", fmi=version)
    assert problems(path) == []
    names = [v.name for v in description(path).modelVariables]
    assert "<q> & 'r'" in names
    assert 'push "hard" %s' in names
    with Instance(path) as one:
        one.begin()
        with pytest.raises(Exception, match="status 3"):
            one.set({'push "hard" %s': float("nan")})
        assert 'push "hard" %s' in one.messages[-1]


def test_the_same_model_is_the_same_file(tmp_path: Path) -> None:
    equations = cd.derive(CASES["pendulum"].build())
    first = equations.export(tmp_path / "a.fmu", q={"shoulder": 1.0}).read_bytes()
    assert first == equations.export(tmp_path / "b.fmu", q={"shoulder": 1.0}).read_bytes()
    other = description(equations.export(tmp_path / "c.fmu", q={"shoulder": 1.1})).guid
    assert other != description(tmp_path / "a.fmu").guid


@VERSION
def test_sources_are_listed_and_compile(version: str, tmp_path: Path) -> None:
    """The listed sources alone make the binary, without a warning."""
    path = unit("door", version)
    with zipfile.ZipFile(path) as archive:
        archive.extractall(tmp_path)
        assert archive.namelist()[0] == "modelDescription.xml"
    sources = tmp_path / "sources"
    if version == "2.0":
        root = ElementTree.parse(tmp_path / "modelDescription.xml").getroot()
        listed = [one.get("name") for one in root.iter("File")]
        assert len(listed) == 2 * len(set(listed))
    else:
        root = ElementTree.parse(sources / "buildDescription.xml").getroot()
        listed = [one.get("name") for one in root.iter("SourceFile")]
    assert {*listed} == {p.name for p in sources.glob("*.c")}
    ours = [n for n in sorted({*listed}) if n.startswith("fm")]
    for compiler, command in compilers().items():
        for name in ours if compiler == "gcc" else ours[::3]:
            # of the headers of the standard
            flags = [*STRICT, *(["-Wno-strict-prototypes"] if compiler == "clang" else [])]
            answer = subprocess.run(
                [*command, *flags, "-O2", "-c", name, "-o", str(tmp_path / "o.o")],
                cwd=sources,
                capture_output=True,
                text=True,
            )
            assert answer.returncode == 0, answer.stderr[:2000]


@VERSION
def test_only_the_interface_is_visible(version: str, tmp_path: Path) -> None:
    with zipfile.ZipFile(unit("door", version)) as archive:
        (name,) = [n for n in archive.namelist() if n.startswith("binaries/")]
        archive.extract(name, tmp_path)
    answer = subprocess.run(
        ["nm", "-D", "--defined-only", str(tmp_path / name)], capture_output=True, text=True
    )
    symbols = [line.split()[-1] for line in answer.stdout.splitlines()]
    prefix = f"fmi{version[0]}"
    assert [s for s in symbols if not s.startswith(prefix)] == []
    headers = Path(cd.__file__).parent / "codegen/fmu/headers"
    declared = (headers / f"{prefix}Functions.h").read_text("utf-8")
    assert all(s in declared for s in symbols)
    assert len(symbols) == {"3.0": 75, "2.0": 44}[version]


def test_this_platform_has_a_name() -> None:
    this = platforms.here()
    assert this is not None
    assert platforms.PLATFORMS[this.name] is this


@pytest.mark.parametrize(
    ("unit_of_state", "expected"),
    [("", "1/s"), ("rad", "rad/s"), ("m/s", "m/s^2"), ("m/s^2", "m/s^3"), ("N*m", "N*m/s")],
)
def test_units_of_rates(unit_of_state: str, expected: str) -> None:
    assert per_second(unit_of_state) == expected
    rate, state = unit_of(expected).dimension, unit_of(unit_of_state or "1").dimension
    assert np.array_equal(np.subtract(rate, state), [0, 0, -1, 0, 0])
