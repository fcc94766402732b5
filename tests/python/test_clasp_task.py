# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasp task files: what is read, and what is said about each fault."""

import re
import shutil

import numpy as np
import pytest

import graspless
from clasp_common import PURSE, changed
from graspless import _data, clasp, frames
from graspless.cli import main
from graspless.tasks import task_from_dict
from tasks_common import fault, write_renamed

SAMPLE = "sample: purse"


def ring(count=240, radius=0.1, thickness=0.012):
    """Points on a torus around z: one hole."""
    rng = np.random.default_rng(1)
    u, v = 2 * np.pi * rng.random((2, count))
    out = radius + thickness * np.cos(v)
    return np.column_stack([out * np.cos(u), out * np.sin(u), thickness * np.sin(v)])


def write_ring(folder, scale=1.0):
    """A cloud of a ring in ring.xyz."""
    np.savetxt(folder / "ring.xyz", scale * ring())


def hand_text():
    """The hand of kr5_sdh as text."""
    return (_data.directory("urdf") / "kr5_sdh.clasp.yaml").read_text()


def test_reads_a_task(write):
    task = graspless.load_task(write(PURSE))
    assert (task.kind, task.seed, task.budget.seconds) == ("clasp", 3, 20)
    problem = task.problem
    assert problem.object.name == "purse"
    assert problem.object.points.shape == (2000, 3)
    assert len(problem.object.loops.found) == 1
    np.testing.assert_allclose(
        problem.X_WO, frames.translation([0.62, 0.05, 0]) @ frames.from_rpy([0, 0, 0.3])
    )
    np.testing.assert_array_equal(problem.q_start, problem.robot.state("home"))
    assert [finger.name for finger in problem.hand.fingers] == ["finger_1", "finger_2"]
    assert (problem.loops, len(problem.marks), problem.pull_W) == ([], 0, None)


@pytest.mark.parametrize(
    ("old", "new", "place"),
    [
        ("rpy: [0, 0, 0.3]", "rpy: [0, 0, 17]", r"object.pose.rpy\[2\]: 17"),
        ("urdf: kr5_sdh", "urdf: kr5_sdh, pose: {rpy: [90, 0, 0]}", r"robot.pose.rpy\[0\]: 90"),
        (
            "object:",
            "obstacles: [{name: a, box: [1, 1, 1], pose: {position: [9, 0, 0], rpy: [0, -90, 0]}}]"
            "\nobject:",
            r"obstacles\[0\].pose.rpy\[1\]: -90",
        ),
    ],
)
def test_degrees_are_warned_of(write, old, new, place):
    with pytest.warns(UserWarning, match=place + r"(\.0)?: is more than a turn"):
        graspless.load_task(write(changed(old, new)))


@pytest.mark.parametrize("name", ["kr5_sdh", "kr5_dlr", "kr5_icub", "kr5_armar", "wam_t42"])
def test_every_hand_that_comes_with_graspless(write, name):
    problem = graspless.load_task(write(changed("kr5_sdh", name))).problem
    from_file = clasp.hand_from_yaml_file(_data.directory("urdf") / f"{name}.clasp.yaml")
    for hand in (problem.hand, from_file):  # the library and task files read it alike
        assert hand.arm == "arm"
        np.testing.assert_allclose(hand.forward_H, from_file.forward_H, atol=1e-15)
        np.testing.assert_allclose(hand.sideways_H, from_file.sideways_H, atol=1e-15)
    for ours, theirs in zip(
        [*problem.hand.fingers, problem.hand.thumb],
        [*from_file.fingers, from_file.thumb],
        strict=True,
    ):
        assert ours.name == theirs.name
        assert [node.link for node in ours.nodes] == [node.link for node in theirs.nodes]
        np.testing.assert_array_equal([n.p_L for n in ours.nodes], [n.p_L for n in theirs.nodes])


def test_what_may_be_clasped(write):
    fields = "clasp: {loops: [0], marks: [[0, 0, 0.3], [0, 0.1, 0.3]], pull: [0, 0, 2]}\nbudget:"
    problem = graspless.load_task(write(changed("budget:", fields))).problem
    assert problem.loops == [0]
    np.testing.assert_array_equal(problem.marks, [[0, 0, 0.3], [0, 0.1, 0.3]])
    np.testing.assert_array_equal(problem.pull_W, [0, 0, 2])


