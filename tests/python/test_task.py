# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Task files: what is read, and what is said about each fault."""

import contextlib
import copy
import math
import re
import shutil
import struct
import warnings

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

import graspless
from fingertip_common import PUSH
from graspless import TaskError, _data, carry, clasp, fingertip, frames, geometry, pinch, slide
from graspless.tasks import task_from_dict
from graspless.tasks.clouds import read_cloud
from graspless.tasks.reading import parse_yaml
from graspless.tasks.slide import model
from graspless.tasks.source import shorten
from tasks_common import GOOD, changed, fault, run, write_renamed, write_robot_with_mesh

CARD = "rectangle: {size: [0.10, 0.08]}"
TABLE = "rectangle: {center: [0.65, 0.0], size: [0.7, 0.7]}"


def test_reads_a_task(write):
    task = graspless.load_task(write(GOOD))
    assert task.seed == 3
    assert task.budget.seconds == 20
    assert task.problem.object.name == "card"
    assert task.problem.support.polygon.area == pytest.approx(0.49)
    np.testing.assert_allclose(task.problem.X_WO_start[:2, 3], [0.6, 0.1])
    assert task.problem.q_home[list(task.problem.robot.joint_names).index("wam_joint_4")] == 1.6


HOME = "home: {wam_joint_2: 0.2, wam_joint_4: 1.6, wam_joint_6: 1.2}"
OUTLINE = f"{CARD}\n  thickness: 0.004"
POSE = "{x: 0.60, y: 0.10, yaw: 0.3}"


def more(text):
    """A change that adds a section on line 13."""
    return "budget:", f"{text}\nbudget:"


