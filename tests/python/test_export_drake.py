# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Drake alone reads an exported folder, moves the robot as planned and steps it to the end."""

import numpy as np
import pytest
import trimesh

import graspless
from graspless import TaskError, cli
from graspless.formats.drake_robot import robot_urdf
from graspless.formats.drake_sdf import Meshes
from graspless.tasks.robot_files import resolve_robot
from graspless.tasks.robots import Robot, build_robot
from graspless.tasks.source import Source
from graspless.timing.trajectory import robot_of
from timing_common import planned

pytest.importorskip("pydrake", reason="Drake is not installed (extra drake)")

from pydrake.common.yaml import yaml_load_typed
from pydrake.geometry import Box, Mesh, Role
from pydrake.multibody.parsing import Parser
from pydrake.multibody.plant import AddMultibodyPlant, MultibodyPlant, MultibodyPlantConfig
from pydrake.systems.analysis import Simulator
from pydrake.systems.framework import DiagramBuilder
from pydrake.systems.primitives import TrajectorySource
from pydrake.trajectories import PiecewisePolynomial, StackedTrajectory

RATE = 5.0  # Drake takes 4 ms to read a piece


class Loaded:
    """A folder in Drake, with the robot's servos following the plan."""

    def __init__(self, folder):
        read = {"schema": PiecewisePolynomial}
        self.joints = yaml_load_typed(**read, filename=str(folder / "joints.yaml"))
        self.poses = yaml_load_typed(**read, filename=str(folder / "object.yaml"))
        builder = DiagramBuilder()
        config = MultibodyPlantConfig(time_step=0.001)
        self.plant, self.scene_graph = AddMultibodyPlant(config, builder)
        parser = Parser(self.plant)
        parser.package_map().AddPackageXml(str(folder / "package.xml"))
        parser.AddModels(str(folder / "scene.dmd.yaml"))
        self.robot = self.plant.GetModelInstanceByName("robot")
        self.object = self.plant.GetModelInstanceByName("object")
        self.plant.set_gravity_enabled(self.robot, False)
        self.plant.Finalize()
        states = StackedTrajectory()
        states.Append(self.joints)
        states.Append(self.joints.MakeDerivative())
        source = builder.AddSystem(TrajectorySource(states))
        port = self.plant.get_desired_state_input_port(self.robot)
        builder.Connect(source.get_output_port(), port)
        self.diagram = builder.Build()
        self.context = self.diagram.CreateDefaultContext()
        indices = self.plant.GetJointActuatorIndices(self.robot)
        moved = [self.plant.get_joint_actuator(index).joint() for index in indices]
        self.names = [joint.name() for joint in moved]
        self.columns = [joint.position_start() for joint in moved]

    @property
    def own(self):
        return self.plant.GetMyContextFromRoot(self.context)

    def place(self, t):
        """Puts joints and object where the polynomials have them at time t."""
        q = self.plant.GetPositions(self.own).copy()
        q[self.columns] = self.joints.value(t)[:, 0]
        self.plant.SetPositions(self.own, q)
        self.plant.SetPositions(self.own, self.object, self.poses.value(t)[:, 0])

    def pose(self, body):
        found = self.plant.GetBodyByName(body)
        return self.plant.EvalBodyPoseInWorld(self.own, found).GetAsMatrix4()

    def shapes(self, body, role=Role.kProximity):
        inspector = self.scene_graph.model_inspector()
        frame = self.plant.GetBodyFrameIdOrThrow(self.plant.GetBodyByName(body).index())
        found = inspector.GetGeometries(frame, role)
        return [(inspector.GetShape(g), inspector.GetPoseInFrame(g).translation()) for g in found]


def loaded(name, tmp_path, rate=RATE):
    trajectory = graspless.export(planned(name), tmp_path / "drake", "drake", rate=rate)
    return trajectory, Loaded(tmp_path / "drake")


