# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Holes of objects that cameras saw: rays through them decide, from perceiving to plan files."""

import json

import numpy as np
import pytest

import graspless
from graspless import frames, geometry, perception
from graspless.cli import main
from graspless.errors import TaskError

CUP = [  # walls and floor of a box that is open at the top
    ([0.09, 0.006, 0.09], [0, -0.042, 0.045]),
    ([0.09, 0.006, 0.09], [0, 0.042, 0.045]),
    ([0.006, 0.078, 0.09], [-0.042, 0, 0.045]),
    ([0.006, 0.078, 0.09], [0.042, 0, 0.045]),
    ([0.078, 0.078, 0.006], [0, 0, 0.003]),
]
HANDLE = [
    ([0.045, 0.012, 0.012], [0.065, 0, 0.075]),
    ([0.045, 0.012, 0.012], [0.065, 0, 0.02]),
    ([0.012, 0.012, 0.067], [0.0865, 0, 0.0475]),
]
TABLE = ([0.7, 0.7, 0.04], [0.65, 0, -0.02])
FLOOR = ([6, 6, 0.02], [0.65, 0, -0.75])


def placed(parts):
    return [geometry.PlacedShape(geometry.Box(size), frames.translation(p)) for size, p in parts]


def frame_of(parts, angle=0.5, noise=None, seed=1):
    """A depth image of an object at (0.65, 0) on a table, seen from a side."""
    bodies = [perception.Body(placed([part]), np.eye(4)) for part in (TABLE, FLOOR)]
    bodies.append(perception.Body(placed(parts), frames.translation([0.65, 0, 0])))
    eye = [0.65 + 0.5 * np.sin(angle), -0.5 * np.cos(angle), 0.4]
    camera = perception.look_at(eye, [0.65, 0, 0.04])
    return perception.render(bodies, camera, noise=noise, seed=seed)


def perceived(parts, angles=(0.5,), noise=None):
    views = [
        perception.View(f.depth, f.K, f.X_WC)
        for f in (frame_of(parts, angle, noise, k + 1) for k, angle in enumerate(angles))
    ]
    scene = perception.perceive_views(views)
    assert len(scene.objects) == 1, scene.reason
    return scene


def loops_of(scene):
    thing = scene.objects[0]
    return geometry.shortest_loops(thing.points, rays=list(thing.rays))


@pytest.fixture(scope="module")
def mug():
    return perceived(CUP + HANDLE)


@pytest.mark.parametrize("noise", [None, perception.Noise()])
@pytest.mark.parametrize("angle", [0.3, 0.45, 0.6])
def test_the_handle_of_a_mug_is_a_hole_and_its_rim_is_not(angle, noise):
    loops = loops_of(perceived(CUP + HANDLE, [angle], noise))
    assert len(loops.found) == 1, loops.reason
    loop = loops.found[0]
    assert loop.seen_through > 1e-4
    assert loop.points[:, 0].min() > 0 or loop.length < 0.25
    assert any("rim of a vessel" in other.reason for other in loops.uncertain)


@pytest.mark.parametrize("noise", [None, perception.Noise()])
@pytest.mark.parametrize("angles", [[0.0], [1.0, 3.0], [0.5, 2.0, 3.6, 5.1]])
def test_a_cup_without_a_handle_has_no_hole(angles, noise):
    loops = loops_of(perceived(CUP, angles, noise))
    assert not loops.found
    assert loops.has_rays


@pytest.mark.parametrize("angle", [-0.4, np.pi / 2])  # its ends, or its opening
def test_a_handle_that_is_hidden_in_part_is_uncertain(angle):
    loops = loops_of(perceived(CUP + HANDLE, [angle]))
    assert not loops.found


def test_a_shallow_dish_has_no_hole():
    low = [([*size[:2], min(size[2], 0.012)], [*p[:2], min(p[2], 0.006)]) for size, p in CUP[:4]]
    dish = [*low, ([0.078, 0.078, 0.002], [0, 0, 0.001])]
    for seed in range(3):
        loops = loops_of(perceived(dish, [0.3 * seed], perception.Noise()))
        assert not loops.found, loops.reason


def test_without_rays_the_distances_between_points_decide(mug):
    loops = geometry.shortest_loops(mug.objects[0].points)
    assert not loops.has_rays
    assert all(loop.seen_through == 0 and loop.unseen == 0 for loop in loops.found)


def test_rays_of_a_depth_image_are_those_of_perceive(mug):
    frame, thing = frame_of(CUP + HANDLE), mug.objects[0]
    X_OC = np.linalg.inv(thing.X_WO) @ frame.X_WC
    is_object = frame.labels == 2
    p_OP = thing.points
    rays = geometry.RayImage.from_depth(frame.depth, is_object, frame.K, X_OC)
    assert np.array_equal(rays.ends < 0, is_object)
    loops = geometry.shortest_loops(p_OP, rays=[rays])
    assert len(loops.found) == 1
    assert loops.found[0].length == pytest.approx(loops_of(mug).found[0].length)
    with pytest.raises(ValueError, match="is_object must have the shape"):
        geometry.RayImage.from_depth(frame.depth, is_object[1:], frame.K, X_OC)


def test_scene_files_keep_rays(mug, tmp_path):
    perception.save_scene(mug, tmp_path / "scene.yaml")
    again = perception.load_scene(tmp_path / "scene.yaml")
    for one, other in zip(mug.objects[0].rays, again.objects[0].rays, strict=True):
        assert np.array_equal(one.ends, other.ends)
        assert np.allclose(one.K, other.K)
        assert np.allclose(one.X_OC, other.X_OC, atol=1e-9)
    assert len(loops_of(again).found) == 1
    arrays = dict(np.load(tmp_path / "scene.npz"))
    del arrays["object_0 rays 0"]
    np.savez(tmp_path / "scene.npz", **arrays)
    with pytest.raises(TaskError, match="points: .*has no array 'object_0 rays 0'"):
        perception.load_scene(tmp_path / "scene.yaml")