def test_obstacles_and_options(write):
    fields = """\
obstacles: [{name: pole, box: [0.1, 0.1, 1], pose: {position: [1, 1, 0]}}]
options: {min_linking: 0.7, targets: 12, stability: {sequences: 4, seed: 9}}
budget:"""
    task = graspless.load_task(write(changed("budget:", fields)))
    assert [obstacle.name for obstacle in task.problem.obstacles] == ["pole"]
    assert (task.options.min_linking, task.options.targets) == (0.7, 12)
    assert (task.options.stability.sequences, task.options.stability.seed) == (4, 9)
    assert task.options.stability.moves == clasp.StabilityOptions().moves


def more(text):
    """A change that adds a section on line 7."""
    return "budget:", f"{text}\nbudget:"


def of_object(text):
    """A change that adds fields of the object on line 6."""
    return "  pose:", f"  {text}\n  pose:"


# A change of the good task, the line that is blamed, and what must be said.
FAULTS = [
    (("kind: clasp", "kind: clasps"), 1, r"kind: clasps: should be 'slide' or .*'clasp'"),
    (("urdf: kr5_sdh", "urdf: kr5_shd"), 2, r"robot.urdf: kr5_shd: no such file, nor .*kr5_sdh"),
    (("urdf: kr5_sdh", "urdf: kr5_sdh, home: asleep"), 2, r"robot.home: asleep: .*open"),
    ((SAMPLE, "sample: trunk"), 5, r"object.sample: trunk: .*lawn_mower"),
    ((SAMPLE, "samples: purse"), 5, r"object.samples: unknown field; did you mean 'sample'"),
    ((f"  {SAMPLE}\n", ""), 3, r"object: exactly one of cloud, mesh, sample, scene must be given"),
    ((SAMPLE, f"{SAMPLE}\n  cloud: a.ply"), 3, r"object: .*not cloud and sample"),
    ((SAMPLE, f"{SAMPLE}\n  points: [[0, 0, 0]]"), 3, r"object: .*not sample and points"),
    ((SAMPLE, f"{SAMPLE}\n  unit: mm"), 3, r"object: unit is for files"),
    ((SAMPLE, "cloud: a.ply"), 5, r"object.cloud: a.ply: no such file"),
    ((SAMPLE, "cloud: a.e57"), 5, r"object.cloud: a.e57: .*one of: .ply, .pcd, .xyz"),
    ((SAMPLE, "cloud: a.ply\n  points: 500"), 3, r"object: points is the number of samples"),
    ((SAMPLE, "mesh: {file: a.stl}"), 5, r"object.mesh.file: a.stl: no such file"),
    (
        (SAMPLE, "unit: mm\n  mesh: {file: a.stl, unit: mm}"),
        3,
        r"object: unit and mesh.unit must not both be given",
    ),
    ((SAMPLE, "mesh: {file: /tmp}"), 5, r"object.mesh.file: /tmp: is a folder, not a file"),
    (more("hand: /tmp"), 7, r"hand: /tmp: is a folder, not a file"),
    ((SAMPLE, "mesh: {file: a.stl, scale: 0}"), 5, r"object.mesh.scale: 0: .*greater than 0"),
    ((SAMPLE, "points: []"), 5, r"object.points: .*(at least|20|points)"),
    ((SAMPLE, "points: [[0, 0, 0], [0, .nan, 0]]"), 5, r"object.points\[1\]\[1\]: nan: .*finite"),
    ((SAMPLE, "points: [[0, 0, 0], [0, 0]]"), 5, r"object.points\[1\]: .*at least 3"),
    (of_object("points: 7"), 6, r"object.points: 7: should be greater than or equal to 20"),
    (of_object("points: many"), 6, r"object.points: many: should be a valid integer"),
    (of_object("noise: -0.1"), 6, r"object.noise: -0.1: should be greater"),
    (of_object("scale: 0"), 6, r"object.scale: 0: should be greater than 0"),
    (of_object("views: [1, 0, 1]"), 6, r"object.views\[0\]: 1: should be a valid list"),
    (of_object("loops: {min_ratio: 0.5}"), 6, r"object.loops.min_ratio: 0.5: .*1"),
    (of_object("loops: {max_edge: 0.5}"), 6, r"loops.max_edge: unknown field; did you .*edge_length"),
    (more("clasp: {loops: [-1]}"), 7, r"clasp.loops\[0\]: -1: should be greater"),
    (more("clasp: {loops: [4]}"), 7, r"clasp.loops\[0\]: 4: there is no loop 4; .*has 1 loop,"),
    (more("clasp: {loops: [4294967296]}"), 7, r"clasp.loops\[0\]: 4294967296: should be less"),
    (of_object("loops: {max_points: 4294967296}"), 6, r"max_points: 4294967296: should be less"),
    (more("clasp: {marks: [0, 0, 1]}"), 7, r"clasp.marks\[0\]: 0: should be a valid list"),
    (more("clasp: {marks: [[0, 0, 1e9]]}"), 7, r"clasp.marks\[0\]: .*finite"),
    (more("clasp: {pull: [0, 0, 0]}"), 7, r"clasp.pull: must be a direction whose length lies in \[1e-06, 10000\], not 0"),
    (more("clasp: {pull: up}"), 7, r"clasp.pull: up: should be a valid list"),
    (more("obstacles: [{name: palm, box: [1, 1, 1]}]"), 7, r"obstacles\[0\].name: palm: is taken"),
    (more("options: {min_linking: 1.0}"), 7, r"options.min_linking: 1.0: should be less than 1"),
    (more("options: {targets: -1}"), 7, r"options.targets: -1: should be greater"),
    (more("options: {dt: 1}"), 7, r"options.dt: 1: is no longer an option; it is always 0.5"),
    (more("options: {search: fast}"), 7, r"options.search: unknown field"),
    (more("options: {stability: {moves: 0}}"), 7, r"stability.moves: 0: should be greater"),
    (more("hand: {arm: arm}"), 7, r"hand.frame: missing"),
    (more("hand: my.clasp.yaml"), 7, r"hand: my.clasp.yaml: no such file"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "line", "what"), FAULTS)
