# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mutated tasks, plan files, clouds and command lines: a result, or one message and exit code 2."""

import io
import json
import shutil
import warnings
from contextlib import redirect_stderr, redirect_stdout

import numpy as np
import PIL.Image
import pytest
import yaml
from hypothesis import given
from hypothesis import strategies as st

import graspless
from fuzz_common import ROOT, edited, fuzzed, refused_or, require_message, spliced
from graspless import cli
from graspless.perception.view_files import kind_of, read_view
from graspless.tasks.clouds import read_cloud

EXAMPLES = sorted((ROOT / "examples").glob("*.yaml"))
DOCUMENTS = [yaml.safe_load(path.read_text()) for path in EXAMPLES]
PLANNED = ["01_slide_card", "06_push_block", "13_clasp_purse", "19_slide_then_lift", "24_carry_bar"]
LIMITS = {"seconds": 0.2, "iterations": 30}

WORDS = [
    b": ", b"- ", b"\n", b"  ", b"[", b"]", b"{", b"}", b"&a ", b"*a", b"<<: ", b"!!int ", b"!!binary ",
    b"|\n", b'"', b"'", b"#", b"%YAML 1.1\n", b"---\n", b"...\n", b"\t", b"\0", b"\xff", b"null", b"~",
    b"-1", b"0", b"1e9", b"1e-9", b".nan", b"-.inf", b"9" * 30, b"0x1f", b"1:30", b"2001-01-01",
]  # fmt: skip


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    """A copy of the examples as working folder: tasks find their clouds and meshes."""
    folder = tmp_path_factory.mktemp("fuzz")
    for path in (ROOT / "examples").iterdir():
        shutil.copy(path, folder)
    with pytest.MonkeyPatch.context() as patch:
        patch.chdir(folder)
        yield folder


@pytest.fixture(scope="module")
def plans(folder):
    """The plan files of some examples, as data."""
    found = [graspless.plan(folder / f"{name}.yaml") for name in PLANNED]
    assert all(found)
    return [json.loads(plan.to_json()) for plan in found]


def require_plan(task, folder):
    """A task can be planned, or is refused; its plan can be written and read, and holds."""
    plan = refused_or(lambda: graspless.plan(task, **LIMITS))
    if plan is None:
        return
    assert plan or plan.reason
    plan.save(folder / "plan.json")
    read = graspless.load_plan(folder / "plan.json")
    assert read == plan
    assert not plan or graspless.check(read) == []


@fuzzed
@given(document=edited(DOCUMENTS))
def test_tasks_as_data(folder, document):
    require_plan(document, folder)


@fuzzed
@given(text=spliced([path.read_bytes() for path in EXAMPLES], WORDS))
def test_task_files(folder, text):
    path = folder / "fuzzed.yaml"
    path.write_bytes(text)
    require_plan(path, folder)


@fuzzed
@given(data=st.data())
def test_plan_files(folder, plans, data):
    path = folder / "fuzzed.json"
    path.write_text(json.dumps(data.draw(edited(plans))))
    plan = refused_or(lambda: graspless.load_plan(path))
    if plan is not None:
        faults = refused_or(lambda: graspless.check(plan))
        assert faults is None or all(isinstance(fault, str) for fault in faults)


@fuzzed
@given(data=st.data())
def test_bytes_of_plan_files(folder, plans, data):
    path = folder / "fuzzed.json"
    path.write_bytes(data.draw(spliced([json.dumps(plan).encode() for plan in plans], WORDS)))
    plan = refused_or(lambda: graspless.load_plan(path))
    if plan is not None:
        refused_or(lambda: graspless.check(plan))


def clouds():
    """Small clouds in every format that is read."""
    points = "0 0 0\n0.1 0 0.02\n0 0.1 0.01\n"
    fields = "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 3\nHEIGHT 1\n"
    pcd = f"VERSION .7\n{fields}VIEWPOINT 0 0 0 1 0 0 0\nPOINTS 3\nDATA "
    numbers = np.array(points.split(), dtype="<f4").tobytes()
    ply = "ply\nformat {} 1.0\nelement vertex 3\n"
    ply += "".join(f"property float {axis}\n" for axis in "xyz") + "end_header\n"
    array = io.BytesIO()
    np.save(array, np.array(points.split(), dtype="<f4").reshape(3, 3))
    return {
        ".npy": [array.getvalue()],
        ".xyz": [points.encode()],
        ".pcd": [f"{pcd}ascii\n{points}".encode(), f"{pcd}binary\n".encode() + numbers],
        ".ply": [
            (ply.format("ascii") + points).encode(),
            ply.format("binary_little_endian").encode() + numbers,
        ],
    }


