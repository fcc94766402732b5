# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fingertip task files: what is read, and what is said about each fault."""

import contextlib
import math
import re
import warnings

import numpy as np
import pytest

import graspless
from fingertip_common import PUSH, TUMBLE, changed
from graspless import TaskError, fingertip, frames
from graspless.tasks.fingertip.motions import angle_to_next_face, edge
from tasks_common import fault

ON_EDGE = 0.025 * (math.sin(0.5) + math.cos(0.5))  # height of a tilted block [m]
BOX = "box: [0.05, 0.10, 0.05]"
SLIDE = "slide: {translation: [0.05, 0, 0], segments: 6}"
TETRAHEDRON = (
    "vertices: [[0, 0, 0], [0.1, 0, 0], [0, 0.1, 0], [0, 0, 0.1]]\n"
    "  triangles: [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]"
)


def test_reads_a_task(write):
    task = graspless.load_task(write(PUSH))
    assert (task.kind, task.seed) == ("fingertip", 3)
    problem = task.problem
    assert problem.object.mass == 1.0
    assert (problem.fingers.count, problem.fingers.radius) == (2, 0.01)
    assert problem.fingers.friction == (0.7, 0.7)
    assert problem.friction == (0.5, 0.5)
    assert len(problem.motion) == 7
    np.testing.assert_allclose(problem.motion.X_WO[0][:3, 3], [0, 0, 0.025])
    np.testing.assert_allclose(problem.motion.X_WO[-1][:3, 3], [0.05, 0, 0.025])
    assert [plane.name for plane in problem.planes] == ["floor"]
    assert task.options.locations_per_side == 5
    assert task.arm is None


def test_planes_friction_and_gravity(write):
    more = """\
floor: {height: 0.2}
walls:
  - {name: a, normal: [1, 0, 0], point: [-0.3, 5, 5]}
  - {name: b, normal: [0, -1, 0], offset: -0.5}
gravity: [0, 0, -1.6]
budget:"""
    text = changed("friction: 0.5\n", "friction: [0.4, 0.6]\n", changed("budget:", more))
    problem = graspless.load_task(write(text)).problem
    assert [(p.name, p.offset) for p in problem.planes] == [
        ("floor", 0.2),
        ("a", -0.3),
        ("b", -0.5),
    ]
    assert problem.friction == (0.4, 0.6)
    assert problem.gravity_W[2] == -1.6
    assert problem.motion.X_WO[0][2, 3] == pytest.approx(0.225)


def test_planes_with_friction_of_their_own(write):
    more = """\
floor: {friction: 0.3}
walls:
  - {name: a, normal: [1, 0, 0], offset: -0.3, friction: [0.1, 0.2]}
  - {name: b, normal: [0, -1, 0], offset: -0.5}
budget:"""
    problem = graspless.load_task(write(changed("budget:", more))).problem
    assert problem.friction == (0.5, 0.5)
    assert [plane.friction for plane in problem.planes] == [(0.3, 0.3), (0.1, 0.2), None]


def test_a_normal_that_is_not_of_unit_length_is_normalised_with_a_warning(write):
    more = "walls: [{name: a, normal: [0, -3, 4], offset: -0.5}]\nbudget:"
    with pytest.warns(
        UserWarning, match=r"task.yaml:11: walls\[0\].normal: .*length 5.*normalised"
    ):
        problem = graspless.load_task(write(changed("budget:", more))).problem
    np.testing.assert_allclose(problem.planes[1].n_W, [0, -0.6, 0.8])
    assert problem.planes[1].offset == -0.5


def more(text):
    """A change that adds a section on line 11."""
    return "budget:", f"{text}\nbudget:"


WALL = "walls: [{name: a, normal: [1, 0, 0], offset: -1, friction: %s}]"

