# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Tasks of several stages: read, planned, checked, written and read back."""

import json
import re
import sys
from pathlib import Path
from typing import Literal, get_args, get_origin

import numpy as np
import pytest
import trimesh
import yaml

import graspless
import inspect_common as small
from graspless import _data, frames, geometry, robot, slide
from graspless.chain import check
from graspless.chain.state import begins, ends
from graspless.kinds import part
from graspless.ros import work
from graspless.ros.jobs import TaskJob
from graspless.simulation import simulation_kind
from graspless.tasks.chain import lying, stages
from graspless.tasks.shapes import regular_polygon
from graspless.tasks.source import _models_in as models_in
from graspless.timing.squeeze import SECONDS, squeezed
from tasks_common import fault, reread, run, without_clock, write_robot_with_mesh

EXAMPLES = _data.directory("examples")

LIFT = """\
kind: chain
robot: {urdf: wam_t42}
object:
  name: card
  rectangle: {size: [0.12, 0.08]}
  thickness: 0.003
  pose: {x: 0.62, y: 0.08, yaw: 0.4}
support: {rectangle: {center: [0.65, 0.0], size: [0.7, 0.7]}, height: 0.0}
stages:
  - {name: to the edge, kind: slide}
  - {name: lift, kind: carry, line: {direction: [0, 0, 2], distance: 0.1}}
budget: {seconds: 20, seed: 1}
"""

TUMBLE = """\
kind: chain
object: {name: block, box: [0.04, 0.06, 0.08], mass: 0.3}
fingers: {radius: 0.008}
friction: 0.6
stages:
  - kind: fingertip
    motion: {tumble: {over: +x, segments: 12}}
    options: {min_stability: 0.2, locations_per_side: 5}
  - kind: fingertip
    motion: {slide: {translation: [0, 0.05, 0], segments: 6}}
    options: {min_stability: 0.2, locations_per_side: 5}
"""


def changed(old, new, text=LIFT):
    assert text.count(old) == 1, old
    return text.replace(old, new)


@pytest.fixture(scope="module")
def lift(tmp_path_factory):
    path = tmp_path_factory.mktemp("chain") / "task.yaml"
    path.write_text(LIFT)
    return graspless.plan(path)


@pytest.fixture(scope="module")
def tumble(tmp_path_factory):
    path = tmp_path_factory.mktemp("chain") / "task.yaml"
    path.write_text(TUMBLE)
    return graspless.plan(path)


@pytest.fixture
def document(lift):
    return json.loads(lift.to_json())


def test_lift_holds(lift):
    assert lift, lift.reason
    assert graspless.check(lift) == []
    assert [stage.kind for stage in lift.stages] == ["slide", "carry"]
    assert lift.names == ["to the edge", "lift"]
    assert [s.name for s in lift.segments][-2:] == ["close", "carry"]
    assert [join.how for join in lift.joins] == ["held"]


def test_lift_takes_the_object_up_and_nowhere_else(lift):
    slid, carried = (stage.segments[-1].object_poses for stage in lift.stages)
    assert np.abs(carried[0] - slid[-1]).max() < 1e-9
    rise = carried[:, :3, 3] - carried[0, :3, 3]
    assert np.abs(rise[-1] - [0, 0, 0.1]).max() < 1e-3
    assert np.abs(rise[:, :2]).max() < 1e-3
    assert np.abs(carried[:, :3, :3] - carried[0, :3, :3]).max() < 4e-3


def test_hand_keeps_the_object(lift):
    """The object's place in the hand is the same in all rows, by kinematics asked anew."""
    stage = lift.stages[1]
    robot, segment = stage.task.problem.robot, stage.segments[0]
    X_HO = [
        np.linalg.inv(robot.pose("grasp", q)) @ X
        for q, X in zip(segment.positions, segment.object_poses, strict=True)
    ]
    assert np.ptp(X_HO, axis=0).max() < 1e-9


def test_stages_stand_alone(lift, tmp_path):
    """Every stage is a plan of its kind, that is checked without the others."""
    for stage in lift.stages:
        alone = reread(json.loads(stage.to_json()), tmp_path / "stage.json")
        assert alone.kind == stage.kind
        assert graspless.check(alone) == []


def test_seeds_and_time_are_shared(lift):
    assert [stage.seed for stage in lift.stages] == [1, 2]
    assert [stage.task.budget.seconds for stage in lift.stages] == [20, 20]
    assert lift.statistics.attempts == 1


def test_written_and_read_back(lift, tumble, tmp_path):
    for plan in (lift, tumble):
        plan.save(tmp_path / "plan.json")
        again = graspless.load_plan(tmp_path / "plan.json")
        assert again.to_json() == plan.to_json()
        assert graspless.check(again) == []


OWN = ", obstacles: [{name: lamp, box: [0.05, 0.05, 0.3], pose: {position: [0.3, 0.9, 0]}}]}"


