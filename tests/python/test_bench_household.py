# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Household objects in small: boxes of our own, seen, picked up and lifted."""

import itertools
import json

import numpy as np
import pytest
import trimesh
from scipy.spatial import ConvexHull

from graspless import frames, geometry
from graspless.cli import main
from graspless_bench.household import run, scenes
from graspless_bench.household import things as bench_things


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
    (bar,) = [path for path in folder.iterdir() if path.stem == "bar"]
    (query,) = run.queries([bar], ["wam_t42"], [1], 1, {}, 1, [bar])
    log = tmp_path / "rows"
    row = query.row | {"stage": "kept"}
    log.write_text(json.dumps(row) + "\n" + '{"mesh": "cut sh')
    assert run.run([query], log=log) == [row]


def test_tables_and_neighbours_are_dealt_out(folder):
    """Six successive drops of an object see each table, alone and with neighbours."""
    paths = sorted(folder.iterdir())
    drops = run.queries(paths[:1], ["wam_t42"], [1], 6, {}, 1, paths)
    assert len({query.dealt for query in drops}) == 6
    assert {query.dealt[0] for query in drops} == set(scenes.TABLES)


@pytest.fixture
def things(folder):
    return [bench_things.read(folder / f"{name}.stl", 0.3) for name in ("bar", "crate")]


def apart(a, b):
    """Distance between two things, seen from above; 0 if one is on the other [m]."""
    hulls = [geometry.Polygon(x.border[ConvexHull(x.border).vertices]) for x in (a, b)]
    if any(hulls[0].contains(p) for p in b.border) or any(hulls[1].contains(p) for p in a.border):
        return 0.0
    return np.linalg.norm(a.border[:, None] - b.border[None], axis=2).min()


def test_a_small_neighbour_is_beside_a_large_object(tmp_path):
    trimesh.creation.cylinder(0.13, 0.02).export(tmp_path / "plate.stl")
    trimesh.creation.box([0.02] * 3).export(tmp_path / "cube.stl")
    plate, cube = (bench_things.read(tmp_path / f"{name}.stl", 0.1) for name in ("plate", "cube"))
    placed = 0
    for seed in range(40):
        rng = np.random.default_rng(seed)
        given = scenes.setting(scenes.TABLES["square"], plate, [cube], rng)
        placed += len(given.others)
        for other in given.others:
            assert scenes.GAP[0] < apart(given.target, other) < scenes.GAP[1]
    assert placed > 20


@pytest.mark.parametrize("table", scenes.TABLES)
def test_things_stand_on_the_table_clear_of_each_other(things, table):
    bar, crate = things
    count = 0
    for seed in range(5):
        rng = np.random.default_rng(seed)
        given = scenes.setting(scenes.TABLES[table], bar, [bar, crate], rng)
        ground = geometry.Polygon(given.table)
        placed = [given.target, *given.others]
        count += len(given.others)
        for item in placed:
            assert item.points[:, 2].min() == pytest.approx(0, abs=1e-9)
            assert min(ground.depth(p) for p in item.border) >= scenes.MARGIN
        for a, b in itertools.combinations(placed, 2):
            assert apart(a, b) > scenes.GAP[0]
    assert count >= 5


def test_what_is_larger_than_the_table_has_no_place(things):
    _, crate = things
    assert (
        scenes.setting(0.3 * scenes.TABLES["square"], crate, [], np.random.default_rng(1)) is None
    )


def test_what_is_dropped_rests_on_a_side(things):
    """A box lies on one of its six sides, whatever it was dropped on."""
    _, crate = things
    for seed in range(5):
        up = bench_things.dropped(crate, np.random.default_rng(seed))[2, :3]
        assert np.abs(up).max() == pytest.approx(1, abs=1e-3)


def test_two_views_see_all_sides(things):
    """A second camera sees the sides that the first one does not."""
    _, crate = things
    given = scenes.setting(scenes.TABLES["square"], crate, [], np.random.default_rng(1))
    middle, top = given.target.points[:, 0].mean(), given.target.points[:, 2].max()
    behind = []
    for views in (1, 2):
        (found,) = scenes.seen(given, 5, views).objects
        at = frames.transform(found.X_WO, np.asarray(found.points))
        side = at[(at[:, 2] > 0.03) & (at[:, 2] < top - 0.03)]
        behind.append((side[:, 0] > middle).mean())
    assert behind[0] < 0.2 < 0.4 < behind[1]


def test_the_parts_have_the_mass_and_the_place_of_the_mesh(tmp_path):
    mesh = trimesh.creation.box([0.10, 0.03, 0.05])
    mesh.export(tmp_path / "block.stl")
    thing = bench_things.read(tmp_path / "block.stl", 0.3)
    X_WT = trimesh.transformations.rotation_matrix(0.5, [1, 2, 3])
    X_WT[:3, 3] = 0.5, -0.2, 0.1
    body = scenes.Placed(thing, X_WT).body
    assert body.mass == 0.3
    assert body.com == pytest.approx(X_WT[:3, 3], abs=1e-4)
    R = X_WT[:3, :3]
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