def test_fault_says_file_line_field_value_and_choice(write, change, line, what):
    message = fault(write(changed(*change))).splitlines()[0]
    assert re.match(rf"task\.yaml:{line}: ", message), message
    assert re.search(what, message), message


# A change of the hand's own file, and what must be said.
HAND_FAULTS = [
    (("link: finger_2_distal}", "link: nail}"), r"fingers.finger_2\[2\].link: nail: unknown link"),
    (("frame: palm", "frame: wrist"), r"frame: wrist: unknown link 'wrist'; choose from base_link"),
    (("arm: arm", "arm: leg"), r"arm: leg: unknown group 'leg'; choose from arm, hand"),
    (("open: open", "open: ajar"), r"open: ajar: unknown state"),
    (("open: open", "open: [open, ajar]"), r"open\[1\]: ajar: unknown state 'ajar'; choose from"),
    (("open: open", "open: [open, home, open]"), r"open\[2\]: open: .*again; each may occur only once"),
    (("open: open", "open: []"), r"open: .*at least 1"),
    (("closed: closed", "closed: open"), r"open: .*same"),
    (("forward: [0, 0, 1]", "forward: [0, 0, 0]"), r"forward: .*must not be zero"),
    (("forward: [0, 0, 1]", "forward: [0, 1, 1]"), r"sideways: .*orthogonal"),
    (("forward: [0, 0, 1]", "forward: [0, 1]"), r"forward: \[0, 1\]: .*at least 3"),
    (("hand: hand", "hnad: hand"), r"hnad: unknown field; did you mean 'hand'"),
    (("{link: thumb_distal}", "{link: thumb_proximal}"), r"fingers.finger_1: .*coincide"),
    (("{link: thumb_distal, point: [0, 0, 0.0675]}", "{link: thumb_distal, point: [0, 0, 67.5]}"), r"thumb\[3\].point: .*within 1 m"),
]  # fmt: skip


@pytest.mark.parametrize(("change", "what"), HAND_FAULTS)
def test_fault_in_the_hands_file_says_its_line(write, change, what):
    text = changed(*change, hand_text())
    line = 1 + hand_text()[: hand_text().index(change[0])].count("\n")
    write(text, "my.clasp.yaml")
    message = fault(write(changed(*more("hand: my.clasp.yaml"))))
    assert re.match(r"my\.clasp\.yaml:\d+: ", message), message
    assert re.search(what, message), message
    if what.startswith(("fingers.finger_2", "thumb")):
        assert message.startswith(f"my.clasp.yaml:{line}: "), message