# A change of the good task, the line that is blamed, and what must be said.
FAULTS = [
    (("thickness:", "thicknes:"), 8, r"object.thicknes: unknown field; did you mean 'thickness'"),
    (("kind: slide", "kind: slid"), 1, r"kind: slid: should be 'slide'"),
    (("kind: slide", "kind: slied"), 1, r"kind: slied: .*'chain'; did you mean 'slide'\?$"),
    (more("options: {search: papr}"), 13, r"search: papr: .*'fast'; did you mean 'paper'\?$"),
    (("kind: slide", "kind:"), 1, r"kind: missing; should be 'slide'"),
    (("0.004", "thin"), 8, r"object.thickness: thin: should be a valid number"),
    (("0.004", "0,004"), 8, r"object.thickness: 0,004: .* a point: 0.004"),
    (("0.004", "'0.004'"), 8, r"object.thickness: '0.004': .*number, without quotes"),
    (("[0.10, 0.08]", '"[0.1, 0.08]"'), 7, r"size: '\[0.1, 0.08\]': .* valid list, without quotes"),
    (
        (CARD, 'rectangle: "{size: [1, 1]}"'),
        7,
        r"rectangle: '\{size.*: .*mapping with.*, without quotes",
    ),
    ((POSE, "'[0, 1]'"), 9, r"object.pose: '\[0, 1\]': .*mapping with .*, without quotes"),
    (("name: card", "name: {a: 1}"), 6, r"object.name: \{'a': 1\}: should be a valid string"),
    (("0.004", "{a: 1}"), 8, r"object.thickness: \{'a': 1\}: should be a valid number"),
    (("name: card", "'': card"), 6, r"object.'': unknown field"),
    (("kind: slide", "'': 1\nkind: slide"), 1, r"^task.yaml:1: '': unknown field"),
    (
        ("x: 0.60", "x: 100000"),
        9,
        r"object.pose: \{'x': 100000.0, .*\}: must be a rigid pose within 1e4 m",
    ),
    (
        ("height: 0.0", "height: 0.0\n  usable_edges: [4294967296]"),
        13,
        r"usable_edges\[0\]: 4294967296: .*less",
    ),
    (
        more(
            "obstacles: [{name: a, vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0]], triangles: [[0, 1, 4294967298]]}]"
        ),
        13,
        r"obstacles\[0\].triangles\[0\]\[2\]: 4294967298: should be less",
    ),
    ((HOME, "home: no"), 4, r"robot.home: false: .*put text in quotes"),
    (("name: card", "name: 1e3"), 6, r"object.name: 1000.0: .*put text .*in quotes"),
    (("0.004", "yes"), 8, r"object.thickness: true: should be a valid number"),
    (("0.004", "-0.004"), 8, r"object.thickness: -0.004: should be greater than 0"),
    ((CARD, "polygon: [[0, 0], [0.1, 0]]"), 7, r"object.polygon: .*at least 3 items"),
    ((CARD, "polygon: [[0, 0, 0], [1, 0], [0, 1]]"), 7, r"object.polygon\[0\]: .*at most 2"),
    ((CARD, "polygon: [[0, 0], [1, 1], [1, 0], [0, 1]]"), 7, r"object.polygon: .*outline"),
    ((TABLE, "polygon: [[0, 0], [1, 1], [1, 0], [0, 1]]"), 11, r"support.polygon: .*support"),
    ((CARD, "polygon: [[.nan, 0], [1, 0], [0, 1]]"), 7, r"polygon\[0\]\[0\]: nan: .*finite"),
    ((f"{CARD}\n", "\n"), 5, r"object: exactly one of polygon, .* must be given, not none"),
    ((CARD, f"{CARD}\n  circle: {{radius: 1}}"), 5, r"not rectangle and circle"),
    (("  thickness: 0.004\n", ""), 5, r"object: thickness must be given"),
    ((f"  pose: {POSE}\n", ""), 5, r"object: pose must be given"),
    ((POSE, "[0.6, 0.1]"), 9, r"object.pose: \[0.6, 0.1\]: should be a mapping with .*yaw"),
    (("x: 0.60", "x: 3.0"), 9, r"object.pose: .*off the support"),
    (("wam_t42", "wam_t43"), 3, r"robot.urdf: wam_t43: no such file, nor .*kr5_t42"),
    ((HOME, f"{HOME}\n  pose: {{position: [1.0e9, 0, 0]}}"), 5, r"robot.pose: must be .* 1e4 m"),
    (("height: 0.0", "height: 0.0\n  friction: 30"), 13, r"support.friction: .*"),
    (
        ("joint_2", "joint_9"),
        4,
        r"robot.home.wam_joint_9: .*: unknown joint 'wam_joint_9'; choose from wam_joint_1",
    ),
    (("wam_joint_4: 1.6", "wam_joint_4: 9"), 4, r"robot.home: .*wam_joint_4.*limits"),
    ((HOME, "home: sleeping"), 4, r"robot.home: sleeping: .*open"),
    ((HOME, "home: [0, 0]"), 4, r"robot.home: .*2 values"),
    (("height: 0.0", "height: 0.0\n  pose: {}"), 10, r"support: at most one of height"),
    (("height: 0.0", "pose: {rpy: [0, 1.5, 0]}"), 10, r"support: .*tilted"),
    (("height: 0.0", "pose: {quaternion: [1, 1, 0, 0]}"), 12, r"support.pose: .*length 1.414"),
    (("seconds: 20", "seconds: -1"), 13, r"budget.seconds: -1: should be greater than 0"),
    (("seed: 3", "seed: -3"), 13, r"budget.seed: -3: should be greater than or equal to 0"),
    (more("options: {search: best}"), 13, r"options.search: best: .*'paper'"),
    (more("options: {range: -0.1}"), 13, r"options.range: -0.1: .*greater"),
    (more("options: {range: 7}"), 13, r"options.range: 7: should be less than or equal to 1"),
    (more("options:\n  min_depth: 0.03\n  max_depth: 0.01"), 14, r"options.min_depth: 0.03: "),
    (more("options:\n  min_depth: 0.03"), 14, r"options.min_depth: 0.03: .*max_depth 0.025"),
    (more("hand: {fingertip: thumb}"), 13, r"hand.fingertip: thumb: .*left_fingertip"),
    (more("hand: {arm: leg}"), 13, r"hand.arm: leg: .*arm"),
    (more("hand: {open: wide}"), 13, r"hand.open: wide: .*open"),
    (more("hand: my.hand.yaml"), 13, r"hand: my.hand.yaml: no such file"),
    (more("obstacles: [{name: a, mesh: {file: b.stl}}]"), 13, r"mesh.file: b.stl: no such file"),
    (
        more("obstacles: [{name: a, box: [1, 1, 1], sphere: {radius: 1}}]"),
        13,
        r"obstacles\[0\]: exactly one of .* not box and sphere",
    ),
    (
        more("obstacles: [{name: left_finger, box: [1, 1, 1]}]"),
        13,
        r"obstacles\[0\].name: left_finger: is taken by a link",
    ),
    (
        more(
            "obstacles:\n- {name: a, box: [1, 1, 1]}\n"
            "- {name: b, box: [1, 1, 1], pose: {position: [1.0e5, 0, 0]}}"
        ),
        15,
        r"obstacles\[1\].pose: must be a rigid pose",
    ),
    (("height: 0.0", "height: 1.0e5"), 12, r"support.height: 100000.0: must be within 10000 m"),
    (
        ("height: 0.0", "pose: {position: [0, 1.0e5, 0]}"),
        12,
        r"support.pose: must be within 10000 m",
    ),
    (
        more("obstacles: [{name: a, box: [1, 1, 1]}, {name: a, box: [1, 1, 1]}]"),
        13,
        r"obstacles: name given twice: a",
    ),
    (
        ("thickness: 0.004", "thickness: 0.1"),
        8,
        r"object.thickness: 0.1: object 'card' is not thin",
    ),
    (("yaw: 0.3", "yaw: null"), 9, r"object.pose.yaw: null: should be a valid number"),
    ((OUTLINE, "cloud: scan.ply"), 7, r"object.cloud: scan.ply: no such file"),
    (more("obstacles: [{name: a, mesh: {file: /tmp}}]"), 13, r"mesh.file: /tmp: is a folder"),
    (more("hand: /tmp"), 13, r"hand: /tmp: is a folder"),
    (
        more("obstacles: [{name: a, mesh: {file: a.stl, scale: 0}}]"),
        13,
        r"obstacles\[0\].mesh.scale: 0: should be greater than 0$",
    ),
    ((OUTLINE, "cloud: scan.e57"), 7, r"object.cloud: scan.e57: .*one of: .ply, .pcd, .xyz, .npy"),
    (("kind: slide", "kind: slide\nkind: slide"), 2, r"kind: given twice"),
    (("kind: slide", "kind: [slide"), 2, r"not valid YAML: .* \(column 6\)"),
    (
        ("  urdf: wam_t42", "\turdf: wam_t42"),
        3,
        r"not valid YAML: a tab .* spaces alone \(column 1\)",
    ),
]


