# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems (5) and (6) written down plainly and solved by SciPy's HiGHS, and contact sets to try.

None of the library's mechanics is used: a ContactSet is read as data.
"""

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_array

from graspless.mechanics import Contact, ContactMode, ContactSet, Finger, FingerMode

NOISE = 1e-12  # of W C: what is below is rounding of a lever that vanishes
TIGHT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}


def tangent(n, t):
    t = t - n * (n @ t)
    if np.linalg.norm(t) > 0:
        return t / np.linalg.norm(t)
    axis = np.eye(3)[(np.argmax(np.abs(n)) + 1) % 3]
    axis = axis - n * (n @ axis)
    return axis / np.linalg.norm(axis)


def cone(n, friction, edges, t):
    """Unit edges as columns."""
    angles = 2 * np.pi * np.arange(edges) / edges
    around = np.outer(t, np.cos(angles)) + np.outer(np.cross(n, t), np.sin(angles))
    return (n[:, None] + friction * around) / np.hypot(1, friction)


def wrenches(contact_set, p, edges):
    """R^1/2 W C of one contact."""
    moments = np.cross(p - contact_set.com_O, edges.T).T
    columns = contact_set.wrench_scale @ np.vstack([edges, moments])
    columns[np.abs(columns) < NOISE * np.abs(columns).max(axis=0)] = 0
    return columns


def environment(contact_set):
    parts = [np.zeros((6, 0))]
    for c in contact_set.contacts:
        t = tangent(c.n_O, c.t_O)
        if c.mode == ContactMode.stick:
            edges = cone(c.n_O, c.friction, contact_set.cone_edges, t)
        else:
            edges = cone(c.n_O, c.friction, 2, t)[:, 1:]  # against the motion
        parts.append(wrenches(contact_set, c.p_OC, edges))
    return np.hstack(parts)


def fingers(contact_set):
    """A pair a finger: wrenches and normal force of its edges."""
    pairs = []
    for f in contact_set.fingers:
        edges = cone(f.n_O, f.friction, contact_set.cone_edges, tangent(f.n_O, f.t_O))
        pairs.append((wrenches(contact_set, f.p_OC, edges), f.n_O @ edges))
    return pairs


def solve(c, A_ub, b_ub, A_eq, b_eq, bounds):
    """linprog's answer; when HiGHS gives up, once more by other means."""
    for method, presolve in [("highs-ds", True), ("highs-ds", False), ("highs-ipm", True)]:
        answer = linprog(
            c, A_ub, b_ub, A_eq, b_eq, bounds, method, options={"presolve": presolve, **TIGHT}
        )
        if answer.status in (0, 2, 3):
            return answer
    raise AssertionError(answer.message)


def max_stability(contact_set, modes, directions):
    """z of Problem (6) in one piece; directions are rows."""
    env, rob = environment(contact_set), fingers(contact_set)
    n, N, limits = len(rob), len(directions), [f.max_normal_force for f in contact_set.fingers]
    generators = np.hstack([env, *[g for g, _ in rob]])
    normals = np.zeros((n, generators.shape[1]))
    column = env.shape[1]
    for i, (g, normal) in enumerate(rob):
        normals[i, column : column + g.shape[1]] = normal
        column += g.shape[1]
    force = [i for i, mode in enumerate(modes) if mode == FingerMode.force]
    # Unknowns: z, f_com of the fingers in force control, then k of each direction.
    first, width = 1 + len(force), generators.shape[1]
    size = first + N * width
    eq, ub = Rows(size), Rows(size)
    known = contact_set.wrench_scale @ contact_set.known_wrench_O
    # Rows on an even footing: HiGHS knows absolute tolerances alone.
    left, singular, _ = np.linalg.svd(generators)
    even = np.eye(6)
    if len(singular) == 6 and 1e-9 < singular[-1] / singular[0] < 0.01:
        even = (left / singular * singular[0]).T
    generators, known, directions = even @ generators, even @ known, directions @ even.T
    for d, direction in enumerate(directions):
        k = first + d * width
        eq.add({0: -direction[:, None], k: generators}, -known)
        ub.add({k: normals}, limits)
        for row, i in enumerate(force):
            eq.add({1 + row: -np.ones((1, 1)), k: normals[i : i + 1]}, [0])
    c = np.zeros(size)
    c[0] = -1
    answer = solve(c, *ub.system(), *eq.system(), (0, None))
    return {0: -answer.fun if answer.status == 0 else 0, 2: 0, 3: np.inf}[answer.status]


class Rows:
    """Rows of a sparse system, block by block."""

    def __init__(self, size):
        self.size, self.rows, self.right = size, 0, []
        self.parts = ([], [], [])

    def add(self, blocks, right):
        for column, block in blocks.items():
            i, j = np.nonzero(block)
            for part, values in zip(
                self.parts, (i + self.rows, j + column, block[i, j]), strict=True
            ):
                part.append(values)
        self.rows += len(right)
        self.right.extend(right)

    def system(self):
        if not self.rows:
            return None, None
        i, j, values = (np.concatenate(part) for part in self.parts)
        return coo_array((values, (i, j)), shape=(self.rows, self.size)).tocsr(), self.right