@pytest.mark.parametrize("obstacles", ["}", OWN])
def test_every_stage_lists_the_meshes_that_it_reads(tmp_path, write, obstacles):
    """The carry takes the robot, and unless it has its own the obstacles, of the stage before."""
    mesh = write_robot_with_mesh(tmp_path)
    post = tmp_path / "post.stl"
    trimesh.creation.box((0.05, 0.05, 0.3)).export(post)
    shape = (
        f"obstacles: [{{name: post, mesh: {{file: {post}}}, pose: {{position: [0.3, -0.9, 0]}}}}]"
    )
    text = changed("robot: {urdf: wam_t42}", f"robot: {{urdf: {tmp_path}/arm.urdf}}")
    text = changed("kind: slide}", f"kind: slide, {shape}}}", text)
    plan = graspless.plan(write(changed("distance: 0.1}}", "distance: 0.1}" + obstacles, text)))
    assert plan, plan.reason
    slid, carried = ({Path(name) for name in stage.task.fields.files} for stage in plan.stages)
    assert slid == {mesh, post}
    assert carried == ({mesh} if obstacles == OWN else {mesh, post})
    plan.save(tmp_path / "plan.json")
    assert graspless.check(tmp_path / "plan.json") == []
    mesh.write_bytes(b"other")
    with pytest.raises(graspless.TaskError, match="has changed since the plan was made"):
        graspless.load_plan(tmp_path / "plan.json")


def test_document_of_a_task_is_the_task(lift, tumble, write):
    stages = zip(graspless.plan(lift.task.to_dict()).stages, lift.stages, strict=True)
    assert all(without_clock(a) == without_clock(b) for a, b in stages)
    again = yaml.safe_dump(tumble.task.to_dict())  # in a task file, too
    assert graspless.load_task(write(again)) == tumble.task


def test_fingers_regrasp_between_stages(tumble):
    assert tumble, tumble.reason
    assert graspless.check(tumble) == []
    assert [join.how for join in tumble.joins] == ["regrasp"]
    first, second = tumble.stages
    assert np.abs(ends([first]).X_WO - begins(second)[1]).max() < 1e-9
    # Tumbled by 90 degrees about -y... the block's z looks along x now.
    assert np.abs(second.segments[0].X_WO[0][:3, 2] - [1, 0, 0]).max() < 1e-6


def test_same_as_one_sequence(tumble, write):
    """Two stages move the object as a sequence of both motions does."""
    text = TUMBLE.replace("kind: chain", "kind: fingertip").partition("stages:")[0]
    text += """\
motion:
  sequence:
    - tumble: {over: +x, segments: 12}
    - slide: {translation: [0, 0.05, 0], segments: 6}
options: {min_stability: 0.2, locations_per_side: 5}
"""
    path = graspless.load_task(write(text)).problem.motion.X_WO
    poses = [X for stage in tumble.stages for s in stage.segments for X in s.X_WO]
    assert np.abs(poses[0] - path[0]).max() < 1e-9
    assert np.abs(poses[-1] - path[-1]).max() < 1e-9


def test_first_stage_that_is_not_found_ends_the_chain(write):
    text = changed("distance: 0.1}", "distance: 3}")
    plan = graspless.plan(write(changed("budget:", "options: {attempts: 2}\nbudget:", text)))
    assert not plan
    assert plan.status == "not_found"
    assert plan.reason.startswith("lift: the arm follows only ")
    assert plan.statistics.attempts == 2
    assert [bool(stage) for stage in plan.stages] == [True, False]
    assert graspless.check(plan)[0].startswith("nothing to check")


def test_no_time_for_a_later_stage(write):
    plan = graspless.plan(graspless.load_task(write(LIFT)), seconds=1e-9)
    assert not plan
    assert plan.status in ("out_of_time", "not_connected", "no_start_root", "no_goal_root")


def test_where_a_stage_cannot_start(write):
    """A tumbled block hangs in the air for a second stage whose floor is lower."""
    plan = graspless.plan(write(TUMBLE + "    floor: {height: -0.02}\n"))
    assert plan.status == "not_joined"
    words = "fingertip: cannot start where 'fingertip' ended: "
    assert plan.reason.startswith(words)
    assert "stages[1].motion" in plan.reason
    assert [bool(stage) for stage in plan.stages] == [True]


