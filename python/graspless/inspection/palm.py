# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Search for the hand of a robot: the palm, and the bodies of its fingers."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

if TYPE_CHECKING:
    from ..frames import Matrix
    from .tree import Tree

GRIPPER = re.compile(r"grip|jaw|finger|claw|thumb|pinch", re.IGNORECASE)
HAND = re.compile(rf"{GRIPPER.pattern}|hand|palm", re.IGNORECASE)
JOIN = "`graspless robot join ARM GRIPPER --mount LINK` adds a gripper"
MANY = 5  # largest number of independent joints of a finger
REACHES_AS_FAR = 0.6  # of a moving jaw's length: how far a fixed jaw must reach


@dataclass(frozen=True)
class Finger:
    """Bodies of a finger, base first; the one body of a fixed jaw is the palm."""

    bodies: tuple[int, ...]
    is_fixed: bool = False

    def links(self, tree: Tree) -> list[int]:
        """Links of the finger that have a collision shape."""
        found = [link for body in self.bodies for link in tree.members[body]]
        return [link for link in found if link in tree.points]

    def name(self, tree: Tree) -> str:
        """Name of the link at the finger's end."""
        return tree.links[self.links(tree)[-1]]


@dataclass(frozen=True)
class Palm:
    """Body that carries the fingers."""

    body: int
    fingers: tuple[Finger, ...]
    reason: str
    is_sure: bool = True

    def link(self, tree: Tree) -> int:
        """Link that all moving fingers are attached to, directly or through fixed joints."""
        moving = (finger for finger in self.fingers if not finger.is_fixed)
        lines = [tree.line(tree.parents[finger.bodies[0]]) for finger in moving]
        return next(link for link in lines[0] if all(link in line for line in lines))

    def drivers(self, tree: Tree) -> list[str]:
        """Independent joints of the fingers, and of the parts of the palm that carry them."""
        start = len(tree.path(self.body))
        ends = {body for finger in self.fingers for body in finger.bodies}
        carriers = {body for end in ends for body in tree.path(end)[start:]}
        return tree.drivers([*(carriers | ends)])

    def ordered(self, tree: Tree) -> tuple[Finger, Finger]:
        """Two fingers, the one that slides first: a fixed jaw, or the only one called left."""
        first, second = self.fingers
        is_left = ["left" in finger.name(tree).lower() for finger in self.fingers]
        if second.is_fixed or (not first.is_fixed and is_left == [False, True]):
            first, second = second, first
        return first, second


def find_palm(tree: Tree, link: str | None = None) -> Palm:
    """Returns the palm: the last fork of the tree, or the fixed jaw at the end of a chain.

    Parameters
    ----------
    tree : Tree
        Robot with collision shapes.
    link : str, optional
        A link of the palm.

    Raises
    ------
    ValueError
        The robot has no hand, or several and `link` is not given.
    """
    if not tree.points:
        raise ValueError("no link has a collision shape, so a hand cannot be found")
    if link is not None:
        try:
            index = tree.robot.frame(link)
        except ValueError as error:
            raise ValueError(f"palm: {error}") from None
        return _palm_at(tree, tree.body(index))
    forks = [body for body in tree.members if len(_shaped(tree, body)) > 1]
    last = [body for body in forks if not any(b in forks for b in tree.below(body)[1:])]
    if len(last) == 1:
        last = _palms_below(tree, last[0])
    if len(last) > 1:
        names = ", ".join(_palm_link(tree, body) for body in last)
        raise ValueError(
            f"{len(last)} links may be the palm of a hand: {names}; choose one with "
            "`graspless robot inspect --palm LINK` or `graspless.robot.inspect(palm=...)`"
        )
    if not last:
        return _jaw(tree)
    carries_legs = not tree.drivers(tree.path(last[0])[1:])
    if carries_legs and (jaw := _named_jaw(tree)) is not None:
        return jaw
    found = _palm_at(tree, last[0])
    _require_fingers(tree, found)
    return replace(found, is_sure=_is_named(tree, found))


