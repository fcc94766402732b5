# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Certificates of plans of all kinds, and `graspless check --certify`."""

import json
import pickle

import pytest

import graspless
from graspless import _api, _data, collision, frames, geometry, slide
from graspless.cli import main
from graspless.plan_files import read_plan
from graspless.scene import EdgeCertificate, Verdict

EXAMPLES = _data.directory("examples")


@pytest.fixture(scope="module")
def plan():
    found = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=1)
    assert found, found.reason
    return found


def test_a_slide_is_proven(plan):
    assert graspless.check(plan, certify=True) == []
    (certificate,) = graspless.certify(plan)
    assert certificate
    assert certificate.num_edges == sum(len(segment) - 1 for segment in plan.segments)
    assert certificate.num_certified == certificate.num_edges
    assert certificate.doubts == []
    assert repr(certificate) == (
        f"<EdgeCertificate of {certificate.num_edges} of {certificate.num_edges} edges>"
    )


@pytest.mark.parametrize(
    ("name", "count"),
    [("24_carry_bar", 1), ("12_t42_tumble", 1), ("17_wam_clasp", 1), ("19_slide_then_lift", 2)],
)
def test_every_kind_is_proven(name, count):
    found = graspless.plan(EXAMPLES / f"{name}.yaml", seed=1)
    assert found, found.reason
    certificates = graspless.certify(found)
    assert len(certificates) == count
    for certificate in certificates:
        assert certificate.num_edges > 10
        assert certificate, [str(doubt) for doubt in certificate.doubts]


def with_ball(plan, p, radius):
    problem = plan.task.problem
    ball = geometry.PlacedShape(geometry.Sphere(radius))
    obstacle = collision.Obstacle("ball", [ball], frames.translation(p))
    return slide.Problem(
        problem.robot,
        problem.hand,
        problem.object,
        problem.support,
        problem.X_WO_start,
        problem.q_home,
        [obstacle],
    )


def test_a_touch_between_the_rows_is_refuted(plan):
    """A ball that grows until the samples touch it is touched between them before that."""
    problem, options = plan.task.problem, plan.task.options
    way = next(segment for segment in plan.segments if segment.name == "reach")
    q = 0.55 * way.positions[len(way) // 2] + 0.45 * way.positions[len(way) // 2 - 1]
    p = problem.robot.pose(problem.hand.grasp_frame, q)[:3, 3] + [0, 0, 0.25]
    clear, touching = 1e-4, 0.2
    assert slide.check(with_ball(plan, p, clear), plan, options) == []
    while touching - clear > 1e-8:
        radius = (clear + touching) / 2
        if slide.check(with_ball(plan, p, radius), plan, options):
            touching = radius
        else:
            clear = radius
    certificate = slide.certify(with_ball(plan, p, clear), plan, options)
    assert not certificate
    doubt = certificate.doubts[0]
    assert doubt.verdict == Verdict.refuted
    assert "ball" in doubt.condition
    assert doubt.condition in str(doubt)
    assert 0 <= doubt.t <= 1
    assert doubt.unit == "m"
    assert certificate.num_certified < certificate.num_edges
    made = pickle.loads(pickle.dumps(certificate))
    assert (repr(made), *map(str, made.doubts)) == (
        repr(certificate),
        *map(str, certificate.doubts),
    )


def test_command_line(plan, tmp_path, capsys):
    path = tmp_path / "plan.json"
    plan.save(path)
    assert main(["check", str(path), "--certify"]) == 0
    edges = sum(len(segment) - 1 for segment in plan.segments)
    assert f"all {edges} edges between rows are certified" in capsys.readouterr().out
    assert main(["check", str(path), "--certify", "--json"]) == 0
    assert json.loads(capsys.readouterr().out) == {
        "holds": True,
        "faults": [],
        "certified_edges": edges,
        "edges": edges,
    }


def test_command_line_says_what_is_not_proven(plan, tmp_path, capsys):
    path = tmp_path / "plan.json"
    document = json.loads(plan.to_json())
    lift = next(s for s in document["segments"] if s["name"] == "lift")
    lift["positions"][0][0] += 5e-7  # a jump that the replay allows
    path.write_text(json.dumps(document))
    assert graspless.check(path) == []
    assert main(["check", str(path), "--certify"]) == 1
    out = capsys.readouterr().out
    edges = sum(len(segment) - 1 for segment in plan.segments)
    assert f"the plan is not certified, {edges} of {edges} edges are certified:" in out
    assert "lift row 0" in out


def test_rounding_between_segments_is_no_motion(plan):
    document = json.loads(plan.to_json())
    lift = next(s for s in document["segments"] if s["name"] == "lift")
    lift["positions"][0][0] += 1e-12
    rounded = read_plan(json.dumps(document), "rounded")
    assert rounded.segments[2].positions[-1][0] != rounded.segments[3].positions[0][0]
    assert graspless.check(rounded, certify=True) == []


def test_faults_come_before_certificates(plan):
    broken = plan.__copy__()
    broken.segments = broken.segments[:-1]
    assert graspless.check(broken, certify=True) == graspless.check(broken)
    with pytest.raises(ValueError, match="segments are not"):
        graspless.certify(broken)


def test_what_is_not_solved_is_not_certified():
    task = graspless.load_task(EXAMPLES / "01_slide_card.yaml").with_changes(iterations=1)
    unsolved = graspless.plan(task)
    if not unsolved:
        with pytest.raises(ValueError, match="only solved plans"):
            graspless.certify(unsolved)
    with pytest.raises(ValueError, match="cannot be certified"):
        slide.certify(task.problem, slide.Plan())
    assert EdgeCertificate()
    assert EdgeCertificate().num_edges == 0


def test_a_plan_is_searched_until_it_is_proven():
    found = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=1, certify=True)
    assert found
    assert graspless.check(found, certify=True) == []


