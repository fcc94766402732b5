# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Observation of the object while the program runs: the failures of a trial."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

import mujoco
import numpy as np

from ... import frames
from ..obstacles import OBSTACLE, plain
from .fingers import OTHER, PAD, SLIDING
from .scene import EDGE, FOOT, HAND, NEIGHBOUR, OBJECT, TABLE

if TYPE_CHECKING:
    from ...frames import Matrix
    from ..settings import Slide
    from .scene import Scene

FAILURES = {
    "tip_lost": "the finger lost contact with the sliding object",
    "off_target": "the object was off its planned pose at the end of the slide",
    "tipped": "the object tilted over the table's edge",
    "fell": "the object fell off the table",
    "hit": "two bodies touched that must not",
    "not_grasped": "the hand closed without grasping the object",
    "dropped": "the object fell out of the hand during lift or hold, stayed behind, or was held "
    "but did not rise by 9 cm",
    "out_of_reach": "the grasp held, but the arm cannot lift straight up there as high as "
    "requested: at its limits, or without touching itself, the support or an obstacle",
}
# Two more in a true world, where others stand beside the object, and what was seen is not all:
# knocked: a body beside the object was moved by more than 2 cm, or tilted by 20 degrees;
# touched: a part of the hand other than the fingers touched the object before the grasp.
_BEFORE_GRASP = ("approach", "press", "slide", "lift", "reach", "grasp")
_AWAY = ("approach", "press", "slide", "lift", "reach", "retreat", "stop")  # only fingers may touch


