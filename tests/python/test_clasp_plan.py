# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Clasp plans: what is written is what was found, and what is read back checks the same."""

import json

import numpy as np
import pytest

import graspless
from clasp_common import PURSE, changed, purse_plan
from graspless import TaskError, clasp, report
from graspless.tasks import read_task
from tasks_common import reread

plan = pytest.fixture(scope="module")(purse_plan)


@pytest.fixture(scope="module")
def document(plan):
    return json.loads(plan.to_json())


def test_plan_holds_after_its_file(plan, tmp_path):
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert graspless.check(again) == []
    assert again.to_json() == plan.to_json()
    assert again == plan
    for mine, theirs in zip(plan.segments, again.segments, strict=True):
        np.testing.assert_array_equal(mine.positions, theirs.positions)
        np.testing.assert_array_equal(mine.virtual_linking, theirs.virtual_linking)


def test_file_has_the_planner_s_own_numbers(plan):
    task = plan.task
    found = clasp._core.plan(task.problem, task.options, task.budget)
    assert plan.joint_names == found.joint_names
    for mine, theirs in zip(plan.segments, found.segments, strict=True):
        assert mine.name == theirs.name
        np.testing.assert_array_equal(mine.positions, theirs.positions)  # bit by bit
        np.testing.assert_array_equal(mine.virtual_linking, theirs.virtual_linking)
    assert (plan.loop, plan.min_linking) == (found.loop, found.min_linking)
    np.testing.assert_array_equal(plan.target.point, found.target.point)
    np.testing.assert_array_equal(plan.target.tangent, found.target.tangent)
    assert plan.stability.margin == found.stability.margin
    assert plan.stability.checks == found.stability.checks
    np.testing.assert_array_equal(plan.tree.p_W, found.tree.p_W)


def test_rows_follow_each_other(plan):
    rows = np.concatenate([segment.positions for segment in plan.segments])
    assert np.abs(np.diff(rows, axis=0)).max() <= 0.05 + 1e-9
    np.testing.assert_array_equal(rows[0], plan.task.problem.q_start)


def test_path_of_the_tree_leads_from_its_root(plan):
    tree = plan.tree
    assert tree.parents[tree.path[0]] == tree.path[0]
    for before, node in zip(tree.path, tree.path[1:], strict=False):
        assert tree.parents[node] == before


@pytest.mark.parametrize(
    "change",
    [
        lambda d: d["segments"][0]["positions"][3].__setitem__(1, 0.4),
        lambda d: d["segments"][0]["object_poses"][3].__setitem__(0, 0.2),
        lambda d: d["segments"][1]["virtual_linking"][-1].__setitem__(0, 0.99),
        lambda d: d["segments"].pop(1),
        lambda d: (
            d["segments"][1]["positions"].pop()
            and d["segments"][1]["object_poses"].pop()
            and d["segments"][1]["virtual_linking"].pop()
        ),
        lambda d: d["target"]["point"].__setitem__(2, 0.0),
        lambda d: d["stability"].update(margin=0.99),
        lambda d: d["joint_names"].reverse(),
        lambda d: d.update(pre_shape="home"),
    ],
    ids=["row", "pose", "linking", "close", "last", "target", "margin", "names", "pre-shape"],
)
def test_check_finds_a_plan_that_was_changed(document, tmp_path, change):
    assert graspless.check(reread(document, tmp_path / "plan.json", change))


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (
            lambda d: d.update(kind="clap"),
            "kind: clap: should be 'slide' or 'pinch' or 'fingertip' or 'clasp'",
        ),
        (lambda d: d.update(status="unstable"), "status: unstable: should be 'solved'"),
        (lambda d: d.update(loop=-1), "loop: -1: should be greater than or equal to 0"),
        (lambda d: d.pop("stability"), "a solved plan must have loop, target and stability"),
        (lambda d: d["tree"]["parents"].pop(), "one per node is needed"),
        (lambda d: d["tree"]["path"].append(10**6), "names a node beyond"),
        (lambda d: d["segments"][0]["virtual_linking"].pop(), "one per row is needed"),
        (lambda d: d["segments"][0]["virtual_linking"][0].pop(), "rows of .1, 2. curves"),
        (lambda d: d["fingers"].pop(), "2 curves, and there are 1 fingers"),
        (lambda d: d["segments"][0]["positions"][0].pop(), "row 0 of segment 'reach' has 11"),
        (lambda d: d["segments"][0]["object_poses"][0].__setitem__(3, 2.0), "not of unit length"),
        (lambda d: d["task"].pop("object"), "object: missing"),
    ],
)
def test_broken_plan_files(document, tmp_path, change, what):
    with pytest.raises(TaskError, match=what) as caught:
        reread(document, tmp_path / "plan.json", change)
    assert str(caught.value).startswith(str(tmp_path / "plan.json"))


