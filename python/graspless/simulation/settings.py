# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Parameters of the physics engine and of its judges, each with its source.

"A choice" marks a value without a source. Rates of checks, recordings and samples are in the files
that use them.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal


@dataclass(frozen=True)
class Solver:
    """Solver parameters. The defaults of MuJoCo are wrong for slow contact with friction."""

    timestep: float = 0.002  # MuJoCo's default [s]
    cone: Literal["elliptic", "pyramidal"] = "elliptic"  # Coulomb's cone; a pyramid slips sooner
    # along its diagonals
    impratio: float = 100.0  # under a steady push, 1 creeps by 4 mm/s and 100 by 0.001 mm/s
    integrator: Literal["euler", "implicit", "implicitfast"] = "implicitfast"  # for stiff servos
    tolerance: float = 1e-10
    iterations: int = 100


@dataclass(frozen=True)
class Servo:
    """Position control of the joints of arms and hands."""

    # Deflection at the joint's largest effort, as of an industrial arm [rad; m/10].
    sag: float = 0.01
    bandwidth: float = 100.0  # sqrt(stiffness / inertia), which sets the rotor's inertia [rad/s]
    damping_ratio: float = 1.0
    effort: float = 50.0  # largest effort of a joint whose URDF has none [Nm or N]
    mimic_solimp: tuple[float, float] = (0.99, 0.999)  # impedance of the constraint between a mimic
    # joint and its joint: a choice, stiffer than MuJoCo's 0.9 and 0.95

    @property
    def lag(self) -> float:
        """Delay behind a steady motion without velocity feed-forward [s]."""
        return 2 * self.damping_ratio / self.bandwidth


@dataclass(frozen=True)
class Spread:
    """Half widths of the variations of trials."""

    friction: float = 0.3  # fraction; drawn separately for the robot's contacts and the support
    mass: float = 0.2  # fraction
    position: float = 0.003  # of the object [m]
    angle: float = 0.0349  # of the object, 2 degrees [rad]
    timestep: float = 0.25  # fraction
    thickness: float = 0.0  # of the object, fraction
    table: float = 0.0  # height of the support [m]
    com: float = 0.0  # position of the centre of mass [m]
    flexure: float = 0.0  # fraction; drawn separately for length and stiffness


# For slides: shape and place of object and support as they are known, and a hand as it is made.
SLIDE_SPREAD = Spread(thickness=0.2, table=0.003, com=0.005, flexure=0.2)
# For fingertip plans: 10 % of friction, and 0.1 mm of the positions of the fingers.
FINGERTIP_SPREAD = Spread(friction=0.1, mass=0.0, position=1e-4, angle=0.0)


@dataclass(frozen=True)
class Fingertip:
    """Bare fingertips: spheres with their own servos, and their contacts with object and planes.

    Planes are soft under a sliding object. On a stiff plane it chatters: the floor's force vanishes
    a quarter of the time, although no pose shows it. Sticking contacts are stiff. A soft contact
    creeps under a steady tangential force, by 0.2 mm/s for 3 N on a light object.
    """

    timestep: float = 0.001  # [s]
    slide_solref: tuple[float, float] = (0.005, 1.0)
    slide_solimp: tuple[float, ...] = (0.5, 0.95, 0.0005, 0.5, 2.0)
    stick_solref: tuple[float, float] = (0.002, 1.0)
    stick_solimp: tuple[float, ...] = (0.99, 0.999, 0.001, 0.5, 2.0)
    mass: float = 0.1  # of a fingertip and all that moves with it [kg]
    stiffness: float = 1e4  # of position control [N/m]; 1e5 fails at 0.1 mm of geometry error
    damping_ratio: float = 1.0
    obstacle_skin: float = 0.0005  # half thickness of an obstacle's mesh [m]: a choice
    skin: float = 0.2  # thickness of the surface of an object that is not convex [radii of a
    # fingertip]: a choice, small compared with a notch that a fingertip enters
    turning: float = 100.0  # stiffness against rolling, relative to position control at the
    # contact: what touches is then as stiff along the surface as the servo, but for 1 %
    speed: float = 0.005  # of a sliding object [m/s]; MuJoCo lifts faster ones off the floor
    arm_speed: float = 0.01  # of an object that an arm slides [m/s]
    approach: float = 0.002  # distance from which a finger comes to the surface [m]
    # For touching, and for a change from one set of forces to another [s].
    load_seconds: float = 0.3
    rest_seconds: float = 0.2  # at the end [s]
    tolerance: float = 0.001  # of a corner's position in the nominal trial [m]
    varied_tolerance: float = 0.0015  # of a corner's position in varied trials [m]
    lost: float = 0.01  # error of a corner beyond which the fingers have lost it [m]: a choice
    slipped: float = 0.001  # tolerance of a fingertip's place on the object [m]: as of a corner
    chatter: float = 0.05  # tolerated fraction of time without force from the floor: a choice; on a
    # stiff floor it is a quarter of the time