@pytest.mark.parametrize(("change", "line", "what"), FAULTS)
def test_fault_says_file_line_field_value_and_choice(write, change, line, what):
    message = fault(write(changed(*change)))
    assert re.match(rf"task\.yaml:{line}: ", message), message
    assert re.search(what, message), message
    assert "\n" not in message


def test_a_missing_file_is_named_whole(write):
    name = f"{'/'.join(['a_long_folder'] * 8)}/b.stl"
    message = fault(write(changed(*more(f"obstacles: [{{name: a, mesh: {{file: {name}}}}}]"))))
    assert message == f"task.yaml:13: obstacles[0].mesh.file: {name}: no such file"


POINTER = "version https://git-lfs.github.com/spec/v1\noid sha256:4d7a\nsize 12345\n"


@pytest.mark.parametrize(
    ("field", "text"),
    [
        (r"obstacles\[0\]", changed(*more("obstacles: [{name: a, mesh: {file: a.stl}}]"))),
        ("object", changed("box: [0.05, 0.10, 0.05]", "mesh: {file: a.stl}", PUSH)),
        ("object", "kind: clasp\nrobot: {urdf: kr5_icub}\nobject: {mesh: {file: a.stl}}\n"),
    ],
)
def test_a_pointer_of_git_lfs_is_no_mesh(write, tmp_path, field, text):
    (tmp_path / "a.stl").write_text(POINTER)
    message = fault(write(text))
    assert re.search(rf"{field}.*: mesh 'a.stl' is a Git LFS pointer, .*'git lfs pull'", message)


def test_a_mesh_of_a_robot_that_is_a_pointer_of_git_lfs(write, tmp_path):
    mesh = write_robot_with_mesh(tmp_path)
    mesh.write_text(POINTER)
    text = changed("urdf: wam_t42", "urdf: arm.urdf")
    graspless.load_task(write(text))  # it is drawn only
    urdf = (tmp_path / "arm.urdf").read_text()
    drawn = re.search(r"<visual>(<geometry><mesh .*?</geometry>)</visual>", urdf)
    collision = f"{drawn[0]}<collision>{drawn[1]}</collision>"
    (tmp_path / "arm.urdf").write_text(urdf.replace(drawn[0], collision))
    what = r"robot.urdf: arm.urdf: mesh 'part.stl' is a Git LFS pointer, .*'git lfs pull'"
    assert re.search(what, fault(write(text)))


def test_a_mesh_that_states_too_many_triangles_is_not_read(write, tmp_path, monkeypatch):
    count = 200_001
    header = b"\0" * 80 + struct.pack("<I", count)
    (tmp_path / "a.stl").write_bytes(header + bytes(50 * count))
    monkeypatch.setattr(geometry, "read_mesh", None)
    message = fault(write(changed("box: [0.05, 0.10, 0.05]", "mesh: {file: a.stl}", PUSH)))
    assert message.endswith("mesh 'a.stl' must have at most 200000 triangles, not 200001")


def test_a_translation_in_millimetres_is_warned_of(write):
    given, far = "translation: [0.05, 0, 0]", "translation: [100, 0, 0]"
    told = r"translation\[0\]: 100: is more than 5 m; lengths are in metres"
    with pytest.warns(UserWarning, match=told):
        graspless.load_task(write(changed(given, far, PUSH)))


def test_says_all_faults_at_once(write):
    message = fault(write(changed("0.004", "-1", changed("seed: 3", "seed: no"))))
    assert [line.split(": ")[0] for line in message.splitlines()] == ["task.yaml:8", "task.yaml:13"]


def test_missing_file(tmp_path):
    assert fault(tmp_path / "none.yaml") == "none.yaml: cannot be read: No such file or directory"


@pytest.mark.parametrize("text", ["", "- a\n- b\n", "slide"])
def test_no_mapping(write, text):
    assert "should be a mapping" in fault(write(text))


@pytest.mark.parametrize(
    ("old", "new", "what"),
    [
        ("</robot>", "", "urdf"),
        ('<limit lower="-2.6" upper="2.6" velocity="2" effort="77"/>', "", "wam_joint_1"),
        ('<parent link="base_link"/>', '<parent link="flange"/>', "cycle|root|tree"),
        ('<parent link="base_link"/>', '<parent link="nowhere"/>', "nowhere"),
        (
            '<geometry><box size="0.28 0.36 0.158"/></geometry></collision>',
            '<geometry><mesh filename="none.stl"/></geometry></collision>',
            "none.stl",
        ),
    ],
)
def test_broken_urdf(write, tmp_path, old, new, what):
    text = _data.robot("wam_t42").read_text()
    assert old in text
    write(text.replace(old, new, 1), "my.urdf")
    for suffix in (".srdf", ".hand.yaml"):
        shutil.copy(_data.directory("urdf") / f"wam_t42{suffix}", tmp_path / f"my{suffix}")
    message = fault(write(changed("wam_t42", "my.urdf")))
    assert message.startswith("task.yaml:3: robot.urdf: my.urdf: ")
    assert re.search(what, message, re.IGNORECASE), message


@pytest.mark.parametrize("kind", ["slide", "pinch"])
@pytest.mark.parametrize("name", ["object", "support"])
def test_link_with_the_name_of_another_body(write, tmp_path, capsys, kind, name):
    write_renamed(tmp_path, "wam_t42", "wam_link_3", name)
    path = write(changed("wam_t42", "my.urdf").replace("kind: slide", f"kind: {kind}"))
    code, _, said = run(capsys, "plan", str(path), "-o", str(tmp_path / "plan.json"))
    assert code == 2
    what = f"link '{name}' has the name of another body of the plan: rename it in the URDF"
    assert f"task.yaml:3: robot.urdf: my.urdf: {what}" in said


