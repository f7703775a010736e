"""Whether the unit of a mesh and the units of its material can be meant."""

from __future__ import annotations

import numpy as np

from ..arrays import Array
from ..errors import ModelWarning, warn

LARGEST, SMALLEST = 10.0, 1e-3  # extent [m] of bodies that are usual
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
