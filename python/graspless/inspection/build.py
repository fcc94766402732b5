# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The steps from a URDF to a proposal."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

from .. import scene
from .._core import robot as robots
from .._core import slide
from .arm import find_arm, find_home, often_touching
from .curves import fist_fields, jaw_fields
from .files import free_name, group_names, make_srdf, with_frames
from .fist import find_fist
from .grip import describe_fist, describe_grip
from .jaws import Jaws, find_jaws
from .linkage import without_linkage
from .pairs import find_pairs, touching
from .palm import Palm, find_palm
from .proposal import Finding, Proposal
from .tips import (
    CLEARANCE,
    LARGEST_PAD,
    LARGEST_RADIUS,
    PITCHES,
    SMALLEST,
    find_pitch,
    find_tips,
    grasp_pose,
)
from .tree import Tree

if TYPE_CHECKING:
    from .._core.robot import Robot
    from ..frames import Matrix
    from .pairs import Pair
    from .tips import Tip

# Of the models of a rigid finger, the one that presses least.
MODEL = "rigid_guarded"  # of the fingers: how they yield is not in a URDF
DEFAULTS = {field: getattr(slide.Hand(), field) for field in ("pad_friction", "press_force")}
SAME = 1e-5  # frames are one if their poses differ by less [m]
THIN = 0.003  # a hand whose fingers stay farther apart than this holds no thin object [m]


def propose(robot: Robot, link: str | None, name: str) -> Proposal:
    """Returns the proposal for a robot. `link` is one of the palm, or None."""
    tree = Tree(robot)
    palm = without_linkage(tree, find_palm(tree, link))
    return _Builder(tree, palm, name).build()