def test_link_with_the_name_of_the_object(write, tmp_path):
    write_renamed(tmp_path, "kr5_sdh", "kr5_link_2", "object")
    what = "robot.urdf: my.urdf: link 'object' has the name of another body of the plan"
    assert what in fault(write(changed("kr5_sdh", "my.urdf")))


def test_fingers_without_a_thumb_and_a_thumb_without_fingers(write):
    text = hand_text()
    without_thumb = text[: text.index("thumb:")]
    write(without_thumb, "my.clasp.yaml")
    path = write(changed(*more("hand: my.clasp.yaml")))
    assert "thumb: missing" in fault(path)
    fingers = text[text.index("fingers:") : text.index("thumb:")]
    write(text.replace(fingers, "fingers: {}\n"), "my.clasp.yaml")
    assert re.search(r"my.clasp.yaml:11: fingers: .*at least 1", fault(path))


def test_a_hand_may_have_several_pre_shapes(write):
    text = changed("open: open", "open: [open, home]", hand_text())
    task = graspless.load_task(write(changed(*more(f"hand: {write(text, 'my.clasp.yaml').name}"))))
    hand, in_library = task.problem.hand, clasp.hand_from_yaml(text)
    for read in (hand, in_library):
        assert (read.open, tuple(read.pre_shapes)) == ("open", ("home",))
    document = task.to_dict()
    assert document["hand"]["open"] == ["open", "home"]
    assert tuple(task_from_dict(document, "plan.json").problem.hand.pre_shapes) == ("home",)


def test_hand_inline_and_its_faults(write):
    rows = "".join(f"  {line}\n" for line in hand_text().splitlines())
    path = write(changed("budget:", f"hand:\n{rows}budget:"))
    assert graspless.load_task(path).problem.hand.frame == "palm"
    path = write(path.read_text().replace("link: thumb_proximal", "link: toe"))
    assert re.search(r"hand.thumb\[1\].link: toe: unknown link 'toe'", fault(path))


def test_robot_without_srdf_or_hand_gets_a_proposal(write, tmp_path):
    shutil.copy(_data.robot("kr5_sdh"), tmp_path / "bare.urdf")
    path = write(changed("kr5_sdh", "bare.urdf"))
    with pytest.warns(UserWarning, match="no SRDF and no description of the hand: proposed"):
        task = graspless.load_task(path)
    assert [finger.name for finger in task.problem.hand.fingers] == [
        "finger_1_proximal",
        "finger_2_proximal",
    ]
    write(hand_text(), "bare.clasp.yaml")
    with pytest.warns(UserWarning, match="no SRDF: proposed"):
        task = graspless.load_task(path)
    assert [finger.name for finger in task.problem.hand.fingers] == ["finger_1", "finger_2"]


def test_cloud_with_unit_and_scale(write, tmp_path):
    write_ring(tmp_path, 1000)
    task = graspless.load_task(write(changed(SAMPLE, "cloud: ring.xyz\n  unit: mm\n  scale: 2")))
    np.testing.assert_allclose(task.problem.object.points, 2 * ring(), atol=1e-9)


def test_millimetres_taken_for_metres_are_warned_of(write, tmp_path):
    write_ring(tmp_path, 1000)
    with pytest.warns(UserWarning, match=r"task.yaml:5: object.cloud: .* m; .*unit: mm"):
        graspless.load_task(write(changed(SAMPLE, "cloud: ring.xyz")))


@pytest.mark.parametrize(
    "mesh", ["{file: ring.stl, scale: 2}\n  unit: mm", "{file: ring.stl, scale: 2, unit: mm}"]
)
def test_mesh_is_sampled(write, tmp_path, mesh):
    import trimesh

    trimesh.creation.torus(100, 15).export(tmp_path / "ring.stl")
    text = changed(SAMPLE, f"mesh: {mesh}\n  points: 800")
    thing = graspless.load_task(write(text)).problem.object
    assert thing.points.shape == (800, 3)
    assert np.hypot(*thing.points[:, :2].T).max() == pytest.approx(0.23, abs=2e-3)
    assert len(thing.loops.found) == 1


