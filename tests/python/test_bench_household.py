# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Household objects in small: boxes of our own, seen, picked up and lifted."""

import json

import numpy as np
import pytest
import trimesh

from graspless import frames
from graspless.cli import main
from graspless_bench.household import run, scenes


@pytest.fixture
def folder(tmp_path):
    trimesh.creation.box([0.10, 0.04, 0.035]).export(tmp_path / "bar.stl")
    trimesh.creation.box([0.3, 0.25, 0.2]).export(tmp_path / "crate.stl")
    return tmp_path


def test_a_bar_is_held_and_a_crate_is_refused(folder, capsys):
    out = folder / "out"
    excluded = folder / "excluded.yaml"
    excluded.write_text("wam_t42: {crate: too large, none: not in the folder}\n")
    asked = ["bench", "household", str(folder), "--poses", "1", "--out", str(out), "--json"]
    asked += ["--excluded", str(excluded)]
    assert main(asked) == 0
    result = json.loads(capsys.readouterr().out)
    rows = {row["mesh"]: row for row in result["rows"]}
    assert rows["bar"]["stage"] == "held", rows["bar"]
    assert rows["bar"]["strategy"] == "pinch"
    assert rows["crate"]["stage"] == "refused"
    assert "the hand opens" in rows["crate"]["reason"]
    (setting,) = result["settings"]
    assert (setting["robot"], setting["views"]) == ("wam_t42", 1)
    pick, kept, only = setting["groups"][:3]
    assert (kept["held"], kept["trials"]) == (1, 1)
    assert result["excluded"] == {"wam_t42": {"crate": "too large"}}
    assert (pick["held"], pick["trials"], only["held"]) == (1, 2, 1)
    low, high = pick["band"]
    assert 0 < low < 0.5 < high < 1
    page = (out / "household.md").read_text()
    assert "| bar | pinch: held |" in page
    assert "- wam_t42, crate: too large" in page
    assert not (out / "household.rows").exists()


def test_rows_of_an_interrupted_run_are_kept(folder, tmp_path):
    log = tmp_path / "rows"
    row = {"mesh": "bar", "pose": 0, "robot": "wam_t42", "views": 1, "seed": 1, "stage": "kept"}
    log.write_text(json.dumps(row) + "\n" + '{"mesh": "cut sh')
    (bar,) = [path for path in folder.iterdir() if path.stem == "bar"]
    assert run.run([bar], ["wam_t42"], [1], 1, {}, seed=1, log=log) == [row]


def test_two_views_see_all_sides(folder):
    """A second camera sees the sides that the first one does not."""
    mesh, (X, *_) = scenes.stable_poses(folder / "crate.stl", 1)
    thing = scenes.placed(mesh, X, 0.3, np.random.default_rng(1))
    middle = thing.points[:, 0].mean()
    behind = []
    for views in (1, 2):
        (found,) = scenes.seen(thing, 5, views).objects
        at = frames.transform(found.X_WO, np.asarray(found.points))
        side = at[(at[:, 2] > 0.03) & (at[:, 2] < 0.17)]
        behind.append((side[:, 0] > middle).mean())
    assert behind[0] < 0.2 < 0.4 < behind[1]


def test_the_parts_have_the_mass_and_the_place_of_the_mesh():
    mesh = trimesh.creation.box([0.10, 0.03, 0.05])
    rng = np.random.default_rng(2)
    X = trimesh.transformations.rotation_matrix(0.5, [1, 2, 3])
    thing = scenes.placed(mesh, X, 0.3, rng)
    corners = mesh.vertices @ thing.X_WT[:3, :3].T + thing.X_WT[:3, 3]
    assert corners[:, 2].min() == pytest.approx(0, abs=1e-9)
    body = scenes.truth(thing, np.eye(4))
    assert body.mass == 0.3
    assert body.com == pytest.approx(corners.mean(axis=0), abs=1e-4)
    R = thing.X_WT[:3, :3]
    a, b, c = 0.10, 0.03, 0.05
    own = 0.3 / 12 * np.diag([b * b + c * c, a * a + c * c, a * a + b * b])
    assert body.inertia == pytest.approx(R @ own @ R.T, rel=0.02, abs=1e-6)


def test_bad_arguments_are_refused(folder, tmp_path, capsys):
    def refused(*arguments):
        assert main(["bench", "household", *map(str, arguments)]) == 2
        return capsys.readouterr().err

    assert "no such folder" in refused(folder / "none")
    assert "--mesh: mug: no such mesh" in refused(folder, "--mesh", "mug")
    assert "--masses: " in refused(folder, "--masses", tmp_path / "none.yaml")
    masses = tmp_path / "masses.yaml"
    masses.write_text("bar: heavy\n")
    assert "bar: heavy: should be a mass in kg" in refused(folder, "--masses", masses)
    excluded = tmp_path / "excluded.yaml"
    assert "--excluded: " in refused(folder, "--excluded", excluded)
    excluded.write_text("wam_t42: {bar: 3}\n")
    assert "wam_t42: " in (said := refused(folder, "--excluded", excluded))
    assert "should have a reason for each mesh, as text" in said
    excluded.write_text("panda: {bar: too wide}\n")
    assert "panda: should be one of wam_t42" in refused(folder, "--excluded", excluded)
    assert "their names should differ" in refused(folder, "--robots", "wam_t42, a/wam_t42.urdf")
    assert "--views: 3: should be 1, 2 or 1,2" in refused(folder, "--views", "3")