@pytest.mark.parametrize(
    ("old", "new", "line", "words"),
    [
        ("stages:\n  - {name: to the edge, kind: slide}\n", "stages: []\n#", 9, "stages: "),
        ("kind: slide}", "kind: push}", 10, r"stages\[0\].kind: push: should be 'slide' or"),
        ("kind: slide}", "kind: slied}", 10, r"kind: slied: .*; did you mean 'slide'\?"),
        ("kind: slide}", "}", 10, r"stages\[0\].kind: missing"),
        ("kind: slide}", "kind: chain}", 10, "a chain holds no chain"),
        (
            "  - {name: to the edge, kind: slide}\n",
            "",
            10,
            r"stages\[0\].kind: carry: nothing is held",
        ),
        ("distance: 0.1}", "distance: 0}", 11, r"stages\[1\].line.distance: 0: should be greater"),
        ("distance: 0.1}", "distance: 2e4}", 11, r"distance: 20000.0: should be .* equal to 10000"),
        (
            "name: lift",
            "name: to the edge",
            10,
            r"stages\[0\].name: to the edge: another stage has",
        ),
        ("[0, 0, 2]", "[0, 0, 0]", 11, r"line.direction: \[0.0, 0.0, 0.0\]: must not be zero"),
        ("kind: slide}", "kind: slide, budget: {}}", 10, r"stages\[0\].budget: must not be given"),
        ("kind: slide}", "kind: slide, robott: {}}", 10, r"stages\[0\].robott: unknown field"),
        (
            "kind: slide}",
            "kind: slide, object: {name: tile}}",
            10,
            r"stages\[0\].object.name: tile: the chain's object has card",
        ),
        (
            "kind: carry, line: {direction: [0, 0, 2], distance: 0.1}",
            "kind: slide",
            11,
            r"stages\[1\].kind: slide: the hand holds the object after 'to the edge'",
        ),
        (
            "kind: carry, line",
            "kind: carry, pose: {}, line",
            11,
            r"stages\[1\].pose: must not be given: a stage starts where the one before",
        ),
        ("thickness: 0.003", "thicknes: 0.003", 6, "object.thicknes: unknown field"),
        ("[0.12, 0.08]", "[0.12, -0.08]", 5, r"object.rectangle.size\[1\]: -0.08"),
        ("budget:", "walls: []\nbudget:", 12, "walls: no stage of this chain has such a field"),
        ("budget:", "options: {attempts: 0}\nbudget:", 12, "options.attempts: 0: should be"),
        ("{x: 0.62, y", "{x: 5, y", 7, "object.pose"),
        (
            "distance: 0.1}}",
            "distance: 0.1}}\n  - {kind: carry, line: {direction: [1, 0, 0], distance: 0.1}, "
            "offset: [1, 0, 0]}",
            12,
            "exactly one of line, offset, goal, place must be given, not line and offset",
        ),
    ],
)
def test_fault_names_the_stage_and_the_field(write, old, new, line, words):
    said = fault(write(changed(old, new)))
    assert said.startswith(f"task.yaml:{line}: "), said
    assert re.search(words, said), said


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "    motion: {slide: {",
            "    motion: {slide: {pose: {position: [0, 0, 0.02]}, ",
            "stages[1].motion.slide.pose: must not be given",
        ),
        (
            "    motion: {slide: {translation: [0, 0.05, 0], segments: 6}}",
            "    object: {name: block, box: [0.04, 0.06, 0.07], mass: 0.3}\n"
            "    motion: {slide: {translation: [0, 0.05, 0], segments: 6}}",
            "stages[1].object: should be that of 'fingertip'",
        ),
        (
            "    motion: {slide: {translation: [0, 0.05, 0], segments: 6}}",
            "    robot: {urdf: wam_t42_tips}\n"
            "    motion: {slide: {translation: [0, 0.05, 0], segments: 6}}",
            "stages[1].robot: must not be given: 'fingertip', the stage before it, has none",
        ),
    ],
)
def test_stage_that_contradicts_the_one_before(write, old, new, words):
    assert words in fault(write(changed(old, new, TUMBLE)))


def test_stage_from_a_file(write, tmp_path):
    """A stage may stand in a task file of its own, with paths relative to it."""
    (tmp_path / "sub").mkdir()
    urdf = _data.robot("wam_t42")
    for path in urdf.parent.glob("wam_t42.*"):
        (tmp_path / "sub" / path.name).write_bytes(path.read_bytes())
    slide = (EXAMPLES / "01_slide_card.yaml").read_text()
    write(changed("urdf: wam_t42", "urdf: wam_t42.urdf", slide), "sub/slide.yaml")
    text = """\
kind: chain
stages:
  - {file: sub/slide.yaml}
  - {kind: carry, offset: [0, 0, 0.05]}
"""
    plan = graspless.plan(write(text), seed=1)
    assert plan, plan.reason
    assert graspless.check(plan) == []
    assert plan.task.fields.stages[0]["object"]["name"] == "card"
    missing = fault(write(text.replace("sub/slide", "sub/none")))
    assert "task.yaml:3: stages[0].file: sub/none.yaml: no such file" in missing
    folder = fault(write(text.replace("sub/slide.yaml", "sub")))
    assert "task.yaml:3: stages[0].file: sub: is a folder, not a file" in folder
    number = fault(write(text.replace("sub/slide.yaml", "3")))
    assert "task.yaml:3: stages[0].file: 3: should be the path of a task file" in number
    write(changed("thickness: 0.003", "thickness: -1", slide), "sub/slide.yaml")
    assert "sub/slide.yaml:10: object.thickness: -1: should be" in fault(write(text))
    write(changed("urdf: wam_t42", "urdf: wam_t4", slide), "sub/slide.yaml")
    typo = "robot.urdf: sub/wam_t4: no such file, nor a robot that comes with graspless; did you"
    assert f"{typo} mean 'wam_t42'?" in fault(write(text))


NO_FILES = {
    *(
        "arm",
        "closed",
        "ends",
        "files",
        "fingers",
        "fingertip",
        "fingertips",
        "frame",
        "grasp_frame",
    ),
    *("home", "link", "links", "mount", "name", "on", "open", "prefix", "proposed", "rests_on"),
    *("root", "sample", "sliding_finger", "srdf_text", "urdf_text", "xacro_args"),
}


def text_fields(model):
    """The names of the fields of a model, and of those in it, that may hold text."""
    for name, field in model.model_fields.items():
        if may_be_text(field.annotation):
            yield name
        for inner in models_in(field.annotation):
            yield from text_fields(inner)


def may_be_text(kind):
    return kind is str or (
        get_origin(kind) is not Literal and any(may_be_text(part) for part in get_args(kind))
    )


