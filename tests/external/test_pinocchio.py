"""Every robot of example-robot-data against Pinocchio: poses, M, inverse and forward dynamics.

A spread of robots runs always, all of them under the marker ``external``. Every case counts its
comparisons and holds the count against ``comparisons.json``.
"""

from __future__ import annotations

import json
import re
from itertools import cycle
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import cardan as cd
from cardan.ir.interpreter import evaluate
from external.robots import (
    FILES,
    LEADERLESS,
    ROBOTS,
    SINGULAR,
    WITH_MIMIC,
    Mimic,
    Peer,
    Slot,
    mimics,
)
from spread import some

SEED = 2
STATES = 10
EPS = float(np.finfo(float).eps)
COUNTS = Path(__file__).parent / "comparisons.json"
FUNCTIONS = ("mass_matrix", "inverse_dynamics", "forward_dynamics")
SPREAD = {
    "anymal_b_simple_description/robots/anymal.urdf",
    "double_pendulum_description/urdf/double_pendulum_continuous.urdf",
    "hector_description/robots/quadrotor_base.urdf",
    "iris_description/robots/iris.urdf",
    "kinova_description/robots/kinova.urdf",
    "panda_description/urdf/panda.urdf",
    "romeo_description/urdf/romeo_laas_small.urdf",
    "solo_description/robots/solo12.urdf",
    "ur_description/urdf/ur5_robot.urdf",
}


def spread(names: list[str]) -> list[Any]:
    return [
        pytest.param(name, marks=[] if name in SPREAD else pytest.mark.external) for name in names
    ]


def based(names: list[str]) -> list[Any]:
    """Every robot on both bases; what always runs does so on either in turn, else it is slow."""
    always = [name for name in names if name in SPREAD]
    others = [name for name in names if name not in SPREAD]
    bases = cycle((("fixed", "free"), ("free", "fixed")))
    turns = [(name, base) for name, both in zip(always, bases, strict=False) for base in both]
    return [
        *some(turns, 2),
        *(
            pytest.param(name, base, marks=pytest.mark.external)
            for name in others
            for base in ("fixed", "free")
        ),
    ]


class Case:
    """One file as our model and Pinocchio's, at seeded states."""

    def __init__(self, name: str, base: str, mimic: str) -> None:
        scene = cd.load(ROBOTS / name, base=base, mimic=mimic, snap=False)
        self.equations = cd.derive(scene)
        self.system = self.equations.system
        self.undamped = {p.name: 0.0 for p in self.system.parameters if p.name.endswith(".damping")}
        self.slots = tuple(
            Slot(j.name, j.q, j.u, j.element.kind == "free") for j in self.system.joints if j.q >= 0
        )
        self.peer = Peer.read(name, base == "free", mimic == "couple", self.slots)
        self.rng = np.random.default_rng(SEED)
        self.q = np.array([self._place() for _ in range(STATES)])
        shape = (STATES, self.system.nu)
        self.u, self.udot, self.tau = (self.rng.uniform(-1, 1, shape) for _ in range(3))
        self.mass = np.array([self.peer.mass_matrix(q) for q in self.q])
        self.count = 0

    @property
    def compiled(self) -> Any:
        model = cd.compile(self.equations, functions=FUNCTIONS)
        return model.with_parameters(self.undamped) if self.undamped else model

    def _place(self) -> np.ndarray:
        q = np.zeros(self.system.nq)
        for slot in self.slots:
            q[slot.q] = self.rng.uniform(-np.pi, np.pi)
            if slot.free:
                turn = self.rng.normal(size=4)
                q[slot.q : slot.q + 4] = turn / np.linalg.norm(turn)
                q[slot.q + 4 : slot.q + 7] = self.rng.uniform(-2, 2, 3)
        return q

    @property
    def allowed(self) -> np.ndarray:
        """min(100 eps cond(M), 1e-9) per state."""
        if self.system.nu == 0:
            return np.full(STATES, 100 * EPS)
        return np.minimum(100 * EPS * np.linalg.cond(self.mass), 1e-9)

    def compare(self, what: str, ours: np.ndarray, theirs: np.ndarray) -> None:
        """max|error| <= allowed max|value| at every state."""
        ours, theirs = (np.asarray(x, dtype=float).reshape(STATES, -1) for x in (ours, theirs))
        assert ours.shape == theirs.shape
        error = np.abs(ours - theirs).max(axis=1, initial=0)
        size = np.abs(theirs).max(axis=1, initial=0)
        worst = int(np.argmax(error - self.allowed * size))
        assert np.all(error <= self.allowed * size), (
            f"{what}, seed {SEED}, state {worst}: error {error[worst]:.2e} of {size[worst]:.2e}, "
            f"allowed {self.allowed[worst]:.2e}"
        )
        self.count += STATES

    def poses(self) -> None:
        """Every link that Pinocchio knows."""
        parameters = [self.undamped.get(p.name, p.value) for p in self.system.parameters]
        theirs: dict[str, list[np.ndarray]] = {link: [] for link in self.peer.links}
        theirs.pop("universe", None)
        for q in self.q:
            self.peer.place(q)
            for link, found in theirs.items():
                found.append(self.peer.pose(link, q))
        for link, found in theirs.items():
            # a link may not be called like what does not move
            frame = "ground_link" if link == "ground" else link
            function = self.equations.function("pose", frame)
            got = evaluate(function, {"q": self.q, "p": parameters}, arithmetic="numpy")
            ours = np.broadcast_to(got["pose"], (STATES, 4, 4))
            self.compare(f"pose of {link}", ours, np.array(found))

    def dynamics(self, forward: bool = True) -> None:
        model, peer = self.compiled, self.peer
        self.compare("mass matrix", model.mass_matrix(self.q), self.mass)
        triples = list(zip(self.q, self.u, self.udot, strict=True))
        expected = np.array([peer.inverse_dynamics(*state) for state in triples])
        computed = model.inverse_dynamics(self.q, self.u, self.udot)
        self.compare("inverse dynamics", computed, expected)
        if forward:
            self.compare(
                "forward dynamics",
                model.forward_dynamics(self.q, self.u, tau=self.tau),
                np.array([self.forward(*state) for state in zip(self.q, self.u, self.tau)]),  # noqa: B905
            )

    def forward(self, q: np.ndarray, u: np.ndarray, tau: np.ndarray) -> np.ndarray:
        """Pinocchio's forward dynamics; its ABA refuses mimic joints, M and RNEA do not."""
        if not any("Mimic" in joint.shortname() for joint in self.peer.model.joints):
            return self.peer.forward_dynamics(q, u, tau)
        bias = self.peer.inverse_dynamics(q, u, np.zeros_like(u))
        return np.linalg.solve(self.peer.mass_matrix(q), tau - bias)


