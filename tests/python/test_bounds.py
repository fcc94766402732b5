# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Hostile files: each is refused with one message and exit code 2, soon and in little memory."""

import json
import re
import time

import numpy as np
import pytest

import graspless
from graspless import TaskError
from graspless.errors import explain
from graspless.tasks import task_from_dict
from graspless.tasks.reading import parse_yaml
from tasks_common import GOOD, changed, fault, run

LAUGHS = "kind: slide\na: &a [x, x, x, x, x, x, x, x, x, x]\n" + "".join(
    f"{name}: &{name} [{', '.join([f'*{below}'] * 10)}]\n"
    for below, name in zip("abcdef", "bcdefg", strict=True)
)
MERGES = "kind: slide\na0: &a0 {k: 1}\n" + "".join(
    f"a{i}: &a{i} {{<<: [{', '.join([f'*a{i - 1}'] * 10)}]}}\n" for i in range(1, 8)
)


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (("card", "!!timestamp x"), "6: object.name: x: should be a value of type timestamp"),
        (("card", "!!bool abc"), "6: object.name: abc: should be a value of type bool"),
        (("card", "!!int abc"), "6: object.name: abc: should be a value of type int of at most 40"),
        (("card", "!!float abc"), "6: object.name: abc: should be a value of type float"),
        (("card", '"\\0"'), r"6: object.name: '\x00': should not contain the character NUL"),
        (("0.004", "1" * 5000), "8: object.thickness: 1111111"),
        (("0.004", "1" * 41), "8: object.thickness: 1111111"),
        (("0.004", "0x" + "f" * 5000), "8: object.thickness: a whole number: should have at most 40"),
        (("0.004", "1:" * 5000 + "1"), "8: object.thickness: a whole number: should have at most 40"),
        (("0.004", "1e300"), "8: object.thickness: 1e+300: should lie in [-1e+30, 1e+30]"),
        (("yaw: 0.3", "yaw: 1e16"), "9: object.pose.yaw: 1e+16: should lie in [-1e+06, 1e+06] rad"),
        (("yaw: 0.3", "yaw: -1e31"), "9: object.pose.yaw: -1e+31: should lie in [-1e+30, 1e+30]"),
        (("wam_t42", "a" * 5000), "File name too long"),
    ],
)  # fmt: skip
def test_values_that_no_field_can_have(write, capsys, change, what):
    path = write(changed(*change))
    code, out, err = run(capsys, "plan", str(path), "-o", "-")
    assert (code, out) == (2, "")
    assert len(err.splitlines()) == 1
    assert f"task.yaml{'' if what[0] == 'F' else ':' + what.partition(':')[0]}" in err
    assert what in err
    fault(path)


@pytest.mark.parametrize("folders", [10, 1000])
def test_the_end_of_a_long_path_is_shown(folders):
    error = OSError(2, "No such file or directory", "a_folder/" * folders + "wrong.stl")
    told = explain(error)
    assert told.endswith("a_folder/wrong.stl': No such file or directory")
    assert told.startswith("'a_folder/")
    assert len(told) < 300


def test_mujoco_names_the_body_in_its_second_line():
    error = ValueError("Error: mass and inertia must be larger\nElement name 'torso', id 3\nmore")
    assert explain(error) == "Error: mass and inertia must be larger (Element name 'torso', id 3)"


def test_box_too_large_for_any_room(write):
    box = "obstacles: [{name: b, box: [1e300, 1, 1]}]\nbudget:"
    told = fault(write(changed("budget:", box)))
    assert told == "task.yaml:13: obstacles[0].box[0]: 1e+300: should lie in [-1e+30, 1e+30]"


@pytest.mark.parametrize("text", [LAUGHS, MERGES], ids=["laughs", "merges"])
def test_aliases_are_counted_before_anything_is_built(text):
    start = time.process_time()
    with pytest.raises(TaskError, match=r"^a.yaml:\d: not valid YAML: more than 1000000 values"):
        parse_yaml(text, "a.yaml")
    assert time.process_time() - start < 1


@pytest.mark.parametrize("text", ["[" * 100_000, "kind: " + "{a: " * 100_000, "- " * 3000 + "x"])
def test_deep_yaml(write, text):
    assert fault(write(text)) == "task.yaml:1: not valid YAML: nested deeper than 100 levels"


def test_aliases_and_levels_as_people_use_them():
    text = "a: &a {k: [1, 2]}\nb: [*a, *a]\nc: {<<: *a, l: 3}\nd: " + "[" * 50 + "]" * 50
    data = parse_yaml(text, "a.yaml").data
    assert (data["b"], data["c"]) == ([data["a"]] * 2, {"k": [1, 2], "l": 3})