def test_files_of_a_stage_s_file_are_beside_it():
    kinds = [part("tasks", kind).Fields for kind in stages.STAGES]
    assert {name for kind in kinds for name in text_fields(kind)} == {*stages.FILES, *NO_FILES}


def test_the_scene_of_a_stage_s_file_is_beside_it(tmp_path):
    (tmp_path / "scene.yaml").touch()
    document = stages.absolute({"object": {"scene": "scene.yaml"}}, tmp_path)
    assert document == {"object": {"scene": str(tmp_path / "scene.yaml")}}


def test_names_in_a_stage_s_file_are_no_paths(tmp_path):
    for folder in ("hand", "fh", "wam_t42", "kr5_t42"):  # of these names
        (tmp_path / folder).mkdir()
    document = {
        "robot": {"urdf": "wam_t42", "xacro_args": {"hand": "fh"}},
        "hand": {"arm": "arm", "hand": "hand"},
    }
    assert stages.absolute(document, tmp_path) == document
    robot = {"arm": "wam_t42", "gripper": {"file": "kr5_t42", "mount": "hand"}}
    given = {"robot": robot, "hand": "hand"}
    assert stages.absolute(given, tmp_path) == given | {"hand": str(tmp_path / "hand")}


def test_a_missing_file_of_a_stage_s_file_is_not_looked_for_elsewhere(tmp_path):
    document = {"robot": {"urdf": "arm.urdf", "srdf": "arm.srdf", "packages": {"a": "a"}}}
    robot = stages.absolute(document, tmp_path)["robot"]
    assert robot["packages"].pop("a") == str(tmp_path / "a")
    assert robot == {
        "urdf": str(tmp_path / "arm.urdf"),
        "srdf": str(tmp_path / "arm.srdf"),
        "packages": {},
    }


def test_check_finds_a_gap_of_the_object(document, tmp_path):
    row = document["stages"][1]["segments"][0]["object_poses"]
    for pose in row:
        pose[0] += 1e-4
    document["stages"][1]["task"]["pose"]["position"][0] += 1e-4
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert any("stage 1 'lift': the object starts 0.0001 m" in fault for fault in faults)
    assert any("pose.position" in fault for fault in faults)


def test_check_finds_a_gap_of_the_joints(document, tmp_path):
    del document["stages"][0]["segments"][-1]["positions"][-1]
    del document["stages"][0]["segments"][-1]["object_poses"][-1]
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert any("stage 1 'lift': a joint starts " in fault for fault in faults)


@pytest.mark.parametrize("stage", [0, 1])
def test_check_finds_a_stage_without_motion(document, tmp_path, stage):
    segments = document["stages"][stage]["segments"]
    segments[-1]["positions"], segments[-1]["object_poses"] = [], []
    faults = graspless.check(reread(document, tmp_path / "rows.json"))
    assert any(fault.startswith(f"stage {stage} ") for fault in faults)
    segments.clear()
    faults = graspless.check(reread(document, tmp_path / "segments.json"))
    assert any(fault.startswith(f"stage {stage} ") for fault in faults)


def test_a_chain_without_stages_is_not_run(document, tmp_path):
    document |= {"stages": [], "names": [], "joins": [], "segments": []}
    empty = reread(document, tmp_path / "plan.json")
    for use in (graspless.time, graspless.simulate):
        with pytest.raises(graspless.TaskError, match="the chain plan has no stages: nothing to"):
            use(empty)
    assert graspless.check(empty)


def test_check_finds_another_task(document, tmp_path):
    document["task"]["stages"][1]["line"]["distance"] = 0.2
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert faults == ["stage 1 'lift': line.distance is not what the chain's task says"]


def test_check_finds_a_stage_that_does_not_hold(document, tmp_path):
    document["stages"][1]["segments"][0]["positions"][5][2] += 0.02
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert any(fault.startswith("stage 1 'lift': carry row 5: ") for fault in faults)


def test_check_finds_a_missing_stage(document, tmp_path):
    for key in ("stages", "names"):
        del document[key][1]
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert faults == ["plan: the stages are not those of the task"]


def test_check_finds_a_wrong_join(document, tmp_path):
    document["joins"][0]["how"] = "arm"
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert faults == ["stage 1 'lift': the join before it is not what the stage before it left"]


def test_carry_alone(write):
    """A carry needs no chain when it is told all that a chain would tell it."""
    text = """\
kind: carry
robot: {urdf: wam_t42}
frame: grasp
object: {name: bar, box: [0.1, 0.02, 0.02]}
pose: {position: [0.55, 0, 0.25]}
goal: {position: [0.55, 0.1, 0.3], rpy: [0, 0, 0.3]}
"""
    plan = graspless.plan(write(text))
    assert plan, plan.reason
    assert graspless.check(plan) == []
    X_WO = plan.segments[0].object_poses[-1]
    wanted = frames.translation([0.55, 0.1, 0.3]) @ frames.from_rpy([0, 0, 0.3])
    assert np.abs(X_WO - wanted).max() < 1e-6
    for field in ("frame", "object", "pose", "robot"):
        kept = "".join(line for line in text.splitlines(True) if not line.startswith(field))
        assert f"{field}: missing" in fault(write(kept))
    assert "frame: palm:" in fault(write(changed("frame: grasp", "frame: palm", text)))
    assert "rests_on" in fault(write(text + "rests_on: [table]\n"))
    thin = changed("0.02]}", "1.0e-8]}", text)
    assert fault(write(thin)).startswith("task.yaml:4: object.box: box.size[2] must be in")