@pytest.mark.parametrize("name", ["slide", "clasp", "carried", "lifted"])
def test_drake_has_the_plan_s_kinematics(tmp_path, name):
    trajectory, scene = loaded(name, tmp_path)
    robot = robot_of(trajectory.plan)
    assert scene.names == trajectory.joint_names == list(robot.joint_names)
    assert scene.joints.end_time() == scene.poses.end_time() == trajectory.duration
    mimics = {"right_finger", "right_fingertip"} if "right_finger_joint" not in scene.names else {}
    for k in (0, 1, len(trajectory) // 3, len(trajectory) // 2, len(trajectory) - 1):
        t = trajectory.times[k]
        np.testing.assert_allclose(scene.joints.value(t)[:, 0], trajectory.positions[k], atol=1e-9)
        rates = scene.joints.EvalDerivative(t)[:, 0]
        np.testing.assert_allclose(rates, trajectory.velocities[k], atol=1e-9)
        scene.place(t)
        np.testing.assert_allclose(scene.pose("object"), trajectory.object_poses[k], atol=1e-9)
        for frame, X_WF in zip(
            robot.frame_names, robot.forward(trajectory.positions[k]), strict=True
        ):
            if frame not in mimics:  # they follow in steps alone
                np.testing.assert_allclose(scene.pose(frame), X_WF, atol=1e-9)


def test_between_samples_drake_is_where_the_plan_is(tmp_path):
    _, scene = loaded("clasp", tmp_path, rate=20.0)
    fine = graspless.time(planned("clasp"), rate=400)
    values = np.hstack([scene.joints.value(t) for t in fine.times]).T
    np.testing.assert_allclose(values, fine.positions, atol=5e-4)


@pytest.mark.parametrize("name", ["clasp", "regrasp", "lifted"])
def test_drake_steps_to_the_end_of_the_plan(tmp_path, name):
    trajectory, scene = loaded(name, tmp_path)
    simulator = Simulator(scene.diagram)
    simulator.AdvanceTo(trajectory.duration)
    scene.context = simulator.get_mutable_context()
    asked = scene.joints.value(trajectory.duration)[:, 0]
    error = np.abs(scene.plant.GetPositions(scene.own)[scene.columns] - asked).max()
    print(f"{name}: largest error of a joint at the end {error:.1e}")
    assert error < 1e-3
    if name == "lifted":  # the finger that mimics the other has followed
        robot = robot_of(trajectory.plan)
        X_WF = robot.forward(trajectory.positions[-1])[
            list(robot.frame_names).index("right_finger")
        ]
        np.testing.assert_allclose(scene.pose("right_finger"), X_WF, atol=1e-3)


def test_drake_starts_at_the_start(tmp_path):
    trajectory, scene = loaded("slide", tmp_path)
    q = scene.plant.GetPositions(scene.own)[scene.columns]
    np.testing.assert_array_equal(q, trajectory.positions[0])
    np.testing.assert_allclose(scene.pose("object"), trajectory.object_poses[0], atol=1e-12)


def test_drake_has_the_task_s_things(tmp_path):
    _, scene = loaded("slide", tmp_path)
    thing = planned("slide").task.problem.object
    body = scene.plant.GetBodyByName("object")
    inertia = body.default_spatial_inertia()
    assert inertia.get_mass() == pytest.approx(thing.mass)
    np.testing.assert_allclose(inertia.get_com(), thing.com, atol=1e-12)
    ((mesh, _),) = scene.shapes("object")
    assert isinstance(mesh, Mesh)
    outline = np.asarray(thing.outline.vertices)
    read = trimesh.load(mesh.source().path(), force="mesh")
    np.testing.assert_allclose(np.ptp(read.vertices, axis=0)[:2], np.ptp(outline, axis=0))
    assert np.ptp(read.vertices[:, 2]) == pytest.approx(thing.thickness)


def test_the_hole_of_a_clasp_s_object_stays_open(tmp_path):
    _, scene = loaded("clasp", tmp_path)
    assert scene.shapes("object") == []
    assert len(scene.shapes("object", Role.kIllustration)) == 1


def test_planes_are_boxes_below_them(tmp_path):
    _, scene = loaded("regrasp", tmp_path)
    ((floor, middle),) = scene.shapes("floor")
    assert isinstance(floor, Box)
    assert middle[2] + floor.height() / 2 == pytest.approx(0.0)
    for plane in planned("regrasp").task.problem.planes:
        ((box, middle),) = scene.shapes(plane.name)
        assert np.asarray(plane.n_W) @ middle + box.height() / 2 == pytest.approx(plane.offset)


URDF = """<robot name="arm">
  <link name="world"/>
  <link name="a">
    <inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
    <visual><geometry><mesh filename="missing.stl"/></geometry></visual>
    <visual><geometry><mesh filename="part.stl" scale="2 2 2"/></geometry></visual>
    <collision><geometry><mesh filename="part.stl" scale="2 2 2"/></geometry></collision>
  </link>
  <joint name="turn" type="continuous">
    <parent link="world"/><child link="a"/><axis xyz="0 0 1"/>
  </joint>
  <transmission name="t"><type>transmission_interface/SimpleTransmission</type>
    <joint name="turn"/><actuator name="motor"/></transmission>
</robot>"""


def test_meshes_of_a_robot_are_converted(tmp_path):
    """A robot with meshes, a link that is called world and a transmission of its own."""
    trimesh.creation.box((0.1, 0.2, 0.3)).export(tmp_path / "part.stl")
    (tmp_path / "arm.urdf").write_text(URDF)
    source = Source("task.yaml", {"robot": {"urdf": "arm.urdf"}})
    fields, _ = resolve_robot(Robot(urdf="arm.urdf"), source, tmp_path)
    robot, meshes = build_robot(fields, source), Meshes()
    with pytest.warns(UserWarning, match=r"missing.stl: no such file"):
        text = robot_urdf(robot, fields, meshes)
    (tmp_path / "meshes").mkdir()
    (name,) = meshes.files  # one file for both roles
    (tmp_path / name).write_text(meshes.files[name])
    (tmp_path / "drake.urdf").write_text(text)
    plant = MultibodyPlant(0.001)
    Parser(plant).AddModels(str(tmp_path / "drake.urdf"))
    plant.WeldFrames(plant.world_frame(), plant.GetFrameByName("graspless_base"))
    plant.Finalize()
    assert plant.GetJointActuatorByName("turn").joint().name() == "turn"
    assert plant.num_actuators() == 1
    read = trimesh.load(tmp_path / name, force="mesh")
    np.testing.assert_allclose(np.ptp(read.vertices, axis=0), [0.1, 0.2, 0.3])


def test_the_command_writes_a_folder_once(tmp_path, capsys):
    planned("clasp").save(tmp_path / "plan.json")
    command = ["export", str(tmp_path / "plan.json"), "--to", "drake", "--rate", "20", "-o"]
    assert cli.main([*command, str(tmp_path / "drake")]) == 0
    for taken, words in (("drake", "is a folder"), ("plan.json", "should be a folder's name")):
        assert cli.main([*command, str(tmp_path / taken)]) == 2
        assert words in capsys.readouterr().err
    (tmp_path / "drake" / "file").touch()
    assert cli.main([*command, str(tmp_path / "drake" / "file")]) == 2
    assert "it exists already; should be a new folder" in capsys.readouterr().err
    with pytest.raises(TaskError, match="group: arm: drake holds the whole robot"):
        graspless.export(planned("clasp"), tmp_path / "other", "drake", group="arm")
    assert sorted(path.name for path in tmp_path.iterdir()) == ["drake", "plan.json"]