def is_bounded(contact_set, modes):
    """Whether Problem (5) is."""
    position = [
        g
        for (g, _), mode in zip(fingers(contact_set), modes, strict=True)
        if mode == FingerMode.position
    ]
    generators = np.hstack([environment(contact_set), *position])
    if not generators.shape[1]:
        return True
    # A feasible k may be scaled at will: k <= 1 shows the same and is never unbounded.
    c = -np.ones(generators.shape[1])
    answer = solve(c, None, None, generators, np.zeros(6), (0, 1))
    assert answer.status == 0
    assert answer.fun > -1e-6 or answer.fun < -0.99, "neither bounded nor unbounded"
    return answer.fun > -0.5


def on_floor(rng, count, mode=None, at=None):
    """Contacts below a body; each sticks or slides unless told."""
    t = [*rng.normal(size=2), 0]
    points = rng.uniform(-1, 1, (count, 3)) if at is None else np.array(at, float)
    points[:, 2] = -1
    friction = rng.uniform(0.2, 1)
    return [
        Contact(
            p_OC=p,
            n_O=[0, 0, 1],
            friction=friction,
            mode=mode or rng.choice([ContactMode.stick, ContactMode.slide]),
            t_O=t,
        )
        for p in points
    ]


def around(rng, count):
    """Fingers about a body that press inward, more or less."""
    made = []
    for _ in range(count):
        out = rng.normal(size=3)
        out /= np.linalg.norm(out)
        n = -out + 0.4 * rng.uniform(-1, 1, 3)
        made.append(
            Finger(
                p_OC=out,
                n_O=n / np.linalg.norm(n),
                friction=rng.uniform(0.2, 1),
                max_normal_force=rng.uniform(3, 30),
            )
        )
    return made


def on_faces(rng, count):
    """Fingers at grid points of a cube's faces: exact symmetry, ties, coincident and opposed ones."""
    made = []
    for _ in range(count):
        n = np.zeros(3)
        n[rng.integers(3)] = rng.choice([-1.0, 1.0])
        p = rng.integers(-1, 2, 3) * 0.5
        p[n != 0] = -n[n != 0]
        made.append(Finger(p_OC=p, n_O=n, friction=0.7, max_normal_force=10))
    return made


CORNERS = [[1, 1, -1], [-1, 1, -1], [-1, -1, -1], [1, -1, -1]]


def wrench_scale(rng):
    return np.diag([1, 1, 1, *rng.uniform(0.5, 2, 3)])


# Each kind of contact set: what touches it, from a generator and a number of fingers.
KINDS = {
    "slides": lambda rng, n: (on_floor(rng, rng.integers(3, 9), ContactMode.slide), around(rng, n)),
    "sticks": lambda rng, n: (on_floor(rng, rng.integers(2, 9), ContactMode.stick), around(rng, n)),
    "mixed": lambda rng, n: (on_floor(rng, rng.integers(1, 12)), around(rng, n)),
    "cube slides": lambda rng, n: (
        on_floor(rng, 4, ContactMode.slide, CORNERS),
        on_faces(rng, n),
    ),
    "cube rests": lambda rng, n: (on_floor(rng, 4, ContactMode.stick, CORNERS), on_faces(rng, n)),
    "cube on its edge": lambda rng, n: (
        on_floor(rng, 2, ContactMode.stick, CORNERS[:2]),
        on_faces(rng, n),
    ),
    "coincident": lambda rng, n: (
        [*on_floor(rng, 4, ContactMode.stick, CORNERS[:2] * 2)],
        (on_faces(rng, 1) * n)[:n],
    ),
    "collinear": lambda rng, n: (
        on_floor(rng, 5, None, [[x, x, -1] for x in np.linspace(-1, 1, 5)]),
        around(rng, n),
    ),
    "between walls": lambda rng, n: (between_walls(rng), on_faces(rng, n)),
    "in the air": lambda rng, n: ([], around(rng, n)),
    "nearly collinear": lambda rng, n: (
        on_floor(rng, 4, None, [[x, x + 1e-6 * rng.normal(), -1] for x in np.linspace(-1, 1, 4)]),
        around(rng, n),
    ),
}


def between_walls(rng):
    contacts = on_floor(rng, 4, ContactMode.stick, CORNERS)
    side = [
        Contact(p_OC=[x, y, 0], n_O=[-x, 0, 0], friction=0.3)
        for x in (-1, 1)[: rng.integers(1, 3)]
        for y in (-1, 1)
    ]
    return contacts + side


def contact_set(rng, kind):
    """A contact set of a kind, with control modes."""
    contacts, held = KINDS[kind](rng, int(rng.integers(0, 5)))
    weight = np.array([0, 0, -10, 0, 0, 0])
    if rng.random() < 0.3:
        weight = weight + rng.normal(size=6)
    made = ContactSet(
        contacts=contacts,
        fingers=held,
        known_wrench_O=weight,
        wrench_scale=wrench_scale(rng),
        com_O=np.zeros(3) if rng.random() < 0.7 else rng.uniform(-0.3, 0.3, 3),
        cone_edges=int(rng.choice([3, 4, 6, 6, 6, 8])),
    )
    modes = [FingerMode.force if rng.random() < 0.5 else FingerMode.position for _ in held]
    return made, modes