def test_link_without_shapes_may_have_the_name_of_a_body(write, tmp_path):
    write_renamed(tmp_path, "wam_t42", "flange", "object")
    assert graspless.load_task(write(changed("wam_t42", "my.urdf")))


def test_fault_in_the_hand_file_names_that_file(write, tmp_path):
    for suffix in (".urdf", ".srdf"):
        shutil.copy(_data.directory("urdf") / f"wam_t42{suffix}", tmp_path / f"my{suffix}")
    write("arm: arm\ntip_radius: -1\n", "my.hand.yaml")
    path = write(changed("wam_t42", "my.urdf"))
    assert fault(path).startswith("my.hand.yaml:2: tip_radius: -1: should be greater")
    write("finger_model: none\nfingertip: thumb\n", "my.hand.yaml")
    assert fault(path).startswith("my.hand.yaml:2: fingertip: thumb: ")


def test_robot_without_srdf_or_hand_file_gets_a_proposal(write, tmp_path):
    urdf = _data.directory("urdf")
    shutil.copy(urdf / "wam_t42.urdf", tmp_path / "bare.urdf")
    path = write(changed("wam_t42", "bare.urdf"))
    with pytest.warns(UserWarning, match=r"task.yaml:2: robot: no SRDF and no description of"):
        task = graspless.load_task(path)
    assert task.problem.hand.finger_model != slide.FingerModel.flexure  # of another hand
    srdf = (urdf / "wam_t42.srdf").read_text().replace('"arm"', '"my_arm"')
    (tmp_path / "bare.srdf").write_text(srdf)
    with pytest.warns(UserWarning, match=r"robot: no description of the hand: proposed"):
        robot = graspless.load_task(path).problem.robot
    assert robot.group("arm") == robot.group("my_arm")


def test_warnings_point_at_the_line_that_called(write, tmp_path):
    shutil.copy(_data.directory("urdf") / "wam_t42.urdf", tmp_path / "bare.urdf")
    text = changed("yaw: 0.3", "yaw: 90", changed("wam_t42", str(tmp_path / "bare.urdf")))
    path = write(text)
    document = parse_yaml(text, "task").data
    for call in (
        lambda: graspless.load_task(path),
        lambda: graspless.plan(path, iterations=0),
        lambda: graspless.plan(document, iterations=0),
    ):
        with warnings.catch_warnings(record=True) as caught:
            warnings.simplefilter("always")
            call()
        assert len(caught) == 2  # of the yaw, and of what was proposed
        assert {warning.filename for warning in caught} == {__file__}


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ((CARD, "rectangle: {size: [100, 80]}"), ":7: object.rectangle: is 100 x 80 m; lengths"),
        ((CARD, "circle: {radius: 50}"), ":7: object.circle: is 100 x 100 m; lengths"),
        (("thickness: 0.004", "thickness: 8"), ":8: object.thickness: 8: is 8 m; lengths are in m"),
        ((TABLE, "rectangle: {size: [700, 700]}"), ":11: support.rectangle: is 700 x 700 m;"),
        (
            ("yaw: 0.3", "yaw: 90"),
            ":9: object.pose.yaw: 90: is more than a turn; angles are in rad",
        ),
        (
            ("budget:", "end: {x: 0.7, y: 0, yaw: 90}\nbudget:"),
            ":13: end.yaw: 90: is more than a turn",
        ),
        (("height: 0.0", "pose: {rpy: [0, 0, 360]}"), r"support.pose.rpy\[2\]: 360: is more than"),
    ],
)
def test_millimetres_and_degrees_are_warned_of(write, change, what):
    path = write(changed(*change))
    with pytest.warns(UserWarning, match=what), contextlib.suppress(TaskError):
        graspless.load_task(path)


@pytest.mark.parametrize(("name", "kind"), [("off", "true or false"), ("1", "a number")])
def test_name_that_yaml_takes_for_a_value(write, name, kind):
    path = write(changed("urdf: wam_t42", f"urdf: wam_t42\n  xacro_args: {{{name}: 1}}"))
    assert fault(path) == (
        f"task.yaml:4: robot.xacro_args.{name}: YAML takes this name for {kind}; put it in quotes"
    )


def test_a_decimal_with_a_comma(write):
    path = write(changed(POSE, "{x: 0,60, y: 0.10, yaw: 0.3}"))
    assert fault(path) == "task.yaml:9: object.pose.x: 0,60: decimals have a point"


def test_clockwise_polygon_is_accepted(write):
    clockwise = "polygon: [[0.05, 0], [-0.05, -0.04], [-0.05, 0.04]]"
    outline = graspless.load_task(write(changed(CARD, clockwise))).problem.object.outline
    assert outline.area == pytest.approx(0.004)


def test_numbers_as_people_write_them(write):
    task = graspless.load_task(write(changed(POSE, "{x: +.5, y: -.2, yaw: -.3e-1}")))
    assert task.fields.object.pose.model_dump() == {"x": 0.5, "y": -0.2, "yaw": -0.03}
    task = graspless.load_task(write(changed("0.004", "4e-3")))
    assert task.problem.object.thickness == 0.004