def test_a_closed_mesh_is_of_all_sides(write, tmp_path, capsys):
    """A washer of few points looks as if one camera could have seen it."""
    import trimesh

    washer = trimesh.creation.annulus(0.03, 0.09, 0.002)
    washer.export(tmp_path / "washer.stl")
    washer.faces = washer.faces[1:]
    washer.export(tmp_path / "open.stl")

    def loops_of(fields):
        return graspless.load_task(write(changed(SAMPLE, fields))).problem.object.loops

    closed = "mesh: {file: washer.stl}\n  points: 1000"
    assert len(loops_of(closed).found) == 1
    unsure = loops_of(f"{closed}\n  loops: {{all_sides: false}}")
    assert not unsure.found
    assert "set all_sides if the points are of all sides" in unsure.uncertain[0].reason
    assert not loops_of("mesh: {file: open.stl}\n  points: 1000").found
    task = graspless.load_task(write(changed(SAMPLE, closed)))
    assert task.fields.object.loops.all_sides is True  # in plan files, too

    command = ["loops", str(tmp_path / "washer.stl"), "--points", "1000"]
    assert main(command) == 0
    command[1] = str(tmp_path / "open.stl")
    assert main(command) == 1
    assert main([*command, "--all-sides"]) == 0
    assert "1 loop" in capsys.readouterr().out


def test_views_keep_what_is_seen(write):
    far = "views: [[0, 3, 0.3]]"
    one = graspless.load_task(write(changed(*of_object(far)))).problem.object.points
    both = "views: [[0, 3, 0.3], [0, -3, 0.3]]"
    two = graspless.load_task(write(changed(*of_object(both)))).problem.object.points
    everything = graspless.load_task(write(PURSE)).problem.object.points
    assert 0 < len(one) < len(two) <= len(everything)
    assert one[:, 1].mean() > two[:, 1].mean()
    assert {tuple(p) for p in one} <= {tuple(p) for p in everything}


def test_views_make_rays(write):
    task = graspless.load_task(write(changed(*of_object("views: [[0, 3, 0.3], [0, -3, 0.3]]"))))
    thing = task.problem.object
    assert [image.X_OC[:3, 3].tolist() for image in thing.rays] == [[0, 3, 0.3], [0, -3, 0.3]]
    assert len(thing.loops.found) == 1
    assert thing.loops.has_rays


def test_noise_has_its_size_and_its_seed(write):
    clean = graspless.load_task(write(PURSE)).problem.object.points
    noisy = [
        graspless.load_task(write(changed(*of_object("noise: 0.001\n  seed: 1")))) for _ in range(2)
    ]
    first, second = (task.problem.object.points for task in noisy)
    np.testing.assert_array_equal(first, second)
    assert (first - clean).std() == pytest.approx(0.001, rel=0.05)


def test_plan_file_holds_the_task_whole(write, tmp_path):
    write_ring(tmp_path)
    write(hand_text(), "my.clasp.yaml")
    text = changed(SAMPLE, "cloud: ring.xyz", changed(*more("hand: my.clasp.yaml")))
    task = graspless.load_task(write(text))
    document = task.to_dict()
    for path in tmp_path.iterdir():
        path.unlink()
    again = task_from_dict(document, "plan.json")
    np.testing.assert_array_equal(again.problem.object.points, task.problem.object.points)
    assert [f.name for f in again.problem.hand.fingers] == ["finger_1", "finger_2"]
    assert again.to_dict() == document
    assert document["options"]["resolution"] == clasp.Options().resolution
    assert document["options"]["stability"]["moves"] == clasp.StabilityOptions().moves
    assert document["object"]["loops"]["min_ratio"] == 2.25
    assert document["hand"]["closed"] == "closed"


@pytest.mark.parametrize(
    ("section", "field", "value"),
    [("robot", "urdf", "kr5_sdh"), ("object", "points", 2000), (None, "hand", "a.yaml")],
)
def test_plan_file_names_no_other_file(write, section, field, value):
    document = graspless.load_task(write(PURSE)).to_dict()
    owner = document[section] if section else document
    owner[field] = value
    if field == "points":
        owner["sample"] = "purse"
    owner.pop("urdf_text", None)
    with pytest.raises(graspless.TaskError, match=f"{field}.*must be part of the plan file"):
        task_from_dict(document, "plan.json")