# A change of the good task, the line that is blamed, and what must be said.
FAULTS = [
    (("kind: fingertip", "kind: fingertips"), 1, r"kind: fingertips: should be 'slide' or 'pinch' or 'finger"),
    (("kind: fingertip\n", ""), 1, r"kind: missing; should be 'slide' or 'pinch' or 'fingertip'"),
    (("mass: 1.0", "mas: 1.0"), 5, r"object.mas: unknown field; did you mean 'mass'"),
    (("mass: 1.0", "mass: -1"), 5, r"object.mass: -1: should be greater than 0"),
    (("mass: 1.0", "mass: .nan"), 5, r"object.mass: nan: .*finite"),
    (("mass: 1.0\n", "\n"), 2, r"object: exactly one of mass, density must be given, not none"),
    (("mass: 1.0", "mass: 1.0\n  density: 3"), 2, r"object: .*not mass and density"),
    (("mass: 1.0", "mass: 1.0\n  com: [1, 0, 0]"), 6, r"object.com: .*hull"),
    (("mass: 1.0", "mass: 1.0\n  inertia: [1, 1, 9]"), 6, r"object.inertia: .*(triangle|inertia)"),
    (("mass: 1.0", "mass: 1.0\n  inertia: [[1, 2, 3], [3, 4, 5]]"), 6, r"object.inertia.*at least 3"),
    ((BOX, "box: [0.05, 0, 0.05]"), 4, r"object.box\[1\]: 0: should be greater than 0"),
    ((f"{BOX}\n", "\n"), 2, r"object: exactly one of box, mesh, vertices must be given, not none"),
    ((BOX, f"{BOX}\n  mesh: {{file: a.stl}}"), 2, r"not box and mesh"),
    ((BOX, "mesh: {file: a.stl}"), 4, r"object.mesh.file: a.stl: no such file"),
    ((BOX, "mesh: {file: /tmp}"), 4, r"object.mesh.file: /tmp: is a folder, not a file"),
    ((BOX, "vertices: [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]"), 2, r"given together"),
    ((BOX, TETRAHEDRON.replace(", [2, 0, 3]]", ", [2, 0, 9]]")), 5, r"object.triangles: .*9"),
    ((BOX, TETRAHEDRON.replace(", [2, 0, 3]]", ", [0, 2, 3]]")), 5, r"object.triangles: .*orient"),
    ((BOX, TETRAHEDRON.replace("[2, 0, 3]", "[0, 2, 1]")), 5, r"object.triangles: .*(closed|edge)"),
    ((BOX, TETRAHEDRON.replace("[2, 0, 3]", "[4294967298, 0, 3]")), 5, r"triangles\[3\]\[0\]: 4294967298: should be less"),
    ((BOX, TETRAHEDRON.replace("[2, 0, 3]", "[99999999999, 0, 3]")), 5, r"triangles\[3\]\[0\]: 99999999999: should"),
    (("segments: 6", "segments: 100000"), 9, r"motion.slide.segments: 100000: should be less than or equal to 99999"),
    (
        (SLIDE, "sequence:\n    - slide: {translation: [1, 0, 0], segments: 99999}\n    - slide: {translation: [1, 0, 0], segments: 1}"),
        9,
        r"motion.sequence: has 100000 segments together; at most 99999",
    ),
    (
        (SLIDE, "lattice: {goal: {}, lower: [0, 0, 0], upper: [0.1, 0, 0], counts: [4294967297, 1, 1]}"),
        9,
        r"motion.lattice.counts\[0\]: 4294967297: should be less",
    ),
    ((SLIDE, "goal: {pose: {}, max_tumbles: 4294967297}"), 9, r"max_tumbles: 4294967297: should be less"),
    (("count: 2", "count: 5"), 6, r"fingers.count: 5: should be less than or equal to 4"),
    (("count: 2", "count: 0"), 6, r"fingers.count: 0: should be greater than or equal to 1"),
    (("radius: 0.01", "radius: 0"), 6, r"fingers.radius: 0: should be greater than 0"),
    (("force: 10", "force: 0"), 6, r"fingers.max_normal_force: 0: should be greater than 0"),
    (("friction: 0.7", "friction: -0.1"), 6, r"fingers.friction: -0.1: should be greater than or equal to 0"),
    (("friction: 0.7", "friction: [0.8, 0.6]"), 6, r"fingers.friction: \[0.8, 0.6\]: the first must not exceed"),
    (("friction: 0.5", "friction: -0.5"), 7, r"friction: -0.5: should be greater than or equal to 0"),
    (("friction: 0.5", "friction: .nan"), 7, r"friction: nan: .*finite"),
    (("friction: 0.5", "friction: [0.5]"), 7, r"friction: \[0.5\]: .*at least 2"),
    (("friction: 0.5", "friction: slippery"), 7, r"friction: slippery: should be a valid number"),
    (more("walls: [{name: a, normal: [0, 0, 0], offset: 0}]"), 11, r"walls\[0\].normal: .*zero"),
    (more("walls: [{name: a, normal: [1, 0, 0]}]"), 11, r"walls\[0\]: exactly one of offset, point"),
    (more("walls: [{name: floor, normal: [1, 0, 0], offset: -1}]"), 1, r"given twice: floor"),
    (more(WALL % -0.1), 11, r"walls\[0\].friction: -0.1: should be greater than or equal to 0"),
    (more(WALL % "[0.6, 0.5]"), 11, r"walls\[0\].friction: \[0.6, 0.5\]: the first must not exceed"),
    (more(WALL % ".nan"), 11, r"walls\[0\].friction: nan: .*finite"),
    (more(WALL % "[0.5, 20000]"), 11, r"walls\[0\]: .*friction.upper must lie in \[0, 10000\], not 20000"),
    (more("floor: {friction: 1e5}"), 11, r"floor: .*friction.lower must lie in \[0, 10000\], not 1"),
    (more("floor: {friction: slippery}"), 11, r"floor.friction: slippery: should be a valid number"),
    (more("gravity: [0, 0]"), 11, r"gravity: \[0, 0\]: .*at least 3"),
    (more("obstacles: [{name: a, box: [1, 1, 1]}]"), 9, r"motion.slide: .*touches obstacle a"),
    (("options: {locations_per_side: 5}", "options: {cone_edges: 2}"), 10, r"cone_edges: 2: .*3"),
    (("{locations_per_side: 5}", "{search: best}"), 10, r"options.search: best: .*'dijkstra'"),
    (("{locations_per_side: 5}", "{min_stability: 0}"), 10, r"min_stability: 0: .*greater than 0"),
    (("{locations_per_side: 5}", "{compliance: {finger: 1}}"), 10, r"compliance.finger: unknown"),
    (("{locations_per_side: 5}", "{compliance: {finger_normal: 1e10}}"), 10, r"finger_normal: .*1000000000"),
    (
        ("{locations_per_side: 5}", "{disturbance_directions: [[1, 0, 0, 0, 0, 0]]}"),
        10,
        r"options.*: .*span",
    ),
    ((SLIDE, "{}"), 8, r"motion: exactly one of slide, turn, .* must be given, not none"),
    ((SLIDE, f"{SLIDE}\n  path: []"), 10, r"motion.path: .*at least 2"),
    ((SLIDE, "slide: {translation: [0, 0, 0], segments: 6}"), 9, r"motion.slide: .*"),
    ((SLIDE, "slide: {translation: [0.1, 0, 0.1]}"), 9, r"motion.slide: .*lifts off every plane"),
    ((SLIDE, "slide: {translation: [0.1, 0, -0.1]}"), 9, r"motion.slide: .*(below|into|enters|inside)"),
    (
        (SLIDE, "slide: {translation: [0.1, 0, 0], pose: {position: [0, 0, 0.03]}}"),
        9,
        r"motion.slide: .*floats",
    ),
    ((SLIDE, "tumble: {over: up}"), 9, r"motion.tumble.over: up: should be '\+x', '-x'"),
    ((SLIDE, "tumble: {}"), 9, r"motion.tumble: exactly one of over, point"),
    ((SLIDE, "tumble: {point: [0, 0, 0]}"), 9, r"motion.tumble: point and axis .*together"),
    ((SLIDE, "tumble: {point: [0, 0, 0], axis: [0, 1, 0]}"), 9, r"tumble: angle must be given"),
    (
        (SLIDE, "tumble: {point: [0.025, 0, 0], axis: [1, 1, 0], angle: 0.4}"),
        9,
        r"motion.tumble: ",
    ),
    ((SLIDE, "turn: {angle: 0.5, axis: [0, 0, 0]}"), 9, r"motion.turn: .*axis"),
    ((SLIDE, "turn: {angle: 0.5, axis: [0, 1, 0]}"), 9, r"motion.turn: "),
    (
        (SLIDE, "lattice: {goal: {position: [0.051, 0, 0.025]}, lower: [0, 0, 0], upper: [0.1, 0, 0], counts: [11, 1, 1]}"),
        9,
        r"motion.lattice: .*along x: the goal \(0.051\) must be one of its values",
    ),
    (
        (SLIDE, "lattice: {goal: {position: [0, 0, 0.025]}, lower: [0, 0, 0], upper: [0.1, 0, 0], counts: [11, 1, 1]}"),
        9,
        r"motion.lattice.goal: must differ from the start",
    ),
    (
        (SLIDE, "goal: {pose: {position: [0, 0, 0.025]}}"),
        9,
        r"motion.goal.pose: must differ from the start",
    ),
    (
        (SLIDE, f"goal: {{pose: {{position: [0.05, 0, {ON_EDGE}], rpy: [0, 0.5, 0]}}}}"),
        9,
        r"motion.goal.pose: must have a face .* flush on 'floor'",
    ),
    (
        (SLIDE, "goal: {pose: {position: [0.05, 0, 0.5]}}"),
        9,
        r"motion.goal.pose: .*floats",
    ),
    (
        (SLIDE, "goal: {pose: {position: [0.05, 0, 0.025]}, slide_step: 0}"),
        9,
        r"motion.goal.slide_step: 0: should be greater than 0",
    ),
    (
        (SLIDE, "sequence:\n    - slide: {translation: [0.1, 0, 0]}\n    - slide: {translation: [0.1, 0, 0], pose: {}}"),
        11,
        r"motion.sequence\[1\].slide.pose: .*a step starts where the one before it ended",
    ),
    ((SLIDE, "turn: {angle: 4.7, segments: 1}"), 9, r"motion.turn: .*4.7.* may turn by 3 rad"),
    ((SLIDE, "turn: {angle: 90}"), 9, r"motion.turn.angle: 90: .* 2 turns; angles are in radians"),
    ((SLIDE, "slide: {translation: [0, 0, 1]}"), 9, r"motion.slide: .*lifts off every plane"),
    ((SLIDE, "sequence: [{}]"), 9, r"motion.sequence\[0\]: exactly one of slide, turn, tumble"),
    (more("carrier: {fingertips: [a, b]}"), 1, r"carrier is for a robot, and none is given"),
    (
        more("robot: {urdf: wam_t42_tips}\ncarrier: {fingertips: [thumb, b]}"),
        12,
        r"carrier.fingertips: .*thumb.*left_tip_center",
    ),
    (
        more("robot: {urdf: wam_t42_tips}\ncarrier: {fingertips: [left_tip_center], links: [[left_finger]]}"),
        12,
        r"carrier: .*each of 2 fingers",
    ),
]  # fmt: skip


