"""The linearized Whipple bicycle with all its parameters as symbols, as its paper has it.

Written down from the paper before it was compared with what is derived.

Source: J. P. Meijaard, J. M. Papadopoulos, A. Ruina, A. L. Schwab, Proc. R. Soc. A 463 (2007)
1955-1982, appendix A: M q'' + v C1 q' + (g K0 + v² K2) q = f, q = (lean, steer). Axes: x forward, z
down. Products of inertia are those of the tensor.
"""

from __future__ import annotations

from typing import Any

import sympy as sp

import cardan as cd

NUMBERS: dict[str, float] = {
    "g": 9.81, "w": 1.02, "c": 0.08, "lam": 0.3141592653589793,
    "rR": 0.3, "mR": 2.0, "IRxx": 0.0603, "IRyy": 0.12,
    "rF": 0.35, "mF": 3.0, "IFxx": 0.1405, "IFyy": 0.28,
    "xB": 0.3, "zB": -0.9, "mB": 85.0, "IBxx": 9.2, "IBzz": 2.8, "IBxz": 2.4, "IByy": 11.0,
    "xH": 0.9, "zH": -0.7, "mH": 4.0, "IHxx": 0.05892, "IHzz": 0.00708, "IHxz": -0.00756,
    "IHyy": 0.06,
}  # fmt: skip
UNITS = {"g": "m/s^2", "lam": "rad"} | {
    name: "kg*m^2" if name.startswith("I") else "kg" if name.startswith("m") else "m"
    for name in NUMBERS
    if name not in ("g", "lam")
}


def scene() -> cd.Scene:
    """The bicycle of ``cd.examples["bicycle"]`` with a symbol for every number; z points up here.

    Turning the axes by pi about x changes the signs of y, z and of products with x: what stands in
    the scene as -zB or -IBxz is zB and IBxz of the paper.
    """
    g = sp.Symbol("g")
    made = cd.Scene("whipple", gravity=(0, 0, -g))
    p = {name: made.parameter(name, value, unit=UNITS[name]) for name, value in NUMBERS.items()}
    rear = made.body("rear", mass=p["mR"], inertia=(p["IRxx"], p["IRyy"], p["IRxx"]))
    frame = made.body(
        "frame", mass=p["mB"], com=(p["xB"], 0, -p["zB"] - p["rR"]), inertia=_tensor(p, "B")
    )
    # its origin is where the steering axis meets the ground
    fork = made.body(
        "fork", mass=p["mH"], com=(p["xH"] - p["w"] - p["c"], 0, -p["zH"]), inertia=_tensor(p, "H")
    )
    front = made.body("front", mass=p["mF"], inertia=(p["IFxx"], p["IFyy"], p["IFxx"]))
    lam = p["lam"]
    made.joint("wheel", cd.RollingDisk(p["rR"]), made.ground, rear)
    made.joint("hub", cd.Revolute("y"), rear, frame)
    # steering to the right is positive: about the axis that points down
    axis = (sp.sin(lam), 0, -sp.cos(lam))
    made.joint("steer", cd.Revolute(axis), frame.at(p["w"] + p["c"], 0, -p["rR"]), fork)
    made.joint("axle", cd.Revolute("y"), fork.at(-p["c"], 0, p["rF"]), front)
    made.joint("contact", cd.RollingDisk(p["rF"]), made.ground, front)
    return made


def _tensor(p: dict[str, Any], body: str) -> dict[str, Any]:
    diagonal = {axis: p[f"I{body}{axis}"] for axis in ("xx", "yy", "zz")}
    return {**diagonal, "xz": -p[f"I{body}xz"], "xy": 0, "yz": 0}


class Paper:
    """M, C1, K0 and K2 of appendix A in the symbols of the scene."""

    w, c, lam = sp.symbols("w c lam")
    rR, mR, IRxx, IRyy, rF, mF, IFxx, IFyy = sp.symbols("rR mR IRxx IRyy rF mF IFxx IFyy")
    xB, zB, mB, IBxx, IBzz, IBxz = sp.symbols("xB zB mB IBxx IBzz IBxz")
    xH, zH, mH, IHxx, IHzz, IHxz = sp.symbols("xH zH mH IHxx IHzz IHxz")
    sine, cosine = sp.sin(lam), sp.cos(lam)

    # the whole bicycle: mass times place of its center, and moments about the rear contact
    mTxT = xB * mB + xH * mH + w * mF
    mTzT = -rR * mR + zB * mB + zH * mH - rF * mF
    ITxx = IRxx + IBxx + IHxx + IFxx + mR * rR**2 + mB * zB**2 + mH * zH**2 + mF * rF**2
    ITxz = IBxz + IHxz - mB * xB * zB - mH * xH * zH + mF * w * rF
    ITzz = IRxx + IBzz + IHzz + IFxx + mB * xB**2 + mH * xH**2 + mF * w**2
    # the front assembly
    mA = mH + mF
    xA, zA = (xH * mH + w * mF) / mA, (zH * mH - rF * mF) / mA
    IAxx = IHxx + IFxx + mH * (zH - zA) ** 2 + mF * (rF + zA) ** 2
    IAxz = IHxz - mH * (xH - xA) * (zH - zA) + mF * (w - xA) * (rF + zA)
    IAzz = IHzz + IFxx + mH * (xH - xA) ** 2 + mF * (w - xA) ** 2
    uA = (xA - w - c) * cosine - zA * sine
    IAll = mA * uA**2 + IAxx * sine**2 + 2 * IAxz * sine * cosine + IAzz * cosine**2
    IAlx = -mA * uA * zA + IAxx * sine + IAxz * cosine
    IAlz = mA * uA * xA + IAxz * sine + IAzz * cosine
    mu = c / w * cosine
    SR, SF = IRyy / rR, IFyy / rF
    ST = SR + SF
    SA = mA * uA + mu * mTxT

    M = ((ITxx, IAlx + mu * ITxz), (IAlx + mu * ITxz, IAll + 2 * mu * IAlz + mu**2 * ITzz))
    K0 = ((mTzT, -SA), (-SA, -SA * sine))
    K2 = ((0, (ST - mTzT) / w * cosine), (0, (SA + SF * sine) / w * cosine))
    C1 = (
        (0, mu * ST + SF * cosine + ITxz / w * cosine - mu * mTzT),
        (-(mu * ST + SF * cosine), IAlz / w * cosine + mu * (SA + ITzz / w * cosine)),
    )
    # summands with the composite quantities put in and multiplied out, row by row, counted by hand:
    # mA and the center of the front assembly are in no denominator then, as
    # mA xA² + mH (xH - xA)² + mF (w - xA)² = mH xH² + mF w², and most of the front wheel cancels,
    # whose center is on no arm but -c cos lam + rF sin lam
    M_terms = (8, 12, 12, 28)
    K0_terms = (4, 7, 7, 7)
    K2_terms = (0, 6, 0, 8)
    C1_terms = (0, 12, 3, 19)
