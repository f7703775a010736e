"""Incidence, path and loop matrices and their products; drawings."""

from __future__ import annotations

import xml.etree.ElementTree as ElementTree

import numpy as np
import pytest

from cardan.api.scene import Scene
from cardan.elements.joints import Fixed, Revolute
from cardan.topology import build
from table import each


def random_scene(seed, bodies=12, closing=0):
    """A random tree with some loops; half of the arcs point to the ground where fixed."""
    rng = np.random.default_rng(seed)
    scene = Scene(f"random {seed}")
    made = [scene.ground]
    for k in range(bodies):
        made.append(scene.body(f"b{k}", mass=1.0))
        inner = made[rng.integers(len(made) - 1)]
        if rng.random() < 0.3:
            scene.joint(f"j{k}", Fixed(), made[-1], inner)
        else:
            scene.joint(f"j{k}", Revolute("xyz"[k % 3]), inner, made[-1])
    for k in range(closing):
        a, b = rng.choice(bodies + 1, 2, replace=False)
        scene.joint(f"c{k}", Revolute("y"), made[a], made[b])
    return scene


@each("seed", range(10))
def test_path_matrix_is_the_inverse_of_the_tree(seed):
    graph = random_scene(seed).graph
    order = [graph.bodies.index(b) for b in graph.path.columns]
    tree = np.array(graph.incidence)[order]
    path = np.array(graph.path)
    np.testing.assert_array_equal(path @ tree, np.eye(len(tree), dtype=int))
    # the row of the ground: S_0 T = -1
    np.testing.assert_array_equal(np.array(graph.incidence)[0] @ path, -1)


@each("seed", range(10))
def test_circuits_are_orthogonal_to_incidence(seed):
    graph = random_scene(seed, closing=4).graph
    assert len(graph.closing) == 4
    np.testing.assert_array_equal(np.array(graph.incidence) @ np.array(graph.circuit).T, 0)
    for joint in graph.closing:
        assert graph.circuit[joint.name, joint.name] == 1


@pytest.mark.parametrize("seed", range(5))
def test_mass_pattern_is_that_of_ancestors(seed):
    scene = random_scene(seed)
    graph, system = scene.graph, build(scene)
    pattern = graph.mass_pattern
    assert set(pattern.rows) == {j.name for j in system.joints}

    def ancestors(k):
        return {k} | (ancestors(system.bodies[k].parent) if system.bodies[k].parent >= 0 else set())

    for i, a in enumerate(system.joints):
        for k, b in enumerate(system.joints):
            related = i in ancestors(k) or k in ancestors(i)
            assert pattern[a.name, b.name] == related


def test_coupled_joints_fill_the_blocks_of_their_leader():
    scene = Scene("hand")
    palm = scene.body("palm", mass=1.0)
    left, right = scene.body("left", mass=1.0), scene.body("right", mass=1.0)
    scene.joint("wrist", Revolute("z"), scene.ground, palm)
    scene.joint("l", Revolute("y"), palm, left)
    scene.joint("r", Revolute("y"), palm, right, couple=("l", -1.0))
    assert scene.graph.mass_pattern.rows == ("wrist", "l")


def hostile():
    scene = Scene('a "model" <&>')
    body = scene.body('evil"]; <script>&', mass=1.0)
    scene.joint('j"\\', Revolute("y"), scene.ground, body)
    return scene


def test_text_has_one_line_per_body():
    scene = random_scene(1, closing=2)
    lines = str(scene.graph).splitlines()
    assert lines[0] == "ground"
    assert sum("closes a loop" in line for line in lines) == 2
    assert len(lines) == 1 + 12 + 2


def test_dot_quotes_names():
    text = hostile().graph.dot()
    assert r'"evil\"]; <script>&"' in text
    assert r'label="j\"\\\nrevolute"' in text
    # outside quotes nothing of the name is left
    assert text.count("\\\\") == 1


def test_notebooks_show_summary_and_graph():
    text = hostile()._repr_html_()
    assert "<svg" in text
    assert "<script>" not in text


def test_svg_is_well_formed_and_escaped():
    root = ElementTree.fromstring(hostile().graph.svg())
    texts = [e.text for e in root.iter() if e.tag.endswith("text")]
    assert 'j"\\' in texts
    assert not [e for e in root.iter() if e.tag.endswith("script")]
    ElementTree.fromstring(random_scene(2, closing=3).graph.svg())


def test_labelled_matrix_prints_and_indexes():
    incidence = hostile().graph.incidence
    assert incidence["ground", 'j"\\'] == 1
    assert incidence.shape == (2, 1)
    assert "+1" in str(incidence)