CLOUD_WORDS = [
    b" ", b"\n", b"-1", b"0", b"1", b"4", b"8", b"4000000000", b"nan", b"1e40", b"x", b"list uchar int ",
    b"property ", b"element face 2\n", b"uchar", b"double", b"binary", b"binary_compressed", b"U", b"I",
]  # fmt: skip


@fuzzed
@given(suffix=st.sampled_from(sorted(clouds())), data=st.data())
def test_clouds(folder, suffix, data):
    path = (folder / "fuzzed").with_suffix(suffix)
    path.write_bytes(data.draw(spliced(clouds()[suffix], CLOUD_WORDS)))
    require_cloud(path)


def require_cloud(path):
    try:
        with warnings.catch_warnings():
            warnings.filterwarnings("ignore", ".* points are not finite")
            points = read_cloud(path)
    except ValueError as error:
        require_message(str(error))
    else:
        assert points.shape[1] == 3
        assert np.isfinite(points).all()


def images():
    """Small depth images of every format, in millimetres."""
    counts = np.full((24, 32), 800, np.uint16)
    made = {suffix: io.BytesIO() for suffix in (".png", ".tif", ".tiff", ".npy")}
    PIL.Image.fromarray(counts).save(made[".png"], "PNG")
    PIL.Image.fromarray(counts).save(made[".tif"], "TIFF")
    PIL.Image.fromarray(counts.astype(np.float32)).save(made[".tiff"], "TIFF")
    np.save(made[".npy"], counts)
    return {suffix: [file.getvalue()] for suffix, file in made.items()}


CAMERA = {"focal": [30.0, 30.0], "center": [15.5, 11.5], "pose": {"rpy": [3, 0, 0]}, "unit": 0.001}


@fuzzed
@pytest.mark.filterwarnings("ignore:Reading .* created on Python 2")  # numpy's
@given(suffix=st.sampled_from(sorted(images())), data=st.data())
def test_depth_images(folder, suffix, data):
    path, camera = (folder / "fuzzed").with_suffix(suffix), folder / "camera.json"
    path.write_bytes(data.draw(spliced(images()[suffix], CLOUD_WORDS)))
    camera.write_text(json.dumps(CAMERA))
    refused_or(lambda: read_view(path, kind_of(path), str(camera), None))


@fuzzed
@given(fields=edited([CAMERA]))
def test_files_of_cameras(folder, fields):
    path, camera = folder / "whole.png", folder / "fuzzed.json"
    path.write_bytes(images()[".png"][0])
    camera.write_bytes(json.dumps(fields).encode("utf-8", "surrogatepass"))
    refused_or(lambda: read_view(path, kind_of(path), str(camera), None))


COMMANDS = ["plan", "check", "loops", "export", "view", "example", "bench", "nothing", "", "--help"]
ARGUMENTS = [
    "01_slide_card.yaml", "06_push_block.yaml", "13_clasp_purse.yaml", "05_point_cloud.ply",
    "09_l_shape.obj", "solved.json", "missing.yaml", "missing.json", ".", "", "\0", "-", "--json",
    "--time", "--seed", "--iterations", "--search", "--png", "--html", "--to", "--fingers", "--group",
    "--points", "--edge", "--unit", "--list", "--rate", "-1", "0", "1", "3", "0.2", "1e400",
    "nan", "9" * 5000, "1" * 30, "paper", "fast", "dijkstra", "ros", "csv", "json", "mujoco", "out.png",
    "out.csv", "nowhere/out.json", "slide", "\ud800",
]  # fmt: skip
ENDS = {  # what keeps a command short: later flags win
    "plan": ["--time", "0.2", "--iterations", "30"],
    "view": ["--png", "view.png"],
    "loops": ["--points", "200"],
    "example": ["--list"],
}


def outcome(arguments):
    """Exit code, stdout and stderr of one command."""
    out, err = io.StringIO(), io.StringIO()
    with redirect_stdout(out), redirect_stderr(err):
        try:
            code = cli.main(arguments)
        except SystemExit as stopped:
            code = stopped.code
    return code, out.getvalue(), err.getvalue()


@fuzzed
@given(
    command=st.sampled_from(COMMANDS),
    arguments=st.lists(st.sampled_from(ARGUMENTS) | st.text(max_size=5), max_size=6),
)
def test_command_lines(folder, plans, command, arguments):
    (folder / "solved.json").write_text(json.dumps(plans[1]))
    code, out, err = outcome([command, *arguments, *ENDS.get(command, [])])
    if code == 2:
        require_message(err)
    else:
        assert code in (0, 1)
        assert out or "--json" in arguments or "-o" in arguments
