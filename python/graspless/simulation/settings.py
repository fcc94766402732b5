# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of the physics engine and of its judges, with where each comes from.

"A choice" has no source. Rates of checks, recordings and samples are in the files that use them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Solver:
    """Solver parameters; the defaults of MuJoCo are wrong for slow contact with friction."""

    timestep: float = 0.002  # MuJoCo's own [s]
    cone: Literal["elliptic", "pyramidal"] = "elliptic"  # Coulomb's; a pyramid slips sooner along
    # its diagonals
    impratio: float = 100.0  # 1 creeps by 4 mm/s under a steady push, 100 by 0.001
    integrator: Literal["euler", "implicit", "implicitfast"] = "implicitfast"  # stiff servos
    tolerance: float = 1e-10
    iterations: int = 100


@dataclass(frozen=True)
class Servo:
    """Position control of an arm's and a hand's joints."""

    sag: float = 0.01  # deflection at the joint's greatest effort [rad or m]: an industrial arm's
    bandwidth: float = 100.0  # sqrt(stiffness / inertia) [rad/s]: sets the rotor's inertia
    damping_ratio: float = 1.0
    effort: float = 50.0  # of a joint whose URDF has none [Nm or N]
    mimic_solimp: tuple[float, float] = (0.99, 0.999)  # impedance of the constraint between a joint
    # and the one that it follows: a choice, stiffer than MuJoCo's 0.9 and 0.95

    @property
    def lag(self) -> float:
        """Delay behind a steady motion without velocity feed-forward [s]."""
        return 2 * self.damping_ratio / self.bandwidth


@dataclass(frozen=True)
class Spread:
    """Half widths of the variations of trials."""

    friction: float = 0.3  # of its value; what the robot touches and what supports, each its own
    mass: float = 0.2  # of its value
    position: float = 0.003  # of the object [m]
    angle: float = 0.0349  # of the object, 2 degrees [rad]
    timestep: float = 0.25  # of its value


# For fingertip plans: friction by 10 %, the positions of the fingers by 0.1 mm, no mass.
FINGERTIP_SPREAD = Spread(friction=0.1, mass=0.0, position=1e-4, angle=0.0)


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
    obstacle_skin: float = 0.0005  # half thickness of an obstacle's mesh [m]: a choice
    skin: float = 0.2  # thickness of the surface of an object that is not convex, in fingertips'
    # radii: a choice, little against a notch that a fingertip goes into
    turning: float = 10.0  # stiffness against rolling, in that of position control at the contact
    speed: float = 0.005  # of an object that slides; faster, MuJoCo lifts it off the floor [m/s]
    arm_speed: float = 0.01  # the same, carried by an arm [m/s]
    approach: float = 0.002  # from where a finger comes to the surface [m]
    load_seconds: float = 0.3  # to touch, and from one set of forces to the next [s]
    rest_seconds: float = 0.2  # at the end [s]
    tolerance: float = 0.001  # of a corner's place, nominal [m]
    varied_tolerance: float = 0.0015  # and where the trial varies [m]
    lost: float = 0.01  # a corner so far from its place is no longer in the fingers [m]: a choice
    slipped: float = 0.001  # of a fingertip on the object [m]: as a corner may be off
    chatter: float = 0.05  # share of the time without any force of the floor: a choice; a stiff
    # floor is lost a quarter of the time


@dataclass(frozen=True)
class Break:
    """The test of a row of a fingertip plan: a wrench comes while the object moves past."""

    distance: float = 0.001  # of a corner, from where it is without the wrench: broken [m]
    lost_distance: float = 0.005  # the same: not only bent [m]
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


