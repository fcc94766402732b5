# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Promises of docs/security.md: no file runs code or reads what it must not."""

import ast
import hashlib
import importlib
import json
import os
import pathlib
import socket
import sys

import pytest

import graspless
from graspless import TaskError, perception, robot
from graspless.tasks import meshes, xacro_process
from pick_common import BAR, seen
from tasks_common import GOOD, changed, fault, run, write_robot_with_mesh

HEAD = '<robot name="a" xmlns:xacro="http://www.ros.org/wiki/xacro">'
REFUSED = "not allowed; --trust (in Python trust=True of load_task and pick) allows it"
# An expression that gets round xacro's own restrictions and runs code.
ESCAPE = (
    "${(lambda: [c for c in ().__class__.__base__.__subclasses__() if c.__name__ == "
    "'catch_warnings'][0]()._module.sys.modules['builtins'].exec(&quot;%s&quot;, "
    "dict(__builtins__=[c for c in ().__class__.__base__.__subclasses__() if c.__name__ == "
    "'catch_warnings'][0]()._module.sys.modules['builtins'])))()}"
)


@pytest.fixture
def inside(tmp_path):
    """A folder with a xacro file's own files, beside others that it must not read."""
    outside = tmp_path / "outside"
    for folder in (tmp_path / "inside" / "parts", outside):
        folder.mkdir(parents=True)
        (folder / "link.xacro").write_text(f'{HEAD}<link name="{folder.name}"/></robot>')
        (folder / "name.yaml").write_text(f"name: {folder.name}")
    (tmp_path / "inside" / "shortcut.yaml").symlink_to(outside / "name.yaml")
    return tmp_path / "inside"


def expanded(folder, body, packages=None, trust=False):
    pytest.importorskip("xacro")
    (folder / "a.xacro").write_text(f"{HEAD}{body}</robot>")
    return xacro_process.expand(folder / "a.xacro", {}, packages or {}, trust)


@pytest.mark.parametrize(
    "tag", ["python/object/apply:os.system ['exit 3']", "python/name:os.system", "python/module:os"]
)
def test_yaml_makes_no_objects(write, tag):
    told = fault(write(changed("name: card", f"name: !!{tag}")))
    assert told.startswith("task.yaml:6: not valid YAML: could not determine a constructor")


def test_no_pickles_are_read():
    """Nor anything else that runs what it reads."""
    names = {"pickle", "marshal", "shelve", "dill", "cloudpickle", "joblib.load"}
    calls = {"eval", "exec", "unsafe_load", "full_load"}
    for path in pathlib.Path(graspless.__file__).parent.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, (ast.Import, ast.ImportFrom)):
                imported = {alias.name for alias in node.names} | {getattr(node, "module", None)}
                assert not names & imported, path
            if isinstance(node, ast.Call):
                called = getattr(node.func, "id", None) or getattr(node.func, "attr", None)
                assert called not in calls, f"{path}:{node.lineno}"


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("urdf: wam_t42", "urdf: {}"),
        ("urdf: wam_t42", "urdf: wam_t42\n  srdf: {}"),
        ("object:", "hand: {}\nobject:"),
        ("rectangle: {size: [0.10, 0.08]}\n  thickness: 0.004", "cloud: {}"),
    ],
)
def test_named_file_of_another_kind_gets_into_no_plan(write, tmp_path, old, new):
    secret = write("password: sesame", "secret.txt")
    secret.chmod(0o400)
    output = tmp_path / "plan.json"
    with pytest.raises(TaskError):
        graspless.plan(write(changed(old, new.format(secret)))).save(output)
    assert not output.exists()
    assert secret.read_text() == "password: sesame"


def test_batch_writes_into_its_folder_only(write, tmp_path):
    write(GOOD, "..card.yaml")
    write(GOOD.replace("card", "../../card"), "b.yaml")
    before = set(tmp_path.iterdir())
    assert graspless.batch([tmp_path / "..card.yaml", tmp_path / "b.yaml"], tmp_path / "out").held
    assert set(tmp_path.iterdir()) == before | {tmp_path / "out"}