@pytest.mark.parametrize(
    ("number", "what"),
    [
        ("010", "YAML reads this as 8; write 10, or put text in quotes"),
        ("-0017", "YAML reads this as -15; write -17, or put text in quotes"),
        ("0_7", "YAML reads this as 7; write 7, or put text in quotes"),
        ("0_", "YAML reads this as 0; write 0, or put text in quotes"),
        ("1:30", "YAML reads this as 90; write minutes and seconds as one number, or put text in"),
        ("1:30.5", "YAML reads this as 90.5; write minutes"),
    ],
)
def test_numbers_that_yaml_takes_for_others_are_refused(write, number, what):
    told = fault(write(changed("0.004", number)))
    assert told.startswith(f"task.yaml:8: object.thickness: {number}: {what}")


def test_decimals_and_hexadecimals_are_read_as_before():
    text = "{a: 0, b: -0, c: 1_000, d: 0.10, e: 0x10, f: '010', g: '1:30'}"
    read = {"a": 0, "b": 0, "c": 1000, "d": 0.1, "e": 16, "f": "010", "g": "1:30"}
    assert parse_yaml(text, "a.yaml").data == read


def test_circle_has_as_many_corners_as_asked(write):
    task = graspless.load_task(write(changed(CARD, "circle: {radius: 0.05, points: 12}")))
    assert len(task.problem.object.outline.vertices) == 12


def test_mass_distribution_gives_mass_and_center(write):
    masses = "masses: [{position: [0, 0, 0], mass: 1}, {position: [0.02, 0.01, 0], mass: 3}]"
    task = graspless.load_task(write(changed("thickness: 0.004", f"thickness: 0.004\n  {masses}")))
    np.testing.assert_allclose(task.problem.object.com, [0.015, 0.0075, 0.0], atol=1e-15)
    assert task.problem.object.mass == 4
    other = f"thickness: 0.004\n  {masses}\n  mass: 3"
    wrong = fault(write(changed("thickness: 0.004", other)))
    assert "task.yaml:10: object.mass: 3: should be 4, the sum of masses" in wrong


def test_center_of_mass_in_the_plane_keeps_its_height(write):
    task = graspless.load_task(
        write(changed("thickness: 0.004", "thickness: 0.004\n  com: [0.01, 0]\n  mass: 0.2"))
    )
    np.testing.assert_allclose(task.problem.object.com, [0.01, 0.0, 0.002])
    assert task.problem.object.mass == 0.2


def test_every_shape_of_obstacle(write, tmp_path):
    import trimesh

    trimesh.creation.box([0.1, 0.1, 0.1]).export(tmp_path / "box.stl")
    text = changed(
        "budget:",
        """obstacles:
  - {name: a, box: [0.1, 0.1, 0.1], pose: {position: [1.5, 0, 0.1]}}
  - {name: b, sphere: {radius: 0.1}, pose: {position: [1.5, 0, 0.1], rpy: [0, 0, 1]}}
  - {name: c, capsule: {radius: 0.1, length: 0.2}, pose: {position: [1.5, 0, 0.1]}}
  - {name: d, cylinder: {radius: 0.1, length: 0.2}, pose: {quaternion: [0, 1, 0, 0]}}
  - {name: e, mesh: {file: box.stl, scale: [1, 1, 2]}, pose: {position: [1.5, 0, 0.1]}}
budget:""",
    )
    task = graspless.load_task(write(text))
    assert [obstacle.name for obstacle in task.problem.obstacles] == list("abcde")
    cylinder = task.problem.obstacles[3].shapes[0].shape
    middles = (cylinder.vertices[:24, :2] + np.roll(cylinder.vertices[:24, :2], 1, axis=0)) / 2
    np.testing.assert_allclose(np.linalg.norm(middles, axis=1), 0.1)  # none of it is left out
    assert list(task.fields.files) == [str(tmp_path / "box.stl")]


def test_xacro_is_expanded_with_its_arguments(write, tmp_path):
    body = _data.robot("wam_t42").read_text()
    head = '<robot name="wam_t42" xmlns:xacro="http://www.ros.org/wiki/xacro">'
    body = body.replace('<robot name="wam_t42">', head + '<xacro:arg name="reach" default="0.5"/>')
    body = body.replace('lower="-2.6" upper="2.6"', 'lower="-$(arg reach)" upper="$(arg reach)"')
    write(body, "my.urdf.xacro")
    for suffix in (".srdf", ".hand.yaml"):
        shutil.copy(_data.directory("urdf") / f"wam_t42{suffix}", tmp_path / f"my{suffix}")
    path = write(changed("urdf: wam_t42", "urdf: my.urdf.xacro\n  xacro_args: {reach: 1.25}"))
    task = graspless.load_task(path)
    assert task.problem.robot.upper[0] == 1.25
    assert task.fields.hand.fingertip == "left_fingertip"
    write(body.replace("$(arg reach)", "$(arg none)"), "my.urdf.xacro")
    assert fault(path).startswith("task.yaml:3: robot.urdf: my.urdf.xacro: xacro cannot expand it")


def grid(height=0.004, n=12, spacing=0.006):
    x, y = np.meshgrid(np.arange(n), np.arange(n))
    flat = spacing * np.column_stack([x.ravel(), y.ravel()])
    return np.column_stack([flat - flat.mean(axis=0), np.full(n * n, height)])


def write_ply(path, points, binary):
    kind = "binary_little_endian" if binary else "ascii"
    axes = "".join(f"property float {axis}\n" for axis in "xyz")
    head = f"ply\nformat {kind} 1.0\nelement vertex {len(points)}\n{axes}end_header\n"
    rows = struct.pack(f"<{points.size}f", *points.ravel()) if binary else None
    text = "\n".join(" ".join(map(str, row)) for row in points) + "\n"
    path.write_bytes(head.encode() + (rows if binary else text.encode()))


