"""Good files of every kind that cardan reads, and how they are used."""

from __future__ import annotations

import hashlib
import io
import json
import os
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import numpy as np

import cardan as cd
from cardan.analyses.simulation.files.append_log import DIGEST, LENGTH
from cardan.analyses.simulation.files.checkpoint import digest
from cardan.number_file import packed, unpacked
from cardan.schema.seal import sealed
from hostile.harness import Kind
from mechanisms.closed_planar import four_bar


def double() -> cd.CompiledModel:
    """A double pendulum with a torque at the shoulder."""
    scene = cd.Scene("double", gravity=(0, 0, -9.81))
    rod = cd.inertia.rod(1.0, 0.5, axis="z")
    upper = scene.body("upper", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    lower = scene.body("lower", mass=1.0, com=(0, 0, -0.25), inertia=rod)
    scene.joint("shoulder", cd.Revolute("y"), scene.ground, upper, q0=0.1)
    scene.joint("elbow", cd.Revolute("y"), upper.at(0, 0, -0.5), lower)
    scene.force("motor", cd.JointForce("shoulder", scene.input("torque")))
    return cd.compile(scene)


def servo() -> cd.CompiledModel:
    """A mass on a rail between stops under a sampled controller."""
    scene = cd.Scene("servo")
    scene.joint("x", cd.Prismatic("x"), scene.ground, scene.body("block", mass=1.0))
    x, v = scene.q("x"), scene.u("x")
    pid = cd.Controller.pid("x", x, v, target=1.0, kp=8.0, ki=1.0, kd=5.0, sample=0.05)
    scene.force("pid", pid)
    return cd.compile(scene)


def linkage() -> cd.CompiledModel:
    """A four-bar linkage."""
    return cd.compile(four_bar())


def shaft(inertia: str = "linked") -> cd.CompiledModel:
    """A beam that holds a body: finite elements, in absolute coordinates."""
    scene = cd.Scene("shaft", gravity=(0, 0, -9.81))
    end = scene.body("end", mass=1, inertia=(1, 1, 1), pose=(1, 0, 0))
    section = cd.section.general(EA=1e4, GA=1e4, GJ=80, EI=100, rhoA=1.0, rhoI=0.01)
    scene.beam("b", scene.ground, end, section, elements=2, inertia=inertia)
    return cd.compile(scene)


def arrays(content: bytes) -> dict[str, Any]:
    """The arrays of an npz file; ``head`` as what its JSON holds."""
    with np.load(io.BytesIO(content), allow_pickle=False) as file:
        parts = {name: file[name] for name in file.files}
    parts["head"] = json.loads(parts["head"].tobytes())
    return parts


def content(parts: dict[str, Any]) -> bytes:
    """The inverse of :func:`arrays`."""
    room = io.BytesIO()
    head = np.frombuffer(json.dumps(parts["head"]).encode("ascii"), dtype=np.uint8)
    np.savez(room, **{**parts, "head": head})
    return room.getvalue()


# checkpoints of steppers

STEPPERS: dict[str, tuple[Callable[[], cd.CompiledModel], dict[str, Any]]] = {
    "DOP853": (double, {"rtol": 1e-9}),
    "RK4": (double, {"method": "RK4", "step": 0.01}),
    "watched": (double, {"events": {"up": (("elbow", 0.39), "mark")}}),
    "Radau": (linkage, {"method": "Radau", "q": {"A": 1.0}}),
    "alpha": (linkage, {"method": "GeneralizedAlpha", "q": {"A": 1.0}}),
    "linkage": (linkage, {"q": {"A": 1.0}}),
    "midpoint": (double, {"method": "EnergyMidpoint", "step": 0.01}),
    "ticks": (servo, {}),
    "beam": (shaft, {"method": "GeneralizedAlpha"}),
    "Radau beam": (shaft, {"method": "Radau"}),
    "conserving beam": (lambda: shaft("lumped"), {"method": "EnergyMomentum", "step": 0.01}),
}


def stepper(name: str, folder: Path) -> Kind:
    """The checkpoint of a stepper."""
    made, options = STEPPERS[name]
    model = made()
    watched = {"events": options["events"]} if "events" in options else {}
    going = model.stepper(**options)
    going.step(0.11)
    folder.mkdir(parents=True)
    going.save(folder / "stepper.npz")

    def use(again: Any) -> bytes:
        again.step(0.05)
        told = repr((again.t, again.work, again.inputs, again.modes, again.events))
        return bytes(again.state.tobytes() + told.encode())

    def pack(parts: dict[str, Any]) -> bytes:
        head = json.dumps(parts["head"]).encode("ascii")
        own = np.frombuffer(digest(head, parts["memory"].tobytes()), dtype=np.uint8)
        return content({**parts, "digest": own})

    return Kind(
        f"stepper {name}",
        folder / "stepper.npz",
        lambda path: model.resume(path, **watched),
        use,
        lambda data: {k: v for k, v in arrays(data).items() if k != "digest"},
        pack,
        lambda place: True,
    )


# files of runs

PUSH = {"torque": ([0.0, 0.3, 0.3, 60.0], [0.0, 0.2, -0.1, 0.1])}
RUNS: dict[str, tuple[Callable[[], cd.CompiledModel], dict[str, Any]]] = {
    "dense": (double, {"t": 2.0, "inputs": PUSH}),
    "times": (double, {"t": np.linspace(0, 2, 50), "q": {"elbow": 0.7}}),
    "events": (double, {"t": 2.0, "q": {"elbow": 0.7}, "events": {"up": (("elbow", 0.0), "mark")}}),
    "linkage": (linkage, {"t": 1.0, "q": {"A": 1.0}}),
    "Radau": (linkage, {"t": 1.0, "q": {"A": 1.0}, "method": "Radau"}),
    "alpha": (linkage, {"t": 0.3, "q": {"A": 1.0}, "method": "GeneralizedAlpha", "rtol": 1e-4}),
    "ticks": (servo, {"t": 2.0}),
    "RK4": (double, {"t": 2.0, "method": "RK4", "step": 0.01, "inputs": PUSH}),
    "beam": (shaft, {"t": 0.3, "method": "GeneralizedAlpha"}),
    "Radau beam": (shaft, {"t": 0.1, "method": "Radau"}),
    "conserving beam": (
        lambda: shaft("lumped"),
        {"t": 0.5, "method": "EnergyMomentum", "step": 0.01},
    ),
}


def run(name: str, folder: Path) -> Kind:
    """The file of a run, cut off half way."""
    made, options = RUNS[name]
    model = made()
    folder.mkdir(parents=True)
    good = folder / "run.part"

    def read(path: Path) -> Any:
        if path == good:
            # it goes on in the file
            path = shutil.copy(path, folder / "run.copy")
        return model.simulate(**options, checkpoint=path, every=0.0)

    def use(motion: Any) -> bytes:
        numbers = (motion.t, motion.x, motion.r, motion.s, motion.work_done, motion.event_log.log)
        return b"".join(array.tobytes() for array in numbers) + motion.status.encode()

    model.simulate(**options, checkpoint=good, every=0.0)
    whole = records(good.read_bytes())
    half = max(1, len(whole["records"]) // 2)
    good.write_bytes(together({**whole, "records": whole["records"][:half]}))
    return Kind(f"run {name}", good, read, use, records, together, lambda place: True)


def records(data: bytes) -> dict[str, Any]:
    """The first line, whose it is, and the records of a file that grows."""
    magic, _, rest = data.partition(b"\n")
    found = []
    while rest:
        (length,) = LENGTH.unpack(rest[: LENGTH.size])
        start = LENGTH.size + DIGEST
        found.append(rest[start : start + length])
        rest = rest[start + length :]
    whose = json.loads(found[0])
    return {"magic": magic.decode(), "whose": whose, "records": [*map(arrays, found[1:])]}


def together(parts: dict[str, Any]) -> bytes:
    """The inverse of :func:`records`."""
    data = parts["magic"].encode() + b"\n"
    for one in (json.dumps(parts["whose"]).encode(), *map(content, parts["records"])):
        data += LENGTH.pack(len(one)) + hashlib.sha256(one).digest() + one
    return data


# folders of models


MODELS: dict[str, tuple[Callable[[], cd.CompiledModel], dict[str, Any]]] = {
    "double": (double, {"q": {"elbow": 0.7}}),
    "linkage": (linkage, {"q": {"A": 1.0}}),
    "servo": (servo, {}),
    "shaft": (shaft, {"method": "GeneralizedAlpha", "step": 0.01}),
}
FILES: dict[str, tuple[Callable[[bytes], Any], Callable[[Any], bytes]]] = {
    "manifest.json": (
        lambda data: {k: v for k, v in json.loads(data).items() if k != "digest"},
        lambda parts: sealed(parts, ensure_ascii=False).encode(),
    ),
    "functions.json": (json.loads, lambda parts: json.dumps(parts).encode()),
    "mesh.npz": (unpacked, packed),
}


def folder(name: str, place: Path) -> Kind:
    """A file of a model's folder: ``manifest.json of double``."""
    file, _, which = name.partition(" of ")
    made, options = MODELS[which]
    model = made()
    model.simulate(0.02, **options)
    shutil.copytree(model.directory, place)
    unpack, pack = FILES[file]

    def read(path: Path) -> Any:
        found = cd.load_model(path.parent)
        if file == "functions.json":
            found._objects.saved()
        return found

    def use(found: Any) -> bytes:
        motion = found.simulate(0.02, **options)
        return bytes(motion.t.tobytes() + motion.x.tobytes() + motion.status.encode())

    def whole(parts: Any) -> bytes:
        """The content, and the manifest beside it with its hash."""
        return pack(parts)

    return Kind(name, place / file, read, use, unpack, whole, lambda place: True)


# entries of the compile cache

ENTRIES = ("manifest.json", "functions.json", "rhs.c", "cardan.h", "object")


def entry(name: str, place: Path) -> Kind:
    """One of ``ENTRIES`` of a cache that holds nothing but the double pendulum.

    Whoever can write there runs code as its user; damage must be found: what is read is written or
    compiled anew.
    """
    place.mkdir(parents=True)
    cache = place / "cache"
    cache.mkdir(mode=0o700)
    # kernels are not entry of a model: those of this session serve
    _ran(double())
    with _cached(cache):
        model = double()
        good = _ran(model)
    objects = [path for path in cache.iterdir() if path.is_file()]
    whole = model.directory
    if name == "object":
        symbol = model._objects._loaded["rhs"].built
        assert symbol is not None
        whole, file = place / "objects", Path(symbol.path).name
        whole.mkdir()
        for path in objects:
            shutil.copy2(path, whole)
        objects = []
    else:
        file = name
    root, key = place / "used", model.directory.relative_to(cache)

    def read(path: Path) -> Any:
        shutil.rmtree(root / str(os.getpid()), ignore_errors=True)
        mine = root / str(os.getpid())
        mine.mkdir(parents=True, mode=0o700)
        for one in objects:
            shutil.copy2(one, mine)
        # what a worker got is its own, the good one stays
        put = shutil.copytree if path.parent == whole else shutil.move
        if name == "object":
            mine.rmdir()
            put(str(path.parent), str(mine))
            shutil.copytree(model.directory, mine / key)
        else:
            (mine / key).parent.mkdir(parents=True)
            put(str(path.parent), str(mine / key))
        mine.chmod(0o700)
        with _cached(mine):
            return double()

    def use(found: Any) -> bytes:
        with _cached(root / str(os.getpid())):
            return _ran(found)

    parts = FILES.get(name, (None, None)) if name == "manifest.json" else (None, None)
    assert use(read(whole / file)) == good
    return Kind(f"{name} of a cache", whole / file, read, use, *parts, state=lambda place: True)


def _ran(model: Any) -> bytes:
    motion = model.simulate(0.02, q={"elbow": 0.7})
    return bytes(motion.t.tobytes() + motion.x.tobytes() + motion.status.encode())


@contextmanager
def _cached(cache: Path) -> Iterator[None]:
    """Models are built in this cache."""
    before = os.environ.get("CARDAN_CACHE")
    os.environ["CARDAN_CACHE"] = str(cache)
    try:
        yield
    finally:
        os.environ.pop("CARDAN_CACHE")
        if before is not None:
            os.environ["CARDAN_CACHE"] = before