@dataclass(frozen=True)
class Clasp:
    """An object that hangs in a hand: how it is made, closed around and pulled at."""

    mass: float = 1.0  # of an object whose task says none, a bag's [kg]
    friction: float = 0.6  # hand on object: rubber pads on plastics or leather, 0.5 to 0.8
    stand_friction: float = 0.5  # object on floor
    spin_friction: float = 0.005  # about the normal [m]: MuJoCo's own, as the next; a contact of
    roll_friction: float = 0.0001  # three dimensions has neither [m]
    skin: float = 0.0005  # half thickness of the surface [m]: little against a cloud's spacing
    obstacle_skin: float = 0.0005  # the same of an obstacle's mesh
    stiffness_time: float = 0.01  # solref of the surface [s]: half MuJoCo's, 5 time steps
    foot_depth: float = 0.01  # what is lower than this above the lowest point is a foot [m]
    foot_radius: float = 0.002  # a choice: near a point [m]
    lead: float = 0.3  # the object comes to rest before the arm moves [s]
    hit: float = 0.005  # what moves an object farther before the hand closes knocked it [m]
    grip_effort: float = 0.5  # of a joint's greatest: where it stops closing
    grip_rate: float = 0.5  # [rad/s]: a sixth of the SDH's greatest
    grip_seconds: float = 3.0  # at most
    grip_still: int = 10  # looks without a motion of the hand: it has closed; a choice
    locked_torque: float = 1e3  # of motors that nothing turns, in their own; a choice, as the next
    locked_stiffness: float = 10.0  # in their own
    force: float = 15.0  # of a random wrench [N]; notes of the feasibility study, as the next four
    torque: float = 1.0  # about the centre of mass [Nm]
    hold: float = 0.1  # until the wrench is drawn anew [s]
    seconds: float = 3.0  # a sequence
    sequences: int = 10  # as the paper's own test
    drag_speed: float = 0.5  # at which drag alone bears a random force: a kilogram comes to it
    # within a hold [m/s]; a choice, as the next. Drag acts at the origin of the object: 9 cm
    # from the centre of mass lets that swing at 0.65 m/s, 20 cm at 1 m/s
    drag_turning: float = 3.0  # the same of a random torque [rad/s]
    pull_rate: float = 40.0  # growth of a straight pull [N/s]: quasi-static against 100 rad/s
    pull_needed: float = 15.0  # as a random one's [N]
    pull_most: float = 60.0  # where a straight pull ends [N]: three fingers of 2 Nm at 0.1 m
    open_seconds: float = 1.0  # of the negative control's hand, to open


@dataclass(frozen=True)
class Slide:
    """A thin object between a table, a pressing finger and a closing hand."""

    impratio: float = 1000.0  # at 100 a finger that carries an object sideways creeps round by
    # up to 7 degrees in 8 s, at 1000 by less than one, as at 10000: Coulomb's law has no creep
    table_solref: float = 0.02  # time constant of a foot's contact [s]
    table_solimp: tuple[float, float, float] = (0.9, 0.95, 0.001)  # MuJoCo's own
    table_slip: float = 0.1  # time constant of sliding friction [s]. MuJoCo's cone is relaxed: what
    # slides hovers by friction x speed x the ratio of both; at 0.02 s feet lose the table, and
    # come down with kicks of 0.1 m/s
    tip_solref: float = 0.01  # of a point of the pad [s]; softer tunnels through a thin plate
    feet: int = 60  # on which the object stands, evenly spread: the torsion of an even pressure
    foot_radius: float = 0.001  # [m]
    rim_rise: float = 0.0001  # how far the outline's own feet are above the others [m]
    rim_spacing: float = 0.01  # of points along outline and edge [m]
    link_mass: float = 1e-3  # left to a link whose finger turns on a flexure [kg]; a choice:
    link_inertia: float = 1e-6  # next to none, but MuJoCo asks for some [kg m^2]
    flexure_damping_ratio: float = 0.7  # of the finger on its flexure
    pad_points: int = 5  # of the line contact: the torsion of a line evenly pressed
    pad_softness: float = 0.008  # half length of the patch on which a closed pad lies [m]: what
    # moment a soft pad withstands is the force times this
    squeeze: float = 0.2  # how far the hand is told to close beyond contact [rad or m]: its
    # flexures push with 8 N a finger then
    squeeze_seconds: float = 0.8  # from the first touch to the lift [s]
    pause: float = 0.3  # after pressing and after sliding, until servos and object rest [s]
    lift_height: float = 0.1  # a choice: enough to see whether the grasp holds [m]
    lift_seconds: float = 2.0
    hold_seconds: float = 1.0  # a choice
    off_target: tuple[float, float] = (0.005, 0.0873)  # nominal: 5 mm, 5 degrees [m, rad]
    off_target_varied: tuple[float, float] = (0.010, 0.1745)  # varied: 10 mm, 10 degrees
    tipped: float = 0.175  # an object that tilts by 10 degrees is about to fall [rad]
    fell: float = 0.02  # below where it lay [m]
    lost_seconds: float = 0.1  # without contact while it slides
    kept_height: float = 0.09  # of what is asked; hands and arms give way a little [m]
    kept: float = 0.02  # how far an object that is held may creep in the hand [m]
