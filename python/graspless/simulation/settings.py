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
class Slide:
    """A thin object between a table, a pressing finger and a closing hand."""

    impratio: float = 1000.0  # at 100 a finger that carries an object sideways creeps round by
    # up to 7 degrees in 8 s, at 1000 by less than one, as at 10000: Coulomb's law has no creep
    table_friction: float = 0.3  # plastic on wood or laminate: handbooks have 0.2 to 0.4
    tip_friction: float = 1.16  # the T42's urethane pads (notes of the house)
    table_solref: float = 0.02  # time constant of a foot's contact [s]
    table_solimp: tuple[float, float, float] = (0.95, 0.99, 0.001)  # a hard table: 10 N on one
    # foot push it in by less than half a millimetre
    table_slip: float = 0.1  # time constant of sliding friction [s]. MuJoCo's cone is relaxed: what
    # slides hovers by friction x speed x the ratio of both; at 0.02 s feet lose the table, and
    # come down with kicks of 0.1 m/s
    tip_solref: float = 0.01  # of a point of the pad [s]; softer tunnels through a thin plate
    feet: int = 60  # points on which the object stands, evenly spread: torsion of a uniform pressure
    foot_radius: float = 0.001  # [m]
    rim_rise: float = 0.0001  # how far the outline's own feet are above the others [m]
    rim_spacing: float = 0.01  # of points along outline and edge [m]
    flexure_stiffness: float = 4.6  # of a finger's flexure [Nm/rad]: 9 N at 15 mm depth
    flexure_damping_ratio: float = 0.7  # of the finger on its flexure
    pad_width: float = 0.032  # of the line contact [m]: the T42's pad
    pad_points: int = 5  # of the line contact: the torsion of a line evenly pressed
    pad_softness: float = 0.008  # half length of the patch on which a closed pad lies [m]: what
    # moment a soft pad withstands is the force times this
    squeeze: float = 0.2  # how far the hand is told to close beyond contact [rad or m]: its
    # flexures push with 6 N then
    squeeze_seconds: float = 0.8  # from the first touch to the lift [s]
    pause: float = 0.3  # after pressing and after sliding, until servos and object rest [s]
    lift_height: float = 0.1  # what the issue asks for [m]
    lift_seconds: float = 2.0
    hold_seconds: float = 1.0  # what the issue asks for
    off_target: tuple[float, float] = (0.005, 0.0873)  # nominal: 5 mm, 5 degrees [m, rad]
    off_target_varied: tuple[float, float] = (0.010, 0.1745)  # varied: 10 mm, 10 degrees
    tipped: float = 0.175  # an object that tilts by 10 degrees is about to fall [rad]
    fell: float = 0.02  # below where it lay [m]
    lost_seconds: float = 0.1  # without contact while it slides
    kept: float = 0.02  # how far an object that is held may creep in the hand [m]
