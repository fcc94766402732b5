# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Rims: vessels that a camera saw, picked up by their walls, and heights in files."""

import copy
import json

import numpy as np
import pytest

import graspless
from graspless import frames, geometry, perception, pinch, robot, slide
from graspless.errors import TaskError
from graspless.picking.strategies import chain_of
from graspless.picking.wish import heights_fields, wish_of
from pick_common import FLOOR, TABLE, body

pytestmark = pytest.mark.filterwarnings(
    "ignore:.*object_0: "
)  # vessels have level faces, and hide parts of themselves


def box_cup(side=0.12, wall=0.006, height=0.08, bottom=0.012):
    """Shapes of a square vessel, in its own frame."""
    out = (side - wall) / 2
    sizes = [
        ([side, side, bottom], [0, 0, bottom / 2]),
        *(([wall, side, height], [x, 0, height / 2]) for x in (-out, out)),
        *(([side, wall, height], [0, y, height / 2]) for y in (-out, out)),
    ]
    return [geometry.PlacedShape(geometry.Box(s), frames.translation(p)) for s, p in sizes]


def round_cup(radius=0.055, wall=0.006, height=0.08, bottom=0.012, sides=24):
    """Shapes of a round vessel."""
    angles = 2 * np.pi * (np.arange(sides + 1)) / sides
    rings = [r * np.column_stack([np.cos(angles), np.sin(angles)]) for r in (radius, radius - wall)]
    shapes = []
    for i in range(sides):
        flat = np.concatenate([ring[i : i + 2] for ring in rings])
        shapes.append(prism(flat, height))
    return [*shapes, prism(rings[0][:-1], bottom)]


def prism(flat, height):
    corners = np.concatenate([np.column_stack([flat, np.full(len(flat), z)]) for z in (0, height)])
    return geometry.PlacedShape(geometry.Convex(corners))


EYE = [-0.05, 0.0, 0.75]  # of the camera [m]


def seen(shapes, x=0.6, y=0.05, yaw=0.4, eyes=(EYE,)):
    """The perceived scene of a vessel on a table."""
    vessel = perception.Body(shapes, frames.planar(x, y, yaw))
    bodies = [body(*TABLE), body(*FLOOR), vessel]
    views = [perception.render(bodies, perception.look_at(eye, [0.65, 0.0, 0.0])) for eye in eyes]
    depth, K, X_WC = (np.stack([getattr(v, key) for v in views]) for key in ("depth", "K", "X_WC"))
    found = graspless.perceive(depth, K, X_WC)
    assert len(found.objects) == 1, found.reason
    return found


def rim(scene, **given):
    return graspless.pick(scene, "object_0", "wam_t42", strategies=["rim"], **given)


@pytest.fixture(scope="module")
def found():
    picked = rim(seen(box_cup()), mass=0.06)
    assert picked, picked.reason
    return picked


@pytest.mark.parametrize(
    ("shapes", "place"),
    [
        (box_cup(), {}),
        (box_cup(side=0.14, wall=0.012, height=0.06), {"yaw": 0.6}),
        (round_cup(), {}),
        (round_cup(radius=0.06, wall=0.004, height=0.1), {"x": 0.55, "y": -0.05}),
    ],
)
def test_a_vessel_is_held_by_its_wall(shapes, place):
    scene = seen(shapes, **place)
    picked = graspless.pick(scene, "object_0", "wam_t42", mass=0.06)
    assert picked, picked.reason
    assert picked.strategy == "rim"
    assert picked.attempts[0].status == "too_wide"  # of the pinch
    assert graspless.check(picked.plan) == []
    first = picked.plan.stages[0]
    assert first.kind == "pinch"
    assert first.max_mass >= 0.06
    X = np.linalg.inv(frames.planar(**{"x": 0.6, "y": 0.05, "yaw": 0.4} | place)) @ first.X_WO_start
    p = np.asarray(first.contacts_O) @ X[:3, :3].T + X[:3, 3]
    assert [is_inside(shapes, q) for q in p].count(True) <= 1
    middle = p.mean(axis=0)
    assert np.linalg.norm(middle[:2]) > 0.04  # at the wall, not across the vessel
    simulation = graspless.simulate(picked.plan)
    assert simulation, simulation.trials[0].failures