@dataclass(frozen=True)
class Break:
    """Test of a row of a fingertip plan: a wrench rises while the object moves past the row."""

    distance: float = 0.001  # of a corner from its undisturbed position that counts as broken [m]
    lost_distance: float = 0.005  # the same, if the contacts gave way and did not just bend [m]
    speed: float = 0.004  # of the fastest corner [m/s]; faster sliding weakens the contacts
    load_seconds: float = 0.15  # the object is held while the fingers build up their forces [s]
    still: float = 0.25  # time at which the object is let go altogether and begins to move [s]
    carry_rate: float = 300.0  # of the spring that carries it before [rad/s]: stiff, but stable
    zero: tuple[float, ...] = (0.3, 0.34)  # times at which the fingers' places are zeroed [s]: what
    # slides on MuJoCo's floor is lifted by some 0.05 mm, which takes 0.5 N from a stiff finger
    begin: float = 0.4  # time at which the wrench begins to rise [s]
    rise_seconds: float = 0.1  # duration of the rise, a half cosine [s]: what is on the fingers
    # oscillates within 10 to 50 ms, and a ramp of 50 ms made it overshoot by a tenth
    until: float = 0.75  # time at which the test ends [s]
    rest_window: float = 0.1  # the last two such parts tell whether the object comes to rest [s]
    goes_on: float = 1.0  # for which a test goes on if the object has not come to rest [s]: a
    # choice. An excess of 0.1 N moves two damped fingertips by 1 mm in this time
    every: int = 5  # steps between two observations
    sampling: float = 0.01  # interval between sampled poses [s]
    largest: float = 3.0  # largest wrench that is tried, relative to z
    precision: float = 0.02  # of the smallest wrench, relative


@dataclass(frozen=True)
class Clasp:
    """An object in a closed hand: its model, the closing of the hand, and the pulls."""

    mass: float = 1.0  # of an object whose task gives none, as of a bag [kg]
    friction: float = 0.6  # of hand on object; rubber on plastics or leather has 0.5 to 0.8
    stand_friction: float = 0.5  # of object on floor
    spin_friction: float = 0.005  # about the normal [m]: MuJoCo's default, like the next; contacts
    roll_friction: float = 0.0001  # of three dimensions have neither [m]
    skin: float = 0.0005  # half thickness of the surface [m]: small compared with a cloud's spacing
    obstacle_skin: float = 0.0005  # half thickness of an obstacle's mesh [m]
    stiffness_time: float = 0.01  # solref of the surface [s]: half MuJoCo's default, 5 time steps
    foot_depth: float = 0.01  # points up to this height above the lowest one are feet [m]
    foot_radius: float = 0.002  # a choice: close to a point [m]
    lead: float = 0.3  # time for the object to come to rest before the arm moves [s]
    hit: float = 0.005  # motion of the object before the hand closes that counts as a knock [m]
    grip_effort: float = 0.5  # fraction of a joint's largest effort at which it stops closing
    grip_rate: float = 0.5  # [rad/s; m/s / 10]: a sixth of the SDH's largest
    grip_seconds: float = 3.0  # longest time of closing [s]
    left: float = 0.05  # that a joint may still close after the last row before it touches: a row
    # of the plan [rad; m / 10]
    left_most: float = 0.2  # to which that is measured [rad; m / 10]
    grip_still: int = 10  # observations without motion after which the hand is closed; a choice
    locked_armature: float = 1e4  # of a joint that is locked [kg m^2; kg]: a wrench moves it by
    # less than a micrometre. A choice
    locked_timing: float = 0.25  # time step and stiffness_time of a hand that is tested locked,
    # relative to others: its surfaces yield by less than 1 mm, but in the hardest blows by 1.5 mm
    force: float = 15.0  # of a random wrench [N]; from the feasibility study, as the next four
    torque: float = 1.0  # of a random wrench, about the centre of mass [Nm]
    hold: float = 0.1  # time after which a new wrench is drawn [s]
    seconds: float = 3.0  # of a sequence [s]
    sequences: int = 10  # as in the paper's own test
    # At which drag balances a random force; a mass of 1 kg reaches it within one hold [m/s]: a
    # choice, as the next. Drag acts at the object's origin: a centre of mass 9 cm away can swing at
    # 0.65 m/s, and one 20 cm away at 1 m/s.
    drag_speed: float = 0.5
    drag_turning: float = 3.0  # at which drag balances a random torque [rad/s]
    pull_rate: float = 40.0  # largest growth of the straight pull [N/s]: quasi-static against 100
    # rad/s. Light objects are pulled more slowly, see Execution.pull
    pull_needed: float = 15.0  # as the force of a random wrench [N]
    pull_most: float = 60.0  # at which the pull ends [N]: three fingers of 2 Nm at 0.1 m
    open_seconds: float = 1.0  # for opening the hand in the negative control [s]