@pytest.mark.parametrize(("change", "line", "what"), FAULTS)
def test_fault_says_file_line_field_value_and_choice(write, change, line, what):
    message = fault(write(changed(*change)))
    assert re.match(rf"task\.yaml:{line}: ", message), message
    assert re.search(what, message), message
    assert "\n" not in message


@pytest.mark.parametrize("none", ["path", "sequence", "lattice", "goal", "turn", "tumble"])
def test_a_field_that_is_null_is_not_blamed(write, none):
    wall = "walls: [{name: w, normal: [-1, 0, 0], offset: -0.05}]\nbudget:"
    text = changed("motion:", f"motion:\n  {none}: null")
    message = fault(write(changed("budget:", wall, text)))
    assert re.search(r"motion.slide: .*w\b", message), message


def test_goal_in_a_wall_is_refused(write):
    wall = "walls: [{name: w, normal: [-1, 0, 0], offset: -0.05}]\nbudget:"
    message = fault(write(changed("budget:", wall)))
    assert re.search(r"motion.slide: .*w\b", message), message


def test_mesh_in_millimetres_and_its_density(write, tmp_path):
    import trimesh

    trimesh.creation.box([50, 100, 50]).export(tmp_path / "a.stl")
    mesh = changed(BOX, "mesh: {file: a.stl, unit: mm}", changed("mass: 1.0", "density: 1000"))
    thing = graspless.load_task(write(mesh)).problem.object
    assert thing.mass == pytest.approx(0.25)
    np.testing.assert_allclose(np.ptp(thing.hull, axis=0), [0.05, 0.10, 0.05], atol=1e-9)
    light = mesh.replace(", unit: mm", "").replace("density: 1000", "density: 0.1")
    with pytest.warns(UserWarning, match=r"object.mesh: is 50 x 100 x 50 m; .*unit: mm"):
        graspless.load_task(write(light))