class _Builder:
    def __init__(self, tree: Tree, palm: Palm, name: str) -> None:
        self.tree, self.palm, self.name = tree, palm, name
        self.robot = tree.robot
        self.arm = find_arm(tree, palm.body)
        self.findings: list[Finding] = []
        self.placed: dict[str, tuple[str, Matrix]] = {}
        self.hand: dict[str, Any] = {}
        self.grasp = self.palm_link()
        self.clasp: dict[str, Any] = {}
        self.drivers: tuple[str, ...] = ()
        self.open = self.closed = np.zeros(0)
        self.gaps = (0.0, 0.0)
        self.groups = {"arm": self._group("arm", self.arm.joints)}
        self.states: dict[str, str] = {}

    def _group(self, wanted: str, joints: tuple[str, ...]) -> str:
        """Returns the SRDF's group of that name if it has these joints, else a new name."""
        robot = self.robot
        columns = sorted(robot.joint(name) for name in joints)
        if wanted in robot.group_names and sorted(robot.group(wanted)) == columns:
            return wanted
        return free_name(wanted, group_names(robot.srdf))

    def _state_names(self) -> dict[str, str]:
        """Names of the hand's states; faulty ones and those that move another hand are taken."""
        tree = self.tree
        below = {
            joint.name for link in tree.links_below(self.palm.body) if (joint := tree.joint(link))
        }
        own = below.union(self.drivers, self.arm.joints)
        faulty = tree.states.keys() - set(self.robot.state_names)
        taken = faulty.union(name for name, joints in tree.states.items() if joints - own)
        return {state: free_name(state, taken) for state in ("open", "closed")}

    def palm_link(self) -> str:
        return self.tree.links[self.palm.link(self.tree)]

    def build(self) -> Proposal:
        self._describe_arm()
        if len(self.palm.fingers) == 2:
            self._propose_jaws()
        else:
            self._propose_fist()
        self.groups["hand"] = self._group("hand", self.drivers)
        self.states = self._state_names()
        found = ((self.groups["arm"], self.arm.joints), (self.groups["hand"], self.drivers))
        groups = {group: joints for group, joints in found if joints}
        if self.hand:
            self.hand = {"arm": self.groups["arm"], **self.states, **self.hand}
        self.clasp = {**self.groups, **self.states, **self.clasp}
        pairs = self._pairs()
        states = [*self._hand_states(), *self._home(pairs)]
        added = {name: at for name, at in self.placed.items() if name not in self.tree.links}
        urdf = with_frames(self.robot.urdf, added)
        srdf = make_srdf(self.name, groups, states, pairs, self.robot.srdf)
        return Proposal(
            self.name,
            self._read(urdf, srdf),
            self.findings,
            urdf,
            srdf,
            hand=self.hand if self.arm.joints else {},
            clasp=self.clasp if self.arm.joints else {},
            hand_links=tuple(self.tree.links[i] for i in self.tree.links_below(self.palm.body)),
            largest_gap=self.gaps[0],
            smallest_gap=self.gaps[1],
        )

    def _propose_jaws(self) -> None:
        jaws = find_jaws(self.tree, self.palm, self.palm.ordered(self.tree))
        self.drivers, self.open, self.closed = jaws.drivers, jaws.open, jaws.closed
        self.gaps = jaws.opening, jaws.smallest
        self._describe_hand(jaws)

    def _propose_fist(self) -> None:
        tree, fist = self.tree, find_fist(self.tree, self.palm)
        self.drivers, self.open, self.closed = fist.drivers, fist.open, fist.closed
        palm, fingers = self.palm_link(), self.palm.fingers
        self.grasp = self._place("grasp", palm, fist.X_WH)
        self.clasp = fist_fields(tree, palm, fingers, fist)
        thumb = tree.links[fingers[fist.thumb].bodies[0]]
        self.find("thumb", thumb, "the finger that the others close against", fist.is_sure)
        self.find("fingers", ", ".join(self.clasp["fingers"]), "a curve through the joints of each")
        for state, q in (("open", fist.open), ("closed", fist.closed)):
            why = f"joints that bend the fingers are near their {state} limits"
            self.find(f"state {state}", self._shown(q), why)
        self.find("grip force", *describe_fist(tree, fist))
        for field, why in (
            ("forward", "from the joints at the palm to the tips of the half closed hand"),
            ("sideways", "along most axes of the fingers' joints"),
        ):
            self.find(field, ", ".join(f"{v:.2f}" for v in self.clasp[field]), why)

    def _read(self, urdf: str, srdf: str) -> Robot:
        given = self.robot
        return robots.Robot.from_urdf(
            urdf, srdf=srdf, packages=given.packages, directory=given.directory, X_WB=given.X_WB
        )

    def find(self, field: str, value: str, reason: str, is_sure: bool = True) -> None:
        self.findings.append(Finding(field, value, reason, is_sure))

    def _describe_arm(self) -> None:
        arm, palm = self.arm, self.palm
        if arm.joints:
            self.find(f"group {self.groups['arm']}", ", ".join(arm.joints), arm.reason, arm.is_sure)
        else:
            why = "no joint carries the hand: join it to an arm before you plan"
            self.find("group arm", "none", why, False)
        self.find("palm", self.palm_link(), palm.reason, palm.is_sure)

    def _describe_hand(self, jaws: Jaws) -> None:
        tips = find_tips(self.tree, jaws)
        pitch, room, touch = find_pitch(
            self.tree, jaws, tips[0], self.tree.links_below(self.palm.body)
        )
        tips[0].X_WF[:3, 3] += tips[0].X_WF[:3, :3] @ touch
        self._place_frames(jaws, tips)
        self._describe_states(jaws)
        self.clasp = jaw_fields(self.tree, self.palm_link(), jaws, tips)
        curve = " against ".join([*self.clasp["fingers"], self.clasp["thumb"][-1]["link"]])
        self.find("clasp", curve, "a curve along both fingers, which close on a bar")
        links = self.tree.links
        own, other = ([links[link] for link in tip.links] for tip in tips)
        self.hand |= {
            "sliding_finger": own,
            "fingers": own + other,
            "finger_model": MODEL,
            **self._pitch(pitch, room),
            "tip_radius": round(tips[0].radius, 4),
            "pad_width": round(tips[0].width, 4),
            **DEFAULTS,
        }
        self.find("sliding_finger", ", ".join(own), "links near the end of the finger that slides")
        self.find("fingers", ", ".join(own + other), "links near the ends of both fingers")
        why = "a rigid finger; how much finger and arm give way is not in a URDF"
        self.find("finger_model", MODEL, why, False)
        for field, size, most, why in (
            (
                "tip_radius",
                tips[0].radius,
                LARGEST_RADIUS,
                "half the thickness of the finger's end",
            ),
            ("pad_width", tips[0].width, LARGEST_PAD, "width of the last 10 mm of the finger"),
        ):
            is_sure = SMALLEST < size < most
            limits = "" if is_sure else f", limited to {_mm(SMALLEST)} and {_mm(most)}"
            self.find(field, _mm(size), why + limits, is_sure)
        self.find("grip force", *describe_grip(self.tree, jaws))
        for field, value in DEFAULTS.items():
            self.find(field, f"{value:g}", "the default of slides; it is not in a URDF", False)

    def _pitch(self, pitch: float, room: float) -> dict[str, float]:
        """Field of the hand, unless the default pitch is right."""
        if pitch == PITCHES[0]:
            return {}
        why = f"flattest pitch of the finger at which the rest of the hand is {_mm(room)} above"
        if room <= CLEARANCE:
            why = f"at no pitch of the finger is the rest of the hand {_mm(CLEARANCE)} above"
        self.find("pitch", f"{pitch:.3f} rad", f"{why} the surface", room > CLEARANCE)
        return {"pitch": round(pitch, 4)}

    def _place(self, name: str, parent: str, X_WA: Matrix) -> str:
        """Attaches a frame to a link and returns its name; one that is there already is taken."""
        tree = self.tree
        X_PA = np.linalg.inv(self.robot.pose(parent, self.open)) @ X_WA
        is_there = name in tree.links and (
            tree.body(tree.links.index(name)) == tree.body(tree.links.index(parent))
            and np.allclose(self.robot.pose(name, self.open), X_WA, atol=SAME)
        )
        found = name if is_there else free_name(name, tree.links)
        self.placed[found] = (parent, X_PA)
        return found

    def _place_frames(self, jaws: Jaws, tips: tuple[Tip, Tip]) -> None:
        own = self.tree.links[tips[0].link]
        fingertip = self._place(f"{own}_fingertip", own, tips[0].X_WF)
        self.grasp = self._place("grasp", self.palm_link(), grasp_pose(self.tree, jaws, tips))
        self.hand |= {"fingertip": fingertip, "grasp_frame": self.grasp}
        for field, name, why in (
            ("fingertip", fingertip, "outer edge of the finger's end, Z out of it, Y to the other"),
            (
                "grasp_frame",
                self.grasp,
                "between the tips where they meet, Z from the palm to them",
            ),
        ):
            parent, X_PA = self.placed[name]
            at = ", ".join(f"{1000 * value:.1f}" for value in X_PA[:3, 3])
            self.find(field, f"{name} in {parent} at ({at}) mm", why, jaws.is_aligned)

    def _describe_states(self, jaws: Jaws) -> None:
        for field, q, gap, why in (
            ("open", jaws.open, jaws.opening, "the tips are farthest apart"),
            ("closed", jaws.closed, jaws.smallest, "just before the fingers touch"),
        ):
            if self.tree.state(field, jaws.drivers) is not None:
                why = "a state of the SRDF"
            elif field == "closed" and not jaws.touches:
                why = "the joints are at their limits"
            can_hold = field == "open" or gap < THIN
            if not can_hold:
                why += f"; an object thinner than {_mm(gap)} cannot be held"
            self.find(f"state {field}", f"{self._shown(q)} (gap {_mm(gap)})", why, can_hold)

    def _shown(self, q: Matrix) -> str:
        """Joints of the hand with their values."""
        return ", ".join(f"{name} {q[self.robot.joint(name)]:.4g}" for name in self.drivers)

    def _hand_states(self) -> list[tuple[str, str, dict[str, float]]]:
        return [
            (state, self.groups["hand"], {n: float(q[self.robot.joint(n)]) for n in self.drivers})
            for state, q in (
                (self.states["open"], self.open),
                (self.states["closed"], self.closed),
                ("home", self.open),
            )
        ]

    def _home(self, pairs: dict[Pair, str]) -> list[tuple[str, str, dict[str, float]]]:
        """Home of the arm. Adds pairs that touch in most configurations if there is none else."""
        if not self.arm.joints:
            return []
        if self.tree.state("home", self.arm.joints) is not None:
            q = np.asarray(self.robot.state("home", self.open))
            hits = touching(scene.Scene(self.robot), set(self.tree.links), q)
            for a, b in sorted(pair for pair in hits if pair not in pairs)[:1]:
                self.find("state home", "that of the SRDF", f"{a} and {b} touch there", False)
            return []
        if "home" in self.tree.states and "home" not in self.robot.state_names:
            self.find("state home", "none", "that of the SRDF is faulty", False)
            return []
        placed = self.placed[self.grasp]
        home = find_home(self.tree, self.arm, placed, pairs, self.open)
        if home is None and (often := often_touching(self.tree, self.arm, pairs, self.open)):
            pairs |= dict.fromkeys(often, "Default")
            shown = ", ".join(f"{a} and {b}" for a, b in often)
            why = "they touch in most configurations, so their shapes seem to overlap"
            self.find("disable_collisions", shown, why, False)
            home = find_home(self.tree, self.arm, placed, pairs, self.open)
        if home is None:
            self.find("state home", "none", "no free configuration was found", False)
            return []
        values = {name: float(home.q[self.robot.joint(name)]) for name in self.arm.joints}
        shown = ", ".join(f"{round(value, 9) + 0.0:.3g}" for value in values.values())  # no -0
        self.find("state home", shown, home.reason, home.is_sure)
        return [("home", self.groups["arm"], values)]

    def _pairs(self) -> dict[Pair, str]:
        found = find_pairs(self.tree, self.palm, self.arm.base)
        always, never = (sum(r == why for r in found.values()) for why in ("Always", "Never"))
        shown = f"{always} always, {never} never in contact"
        self.find("disable_collisions", shown, "in random configurations and by descent")
        return found


def _mm(length: float) -> str:
    return f"{1000 * length:.1f} mm"