def _palms_below(tree: Tree, last: int) -> list[int]:
    """Returns the forks that may be the palm of the hand with the last fork of the tree.

    A part that only joints of other fingers move belongs to a palm below it. A shorter chain than
    the one that carries the fork below may be part of a finger.
    """
    forks = [body for body in tree.path(last) if len(_shaped(tree, body)) > 1]
    while len(forks) > 1 and _is_part(tree, forks[-2], forks[-1]):
        forks.pop()
    path = tree.path(forks[-1])
    ends = [0, *(path.index(fork) for fork in forks)]
    chains = [len(tree.drivers(path[a + 1 : b + 1])) for a, b in pairwise(ends)]
    longest = chains.index(max(chains))
    if chains[longest] > chains[-1] and _most_joints(tree, forks[longest]) <= MANY:
        return [forks[longest], forks[-1]]
    return [forks[-1]]


def _is_part(tree: Tree, below: int, fork: int) -> bool:
    """True if each joint between two forks moves other branches of the lower one, too."""
    between = tree.path(fork)[len(tree.path(below)) :]
    carried = tree.below(between[0])
    others = [body for body in tree.below(below)[1:] if body not in carried]
    return set(tree.drivers(between)) <= set(tree.drivers(others))


def _most_joints(tree: Tree, body: int) -> int:
    """Largest number of independent joints of a branch of a body."""
    return max(len(tree.drivers(list(f.bodies))) for f in _fingers(tree, _shaped(tree, body)))


def _fingers(tree: Tree, children: list[int]) -> tuple[Finger, ...]:
    """Returns the fingers that begin at bodies of a palm.

    Beside two others, branches that have joints of their own are fingers on a part of the palm.
    """
    found = []
    for child in children:
        fork = child
        while len(branches := _shaped(tree, fork)) == 1:
            fork = branches[0]
        joints = [set(tree.drivers(tree.below(branch))) for branch in branches]
        shared = {name for name in set().union(*joints) if sum(name in own for own in joints) > 1}
        if len(children) > 2 and len(branches) > 1 and all(own - shared for own in joints):
            found += [finger for branch in branches for finger in _fingers(tree, [branch])]
        else:
            found.append(Finger(tuple(tree.below(child))))
    return tuple(found)


def _require_fingers(tree: Tree, palm: Palm) -> None:
    """Raises ValueError if an arm or a leg is taken for a finger of a body not called a hand."""
    if HAND.search(" ".join(tree.links[link] for link in tree.members[palm.body])):
        return
    for finger in palm.fingers:
        count = len(tree.drivers([body for body in finger.bodies if body != palm.body]))
        if count > MANY:
            raise ValueError(
                f"no hand was found: {_palm_link(tree, palm.body)} carries {finger.name(tree)} by "
                f"{count} joints, more than the {MANY} of a finger; name its palm if it has one; "
                f"{JOIN}"
            )


def _is_named(tree: Tree, palm: Palm) -> bool:
    """True if a link or joint of the hand is called one."""
    bodies = [body for finger in palm.fingers for body in finger.bodies]
    names = [tree.links[link] for body in (palm.body, *bodies) for link in tree.members[body]]
    return HAND.search(" ".join([*names, *map(tree.driver, bodies)])) is not None


def _shaped(tree: Tree, body: int) -> list[int]:
    return [child for child in tree.children[body] if tree.has_shape(child)]


def _palm_link(tree: Tree, body: int) -> str:
    """Name of the link that carries the first finger of a body."""
    children = _shaped(tree, body)
    return tree.links[tree.parents[children[0]] if children else body]


def _palm_at(tree: Tree, body: int) -> Palm:
    children = _shaped(tree, body)
    name = _palm_link(tree, body)
    if not children:
        what = "no moving link with a collision shape is attached to it"
        raise ValueError(f"palm: {name}: {what}; {JOIN}")
    if len(children) == 1:
        return _jaws(tree, body, children[0], is_sure=False)
    fingers = _fingers(tree, children)
    reason = f"{name} is the last link that carries several moving ones"
    return Palm(body, fingers, reason)


