# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Where the object of a slide can be: in plans, files and summaries."""

from __future__ import annotations

import json
import math

import numpy as np
import pytest

import graspless
from graspless import report, slide
from graspless.tasks import read_task

pytestmark = pytest.mark.filterwarnings("error")

CARD = """
kind: slide
robot: {urdf: wam_t42}
object: {rectangle: {size: [0.12, 0.08]}, thickness: 0.003, mass: MASS, pose: {x: 0.62, y: 0.08, yaw: 0.4}}
support: {rectangle: {center: [0.65, 0.0], size: [0.7, 0.7]}}
budget: {seconds: 5, seed: 1}
"""  # noqa: E501


def card(mass, **options):
    document = CARD.replace("MASS", str(mass))
    text = document + (f"options: {json.dumps(options)}\n" if options else "")
    return read_task(text, "card")


@pytest.fixture(scope="module")
def plan():
    found = graspless.plan(card(0.05))
    assert found, found.reason
    return found


def rows(plan):
    return next(len(s) for s in plan.segments if s.name == "slide")


def test_there_is_a_bound_for_each_row(plan):
    tube = plan.tube
    assert len(tube.position) == len(tube.angle) == rows(plan)
    assert min(tube.position) > 0.003  # the object's position at the start is as uncertain
    assert min(tube.angle) > 0.0349
    again = slide.tube(plan.task.problem, plan, plan.task.options)
    assert again.position == pytest.approx(tube.position, abs=1e-9)
    assert again.angle == pytest.approx(tube.angle, abs=1e-9)


def test_a_file_keeps_it(plan, tmp_path):
    plan.save(tmp_path / "plan.json")
    document = json.loads((tmp_path / "plan.json").read_text())
    assert document["tube"]["position"] == pytest.approx(plan.tube.position, abs=1e-8)
    back = graspless.load_plan(tmp_path / "plan.json")
    assert back.tube.angle == pytest.approx(plan.tube.angle, abs=1e-8)
    assert graspless.check(back) == []


@pytest.mark.parametrize(
    ("edit", "told"),
    [
        (lambda tube: tube.update(position=[p / 2 for p in tube["position"]]), "m off, not"),
        (lambda tube: tube.update(angle=[0.0 for _ in tube["angle"]]), "rad off, not"),
        (lambda tube: tube["angle"].pop(), "a bound of at least 0 for each row"),
        (lambda tube: tube["position"].__setitem__(0, -1.0), "a bound of at least 0 for each row"),
        (lambda tube: tube.update(position=[2 * p for p in tube["position"]]), None),
        (lambda tube: tube.update(position=[], angle=[]), None),
    ],
)
def test_check_reads_the_claim_of_a_file(edit, told, plan, tmp_path):
    document = json.loads(plan.to_json())
    edit(document["tube"])
    (tmp_path / "edited.json").write_text(json.dumps(document))
    faults = graspless.check(graspless.load_plan(tmp_path / "edited.json"))
    if told is None:
        assert faults == []
    else:
        assert len(faults) == 1
        assert faults[0].startswith("tube")
        assert told in faults[0]


def test_check_finds_a_heavier_object(plan, tmp_path):
    document = json.loads(plan.to_json())
    document["task"]["object"]["mass"] = 2.5
    (tmp_path / "heavy.json").write_text(json.dumps(document))
    faults = graspless.check(graspless.load_plan(tmp_path / "heavy.json"))
    assert any(fault.startswith("tube: friction may leave") for fault in faults)


def test_files_of_before_state_nothing(plan, tmp_path):
    document = json.loads(plan.to_json())
    del document["tube"]
    (tmp_path / "old.json").write_text(json.dumps(document))
    old = graspless.load_plan(tmp_path / "old.json")
    assert not old.tube.position
    assert graspless.check(old) == []
    assert "off this plan" not in report.as_text(old)


def test_the_summary_tells_its_end(plan):
    position, angle = 1000 * plan.tube.position[-1], math.degrees(plan.tube.angle[-1])
    assert (
        f"after the slide, it may be {position:.1f} mm and {angle:.1f} deg off this plan"
        in report.as_text(plan)
    )


def test_what_cannot_be_dragged_is_refused_with_the_number():
    refused = graspless.plan(card(8))
    assert refused.status == "cannot_drag"
    assert "times the friction that the pad has" in refused.reason
    assert "object.mass 8 kg" in refused.reason
    assert not refused.tube.position
    assert graspless.plan(card(8, refuse_lag=False))


def test_the_object_is_inside_it_in_a_physics_engine(plan):
    pytest.importorskip("mujoco")
    from graspless import simulation

    result = simulation.simulate(plan, 2, seed=3)
    for trial in result.trials:
        assert trial.measures["position_error"] <= plan.tube.position[-1]
        assert trial.measures["angle_error"] <= plan.tube.angle[-1]


def test_a_finger_that_jams_drags_the_object_along():
    certain = dict.fromkeys(("friction_spread", "mass_spread", "flexure_spread", "com_spread"), 0.0)
    certain |= dict.fromkeys(("thickness_spread", "height_spread", "position_spread"), 0.0)
    certain |= {"refuse_lag": False, "angle_spread": 0.0, "tracking_spread": 0.0}
    smooth = graspless.plan(card(0.05, **certain))
    problem = smooth.task.problem

    def rough(times):  # both frictions, so that their ratio is the same
        support, hand = problem.support, problem.hand
        more = slide.Support(
            support.polygon.vertices, support.X_WS, friction=times * support.friction
        )
        hand.pad_friction *= times
        return slide.Problem(
            problem.robot, hand, problem.object, more, problem.X_WO_start, problem.q_home
        )

    tubes = [slide.tube(rough(times), smooth, smooth.task.options) for times in (1, 3, 4, 6)]
    assert max(max(tube.position) for tube in tubes) < 0.01


def test_a_support_that_is_too_slippery_for_its_slope_is_refused():
    document = CARD.replace("MASS", "0.05").replace(
        "support: {", "support: {friction: 0.1, pose: {rpy: [0, -0.14, 0]}, "
    )
    with pytest.raises(
        ValueError,
        match=r"support.friction: 0.1: must be at least 0.1409\d*, the slope of the support: the",
    ):
        graspless.plan(read_task(document, "steep"))


@pytest.mark.parametrize(
    ("options", "told"),
    [
        ({"friction_spread": 1.0}, "friction_spread"),
        ({"mass_spread": -0.1}, "mass_spread"),
        ({"position_spread": float("nan")}, "position_spread"),
    ],
)
def test_spreads_that_are_none(options, told, plan):
    with pytest.raises(ValueError, match=told):
        slide.plan(plan.task.problem, slide.Options(**options))


def test_numbers_of_a_tube():
    tube = slide.Tube(position=[0.1, 0.2], angle=np.array([0.3]))
    assert (list(tube.position), list(tube.angle)) == ([0.1, 0.2], [0.3])
    with pytest.raises(TypeError):
        slide.Tube(position="wide")
