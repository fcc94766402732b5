# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pairs of links that need no test for collision."""

from __future__ import annotations

from itertools import combinations
from typing import TYPE_CHECKING

from .. import scene

if TYPE_CHECKING:
    from ..frames import Matrix
    from .palm import Palm
    from .tree import Tree

Pair = tuple[str, str]


def find_pairs(tree: Tree, palm: Palm, base: int) -> dict[Pair, str]:
    """Returns the pairs with the reason of an SRDF: Always, Never, or Default if none of the joints
    of arm and hand moves one of them relative to the other.

    Fingers may always meet, however rarely they do.
    """
    moved = moved_links(tree, palm, base)
    always, never = scene.sample_contacts(tree.robot, links=moved)
    finger = _finger_of(tree, palm)
    found = {(tree.links[a], tree.links[b]): "Always" for a, b in always}
    for a, b in never:
        ends = finger.get(a), finger.get(b)
        if None in ends or ends[0] == ends[1]:
            found[tree.links[a], tree.links[b]] = "Never"
    carriers = _carriers(tree, palm, base)
    for a, b in combinations(sorted(tree.points), 2):
        pair = tree.links[a], tree.links[b]
        if carriers[a] == carriers[b] and (a, b) not in tree.robot.ignored_pairs:
            found.setdefault(pair, "Default")
    return found


def _carriers(tree: Tree, palm: Palm, base: int) -> dict[int, int]:
    """The body that carries each link, and moves with a joint of arm or hand, or is the root."""
    path = tree.path(palm.body)
    used = path[path.index(base) + 1 :] + [b for finger in palm.fingers for b in finger.bodies]
    drivers = set(tree.drivers([body for body in used if tree.joint(body)]))

    def carrier(body: int) -> int:
        while tree.parents[body] >= 0 and tree.driver(body) not in drivers:
            body = tree.body(tree.parents[body])
        return body

    return {link: carrier(tree.body(link)) for link in tree.points}


def moved_links(tree: Tree, palm: Palm, base: int) -> list[int]:
    """Returns the links that the joints of the hand and of an arm on body `base` move."""
    path = tree.path(palm.body)
    at = path.index(base) + 1
    first = path[at:] or list(tree.children[palm.body])
    return [link for body in first[: 1 if path[at:] else None] for link in tree.links_below(body)]


def touching(made: scene.Scene, links: set[str], q: Matrix) -> set[Pair]:
    """Returns the pairs of these links that touch at q."""
    made.is_free(q)
    names = [made.world.name(body) for body in range(made.world.num_bodies)]
    pairs = {(names[a], names[b]) for a, b in made.world.all_collisions()}
    return {pair for pair in pairs if links.issuperset(pair)}


def _finger_of(tree: Tree, palm: Palm) -> dict[int, int]:
    """Number of the moving finger that each link belongs to."""
    moving = (finger for finger in palm.fingers if not finger.is_fixed)
    return {
        link: number
        for number, finger in enumerate(moving)
        for body in finger.bodies
        for link in tree.members[body]
    }