def test_command_line(write, capsys, tmp_path):
    path, out = str(write(LIFT)), str(tmp_path / "plan.json")
    code, said, _ = run(capsys, "plan", path, "-o", out)
    assert code == 0
    assert "to the edge (slide): solved" in said
    assert "lift (carry): solved" in said
    assert "holds: 8 segments" in said
    assert run(capsys, "check", out)[0] == 0
    code, said, _ = run(capsys, "plan", path, "-o", out, "--json")
    summary = json.loads(said)
    assert [stage["name"] for stage in summary["stages"]] == ["to the edge", "lift"]
    assert summary["faults"] == []


def test_replay_shows_one_stage_after_the_other(lift, tmp_path):
    pytest.importorskip("viser")
    from graspless import view
    from tasks_common import recording

    view.write_html(lift, tmp_path / "plan.html")
    text = (tmp_path / "plan.html").read_text()
    assert len(text) < 2e6
    assert "<title>graspless: card, solved</title>" in text
    messages = recording(text)["messages"]
    shown = [
        (at, m["name"], m["props"]["visible"] if "props" in m else m["visible"])
        for at, m in messages
        if m["type"] == "SetSceneNodeVisibilityMessage" and m["name"].count("/") == 1
    ]
    switched = [(name, visible) for at, name, visible in shown if at > 0]
    assert ("/0 to the edge", False) in switched
    assert ("/1 lift", True) in switched


def test_picture_has_those_of_the_stages_below_each_other(lift, tmp_path, monkeypatch):
    pytest.importorskip("matplotlib")
    from graspless import view
    from graspless.view.carry import picture as carry
    from graspless.view.figures import DPI, new_figure
    from graspless.view.slide import picture as slide
    from tasks_common import read_png

    def drawing(width, height, color):
        page = new_figure(width / DPI, height / DPI)
        page.set_facecolor(color)
        return lambda plan: page

    monkeypatch.setattr(slide, "draw", drawing(30, 20, (1, 0, 0)))
    monkeypatch.setattr(carry, "draw", drawing(20, 10, (0, 0, 1)))
    view.write_png(lift, tmp_path / "plan.png")
    picture = read_png(tmp_path / "plan.png")[..., :3]
    assert picture.shape == (30, 30, 3)
    assert (picture[1:20, :29] == [1, 0, 0]).all()  # a face does not fill its outermost pixels
    assert (picture[21:, :19] == [0, 0, 1]).all()
    assert (picture[20:, 20:] == 1).all()


def test_chain_without_a_stage_is_drawn_as_it_starts(write, tmp_path):
    pytest.importorskip("matplotlib")
    pytest.importorskip("viser")
    from graspless import view
    from tasks_common import read_png

    plan = graspless.plan(graspless.load_task(write(LIFT)), seconds=1e-9)
    assert plan.stages == ()
    view.write_png(plan, tmp_path / "plan.png")
    assert read_png(tmp_path / "plan.png").std() > 0
    view.write_html(plan, tmp_path / "plan.html")
    assert "<title>graspless: card, out_of_time</title>" in (tmp_path / "plan.html").read_text()


def test_picture_of_a_carry_shows_the_object_rise(lift, tmp_path):
    pytest.importorskip("matplotlib")
    from graspless import view
    from graspless.view.bodies import OBJECT
    from tasks_common import pixels, read_png

    view.write_png(lift.stages[1], tmp_path / "carry.png")
    picture = read_png(tmp_path / "carry.png")
    third = picture.shape[1] // 3
    heights = [
        pixels(picture[80:, k * third : (k + 1) * third], OBJECT)[:, 0].mean() for k in range(3)
    ]
    assert heights[0] > heights[1] > heights[2]


@pytest.fixture(scope="module")
def carried(lift):
    pytest.importorskip("mujoco")
    return graspless.simulate(lift, record=True).trials[0]


def test_simulated_hand_takes_the_object_where_the_plan_says(carried):
    assert carried, carried.failures
    assert carried.measures["carried"] == pytest.approx(0.1, abs=0.003)
    assert carried.measures["carry_error"] < 0.003
    assert carried.measures["kept"] == 1
    of_clasps = {"moved_before", "moved_by_closing", "moved_by_grip"}
    of_clasps |= {"linking", "grip", "raised", "swayed"}
    measures = {
        m
        for m in simulation_kind("chain").MEASURES
        if not m.startswith(("lift_", "place_", "fingers_", "left_"))
    } - of_clasps
    assert set(carried.measures) == measures


def test_recording_has_the_object_near_the_plan_from_the_first_moment_on(lift, carried):
    """What is planned moves as what happens does: in a chain that holds, both go together."""
    assert carried, carried.failures
    recording = carried.recording
    off = np.linalg.norm((recording.object_poses - recording.planned_poses)[:, :3, 3], axis=1)
    names = np.array(recording.names)
    gaps = {name: off[names == name].max() for name in dict.fromkeys(recording.names)}
    assert {"approach", "press", "slide", "close", "raise", "hold"} <= set(gaps)
    assert max(gaps.values()) < 0.005, gaps
    planned = lift.stages[0].segments
    np.testing.assert_allclose(recording.planned_poses[0], planned[0].object_poses[0], atol=1e-9)