@pytest.mark.parametrize(
    ("change", "what"),
    [
        ((SLIDE, "turn: {angle: 7}"), r":9: motion.turn.angle: 7: .*more than a turn; .*radians"),
        (("radius: 0.01", "radius: 10"), r"fingers.radius: 10.*lengths are in metres"),
        ((SLIDE, "slide: {pose: {rpy: [0, 0, 90]}, translation: [0.1, 0, 0]}"), r"slide.pose.rpy"),
        ((SLIDE, "sequence: [{slide: {translation: [200, 0, 0]}}]"), r"translation\[0\]: 200: is"),
        (
            (SLIDE, "lattice: {goal: {}, lower: [0, 0, 0], upper: [0.1, 0.1, 90]}"),
            r"lattice.upper\[2\]: 90: is more than a turn",
        ),
    ],
)
def test_degrees_and_millimetres_are_warned_of(write, change, what):
    with pytest.warns(UserWarning, match=what), contextlib.suppress(TaskError):
        graspless.load_task(write(changed(*change)))


@pytest.mark.parametrize(
    ("scale", "what"),
    [
        (
            "1",
            r"mesh: is 50 x 50 x 100 m; lengths are in metres; .*millimetres write 'unit: mm'",
        ),
        ("1.0e-6", r"mesh: is 5e-05 x 5e-05 x 0.0001 m; lengths are in metres; .*write no scale"),
    ],
)
@pytest.mark.parametrize("parts", [False, True])
def test_the_unit_of_an_obstacle_s_mesh_is_doubted(write, tmp_path, scale, what, parts):
    import trimesh

    trimesh.creation.box([50, 50, 100]).export(tmp_path / "post.stl")
    mesh = f"mesh: {{file: post.stl, scale: {scale}}}"
    shape = f"parts: [{{box: [1, 1, 1]}}, {{{mesh}}}]" if parts else mesh
    obstacle = f"obstacles: [{{name: post, {shape}, pose: {{position: [90, 0, 0]}}}}]\nbudget:"
    place = r"obstacles\[0\].parts\[1\]." if parts else r"obstacles\[0\]."
    with pytest.warns(UserWarning, match=place + what):
        graspless.load_task(write(changed("budget:", obstacle)))
    for right in ("scale: 0.001", "unit: mm"):
        text = changed("budget:", obstacle.replace(mesh, f"mesh: {{file: post.stl, {right}}}"))
        with warnings.catch_warnings():
            warnings.simplefilter("error")
            post = graspless.load_task(write(text)).problem.obstacles[0]
        np.testing.assert_allclose(
            np.ptp(post.shapes[-1].shape.vertices, axis=0), [0.05, 0.05, 0.1]
        )


