# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""What tests of all kinds of tasks share: a good task as text, and ways to break and run it."""

import base64
import json
import re

import numpy as np
import pytest

import graspless
from graspless import TaskError, cli, robot

GOOD = """\
kind: slide
robot:
  urdf: wam_t42
  home: {wam_joint_2: 0.2, wam_joint_4: 1.6, wam_joint_6: 1.2}
object:
  name: card
  rectangle: {size: [0.10, 0.08]}
  thickness: 0.004
  pose: {x: 0.60, y: 0.10, yaw: 0.3}
support:
  rectangle: {center: [0.65, 0.0], size: [0.7, 0.7]}
  height: 0.0
budget: {seconds: 20, seed: 3}
"""


def changed(old: str, new: str, text: str = GOOD) -> str:
    """The good task with one part replaced; the part must be there once."""
    assert text.count(old) == 1, old
    return text.replace(old, new)


def write_robot_with_mesh(folder):
    """Writes arm.urdf, a WAM with a mesh that is drawn only; returns the path of the mesh."""
    mesh = folder / "part.stl"
    mesh.write_bytes(b"")
    text = robot.builtin("wam_t42").read_text()
    shape = f'<visual><geometry><mesh filename="{mesh}"/></geometry></visual>'
    head, tail = text.split("<visual>", 1)
    (folder / "arm.urdf").write_text(head + shape + tail.partition("</visual>")[2])
    for ending in (".srdf", ".hand.yaml"):
        source = robot.builtin("wam_t42").with_name(f"wam_t42{ending}")
        (folder / f"arm{ending}").write_text(source.read_text())
    return mesh


def write_renamed(folder, name, old, new):
    """Writes a robot that comes with graspless as my.urdf and so on, with a link renamed."""
    for path in robot.builtin(name).parent.glob(f"{name}.*"):
        text = path.read_text().replace(f'"{old}"', f'"{new}"')
        (folder / path.name.replace(name, "my", 1)).write_text(text)


def fault(path):
    """The message of a task that must not be read, without its folder."""
    with pytest.raises(TaskError) as caught:
        graspless.load_task(path)
    assert isinstance(caught.value, ValueError)
    return str(caught.value).replace(f"{path.parent}/", "")


def run(capsys, *arguments):
    """Exit code, stdout and stderr of one command."""
    try:
        code = cli.main(list(arguments))
    except SystemExit as stopped:
        code = stopped.code
    captured = capsys.readouterr()
    return code, captured.out, captured.err


def reread(document, path, change=lambda _: None):
    """The plan of a document that was written to a file, after a change of that copy alone."""
    copy = json.loads(json.dumps(document))
    change(copy)
    path.write_text(json.dumps(copy))
    return graspless.load_plan(path)


def edited(plan, path):
    """A slide's or clasp's plan whose first joint jumps in the middle of its first segment."""
    document = json.loads(plan.to_json())
    rows = document["segments"][0]["positions"]
    rows[len(rows) // 2][0] += 0.3
    path.write_text(json.dumps(document))
    assert graspless.check(path)
    return str(path)


def without_clock(plan):
    """What stands in a plan's file, but for how long it took."""
    document = json.loads(plan.to_json())
    stats = document["stats"].items()
    document["stats"] = {name: value for name, value in stats if not name.endswith("seconds")}
    return document


def pixels(picture, color, tolerance=0.06):
    """Places of pixels near a colour, whatever its brightness."""
    rgb = picture[..., :3]
    shade = rgb / np.maximum(rgb.max(axis=2, keepdims=True), 1e-6)
    near = np.abs(shade - np.array(color) / max(color)).max(axis=2) < tolerance
    return np.argwhere(near & (rgb.max(axis=2) > 0.3))


def read_png(path):
    """The picture in a file, [height, width, 4]."""
    from matplotlib.image import imread

    return imread(path)


def recording(text):
    """What a replay's page holds: its messages and how long it lasts."""
    import msgspec
    import zstandard

    data = re.search(r'__VISER_EMBED_DATA__="([^"]+)"', text)[1]
    inner = zstandard.ZstdDecompressor().decompressobj().decompress(base64.b64decode(data)[8:])
    length = int.from_bytes(inner[:8], "little")
    return msgspec.msgpack.decode(inner[8 : 8 + length])


def last_positions(messages):
    """Where each moving frame of a replay ends."""
    return {
        message["name"]: message["position"]
        for _, message in messages
        if message["type"] == "SetPositionMessage"
    }