@dataclass
class Judge:
    """Looks at the state every few steps."""

    scene: Scene
    interval: float  # between looks [s]
    settings: Slide
    failures: list[str] = field(default_factory=list)
    forces: list[float] = field(default_factory=list)  # of the tip while it slides [N]
    touched: tuple[str, str] | None = None  # what hit what
    lowest: float = field(init=False)  # height where the object has not fallen yet [m]
    _lost: float = 0.0
    _has_fallen: bool = False

    def __post_init__(self) -> None:
        model = self.scene.model
        self._kind = np.zeros(model.ngeom, dtype=int)  # 0: the arm and the hand
        order = (HAND, OBJECT, TABLE, OBSTACLE, FOOT, EDGE, PAD, SLIDING, OTHER, NEIGHBOUR)
        code = {what: i for i, what in enumerate(order, start=1)}
        for what in order:
            self._kind[self.scene.groups[what]] = code[what]
        allowed = [(FOOT, TABLE), (EDGE, OBJECT), (PAD, OBJECT), (PAD, TABLE)]
        allowed += [(SLIDING, OBJECT), (OTHER, OBJECT)]
        self._is_true = not len(self.scene.groups[FOOT])
        if self._is_true:
            allowed.append((OBJECT, TABLE))
        self._allowed = np.zeros((len(order) + 1,) * 2, dtype=bool)
        for a, b in allowed:
            self._allowed[code[a], code[b]] = self._allowed[code[b], code[a]] = True
        self._allowed[code[NEIGHBOUR], :] = self._allowed[:, code[NEIGHBOUR]] = True
        self._pad, self._object, self._foot = code[PAD], code[OBJECT], code[FOOT]
        self._fingers, self._rest = (code[SLIDING], code[OTHER]), code[HAND]
        self._body = model.body(OBJECT).id
        self._others = sorted(set(model.geom_bodyid[self.scene.groups[NEIGHBOUR]]))
        self._stood = model.body_pos[self._others].copy()
        self.lowest = -self.settings.fell

    def look(self, data: Any, phase: str) -> None:
        """Records the failures of the current state."""
        a, b = self._kinds(data)
        grasps = phase not in _AWAY
        self._allowed[self._rest, self._object] = self._allowed[self._object, self._rest] = grasps
        for index in np.flatnonzero(~self._allowed[a, b]):
            pair = {int(a[index]), int(b[index])}
            by_hand = self._is_true and pair == {self._rest, self._object}
            self._note_contact(data, int(index), "touched" if by_hand else "hit")
        if phase == "slide":
            self._watch_tip(data)
        self._watch_others(data)
        if phase in _BEFORE_GRASP and not self.tilt(data) <= self.settings.tipped:
            self.note("tipped")
        if not self.height(data.xpos[self._body]) >= self.lowest:
            self._has_fallen = True
            self.note("fell" if phase not in ("raise", "hold") else "dropped")

    def note(self, failure: str) -> None:
        """Records a failure once."""
        if failure not in self.failures:
            self.failures.append(failure)

    def withdraw(self, failure: str) -> None:
        """Forgets a failure that was made good."""
        self.failures = [other for other in self.failures if other != failure]
        self._lost = 0.0

    @property
    def is_over(self) -> bool:
        """True if the object has fallen."""
        return self._has_fallen

    def pose(self, data: Any) -> Matrix:
        """X_WO."""
        X_WO = frames.from_quaternion(data.xquat[self._body])
        X_WO[:3, 3] = data.xpos[self._body]
        return X_WO

    def height(self, p_WO: Matrix) -> Any:
        """Returns the height of points [..., 3] above the object's start [m].

        It is that along the support's normal: an object that slides down a slope keeps it.
        """
        return (p_WO - self.scene.X_WO[:3, 3]) @ self.scene.X_WO[:3, 2]

    def tilt(self, data: Any) -> float:
        """Returns the angle between the object's z axis now and at the start [rad]."""
        cosine = data.xmat[self._body].reshape(3, 3)[:, 2] @ self.scene.X_WO[:3, 2]
        return float(np.arccos(np.clip(cosine, -1, 1)))

    def holds(self, data: Any) -> bool:
        """Returns True if both fingers touch the object."""
        a, b = self._kinds(data)
        other = np.where(a == self._object, b, np.where(b == self._object, a, 0))
        return all((other == finger).any() for finger in self._fingers)

    def holds_clear(self, data: Any) -> bool:
        """Returns True if both fingers touch the object, and nothing but the hand does."""
        a, b = self._kinds(data)
        own = (self._object, self._foot)
        other = np.where(np.isin(a, own), b, np.where(np.isin(b, own), a, self._fingers[0]))
        return self.holds(data) and bool(np.isin(other, (*self._fingers, self._rest)).all())

    def is_touched(self, data: Any) -> bool:
        """Returns True if a finger or another part of the robot touches the object."""
        a, b = self._kinds(data)
        other = np.where(a == self._object, b, np.where(b == self._object, a, -1))
        return bool(np.isin(other, (0, *self._fingers, self._rest)).any())

    def _kinds(self, data: Any) -> tuple[Any, Any]:
        geoms = data.contact.geom
        touching = data.contact.dist < 0
        return self._kind[geoms[touching, 0]], self._kind[geoms[touching, 1]]

    def _note_contact(self, data: Any, index: int, failure: str) -> None:
        self.note(failure)
        if self.touched is None:
            geoms = data.contact.geom[data.contact.dist < 0][index]
            robot = (0, self._rest, *self._fingers, self._pad)
            first, second = sorted(geoms, key=lambda geom: self._kind[geom] in robot)
            self.touched = self._name(first), self._name(second)

    def _name(self, geom: int) -> str:
        """Returns the name of the link, of the obstacle or of another body that a geom is of."""
        model = self.scene.model
        body = model.body(model.geom_bodyid[geom])
        if body.name in (SLIDING, OTHER):
            body = model.body(body.parentid[0])  # the link that bends here
        return plain(body.name)

    def tip_force(self, data: Any) -> float:
        """Returns the normal force of the pad on the object [N]."""
        force, of_contact = 0.0, np.zeros(6)
        kinds = self._kind[data.contact.geom]
        pads = ((kinds == self._pad) | (kinds == self._object)).all(axis=1)
        for i in np.flatnonzero(pads):
            mujoco.mj_contactForce(self.scene.model, data, i, of_contact)
            force += float(of_contact[0])
        return force

    def _watch_others(self, data: Any) -> None:
        moved = np.linalg.norm(data.xpos[self._others] - self._stood, axis=1)
        upright = data.xmat[self._others].reshape(-1, 3, 3)[:, 2, 2]
        far, tilt = self.settings.knocked
        if (moved > far).any() or (upright < np.cos(tilt)).any():
            self.note("knocked")

    def _watch_tip(self, data: Any) -> None:
        self.forces.append(self.tip_force(data))
        self._lost = 0.0 if self.forces[-1] > 0 else self._lost + self.interval
        if self._lost > self.settings.lost_seconds:
            self.note("tip_lost")