@pytest.mark.parametrize(
    ("text", "what"),
    [
        ("[" * 100_000, "not valid JSON: nested too deeply"),
        ('{"format": 1, "kind": "slide", "a": ' + "[" * 100_000, "nested too deeply"),
        ('{"format": 1, "kind": "slide", "a": ' + "[" * 200 + "]" * 200 + "}", "deeper than 100"),
        ('{"format": ' + "1" * 5000 + "}", "format: 11111"),
        ('{"format": 1, "kind": "slide", "seed": ' + "1" * 5000 + "}", "seed: 11111"),
        ('{"format": 1, "kind": "slide", "reason": "\\ud800"}', "reason: '\\ud800': should be text"),
        ('{"format": 1, "kind": "slide", "\\ud800": 0}', "should be text"),
    ],
)  # fmt: skip
def test_hostile_plan_files(tmp_path, capsys, text, what):
    path = tmp_path / "plan.json"
    path.write_text(text)
    code, out, err = run(capsys, "check", str(path))
    assert (code, out) == (2, "")
    assert err.startswith(f"{path}: ")
    assert what in err
    assert len(err) < 5000


def test_hostile_fields_given_in_python():
    around = {}
    around["around"] = around
    deep = parse_yaml(GOOD, "a.yaml").data
    for wrong in (around, "\ud800", 10**5000, 1e300, np.array(1)):
        with pytest.raises(TaskError, match="task"):
            graspless.plan(deep | {"object": wrong})


def test_resolution_that_no_search_can_have(write, capsys):
    path = write(GOOD + "options: {resolution: 1e-9}\n")
    code, _, err = run(capsys, "plan", str(path), "-o", "-")
    assert code == 2
    assert "options.resolution: 1e-09: " in err


@pytest.mark.parametrize(
    ("error", "what"),
    [
        (MemoryError("std::bad_alloc"), "check: needs more memory than there is; "),
        (RuntimeError("odd"), "check: RuntimeError: odd"),
        (KeyError("abc"), "check: KeyError: 'abc'"),
        (RecursionError("deep"), "check: nested too deeply"),
        (OSError(36, "File name too long", "aaa"), "check: 'aaa': File name too long"),
    ],
)
def test_faults_of_libraries_are_no_tracebacks(write, capsys, monkeypatch, error, what):
    def fail(_):
        raise error

    monkeypatch.setattr("graspless.cli.given_plan", fail)
    code, out, err = run(capsys, "check", "plan.json")
    assert (code, out) == (2, "")
    assert err.startswith(what)
    assert len(err.splitlines()) == 1
    assert json.dumps(err).count("bad_alloc") == 0


@pytest.mark.parametrize(
    "error", [KeyError("abc"), TaskError("task.yaml: wrong"), OSError(2, "x", "a")]
)
def test_traceback_on_request(capsys, monkeypatch, error):
    def fail(_):
        raise error

    monkeypatch.setattr("graspless.cli.given_plan", fail)
    monkeypatch.setenv("GRASPLESS_TRACEBACK", "1")
    code, _, err = run(capsys, "check", "plan.json")
    first, _, rest = err.partition("\n")
    assert code == 2
    assert "Traceback" not in first
    assert rest.startswith("Traceback")
    assert f"{type(error).__name__}: {error}" in rest


def test_output_at_a_loop_of_links(write, tmp_path, capsys):
    (tmp_path / "a").symlink_to("b")
    (tmp_path / "b").symlink_to("a")
    code, _, err = run(capsys, "plan", str(write(GOOD)), "-o", str(tmp_path / "a"))
    assert code == 2
    assert err == f"{tmp_path / 'a'}: cannot be written: Too many levels of symbolic links\n"
    with pytest.raises(TaskError, match="cannot be written: embedded null byte"):
        graspless.plan(write(GOOD), iterations=0).save("a\0b")


@pytest.mark.parametrize(
    ("expression", "what"),
    [("9**9**9", r"within (10 s|1024 MiB)"), ("'a' * 10**10", "1024 MiB"), ("1/0", "division")],
)
def test_xacro_that_never_ends(write, expression, what):
    write(
        f'<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro"><link name="${{{expression}}}"/></robot>',
        "a.xacro",
    )
    told = fault(write(changed("urdf: wam_t42", "urdf: a.xacro")))
    assert re.match(rf"task.yaml:3: robot.urdf: a.xacro: xacro cannot expand it.*{what}", told)


@pytest.mark.parametrize("name", ["secret", "secret.stl"])
def test_plan_file_opens_no_path_of_its_own(write, tmp_path, monkeypatch, name):
    secret = tmp_path / name
    secret.write_text("password")
    document = graspless.load_task(write(GOOD)).to_dict() | {"files": {str(secret): "0" * 64}}
    monkeypatch.setattr("graspless.tasks.meshes.checksum", lambda _: pytest.fail("opened"))
    with pytest.raises(TaskError, match=rf"files: .*{name}: should be a mesh .* of the task's"):
        task_from_dict(document, "plan.json")


@pytest.mark.parametrize("limit", ["0", "-1"])
def test_velocity_limit_of_no_motion(limit):
    from graspless.timing.settings import joint_limits

    text = graspless.robot.builtin("wam_t42").read_text()
    one = re.search(r'<joint name="wam_joint_1".*?</joint>', text, re.DOTALL)[0]
    text = text.replace(one, re.sub(r'velocity="[^"]*"', f'velocity="{limit}"', one))
    robot = graspless.robot.Robot.from_urdf(text)
    with pytest.raises(TaskError, match=f"robot: wam_joint_1: velocity limit {limit}: should be"):
        joint_limits(robot, None, None, None)
    assert joint_limits(robot, {"wam_joint_1": 0.5}, None, None)[0][0] == 0.5