def test_simulated_hand_that_does_not_close_leaves_the_object_behind(lift, tmp_path):
    """A hand that stays open takes nothing with it."""
    pytest.importorskip("mujoco")
    document = json.loads(lift.to_json())
    close = document["stages"][0]["segments"][-1]
    open_rows = [close["positions"][0]] * len(close["positions"])
    close["positions"] = open_rows
    for row in document["stages"][1]["segments"][0]["positions"]:
        row[7] = open_rows[0][7]
    plan = reread(document, tmp_path / "plan.json")
    trial = graspless.simulate(plan).trials[0]
    assert not trial
    assert trial.measures["kept"] == 0


def test_chain_that_is_not_executed_in_one_go(tumble):
    pytest.importorskip("mujoco")
    with pytest.raises(graspless.TaskError, match="fingertip, fingertip is not simulated") as said:
        graspless.simulate(tumble)
    assert "a slide, a pinch or a clasp and the carries" in str(said.value)
    assert "plan." not in str(said.value)


def test_chain_of_bare_fingertips_has_no_trajectory_for_controllers():
    found = work.done(TaskJob(TUMBLE, limits={"max_jerk": 50.0}), lambda _: None)
    assert (found.status, found.joint_names) == ("solved", [])
    assert found.warnings == ["the plan moves no joints: its fingertips have no arm"]


def test_chain_of_one_slide_is_that_slide(lift, write):
    pytest.importorskip("mujoco")
    plan = graspless.plan(write(LIFT.split("  - {name: lift")[0]))
    found, alone = graspless.simulate(plan), graspless.simulate(plan.stages[0])
    assert found
    assert found.trials[0].measures == alone.trials[0].measures
    assert set(found.trials[0].measures) <= set(simulation_kind("chain").MEASURES)


def test_carry_alone_is_not_simulated(lift):
    pytest.importorskip("mujoco")
    with pytest.raises(graspless.TaskError, match="a carry is not simulated alone: plan a chain"):
        graspless.simulate(lift.stages[1])


def test_object_that_is_carried_down_is_not_dropped(write):
    """Out from under the table's edge, and then below it."""
    pytest.importorskip("mujoco")
    text = changed("direction: [0, 0, 2], distance: 0.1", "direction: [0, 0, 2], distance: 0.02")
    down = "  - {kind: carry, offset: [-0.12, 0, 0]}\n  - {kind: carry, offset: [0, 0, -0.08]}\n"
    plan = graspless.plan(write(changed("budget:", down + "budget:", text)))
    assert plan, plan.reason
    trial = graspless.simulate(plan).trials[0]
    assert trial, (trial.failures, trial.measures)


def test_obstacles_of_the_carries_are_there(write):
    pytest.importorskip("mujoco")
    from graspless.simulation.chain import _Carried
    from graspless.simulation.settings import Slide
    from graspless.simulation.variation import Variation

    box = "{name: post, box: [0.05, 0.05, 0.05], pose: {position: [0.9, 0.9, 0.5]}}"
    other = box.replace("post", "shelf").replace("0.9, 0.9", "0.8, 0.9")
    text = changed("stages:", f"obstacles: [{box}]\nstages:")
    text = changed("distance: 0.1}", f"distance: 0.1}}, obstacles: [{other}]", text)
    plan = graspless.plan(write(text))
    assert plan, plan.reason
    scene = _Carried(plan.stages, Variation(), Slide()).scene
    assert len(scene.groups["obstacle"]) == 2
    assert len(scene.groups["table"]) == 1


TILE = (EXAMPLES / "23_tumble_slide_lift.yaml").read_text()


@pytest.fixture(scope="module")
def tile():
    return graspless.plan(EXAMPLES / "23_tumble_slide_lift.yaml")


def test_arm_goes_on_with_what_the_fingertips_left(tile):
    assert tile, tile.reason
    assert graspless.check(tile) == []
    assert [join.how for join in tile.joins] == ["arm", "held"]
    first, second, _ = tile.stages
    q = first.joint_segments[-1].positions[-1]
    assert np.abs(q - second.segments[0].positions[0]).max() < 1e-9


def test_the_hand_squeezes_after_the_fingertips_too(tile):
    trajectory = graspless.time(tile)
    held = squeezed(trajectory, 0.2)
    assert held.duration == pytest.approx(trajectory.duration + SECONDS)
    closing = np.abs(held.positions[-1] - trajectory.positions[-1])
    assert closing.max() > 0.05
    problem = tile.stages[1].task.problem
    assert not closing[problem.robot.group(problem.hand.arm)].any()


def test_all_three_stages_by_one_arm_hold_in_the_physics_engine(tile):
    pytest.importorskip("mujoco")
    trial = graspless.simulate(tile).trials[0]
    assert trial, trial.failures
    assert trial.measures["fingers_error"] < 0.002


