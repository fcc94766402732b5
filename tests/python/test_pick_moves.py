# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picks of blocks that fingertips tumble or push before the hand grasps them."""

import dataclasses
import math

import numpy as np
import pytest

import graspless
from graspless import frames, geometry, perception, picking
from graspless.cli import main
from graspless.picking import duration
from graspless.picking.block import Block, block_of, level, wish_at
from graspless.picking.moves import misplaced, pushes, tumbles
from graspless.picking.moving import Moving, moving_of
from graspless.picking.wish import wish_of
from graspless.tasks import task_from_dict
from pick_common import FLOOR, TABLE, body, seen

TIPS = "wam_t42_tips"
BOX = ([0.118, 0.112, 0.04], 0.6, 0.0, 0.02)
WALLS = tuple(([0.14, 0.02, 0.12], 0.6, y, 0.06) for y in (0.11, -0.11))
BAR = ([0.10, 0.045, 0.06], 0.6, 0.0, 0.03)
SLABS = tuple(([0.16, 0.03, 0.1], 0.6, y, 0.05) for y in (0.0495, -0.0495))
LARGE = ([0.118, 0.112, 0.09], 0.6, 0.0, 0.045, 0.3)


def at(scene, x, y):
    """Name of the object that is nearest to a point, seen from above."""
    off = [np.linalg.norm(np.asarray(thing.X_WO)[:2, 3] - (x, y)) for thing in scene.objects]
    return scene.objects[int(np.argmin(off))].name


def wished(scene, name, robot=TIPS, mass=0.5):
    return wish_of(scene, "scene", name, robot, lift=0.1, respect="objects", mass=mass)


@pytest.fixture(scope="module")
def between_walls():
    """A flat box that is too wide for the hand, between two walls, and its name."""
    scene = seen(BOX, *WALLS)
    return scene, at(scene, 0.6, 0.0)


@pytest.fixture(scope="module")
def tumbled(between_walls):
    scene, name = between_walls
    return graspless.pick(scene, name, TIPS, mass=0.8, strategies=["pinch", "tumble"], seconds=60)


def some_block(rng):
    X_WB = frames.planar(*rng.uniform([0.4, -0.2, -3], [0.7, 0.2, 3]))
    size = rng.uniform(0.03, 0.2, 3)
    X_WB[2, 3] = 0.1 + size[2] / 2
    return Block(size, X_WB)


@pytest.mark.parametrize("seed", range(5))
def test_a_block_stands_on_its_floor_after_each_move(seed):
    block = some_block(np.random.default_rng(seed))
    base = np.zeros(2)
    for move in [*tumbles(block, base), *pushes(block, base)]:
        goal = move.goal
        signs = np.array(np.meshgrid(*[[-1, 1]] * 3)).reshape(3, -1).T
        corners = (signs * goal.size / 2) @ goal.X_WB[:3, :3].T + goal.X_WB[:3, 3]
        assert corners[:, 2].min() == pytest.approx(0.1, abs=1e-12)
        assert np.ptp(corners[:, 2]) == pytest.approx(goal.height)
        assert goal.height * np.prod(goal.sides) == pytest.approx(np.prod(block.size))
        off = np.linalg.norm(corners[:, None, :2] - goal.corners[None], axis=2).min(axis=1)
        assert off.max() < 1e-12
        assert geometry.Polygon(goal.corners).area == pytest.approx(np.prod(goal.sides))


@pytest.mark.parametrize("seed", range(3))
def test_the_motion_of_a_move_ends_at_its_goal(seed):
    block = some_block(np.random.default_rng(seed))
    for move in [*tumbles(block, np.zeros(2)), *pushes(block, np.zeros(2))[::7]]:
        document = {
            "kind": "fingertip",
            "object": {"box": block.size.tolist(), "mass": 0.2},
            "floor": {"height": 0.1},
            "motion": move.motion,
        }
        poses = task_from_dict(document, "task").problem.motion.X_WO
        assert poses[0] == pytest.approx(block.X_WB, abs=1e-12)
        assert poses[-1] == pytest.approx(move.goal.X_WB, abs=1e-9)


