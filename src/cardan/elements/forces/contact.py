"""Contact of a sphere with a plane or another sphere."""

from __future__ import annotations

import math
from typing import ClassVar

from ...errors import ModelError
from ...ir.arithmetic import Scalar, norm, select, sqrt
from ...ir.matrix import Matrix
from ...records import dataclass
from ..formulas import Lines, Shapes
from ..internal_states import MODE, Change, EventSpec, Jumped, Mode, Solved
from ..limits import Limit, not_negative, positive
from ..quantity import RATIO, Direction, Place, Quantity, Units, Value, quantities_of
from ..validation import number
from .force import Action, ForceElement, Load, Places, constant, potential

UNDECIDED, SEPARATED, TOUCHING = 0, 1, 2


@dataclass(frozen=True)
class Contact(ForceElement):
    """A sphere that is pressed against a plane, or against another sphere, with friction.

    The normal ``force = stiffness d^exponent (1 + damping d')`` as long as that pushes, d being how
    deep the two overlap; friction is mu times it against the sliding velocity v, smoothed as
    v / sqrt(v^2 + transition_velocity^2). Touching and parting are events, so that no step goes
    over them.

    Args:
        sphere: Frame whose origin is the center of the sphere.
        radius: Of the sphere [m]; 0 for a point.
        other: Frame of the plane (its origin is a point of it), or center of the other sphere.
        stiffness: [N/m^exponent].
        damping: Hunt and Crossley's [s/m]; or by ``restitution`` and ``speed``:
        restitution: Speed after an impact over that before it, a number above 0 and at most 1.
        speed: Impact speed at which ``restitution`` holds [m/s], a number; slower impacts bounce
            more.
        exponent: 1.5 for spheres (Hertz), 1 for a linear spring.
        normal: Of the plane, in axes of ``other``, out of its material.
        other_radius: Of the other sphere [m]; None: ``other`` is a plane.
        mu: Coefficient of friction.
        transition_velocity: Speed over which friction is smoothed [m/s].

    Raises:
        ModelError: a value that is not a number or expression, a negative radius, stiffness,
            damping or mu, an exponent below 1, a transition_velocity that is not positive;
            restitution without speed, beside damping, or out of its range.

    Source: K. H. Hunt and F. R. E. Crossley, J. Applied Mechanics 42 (1975) 440.
    """

    kind: ClassVar[str] = "contact"
    strained: ClassVar[bool] = False
    symbol_shapes: ClassVar[Shapes] = {"n_0": (3, 1)}
    units: ClassVar[Units] = {
        **{"radius": "m", "stiffness": "", "damping": "s/m", "exponent": RATIO, "normal": RATIO},
        **{"other_radius": "m", "mu": "", "transition_velocity": "m/s"},
    }
    sphere: Place
    other: Place
    radius: Value
    stiffness: Value
    damping: Value = 0.0
    exponent: Value = 1.5
    normal: Direction = "z"
    other_radius: Value | None = None
    mu: Value = 0.0
    transition_velocity: Value = 1e-3
    restitution: Value | None = None
    speed: Value | None = None

    def __post_init__(self) -> None:
        if self.restitution is not None or self.speed is not None:
            object.__setattr__(self, "damping", self._damping())
            # said by the damping from here on
            object.__setattr__(self, "restitution", None)
            object.__setattr__(self, "speed", None)
        super().__post_init__()

    def _damping(self) -> float:
        """The damping by which an impact at ``speed`` has the restitution.

        Raises:
            ModelError: numbers that do not go together.
        """
        e, speed = self.restitution, self.speed
        if e is None or speed is None:
            raise ModelError("contact: restitution and speed (of the impact) go together")
        if self.damping != 0:
            raise ModelError(
                "contact: restitution and speed say what the damping is; leave one out"
            )
        e, speed = (number("contact", n, x) for n, x in (("restitution", e), ("speed", speed)))
        if not all(isinstance(x, float) and x > 0 for x in (e, speed)):
            raise ModelError(
                f"contact: restitution={e!r}, speed={speed!r}: give positive numbers, restitution "
                "at most 1"
            )
        if e > 1:
            raise ModelError(f"contact: restitution={e:g}: no impact gives energy; at most 1")
        return damping_of(float(e)) / float(speed)

    def limits(self) -> tuple[Limit, ...]:
        return (
            *not_negative("radius", "stiffness", "damping", "other_radius", "mu"),
            Limit("exponent", "exponent is {value}; give 1 or more", 1.0),
            *positive("transition_velocity"),
        )

    def quantities(self) -> dict[str, Quantity]:
        left_out = () if self.other_radius is None else ("normal",)
        return quantities_of(self, {k: v for k, v in self.units.items() if k not in left_out})

    def _geometry(self, at: Places) -> tuple[Scalar, Matrix, Matrix]:
        """Depth of the overlap, unit normal towards the sphere, and the place of the contact."""
        motion, (a, b) = at.motion, (at.frames["sphere"], at.frames["other"])
        span, radius = motion.position(a) - motion.position(b), at.data["radius"][0]
        if "normal" in at.data:
            local = at.data["normal"]
            normal = motion.rotation(b) @ (local / norm(*local))
            distance, reach = normal.dot(span), radius * 0
        else:
            distance, reach = norm(*span), at.data["other_radius"][0]
            normal = span / distance
        depth = radius + reach - distance
        return depth, normal, motion.position(a) - normal * (radius - depth * 0.5)

    def _velocity(self, at: Places, place: Matrix) -> Matrix:
        """Velocity of the sphere's material at a place relative to that of the other."""
        motion = at.motion

        def there(frame: int) -> Matrix:
            arm = place - motion.position(frame)
            return motion.velocity(frame) + motion.angular_velocity(frame).cross(arm)

        return there(at.frames["sphere"]) - there(at.frames["other"])

    def paired(self) -> bool:
        return True

    def act(self, at: Places) -> tuple[Action, ...]:
        data = at.data
        depth, normal, place = self._geometry(at)
        velocity = self._velocity(at, place)
        closing = -normal.dot(velocity)
        deep = (depth * 0).apply("lt", depth)
        touching = deep.apply("and", at.s[0].apply("eq", float(SEPARATED)).apply("not"))
        exponent, d = data["exponent"][0], select(touching, depth, 1)
        elastic = select(touching, data["stiffness"][0] * d.apply("pow", exponent), 0)
        push = elastic * (data["damping"][0] * closing + 1)
        push = (push * 0).apply("max", push)
        sliding = velocity + normal * closing
        smoothing = data["transition_velocity"][0]
        drag = push * data["mu"][0] / sqrt(sliding.dot(sliding) + smoothing * smoothing)
        # of places alone, whatever the mode
        d = select(deep, depth, 1)
        stored = data["stiffness"][0] * d.apply("pow", exponent + 1) / (exponent + 1)
        quantities = (data[name] for name in ("stiffness", "exponent", "radius"))
        energy = potential(select(deep, stored, 0), *quantities)
        return (
            Action(self._pair(at, place, normal * elastic), (), *energy),
            Action(self._pair(at, place, normal * (push - elastic) - sliding * drag)),
        )

    def _pair(self, at: Places, place: Matrix, force: Matrix) -> tuple[Load, ...]:
        """A force on the sphere at a place, and its opposite on the other."""
        loads = []
        for frame, sign in ((at.frames["sphere"], 1), (at.frames["other"], -1)):
            end_force = force * sign
            arm = place - at.motion.position(frame)
            loads.append(Load(frame, arm.cross(end_force), end_force))
        return tuple(loads)

    def formulas(self, at: Places) -> Lines:
        plane = "normal" in at.data
        normal: Lines = (
            ("span", "d = p_s - p_o"),
            ("normal out of the plane" if plane else "normal towards the sphere",
             "n = R_o @ unit(n_0)" if plane else "n = d / sqrt(dot(d, d))"),
            ("depth of the overlap", "delta = r - dot(n, d)" if plane
             else "delta = r + r_o - sqrt(dot(d, d))"),
            ("place of the contact", "x = p_s - (r - delta / 2) * n"),
            ("velocity of the sphere there",
             "v = v_s + R_s @ skew(omega_s) @ R_s.T @ (x - p_s)"
             " - v_o - R_o @ skew(omega_o) @ R_o.T @ (x - p_o)"),
        )  # fmt: skip
        push: Lines = (
            ("elastic force while they touch, k the stiffness, N the exponent",
             "f_e = k * delta ** N if delta > 0 else 0"),
            ("with damping c", "f = max(f_e * (1 - c * dot(n, v)), 0)"),
            ("sliding velocity", "w = v - dot(n, v) * n"),
            ("force on the sphere, friction with the transition velocity epsilon",
             "F_s = f * n - mu * f / sqrt(dot(w, w) + epsilon ** 2) * w"),
            ("moment on it", "M_s = skew(x - p_s) @ F_s"),
            ("on the other", "F_o = -F_s"),
            ("", "M_o = -(skew(x - p_o) @ F_s)"),
        )  # fmt: skip
        fixed = constant(*(at.data[name] for name in ("stiffness", "exponent", "radius")))
        stored = "V = k * delta ** (N + 1) / (N + 1) if delta > 0 else 0"
        return (*normal, *push, *((("potential energy", stored),) * fixed))

    # touching and parting

    def modes(self) -> tuple[Mode, ...]:
        labels = ((UNDECIDED, "undecided"), (SEPARATED, "apart"), (TOUCHING, "touching"))
        return (Mode("", UNDECIDED, labels),)

    def events(self) -> tuple[EventSpec, ...]:
        touch = EventSpec("touch", MODE, "they touch", decides=UNDECIDED, unit="m")
        return touch, EventSpec("part", MODE, "they part", unit="m")

    def signs(self, at: Places, solved: Solved) -> tuple[Scalar, ...]:
        mode, depth = at.s[0], self._geometry(at)[0]
        undecided = mode.apply("eq", float(UNDECIDED))
        touch = select(undecided, -1, select(mode.apply("eq", float(SEPARATED)), -depth, 1))
        return touch, select(mode.apply("eq", float(TOUCHING)), depth, 1)

    def change(self, at: Places, jumped: Jumped) -> Change:
        depth = self._geometry(at)[0]
        undecided = at.s[0].apply("eq", float(UNDECIDED))
        new_mode = select(undecided.apply("and", depth.apply("le", 0.0)), SEPARATED, TOUCHING)
        mode = select(jumped.fired(0), new_mode, select(jumped.fired(1), SEPARATED, at.s[0]))
        return Change(s=Matrix.vector(at.motion.graph, [mode]))


def damping_of(restitution: float) -> float:
    """Damping times speed of impact, d, by which an impact has a restitution e.

    Over an impact m x'' = -k x^n (1 + a x') integrates, whatever k, n and m, to
    ln((1 + d) / (1 - e d)) = d (1 + e) with d = a times the speed; its root is below 1 / e.
    """
    low, high = 0.0, 1.0 / restitution
    for _ in range(200):
        d = 0.5 * (low + high)
        gap = 1 - restitution * d
        lost = gap <= 0 or math.log((1 + d) / gap) > d * (1 + restitution)
        low, high = (low, d) if lost else (d, high)
    return 0.5 * (low + high) if restitution < 1 else 0.0
