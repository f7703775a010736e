"""Frames that go along orbits: local vertical, local horizontal.

Their x axis points forward along a circular orbit, y against its normal and z down to the center:
turns about x, y and z are roll, pitch and yaw.
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..arguments import checked
from ..elements.joints.fixed import Fixed
from ..elements.joints.revolute import Revolute
from ..elements.quantity import Value
from ..elements.validation import is_expression, positive
from ..errors import ModelError, brief
from .frame import Frame, Located, Place

if TYPE_CHECKING:
    import sympy

    from .scene import SceneRecord

# x forward, y against the normal, z down, in axes of the radius, of the way forward and the normal
LOCAL = ((0, 0, -1), (1, 0, 0), (0, -1, 0))


@checked
def circular(
    scene: SceneRecord,
    name: str,
    mu: Value,
    radius: Value,
    inclination: Value = 0,
    node: Value = 0,
    phase: Value = 0,
    center: Place | None = None,
) -> Frame:
    """A frame that goes along a circular orbit, for bodies whose attitude matters and not more.

    It is on a body ``<name>`` without mass, which the prescribed joint ``<name>`` turns about the
    center at the rate sqrt(mu / radius^3). A joint from it to the mass center of a satellite has
    the attitude in the orbit as coordinates: ``Spherical("ZYX")`` yaw, pitch and roll.

    Args:
        scene: The model.
        name: Of the frame, and of the body and the joint that it adds.
        mu: Constant of gravitation times mass of the center [m^3/s^2].
        radius: Of the orbit [m].
        inclination: Of its plane against the x-y plane of the center, about the node [rad].
        node: Direction of the ascending node in that plane, from x [rad].
        phase: Angle from the node at t = 0 [rad].
        center: Frame or body at whose origin the center is; the ground by default.

    Returns:
        The frame.

    Raises:
        ModelError: mu or radius not above 0, or a name that is taken.

    Source: P. C. Hughes, Spacecraft Attitude Dynamics, 1986, section 9.1.
    """
    import sympy

    mu, radius = (positive(f"orbit '{name}'", k, x) for k, x in (("mu", mu), ("radius", radius)))
    rate = sympy.sqrt(mu / radius**3) if is_expression(mu / radius) else (mu / radius**3) ** 0.5
    plane, carrier = scene.body(f"{name}.plane"), scene.body(f"{name}.carrier")
    orbit_frame = plane.at(rotation=("ZXZ", 0, -inclination, -node))
    scene.joint(f"{name}.plane", Fixed(), scene.ground if center is None else center, orbit_frame)
    scene.joint(name, Revolute("z"), plane, carrier, prescribed=rate * sympy.Symbol("t") + phase)
    return carrier.at(radius, 0, 0, rotation=LOCAL, name=name)


def axes(body: Place, center: Place | None = None) -> sympy.Matrix:
    """Orientation of the local frame of a body on any orbit, of its motion as it is.

    Args:
        body: Body or frame that moves about the center.
        center: Frame or body at whose origin the center is; the ground by default.

    Returns:
        R (3, 3), from local axes to those of the ground: an expression for outputs and forces.
    """
    import sympy

    for name, place in (("body", body), ("center", center or body)):
        if not isinstance(place, Located):
            raise ModelError(f"orbit: {name} is {brief(place)}; give a body or a frame")
    r, v = body.position(wrt=center), body.velocity()
    if center is not None:
        v = v - center.velocity()
    down, side = -r / r.norm(), -r.cross(v)
    side = side / side.norm()
    return sympy.Matrix.hstack(side.cross(down), side, down)


def attitude(body: Place, center: Place | None = None) -> tuple[sympy.Expr, sympy.Expr, sympy.Expr]:
    """Roll, pitch and yaw of a body against its local frame, see :func:`axes` [rad].

    The body gets there from the local frame by yaw about z, then pitch about y, then roll about x.
    Pitch lies between -90 and 90 degrees.
    """
    import sympy

    R = axes(body, center).T * body.rotation()
    return (
        sympy.atan2(R[2, 1], R[2, 2]),
        sympy.atan2(-R[2, 0], sympy.sqrt(R[2, 1] ** 2 + R[2, 2] ** 2)),
        sympy.atan2(R[1, 0], R[0, 0]),
    )
