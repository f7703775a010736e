"""Writes the files that later versions of cardan must read, or refuse in words.

usage: python tests/compatibility/write.py

A file that is there stays as it is: it says what the cardan of its day wrote. Raise a version in
``cardan.version`` and run this again: what the new version writes is put beside the others. Names
are those of a format and its version; ``run_1.nc`` and ``ensemble_0.nc`` are older than this
script: files had no hash then, ensembles no version.
"""

from __future__ import annotations

import json
import lzma
import os
import pickle
import subprocess
import sys
import tarfile
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

# the mechanisms stand in the folder above
sys.path.insert(0, str(Path(__file__).parents[1]))

import cardan as cd
from cardan import version
from cardan.elements.forces import FORCES
from cardan.elements.joints import JOINTS
from cardan.scene.files.yaml import keys
from mechanisms import ZOO
from mechanisms.closed import CLOSED

FILES = Path(__file__).parent / "files"
SCENES = FILES / f"scene_{version.SCENE.version}"
# scenes that the program writes; the others in the folder are written by hand
# what a run is made of; the rest follows from it by a model
STORED = ("t", "x", "r", "s", "work_done")
SAVED = ("backwards", "backwards_guided", "parabola", "gear", "damped", "driven", "orbiter",
         "gyrostat", "roller_coaster", "screw", "gripper", "four_bar")  # fmt: skip
# parts of other scenes
PARTS = ("bucket",)
VARIED = {"t": np.linspace(0, 0.2, 5), "q": {"shoulder": np.linspace(0, 1, 6)}}
KEEP = {
    "states": "states",
    "largest": "max of elbow",
    "bins": "histogram of elbow from -1 to 1 in 4",
}
START: dict[str, Any] = {"q": {"shoulder": 1.0}, "u": {"elbow": 4.0}}
TORQUE = ([0.0, 0.1, 0.4], [0.0, 2.0, -1.0])


def scene(name: str = "pendulum") -> cd.Scene:
    return cd.load(FILES / "scene_1" / f"{name}.yaml")


def model(name: str = "pendulum") -> cd.CompiledModel:
    return cd.compile(scene(name))


def start(scene: cd.Scene, model: cd.CompiledModel) -> np.ndarray:
    """The state a scene starts in."""
    return model.initial(**{name: scene.settings.get(name) for name in "quz"})


def described(scene: cd.Scene) -> dict[str, Any]:
    """Names and numbers of a scene that no reader may change."""
    members = ("bodies", "joints", "beams", "forces", "inputs", "outputs", "constraints")
    return {
        **{name: list(getattr(scene, name)) for name in members},
        "parameters": {name: float(one.value) for name, one in scene.parameters.items()},
        "settings": json.loads(json.dumps(scene.settings, default=np.ndarray.tolist)),
    }


def rates(scene: cd.Scene) -> dict[str, list[float]]:
    """What a scene says about motion: xdot at its start, or of beams the energy."""
    made = cd.compile(scene)
    x = start(scene, made)
    if scene.beams:
        q, u = made.split(x)[:2]
        return {"x": x.tolist(), "energy": list(map(float, made.energy(q, u)))}
    return {"x": x.tolist(), "xdot": made.rhs(0.0, x).tolist()}


def of_motion(motion: cd.Trajectory) -> dict[str, np.ndarray]:
    """The numbers of a run that reading must give again."""
    frame = motion.manifest["bodies"][-1]["parts"][0]
    found = {name: getattr(motion, name) for name in STORED}
    found |= {"pose": motion.pose(frame), "energy": motion.energy.total}
    found |= {f"constraint {name}": x for name, x in motion.constraints.items()}
    if motion.dense is not None:
        found["between"] = motion.at(np.linspace(motion.t[0], motion.t[-1], 7))
    return found


def of_ensemble(runs: cd.Ensemble) -> dict[str, np.ndarray]:
    bins = runs["bins"]
    return {
        "final": runs.final,
        "states": runs["states"],
        "largest": runs["largest"],
        "counts": bins.counts,
        "edges": bins.edges,
    }


def of_model(made: cd.CompiledModel) -> dict[str, np.ndarray]:
    """Results of a model at one state."""
    q, u = np.array([0.3, -0.2]), np.array([0.5, 1.5])
    return {
        "rhs": made.rhs(0.0, np.concatenate([q, u])),
        "forward_dynamics": made.forward_dynamics(q, u),
        "mass_matrix": made.mass_matrix(q),
        "energy": np.array(made.energy(q, u)),
    }


def numbers(path: Path, values: dict[str, Any]) -> None:
    np.savez_compressed(path, **values)


def once(name: str, write: Callable[[Path], Any]) -> None:
    """Write a file unless it is there."""
    path = FILES / name
    if path.exists():
        print(f"{name}: stays")
        return
    path.parent.mkdir(parents=True, exist_ok=True)
    write(path)
    print(f"{name}: {path.stat().st_size} bytes")


