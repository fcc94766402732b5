# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Row of a fingertip plan under wrenches on the object."""

from __future__ import annotations

from typing import TYPE_CHECKING

import mujoco
import numpy as np

from ... import frames
from ...mechanics import wrench_scale
from ..settings import Fingertip
from ..variation import Variation
from .execute import corner_error
from .passing import passing
from .servo import Servo
from .world import build_world

if TYPE_CHECKING:
    from collections.abc import Sequence

    from ...fingertip import Plan, Segment
    from ...frames import Matrix
    from ..settings import Break


class Disturbed:
    """A row of a moving plan, and the effect of wrenches there."""

    def __init__(
        self,
        plan: Plan,
        segment: Segment,
        row: int,
        settings: Break,
        directions: Sequence[int] | None = None,
    ) -> None:
        problem, self._settings = plan.task.problem, settings
        self._world = build_world(problem, Variation(), Fingertip(), friction_at=min)
        self._world.soften(slides=segment.name in ("slide", "turn"))
        self._script = passing(plan, segment, row, settings).at(
            np.arange(0, settings.until + settings.goes_on, self._world.model.opt.timestep)
        )
        limit = problem.fingers.max_normal_force
        self._servo = Servo(self._world, self._script, limit)
        scale = wrench_scale(problem.object.mass, problem.object.inertia)
        unscaled = np.asarray(plan.task.options.disturbance_directions)
        self.wrenches_O = np.linalg.solve(scale, unscaled.T).T
        self._tried = range(len(unscaled)) if directions is None else directions
        self._start = round(settings.begin / self._world.model.opt.timestep)
        moments = range(self._start, round(settings.until / self._world.model.opt.timestep))
        self._first = sum(i % settings.every == 0 for i in moments)  # looks of the test proper
        self._touches = segment.touches[row]
        self._zeroed_O = np.zeros_like(self._script.centers[0])
        self._state = self._settled()
        self.misplaced = 0.0  # of a finger, by a spring that bent without any wrench, at worst [m]
        self._undisturbed = self._run(np.zeros(6))

    @property
    def undisturbed(self) -> float:
        """Returns the largest distance of a corner from its plan without any wrench [m]."""
        moments = range(self._start, len(self._script))
        looked_at = [i for i in moments if i % self._settings.every == 0][: self._first]
        return max(
            corner_error(self._world.hull, place, self._script.places[i])
            for i, place in zip(looked_at, self._undisturbed, strict=False)
        )

    def breaks(self, wrench_O: Matrix, distance: float) -> bool:
        """True if a wrench about the centre of mass, in O [N, N m], moves a corner so far [m].

        Where the object still moves at the end of the test and might go so far, it goes on for
        longer: the damping of the fingers slows down what nothing holds.
        """
        places = self._run(wrench_O, distance, self._first)
        if len(places) < self._first:
            return True
        settings, step = self._settings, self._settings.every * self._world.model.opt.timestep
        before = max(round(settings.rest_window / step), 1)
        off, earlier, first = (
            corner_error(self._world.hull, places[i], self._undisturbed[self._first + i])
            for i in (-1, -1 - before, -1 - 2 * before)
        )
        ratio = np.clip((off - earlier) / max(earlier - first, 1e-12), 0.0, 1.0)
        windows = np.arange(1, round(settings.goes_on / settings.rest_window) + 1)
        if off + (off - earlier) * (ratio**windows).sum() < distance:
            return False
        return len(self._run(wrench_O, distance)) < len(self._undisturbed)

    def smallest(self, z: float, distance: float) -> tuple[float, int]:
        """Returns factor [N] and index of the direction of the smallest wrench that does.

        0 and -1: it goes so far from its planned place without any; inf and -1: none does.
        """
        if not self.undisturbed < distance:
            return 0.0, -1
        best, direction = self._settings.largest * z, -1
        for k in self._tried:
            wrench_O = self.wrenches_O[k]
            if not self.breaks(best * wrench_O, distance):
                continue
            holds = 0.0
            direction = k
            while best - holds > self._settings.precision * best:
                middle = (holds + best) / 2
                if self.breaks(middle * wrench_O, distance):
                    best = middle
                else:
                    holds = middle
        return (best if direction >= 0 else np.inf), direction

    def _settled(self) -> Matrix:
        """Returns the state of the world just before the wrench."""
        world, script = self._world, self._script
        held, settings = script.places[0], self._settings
        world.place(frames.from_row(held), script.centers[0])
        letting_go = settings.still - settings.load_seconds
        for i in range(self._start):
            time = script.times[i]
            loaded = min(1.0, time / settings.load_seconds)
            grip = np.clip((settings.still - time) / letting_go, 0, 1)
            world.carry(held, 1 - loaded, grip * settings.carry_rate)
            if any(abs(time - at) < world.model.opt.timestep / 2 for at in settings.zero):
                self._servo.zero(i)
                self._zeroed_O = self._commanded_O(i)
            self._servo.command(i)
            mujoco.mj_step(world.model, world.data)
        self._zero_O = self._servo.zero_O
        state = np.zeros(mujoco.mj_stateSize(world.model, _WHOLE))
        mujoco.mj_getState(world.model, world.data, state, _WHOLE)
        return state

    def _run(
        self, wrench_O: Matrix, distance: float | None = None, looks: int | None = None
    ) -> list[Matrix]:
        """Returns poses of the object every few steps, up to where it moves too far, or so many."""
        world, settings = self._world, self._settings
        mujoco.mj_setState(world.model, world.data, self._state, _WHOLE)
        self._servo.zero_O = self._zero_O
        places: list[Matrix] = []
        for i in range(self._start, len(self._script)):
            if len(places) == looks:
                break
            since = self._script.times[i] - settings.begin
            risen = min(1.0, since / settings.rise_seconds)
            world.push(0.5 * (1 - np.cos(np.pi * risen)) * wrench_O)
            self._servo.command(i)
            mujoco.mj_step(world.model, world.data)
            if i % settings.every != 0:
                continue
            place = world.object_qpos.copy()
            if distance is not None:
                off = corner_error(world.hull, place, self._undisturbed[len(places)])
                if not off < distance:
                    break
            elif len(places) < self._first:
                self.misplaced = max(self.misplaced, self._beside(i))
            places.append(place)
        return places

    def _commanded_O(self, i: int) -> Matrix:
        """Returns where the fingers [n, 3] should be on the object as it lies [m]."""
        X_WO = self._world.X_WO
        places_O: Matrix = (self._servo.commanded(i) - X_WO[:3, 3]) @ X_WO[:3, :3]
        return places_O

    def _beside(self, i: int) -> float:
        """Returns how far a finger's spring is from where it was zeroed, at worst [m].

        Fingers in force control have no spring along the normal.
        """
        off = (self._commanded_O(i) - self._zeroed_O)[self._touches]
        normals_O = (self._script.normals[i] @ self._world.X_WO[:3, :3])[self._touches]
        holds = (self._script.holds[i] > 0)[self._touches]
        along = (off * normals_O).sum(axis=1) * ~holds
        return float(np.linalg.norm(off - along[:, None] * normals_O, axis=1).max())


_WHOLE = int(mujoco.mjtState.mjSTATE_INTEGRATION)