@pytest.mark.parametrize("apart", [0.2, 0.03])
def test_a_mesh_of_several_pieces_is_doubted(write, tmp_path, apart):
    import trimesh

    boxes = [trimesh.creation.box([0.05, 0.05, 0.05]) for _ in range(2)]
    boxes[1].apply_translation([apart, 0, 0])
    trimesh.util.concatenate(boxes).export(tmp_path / "a.stl")
    text = changed(BOX, "mesh: {file: a.stl}", changed("mass: 1.0", "mass: 0.2"))
    what = r"object.mesh: is not one piece: has 2 that share no corner; .* mass counts twice"
    with pytest.warns(UserWarning, match=what), contextlib.suppress(TaskError):
        graspless.load_task(write(text))


def test_a_cavity_is_no_piece(write, tmp_path):
    import trimesh

    hollow = [trimesh.creation.box([0.05, 0.05, 0.05]), trimesh.creation.box([0.04, 0.04, 0.04])]
    hollow[1].invert()
    trimesh.util.concatenate(hollow).export(tmp_path / "a.stl")
    text = changed(BOX, "mesh: {file: a.stl}", changed("mass: 1.0", "mass: 0.2"))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        graspless.load_task(write(text))


@pytest.mark.parametrize("size", [0.02, 0.05, 0.08])
def test_a_piece_that_is_inside_out_names_the_mesh(write, tmp_path, size):
    import trimesh

    boxes = [trimesh.creation.box([0.05, 0.05, 0.05]), trimesh.creation.box([size] * 3)]
    boxes[1].apply_translation([0.1, 0, 0])
    boxes[1].invert()
    trimesh.util.concatenate(boxes).export(tmp_path / "a.stl")
    text = changed(BOX, "mesh: {file: a.stl}", changed("mass: 1.0", "mass: 0.2"))
    message = fault(write(text))
    what = (
        r"object.mesh: .*its piece of 12 triangles about \(.*\) is inside out .* and is no cavity"
    )
    assert re.search(what, message), message


