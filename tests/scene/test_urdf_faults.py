"""What a newcomer gets wrong in a URDF: every fault is named, with its place and its cure."""

from __future__ import annotations

from pathlib import Path

import pytest

import cardan as cd
from cardan.errors import ImpossibleWarning
from cardan.scene.files import mjcf, sdf
from cardan.scene.files.urdf import from_text
from cardan.scene.summary import summary
from table import each

INERTIAL = '<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1"/></inertial>'
LIMIT = '<limit lower="-1" upper="1"/>'
AXIS = '<axis xyz="0 0 1"/>'


def link(name: str, inside: str = INERTIAL) -> str:
    return f'<link name="{name}">{inside}</link>'


def joint(
    inside: str = AXIS + LIMIT,
    kind: str = "revolute",
    name: str = "elbow",
    parent: str = "base",
    child: str = "boom",
) -> str:
    return (
        f'<joint name="{name}" type="{kind}">\n<parent link="{parent}"/><child link="{child}"/>'
        f"{inside}</joint>"
    )


def robot(*parts: str) -> str:
    return '<robot name="r">\n' + "\n".join(parts) + "</robot>"


def arm(inside: str = AXIS + LIMIT, kind: str = "revolute", boom: str = INERTIAL) -> str:
    return robot(link("base"), link("boom", boom), joint(inside, kind))


def notes(text: str) -> list[str]:
    """Those on faults, without those on what does not act."""
    return [note for note in from_text(text, name="arm.urdf").notes if "do not act" not in note]


@pytest.mark.filterwarnings("error")
def test_a_faultless_robot_has_no_notes() -> None:
    visual = (
        '<visual name="v"><origin xyz="0 0 0" rpy="0 0 0"/><geometry><box size="1 1 1"/></geometry>'
        '<material name="red"><color rgba="1 0 0 1"/></material></visual>'
    )
    limit = '<limit lower="0" upper="1" velocity="1" effort="2"/>'
    more = '<origin xyz="0 0 1" rpy="0 0 1"/><dynamics damping="1" friction="0"/>'
    loop = (
        '<loop_joint name="C" type="fixed"><link1 link="base"/><link2 link="boom"><origin/></link2>'
        "<origin/></loop_joint>"
    )
    parts = (link("base"), link("boom", INERTIAL + visual), joint(AXIS + limit + more), loop)
    assert not notes(robot(*parts))


@pytest.mark.parametrize("kind", ["revolute", "continuous", "prismatic", "planar"])
def test_a_missing_axis_is_noted(kind: str) -> None:
    assert notes(arm(LIMIT, kind)) == ["joint 'elbow': no <axis>; x is taken, as URDF says"]


@pytest.mark.parametrize("kind", ["fixed", "floating"])
def test_joints_without_an_axis_need_none(kind: str) -> None:
    assert not notes(arm("", kind))


def test_joints_with_the_same_fault_share_a_note() -> None:
    parts = [link("base"), link("boom"), link("hand"), joint(LIMIT)]
    parts.append(joint(LIMIT, name="wrist", parent="boom", child="hand"))
    said = "joints 'elbow', 'wrist': no <axis>; x is taken, as URDF says"
    assert notes(robot(*parts)) == [said]


def test_a_missing_axis_of_what_closes_a_loop_is_noted() -> None:
    ends = '<link1 link="base"/><link2 link="boom"/>'
    loop = f'<loop_joint name="C" type="revolute">{ends}</loop_joint>'
    assert notes(robot(link("base"), link("boom"), joint(), loop)) == [
        "arm.urdf:6: loop joint 'C': no <axis>; x is taken"
    ]


@each(
    ("kind", "limited"),
    [("revolute", True), ("prismatic", True), ("continuous", False), ("planar", False)],
)
def test_a_missing_limit_is_noted(kind: str, limited: bool) -> None:
    said = f"'elbow': no <limit>, which URDF requires of a {kind} joint; it moves without limits"
    assert notes(arm(AXIS, kind)) == ([f"joint {said}"] if limited else [])


@each(
    ("text", "said"),
    [
        (
            arm(AXIS + LIMIT + '<origin xzy="1 0 0"/>'),
            "arm.urdf:5: joint 'elbow': <origin xzy=...> is not read. Did you mean 'xyz'?",
        ),
        (
            arm(boom=INERTIAL.replace("inertial", "intertial")),
            "arm.urdf:3: link 'boom': <intertial> is not read. Did you mean 'inertial'?",
        ),
        (
            arm(AXIS + '<Limit lower="0" upper="1"/>' + LIMIT),
            "arm.urdf:5: joint 'elbow': <Limit> is not read. Did you mean 'limit'?",
        ),
    ],
)
def test_what_is_misspelt_is_noted_and_warned_of(text: str, said: str) -> None:
    with pytest.warns(cd.ModelWarning) as warned:
        assert said in from_text(text, name="arm.urdf").notes
    assert said in [str(one.message) for one in warned]