def test_tumbles_lie_as_low_as_possible_and_pushes_are_short():
    block = Block(np.array([0.2, 0.1, 0.03]), frames.translation([0.5, 0, 0.015]))
    heights = [move.goal.height for move in tumbles(block, np.zeros(2))]
    assert heights == pytest.approx([0.1, 0.1, 0.2, 0.2])
    found = pushes(block, np.zeros(2))
    assert found[0].words == "pushed 4 cm towards 180 deg"  # to the robot
    assert any("turned by 45 deg" in move.words for move in found)


@pytest.mark.parametrize(
    "box",
    [
        LARGE,
        ([0.15, 0.1, 0.03], 0.55, 0.1, 0.015, 0.8),
        ([0.2, 0.03, 0.1], 0.7, -0.2, 0.05, 0.1),
        ([0.08, 0.18, 0.02], 0.45, -0.1, 0.01, 1.1),
    ],
)
def test_a_box_is_found_to_be_a_block(box):
    scene = seen(box)
    block = block_of(level(wished(scene, scene.objects[0].name)))
    assert isinstance(block, Block), block
    assert sorted(block.size) == pytest.approx(sorted(box[0]), abs=0.004)
    assert block.X_WB[:3, 3] == pytest.approx(box[1:4], abs=0.004)
    long = block.X_WB[:3, max(block.across, key=lambda k: block.size[k])]
    across = box[4] + (math.pi / 2 if box[0][1] > box[0][0] else 0)
    assert abs(long @ [math.cos(across), math.sin(across), 0]) > math.cos(math.radians(3))


def test_what_is_no_block_is_refused_with_a_number():
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    ring = 0.06 * np.column_stack([np.cos(angles), np.sin(angles)])
    corners = np.concatenate([np.column_stack([ring, np.full(40, z)]) for z in (0.0, 0.04)])
    disc = perception.Body(
        [geometry.PlacedShape(geometry.Convex(corners))], frames.translation([0.6, 0, 0])
    )
    frame = perception.render(
        [body(*TABLE), body(*FLOOR), disc], perception.look_at([-0.05, 0, 0.75], [0.65, 0, 0])
    )
    scene = graspless.perceive(frame.depth, frame.K, frame.X_WC)
    found = graspless.pick(scene, at(scene, 0.6, 0), TIPS, mass=0.3, strategies=["tumble"])
    assert not found
    assert "no block: its" in found.reason
    assert "at most 6 mm are allowed" in found.reason


def test_a_tilted_support_is_refused_with_its_angle(between_walls):
    scene, name = between_walls
    wish = wished(scene, name)
    flat = level(wish)
    assert np.asarray(flat.support.X_WS)[2, 2] == 1.0
    ring = np.asarray(flat.support.polygon)
    assert geometry.Polygon(ring).area == pytest.approx(
        geometry.Polygon(wish.support.polygon).area, rel=1e-3
    )
    old = wish.support
    tilted = perception.Support(
        name=old.name, polygon=old.polygon, edges=old.edges, X_WS=frames.from_rpy([0.1, 0, 0])
    )
    reason = level(dataclasses.replace(wish, support=tilted))
    assert reason == f"{old.name} is tilted by 5.7 deg, at most 1.1 deg are allowed"


def test_the_fingertips_of_a_hand_are_found_by_their_shapes(between_walls):
    scene, name = between_walls
    budget = graspless.planning.Budget()
    moving = moving_of("tumble", wished(scene, name), None, budget)
    assert isinstance(moving, Moving), moving
    assert moving.opening == pytest.approx(0.054)
    assert moving.tips.frames == ["left_tip_center", "right_tip_center"]
    assert moving.tips.radius == pytest.approx(0.013)
    assert moving.tips.apart == pytest.approx(0.08, abs=1e-3)
    refused = moving_of("tumble", wished(scene, name, robot="wam_t42"), None, budget)
    assert "no frame at the centre of the round end of 'left_finger'" in refused