def write_pcd(path, points, data):
    from pypcd4 import Encoding, PointCloud

    PointCloud.from_xyz_points(points.astype(np.float32)).save(path, encoding=Encoding(data))


CLOUDS = {
    "ascii.ply": lambda path, p: write_ply(path, p, False),
    "binary.ply": lambda path, p: write_ply(path, p, True),
    "plain.xyz": lambda path, p: np.savetxt(path, p),
    "colours.xyz": lambda path, p: np.savetxt(path, np.hstack([p, p]), header="x y z r g b"),
    "plain.npy": np.save,
    "organised.npy": lambda path, p: np.save(path, p.reshape(12, 12, 3)),
    "ascii.pcd": lambda path, p: write_pcd(path, p, "ascii"),
    "binary.pcd": lambda path, p: write_pcd(path, p, "binary"),
    "compressed.pcd": lambda path, p: write_pcd(path, p, "binary_compressed"),
}


@pytest.mark.parametrize("name", CLOUDS)
def test_reads_every_kind_of_cloud(tmp_path, name):
    points = grid()
    CLOUDS[name](tmp_path / name, points)
    np.testing.assert_allclose(read_cloud(tmp_path / name), points, atol=1e-7)


@pytest.mark.parametrize("name", CLOUDS)
def test_points_that_are_not_finite_are_left_out(tmp_path, name):
    """Organised clouds of depth cameras have NaN where a pixel measured nothing."""
    CLOUDS[name](tmp_path / name, np.where(np.eye(144, 3) > 0, np.nan, grid()))
    with pytest.warns(UserWarning, match=f"{name}: 3 of 144 points are not finite"):
        points = read_cloud(tmp_path / name)
    np.testing.assert_allclose(points, grid()[3:], atol=1e-7)


@pytest.mark.parametrize(
    ("name", "what"),
    [
        ("ascii.ply", r"its header states 144 rows \(144 vertex\), but {rows} follow"),
        ("ascii.pcd", "POINTS is 144, but {rows} rows follow"),
    ],
)
@pytest.mark.parametrize("rows", [100, 143, 145])
def test_ascii_clouds_have_as_many_rows_as_they_state(tmp_path, name, what, rows):
    CLOUDS[name](tmp_path / name, grid())
    lines = (tmp_path / name).read_text().splitlines()
    lines = lines[:-144] + (lines[-144:] * 2)[:rows]
    (tmp_path / name).write_text("\n".join(lines))
    with pytest.raises(ValueError, match=what.format(rows=rows)):
        read_cloud(tmp_path / name)


def test_binary_ply_of_another_length(tmp_path):
    CLOUDS["binary.ply"](tmp_path / "a.ply", grid())
    (tmp_path / "a.ply").write_bytes((tmp_path / "a.ply").read_bytes()[:-1])
    with pytest.raises(
        ValueError, match=r"the \d+ bytes after its header are not .* \(144 vertex\)"
    ):
        read_cloud(tmp_path / "a.ply")


@pytest.mark.parametrize(
    "line", ["1,2,3", "1, 2, 3", "1 ,2 ,3,", "1\t2 3", "1,2,3,4,5,6 # colours"]
)
def test_numbers_of_xyz_are_separated_by_spaces_or_commas(write, tmp_path, line):
    write(f"{line}\n", "a.xyz")
    np.testing.assert_array_equal(read_cloud(tmp_path / "a.xyz"), [[1, 2, 3]])


@pytest.mark.parametrize("line", ["0,587 0,123 -0,02", "0,5, 0,1, 2,0", "1,2,3 255 0 0"])
def test_decimal_commas_are_refused(write, tmp_path, line):
    write(f"# x y z\n{line}\n", "a.xyz")
    with pytest.raises(ValueError, match=f"line 2 separates .* decimals have a point: {line}"):
        read_cloud(tmp_path / "a.xyz")


def test_xyz_without_a_coordinate_between_commas(write, tmp_path):
    write("1,,3,4\n", "a.xyz")
    with pytest.raises(ValueError, match="line 1 must have three numbers"):
        read_cloud(tmp_path / "a.xyz")


def test_ply_with_faces_gives_its_vertices(tmp_path):
    import trimesh

    box = trimesh.creation.box([0.1, 0.1, 0.004])
    box.export(tmp_path / "box.ply")
    points = read_cloud(tmp_path / "box.ply")
    np.testing.assert_allclose(np.unique(points, axis=0), np.unique(box.vertices, axis=0))


def cloud_task(name, more=""):
    return changed(OUTLINE, f"cloud: {name}{more}")


def test_cloud_in_the_object_frame(write, tmp_path):
    np.savetxt(tmp_path / "a.xyz", grid())
    task = graspless.load_task(write(cloud_task("a.xyz")))
    assert task.problem.object.thickness == pytest.approx(0.004)
    assert task.fields.object.points is not None