@dataclass(frozen=True)
class Slide:
    """A thin object between a table, a pressing finger and a closing hand."""

    impratio: float = 1000.0  # at 100, a finger that carries an object sideways creeps around it by
    # up to 7 degrees in 8 s; at 1000 and 10000 by less than one. Coulomb's law has no creep
    table_solref: float = 0.02  # time constant of a foot's contact [s]
    table_solimp: tuple[float, float, float] = (0.9, 0.95, 0.001)  # MuJoCo's default
    table_slip: float = 0.1  # time constant of sliding friction [s]. MuJoCo relaxes the cone, so a
    # sliding body hovers by friction x speed x the ratio of both time constants; at 0.02 s feet
    # leave the table and come down at 0.1 m/s
    tip_solref: float = 0.01  # of a point of the pad [s]; softer points pass through a thin plate
    feet: int = 60  # number of points on which the object stands, evenly spread like its pressure
    foot_radius: float = 0.001  # [m]
    rim_rise: float = 0.0001  # height of the outline's feet above the others [m]
    rim_spacing: float = 0.01  # of points along outline and edge [m]
    link_mass: float = 1e-3  # left to a link whose finger turns on a flexure [kg]; a choice:
    link_inertia: float = 1e-6  # almost none, but MuJoCo requires some [kg m^2]
    flexure_damping_ratio: float = 0.7  # of the finger on its flexure
    wrist_damping_ratio: float = 1.0  # of an arm under impedance control; a choice
    wrist_mass: float = 1.5  # that its damping is meant for: a hand and a last link [kg]; a choice
    guarded_stiffness: float = 2000.0  # of an arm that holds a force, across it [N/m]; a choice
    grip_solimp: tuple[float, float, float] = (0.9, 0.998, 0.002)  # of fingers that close: as soft
    # as MuJoCo's default up to 1 mm, and hard at 2 mm. With the default, a Robotiq's 250 N pressed
    # each pad 4 mm into a spoon, and its contacts turned from the faces between the pads to the top
    pad_points: int = 5  # of the line contact, for the torsion of an even pressure along it
    pad_softness: float = 0.008  # half length of the contact patch of a closed pad [m]: the moment
    # that a soft pad withstands is its force times this
    squeeze: float = 0.2  # commanded closing beyond contact [rad; of prismatic joints 1/10 m], a
    # choice: the flexures of the T42 then press with 8 N per finger
    squeeze_seconds: float = 0.8  # from the first touch to the lift [s]
    pause: float = 0.3  # for servos and object to come to rest after pressing and after sliding [s]
    lift_height: float = 0.1  # a choice: enough to see whether the grasp holds [m]
    lift_seconds: float = 2.0  # [s]
    hold_seconds: float = 1.0  # a choice [s]
    off_target: tuple[float, float] = (0.005, 0.0873)  # nominal: 5 mm, 5 degrees [m, rad]
    off_target_varied: tuple[float, float] = (0.010, 0.1745)  # varied: 10 mm, 10 degrees [m, rad]
    placed: tuple[float, float] = (0.015, 0.175)  # of an object that was put down: 15 mm and 10
    # degrees, a choice: hands that open unevenly push it by some millimetres [m, rad]
    tipped: float = 0.175  # tilt of an object that is about to fall, 10 degrees [rad]
    fell: float = 0.02  # drop of the object that counts as a fall [m]
    lost_seconds: float = 0.1  # without contact while it slides [s]
    knocked: tuple[float, float] = (0.02, 0.35)  # by so much a body beside the object may move, or
    # tilt: a choice [m, rad]
    kept_height: float = 0.09  # required height; hands and arms yield a little [m]
    kept: float = 0.02  # tolerated motion of a held object in the hand [m]