def test_a_box_between_walls_is_tumbled_and_pinched(between_walls, tumbled):
    assert tumbled, tumbled.reason
    assert tumbled.strategy == "tumble"
    assert tumbled.attempts[0].status == "too_wide"
    assert "41 mm wide there, the hand opens 54 mm" in tumbled.attempts[1].reason
    plan = tumbled.plan
    assert [stage.kind for stage in plan.stages] == ["fingertip", "pinch", "carry"]
    assert graspless.check(plan) == []
    assert duration(plan) > 2.0
    box = plan.stages[0].task.problem.object.hull
    assert sorted(np.ptp(box, axis=0)) == pytest.approx([0.04, 0.112, 0.118], abs=0.004)
    first, last = (plan.stages[k].segments[-1].object_poses[-1] for k in (1, 2))
    assert last[2, 3] - first[2, 3] == pytest.approx(0.1, abs=1e-3)


def test_the_plan_holds_over_its_interval_of_friction(tumbled):
    moved = tumbled.plan.stages[0]
    assert moved.statistics.seconds < 60
    fields = moved.task.fields
    assert fields.friction == [0.45, 0.55]
    assert fields.fingers.friction == [0.63, 0.77]
    assert moved.task.options.min_stability >= 1.0
    assert max(segment.scrub for segment in moved.joint_segments) <= 0.0015


def test_a_chain_of_a_pick_is_saved_loaded_and_timed(tumbled, tmp_path):
    tumbled.plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert graspless.check(again) == []
    assert again.names == ["tumble", "pinch", "lift"]
    trajectory = graspless.time(again)
    assert np.all(np.diff(trajectory.times) > 0)


def test_a_tumble_and_its_pinch_hold_in_mujoco(tumbled):
    pytest.importorskip("mujoco")
    from graspless import simulation

    found = simulation.simulate(tumbled.plan, trials=2, record=True)
    assert found, [trial.failures for trial in found.trials]
    for trial in found.trials:
        assert trial.measures["kept"] == 1.0
        assert trial.measures["left_error"] < 2e-3
    film = found.trials[0].recording
    assert np.all(np.diff(film.times) > 0)
    assert {"tumble", "retreat", "close", "hold"} <= set(film.names)
    off = np.linalg.norm(film.object_poses[:, :3, 3] - film.planned_poses[:, :3, 3], axis=1)
    assert off.max() < 5e-3  # in one frame of the object throughout


def test_what_is_lost_by_the_fingertips_is_not_grasped(tumbled):
    pytest.importorskip("mujoco")
    from graspless.simulation import chain
    from graspless.simulation.variation import Variation

    trial = chain.run(tumbled.plan, Variation(friction=0.2, support_friction=0.2))
    assert trial.failures == ("fingers_lost",)
    assert "kept" not in trial.measures


def test_what_was_tumbled_is_put_down(between_walls):
    scene, name = between_walls
    place = {"pose": {"x": 0.5, "y": 0.22}}
    found = graspless.pick(
        scene, name, TIPS, mass=0.5, strategies=["tumble"], place=place, seconds=60
    )
    assert found, found.reason
    assert found.plan.names == ["tumble", "pinch", "lift", "place"]
    assert graspless.check(found.plan) == []
    end = found.plan.stages[-1].segments[-1].object_poses[-1]
    assert end[:2, 3] == pytest.approx([0.5, 0.22], abs=2e-3)


def test_a_bar_between_slabs_is_pushed_out_and_pinched():
    scene = seen(BAR, *SLABS)
    found = graspless.pick(
        scene, at(scene, 0.6, 0.0), TIPS, mass=0.3, strategies=["pinch", "push"], seconds=60
    )
    assert found, found.reason
    assert found.attempts[0].status == "not_reached"
    assert found.attempts[1].reason.startswith("pushed ")
    assert [stage.kind for stage in found.plan.stages] == ["fingertip", "pinch", "carry"]
    assert graspless.check(found.plan) == []
    poses = found.plan.stages[0].segments[0].X_WO
    assert np.ptp(poses[:, 2, 3]) < 1e-9  # it stays on the table


def test_a_tile_is_tumbled_flat_and_slid_to_an_edge():
    scene = seen(([0.052, 0.12, 0.11], 0.7, 0.0, 0.055, 0.3))
    found = graspless.pick(
        scene, scene.objects[0].name, TIPS, mass=0.3, strategies=["tumble"], seconds=60
    )
    assert found, found.reason
    assert [stage.kind for stage in found.plan.stages] == ["fingertip", "slide", "carry"]
    assert "mm high there, the hand opens 54 mm" in found.attempts[0].reason
    assert graspless.check(found.plan) == []