def _ends(tree: Tree) -> list[int]:
    """Bodies at the ends of chains that have a shape."""
    return [b for b in tree.members if not _shaped(tree, b) and tree.has_shape(b) and b > 0]


def _jaw(tree: Tree) -> Palm:
    """Returns the palm of a gripper with one moving jaw, at the end of a chain."""
    ends = _ends(tree)
    leaf = ends[-1] if ends else 0
    parent = tree.body(tree.parents[leaf]) if leaf else 0
    if leaf and any(link in tree.points for link in tree.members[parent]):
        named = _is_jaw(tree, leaf)
        if named or _is_beside(tree, parent, leaf):
            return _jaws(tree, parent, leaf, named)
    drawn = [tree.links[link] for link in tree.links_below(leaf) if tree.links[link] in tree.drawn]
    if drawn:
        shown = " and ".join(drawn)
        raise ValueError(f"no hand was found: {shown} can be seen, but have no collision shape")
    bare = [b for b in tree.members if b and not tree.children[b] and not tree.has_shape(b)]
    if len(bare) > 1:
        names = " and ".join(tree.links[b] for b in bare)
        raise ValueError(
            f"no hand was found: {names} move, but have no shape; add the fingers "
            "that are mounted on them"
        )
    fixed = [tree.links[link] for link in tree.members[leaf] if GRIPPER.search(tree.links[link])]
    what = f"no joint moves {', '.join(fixed)}" if fixed else "no joint moves a finger"
    raise ValueError(
        f"no hand was found: {what} (no link carries two or more moving links, and the last "
        f"joint does not move one jaw against another); {JOIN}"
    )


def _named_jaw(tree: Tree) -> Palm | None:
    """Returns the palm of the only part at the end of a chain that is called a jaw."""
    found = [leaf for leaf in _ends(tree) if _is_jaw(tree, leaf)]
    if len(found) != 1:
        return None
    parent = tree.body(tree.parents[found[0]])
    has_shape = any(link in tree.points for link in tree.members[parent])
    return _jaws(tree, parent, found[0], is_sure=True) if has_shape else None


def _is_jaw(tree: Tree, leaf: int) -> bool:
    return GRIPPER.search(f"{tree.links[leaf]} {tree.driver(leaf)}") is not None


def _jaws(tree: Tree, parent: int, leaf: int, is_sure: bool) -> Palm:
    reason = f"{tree.links[leaf]} moves against {tree.links[tree.parents[leaf]]}, which is fixed"
    fingers = (Finger((parent,), is_fixed=True), Finger(tuple(tree.below(leaf))))
    return Palm(parent, fingers, reason, is_sure)


def _is_beside(tree: Tree, parent: int, leaf: int) -> bool:
    """True if a body reaches past the joint of its child about as far as the child itself.

    A child that lies around the axis of its joint is a flange, not a jaw.
    """
    X_WL = tree.poses(tree.robot.clamp(np.zeros(tree.robot.dof)))
    base, joint = X_WL[parent][:3, 3], X_WL[leaf][:3, 3]
    moving = tree.cloud(tree.members[leaf], X_WL)
    length = _farthest(moving, joint)
    owner = tree.joint(leaf)
    assert owner is not None
    axis = X_WL[leaf][:3, :3] @ owner.axis_L
    offset = np.linalg.norm(np.cross(moving.mean(axis=0) - joint, axis)) / np.linalg.norm(axis)
    reach = _farthest(tree.cloud(tree.members[parent], X_WL), base)
    past = reach - float(np.linalg.norm(joint - base))
    return bool(past > REACHES_AS_FAR * length and offset > length / 4)


def _farthest(points: Matrix, origin: Matrix) -> float:
    return float(np.linalg.norm(points - origin, axis=1).max())
