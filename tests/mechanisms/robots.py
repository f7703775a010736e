"""The robots, arms and chains whose operations are counted and whose speed is measured.

Robots come as URDF with the PyPI package example-robot-data.
"""

from __future__ import annotations

import importlib.metadata
import json
import re
import tempfile
import warnings
from collections.abc import Callable
from dataclasses import dataclass
from functools import cache
from pathlib import Path

import cardan as cd

from .chain import chain

PACKAGE = "example-robot-data"
FINGERS = ("panda_finger_joint1", "panda_finger_joint2")
PUMA = Path(__file__).parents[1] / "references" / "puma560.json"


@cache
def folder() -> Path:
    """Where example-robot-data keeps its robots.

    Raises:
        FileNotFoundError: it is not installed, or without its URDFs.
    """
    try:
        files = importlib.metadata.files(PACKAGE) or []
    except importlib.metadata.PackageNotFoundError:
        files = []
    for entry in files:
        parts = entry.parts
        if entry.suffix == ".urdf" and "robots" in parts:
            depth = len(parts) - parts.index("robots") - 1
            return Path(str(entry.locate())).resolve().parents[depth - 1]
    raise FileNotFoundError(f"the robots of {PACKAGE} are not here: pip install {PACKAGE}")


@dataclass(frozen=True)
class Standard:
    """A mechanism that figures are stated for.

    Attributes:
        title: As tables call it.
        build: Makes the scene.
        needs: The PyPI package its file comes with.
    """

    title: str
    build: Callable[[], cd.Scene]
    needs: str = ""


def _urdf(title: str, file: str, base: str = "fixed") -> Standard:
    return Standard(title, lambda: cd.load(folder() / file, base=base), PACKAGE)


def panda() -> cd.Scene:
    """The Panda arm with both finger joints made fixed: seven joints are left."""
    path = folder() / "panda_description/urdf/panda.urdf"
    text = path.read_text(encoding="utf-8")
    for joint in FINGERS:
        text = re.sub(rf'(<joint name="{joint}" type=)"\w+"', r'\1"fixed"', text)
    text = re.sub(r"<mimic [^>]*/>", "", text)
    with tempfile.TemporaryDirectory() as place:
        copy = Path(place) / path.name
        copy.write_text(text, encoding="utf-8")
        return cd.load(copy)


def puma() -> cd.Scene:
    """PUMA 560 without motors, from its table of parameters."""
    keys = ("a", "alpha", "d", "mass", "com", "inertia")
    rows = json.loads(PUMA.read_text("utf-8"))["rows"]
    with warnings.catch_warnings():
        # the published inertias of links 1 and 3 are those of no rigid body
        warnings.filterwarnings("ignore", message=".*triangle inequality")
        return cd.from_dh([{key: row[key] for key in keys} for row in rows], name="puma560")


STANDARD: dict[str, Standard] = {
    "panda": Standard("Panda, fingers fixed", panda, PACKAGE),
    "ur5": _urdf("UR5", "ur_description/urdf/ur5_robot.urdf"),
    "puma560": Standard("PUMA 560", puma),
    "chain7": Standard("7R chain", lambda: chain(7)),
    "anymal": _urdf("ANYmal", "anymal_b_simple_description/robots/anymal.urdf", "free"),
    "talos": _urdf("Talos", "talos_data/robots/talos_reduced.urdf", "free"),
    "icub": _urdf("iCub", "icub_description/robots/icub_reduced.urdf", "free"),
    "g1": _urdf("G1", "g1_description/urdf/g1_29dof_rev_1_0.urdf", "free"),
    "chain14": Standard("chain of 14", lambda: chain(14)),
    "chain30": Standard("chain of 30", lambda: chain(30)),
    "chain100": Standard("chain of 100", lambda: chain(100)),
    "pendulum10": Standard("planar pendulum of 10", lambda: chain(10, "y")),
    "pendulum100": Standard("planar pendulum of 100", lambda: chain(100, "y")),
}