def test_what_is_misspelt_often_is_noted_once() -> None:
    links = [link(f"l{k}", INERTIAL.replace("inertial", "intertial")) for k in range(3)]
    joints = [joint(kind="fixed", name=f"j{k}", parent="l0", child=f"l{k}") for k in (1, 2)]
    with pytest.warns(cd.ModelWarning, match="intertial"):
        said = notes(robot(*links, *joints))
    assert len(said) == 1
    assert said[0].endswith("Did you mean 'inertial'? (3 times)")


def test_a_misspelt_element_is_warned_of_where_the_file_cannot_be_read(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(arm().replace("joint", "jiont"))
    with (
        pytest.raises(cd.TopologyError, match="2 root links"),
        pytest.warns(cd.ModelWarning, match="<jiont> is not read. Did you mean 'joint'"),
    ):
        cd.load(path)


def test_what_is_not_read_is_listed() -> None:
    boom = INERTIAL + "<collision/>" * 2
    limit = '<limit lower="0" upper="1" jerk="3"/>'
    text = arm(AXIS + limit + "<safety_controller/>", boom=boom)
    text = text.replace("</robot>", '<gazebo/><x:thing xmlns:x="http://x"/></robot>')
    assert notes(text) == [
        "not read: link collision (2), gazebo, thing, joint safety_controller, limit jerk="
    ]


def test_what_an_element_has_already_is_not_proposed() -> None:
    limit = '<limit lower="0" upper="1" effort="1" command_effort="2"/>'
    assert notes(arm(AXIS + limit)) == ["not read: limit command_effort="]


def test_many_unknown_names_stay_one_short_note() -> None:
    text = robot(link("base"), *(f"<q{k:05}zz/>" for k in range(20_000)))
    (note,) = notes(text)
    assert note.endswith(" and 19960 more")
    assert len(note) < 600


def test_missing_moments_of_inertia_are_named() -> None:
    flat = INERTIAL.replace(' izz="1"', "")
    said = "link 'boom': <inertia> lacks izz; 0 is taken"
    assert notes(arm(boom=flat)) == [said]
    with pytest.warns(ImpossibleWarning) as warned:
        from_text(arm(boom=flat.replace('ixx="1"', 'ixx="3"')))
    (message,) = [str(one.message) for one in warned]
    assert "body 'boom': <inertia> lacks izz; with 0 in its place no body has this" in message
    assert message.endswith("give izz")


@each(
    ("inside", "words"),
    [
        ('<axis xyz="1,0,0"/>', "'1,0,0' has commas, but blanks separate numbers: write '1 0 0'"),
        ('<axis xyz="1, 0, 0"/>', "blanks separate numbers: write '1 0 0'"),
        ('<axis xyz="0 0 z"/>', "xyz of <axis>: 'z' is not a number"),
        ('<axis xyz="0 0"/>', "xyz='0 0' of <axis> has 2 numbers, expected 3"),
        ('<axis xyz="1"/>', "xyz='1' of <axis> has 1 number, expected 3"),
        ('<dynamics damping="1 kg"/>', "damping of <dynamics>: '1 kg' is not a number"),
        ('<dynamics damping=""/>', "damping of <dynamics>: '' is not a number"),
        ('<limit lower="low"/>', "lower of <limit>: 'low' is not a number"),
        ('<dynamics damping="1e31"/>', "'1e31' is not a number up to 1e+30"),
    ],
)
def test_faulty_numbers(inside: str, words: str) -> None:
    with pytest.raises(cd.ModelError) as caught:
        from_text(arm(inside))
    assert words in str(caught.value)


@pytest.mark.filterwarnings("ignore")
def test_a_massless_body_inside_a_chain_is_not_a_tip() -> None:
    inner = joint()
    outer = joint(name="wrist", parent="boom", child="hand")
    text = robot(link("base"), link("boom", ""), link("hand", ""), inner, outer)
    said = [note for note in cd.derive(from_text(text)).system.notes if "massless" in note]
    assert said == [
        "body 'boom' and all that it carries ('hand') are massless: nothing resists the joint "
        "'elbow' that moves it. Give one of them a mass or an inertia, or fix or prescribe the "
        "joint",
        "body 'hand' is a massless tip: nothing resists the joint 'wrist' that moves it. Give it a "
        "mass or an inertia, or fix or prescribe the joint",
    ]


def mesh(reference: str) -> str:
    return f'<visual><geometry><mesh filename="{reference}"/></geometry></visual>'


def test_a_missing_mesh_is_named_with_its_link_and_the_folders(tmp_path: Path) -> None:
    path = tmp_path / "arm.urdf"
    path.write_text(arm(boom=INERTIAL + mesh("meshes/boom.stl")))
    (note,) = [note for note in cd.load(path).notes if "mesh" in note]
    assert note == (
        f"1 mesh file was not found in the folder of the file ('{tmp_path}'): 'meshes/boom.stl' of "
        "link 'boom'; relative paths start at the folder of the file"
    )
    path.write_text(arm(boom=INERTIAL + mesh("package://arm/boom.stl")))
    (note,) = [note for note in cd.load(path, packages="ros").notes if "mesh" in note]
    assert note == (
        f"1 mesh file was not found in 'ros' and the folder of the file ('{tmp_path}'): "
        "'package://arm/boom.stl' of link 'boom'; packages= names the folders to look in"
    )


def test_the_cure_at_the_end_of_a_note_is_printed() -> None:
    meshes = "".join(mesh(f"meshes/a_part_with_a_long_name_{k}.stl") for k in range(3))
    printed = summary(from_text(arm(boom=INERTIAL + meshes)))
    assert "relative paths start at the folder of the file\n" in printed


def test_a_mesh_of_an_sdf_without_a_file_lacks_its_uri() -> None:
    text = (
        '<sdf version="1.7"><model name="m"><link name="a"><visual name="v"><geometry><mesh/>'
        "</geometry></visual></link></model></sdf>"
    )
    with pytest.raises(cd.ModelError, match="<mesh> lacks <uri>"):
        sdf.from_text(text)


BROKEN = {
    "arm.urdf": arm('<axis xyz="0 0"/>'),
    "loop.urdf": robot(link("base"), link("boom")),
    "arm.sdf": '<sdf version="1.7"><model name="m"><link/></model></sdf>',
    "arm.xml": "<mujoco><worldbody><body><geom size='x'/></body></worldbody></mujoco>",
    "arm.yaml": "cardan: 1\nbodies: {a: {mass: x}}\n",
    "bad.urdf": "<robot",
}


@pytest.mark.parametrize("name", BROKEN)
def test_errors_name_the_file(name: str, tmp_path: Path) -> None:
    (tmp_path / name).write_text(BROKEN[name])
    with pytest.raises(cd.CardanError, match=name):
        cd.load(tmp_path / name)


def test_errors_in_an_included_file_name_it(tmp_path: Path) -> None:
    (tmp_path / "arm.urdf").write_text(arm('<axis xyz="0 0"/>'))
    (tmp_path / "cell.yaml").write_text("cardan: 1\ninclude: {left: {file: arm.urdf}}\n")
    with pytest.raises(cd.ModelError, match=r"cell.yaml:2:.*file 'arm.urdf': joint 'elbow'"):
        cd.load(tmp_path / "cell.yaml")


@each(
    ("parts", "words"),
    [
        ([], "2 root links, which no joint has as its <child>: 'base', 'boom'"),
        (
            [joint(), joint(name="back", parent="boom", child="base")],
            "Write the joint that closes the loop as <loop_joint>",
        ),
        (
            [link("hand"), link("tip"), joint(),
             joint(name="a", parent="hand", child="tip"),
             joint(name="b", parent="tip", child="hand")],
            "from the root link 'base' to the links 'tip', 'hand': their joints form a loop",
        ),
    ],
)  # fmt: skip
def test_links_that_are_no_tree(parts: list[str], words: str) -> None:
    with pytest.raises(cd.TopologyError) as caught:
        from_text(robot(link("base"), link("boom"), *parts))
    assert words in str(caught.value)


def test_hints_of_other_formats_stay() -> None:
    text = "<mujoco><worldbody><body><inertial pos='0 0 0' mass='1' diaginertia='1,1,1'/></body>"
    with pytest.raises(cd.ModelError, match="blanks separate numbers"):
        mjcf.from_text(f"{text}</worldbody></mujoco>")


LINKS = '<link name="a"/><link name="b">{inertial}</link><link name="c"/>'


@pytest.mark.parametrize(
    ("mass", "message"),
    [
        ("", r"link 'b': <inertial> lacks <mass value"),
        ("<mass>1.5</mass>", r"lacks the attribute 'value': write <mass value=\"1\.5\"/>"),
    ],
)
def test_a_mass_that_is_missing_is_named(tmp_path: Path, mass: str, message: str) -> None:
    inertia = '<inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    links = LINKS.format(inertial=f"<inertial>{mass}{inertia}</inertial>")
    joints = (
        '<joint name="{n}" type="continuous"><parent link="{p}"/><child link="{c}"/>'
        '<axis xyz="0 0 1"/></joint>'
    )
    both = joints.format(n="j", p="a", c="b") + joints.format(n="k", p="b", c="c")
    file = tmp_path / "robot.urdf"
    file.write_text(f'<robot name="robot">{links}{both}</robot>')
    with pytest.raises(cd.ModelError, match=message):
        cd.load(file)


def test_links_that_are_exchanged_are_suspected(tmp_path: Path) -> None:
    joints = "".join(
        f'<joint name="{n}" type="continuous"><parent link="{p}"/><child link="{c}"/>'
        '<axis xyz="0 0 1"/></joint>'
        for n, p, c in (("first", "a", "b"), ("second", "c", "b"))
    )
    file = tmp_path / "robot.urdf"
    file.write_text(f'<robot name="robot">{LINKS.format(inertial="")}{joints}</robot>')
    with pytest.raises(cd.TopologyError, match="<parent> and <child> of 'second' exchanged"):
        cd.load(file)
