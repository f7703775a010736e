"""Whether the unit of a mesh and the units of its material can be meant."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import ModelError, ModelWarning, warn

LARGEST, SMALLEST = 10.0, 1e-3  # extent [m] of bodies that are usual
FARTHEST, LOST = 1e6, 1e12  # distance from the origin, in sizes of the body
ATOM = 1e-10  # extent of the smallest [m]
SLOWEST, FASTEST = 10.0, 3e4  # speed of sound [m/s] of soft rubber, and beyond diamond
LIGHTEST, HEAVIEST = 1.0, 3e4  # density [kg/m^3] of foam, and beyond osmium


def judge_size(source: str, points: Array) -> None:
    """Warn of a body so large or small that its unit may be another one."""
    extent = float(np.ptp(points, axis=0).max())
    if extent > LARGEST:
        warn(
            f"{source}: it is {extent:.4g} m long. If its nodes are in millimeters, give "
            "scale=1e-3; scale=1 says that they are in meters",
            ModelWarning,
        )
    elif extent < SMALLEST:
        warn(
            f"{source}: it is {extent:.4g} m long, all in all. Nodes are in meters: give the unit "
            "of the file as scale=, or scale=1 if it is that small",
            ModelWarning,
        )


def judge_place(source: str, points: Array) -> None:
    """Check that positions have digits enough for the size of a body.

    Raises:
        ModelError: it is smaller than any body.
    """
    extent = float(np.ptp(points, axis=0).max())
    distance = float(abs(points.mean(axis=0)).max())
    if distance > LOST * extent:
        raise ModelError(
            f"{source}: it lies {distance:.4g} m from the origin and is {extent:.4g} m long: its "
            "nodes have no digits left. Move it to the origin, in the program that wrote it"
        )
    if extent < ATOM:
        raise ModelError(
            f"{source}: it is {extent:.4g} m long, smaller than an atom: give the unit of its "
            "nodes as scale= [m]"
        )
    if distance > FARTHEST * extent:
        warn(
            f"{source}: it lies {distance:.4g} m from the origin and is {extent:.4g} m long: its "
            "nodes lose digits. Move it to the origin",
            ModelWarning,
        )


def judge_material(source: str, stiffest: float, density: float) -> None:
    """Warn of a modulus [Pa] and a density [kg/m^3] that are in units of another system."""
    if density == 0.0:
        return
    speed = (stiffest / density) ** 0.5
    if speed > FASTEST:
        reason = f"sound would travel at {speed:.3g} m/s, faster than in any material"
    elif speed < SLOWEST:
        reason = f"sound would travel at {speed:.3g} m/s, slower than in rubber"
    elif not LIGHTEST < density < HEAVIEST:
        reason = "no solid has this density"
    else:
        return
    warn(
        f"{source}: material with E = {stiffest:.4g}, rho = {density:.4g}: {reason}. Units are Pa "
        "and kg/m^3: multiply MPa by 1e6, t/mm^3 by 1e12 and g/cm^3 by 1e3",
        ModelWarning,
    )