@pytest.fixture(scope="module")
def block():
    """A block that fingertips tumble and a hand pinches; nothing is carried after that."""
    task = yaml.safe_load(TILE)
    task["stages"] = task["stages"][:2]
    task["object"] |= {"box": [0.04, 0.04, 0.08]}
    pose = {"position": [0.60, 0.0, 0.04]}
    task["stages"][0]["motion"] = {"tumble": {"over": "+x", "pose": pose, "segments": 18}}
    task["stages"][0]["options"] = {"min_stability": 0.1}
    lying = {"rectangle": {"size": [0.08, 0.04]}, "thickness": 0.04}
    support = task["stages"][1]["support"]
    task["stages"][1] = {"name": "pinch", "kind": "pinch", "object": lying, "support": support}
    plan = graspless.plan(task)
    assert plan, plan.reason
    return plan


def test_what_the_fingertips_left_is_pinched_and_recorded(block):
    pytest.importorskip("mujoco")
    trial = graspless.simulate(block, record=True).trials[0]
    assert trial, trial.failures
    film = trial.recording
    assert {"tumble", "close", "raise"} <= set(film.names)
    low = np.array([name not in ("raise", "hold") for name in film.names])
    off = np.linalg.norm((film.object_poses - film.planned_poses)[low, :3, 3], axis=1)
    assert off.max() < 1e-3


def test_other_bodies_take_the_place_of_what_a_lone_pinch_knows(block):
    pytest.importorskip("mujoco")
    from graspless.simulation import chain
    from graspless.simulation.slide.truth import Body, Truth
    from graspless.simulation.variation import Variation

    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (0, 2)]) / 2
    com, inertia = np.array([0.0, 0.0, 0.002]), np.eye(3) * 1e-4
    flat = Body([corners * [0.08, 0.03, 0.004]], 0.15, com, inertia)
    assert "not_grasped" in chain.run(block, Variation(), truth=Truth(flat)).failures


def test_object_is_one_body_in_all_frames(tile):
    """A box and its outline are the same corners, and in time nothing jumps."""
    first, second, third = tile.stages
    corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
    X_W1, X_W2 = first.segments[-1].X_WO[-1], second.segments[0].object_poses[0]
    box = (corners / 2 * [0.04, 0.08, 0.10]) @ X_W1[:3, :3].T + X_W1[:3, 3]
    plate = (corners / 2 * [0.10, 0.08, 0.04] + [0, 0, 0.02]) @ X_W2[:3, :3].T + X_W2[:3, 3]
    apart = np.linalg.norm(box[:, None] - plate[None], axis=2)
    assert apart.min(axis=0).max() < 1e-9
    assert apart.min(axis=1).max() < 1e-9
    poses = graspless.time(tile).object_poses
    assert np.linalg.norm(np.diff(poses[:, :3, 3], axis=0), axis=1).max() < 2e-3
    assert np.abs(np.diff(poses[:, :3, :3], axis=0)).max() < 0.02
    end = third.segments[-1].object_poses[-1] @ np.linalg.inv(tile.object_frames[2])
    assert np.abs(poses[-1] - end).max() < 1e-9


def test_stage_has_the_mass_of_the_chain(tile, write):
    assert tile.stages[1].task.problem.object.mass == 0.15
    said = fault(write(changed("thickness: 0.04}", "thickness: 0.04, mass: 1}", TILE)))
    assert "stages[1].object.mass: 1: the chain's object has 0.15" in said


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        ("thickness: 0.04}", "thickness: 0.041}", "is 0.04 m high as it lies; thickness is 0.041"),
        ("size: [0.10, 0.08]}", "size: [0.10, 0.07]}", "has another outline seen from above"),
        ("height: 0.0}", "height: -0.01}", "lies 0.01 m over the support"),
    ],
)
def test_outline_of_another_object(write, old, new, words):
    plan = graspless.plan(write(changed(old, new, TILE)))
    assert plan.status == "not_joined"
    assert plan.reason.startswith("slide: cannot start where 'tumble' ended: ")
    assert f"stages[1].object: {words}" in plan.reason


def test_check_finds_an_object_that_lies_elsewhere(tile, tmp_path):
    document = json.loads(tile.to_json())
    document["stages"][1]["task"]["object"]["pose"]["yaw"] += 0.01
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert "stage 1 'slide': object.pose.yaw is not what the chain's task says" in faults
    document = json.loads(tile.to_json())
    for segment in document["stages"][1]["segments"]:
        for pose in segment["object_poses"]:
            pose[1] += 3e-4
    faults = graspless.check(reread(document, tmp_path / "plan.json"))
    assert any("stage 1 'slide': the object starts 0.0003 m" in fault for fault in faults)


def test_a_gap_of_the_joints_has_the_unit_of_its_joint():
    arm = robot.Robot.from_urdf(small.gripper(hand=small.prismatic()))
    slides = np.asarray(arm.step_weights) > 1
    assert check._largest(np.where(slides, 0.001, 0), arm) == "0.001 m"
    assert check._largest(np.where(slides, 0.001, 0.2), arm) == "0.2 rad"


