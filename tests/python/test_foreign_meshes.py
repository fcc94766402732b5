# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Collision meshes in .dae, .glb and .gltf, read by trimesh in a process of its own."""

import base64
import io
import json
import subprocess
import zipfile

import numpy as np
import pytest
import trimesh

from graspless import _mesh_reader, geometry, robot
from graspless.errors import install_command
from graspless.tasks.robot_files import resolve_robot
from graspless.tasks.robots import Robot, build_robot
from graspless.tasks.source import Source

pytest.importorskip("collada")

DAE = """\
<?xml version="1.0" encoding="utf-8"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
  <asset><unit name="inch" meter="{unit}"/><up_axis>{up}</up_axis></asset>
  <library_geometries><geometry id="wedge"><mesh>
    <source id="p"><float_array id="a" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
      <technique_common><accessor source="#a" count="4" stride="3"><param name="X" type="float"/>
      <param name="Y" type="float"/><param name="Z" type="float"/></accessor></technique_common>
    </source>
    <vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
    <triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/>
      <p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
  </mesh></geometry></library_geometries>
  {nodes}
  <scene><instance_visual_scene url="#s"/></scene>
</COLLADA>
"""
SCENE = """\
<library_visual_scenes><visual_scene id="s">
  <node><matrix>1 0 0 0 0 1 0 0 0 0 1 0 0 0 0 1</matrix><instance_geometry url="#wedge"/></node>
  <node><matrix>2 0 0 10 0 2 0 0 0 0 2 0 0 0 0 1</matrix>
    <node><translate>0 5 0</translate><instance_geometry url="#wedge"/></node></node>
</visual_scene></library_visual_scenes>"""


def dae(unit="0.0254", up="Z_UP", nodes=SCENE):
    return DAE.format(unit=unit, up=up, nodes=nodes)


@pytest.fixture(autouse=True)
def cache(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    return tmp_path / "cache/graspless/meshes"


@pytest.fixture
def processes(monkeypatch):
    """Counts the processes that are started."""
    started, run = [], subprocess.run

    def count(*arguments, **options):
        started.append(arguments)
        return run(*arguments, **options)

    monkeypatch.setattr(subprocess, "run", count)
    return started


def said(path, content):
    path.write_bytes(content if isinstance(content, bytes) else content.encode())
    with pytest.raises(ValueError, match=f"mesh '{path}'") as error:
        geometry.read_mesh(str(path))
    assert "\n" not in str(error.value)
    return str(error.value)


@pytest.mark.parametrize("up", ["Z_UP", "Y_UP"])
def test_dae_in_inches_with_two_geometries(tmp_path, up):
    path = tmp_path / "wedges.DAE"
    path.write_text(dae(up=up))
    mesh = geometry.read_mesh(str(path))
    assert len(mesh.vertices) == 8  # no vertex occurs twice in a geometry
    assert len(mesh.triangles) == 8
    corners = [mesh.vertices.min(axis=0), mesh.vertices.max(axis=0)]
    np.testing.assert_allclose(corners, 0.0254 * np.array([[0, 0, 0], [12, 12, 2]]), atol=1e-12)
    both = trimesh.Trimesh(mesh.vertices, mesh.triangles)
    assert both.volume == pytest.approx((1 + 8) / 6 * 0.0254**3)  # outward stays outward


def test_formats_agree(tmp_path):
    shape = trimesh.creation.icosphere(subdivisions=2, radius=0.1)
    shape.apply_translation([0.1, 0.2, 0.3])
    for kind in ("stl", "glb", "dae"):
        shape.export(tmp_path / f"ball.{kind}")
    buffer = trimesh.Scene(shape).export(file_type="gltf")
    document = json.loads(buffer["model.gltf"])
    for entry in document["buffers"]:
        data = base64.b64encode(buffer[entry["uri"]]).decode()
        entry["uri"] = f"data:application/octet-stream;base64,{data}"
    (tmp_path / "ball.gltf").write_text(json.dumps(document))
    expected = geometry.read_mesh(str(tmp_path / "ball.stl"), 2.0)
    for kind in ("glb", "dae", "gltf"):
        mesh = geometry.read_mesh(str(tmp_path / f"ball.{kind}"), 2.0)
        assert len(mesh.vertices) == len(expected.vertices) == 162
        order, known = (
            np.lexsort(mesh.vertices.round(5).T),
            np.lexsort(expected.vertices.round(5).T),
        )
        np.testing.assert_allclose(mesh.vertices[order], expected.vertices[known], atol=1e-6)


def urdf(folder, files):
    links = "".join(
        f'<link name="{name}"><collision><geometry><mesh filename="{name}"/></geometry></collision>'
        f'</link><joint name="j{name}" type="fixed"><parent link="base"/><child link="{name}"/></joint>'
        for name in files
    )
    for name in files:
        (folder / name).write_text(dae(unit=str(1 + len(name))))
    (folder / "arm.urdf").write_text(f'<robot name="r"><link name="base"/>{links}</robot>')


def test_robot_is_read_by_one_process_and_then_by_none(tmp_path, cache, processes):
    urdf(tmp_path, ["a.dae", "bb.dae", "ccc.dae"])
    source = Source("task.yaml", {"robot": {"urdf": "arm.urdf"}})
    for _ in range(2):
        fields, _ = resolve_robot(Robot(urdf="arm.urdf"), source, tmp_path)
        arm = robot.Robot.from_urdf(fields.urdf_text, directory=str(tmp_path))
        assert [placed.shape.vertices.max() for _, placed in arm.shapes] == [72, 84, 96]
    assert len(processes) == 1
    for path in cache.iterdir():
        path.write_bytes(path.read_bytes()[:100])
    assert len(robot.Robot.from_urdf_file(str(tmp_path / "arm.urdf")).shapes) == 3
    assert len(processes) == 4


def test_cache_that_cannot_be_written(tmp_path, monkeypatch):
    (tmp_path / "file").write_text("")
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "file"))
    (tmp_path / "a.dae").write_text(dae())
    assert len(geometry.read_mesh(str(tmp_path / "a.dae")).triangles) == 8


