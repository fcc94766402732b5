# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Certificate of a clasp: in plans, files, reports, and as a function."""

import json

import numpy as np
import pytest

import graspless
from clasp_common import PURSE, problem, purse_plan
from graspless import TaskError, clasp, report
from graspless.tasks import read_task
from tasks_common import reread

SHAPE = clasp.StabilityOptions(force=0, torque=0)  # without a load


plan = pytest.fixture(scope="module")(purse_plan)


@pytest.fixture(scope="module")
def document(plan):
    return json.loads(plan.to_json())


def opened(plan, share):
    """Last row of a plan, with the hand opened by a share of the way."""
    robot, hand = plan.task.problem.robot, plan.task.problem.hand
    q = np.array(plan.segments[-1].positions[-1])
    joints = robot.group(hand.hand)
    q[joints] += share * (np.asarray(robot.state(hand.open)) - q)[joints]
    return q


def test_plan_carries_its_certificate(plan):
    found = plan.certificate
    assert found.caged
    assert found.lower <= found.upper < 0
    assert found.upper == pytest.approx((found.gap - found.thickness) / 2, abs=1e-9)
    assert 0.005 < found.thickness < plan.task.problem.object.loops.found[0].thickness
    assert set(found.between) <= set(plan.task.problem.robot.frame_names)
    q = plan.segments[-1].positions[-1]
    again = clasp.certificate(plan.task.problem, q, plan.loop, plan.task.options.certificate)
    assert (again.lower, again.upper, again.moves) == (found.lower, found.upper, found.moves)
    assert 0 < plan.statistics.certificate_seconds < plan.statistics.seconds


def test_what_is_caged_does_not_come_free(plan):
    """Where random moves find a way out, the hand does not cage; an open hand never does."""
    task = plan.task.problem
    uppers = []
    for share in (0.0, 0.05, 0.1, 0.2, 0.3, 0.5, 1.0):
        q = opened(plan, share)
        found = clasp.certificate(task, q, plan.loop, clasp.CertificateOptions(moves=0))
        uppers.append(found.upper)
        free = clasp.test_stability(task, q, plan.loop, SHAPE).escapes > 0
        assert not (free and found.upper < -0.003)  # the moves may enter the hand by 3 mm
    assert uppers[0] < 0 < uppers[-1]
    assert uppers[3:] == sorted(uppers[3:])


@pytest.mark.parametrize(
    ("field", "value"),
    [
        ("caged", False),
        ("lower", 0.0),
        ("upper", -0.5),
        ("thickness", 0.1),
        ("gap", -0.1),
        ("between", ["palm", "palm"]),
    ],
)
def test_check_finds_a_certificate_that_was_changed(document, tmp_path, field, value):
    broken = json.loads(json.dumps(document))
    broken["certificate"][field] = value
    (fault,) = graspless.check(reread(broken, tmp_path / "plan.json"))
    assert fault.startswith("plan: certificate is not what is found again")


def test_a_hand_that_was_opened_is_not_caged_any_more(document, plan, tmp_path):
    broken = json.loads(json.dumps(document))
    broken["segments"][1]["positions"][-1] = opened(plan, 0.1).tolist()
    faults = graspless.check(reread(broken, tmp_path / "plan.json"))
    assert any("certificate" in fault for fault in faults)


def test_plan_files_without_a_certificate_hold(document, tmp_path):
    older = json.loads(json.dumps(document))
    del older["certificate"]
    older["task"]["options"].pop("certificate")
    again = reread(older, tmp_path / "plan.json")
    assert again.certificate is None
    assert graspless.check(again) == []
    assert "caged" not in report.as_text(again)
    assert report.as_dict(again)["certificate"] is None


def test_report_says_caged_only_where_that_is_proven(document, plan, tmp_path):
    found = plan.certificate
    first, second = found.between
    text = report.as_text(plan)
    core = f"a loop with a core of {1000 * found.thickness:.1f} mm"
    assert f"caged: {core} does not pass the gap of" in text
    assert f"mm between {first} and {second} (opening {1000 * found.lower:.1f} to" in text
    assert report.as_dict(plan)["certificate"]["upper"] == found.upper
    for change, says in (
        ({"caged": False, "upper": 0.001}, "not proven to be caged: a loop"),
        ({"caged": False, "upper": 1e6, "between": ["", ""]}, "no ring of the hand is linked"),
    ):
        other = json.loads(json.dumps(document))
        other["certificate"].update(change)
        text = report.as_text(reread(other, tmp_path / "plan.json"))
        assert says in text
        assert "\ncaged" not in text


def test_options_of_a_task(plan):
    text = PURSE + "options: {certificate: {moves: 0, tolerance: 0.001}}\n"
    options = read_task(text, "purse.yaml").options
    assert (options.certificate.moves, options.certificate.tolerance) == (0, 0.001)
    q = plan.segments[-1].positions[-1]
    found = clasp.certificate(plan.task.problem, q, plan.loop, options.certificate)
    assert found.moves == 0
    assert found.upper == plan.certificate.upper
    assert found.lower < plan.certificate.lower
    for bad in ("moves: -1", "tolerance: 0", "seed: -3"):
        with pytest.raises(TaskError, match=f"options.certificate.{bad.split(':')[0]}"):
            read_task(PURSE + f"options: {{certificate: {{{bad}}}}}\n", "purse.yaml")


def test_nonsense_is_refused():
    given = problem()
    q = given.q_start
    with pytest.raises(ValueError, match="loop must be the index of one of the 1 loops"):
        clasp.certificate(given, q, 3)
    with pytest.raises(ValueError, match="q"):
        clasp.certificate(given, q[:-1], 0)
    with pytest.raises(ValueError, match="tolerance must lie in"):
        clasp.certificate(given, q, 0, clasp.CertificateOptions(tolerance=np.nan))