def test_outline_is_laid_where_its_corners_are():
    rng = np.random.default_rng(3)
    for _ in range(50):
        outline = lying.convex_hull(rng.normal(size=(8, 2)) * 0.1)
        x, y, yaw = rng.uniform(-1, 1, 3)
        X_SO = frames.planar(x, y, yaw)
        ring = np.concatenate(
            [np.column_stack([outline, np.full(len(outline), z)]) for z in (0, 0.02)]
        )
        corners_S = ring @ X_SO[:3, :3].T + X_SO[:3, 3]
        prism = slide.Object.prism("a", geometry.Polygon(outline), 0.02)
        com_S = X_SO[:3, :3] @ prism.com + X_SO[:3, 3]
        pose = lying.lying(rng.permutation(corners_S), com_S, prism)
        assert (pose.x, pose.y, pose.yaw) == pytest.approx((x, y, yaw), abs=1e-7)


@pytest.mark.parametrize(("radius", "count"), [(0.05, 100), (0.05, 320), (0.02, 1000)])
def test_a_finely_drawn_circle_is_laid_where_it_is(radius, count):
    ring = regular_polygon(radius, count)
    hull = lying.convex_hull(ring)
    assert np.ptp(hull, axis=0) == pytest.approx([2 * radius] * 2, abs=2e-4)
    moved = np.repeat(ring + [0.3, 0.1], 2, axis=0)
    prism = slide.Object.prism("a", geometry.Polygon(ring), 0.02)
    corners_S = np.column_stack([moved, np.tile([0, 0.02], count)])
    pose = lying.lying(corners_S, np.array([0.3, 0.1, 0.01]), prism)
    assert (pose.x, pose.y) == pytest.approx((0.3, 0.1), abs=1e-4)


def test_points_on_an_edge_are_no_corners():
    corners = np.array([[0, 0], [0.1, 0], [0.1, 0.05], [0, 0.05]])
    between = (corners + np.roll(corners, 1, axis=0)) / 2 + [-1e-6, 1e-6]
    assert len(lying.convex_hull(np.concatenate([corners, between]))) == 4


def test_outline_turns_least():
    """Of the four ways in which a square lies on itself, unless its centre of mass decides."""
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]]) * 0.05
    ring = np.concatenate([np.column_stack([square, np.full(4, z)]) for z in (0, 0.01)])
    R = frames.from_rpy([0, 0, 1.4])[:3, :3]
    prism = slide.Object.prism("a", geometry.Polygon(square), 0.01)
    pose = lying.lying(ring @ R.T, R @ prism.com, prism)
    assert pose.yaw == pytest.approx(1.4 - np.pi / 2, abs=1e-9)
    prism = prism.with_com([0.02, 0.0, 0.005])
    assert lying.lying(ring @ R.T, R @ prism.com, prism).yaw == pytest.approx(1.4, abs=1e-9)


def test_a_notched_outline_is_laid_by_its_centre_of_mass():
    notched = np.array([[0, 0], [0.1, 0], [0.1, 0.06], [0.07, 0.06], [0.07, 0.02], [0.03, 0.02]])
    notched = np.concatenate([notched, [[0.03, 0.06], [0, 0.06]]])
    prism = slide.Object.prism("u", geometry.Polygon(notched), 0.02)
    X_SO = frames.planar(0.2, 0.1, 3.0)
    box = np.concatenate([np.column_stack([notched, np.full(8, z)]) for z in (0, 0.02)])
    p_S = box @ X_SO[:3, :3].T + X_SO[:3, 3]
    pose = lying.lying(p_S, X_SO[:3, :3] @ prism.com + X_SO[:3, 3], prism)
    assert (pose.x, pose.y, pose.yaw) == pytest.approx((0.2, 0.1, 3.0), abs=1e-9)


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("thickness: 0.04}", "thickness: 0.04005}"),
        (
            "rectangle: {size: [0.10, 0.08]}",
            "polygon: [[-0.05, -0.04], [0, -0.04], [0.05, -0.04], [0.05, 0.04], [-0.05, 0.04]]",
        ),
    ],
)
def test_an_outline_written_otherwise_is_the_same_object(write, old, new):
    plan = graspless.plan(write(changed(old, new, TILE)))
    assert plan, plan.reason
    assert graspless.check(plan) == []


def test_camera_of_a_chain_sees_what_each_stage_shows():
    pytest.importorskip("viser")
    from graspless.view.chain import replay
    from graspless.view.raster import Camera

    cameras = [
        Camera(np.array([2.0, 1, 1]), np.array([0.5, 0, 0.2]), 0.3),
        Camera(np.array([1.0, 2, 1]), np.array([0.7, 0.3, 0.1]), 0.2),
    ]
    view = replay.common(cameras)
    targets = view.project(np.array([c.target for c in cameras]), 400, 300)
    assert (targets[:, :2] > 0).all()
    assert (targets[:, :2] < [400, 300]).all()
    ahead, first = view.target - view.eye, cameras[0].target - cameras[0].eye
    assert np.abs(np.cross(ahead, first)).max() < 1e-9
    assert replay.common(cameras[:1]).angle == pytest.approx(0.3 / 1.08)


def test_an_attempt_that_was_interrupted_ends_the_chain(lift, monkeypatch):
    """Whatever became of those before it."""
    search = sys.modules["graspless.chain.search"]
    first = search.Found(list(lift.stages), "not_found", "lift: the arm does not follow")
    found = [first, search.Found([], "interrupted", "interrupted")]
    monkeypatch.setattr(search, "_attempt", lambda *given: found.pop(0))
    assert search.search(lift.task, lift.task.budget).status == "interrupted"
