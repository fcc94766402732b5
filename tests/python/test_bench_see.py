# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The comparison of perception with the truth, with a box whose truth is known."""

import json

import numpy as np
import pytest
import trimesh

from graspless.cli import main


@pytest.fixture
def folder(tmp_path):
    # It lies down: its largest side is 0.15 m x 0.1 m, and so it is 0.04 m high.
    trimesh.creation.box([0.04, 0.15, 0.1]).export(tmp_path / "carton.stl")
    return tmp_path


def test_a_box_is_found_and_measured(folder, capsys):
    out = folder / "out"
    assert main(["bench", "see", str(folder), "--poses", "1", "--out", str(out), "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["scenes"] == 9  # three levels of noise, two single views and both together
    every = result["all"]
    assert every["tables"] == every["found"] == 1
    assert every["real_right"] > 0.99
    assert every["visible_found"] > 0.95
    assert every["thickness"] < 0.001
    assert every["iou"] > 0.9
    (row,) = result["meshes"]
    assert row["thickness"] == pytest.approx(0.04, abs=1e-6)
    page = (out / "see.md").read_text()
    assert "| carton |" in page
    assert np.isfinite(json.loads((out / "see.json").read_text())["all"]["seconds"])


def test_bad_arguments_are_refused(folder, capsys):
    def refused(*arguments):
        assert main(["bench", "see", *map(str, arguments)]) == 2
        return capsys.readouterr().err

    assert "no such folder" in refused(folder / "none")
    (folder / "empty").mkdir()
    assert "has no meshes" in refused(folder / "empty")
    assert "--mesh: mug: no such mesh (one of: carton)" in refused(folder, "--mesh", "mug")
    assert "roll of tape, box, ball" in refused("--mesh", "mut")
    assert "its own objects only" in refused(folder, "--grid", "holes")
    assert "(one of: mug, pitcher, cup," in refused("--grid", "holes", "--mesh", "fork")


def test_objects_made_of_parts_need_no_folder(capsys, tmp_path):
    out = str(tmp_path / "out")
    assert main(["bench", "see", "--poses", "1", "--mesh", "box", "--out", out, "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    (row,) = result["meshes"]
    assert row["thickness"] == pytest.approx(0.06, abs=1e-6)  # it lies on its largest side
    assert result["all"]["found"] == 1
    assert "held out" in (tmp_path / "out" / "see.md").read_text()
    assert "Scans of" not in (tmp_path / "out" / "see.md").read_text()


def test_holes_are_judged_by_the_true_mesh(monkeypatch, capsys, tmp_path):
    from graspless_bench.see import holes

    monkeypatch.setattr(holes, "SIDES", 2)
    monkeypatch.setattr(holes, "NOISES", (0.0, 1.0))
    out = tmp_path / "out"
    names = ["--mesh", "scissors", "--mesh", "bowl"]
    assert main(["bench", "see", "--grid", "holes", *names, "--out", str(out), "--json"]) == 0
    result = json.loads(capsys.readouterr().out)
    assert result["scenes"] == 2 * 2 * 2 * 2
    for row in result["objects"]:
        assert row["wrong"] == 0
        assert row["right"] == row["scenes"] == 4
    assert "| bowl |" in (out / "see.md").read_text()


def test_openings_are_those_that_lines_pass():
    from graspless import geometry
    from graspless_bench.see.truth import Openings

    ring = trimesh.creation.annulus(0.04, 0.06, 0.02)
    openings = Openings(geometry.Mesh(ring.vertices, ring.faces.astype(np.int32)))
    angles = np.linspace(0, 2 * np.pi, 40, endpoint=False)
    around = np.column_stack([0.05 * np.cos(angles), 0.05 * np.sin(angles), 0 * angles])
    assert openings.has(around)  # along the ring
    across = np.column_stack([0.05 + 0.012 * np.cos(angles), 0 * angles, 0.012 * np.sin(angles)])
    assert not openings.has(across)  # around its material
    assert not openings.has(0.2 * around + [0.05, 0, 0.01])  # on its side
    ball = trimesh.creation.icosphere(2, 0.05)
    solid = Openings(geometry.Mesh(ball.vertices, ball.faces.astype(np.int32)))
    assert not solid.has(around)


def test_plans_are_timed_from_the_images_on(capsys, tmp_path, monkeypatch):
    from graspless_bench.see import plans

    monkeypatch.setattr(plans, "CARDS", 1)
    monkeypatch.setattr(plans, "NAMES", ("bucket",))
    monkeypatch.setitem(plans.POSES, "purse", plans.POSES["purse"][:1])
    assert main(["bench", "see", "--grid", "plans", "--out", str(tmp_path), "--json"]) == 0
    rows = json.loads(capsys.readouterr().out)["plans"]
    assert [(row["name"], row["views"]) for row in rows] == [
        ("slide", 1), ("slide", 2), ("clasp", 1), ("clasp", 2),
    ]  # fmt: skip
    for row in rows:
        assert row["trials"] == row["checked"] == 1
        stages = sum(row[stage] for stage in plans.STAGES)
        assert row["seconds"] == row["p90"] == pytest.approx(stages)
    assert "| slide | 1 | 1 | 1 |" in (tmp_path / "see.md").read_text()
