# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Random contact sets to try the stability engines on: common ones, and ill-conditioned ones."""

import numpy as np

from graspless import mechanics
from graspless.mechanics import Contact, ContactMode, ContactSet, Finger, FingerMode


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
    if kind in HARD:
        return hard_set(rng, kind)
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


def rotation(rng):
    q, r = np.linalg.qr(rng.normal(size=(3, 3)))
    q = q * np.sign(np.diag(r))
    return q if np.linalg.det(q) > 0 else -q


def near_line(rng, count, off=None):
    """Points on the floor, `off` times the line's length away from it: 1e-9 to 1e-3."""
    off = 10 ** rng.uniform(-9, -3) if off is None else off
    turn = rng.uniform(0, 2 * np.pi)
    along, across = (
        np.array([np.cos(turn), np.sin(turn), 0]),
        np.array([-np.sin(turn), np.cos(turn), 0]),
    )
    points = np.outer(np.sort(rng.uniform(-1, 1, count)), along)
    return points + np.outer(off * rng.normal(size=count), across) + [0, 0, -1]


def with_friction(touches, draw):
    for touch in touches:
        touch.friction = draw()
    return touches


def copies(rng, contacts, off):
    """Contacts, each with another one at a distance."""
    made = list(contacts)
    for c in contacts:
        p = c.p_OC + off * rng.normal(size=3)
        made.append(Contact(p_OC=p, n_O=c.n_O, friction=c.friction, mode=c.mode, t_O=c.t_O))
    return made


def on_planes(rng):
    """Floor and walls, each with friction of its own, from none to much."""
    contacts = []
    for n in np.eye(3)[rng.permutation(3)[: rng.integers(1, 4)]]:
        friction, mode = rng.choice([0, 1e-3, 0.1, 0.5, 1, 3]), rng.choice(list(ContactMode))
        t = np.cross(n, rng.normal(size=3))
        for _ in range(rng.integers(1, 5)):
            p = rng.uniform(-1, 1, 3)
            p -= n * (n @ p + 1)
            contacts.append(Contact(p_OC=p, n_O=n, friction=friction, mode=mode, t_O=t))
    return contacts


def in_one_plane(rng, n):
    """Points and normals of contacts and fingers all in x = 0, but for friction."""
    contacts, held = on_floor(rng, rng.integers(2, 6), ContactMode.stick), around(rng, n)
    for touch in [*contacts, *held]:
        touch.p_OC = touch.p_OC * [0, 1, 1]
        normal = touch.n_O * [0, 1, 1]
        touch.n_O = normal / np.linalg.norm(normal)
    return contacts, held


def fingers_near_line(rng, n):
    """Fingers whose points nearly lie on the line of the contacts."""
    contacts = on_floor(rng, 4, None, near_line(rng, 4))
    held = around(rng, n)
    for finger, p in zip(held, near_line(rng, 4), strict=False):
        finger.p_OC = p
    return contacts, held


def walls_near_line(rng, n):
    contacts = on_floor(rng, 4, ContactMode.stick, near_line(rng, 4))
    off = 10 ** rng.uniform(-9, -3) * rng.normal()
    for x in (-1, 1):
        contacts.append(Contact(p_OC=[x, off, 0], n_O=[-x, 0, 0], friction=rng.choice([0.05, 0.3])))
    return contacts, on_faces(rng, n)


def plain(rng, n):
    return on_floor(rng, rng.integers(3, 9)), around(rng, n)


# Ill-conditioned and extreme kinds, in metres; hard_set() scales and turns them.
HARD = {
    "near a line": lambda rng, n: (on_floor(rng, 4, None, near_line(rng, 4)), around(rng, n)),
    "block near a line": lambda rng, n: (
        on_floor(rng, 4, ContactMode.stick, near_line(rng, 4)),
        on_faces(rng, n),
    ),
    "many near a line": lambda rng, n: (
        on_floor(rng, 8, None, near_line(rng, 8)),
        around(rng, n),
    ),
    "fingers near a line": fingers_near_line,
    "walls near a line": walls_near_line,
    "without friction": lambda rng, n: tuple(with_friction(t, lambda: 0.0) for t in plain(rng, n)),
    "friction 3": lambda rng, n: tuple(with_friction(t, lambda: 3.0) for t in plain(rng, n)),
    "little friction": lambda rng, n: tuple(
        with_friction(t, lambda: 10 ** rng.uniform(-7, -2)) for t in plain(rng, n)
    ),
    "some without friction": lambda rng, n: tuple(
        with_friction(t, lambda: rng.choice([0, 0.3])) for t in plain(rng, n)
    ),
    "in one plane": in_one_plane,
    "doubled": lambda rng, n: (copies(rng, on_floor(rng, rng.integers(2, 6)), 0), around(rng, n)),
    "nearly doubled": lambda rng, n: (
        copies(rng, on_floor(rng, rng.integers(2, 6)), 10 ** rng.uniform(-9, -3)),
        around(rng, n),
    ),
    "planes": lambda rng, n: (on_planes(rng), around(rng, n)),
}


def hard_set(rng, kind):
    """A set of a hard kind: 1 mm to 10 m large, 1 g to 1 t heavy, tilted in one of two."""
    contacts, held = HARD[kind](rng, int(rng.integers(0, 5)))
    size, mass = rng.choice([1e-3, 1, 10]), rng.choice([1e-3, 1, 1e3])
    turn = rotation(rng) if rng.random() < 0.5 else np.eye(3)
    for touch in [*contacts, *held]:
        touch.p_OC = turn @ touch.p_OC * size
        normal = turn @ touch.n_O
        touch.n_O = normal / np.linalg.norm(normal)
        touch.t_O = turn @ touch.t_O
    for finger in held:
        finger.max_normal_force *= mass
    known = np.zeros(6)
    known[:3] = turn @ [0, 0, -9.81 * mass]
    inertia = turn @ np.diag(rng.uniform(0.5, 0.9, 3)) @ turn.T * mass * size**2
    scale = mechanics.wrench_scale(mass, (inertia + inertia.T) / 2)
    made = ContactSet(
        contacts=contacts,
        fingers=held,
        known_wrench_O=known,
        wrench_scale=scale if rng.random() < 0.8 else np.eye(6),
        com_O=np.zeros(3) if rng.random() < 0.5 else size * rng.uniform(-0.3, 0.3, 3),
        cone_edges=int(rng.choice([3, 4, 6, 6, 6, 8])),
    )
    modes = [FingerMode.force if rng.random() < 0.5 else FingerMode.position for _ in held]
    return made, modes