@pytest.mark.parametrize(("counts", "seed"), [([2, 1, 0, 0], 7), ([3, 1, 2] * 7, 6), ([0], 5)])
def test_other_seeds_are_tried_while_edges_are_doubted(monkeypatch, counts, seed):
    doubts = iter(counts)
    monkeypatch.setattr(
        _api, "checked", lambda plan, with_certificate: (["?"] * next(doubts), (0, 1))
    )
    found = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=5, certify=True)
    assert found.seed == seed


def test_the_search_for_a_certificate_ends_without_one(monkeypatch):
    monkeypatch.setattr(_api, "checked", lambda plan, with_certificate: (["?"], None))
    found = graspless.plan(EXAMPLES / "01_slide_card.yaml", seed=5, seconds=0.2, certify=True)
    assert found.seed == 5
    card = graspless.load_task(EXAMPLES / "01_slide_card.yaml").to_dict()
    card["object"]["pose"]["x"] = 0.99  # out of reach
    assert not graspless.plan(card, iterations=20, certify=True)


def test_certify_and_prove_are_not_combined(tmp_path, capsys):
    with pytest.raises(graspless.TaskError, match="certify: cannot be combined with prove"):
        graspless.plan(EXAMPLES / "01_slide_card.yaml", certify=True, prove=1)
    command = ["plan", str(EXAMPLES / "01_slide_card.yaml"), "-o", str(tmp_path / "plan.json")]
    assert main([*command, "--certify", "--prove", "1"]) == 2
    assert "--certify: cannot be combined with --prove" in capsys.readouterr().err
    assert main([*command, "--certify"]) == 0
    assert "edges between rows are certified" in capsys.readouterr().out


def test_a_plan_without_joints_is_not_certified(tmp_path, capsys):
    path = str(tmp_path / "plan.json")
    push = graspless.plan(EXAMPLES / "06_push_block.yaml", seed=3, certify=True)
    assert push.seed == 3  # no other seed is tried
    push.save(path)
    assert graspless.check(push) == []
    (fault,) = graspless.check(push, certify=True)
    assert fault.startswith("not certified: bare fingertips have no joint paths")
    assert graspless.certify(push) == []
    assert main(["check", path]) == 0
    capsys.readouterr()
    assert main(["check", path, "--certify"]) == 1
    assert capsys.readouterr().out == f"the plan is not certified:\n{fault}\n"