def test_a_hand_that_is_half_open_reaches_into_a_narrow_vessel():
    vessel = box_cup(side=0.066, height=0.07)
    picked = rim(seen(vessel, eyes=(EYE, (1.35, 0.0, 0.75))), mass=0.06)
    assert picked, picked.reason
    assert graspless.check(picked.plan) == []
    first = picked.plan.stages[0]
    assert first.task.options.opening == pytest.approx(first.opening / 2)
    simulation = graspless.simulate(picked.plan)
    assert simulation, simulation.trials[0].failures


def test_a_wall_is_seen_from_both_sides_before_it_is_grasped():
    """A square vessel before the camera shows the inside or the outside of each wall."""
    one = rim(seen(box_cup(), yaw=0.1), mass=0.06)
    assert not one
    assert "a view from another side may help" in one.reason
    two = rim(seen(box_cup(), yaw=0.1, eyes=(EYE, [1.3, 0.2, 0.75])), mass=0.06)
    assert two, two.reason
    assert graspless.check(two.plan) == []


def is_inside(shapes, p):
    """True if a point is in the cavity: no shape is there, and some are to all sides."""
    height = max(extent(shape, [0, 0, 1]) for shape in shapes)
    return bool(np.linalg.norm(p[:2]) < 0.05 and p[2] < height)


def extent(placed, direction):
    shape = placed.shape
    corners = (
        np.asarray(shape.vertices)
        if hasattr(shape, "vertices")
        else np.array(np.meshgrid(*[(-s / 2, s / 2) for s in np.ravel(shape.size)]))
        .reshape(3, -1)
        .T
    )
    return float((frames.transform(placed.X_BG, corners) @ direction).max())


def test_the_simulated_vessel_is_the_true_one():
    """The plan, made on what was seen, holds on the shapes themselves, with what was not seen."""
    from graspless.simulation import chain as chains
    from graspless.simulation.slide.truth import Body, Truth
    from graspless.simulation.variation import Variation

    shapes = box_cup()
    X_WT = frames.planar(0.6, 0.05, 0.4)
    picked = rim(seen(shapes), mass=0.06)
    assert picked, picked.reason
    X_OT = np.linalg.inv(picked.plan.stages[0].X_WO_start) @ X_WT
    parts = []
    for placed in shapes:
        signs = np.array(np.meshgrid(*3 * [(-0.5, 0.5)])).reshape(3, -1).T
        corners = signs * np.ravel(placed.shape.size)
        parts.append(frames.transform(X_OT @ placed.X_BG, corners))
    com = frames.transform(X_OT, np.array([[0, 0, 0.035]]))[0]
    truth = Truth(Body(parts, 0.06, com, np.diag([2e-4, 2e-4, 3e-4])))
    trial = chains.run(picked.plan, Variation(), truth=truth)
    assert not set(trial.failures) - {"off_target", "tipped"}, trial.failures
    assert trial.measures["kept"] == 1


@pytest.mark.parametrize(
    ("shapes", "mass", "status", "words"),
    [
        ([body([0.12, 0.12, 0.08], 0, 0, 0.04).shapes[0]], 0.1, "too_wide", "the hand opens 54 mm"),
        (box_cup(side=0.2, wall=0.065), 0.1, "too_wide", "mm thick where it is thinnest, the hand"),
        (box_cup(), 2.0, "too_heavy", "N a finger; it weighs 2.00 kg"),
        (box_cup(bottom=0.066), 0.1, "no_room", "mm too high there"),
        (box_cup(height=0.018, bottom=0.004), 0.1, "too_flat", "or more over the support"),
    ],
)
def test_what_cannot_be_held_has_its_number(shapes, mass, status, words):
    if len(shapes) == 1:  # a full block
        shapes = [geometry.PlacedShape(shapes[0].shape, frames.translation([0, 0, 0.04]))]
    picked = rim(seen(shapes), mass=mass)
    assert not picked
    attempt = picked.attempts[0]
    assert attempt.status == status, attempt.reason
    assert words in attempt.reason


