# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every parameter of the physics engine, with where it comes from. Nothing else has one."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True)
class Solver:
    """What MuJoCo's defaults get wrong for slow contact with friction."""

    timestep: float = 0.002  # MuJoCo's own [s]
    cone: str = "elliptic"  # Coulomb's cone; a pyramid slips sooner along its diagonals
    impratio: float = 100.0  # 1 creeps by 4 mm/s under a steady push, 100 by 0.001
    integrator: str = "implicitfast"  # stiff servos
    tolerance: float = 1e-10
    iterations: int = 100


@dataclass(frozen=True)
class Servo:
    """Position control of an arm's and a hand's joints."""

    sag: float = 0.01  # deflection at the joint's greatest effort [rad or m]: an industrial arm's
    bandwidth: float = 100.0  # sqrt(stiffness / inertia) [rad/s]: sets the rotor's inertia
    damping_ratio: float = 1.0
    effort: float = 50.0  # of a joint whose URDF has none [Nm or N]


@dataclass(frozen=True)
class Spread:
    """Half widths of what trials vary."""

    friction: float = 0.3  # of its value
    mass: float = 0.2  # of its value
    position: float = 0.003  # of the object [m]
    angle: float = 0.0349  # of the object, 2 degrees [rad]
    timestep: float = 0.25  # of its value


@dataclass(frozen=True)
class Fingertip:
    """Bare fingertips: spheres with servos of their own, and contact with them and with planes.

    Planes are soft while the object slides on them: a stiff contact that slides chatters, so that
    the floor's force vanishes a quarter of the time, which no pose shows. What sticks is stiff: a
    soft contact creeps under a steady force along it, 0.2 mm/s for 3 N on a light object.
    """

    timestep: float = 0.001  # [s]
    slide_solref: tuple[float, float] = (0.005, 1.0)
    slide_solimp: tuple[float, ...] = (0.5, 0.95, 0.0005, 0.5, 2.0)
    stick_solref: tuple[float, float] = (0.002, 1.0)
    stick_solimp: tuple[float, ...] = (0.99, 0.999, 0.001, 0.5, 2.0)
    mass: float = 0.1  # of a fingertip, and of what moves with it [kg]
    stiffness: float = 1e4  # of position control [N/m]; 1e5 breaks on 0.1 mm of geometry error
    damping_ratio: float = 1.0
    turning: float = 10.0  # stiffness against rolling, in that of position control at the contact
    approach: float = 0.002  # from where a finger comes to the surface [m]
    load_seconds: float = 0.3  # to touch, and from one set of forces to the next [s]
    rest_seconds: float = 0.2  # at the end [s]
    tolerance: float = 0.001  # of a corner's place, nominal [m]
    varied_tolerance: float = 0.0015  # and where the trial varies [m]


@dataclass(frozen=True)
class Break:
    """The test of a row of a fingertip plan: a wrench comes while the object moves past."""

    distance: float = 0.001  # of a corner, from where it is without the wrench: broken [m]
    speed: float = 0.004  # of the fastest corner; faster, sliding contacts lose strength [m/s]
    load_seconds: float = 0.15  # the object is held fast while the fingers come to their forces [s]
    still: float = 0.25  # when it begins to move [s]
    begin: float = 0.4  # when the wrench begins to come [s]
    rise_seconds: float = 0.05  # until it is whole [s]
    until: float = 0.75  # when the test ends [s]
    every: int = 5  # steps between looks
    sampling: float = 0.01  # of poses [s]
    largest: float = 3.0  # of z: no greater wrench is tried
    precision: float = 0.02  # of the smallest wrench