def test_cloud_in_the_world_says_where_it_lies(write, tmp_path):
    X_WS = frames.translation([0.1, 0.2, 0.3]) @ frames.from_rpy([0.1, 0.2, 0.3])
    p_SP = grid() + np.array([0.55, 0.05, 0.0])
    np.savetxt(tmp_path / "a.xyz", p_SP @ X_WS[:3, :3].T + X_WS[:3, 3])
    text = cloud_task("a.xyz", "\n  frame: world")
    text = changed("  pose: {x: 0.60, y: 0.10, yaw: 0.3}\n", "", text)
    text = changed("height: 0.0", "pose: {position: [0.1, 0.2, 0.3], rpy: [0.1, 0.2, 0.3]}", text)
    problem = graspless.load_task(write(text)).problem
    expected = X_WS @ frames.translation([0.55, 0.05, 0.0])
    np.testing.assert_allclose(problem.X_WO_start, expected, atol=1e-9)
    assert problem.object.thickness == pytest.approx(0.004)


def test_cloud_in_the_world_takes_no_pose(write, tmp_path):
    np.savetxt(tmp_path / "a.xyz", grid())
    message = fault(write(cloud_task("a.xyz", "\n  frame: world")))
    assert message.startswith("task.yaml:5: object: pose must not be given")


@pytest.mark.parametrize(
    ("points", "what"),
    [
        (np.full((144, 3), np.nan), "144 of 144 points are not finite"),
        (np.empty((0, 3)), "is empty"),
        (np.random.default_rng(1).uniform(-0.05, 0.05, (300, 3)), "thin"),
        (grid()[:2], "at least 3"),
    ],
)
@pytest.mark.parametrize("kind", ["ascii.ply", "plain.xyz"])
@pytest.mark.filterwarnings("ignore:.*no data.*:UserWarning")
def test_cloud_that_cannot_be_slid(write, tmp_path, points, what, kind):
    CLOUDS[kind](tmp_path / kind, points)
    message = fault(write(cloud_task(kind)))
    assert message.startswith(f"task.yaml:7: object.cloud: {kind}: ")
    assert what in message


def test_broken_clouds(write, tmp_path):
    write("ply\nformat ascii 1.0\nelement vertex 3\n", "a.ply")
    write("# .PCD v0.7\nVERSION", "a.pcd")
    write("1 2 x\n", "a.xyz")
    write("no array", "a.npy")
    np.save(tmp_path / "flat.npy", np.ones(9))
    np.save(tmp_path / "colours.npy", np.ones((9, 6)))
    np.save(tmp_path / "words.npy", np.full((9, 3), "a"))
    np.save(tmp_path / "picture.npy", np.ones((9, 9, 3), np.uint8))
    for name in (
        "a.ply",
        "a.pcd",
        "a.xyz",
        "a.npy",
        "flat.npy",
        "colours.npy",
        "words.npy",
        "picture.npy",
    ):
        message = fault(write(cloud_task(name)))
        assert message.startswith(f"task.yaml:7: object.cloud: {name}: cannot be read"), message


PCD = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 {}\nWIDTH {}\nPOINTS {}\nDATA {}\n"


@pytest.mark.parametrize(
    ("count", "points", "data", "what"),
    [
        (4_000_000_000, 1, "ascii", "COUNT has 4000000002 values a point, but the file only 1"),
        (4_000_000_000, 0, "binary", "COUNT has 4000000002 values a point, but the file only 1"),
        (1, 4_000_000_000, "ascii", "POINTS is 4000000000, which takes at least 24000000000 byte"),
        (1, 4_000_000_000, "binary", "POINTS is 4000000000, which takes at least 48000000000 byte"),
        (1, 2, "binary_compressed", "states 858982960 bytes of points, packed in 12 bytes"),
    ],
)
def test_pcd_that_states_more_than_it_holds(write, count, points, data, what):
    write(PCD.format(count, points, points, data) + "0 0 0\n333333", "a.pcd")
    message = fault(write(cloud_task("a.pcd")))
    assert f"object.cloud: a.pcd: cannot be read as a point cloud: {what}" in message


@pytest.mark.parametrize(
    "header",
    [
        "property float x\n",
        "element vertex 4000000000\nproperty float x\n",
        "element vertex 1\nproperty list uint int x\n",
    ],
)
@pytest.mark.parametrize("code", ["ascii", "binary_little_endian"])
def test_ply_that_states_more_than_it_holds(write, header, code):
    write(f"ply\nformat {code} 1.0\n{header}end_header\n44444444444 1", "a.ply")
    assert "object.cloud: a.ply: cannot be read as a point cloud" in fault(
        write(cloud_task("a.ply"))
    )


def test_millimetres_are_told_and_can_be_said(write, tmp_path):
    np.savetxt(tmp_path / "a.xyz", 1000 * grid(n=20, spacing=0.15))
    with pytest.warns(UserWarning, match=r"task.yaml:7: object.cloud: a.xyz: is 2850 x .*unit: mm"):
        graspless.load_task(write(cloud_task("a.xyz")))
    np.savetxt(tmp_path / "a.xyz", 1000 * grid())
    task = graspless.load_task(write(cloud_task("a.xyz", "\n  unit: mm")))
    assert task.problem.object.thickness == pytest.approx(0.004)


def test_task_of_a_plan_needs_no_other_file(write):
    task = graspless.load_task(write(GOOD))
    again = task_from_dict(task.to_dict(), "plan.json")
    assert again.to_dict() == task.to_dict()
    np.testing.assert_array_equal(again.problem.q_home, task.problem.q_home)
    np.testing.assert_array_equal(again.problem.X_WO_start, task.problem.X_WO_start)
    document = task.to_dict() | {"robot": {"urdf": "wam_t42"}}
    with pytest.raises(TaskError, match=r"plan.json: robot.urdf: .*must be part of the plan file"):
        task_from_dict(document, "plan.json")