@pytest.mark.parametrize(
    ("body", "name"),
    [
        ('<xacro:include filename="parts/link.xacro"/>', "parts"),
        ('<xacro:include filename="parts/*.xacro"/>', "parts"),
        ('<xacro:include filename="$(find mine)/link.xacro"/>', "outside"),
        ("<link name=\"${xacro.load_yaml('parts/name.yaml')['name']}\"/>", "parts"),
        ("<link name=\"${xacro.load_yaml('$(find mine)/name.yaml')['name']}\"/>", "outside"),
        ('<xacro:include filename="none.xacro" optional="true"/><link name="one"/>', "one"),
        ('<link name="$(optenv GRASPLESS_NEVER_SET one)"/>', "one"),
    ],
)
def test_xacro_reads_its_folder_and_packages(inside, body, name):
    outside = str(inside.parent / "outside")
    assert f'<link name="{name}"/>' in expanded(inside, body, {"mine": outside})


@pytest.mark.parametrize(
    ("body", "what"),
    [
        ('<xacro:include filename="../outside/link.xacro"/>', "opens '{}/inside/../outside"),
        ('<xacro:include filename="{}/outside/link.xacro"/>', "opens '{}/outside/link.xacro'"),
        ('<xacro:include filename="{}/outside/*.xacro"/>', "opens '{}/outside'"),
        ('<xacro:include filename="{}/outside/link.xacro" optional="true"/>', "opens '{}/outside"),
        ("<link name=\"${xacro.load_yaml('{}/outside/name.yaml')}\"/>", "opens '{}/outside"),
        ("<link name=\"${xacro.load_yaml('shortcut.yaml')}\"/>", "opens '{}/inside/shortcut"),
        ('<xacro:include filename="$(find other)/a.xacro"/>', "looks for package 'other' outside"),
        ('<link name="$(env HOME)"/>', "reads the environment variable 'HOME'"),
        ('<link name="$(optenv HOME none)"/>', "reads the environment variable 'HOME'"),
    ],
)
def test_xacro_reads_nothing_else(inside, monkeypatch, body, what):
    monkeypatch.setenv("HOME", "/home/somebody")
    body, what = (text.replace("{}", str(inside.parent)) for text in (body, what))
    with pytest.raises(ValueError, match="xacro cannot expand it") as caught:
        expanded(inside, body)
    assert what in str(caught.value)
    assert str(caught.value).endswith(REFUSED)
    if "other" not in body:
        assert "<link" in expanded(inside, body, trust=True)


@pytest.mark.parametrize(
    ("code", "event"),
    [
        ("open('{}/new', 'w')", "opens"),
        ("open('{}/inside/new', 'w')", "opens"),
        ("open('{}/outside/name.yaml')", "opens"),
        ("open(0)", "opens"),
        ("import os; os.system('touch {}/new')", "does os.system"),
        ("import os; os.posix_spawn('/bin/true', ['true'], dict())", "does os.posix_spawn"),
        ("import os; os.fork()", "does os.fork"),
        ("import os; os.remove('{}/inside/parts/name.yaml')", "does os.remove"),
        ("import socket", "does import"),
        ("import _posixsubprocess", "does import"),
        ("import sys; sys._getframe()", "does sys._getframe"),
        # Replacing what the process checks with changes nothing.
        ("import os; os.readlink = lambda p: '{}/inside'; open('{}/outside/name.yaml')", "opens"),
        ("import sys; sys.modules['__main__']._refuse = print; open('{}/new', 'w')", "opens"),
    ],
)
def test_xacro_cannot_write_run_or_connect(inside, code, event):
    body = f'<link name="{ESCAPE % code.replace("{}", str(inside.parent))}"/>'
    with pytest.raises(ValueError, match=f"xacro cannot expand it: {event}") as caught:
        expanded(inside, body)
    assert str(caught.value).endswith(REFUSED)
    assert not (inside.parent / "new").exists()
    assert (inside / "parts" / "name.yaml").exists()