def test_a_tumble_of_what_stands_on_one_corner_says_the_gap_and_the_remedy(write):
    vertices = "[[0, 0, 0], [0.1, 0, 0.0003], [0, 0.1, 0.0004], [0, 0, 0.1]]"
    text = changed(BOX, TETRAHEDRON.replace(TETRAHEDRON.split(chr(10))[0][10:], vertices))
    message = fault(write(changed(SLIDE, "tumble: {over: +x}", text)))
    what = r"motion.tumble: .*no edge: its lowest two corners are 0 mm and 0.3 mm above the floor;"
    assert re.search(what + r" give a pose in which it stands on an edge", message), message


def test_inertia_and_centre_of_mass(write):
    fields = "mass: 1.0\n  com: [0.01, 0, 0]\n  inertia: [0.001, 0.0012, 0.0011]"
    thing = graspless.load_task(write(changed("mass: 1.0", fields))).problem.object
    np.testing.assert_allclose(thing.com, [0.01, 0, 0])
    np.testing.assert_allclose(thing.inertia, np.diag([0.001, 0.0012, 0.0011]))


def test_tumble_over_each_side_lies_down_on_the_next_face(write):
    for side, place in (
        ("+x", [0.05, 0]),
        ("-x", [-0.05, 0]),
        ("+y", [0, 0.075]),
        ("-y", [0, -0.075]),
    ):
        text = changed(SLIDE, f"tumble: {{over: {side}, segments: 4}}")
        X_WO = graspless.load_task(write(text)).problem.motion.X_WO
        np.testing.assert_allclose(X_WO[-1][:2, 3], place, atol=1e-12)
        corners = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)])
        heights = (corners * [0.025, 0.05, 0.025]) @ X_WO[-1][2, :3] + X_WO[-1][2, 3]
        assert np.sum(np.abs(heights) < 1e-9) == 4
        assert heights.min() > -1e-9


def test_angle_to_next_face_of_a_prism():
    prism = np.array(
        [[0, y, 0] for y in (0, 1)] + [[1, y, 0] for y in (0, 1)] + [[0, y, 2] for y in (0, 1)]
    )
    point, axis = edge(prism.astype(float), 0.0, "+x", 2.0)
    np.testing.assert_allclose(np.abs(axis), [0, 1, 0])
    assert point[0] == 1
    assert angle_to_next_face(prism.astype(float), point, axis) == pytest.approx(
        math.pi - math.atan(2)
    )
    point, axis = edge(prism.astype(float), 0.0, "-x", 2.0)
    assert angle_to_next_face(prism.astype(float), point, axis) == pytest.approx(math.pi / 2)


