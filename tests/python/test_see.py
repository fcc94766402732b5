# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""From a depth image to a scene file, a picture and a checked plan; and edges that are usable."""

import copy
import json
import pickle
import re

import numpy as np
import PIL.Image
import pytest

import graspless
from graspless import frames, perception, slide
from graspless.cli import main
from graspless.errors import TaskError
from graspless.perception import cli
from graspless.tasks import scenes
from graspless.view import perceived
from graspless.view.slide import stage
from graspless.view.slide.film import film
from pick_common import body

# The far edge, at x = 1 m, stands against a wall: nothing can be slid over it.
BODIES = [
    body([0.7, 0.7, 0.04], 0.65, 0, -0.02),
    body([6, 6, 0.02], 0.65, 0, -0.75),
    body([0.02, 0.9, 1.3], 1.01, 0, 0),
    body([0.12, 0.08, 0.006], 0.62, 0.08, 0.003),
    body([0.06, 0.06, 0.12], 0.8, -0.2, 0.06),
]
TASK = """
kind: slide
robot: {urdf: wam_t42}
object: {scene: scene.yaml, name: object_0}
"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    where = tmp_path_factory.mktemp("see")
    frame = perception.render(BODIES, perception.look_at([-0.05, 0, 0.75], [0.62, 0, 0]))
    frame.save(where / "frame.npz")
    arguments = [str(where / "frame.npz"), "-o", str(where / "scene.yaml")]
    assert main(["see", *arguments, "--png", str(where / "scene.png")]) == 0
    return where


def load(folder, text):
    (folder / "task.yaml").write_text(text)
    return graspless.load_task(folder / "task.yaml")


def test_see_writes_a_scene_and_a_picture(folder):
    scene = perception.load_scene(folder / "scene.yaml")
    names = [thing.name for thing in scene.objects]
    assert names == ["object_0", "object_1", "object_2"]  # the last is the wall
    assert scene.objects[2].touches_border
    table = next(s for s in scene.supports if s.name == scene.objects[0].support)
    assert {str(label) for label in table.edges} >= {"real", "occluded"}
    assert (folder / "scene.png").read_bytes().startswith(b"\x89PNG")


def test_a_slide_from_a_scene_ends_over_a_real_edge(folder):
    task = load(folder, TASK)
    support, thing = task.problem.support, task.problem.object
    assert thing.name == "object_0"
    assert thing.thickness == pytest.approx(0.006, abs=0.001)
    assert 0 < len(support.usable_edges) < len(support.polygon.vertices)
    obstacles = [body.name for body in task.problem.obstacles]
    assert obstacles == ["scene object_1", "scene object_2"]
    plan = graspless.plan(task, seed=1)
    assert plan, plan.reason
    assert graspless.check(plan) == []
    p_SO = (np.linalg.inv(support.X_WS) @ plan.X_WO_goal)[:2, 3]
    edge = support.polygon.nearest_edge(p_SO)
    assert edge.index in support.usable_edges
    assert plan.X_WO_goal[0, 3] < 0.97  # not over the edge at the wall
    shown = film(plan)
    seen = stage.camera(shown, 400, 300).project(shown.link_poses[0, :, :3, 3], 400, 300)
    assert np.ptp(seen[:, 0]) > 100  # the robot, not the floor, fills the picture
    plan.save(folder / "plan.json")
    again = graspless.load_plan(folder / "plan.json")
    assert graspless.check(again) == []
    assert again.task.problem.support.usable_edges == support.usable_edges


def test_obstacles_of_a_scene_are_chosen(folder):
    def names(respect):
        text = TASK.replace("object_0}", f"object_0, respect: {respect}}}")
        return [body.name for body in load(folder, text).problem.obstacles]

    assert names("nothing") == []
    seen = ["scene object_1", "scene object_2"]
    assert names("objects") == seen
    unseen = names("unseen")
    assert unseen[:3] == [*seen, "unseen 0"]


def test_a_scene_is_pickled_and_copied(folder, tmp_path):
    scene = perception.load_scene(folder / "scene.yaml")
    scene.stamp = 5.0
    files = []
    for made in (scene, pickle.loads(pickle.dumps(scene)), copy.deepcopy(scene)):
        perception.save_scene(made, tmp_path / "made.yaml")
        files.append([(tmp_path / f"made.{end}").read_bytes() for end in ("yaml", "npz")])
    assert files[0] == files[1] == files[2]
    ends = [thing.rays[0].ends.tobytes() for thing in pickle.loads(pickle.dumps(scene)).objects]
    assert ends == [thing.rays[0].ends.tobytes() for thing in scene.objects]


def test_other_objects_get_a_padding(folder):
    def paddings(kind, name):
        text = TASK.replace("slide", kind).replace("object_0}", f"{name}, padding: 0.02}}")
        return {body.name: body.padding for body in load(folder, text).problem.obstacles}

    assert paddings("slide", "object_0") == {"scene object_1": 0.02, "scene object_2": 0.02}
    of_clasp = paddings("clasp", "object_1")
    assert of_clasp.pop("scene object_0") == of_clasp.pop("scene object_2") == 0.02
    assert set(of_clasp.values()) == {0.0}  # of supports
    card = CARD.format(corners=[[0, 0], [1, 0], [1, 1]], edges=[0])
    with pytest.raises(TaskError, match="padding is for objects of a scene"):
        load(folder, card.replace("thickness:", "padding: 0.01, thickness:"))


@pytest.mark.parametrize(
    ("above", "top"),
    [(0.1, 0.1), (0.015, 0.015), (0.002, -0.001), (-0.002, -0.003), (-0.04, -0.04), (-0.45, -0.45)],
)
def test_supports_around_an_object_are_obstacles(above, top):
    scene = scene_of([[[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]])
    X_WS = np.eye(4)
    X_WS[2, 3] = above
    other = perception.Support(
        name="support_1", polygon=scene.supports[0].polygon, X_WS=X_WS,
        edges=[perception.EdgeLabel.real] * 4,
    )  # fmt: skip
    scene = perception.Scene(
        status=scene.status, reason="", supports=[*scene.supports, other], unseen=[], warnings=[],
        objects=list(scene.objects),
    )  # fmt: skip
    (found,) = scenes.obstacles(scene, scene.objects[0], "objects", has_support=False)
    assert found.name == "scene support_1"
    heights = [above + corner[2] for part in found.parts for corner in part.convex]
    assert max(heights) == pytest.approx(top)


def test_a_floor_far_below_is_no_obstacle(folder):
    scene = perception.load_scene(folder / "scene.yaml")
    found = scenes.obstacles(scene, scene.objects[0], "objects", has_support=False)
    assert len(scene.supports) > 1
    assert not any("support" in obstacle.name for obstacle in found)


def test_a_clasp_from_a_scene_has_cloud_pose_and_table(folder):
    text = "kind: clasp\nrobot: {urdf: wam_t42}\nobject: {scene: scene.yaml, name: object_1}\n"
    task = load(folder, text)
    scene = perception.load_scene(folder / "scene.yaml")
    assert np.allclose(task.problem.X_WO, scene.objects[1].X_WO)
    assert np.allclose(task.problem.object.points, scene.objects[1].points, atol=1e-9)
    names = [body.name for body in task.problem.obstacles]
    assert f"scene {scene.objects[1].support}" in names
    assert "scene object_0" in names
    assert len(task.problem.object.rays) == 1


@pytest.mark.parametrize(
    ("old", "new", "words"),
    [
        (
            "object_0",
            "object_7",
            "the scene has no 'object_7' (one of: object_0, object_1, object_2)",
        ),
        (", name: object_0", "", "name must be given"),
        ("scene.yaml", "other.yaml", "no such file"),
        ("object_0}", "object_0, pose: {x: 1}}", "pose must not be given"),
        ("object_0}", "object_0, respect: walls}", "respect"),
        ("object_0}", "object_0}\nsupport: {height: 1}", "height and pose must not be given"),
        ("object_0}", "object_0}\nsupport: {usable_edges: [99]}", "usable_edges has 99"),
        ("object_0}", "object_0}\nsupport: {usable_edges: []}", "usable_edges is empty"),
    ],
)
def test_bad_tasks_of_a_scene_are_refused(folder, old, new, words):
    with pytest.raises(TaskError) as error:
        load(folder, TASK.replace(old, new))
    assert words in str(error.value)
    assert "task.yaml" in str(error.value)


def test_a_scene_without_a_real_edge_is_refused(folder):
    text = (folder / "scene.yaml").read_text()
    (folder / "blind.yaml").write_text(text.replace("real", "occluded"))
    with pytest.raises(TaskError, match="no real edge"):
        load(folder, TASK.replace("scene.yaml", "blind.yaml"))


CARD = """
kind: slide
robot: {{urdf: wam_t42}}
object: {{rectangle: {{size: [0.12, 0.08]}}, thickness: 0.003, pose: {{x: 0.62, y: 0.08}}}}
support: {{polygon: {corners}, usable_edges: {edges}}}
"""
CORNERS = [[0.3, -0.35], [1, -0.35], [1, 0.35], [0.3, 0.35]]


@pytest.mark.parametrize(("corners", "y"), [(CORNERS, -0.35), (CORNERS[::-1], 0.35)])
def test_usable_edges_of_a_file_are_by_its_own_corners(folder, corners, y):
    task = load(folder, CARD.format(corners=corners, edges=[0]))
    (index,) = task.problem.support.usable_edges
    edge = task.problem.support.polygon.edge(index)
    assert edge.a[1] == edge.b[1] == y


def test_a_plan_over_an_edge_that_is_not_usable_fails_its_check(folder):
    task = load(folder, CARD.format(corners=CORNERS, edges=[3]))  # at x = 0.3 m
    plan = graspless.plan(task, seed=1)
    assert plan, plan.reason
    assert plan.X_WO_goal[0, 3] < 0.4
    other = slide.Support(task.problem.support.polygon, np.eye(4), usable_edges=[1])
    faults = slide.check(with_support(task.problem, other), plan)
    assert any("not usable" in fault for fault in faults)


def with_support(problem, support):
    return slide.Problem(
        problem.robot, problem.hand, problem.object, support, problem.X_WO_start, problem.q_home
    )


def test_see_says_why_nothing_was_found(folder, capsys):
    with np.load(folder / "frame.npz") as frame:
        np.savez(folder / "mm.npz", depth=1000 * frame["depth"], K=frame["K"], X_WC=frame["X_WC"])
    code = main(["see", str(folder / "mm.npz"), "-o", str(folder / "none.yaml"), "--json"])
    summary = json.loads(capsys.readouterr().out)
    assert code == 1
    assert summary["status"] == "not_metres"
    assert not perception.load_scene(folder / "none.yaml")
    with pytest.raises(TaskError, match="nothing was found in this scene: the median depth"):
        load(folder, TASK.replace("scene.yaml", "none.yaml"))


def test_see_warns_of_a_camera_in_millimetres(folder, capsys):
    with np.load(folder / "frame.npz") as frame:
        far = frame["X_WC"].copy()
        far[:3, 3] *= 1000
        np.savez(folder / "far.npz", depth=frame["depth"], K=frame["K"], X_WC=far)
    main(["see", str(folder / "far.npz"), "-o", str(folder / "off.yaml")])
    assert "far.npz: the camera is 751.7 m from the origin" in capsys.readouterr().err


def test_see_takes_options(folder, capsys):
    def see(text):
        code = main(
            ["see", str(folder / "frame.npz"), "-o", str(folder / "low.yaml"), "--options", text]
        )
        return code, capsys.readouterr()

    assert see("{}")[0] == 0
    assert len(perception.load_scene(folder / "low.yaml").objects) == 3
    assert see("{min_object_area: 0.5}")[0] == 0
    assert not perception.load_scene(folder / "low.yaml").objects
    for text, words in (
        ("{min_area: 0.5}", "--options:1: min_area: unknown field; did you mean 'min_object_area'"),
        ("{max_height: -1}", "--options:1: max_height: -1: should be greater than"),
        ("max_height", "--options: max_height: should be fields in YAML"),
    ):
        code, said = see(text)
        assert code == 2
        assert words in said.err


def test_see_averages_frames_and_joins_views(folder, capsys):
    with np.load(folder / "frame.npz") as frame:
        K, X_WC, depth = frame["K"], frame["X_WC"], frame["depth"]
    np.savez(folder / "frames.npz", frames=np.stack([depth] * 3), K=K, X_WC=X_WC)
    files = [str(folder / "frames.npz"), str(folder / "frame.npz")]
    assert main(["see", *files, "-o", str(folder / "both.yaml"), "--json"]) == 0
    assert len(json.loads(capsys.readouterr().out)["objects"]) == 3


def test_each_cloud_has_its_own_viewpoint(folder, capsys):
    with np.load(folder / "frame.npz") as frame:
        K, X_WC, depth = frame["K"], frame["X_WC"], frame["depth"]
    v, u = np.nonzero(depth > 0)
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(len(u))], axis=-1)
    points = (rays * depth[v, u, None]) @ X_WC[:3, :3].T + X_WC[:3, 3]
    names = [str(folder / "one.xyz"), str(folder / "two.xyz")]
    for name in names:
        np.savetxt(name, points[::4], "%.5f")
    eye, output = list(map(str, X_WC[:3, 3])), ["-o", str(folder / "clouds.yaml")]

    def see(*arguments):
        return main(["see", *arguments, *output]), capsys.readouterr().err

    for given in (["--viewpoint", *eye], ["--viewpoint", *eye] * 3):
        code, said = see(*names, *given)
        assert code == 2
        assert re.search(
            r"--viewpoint: [13] for 2 cloud\(s\) \(.*one.xyz, .*two.xyz\): should", said
        )
    assert see(*names, *["--viewpoint", *eye] * 2)[0] == 0
    images = [names[0], str(folder / "frame.npz"), names[1]]
    far = ["--viewpoint", *eye, "--viewpoint", "0", "0", "1e5"]
    code, said = see(*images, *far)  # the second one is of the second cloud
    assert code == 2
    assert "two.xyz: viewpoint" in said


CAMERA = """
focal: [{K[0][0]}, {K[1][1]}]
center: [{K[0][2]}, {K[1][2]}]
pose: {{position: {position}, quaternion: {quaternion}}}
"""


def write_camera(folder, name, text=""):
    """Writes the camera of the frame, and returns the name of its file, depths, K and X_WC."""
    with np.load(folder / "frame.npz") as frame:
        K, X_WC, depth = frame["K"], frame["X_WC"], frame["depth"]
    row = [float(value) for value in frames.to_row(X_WC)]
    content = CAMERA.format(K=K.tolist(), position=row[:3], quaternion=row[3:])
    (folder / name).write_text(content + text)
    written = frames.translation(row[:3]) @ frames.from_quaternion(row[3:])
    return str(folder / name), depth, K, written


def test_depth_images_of_every_kind_show_the_same_scene(folder, capsys):
    camera, depth, K, X_WC = write_camera(folder, "camera.yaml", "unit: 0.001")
    counts = np.round(1000 * np.nan_to_num(depth)).astype(np.uint16)
    np.savez(folder / "same.npz", depth=0.001 * counts, K=K, X_WC=X_WC)
    PIL.Image.fromarray(counts).save(folder / "depth.png")
    PIL.Image.fromarray(counts).save(folder / "depth.tif")
    np.save(folder / "depth.npy", counts)
    in_metres = write_camera(folder, "metres.yaml")[0]
    np.save(folder / "metres.npy", (0.001 * counts).astype(np.float32))
    PIL.Image.fromarray((0.001 * counts).astype(np.float32)).save(folder / "metres.tiff")

    def seen(name, *flags):
        arguments = ["see", str(folder / name), *flags, "-o", str(folder / "y.yaml"), "--json"]
        assert main(arguments) == 0
        return json.loads(capsys.readouterr().out)

    expected = seen("same.npz")
    assert len(expected["objects"]) == 3
    for name in ("depth.png", "depth.tif", "depth.npy"):
        assert seen(name, "--camera", camera) == expected
    for name in ("metres.npy", "metres.tiff"):  # in single precision
        (first, *_), (same, *_) = seen(name, "--camera", in_metres)["objects"], expected["objects"]
        assert first["position"] == pytest.approx(same["position"], abs=1e-4)
    two = seen("depth.png", str(folder / "depth.npy"), "--camera", camera, "--camera", camera)
    assert len(two["objects"]) == 3


def test_an_array_of_points_is_a_cloud(folder, capsys):
    _, depth, K, X_WC = write_camera(folder, "camera.yaml")
    v, u = np.nonzero(depth > 0)
    rays = np.stack([(u - K[0, 2]) / K[0, 0], (v - K[1, 2]) / K[1, 1], np.ones(len(u))], axis=-1)
    points = (rays * depth[v, u, None]) @ X_WC[:3, :3].T + X_WC[:3, 3]
    np.save(folder / "cloud.npy", points)
    np.savetxt(folder / "cloud.xyz", points, "%.17g")
    viewpoint = ["--viewpoint", *map(str, X_WC[:3, 3]), "-o", str(folder / "z.yaml"), "--json"]
    said = []
    for name in ("cloud.npy", "cloud.xyz"):
        assert main(["see", str(folder / name), *viewpoint]) == 0
        said.append(capsys.readouterr().out)
    assert said[0] == said[1]


def test_bad_depth_images_are_refused(folder, capsys):
    camera, depth, *_ = write_camera(folder, "camera.yaml", "unit: 0.001")
    bare = write_camera(folder, "bare.yaml")[0]
    counts = np.round(1000 * np.nan_to_num(depth)).astype(np.uint16)
    PIL.Image.fromarray(counts).save(folder / "good.png")

    def refused(image, *flags):
        name = str(folder / "bad.npy")
        if isinstance(image, np.ndarray):
            np.save(name, image)
        else:
            name = str(folder / image)
        assert main(["see", name, *flags, "-o", str(folder / "x.yaml")]) == 2
        return capsys.readouterr().err

    given = ("--camera", camera)
    assert "good.png: a depth image needs --camera YAML, a file with" in refused("good.png")
    said = refused("good.png", "--camera", bare)
    assert "bare.yaml:2: unit: missing: good.png has integers; should be the distance" in said
    said = refused("good.png", "--camera", camera, "--camera", camera)
    assert f"--camera: 2 for 1 image(s) ({folder / 'good.png'}): should be given once" in said
    said = refused("frame.npz", "--camera", camera)
    assert said == "--camera: has no effect: none of the files is a depth image\n"
    assert "none.yaml: cannot be read: No such file" in refused("good.png", "--camera", "none.yaml")
    for text, words in (
        ("unit: 2.0", "unit: 2.0: should be less than or equal to 1"),
        ("distortion: [0.1]", "distortion: unknown field"),
        ("unit: mm", "unit: mm: should be a valid number"),
    ):
        wrong = write_camera(folder, "wrong.yaml", text)[0]
        assert f"wrong.yaml:5: {words}" in refused("good.png", "--camera", wrong)
    for mode in ("L", "RGB"):
        PIL.Image.fromarray((counts >> 8).astype(np.uint8)).convert(mode).save(folder / "8.png")
        said = refused("8.png", "--camera", camera)
        assert f"8.png: has pixels of type {mode}; those of a depth image are" in said
    pages = [PIL.Image.fromarray(counts)] * 2
    pages[0].save(folder / "pages.tif", save_all=True, append_images=pages[1:])
    assert "pages.tif: has 2 pages; a depth image has one" in refused("pages.tif", *given)
    PIL.Image.fromarray(counts.astype(np.int32)).save(folder / "long.tif")
    assert "long.tif: has pixels of type I; those" in refused("long.tif", *given)
    (folder / "cut.png").write_bytes((folder / "good.png").read_bytes()[:900])
    assert "cut.png: is damaged, or no image" in refused("cut.png", "--camera", camera)
    (folder / "text.png").write_text("no image")
    assert "text.png: is damaged, or no image of type PNG" in refused(
        "text.png", "--camera", camera
    )
    assert "bad.npy: has shape (480, 640, 4); a depth image" in refused(
        np.ones((480, 640, 4)), *given
    )
    assert "holds values of type complex128, not" in refused(np.ones((480, 640), complex), *given)
    assert "bad.npy: holds values of type object, not" in refused(np.array([[{}]]), *given)
    assert "at most 50000000 are read" in refused(np.ones((7100, 7100), np.uint8), *given)
    assert "has 8 bits per pixel; pictures" in refused(np.ones((480, 640), np.uint8), *given)
    said = refused(np.ones((480, 640, 3), np.uint8), "--viewpoint", "0", "0", "1")
    assert "the array has 8 bits per value, like the colours of a picture" in said
    (folder / "arrays.npy").write_bytes((folder / "frame.npz").read_bytes())
    assert "arrays.npy: is an .npz archive; rename it" in refused("arrays.npy", *given)
    np.save(folder / "cut.npy", counts)
    (folder / "cut.npy").write_bytes((folder / "cut.npy").read_bytes()[:5000])
    assert "cut.npy: its header states 307200 numbers, but 4872 bytes" in refused("cut.npy", *given)
    (folder / "text.npy").write_text("no array")
    assert "text.npy: its header is not that of an .npy file" in refused("text.npy")
    assert "a cloud needs --viewpoint" in refused(np.ones((9, 3)))


def test_a_file_of_other_origin_beside_the_scene_is_kept(folder, capsys):
    def see(*flags):
        assert main(["see", str(folder / "frame.npz"), "-o", str(folder / "own.yaml"), *flags]) == 0
        return capsys.readouterr().out

    aside = folder / "own.npz~"
    image = (folder / "frame.npz").read_bytes()
    (folder / "own.npz").write_bytes(image)
    assert see().endswith(f"kept: {aside}, as it was before\n")
    assert aside.read_bytes() == image
    (folder / "own.yaml").write_text((folder / "own.yaml").read_text() + "# mine\n")
    assert json.loads(see("--json"))["kept"] == []  # its own points again
    old = perception.load_scene(folder / "own.yaml")
    parts = {"supports": old.supports, "objects": old.objects[:1], "unseen": [], "warnings": []}
    new = perception.Scene(status=old.status, reason=old.reason, **parts)
    assert perception.save_scene(new, folder / "own.yaml") is None
    assert aside.read_bytes() == image
    (folder / "own.npz").write_bytes(image)
    assert json.loads(see("--json"))["kept"] == [str(aside)]


def test_bad_files_are_refused(folder, capsys):
    def refused(*arguments):
        assert main(["see", *map(str, arguments), "-o", str(folder / "x.yaml")]) == 2
        return capsys.readouterr().err

    np.savez(folder / "a.npz", depth=np.ones((480, 640)), K=np.eye(3))
    said = refused(folder / "a.npz")
    assert said.endswith("a.npz: must have the array X_WC; it has depth, K\n")
    np.savez(folder / "b.npz", K=np.eye(3), X_WC=np.eye(4))
    said = refused(folder / "b.npz")
    assert "b.npz: must have the array depth (or frames); it has K, X_WC; for an organised" in said
    both = {"depth": np.ones((480, 640)), "frames": np.ones((1, 480, 640))}
    np.savez(folder / "e.npz", K=np.eye(3), X_WC=np.eye(4), **both)
    assert "e.npz: has both depth and frames; it must have one" in refused(folder / "e.npz")
    np.savez(folder / "c.npz", depth=np.array([{}]), K=np.eye(3), X_WC=np.eye(4))
    assert "c.npz: cannot be read as arrays" in refused(folder / "c.npz")
    (folder / "cut.npz").write_bytes((folder / "a.npz").read_bytes()[:-30])
    assert "as arrays: it is cut off, or no .npz file" in refused(folder / "cut.npz")
    np.savez(folder / "d.npz", depth=np.ones((480, 640)), K=np.eye(3), X_WC=np.eye(4))
    assert "d.npz: K's horizontal principal point" in refused(folder / "d.npz")
    assert "no such file" in refused(folder / "none.npz")
    assert "unknown kind of file" in refused(folder / "scene.yaml")
    said = refused(folder / "frame.npz", "--viewpoint", 0, 0, 1)
    assert said == "--viewpoint: has no effect: none of the files is a cloud\n"
    choices = ".npz, .png, .tif, .tiff, .npy, .ply, .pcd, .xyz"
    said = refused(folder / "cloud.bag", "--viewpoint", 0, 0, 1)
    assert f"cloud.bag: unknown kind of file (one of: {choices})" in said
    assert "no.npy: no such file" in refused(folder / "no.npy", "--viewpoint", 0, 0, 1)
    (folder / "cloud.xyz").write_text("0 0 1\n")
    assert "a cloud needs --viewpoint" in refused(folder / "cloud.xyz")
    assert "VIEWPOINT" not in refused(folder / "cloud.xyz")
    header = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH 1\nHEIGHT 1\n"
    for stated, words in (("0 0 0", ""), ("0.1 0 1.5", "VIEWPOINT in the file is 0.1 0 1.5")):
        text = f"{header}VIEWPOINT {stated} 1 0 0 0\nPOINTS 1\nDATA ascii\n0 0 1\n"
        (folder / "cloud.pcd").write_text(text)
        message = refused(folder / "cloud.pcd")
        assert ("VIEWPOINT" in message) == bool(words)
        assert words in message
    assert main(["see", str(folder / "a.npz"), "-o", str(folder / "x.json")]) == 2
    assert "choices: .yaml, .yml" in capsys.readouterr().err


def scene_of(outlines, height=0.0, **thing):
    """A scene with objects of these outlines on a table."""
    X_WS = np.eye(4)
    X_WS[2, 3] = height
    square = np.array([[0, 0], [1, 0], [1, 1], [0, 1]])
    table = perception.Support(
        name="support_0", polygon=square, edges=[perception.EdgeLabel.real] * 4, X_WS=X_WS,
        height_error=0.0, angle_error=0.0, noise=0.001, least_thickness=0.002,
    )  # fmt: skip
    fields = {
        "support": "support_0", "X_WO": X_WS, "thickness": 0.1, "thickness_error": 0.0005,
        "is_flat": True, "position_error": 0.0, "yaw_error": 0.0, "points": np.zeros((1, 3)),
    } | thing  # fmt: skip
    objects = [
        perception.Object(name=f"object_{k}", outline=ring, **fields)
        for k, ring in enumerate(outlines)
    ]
    return perception.Scene(
        status=perception.Status.found, reason="", supports=[table], objects=objects, unseen=[],
        warnings=[],
    )  # fmt: skip


def turned(ring, yaw):
    c, s = np.cos(yaw), np.sin(yaw)
    return np.asarray(ring) @ [[c, s], [-s, c]]


def test_the_size_is_that_of_the_smallest_rectangle_around_the_outline():
    square, bar = (np.array([[0, 0], [a, 0], [a, b], [0, b]]) for a, b in ((8, 8), (3, 12)))
    notched = np.array([[0, 0], [6, 0], [6, 9], [3, 5], [0, 9]])
    rings = [turned(ring / 100, 0.6) for ring in (square, bar, notched)]
    sizes = [line.split(": ")[1].split(",")[0] for line in cli._lines(scene_of(rings))[2:]]
    assert sizes == ["8.0 cm x 8.0 cm", "12.0 cm x 3.0 cm", "9.0 cm x 6.0 cm"]


def test_the_noise_is_not_given_as_the_error_of_a_quantile():
    ring = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
    said = [cli._lines(scene_of([ring], is_flat=flat))[2] for flat in (True, False)]
    assert said[0].endswith("100.0 +- 0.5 mm thick, flat")
    assert said[1].endswith("100.0 mm thick (noise alone: +- 0.5 mm)")


def test_a_height_of_zero_has_no_minus(monkeypatch):
    ring = [[0, 0], [0.1, 0], [0.1, 0.1], [0, 0.1]]
    scene = scene_of([ring], height=-1e-5, warnings=["touches the border"])
    assert "height 0.000 m" in cli._lines(scene)[1]
    drawn = []
    monkeypatch.setattr(perceived, "as_png", drawn.append)
    perceived.draw(scene)
    assert drawn[0].axes[0].get_title(loc="left").startswith("support_0 at 0.000 m")
    assert [text.get_text() for text in drawn[0].texts] == [
        "(!): has warnings; graspless see prints them"
    ]