def held(case: Case, key: str, record_property: Any) -> None:
    """The comparisons of a case are counted, and never fewer than committed."""
    record_property("comparisons", case.count)
    record_property("case", key)
    assert case.count >= json.loads(COUNTS.read_text(encoding="utf-8"))[key]


@pytest.mark.parametrize(("name", "base"), based(FILES))
def test_mimic_freed(name: str, base: str, record_property: Any) -> None:
    case = Case(name, base, "free")
    case.poses()
    case.dynamics(forward=name not in SINGULAR)
    if name in SINGULAR:
        with pytest.raises(cd.CardanError, match="joint"):
            case.compiled.forward_dynamics(case.q[0], case.u[0])
    held(case, f"{name} {base}", record_property)


def builds_mimic(name: str) -> bool:
    """Pinocchio couples a mimic joint only where its leader comes first."""
    try:
        Peer.read(name, False, True, ())
    except (RuntimeError, ValueError):
        return False
    return True


@pytest.mark.parametrize(
    ("name", "base"), based([name for name in WITH_MIMIC if builds_mimic(name)])
)
def test_mimic_coupled(name: str, base: str, record_property: Any) -> None:
    case = Case(name, base, "couple")
    case.dynamics()
    held(case, f"{name} {base} coupled", record_property)


def expansion(coupled: Any, freed: Any, table: dict[str, Mimic]) -> tuple[np.ndarray, np.ndarray]:
    """E (nu_free, nu) and q of the mimicking joints' offsets: u_free = E u."""
    mine = {j.name: j for j in coupled.joints}
    matrix, offset = np.zeros((freed.nu, coupled.nu)), np.zeros(freed.nq)
    for joint in freed.joints:
        mimic, leader, ratio = table.get(joint.name), joint.name, 1.0
        # a leader may itself mimic
        while mimic is not None:
            offset[joint.q] += ratio * mimic.offset
            leader, ratio = mimic.leader, ratio * mimic.multiplier
            mimic = table.get(leader)
        for k in range(len(joint.element.speeds)):
            matrix[joint.u + k, mine[leader].u + k] = ratio
    return matrix, offset


@pytest.mark.parametrize("name", spread(WITH_MIMIC))
def test_coupling_contracts_the_free_mass_matrix(name: str, record_property: Any) -> None:
    free = Case(name, "fixed", "free")
    scene = cd.load(ROBOTS / name, base="fixed", mimic="couple", snap=False)
    equations = cd.derive(scene)
    matrix, offset = expansion(equations.system, free.system, mimics(name))
    # on a fixed base q and u have the same slots
    q = np.random.default_rng(SEED).uniform(-np.pi, np.pi, (STATES, equations.system.nq))
    free.q = q @ matrix.T + offset
    parameters = [p.value for p in free.system.parameters]
    function = free.equations.function("mass_matrix")
    full = evaluate(function, {"q": free.q, "p": parameters}, arithmetic="numpy")["M"]
    free.mass = matrix.T @ full @ matrix
    parameters = [p.value for p in equations.system.parameters]
    function = equations.function("mass_matrix")
    ours = evaluate(function, {"q": q, "p": parameters}, arithmetic="numpy")["M"]
    free.compare("contracted mass matrix", ours, free.mass)
    held(free, f"{name} contracted", record_property)


@pytest.mark.parametrize("name", sorted(LEADERLESS))
def test_a_mimic_joint_without_its_leader_is_named_and_moves_freely(name: str) -> None:
    follower, mimic = next(iter(mimics(name).items()))
    with pytest.warns(UserWarning, match=re.escape(f"{follower} ({mimic.leader})")):
        scene = cd.load(ROBOTS / name, mimic="couple")
    assert follower in cd.derive(scene).coordinates


def test_every_robot_is_compared() -> None:
    assert len(FILES) == 68
    counts = json.loads(COUNTS.read_text(encoding="utf-8"))
    assert {f"{name} {base}" for name in FILES for base in ("fixed", "free")} <= set(counts)
    print(f"{sum(counts.values())} comparisons in {len(counts)} cases")