def packed(folder: Path, path: Path) -> None:
    """A folder as an archive that says nothing about who made it."""

    def plain(info: tarfile.TarInfo) -> tarfile.TarInfo | None:
        info.uid = info.gid = info.mtime = 0
        info.uname = info.gname = ""
        return None if info.name.startswith(("./zig", "./.")) and info.name != "." else info

    with tarfile.open(path, "w:xz") as file:
        file.add(folder, ".", filter=plain)


def scenes() -> None:
    """Scenes of every section, joint and force, and what they say about motion."""
    for name in SAVED:
        once(f"{SCENES.name}/{name}.yaml", {**ZOO, **CLOSED}[name].build().save)
    texts = {path: path.read_text("utf-8") for path in SCENES.glob("*.yaml")}
    sections = {line.split(":")[0] for text in texts.values() for line in text.splitlines()}
    elements = {
        kind for kind in (*JOINTS, *FORCES) if any(f"type: {kind}" in t for t in texts.values())
    }
    missing = ({key.name for key in keys.TOP} - sections) | ({*JOINTS, *FORCES} - elements)
    assert not missing, f"no scene has {missing}"
    made = {path.stem: cd.load(path) for path in sorted(texts) if path.stem not in PARTS}
    told = {name: {**described(one), **rates(one)} for name, one in made.items()}
    once(f"{SCENES.name}.json", lambda path: path.write_text(json.dumps(told, indent=1) + "\n"))


def runs() -> None:
    options: dict[str, dict[str, Any]] = {
        "pendulum": {"t": 0.4, "u": {"elbow": 4.0}, "inputs": {"torque": TORQUE}},
        "four_bar": {"t": 0.2, "rtol": 1e-5},
        "mast": {"t": np.linspace(0, 1e-3, 3)},
    }
    for name, how in options.items():
        stem = f"run_{version.RUN.version}_{name}"
        once(f"{stem}.nc", lambda path, n=name, how=how: model(n).simulate(**how).save(path))
        # without its model, which closes circuits between the times too
        motion = cd.load_motion(FILES / f"{stem}.nc")
        once(f"{stem}.npz", lambda path, motion=motion: numbers(path, of_motion(motion)))


def ensembles() -> None:
    runs = model().ensemble(**VARIED, reduce=KEEP, threads=1)
    stem = f"ensemble_{version.ENSEMBLE.version}"
    once(f"{stem}.nc", runs.save)
    once(f"{stem}.npz", lambda path: numbers(path, of_ensemble(runs)))


def checkpoints() -> None:
    """A stepper, a run and an ensemble that go on."""
    stepper = model().stepper(**START, rtol=1e-8)
    for _ in range(3):
        stepper.step(0.05, inputs={"torque": 0.5})
    once(f"stepper_{version.STEPPER.version}.npz", stepper.save)
    stepper.step(0.1)
    ahead = stepper.state
    whole = model().simulate(0.2, **START)
    runs = model().ensemble(**VARIED, reduce=KEEP, threads=1)
    once(
        "checkpoints.npz",
        lambda path: numbers(path, {"ahead": ahead, "run": whole.x, "ensemble": runs.final}),
    )
    once(
        f"run_file_{version.RUN_FILE.version}.part",
        lambda path: model().simulate(0.2, **START, checkpoint=path, every=0),
    )
    once(
        f"ensemble_file_{version.ENSEMBLE_FILE.version}.part",
        lambda path: model().ensemble(**VARIED, reduce=KEEP, threads=1, checkpoint=path),
    )


def models() -> None:
    """Pickles, an export and a folder of a model."""
    made = model()
    told = of_model(made)
    motion = made.simulate(0.1, **START)
    once("model.npz", lambda path: numbers(path, told))
    for name, value in (("model", made), ("motion", motion)):
        content = lzma.compress(pickle.dumps(value, protocol=4))
        once(
            f"pickle_{version.PICKLE.version}_{name}.xz",
            lambda path, c=content: path.write_bytes(c),
        )
    once("motion.npz", lambda path: numbers(path, of_motion(motion)))
    with TemporaryDirectory() as folder:
        own, exported = Path(folder) / "own", Path(folder) / "exported"
        of_model(cd.compile(scene(), directory=own))
        once(f"model_{version.MANIFEST.version}.tar.xz", lambda path: packed(own, path))
        cd.derive(scene()).export(exported, language="c", integrators=["rk4"])
        once(f"export_{version.MANIFEST.version}.tar.xz", lambda path: packed(exported, path))


def cache() -> None:
    """The compile cache of a process that computed the results of a model."""
    program = "import sys; sys.path[:0] = sys.argv[1:]; import write; write.of_model(write.model())"
    with TemporaryDirectory() as folder:
        environment = {**os.environ, "CARDAN_CACHE": folder}
        command = [sys.executable, "-c", program, str(Path(__file__).parent)]
        subprocess.run(command, env=environment, check=True)
        once("cache.tar.xz", lambda path: packed(Path(folder), path))


if __name__ == "__main__":
    for write in (scenes, runs, ensembles, checkpoints, models, cache):
        write()
