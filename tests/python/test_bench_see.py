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
