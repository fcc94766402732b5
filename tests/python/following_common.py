# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A world without physics for followers: joints do as told, the object moves with the fingertip."""

from __future__ import annotations

from dataclasses import dataclass, field

import numpy as np

from graspless import _data, frames
from graspless.following import Follower, Settings

CARD = _data.directory("examples") / "01_slide_card.yaml"
CAMERA = {"lag": 0.1, "noise": (0.002, np.radians(1)), "bias": (0.0009, -0.0009, 0.0008)}
# A search that ends in one update finds the same plan on a busy machine, too.
PATIENT = Settings(search_seconds=1.0, plan_seconds=2.0, resume_seconds=1.0)


@dataclass
class World:
    """Joints at their targets, and an object that follows the effective fingertip in contact.

    `grip` is the fraction of the fingertip's turning that the object takes part in. The camera
    gives the pose `lag` s late, with noise [m, rad] and a bias [m].
    """

    plan: object
    x: float = 0.0
    y: float = 0.0
    yaw: float = 0.0
    grip: float = 1.0
    lag: float = 0.0
    noise: tuple[float, float] = (0.0, 0.0)
    bias: tuple[float, float, float] = (0.0, 0.0, 0.0)
    seed: int = 0
    rate: float = 50.0
    camera: int = 2  # one pose every so many updates; 0: none
    targets: list = field(default_factory=list)
    places: list = field(default_factory=list)  # X_WO at each target

    def __post_init__(self):
        problem = self.plan.task.problem
        self.problem, self.robot, self.hand = problem, problem.robot, problem.hand
        self.X_WO = np.array(problem.X_WO_start) @ frames.planar(0, 0, self.yaw)
        self.X_WO[:3, 3] += [self.x, self.y, 0]
        self.follower = Follower(self.plan, PATIENT)
        self.random = np.random.default_rng(self.seed)
        self.q = np.array(self.plan.segments[0].positions[0])
        self.t, self.shown, self.pose, self.age = 0.0, [], None, 0.0
        self.contact = None

    def effective_tip(self, q):
        """Place of the contact: eq. of the flexing finger (docs/internals/slide.md)."""
        X_SF = np.linalg.inv(self.problem.support.X_WS) @ self.robot.pose(self.hand.fingertip, q)
        L, r = self.hand.flexure_length, self.hand.tip_radius
        heading = X_SF[:2, 2] / np.linalg.norm(X_SF[:2, 2])
        b = np.arcsin(-X_SF[2, 2])
        depth = self.problem.object.thickness - X_SF[2, 3]
        bent = np.arcsin(np.sin(b) - depth / L)
        s = L * (np.cos(bent) - np.cos(b)) + r * (self.plan.task.options.pitch - bent)
        x, y = X_SF[:2, 3] + s * heading
        return frames.planar(x, y, np.arctan2(X_SF[1, 0], X_SF[0, 0]))

    def step(self, **given):
        """One update; the object moves by what the fingertip does in the slide."""
        self.t += 1 / self.rate
        pose = self._camera() if "pose" not in given else None
        if pose is not None:
            given = {"pose": pose, "age": self.lag} | given
        target = self.follower.update(given.pop("t", self.t), given.pop("q", self.q), **given)
        self.targets.append(target)
        self.q = target.position
        tip = self.effective_tip(self.q) if target.phase == "slide" else None
        if tip is not None and self.contact is not None:
            X_WS = np.array(self.problem.support.X_WS)
            moved = tip @ np.linalg.inv(self.contact)
            turn = np.arctan2(moved[1, 0], moved[0, 0])
            slipped = (
                frames.translation([*tip[:2, 3], 0])
                @ frames.planar(0, 0, (self.grip - 1) * turn)
                @ frames.translation([*-tip[:2, 3], 0])
            )
            self.X_WO = X_WS @ slipped @ moved @ np.linalg.inv(X_WS) @ self.X_WO
        self.contact = tip
        self.places.append(self.X_WO)
        return target

    def _camera(self):
        if not self.camera or len(self.targets) % self.camera:
            return None
        X_WO = self.X_WO @ frames.planar(0, 0, self.random.normal() * self.noise[1])
        X_WO[:3, 3] += self.random.normal(size=3) * self.noise[0] + self.bias
        self.shown.append((self.t, X_WO))
        ready = [X for t, X in self.shown if t <= self.t - self.lag + 1e-9]
        self.shown = [(t, X) for t, X in self.shown if t > self.t - self.lag + 1e-9]
        return ready[-1] if ready else None

    def run(self, until=lambda target: False, seconds=90.0):
        """Runs until the end, or until `until` holds of a target; returns that."""
        while self.t < seconds:
            target = self.step()
            if target.status in ("done", "stopped") or until(target):
                return target
        raise AssertionError(f"no end in {seconds} s: {target.status}, {target.reason}")

    def error(self):
        """Distance and angle of the object from the goal of the plan that is followed [m, rad]."""
        X = np.linalg.inv(self.follower.plan.X_WO_goal) @ self.X_WO
        return float(np.linalg.norm(X[:3, 3])), abs(float(np.arctan2(X[1, 0], X[0, 0])))

    def kick(self, x, y, yaw):
        """Displaces the object."""
        self.X_WO = self.X_WO @ frames.planar(0, 0, yaw)
        self.X_WO[:2, 3] += [x, y]


def phases(world):
    """Names of the phases that a world went through, in order."""
    return list(dict.fromkeys(target.phase for target in world.targets))
