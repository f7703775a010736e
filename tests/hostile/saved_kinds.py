"""Good motions, ensembles and checkpoints of ensembles, and how they are used."""

from __future__ import annotations

import hashlib
import io
import json
import os
import shutil
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from cardan.analyses.ensembles import file_schema
from cardan.analyses.simulation.files.append_log import DIGEST, LENGTH
from cardan.runtime import formats
from cardan.runtime.formats.contents import Contents, Variable
from cardan.runtime.trajectory import storage
from cardan.version import ENSEMBLE, RUN, Format
from hostile.harness import Kind
from hostile.kinds import double

Scene = Callable[[], cd.CompiledModel]


def ball() -> cd.CompiledModel:
    """A ball on a pendulum, over a stop, with a shape."""
    scene = cd.Scene("ball", gravity=(0, 0, -9.81))
    rod = scene.body("rod", mass=1.0, com=(0, 0, -0.5), inertia=(0.1, 0.1, 0.01))
    ball = cd.shape.sphere(0.1)
    inertia = (0.02, 0.02, 0.01)
    bob = scene.body("bob", mass=0.5, com=(0, 0, -0.2), inertia=inertia, shape=ball)
    scene.joint("pivot", cd.Revolute("y"), scene.ground, rod)
    scene.joint("socket", cd.Spherical(), rod.at(0, 0, -1.0), bob)
    scene.force("stop", cd.Stop("pivot", lower=-0.3, restitution=0.5))
    return cd.compile(scene)


def blade() -> cd.CompiledModel:
    """A beam on a hinge, in absolute coordinates."""
    scene = cd.Scene("blade", gravity=(0, 0, -9.81))
    hub = scene.body("hub", mass=2.0, inertia=(0.1, 0.1, 0.15))
    scene.joint("hinge", cd.Revolute("y"), scene.ground, hub)
    section = cd.section.rectangle(0.02, 0.02)
    metal = cd.material(E=7e10, nu=0.3, rho=2700)
    scene.beam("beam", hub.at(0.1, 0, 0), (0.6, 0, 0), section, metal, elements=2)
    return cd.compile(scene)


BALL = {"t": 0.6, "q": {"pivot": 0.4}, "u": {"pivot": -3.0, "socket": [0.1, 0, 2]}}
MOTIONS: dict[str, tuple[Scene, dict[str, Any]]] = {
    "ball": (ball, BALL),
    "archived ball": (ball, BALL),
    "pushed": (double, {"t": 0.3, "inputs": {"torque": ([0.0, 0.1, 0.3], [0.0, 0.2, -0.1])}}),
    "blade": (blade, {"t": np.linspace(0, 0.01, 6)}),
    "dense blade": (blade, {"t": 0.002}),
}


def motion(name: str, folder: Path) -> Kind:
    """A saved motion, used without its model."""
    made, options = MOTIONS[name]
    folder.mkdir(parents=True)
    ending = ".npz" if name.startswith("archived") else ".nc"
    good = made().simulate(**options).save(folder / f"run{ending}")

    def use(again: cd.Trajectory) -> bytes:
        found = hashlib.sha256((repr(again) + again._repr_html_()).encode())
        frames = again.manifest["frames"]
        names = [row["name"] for row in frames]
        # those of rigid trees beside nodes are known at the saved times only
        anywhere = [row["name"] for row in frames if row.get("tree") is None]
        for frame in names[:8]:
            found.update(again.pose(frame).tobytes())
        if again.dense is not None:
            middle = again.resample(np.linspace(again.t[0], again.t[-1], 5))
            found.update(middle.x.tobytes() + middle.pose(anywhere[-1]).tobytes())
        forces = again.multipliers if "multipliers" in again.stored else None
        told = (again.events, again.ticks, again.constraints, forces, again.ledger)
        found.update(repr(told).encode() + repr(again.manifest).encode())
        for part in (again.r, again.s, again.work_done, again.energy.total, again.energy_residual):
            found.update(np.asarray(part).tobytes())
        here = folder / f"again{os.getpid()}"
        found.update(again.animate(here.with_suffix(".html"), fps=100.0).path.read_bytes())
        again.save(here.with_suffix(ending))
        for suffix in (".html", ending):
            here.with_suffix(suffix).unlink()
        return found.digest()

    pack, unpack = _packing(RUN, ("title", *storage.NOTES), ending)
    return Kind(f"motion {name}", good, cd.load_motion, use, unpack, pack, lambda place: True)