INERTIAL = """<inertial><mass value="1"/>
<inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="9"/></inertial>"""  # A + B < C
MOVING = """\
<robot name="r"><link name="base"/>
  <link name="arm">{inertial}
    <collision><geometry><mesh filename="a.dae" scale="2 2 2"/></geometry></collision>
    <visual><geometry><mesh filename="a.dae" scale="2 2 2"/></geometry></visual>
  </link>
  <joint name="turn" type="continuous"><parent link="base"/><child link="arm"/>
    <limit velocity="1" effort="1"/></joint>
</robot>"""


@pytest.fixture
def moving(tmp_path):
    """A robot with a .dae to draw and to collide with, and fields of a task."""
    (tmp_path / "a.dae").write_text(dae())
    (tmp_path / "arm.urdf").write_text(MOVING.format(inertial=INERTIAL))
    source = Source("task.yaml", {"robot": {"urdf": "arm.urdf"}})
    fields, _ = resolve_robot(Robot(urdf="arm.urdf"), source, tmp_path)
    return build_robot(fields, source), fields


def test_dae_is_drawn_in_metres(moving, processes):
    from graspless.view import bodies

    drawn = bodies.robot_bodies(*moving)[1].parts[0].vertices
    np.testing.assert_allclose(drawn.max(axis=0), 2 * 0.0254 * np.array([12, 12, 2]))
    assert not processes  # it was read as a collision mesh


def test_dae_is_simulated(moving):
    pytest.importorskip("mujoco")
    from graspless.simulation.robots import robot_spec

    model = robot_spec(*moving).compile()
    assert model.ngeom == 1
    size = 0.0254 * 2 * np.array([12, 12, 2])
    assert model.geom_rbound[0] >= np.linalg.norm(size) / 3


def bomb():
    """Nodes that contain the next one twice, 40 deep."""
    nodes = "".join(
        f'<node id="n{i}"><instance_node url="#n{i + 1}"/><instance_node url="#n{i + 1}"/></node>'
        for i in range(40)
    )
    return (
        f'<library_nodes>{nodes}<node id="n40"><instance_geometry url="#wedge"/></node></library_nodes>'
        '<library_visual_scenes><visual_scene id="s"><node><instance_node url="#n0"/></node>'
        "</visual_scene></library_visual_scenes>"
    )


def test_refuses_damaged_files(tmp_path):
    archive = io.BytesIO()
    with zipfile.ZipFile(archive, "w") as file:
        file.writestr("a.dae", dae())
    empty = '<library_visual_scenes><visual_scene id="s"/></library_visual_scenes>'
    assert "it is an archive" in said(tmp_path / "zip.dae", archive.getvalue())
    assert "cannot be read: it has no triangles" in said(tmp_path / "empty.dae", dae(nodes=empty))
    assert "cannot be read: " in said(tmp_path / "text.dae", "text")
    assert "cannot be read: " in said(tmp_path / "unit.dae", dae(unit="long"))
    assert "vertices" in said(tmp_path / "nan.dae", dae(unit="nan"))
    assert "cannot be read: " in said(tmp_path / "none.glb", b"glTF")
    other = {"asset": {"version": "2.0"}, "buffers": [{"uri": "/etc/passwd", "byteLength": 4}]}
    assert "its data in another file; save it as .glb" in said(
        tmp_path / "other.gltf", json.dumps(other)
    )


def test_a_bomb_ends_in_time(tmp_path, monkeypatch):
    monkeypatch.setattr(_mesh_reader, "SECONDS", 2)
    fault = said(tmp_path / "bomb.dae", dae(nodes=bomb()))
    assert "cannot be read: " in fault


def test_limit_of_size(tmp_path, monkeypatch):
    monkeypatch.setattr(_mesh_reader, "LARGEST", 100)
    assert "bytes, more than 100" in said(tmp_path / "a.dae", dae())


def test_names_the_missing_package(tmp_path, monkeypatch):
    monkeypatch.setattr(_mesh_reader, "find_spec", lambda name: None if name == "collada" else name)
    fault = said(tmp_path / "a.dae", dae())
    assert "needs collada for .dae, .glb and .gltf files: " in fault
    assert install_command("robots") in fault


def test_preparing_leaves_the_fault_to_the_reader(tmp_path, monkeypatch):
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    paths = [tmp_path / "a.dae", tmp_path / "b.dae"]
    for path in paths:
        path.write_text(path.name)
    monkeypatch.setattr(_mesh_reader, "find_spec", lambda name: None)
    _mesh_reader.prepare(paths)
    with pytest.raises(ValueError, match=r"a\.dae' needs trimesh"):
        _mesh_reader.read(str(paths[0]))