def test_xacro_has_a_limit_of_time_and_memory():
    """tests/python/test_bounds.py shows that they hold."""
    assert xacro_process.SECONDS == 10
    assert xacro_process.MEMORY == 2**30


def test_trusted_xacro_does_what_it_wants(inside):
    code = f"open('{inside}/new', 'w')"
    expanded(inside, f'<link name="{ESCAPE % code}"/>', trust=True)
    assert (inside / "new").exists()


def write_untrusted(inside):
    """Writes arm.xacro, which reads a file of another folder."""
    pytest.importorskip("xacro")
    arm = robot.builtin("wam_t42")
    for ending in (".srdf", ".hand.yaml"):
        (inside / f"arm{ending}").write_text(arm.with_name(f"wam_t42{ending}").read_text())
    (inside.parent / "outside" / "arm.urdf").write_text(arm.read_text())
    include = '<xacro:include filename="../outside/arm.urdf"/>'
    (inside / "arm.xacro").write_text(f"{HEAD}{include}</robot>")


@pytest.mark.parametrize("is_chain", [False, True])
def test_trust_is_asked_for_in_commands_and_calls(inside, tmp_path, capsys, is_chain):
    write_untrusted(inside)
    text = changed("urdf: wam_t42", "urdf: arm.xacro")
    if is_chain:
        (inside / "stage.yaml").write_text(text)
        text = "kind: chain\nstages: [{file: stage.yaml}]\nbudget: {seconds: 20}"
    path = inside / "task.yaml"
    path.write_text(text)
    with pytest.raises(TaskError, match="--trust"):
        graspless.load_task(path)
    assert graspless.load_task(path, trust=True).problem
    plan = ("plan", str(path), "-o", str(tmp_path / "plan.json"))
    code, _, err = run(capsys, *plan)
    assert (code, err.count(REFUSED)) == (2, 1)
    assert run(capsys, *plan, "--trust")[0] == 0
    output = tmp_path / "plans"
    batch = ("batch", str(path), "-o", str(output))
    assert run(capsys, *batch)[0] == 1
    assert "--trust" in json.loads((output / "batch.jsonl").read_text())["reason"]
    assert run(capsys, *batch, "--trust")[0] == 0


def test_trust_is_asked_for_by_a_pick(inside, tmp_path, capsys):
    write_untrusted(inside)
    scene = seen(BAR)
    (thing,) = scene.objects
    perception.save_scene(scene, tmp_path / "scene.yaml")
    pick = ("pick", str(tmp_path / "scene.yaml"), thing.name, "-o", str(tmp_path / "plan.json"))
    pick = (*pick, "--robot", str(inside / "arm.xacro"), "--place", f"on: {thing.support}")
    code, _, err = run(capsys, *pick)
    assert (code, err.count(REFUSED)) == (2, 1)
    assert run(capsys, *pick, "--trust")[0] == 0
    arm, tumble = str(inside / "arm.xacro"), ["tumble"]
    found = graspless.pick(scene, thing.name, arm, strategies=tumble, mass=0.1, trust=True)
    assert "not allowed" not in found.attempts[0].reason


@pytest.fixture
def document(tmp_path):
    """A plan file's fields whose robot has a mesh, and the mesh."""
    mesh = write_robot_with_mesh(tmp_path)
    (tmp_path / "task.yaml").write_text(changed("urdf: wam_t42", "urdf: arm.urdf"))
    fields = json.loads(graspless.plan(tmp_path / "task.yaml").to_json())
    assert fields["task"]["files"] == {str(mesh): hashlib.sha256(b"").hexdigest()}
    return fields, mesh


def opened_by(work):
    """Paths that are opened during a call."""
    paths, is_on = set(), [True]

    def note(event, arguments):
        if is_on[0] and event == "open" and isinstance(arguments[0], (str, bytes, os.PathLike)):
            paths.add(os.fsdecode(arguments[0]))

    sys.addaudithook(note)  # cannot be removed
    try:
        work()
    finally:
        is_on[0] = False
    return paths