@pytest.mark.filterwarnings("ignore:.*<limit> without effort")
def test_the_force_of_the_fingers_can_be_given(tmp_path):
    """A hand without effort limits holds a wall if its force is known."""
    arm = robot.builtin("wam_t42")
    text = arm.read_text()
    assert text.count(' effort="2"') == 2
    (tmp_path / "arm.urdf").write_text(text.replace(' effort="2"', ""))
    for ending in (".srdf", ".hand.yaml"):
        (tmp_path / f"arm{ending}").write_text(arm.with_name(f"wam_t42{ending}").read_text())
    scene, given = seen(box_cup()), {"strategies": ["rim"], "mass": 0.06}
    unknown = graspless.pick(scene, "object_0", tmp_path / "arm.urdf", **given)
    assert unknown.attempts[0].status == "unknown_force"
    known = graspless.pick(scene, "object_0", tmp_path / "arm.urdf", grip_force=8.0, **given)
    assert known.plan is not None, known.reason
    assert known.plan.stages[0].task.options.grip_force == 8.0
    assert graspless.check(known.plan) == []
    weak = rim(scene, mass=0.06, grip_force=0.1)
    assert "at 0.1 N a finger; it weighs 0.06 kg" in weak.attempts[0].reason


def test_heights_are_seen_no_lower_than_they_are():
    scene = seen(round_cup())
    fields = heights_fields(wish(scene), 0.0025)
    rows, undersides = np.array(fields["rows"]), np.array(fields["undersides"])
    thing = scene.objects[0]
    X_TO = np.linalg.inv(frames.planar(0.6, 0.05, 0.4)) @ thing.X_WO
    i, j = np.meshgrid(*map(np.arange, rows.shape), indexing="ij")
    flat = np.array(fields["corner"]) + fields["cell"] * (np.stack([i, j], -1) + 0.5)
    p = np.concatenate([flat, np.zeros((*i.shape, 1))], axis=-1) @ X_TO[:3, :3].T + X_TO[:3, 3]
    r = np.linalg.norm(p[..., :2], axis=-1)
    inside, wall = r < 0.046, (r > 0.0505) & (r < 0.0535)
    assert (rows[inside] > 0.012 - 0.004).all()
    assert np.quantile(rows[wall], 0.05) > 0.08 - 0.004
    assert np.median(rows[inside]) < 0.06  # the camera looks in
    assert (undersides <= rows).all()