def test_report_names_loop_fingers_and_margin(plan):
    text = report.as_text(plan)
    assert "clasps the loop, " in text
    assert "finger_1 " in text
    assert f"margin {plan.stability.margin:.2f}" in text
    assert "secure: the loop escapes in 0 of 10 sequences of random moves" in text
    assert len(text.splitlines()) < 12
    printed = report.as_dict(plan)
    assert printed["loop"] == 0
    assert set(printed["virtual_linking"]) == {"finger_1", "finger_2"}
    assert min(printed["virtual_linking"].values()) >= plan.min_linking
    json.dumps(printed)


@pytest.mark.parametrize(("mass", "is_too_heavy"), [(0.1, False), (1000, True)])
def test_an_object_that_is_heavier_than_the_load_is_told(plan, tmp_path, mass, is_too_heavy):
    text = changed("sample: purse", f"sample: purse\n  mass: {mass}")
    heavy = graspless.plan(read_task(text, "purse.yaml"))
    assert heavy.stability.withstands == plan.stability.withstands
    words = [
        f"the object weighs 9810 N, and the hand withstands a sudden "
        f"{plan.stability.withstands:.3g} N at most: it may be forced open"
    ]
    assert list(heavy.warnings) == (words if is_too_heavy else [])
    heavy.save(tmp_path / "plan.json")
    assert graspless.check(graspless.load_plan(tmp_path / "plan.json")) == []


def test_cloud_without_a_hole_is_told_with_its_betti_curve(tmp_path):
    import trimesh

    ball = trimesh.creation.icosphere(subdivisions=3, radius=0.1)
    np.savetxt(tmp_path / "ball.xyz", ball.vertices)
    (tmp_path / "task.yaml").write_text(changed("sample: purse", "cloud: ball.xyz"))
    plan = graspless.plan(tmp_path / "task.yaml")
    assert not plan
    assert (plan.status, plan.loop, plan.target) == ("no_reliable_hole", None, None)
    text = report.as_text(plan)
    assert plan.reason in text
    assert (
        "loops by longest edge of the complex: " in text
        or "no holes at any longest edge of the complex" in text
    )
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    assert again == plan
    assert graspless.check(again)[0].startswith(
        "nothing to check: the plan's status is no_reliable"
    )


@pytest.mark.parametrize("x", [0.5, 0.55])
def test_a_start_from_which_turning_to_the_loop_hits_the_object(x):
    """Every step of Algorithm 2 turns the hand: no tree left its root, in any time."""
    thing = {"name": "purse", "sample": "purse", "seed": 2, "pose": {"position": [x, 0.05, 0]}}
    task = {"kind": "clasp", "robot": {"urdf": "kr5_sdh"}, "object": thing}
    found = graspless.plan({**task, "budget": {"seconds": 20}}, seed=1)
    assert found, found.reason
    assert graspless.check(found) == []


def test_no_time_is_a_status():
    plan = graspless.plan(read_task(PURSE, "purse.yaml"), iterations=0)
    assert not plan
    assert plan.status == "not_found"
    assert plan.segments == ()
    assert graspless.check(plan)