def test_plan_file_opens_its_meshes_only(document, tmp_path):
    fields, mesh = document
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(fields))
    graspless.check(path)  # imports
    found = opened_by(lambda: graspless.check(path))
    assert found == {str(path), str(mesh)}


@pytest.mark.parametrize(
    ("change", "what"),
    [
        (lambda task, mesh: task["files"].clear(), "its checksum is missing"),
        (lambda task, mesh: task["files"].update({str(mesh): "0" * 64}), "has changed since"),
        (lambda task, mesh: task["files"].update({"/etc/shadow": "0" * 64}), "should be a mesh"),
        (lambda task, mesh: task["robot"].update(urdf="arm.urdf"), "robot"),
        (lambda task, mesh: task["robot"].update(urdf="a", urdf_text=None), "must be part of the plan"),
        (lambda task, mesh: task.update(hand="arm.hand.yaml"), "must be part of the plan file"),
        (lambda task, mesh: task.update(object=task["object"] | {"cloud": "a.ply"}), "object"),
    ],
)  # fmt: skip
def test_plan_file_that_names_other_files(document, tmp_path, capsys, monkeypatch, change, what):
    fields, mesh = document
    change(fields["task"], mesh)
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(fields))
    code, out, err = run(capsys, "check", str(path))
    assert (code, out) == (2, "")
    assert what in err


@pytest.mark.parametrize(
    "hidden",
    [
        '<!DOCTYPE robot [<!ENTITY a "{}">]>',
        "<?a {} ?>",
        '<x:a>{}</x:a><link name="b" name="b"/>',
    ],
)
def test_readers_of_xml_see_the_same_meshes(document, tmp_path, capsys, hidden):
    """The URDF reader is lenient: what it finds and a strict reader does not is not hidden."""
    fields, mesh = document
    mesh_element = f"<collision><geometry><mesh filename='{mesh}'/></geometry></collision>"
    text = fields["task"]["robot"]["urdf_text"]
    head, tail = text.split("<link ", 1)
    fields["task"]["robot"]["urdf_text"] = f"{head}{hidden.format(mesh_element)}<link {tail}"
    path = tmp_path / "plan.json"
    path.write_text(json.dumps(fields))
    code, _, err = run(capsys, "check", str(path))
    assert code == 2
    assert "robot.urdf_text: " in err


def test_meshes_of_all_namespaces_have_checksums():
    found = meshes._named(
        {
            "urdf_text": '<robot xmlns="a"><mesh filename="file:///a.stl"/></robot>',
            "directory": "/b",
        }
    )
    assert found == {pathlib.Path("/a.stl"): ("urdf_text",)}


def test_viewer_is_bound_to_this_machine():
    pytest.importorskip("viser")
    servers = importlib.import_module("graspless.view.server")
    port = servers.free_port()
    with servers.open_server(port) as server:
        assert server.get_host() == "127.0.0.1"
        others = {info[4][0] for info in socket.getaddrinfo(socket.gethostname(), port)}
        for address in others - {"127.0.0.1", "::1"}:
            with pytest.raises(OSError, match="refused"), socket.socket() as probe:
                probe.settimeout(1)
                probe.connect((address, port))


def test_names_add_no_html(write, tmp_path):
    pytest.importorskip("viser")
    script = "<script>alert(1)</script>"
    plan = graspless.plan(write(changed("name: card", f"name: {script}")))
    graspless.view.write_html(plan, tmp_path / "plan.html")
    assert script not in (tmp_path / "plan.html").read_text()
    assert script not in plan._repr_html_()


def test_batch_without_dask_opens_no_connection(write, tmp_path):
    events = set()
    is_on = [True]
    sys.addaudithook(lambda event, _: events.add(event) if is_on[0] else None)
    graspless.batch(write(GOOD), tmp_path / "out")
    is_on[0] = False
    assert "open" in events
    assert not events & {"socket.connect", "socket.bind"}