def test_the_command_loops_reads_scenes(mug, tmp_path, capsys):
    path = tmp_path / "scene.yaml"
    perception.save_scene(mug, path)
    assert main(["loops", str(path), "--object", "object_0", "--json"]) == 0
    printed = json.loads(capsys.readouterr().out)
    assert printed["has_rays"] is True
    assert printed["found"][0]["seen_through"] > 0
    assert main(["loops", str(path), "--object", "object_0"]) == 0
    assert "seen through on" in capsys.readouterr().out
    assert main(["loops", str(path)]) == 2
    assert "--object NAME must be given" in capsys.readouterr().err
    assert main(["loops", str(path), "--object", "object_3"]) == 2
    assert "the scene has no 'object_3'" in capsys.readouterr().err


TASK = "kind: clasp\nrobot: {urdf: kr5_sdh}\nobject: {scene: scene.yaml, name: object_0}\n"


def test_a_clasp_task_of_a_scene_has_its_rays(mug, tmp_path, recwarn):
    perception.save_scene(mug, tmp_path / "scene.yaml")
    (tmp_path / "task.yaml").write_text(TASK)
    task = graspless.load_task(tmp_path / "task.yaml")
    thing = task.problem.object
    assert len(thing.rays) == 1
    assert len(thing.loops.found) == 1
    assert not [w for w in recwarn if "see all sides" in str(w.message)]


def test_a_rim_is_not_clasped(tmp_path):
    perception.save_scene(perceived(CUP), tmp_path / "scene.yaml")
    (tmp_path / "task.yaml").write_text(TASK)
    with pytest.warns(UserWarning, match="something nearer may hide part of it"):
        plan = graspless.plan(tmp_path / "task.yaml", seed=1)
    assert str(plan.status) == "no_reliable_hole"
    assert "no ray passed through it" in plan.reason
    plan.save(tmp_path / "plan.json")
    again = graspless.load_plan(tmp_path / "plan.json")
    one, other = plan.task.problem.object, again.task.problem.object
    assert [loop.reason for loop in one.loops.uncertain] == [
        loop.reason for loop in other.loops.uncertain
    ]
    assert np.array_equal(one.rays[0].ends, other.rays[0].ends)


@pytest.mark.parametrize(
    ("change", "words"),
    [
        ({"ends": "!"}, "rays[0].ends"),
        ({"ends": "AAAA"}, "rays[0].ends"),
        ({"size": [3, 5]}, "rays[0].ends"),
        ({"size": [0, 5]}, "rays[0].size"),
        ({"focal": [0.0, 5.0]}, "rays[0].focal"),
    ],
)
def test_bad_rays_of_a_task_are_refused(mug, change, words):
    from graspless.tasks import task_from_dict
    from graspless.tasks.rays import rays_fields

    thing = mug.objects[0]
    document = {
        "kind": "clasp",
        "robot": {"urdf": "kr5_sdh"},
        "object": {
            "points": thing.points.tolist(),
            "rays": [rays_fields(thing.rays[0]) | change],
        },
    }
    with pytest.raises(TaskError) as error:
        task_from_dict(document, "task", resolve=True)
    assert words in str(error.value)


def cloud_file(scene, path):
    """Writes the points of the only object; returns the camera's position in their frame."""
    (thing,) = scene.objects
    np.savetxt(path, thing.points)
    return thing.rays[0].X_OC[:3, 3]


def test_a_cloud_of_one_view_needs_its_camera(mug, tmp_path, capsys):
    eye = cloud_file(mug, tmp_path / "mug.xyz")
    assert main(["loops", str(tmp_path / "mug.xyz")]) == 1
    assert "one camera could have seen all points" in capsys.readouterr().out
    assert main(["loops", str(tmp_path / "mug.xyz"), "--json", "--views", *map(str, eye)]) == 0
    found = json.loads(capsys.readouterr().out)
    assert found["has_rays"]
    assert len(found["found"]) == 1
    assert found["found"][0]["seen_through"] > 1e-4


def test_a_camera_without_depth_image_sees_no_hole_in_a_cup(tmp_path):
    eye = cloud_file(perceived(CUP), tmp_path / "cup.xyz")
    millimetres = 1000 * np.loadtxt(tmp_path / "cup.xyz")
    np.savetxt(tmp_path / "cup_mm.xyz", millimetres)
    assert main(["loops", str(tmp_path / "cup.xyz"), "--views", *map(str, eye)]) == 1
    views = [*map(str, 1000 * eye)]
    assert main(["loops", str(tmp_path / "cup_mm.xyz"), "--unit", "mm", "--views", *views]) == 1


def test_bad_views_are_refused(mug, tmp_path, capsys):
    cloud_file(mug, tmp_path / "mug.xyz")

    def refused(*arguments):
        assert main(["loops", *map(str, arguments)]) == 2
        return capsys.readouterr().err

    path = tmp_path / "mug.xyz"
    assert "--viewpoints has 2 numbers; it must have three" in refused(path, "--views", 1, 2)
    assert "viewpoints[0] is among the points" in refused(path, "--views", 0, 0, 0.05)
    assert "but point 1 is" in refused(path, "--views", 0, 0, 1, 0, 0, "nan")
    perception.save_scene(mug, tmp_path / "scene.yaml")
    scene = (tmp_path / "scene.yaml", "--object", "object_0", "--views", 0, 0, 1)
    assert "--viewpoints: only for clouds" in refused(*scene)