def test_sequence_joins_its_steps(write):
    steps = """sequence:
    - slide: {translation: [0.05, 0, 0], segments: 5}
    - tumble: {over: +x, segments: 6}
    - turn: {angle: 0.5, segments: 3}"""
    X_WO = graspless.load_task(write(changed(SLIDE, steps))).problem.motion.X_WO
    assert len(X_WO) == 5 + 6 + 3 + 1
    np.testing.assert_allclose(X_WO[-1][:3, 3], [0.10, 0, 0.025], atol=1e-12)
    turned = X_WO[-1][:3, :3] @ X_WO[11][:3, :3].T
    np.testing.assert_allclose(turned, frames.from_rpy([0, 0, 0.5])[:3, :3], atol=1e-12)


def test_lattice_goal_and_path(write):
    lattice = "lattice: {goal: {position: [0.05, 0, 0.025]}, lower: [0, 0, 0], upper: [0.1, 0, 0], counts: [11, 1, 1]}"
    motion = graspless.load_task(write(changed(SLIDE, lattice))).problem.motion
    assert isinstance(motion, fingertip.Lattice)
    assert tuple(motion.counts) == (11, 1, 1)
    goal = "goal: {pose: {position: [0.05, 0, 0.025]}, max_tumbles: 1}"
    motion = graspless.load_task(write(changed(SLIDE, goal))).problem.motion
    assert isinstance(motion, fingertip.Goal)
    assert motion.max_tumbles == 1
    assert motion.slide_step == fingertip.Goal().slide_step
    path = "path: [{position: [0, 0, 0.025]}, {position: [0.01, 0, 0.025]}]"
    motion = graspless.load_task(write(changed(SLIDE, path))).problem.motion
    assert isinstance(motion, fingertip.Path)
    assert len(motion) == 2


def test_every_option_can_be_given(write):
    given = (
        "search: paper, location_spacing: 0.02, cone_edges: 8, samples_per_arc: 2, "
        "min_stability: 0.3, regrasp_cost: 10, stability_weight: 0.02, max_regrasps: 2, threads: 2, "
        "max_memory: 1e9, explain: false, compliance: {finger_normal: 0.3}"
    )
    options = graspless.load_task(write(changed("locations_per_side: 5", given))).options
    assert options.search == fingertip.Search.paper
    assert (options.cone_edges, options.threads, options.explain) == (8, 2, False)
    assert options.compliance.finger_normal == 0.3
    assert options.compliance.environment_normal == fingertip.Compliance().environment_normal


def test_task_with_a_robot(write):
    text = changed("budget:", """\
robot: {urdf: wam_t42_tips}
carrier:
  fingertips: [left_tip_center, right_tip_center]
  links: [[left_finger], [right_finger]]
realize: {max_jump: 0.04}
budget:""")  # fmt: skip
    arm = graspless.load_task(write(text)).arm
    assert arm.robot.name
    assert arm.options.max_jump == 0.04
    assert arm.options.approach == fingertip.RealizeOptions().approach
    np.testing.assert_allclose(arm.q_home, arm.robot.state("home"))


def test_other_fingertip_plans_where_the_hand_does_not_open(write):
    text = """\
kind: fingertip
object: {name: block, box: [0.062, 0.078, 0.08], mass: 0.2}
fingers: {count: 2, radius: 0.013, max_normal_force: 10, friction: 0.8}
friction: 0.8
motion: {tumble: {over: +x, pose: {position: [0.60, 0, 0.04]}, segments: 18}}
robot: {urdf: wam_t42_tips}
"""
    best = graspless.plan(write(text + "realize: {plans: 1}\n"))
    assert best.status == fingertip.Status.not_realized
    assert "touches 'block': a hand that opens wider" in best.reason
    plan = graspless.plan(write(text))
    assert plan, plan.reason
    assert graspless.check(plan) == []
    assert plan.cost > best.cost == pytest.approx(plan.lower_bound)
    assert "the best plan costs" in plan.warnings[-1]
    assert max(s.scrub for s in plan.joint_segments) < 1e-3


def test_walls_of_the_example_are_as_written(write):
    problem = graspless.load_task(write(TUMBLE)).problem
    np.testing.assert_allclose([p.n_W for p in problem.planes], [[0, 0, 1], [1, 0, 0], [0, -1, 0]])