@pytest.mark.filterwarnings("ignore:.*no description of the hand")  # for a clasp
def test_refusals_come_early_and_have_a_number():
    scene = seen(LARGE)
    found = graspless.pick(scene, scene.objects[0].name, TIPS, mass=0.5)
    reasons = {attempt.strategy: attempt for attempt in found.attempts}
    assert not found
    assert {reasons[name].status for name in ("tumble", "push")} == {"refused"}
    for name in ("tumble", "push"):
        assert "no side fits the 54 mm hand" in reasons[name].reason
        assert reasons[name].seconds < 2.0
    assert "one that opens 95 mm (+41 mm) would do" in reasons["tumble"].reason


def test_a_mass_is_needed(between_walls):
    scene, name = between_walls
    found = graspless.pick(scene, name, TIPS, strategies=["tumble"])
    assert not found
    assert "its mass is needed" in found.reason


def test_a_place_for_the_tumbled_block_must_be_free(between_walls):
    scene, name = between_walls
    flat = level(wished(scene, name))
    block = block_of(flat)
    assert not any(misplaced(move, flat) for move in tumbles(block, np.zeros(2)))
    near = Block(block.size, frames.translation([0, 0.03, 0]) @ block.X_WB)
    words = [misplaced(move, flat) for move in tumbles(near, np.zeros(2))]
    assert any("is there" in word for word in words)  # towards a wall
    beyond = Block(block.size, frames.translation([0.5, 0, 0]) @ block.X_WB)
    words = [misplaced(move, flat) for move in tumbles(beyond, np.zeros(2))]
    assert any("mm beyond the edge of" in word for word in words)


def test_the_wish_at_a_goal_is_a_prism_there(between_walls):
    scene, name = between_walls
    flat = level(wished(scene, name))
    block = block_of(flat)
    for move in tumbles(block, np.zeros(2)):
        there = wish_at(flat, move.goal)
        assert there.outline.area == pytest.approx(np.prod(move.goal.sides))
        assert there.thing.thickness == pytest.approx(move.goal.height)
        ring = np.asarray(there.thing.outline) @ there.thing.X_WO[:2, :2].T
        ring = ring + there.thing.X_WO[:2, 3]
        off = np.linalg.norm(ring[:, None] - move.goal.corners[None], axis=2).min(axis=1)
        assert off.max() < 1e-9


def test_the_same_seed_gives_the_same_tumble(between_walls, tumbled):
    scene, name = between_walls
    again = graspless.pick(
        scene, name, TIPS, mass=0.8, strategies=["pinch", "tumble"], seconds=60
    ).plan
    one, two = (plan.stages[0].to_json() for plan in (tumbled.plan, again))
    assert one.split('"stats"')[0] == two.split('"stats"')[0]


def test_the_command_and_the_task_file(between_walls, tmp_path, capsys, monkeypatch):
    scene, name = between_walls
    monkeypatch.chdir(tmp_path)
    perception.save_scene(scene, "scene.yaml")
    (tmp_path / "pick.yaml").write_text(
        f"{{kind: pick, scene: scene.yaml, name: {name}, robot: {{urdf: {TIPS}}}, mass: 0.8, "
        "strategies: [pinch, tumble], budget: {seconds: 60}}"
    )
    assert main(["pick", "pick.yaml"]) == 0
    out = capsys.readouterr().out
    assert "tumble, then pinch, then lift" in out
    assert "tumble solved: tumbled towards" in out
    assert main(["check", "plan.json"]) == 0
    assert main(["pick", "scene.yaml", name, "--robot", TIPS, "--strategies", "tumble"]) == 1
    assert "its mass is needed" in capsys.readouterr().out


@pytest.mark.filterwarnings("ignore:.*no description of the hand")  # for a clasp
def test_what_a_hand_cannot_do_takes_no_time_of_the_others(between_walls):
    scene, name = between_walls
    for robot, waiting in (("wam_t42", 3), (TIPS, 5)):
        found = graspless.pick(scene, name, robot, seconds=0.5)
        assert found.attempts[0].strategy == "pinch"
        assert picking._waiting(found.attempts, 1) == waiting
