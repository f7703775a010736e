"""Superelements in flight, and in a slider-crank.

The laws iterate the list of those in flight: every kind of frame and of inertia, stiffening and
damping. Matrices are those of the brick of the references, made soft, or of a
few beams, whose mass depends on directions.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cache
from typing import Any

import cardan as cd
from superelements.components import brick_matrices, faces, planar_beam, reference


@cache
def soft_brick(modes: int = 2) -> Any:
    """The brick with its stiffness times 1e-4: frequencies of some rad/s and up."""
    M, K, nodes = brick_matrices()
    return cd.superelement.reduce(M, 1e-4 * K, nodes, faces(), modes=modes)


@cache
def beams(**options: Any) -> Any:
    """Four beams of 1 m in all."""
    scene = cd.Scene("beams", gravity=(0, 0, 0))
    section = cd.section.general(EA=1e5, GA=1e5, GJ=40.0, EI=40.0, rhoA=1.0, rhoI=1e-2)
    scene.beam("beam", scene.ground, (1.0, 0, 0), section, elements=4)
    return cd.superelement.from_beams(scene, "beam", modes=2, **options)


@dataclass(frozen=True)
class Flyer:
    """A superelement that nothing holds.

    Attributes:
        name: In test output.
        record: Makes its matrices.
        options: Of ``scene.superelement``.
        galilean: Whether forces do not depend on a common velocity.
        load: Whether a body hangs at its last interface.
    """

    name: str
    record: Callable[[], Any] = field(repr=False)
    options: Mapping[str, Any]
    galilean: bool = True
    load: bool = False

    def build(self, gravity: Any = (0.0, 0.0, 0.0)) -> cd.Scene:
        """The scene; joint ``"free"`` leads to the first interface."""
        record = self.record()
        first, last = record.interfaces[0].name, record.interfaces[-1].name
        scene = cd.Scene("flying", gravity=gravity)
        boom = scene.superelement("boom", record, **self.options)
        scene.joint("free", cd.Free(), scene.ground, boom.at(first))
        if self.load:
            load = scene.body("load", mass=0.3, com=(0.05, 0, 0.02), inertia=(0.01, 0.02, 0.02))
            scene.joint("hinge", cd.Revolute("y"), boom.at(last), load)
        return scene


FRAMES = ("root", "tip", "mean", "chord")
FLYERS: dict[str, Flyer] = {
    flyer.name: flyer
    for flyer in (
        *(Flyer(frame, soft_brick, {"frame": frame}) for frame in FRAMES),
        Flyer("projected", beams, {"frame": "end", "inertia": "projected"}, galilean=False),
        Flyer("corotated", beams, {"frame": "end", "inertia": "corotated"}, galilean=False),
        Flyer(
            "stiffened",
            lambda: beams(stiffening="start", damping=0.02),
            {"frame": "start", "stiffening": True},
            load=True,
        ),
        Flyer("damped chord", lambda: beams(damping=0.02), {"frame": "chord"}, load=True),
    )
}


def slider_crank() -> cd.Scene:
    """A crank at constant speed and a flexible rod, of the references."""
    data = reference("slider_crank_superelement_A")["parameters"]
    M, K, nodes = planar_beam(*(data[k] for k in ("rod", "elements", "EA", "EI", "rhoA")))
    ends, modes = {"pin": 0, "slider": data["elements"]}, data["cb_modes"]
    record = cd.superelement.reduce(M, K, nodes, ends, node_dofs="x y rz", modes=modes)
    scene = cd.Scene("slider_crank", gravity=(0, 0, 0))
    crank, slider = scene.body("crank"), scene.body("slider", data["slider_mass"])
    turning = data["Omega"] * cd.t
    scene.joint("crank", cd.Revolute("z"), scene.ground, crank, prescribed=turning)
    rod = scene.superelement("rod", record, frame="chord", inertia="projected")
    scene.joint("pin", cd.Revolute("z"), crank.at(data["crank"]), rod.at("pin"))
    scene.joint("slide", cd.Prismatic("x"), scene.ground, slider)
    scene.joint("wrist", cd.Revolute("z"), rod.at("slider"), slider)
    return scene