def _packing(
    form: Format, notes: tuple[str, ...], ending: str = ".nc"
) -> tuple[Callable[[dict[str, Any]], bytes], Callable[[bytes], dict[str, Any]]]:
    """From parts to the content of a file whose hash is right, and back."""

    def path() -> Path:
        return Path("/dev/shm" if os.path.isdir("/dev/shm") else "/tmp") / f"{os.getpid()}{ending}"

    def pack(parts: dict[str, Any]) -> bytes:
        dimensions: dict[str, int] = {}
        variables = {}
        try:
            for name, one in parts["variables"].items():
                values = np.asarray(one["values"])
                values = values.real if values.dtype.kind == "c" else values
                values = values if values.dtype.kind == "S" else values.astype(np.float64)
                axes = [
                    axis if dimensions.setdefault(axis, size) == size else f"{axis}_{size}"
                    for axis, size in zip(one["axes"], values.shape, strict=False)
                ]
                axes += [f"{name}_{k}" for k in range(len(axes), values.ndim)]
                variables[name] = Variable(tuple(axes), values, one["attributes"])
            told = {k: json.dumps(v) for k, v in parts["notes"].items()}
            formats.save(path(), form, Contents(variables, told), "")
            return path().read_bytes()
        except Exception as error:
            raise ValueError("no such file can be written") from error
        finally:
            path().unlink(missing_ok=True)

    def unpack(content: bytes) -> dict[str, Any]:
        path().write_bytes(content)
        try:
            held = formats.load(path(), form, notes)
        finally:
            path().unlink()
        variables = {
            name: {"axes": [*v.dimensions], "values": v.values, "attributes": {**v.attributes}}
            for name, v in held.variables.items()
        }
        told = {k: json.loads(v) for k, v in held.notes.items() if k != "title"}
        return {"variables": variables, "notes": told}

    return pack, unpack


# ensembles

KEEP = {
    "states": "states",
    "largest": "max of elbow",
    "mean": "mean of elbow",
    "bins": "histogram of elbow from -1 to 1 in 5",
}
VARIED = {
    "t": np.linspace(0, 0.5, 6),
    "q": {"elbow": np.linspace(-1, 1, 24)},
    "threads": 1,
    "lanes": 1,
}


def _results(made: cd.Ensemble) -> bytes:
    found = hashlib.sha256(made.final.tobytes() + repr(made.status.tolist()).encode())
    for name, value in made.results.items():
        found.update(name.encode() + (repr(value) + repr(np.shape(value))).encode())
        if isinstance(value, np.ndarray):
            found.update(value.tobytes())
    for table in (made.statistics, made.varied):
        for name, values in table.items():
            found.update(name.encode() + values.tobytes())
    found.update(repr((made.messages, made.request.entries, made.success)).encode())
    return found.digest()


def ensemble(folder: Path) -> Kind:
    """A saved ensemble."""
    folder.mkdir(parents=True)
    good = double().ensemble(**VARIED, reduce=KEEP).save(folder / "runs.nc")

    def use(again: cd.Ensemble) -> bytes:
        here = folder / f"again{os.getpid()}.nc"
        again.save(here)
        here.unlink()
        parts = (again.q, again.u, again.t, again[again.request.entries[0]])
        return repr(again).encode() + _results(again) + b"".join(x.tobytes() for x in parts)

    notes = ("title", *file_schema.NOTES)
    pack, unpack = _packing(ENSEMBLE, notes)
    return Kind("ensemble", good, cd.load_ensemble, use, unpack, pack, lambda place: True)


def checkpoint(folder: Path) -> Kind:
    """The checkpoint of an ensemble, cut off half way."""
    model = double()
    folder.mkdir(parents=True)
    good = folder / "runs.part"

    def read(path: Path) -> cd.Ensemble:
        if path == good:
            # it goes on in the file
            path = Path(shutil.copy(path, folder / "runs.copy"))
        return model.ensemble(**VARIED, reduce=KEEP, checkpoint=path)

    model.ensemble(**VARIED, reduce=KEEP, checkpoint=good)
    whole = _records(good.read_bytes())
    assert len(whole["records"]) > 2
    good.write_bytes(_together({**whole, "records": whole["records"][:2]}))
    return Kind("checkpoint", good, read, _results, _records, _together, lambda place: True)


def part(folder: Path) -> Kind:
    """One of two parts of an ensemble, joined with the other."""
    model = double()
    folder.mkdir(parents=True)
    for k in (1, 2):
        model.ensemble(**VARIED, reduce=KEEP, part=(k, 2), checkpoint=folder / f"runs-{k}.part")

    def read(path: Path) -> cd.Ensemble:
        return cd.Ensemble.join([path, path.parent / "runs-1.part"])

    good = folder / "runs-2.part"
    return Kind("part", good, read, _results, _records, _together, lambda place: True)


def _records(data: bytes) -> dict[str, Any]:
    magic, _, rest = data.partition(b"\n")
    found = []
    while rest:
        (length,) = LENGTH.unpack(rest[: LENGTH.size])
        start = LENGTH.size + DIGEST
        found.append(rest[start : start + length])
        rest = rest[start + length :]
    blocks = [*map(_block, found[1:])]
    return {"magic": magic.decode(), "whose": json.loads(found[0]), "records": blocks}


# arrays of letters
TEXTS = ("messages", "names", "warnings", "request", "checks")


def _block(content: bytes) -> dict[str, Any]:
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        parts: dict[str, Any] = {name: file[name] for name in file.files}
    return parts | {k: json.loads(parts[k].tobytes()) for k in TEXTS if k in parts}


def _together(parts: Mapping[str, Any]) -> bytes:
    data = parts["magic"].encode() + b"\n"
    blocks = []
    for one in parts["records"]:
        room = io.BytesIO()
        texts = {
            name: np.frombuffer(json.dumps(one[name]).encode(), dtype=np.uint8)
            for name in TEXTS
            if name in one
        }
        np.savez(room, **{**one, **texts})
        blocks.append(room.getvalue())
    for block in (json.dumps(parts["whose"]).encode(), *blocks):
        data += LENGTH.pack(len(block)) + hashlib.sha256(block).digest() + block
    return data