def test_changed_mesh_is_noticed(write, tmp_path):
    import trimesh

    trimesh.creation.box([0.1, 0.1, 0.1]).export(tmp_path / "box.stl")
    obstacle = "obstacles: [{name: e, mesh: {file: box.stl}, pose: {position: [2, 0, 0]}}]\nbudget:"
    document = graspless.load_task(write(changed("budget:", obstacle))).to_dict()
    trimesh.creation.box([0.2, 0.1, 0.1]).export(tmp_path / "box.stl")
    with pytest.raises(TaskError, match=r"box.stl: has changed since"):
        task_from_dict(document, "plan.json")
    (tmp_path / "box.stl").unlink()
    with pytest.raises(TaskError, match=r"box.stl: no such file"):
        task_from_dict(document, "plan.json")
    document["obstacles"][0]["mesh"]["file"] = "/nope/mug.stl"
    what = r"^plan.json: obstacles\[0\].mesh.file: /nope/mug.stl: is not in task.files$"
    with pytest.raises(TaskError, match=what):
        task_from_dict(document, "plan.json")


def test_changes_of_the_search(write):
    task = graspless.load_task(write(GOOD))
    other = task.with_changes(search="paper", seconds=2.5, iterations=7, seed=9)
    assert (other.options.search, other.budget.seconds) == (slide.Search.paper, 2.5)
    assert (other.budget.iterations, other.seed) == (7, 9)
    assert task.seed == 3
    with pytest.raises(TaskError, match="seconds"):
        task.with_changes(seconds=-1)


def test_a_task_keeps_the_options_that_it_was_made_with(write):
    task = graspless.load_task(write(GOOD))
    options = task.options
    options.lift_height = 0.3
    other = graspless.Task.of(task.problem, options)
    options.lift_height = 0.2
    assert (task.options.lift_height, other.options.lift_height) == (0.08, 0.3)
    assert other.to_dict()["options"]["lift_height"] == 0.3
    with pytest.raises(AttributeError):
        task.options = options


@pytest.mark.parametrize("room", [slide, pinch, fingertip, clasp, carry])
def test_copies_of_options_are_whole(room):
    options = room.Options(max_memory=1e9)
    for name in ("compliance", "stability"):  # options within options
        if hasattr(options, name):
            inner = getattr(options, name)
            setattr(inner, inner.fields()[0].name, 3)
    for copied in (copy.copy(options), copy.deepcopy(options)):
        assert repr(copied) == repr(options) != repr(room.Options())
        copied.max_memory = 2e9
        assert options.max_memory == 1e9


def test_fields_of_a_hand_are_those_of_the_core():
    public = {name for name in dir(slide.Hand()) if not name.startswith("_")} - {"fields"}
    assert set(model.Hand.model_fields) == public | {"pitch"}


angles = st.floats(-math.pi, math.pi)
places = st.floats(-10, 10)


@given(st.tuples(angles, angles, angles), st.tuples(places, places, places))
def test_poses_survive_their_row(rpy, position):
    X = frames.translation(position) @ frames.from_rpy(rpy)
    np.testing.assert_allclose(frames.from_row(frames.to_row(X)), X, atol=1e-14 + 1e-15 * 10)
    np.testing.assert_allclose(X[:3, :3] @ X[:3, :3].T, np.eye(3), atol=1e-14)


def test_poses_may_be_lists():
    X = frames.translation([1, 2, 3]) @ frames.from_rpy([0.1, 0.2, 0.3])
    pose = X.tolist()
    np.testing.assert_allclose(frames.transform(pose, [[0, 0, 0]]), [[1, 2, 3]])
    np.testing.assert_allclose(frames.to_rpy(pose), [0.1, 0.2, 0.3])
    np.testing.assert_allclose(frames.between(np.eye(4).tolist(), pose, 0.5)[:3, 3], [0.5, 1, 1.5])
    np.testing.assert_allclose(frames.along([np.eye(4), X], [-1, 2]), [np.eye(4), X])
    assert frames.angle(pose, pose) == 0
    with pytest.raises(TaskError, match=r"rows: shape \(1, 6\): should be \(N, 7\)"):
        frames.from_row(pose[0] + [0, 0])


names = st.text("abc_", min_size=1, max_size=3)
values = st.recursive(
    st.integers(-5, 5) | st.booleans() | st.text("xyz: -#'\"", max_size=4),
    lambda inner: st.lists(inner, max_size=3) | st.dictionaries(names, inner, max_size=3),
    max_leaves=8,
)


@given(st.dictionaries(names, values, min_size=1, max_size=4))
def test_every_field_has_its_line(data):
    import yaml

    text = yaml.safe_dump(data, default_flow_style=False, sort_keys=False)
    source = parse_yaml(text, "a.yaml")
    assert source.data == data
    rows = text.splitlines()
    for location, line in source.lines.items():
        if location and isinstance(location[-1], str):
            assert f"{location[-1]}:" in rows[line - 1]


@given(st.text(max_size=200))
def test_no_text_breaks_the_reader(text):
    with pytest.raises(TaskError, match=r"^a\.yaml"):
        parse_yaml(text, "a.yaml").validate(model.SlideTask)


def test_a_long_path_is_shown_by_its_end():
    assert shorten("/home/me/" + 30 * "folder/" + "arm.urdf").endswith("folder/arm.urdf")
    assert shorten(50 * "word/ ").endswith("...")