def test_the_thin_bottom_of_a_vessel_is_no_wall():
    """It is as high as the table, so that the rays to it have no known end, but they are clear."""
    scene = seen(box_cup(bottom=0.0015))
    thing = scene.objects[0]
    assert max(np.asarray(image.clear).max() for image in thing.rays) > 0.5
    rows = np.array(heights_fields(wish(scene), 0.0025)["rows"])
    middle = rows[tuple(slice(n // 2 - 4, n // 2 + 4) for n in rows.shape)]
    assert np.median(middle) < 0.05
    assert rim(scene, mass=0.06)


def wish(scene):
    return wish_of(scene, "scene", "object_0", "wam_t42", lift=0.1, respect="objects", mass=0.06)


def test_a_scene_file_keeps_what_the_heights_need(tmp_path):
    scene = seen(box_cup(bottom=0.0015))
    perception.save_scene(scene, tmp_path / "scene.yaml")
    again = perception.load_scene(tmp_path / "scene.yaml")
    a, b = (np.array(heights_fields(wish(one), 0.0025)["rows"]) for one in (scene, again))
    assert a.shape == b.shape
    assert (np.abs(a - b) < 0.003).mean() > 0.98  # the file rounds the rays


def test_plan_and_task_files_keep_the_heights(found, tmp_path):
    found.plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert again == found.plan
    assert graspless.check(again) == []
    heights = json.loads((tmp_path / "plan.json").read_text())["task"]["stages"][0]["object"]
    assert set(heights["heights"]) == {"corner", "cell", "rows", "undersides"}


def test_an_edited_plan_is_at_fault(found):
    first = found.plan.stages[0]
    assert graspless.check(first) == []
    for change in (
        lambda plan: setattr(plan, "max_mass", 9.0),
        lambda plan: setattr(plan, "contacts_O", np.asarray(plan.contacts_O) + [0, 0, 0.03]),
        lambda plan: setattr(plan, "contacts_O", np.asarray(plan.contacts_O) * [0.5, 0.5, 1]),
    ):
        edited = copy.copy(first)
        change(edited)
        assert graspless.check(edited)


def test_a_problem_with_heights_made_in_python(found):
    given = found.plan.stages[0].task.problem
    task = graspless.plan(given, seed=1).task
    fields = task.fields.object.heights
    assert np.allclose(fields.rows, np.asarray(given.object.heights.heights))
    assert np.allclose(fields.undersides, np.asarray(given.object.heights.undersides))
    solid = geometry.HeightMap([0, 0], 0.01, np.full((3, 4), 0.02))
    assert solid.undersides is None
    thing = slide.Object.prism("thing", [[0, 0], [0.03, 0], [0.03, 0.04], [0, 0.04]], 0.02)
    assert thing.heights is None
    assert len(thing.with_heights(solid).shapes) == 1
    assert np.isclose(thing.with_heights(solid).scaled(2).heights.cell, 0.02)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"rows": [[0.01, 0.02], [0.01]]}, "rows must be equally long"),
        ({"rows": [[0.01, 5.0], [0.01, 0.01]], "undersides": None}, "at most the thickness"),
        ({"rows": [[0.0, 0.0]], "undersides": None}, "one of at least 1e-6 m"),
        ({"cell": -1}, "heights.cell"),
        ({"undersides": [[0.0]]}, "as many as .heights"),
    ],
)
def test_bad_heights_are_named(change, words):
    task = chain_of("rim", wish(seen(box_cup())), 1, 5.0)
    stage = {k: v for k, v in task["stages"][0].items() if k != "name"} | {"robot": task["robot"]}
    stage["object"]["heights"] |= change
    with pytest.raises(TaskError, match="heights") as caught:
        graspless.plan(stage)
    assert words in str(caught.value)


def test_a_tray_is_slid_with_the_finger_in_it():
    picked = graspless.pick(
        seen(box_cup(side=0.16, height=0.03, bottom=0.006)),
        "object_0",
        "wam_t42",
        strategies=["slide"],
        mass=0.1,
    )
    assert picked, picked.reason
    assert graspless.check(picked.plan) == []
    tray = picked.plan.stages[0].task.problem.object
    assert tray.top < 0.01
    assert tray.thickness == pytest.approx(0.03, abs=0.003)


def test_a_slide_needs_a_level_part():
    task = chain_of("slide", wish(seen(box_cup(height=0.03))), 1, 5.0)
    stage = {k: v for k, v in task["stages"][0].items() if k != "name"} | {"robot": task["robot"]}
    rows = [[0.01 + 0.01 * ((i + j) % 2) for j in range(14)] for i in range(14)]
    stage["object"]["heights"] = {"corner": [-0.07, -0.07], "cell": 0.01, "rows": rows}
    plan = graspless.plan(stage)
    assert plan.status == slide.Status.no_start_root
    assert "nothing to press on" in plan.reason


def test_a_pick_of_what_is_nowhere_level_has_a_reason():
    angles = 2 * np.pi * np.arange(24) / 24
    foot = 0.07 * np.column_stack([np.cos(angles), np.sin(angles), 0 * angles])
    cone = geometry.PlacedShape(geometry.Convex(np.concatenate([foot, [[0, 0, 0.03]]])))
    picked = graspless.pick(
        seen([cone], x=0.55, y=0.1), "object_0", "wam_t42", strategies=["slide"]
    )
    assert not picked
    assert "nothing to press on" in picked.reason


def test_a_vessel_is_put_down_again():
    picked = rim(seen(box_cup()), mass=0.06, place={"pose": {"x": 0.6, "y": -0.2}})
    assert picked, picked.reason
    assert graspless.check(picked.plan) == []
    assert isinstance(picked.plan.stages[0], pinch.Plan)
