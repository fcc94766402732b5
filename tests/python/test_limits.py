# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Limits of time and memory over absurdly large tasks, and signals.

Bounds are on processor time, which does not grow with the load of the machine.
"""

import json
import math
import os
import pathlib
import resource
import signal
import subprocess
import sys
import time

import pytest

import graspless
from graspless import TaskError
from graspless.errors import OutOfTimeError
from graspless.plan_files import read_plan
from graspless.tasks import task_from_dict

pytestmark = pytest.mark.slow

ROOT = pathlib.Path(__file__).parents[2]
MOST_MEMORY = 4_000_000_000  # of a process [bytes]
GENEROUS = 3.0  # imports, and far more than any poll is apart [s]

CARD = {"name": "card", "rectangle": {"size": [0.12, 0.08]}, "thickness": 0.003}
POSE = {"pose": {"x": 0.62, "y": 0.08, "yaw": 0.4}}
TABLE = {"rectangle": {"center": [0.65, 0.0], "size": [0.7, 0.7]}}
BLOCK = {"name": "block", "box": [0.05, 0.05, 0.10], "mass": 1.0}
WALLS = [
    {"name": "behind", "normal": [1, 0, 0], "offset": -0.03},
    {"name": "beside", "normal": [0, -1, 0], "offset": -0.03},
]


def round_outline(corners, radius, x=0.0, rough=0.0):
    """A circle, or an outline with every second corner reflex."""
    angles = [2 * math.pi * i / corners for i in range(corners)]
    radii = [radius * (1 + rough * (i % 2)) for i in range(corners)]
    return [[x + r * math.cos(a), r * math.sin(a)] for r, a in zip(radii, angles, strict=True)]


def ring(points):
    """A cloud with a hole; its points follow no pattern."""
    turns = [(i * 0.754877666, i * 0.569840291) for i in range(points)]
    return "\n".join(
        f"{(0.3 + 0.05 * math.cos(b)) * math.cos(a):.6f} "
        f"{(0.3 + 0.05 * math.cos(b)) * math.sin(a):.6f} {0.05 * math.sin(b):.6f}"
        for a, b in ((2 * math.pi * (u % 1), 2 * math.pi * (v % 1)) for u, v in turns)
    )


def slide(thing=None, support=None, **options):
    return {
        "kind": "slide",
        "robot": {"urdf": "wam_t42"},
        "object": (thing or CARD) | POSE,
        "support": support or TABLE,
        "options": options,
    }


def fingertip(motion, count=2, walls=(), **options):
    return {
        "kind": "fingertip",
        "object": BLOCK,
        "fingers": {"count": count},
        "walls": list(walls),
        "motion": motion,
        "options": options,
    }


PUSH = {"slide": {"translation": [0.1, 0, 0], "segments": 30}}
TUMBLE = {"tumble": {"over": "+x", "segments": 30}}
CIRCLE = {"name": "disc", "circle": {"radius": 0.06, "points": 4000}, "thickness": 0.003}
CASES = {
    "range": slide(range=1e-12),
    "circle": slide(CIRCLE),
    "outline": slide({"polygon": round_outline(20_000, 0.06), "thickness": 0.003}),
    "support": slide(support={"polygon": round_outline(20_000, 0.35, 0.65)}),
    "rough": slide(support={"polygon": round_outline(20_000, 0.35, 0.65, rough=1e-3)}),
    "locations": fingertip(PUSH, 4, locations_per_side=20),
    "fingers": fingertip(PUSH, 4),
    "walls": fingertip(TUMBLE, walls=WALLS, locations_per_side=31),
    "poses": fingertip({"slide": {"translation": [0.1, 0, 0], "segments": 50_000}}),
    "cloud": {
        "kind": "clasp",
        "robot": {"urdf": "kr5_sdh"},
        "object": {"name": "ring", "cloud": "ring.xyz", "loops": {"max_points": 100_000}},
    },
    "step": {
        "kind": "carry",
        "robot": {"urdf": "wam_t42", "home": {"wam_joint_2": 0.7, "wam_joint_4": 1.6}},
        "frame": "grasp",
        "object": {"name": "bar", "box": [0.02, 0.02, 0.10]},
        "pose": {"position": [0.65, 0.0, 0.29]},
        "offset": [0.0, 0.0, 500.0],
        "options": {"step": 1e-4, "resolution": 1e-4, "max_twist": 3.0},
    },
}


def start(folder, document, *flags):
    """Begins `graspless plan` in a process of bounded memory."""
    (folder / "task.yaml").write_text(json.dumps(document))
    if document["object"].get("cloud"):
        (folder / "ring.xyz").write_text(ring(50_000))
    limit = (resource.RLIMIT_AS, (MOST_MEMORY, MOST_MEMORY))
    return subprocess.Popen(
        [sys.executable, "-m", "graspless", "plan", "task.yaml", *flags],
        cwd=folder,
        env=os.environ | {"OMP_NUM_THREADS": "1"},
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        preexec_fn=lambda: resource.setrlimit(*limit),
    )


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


@pytest.mark.parametrize("name", CASES)
def test_time_limit_of_large_tasks(tmp_path, name):
    before = processor_time()
    process = start(tmp_path, CASES[name], "--time", "0.3")
    out, err = process.communicate(timeout=300)
    assert process.returncode in (0, 1), err
    assert processor_time() - before < 0.3 + GENEROUS
    if process.returncode == 1 and "plan.json" in out:
        assert json.loads((tmp_path / "plan.json").read_text())["status"] != "solved"


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM])
@pytest.mark.parametrize("name", ["rough", "walls", "cloud", "range"])
def test_signals_in_large_tasks(tmp_path, name, number):
    before = processor_time()
    process = start(tmp_path, CASES[name], "--time", "1000")
    time.sleep(1.5)
    process.send_signal(number)
    _, err = process.communicate(timeout=300)
    assert (process.returncode, err) == (128 + number, "interrupted\n")
    assert processor_time() - before < 1.5 + GENEROUS
    assert {path.name for path in tmp_path.iterdir()} <= {"task.yaml", "ring.xyz"}


def test_reading_counts_as_time(tmp_path):
    (tmp_path / "ring.xyz").write_text(ring(50_000))
    path = tmp_path / "task.yaml"
    path.write_text(json.dumps(CASES["cloud"] | {"budget": {"seconds": 0.05}}))
    with pytest.raises(OutOfTimeError, match=r"^budget.seconds: 0.05 s were over before"):
        graspless.plan(path)
    with pytest.raises(TaskError, match=r"^budget.seconds: 0.01 s were over before"):
        graspless.plan(path, seconds=0.01)
    small = fingertip({"slide": {"translation": [0.1, 0, 0], "segments": 3}})
    assert graspless.plan(small, seconds=20)
    task_from_dict(small, "task")  # no limit is left behind


def test_what_is_too_large_is_a_status():
    plan = graspless.plan(fingertip(PUSH, 4, locations_per_side=400))
    assert str(plan.status) == "out_of_memory"
    assert "take a smaller locations_per_side" in plan.reason
    plan = graspless.plan(fingertip(PUSH, 3, max_memory=1e5))
    assert str(plan.status) == "out_of_memory"
    assert "options.max_memory" in plan.reason
    assert read_plan(plan.to_json(), "plan") == plan


@pytest.mark.filterwarnings("ignore:.*(is more than 100 m|nothing there holds it)")
@pytest.mark.parametrize(
    ("document", "less"),
    [
        (CASES["step"] | {"options": {"step": 1e-4, "max_twist": 3.0, "max_memory": 1e6}}, "step"),
        (slide(range=1e-5, search="paper", max_memory=1e6), "range"),
    ],
)
def test_memory_is_watched(document, less):
    plan = graspless.plan(document, seconds=300)
    assert str(plan.status) == "out_of_memory"
    told = "the search needs more memory than options.max_memory = 1 MB"
    assert plan.reason.startswith(f"{told}; take a larger options.{less}")


def test_random_tasks():
    script = ROOT / "tests" / "torture" / "limits.py"
    done = subprocess.run(
        [sys.executable, script, "--json", "--tasks", "15", "--seed", "7"],
        capture_output=True,
        text=True,
        timeout=600,
    )
    runs = json.loads(done.stdout)
    assert len(runs) == 15
    for run in runs:
        assert not run["fault"], run
        assert run["cpu"] < run["seconds"] + GENEROUS, run
        assert run["memory"] < run["asked"] + 150e6, run


LITTLE_MEMORY = """
import resource
import numpy as np
from graspless import collision, frames, geometry
x, y = np.meshgrid(np.linspace(0, 1, 300), np.linspace(0, 1, 300))
waves = np.column_stack([x.ravel(), y.ravel(), 0.1 * np.sin(9 * x.ravel()) * np.cos(7 * y.ravel())])
i = np.arange(300 * 300).reshape(300, 300)
a, b, c, d = (corner.ravel() for corner in (i[:-1, :-1], i[:-1, 1:], i[1:, :-1], i[1:, 1:]))
triangles = np.vstack([np.column_stack([a, b, c]), np.column_stack([b, d, c])])
world = collision.World()
world.add_body("waves", [geometry.PlacedShape(geometry.Mesh(waves, triangles))])
world.add_body("box", [geometry.PlacedShape(geometry.Box([0.02, 0.02, 0.02]))])
world.add_pair("waves", "box")
world.set_pose("box", frames.translation([0.5, 0.5, 0.1 * np.sin(4.5) * np.cos(3.5)]))
size = int(open("/proc/self/statm").read().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (size + 20_000_000, size + 20_000_000))
try:
    world.all_collisions()
except MemoryError:
    print("MemoryError")
"""


def test_a_mesh_for_which_there_is_no_memory_is_an_error():
    ended = subprocess.run(
        [sys.executable, "-c", LITTLE_MEMORY], capture_output=True, text=True, check=True
    )
    assert ended.stdout == "MemoryError\n"
