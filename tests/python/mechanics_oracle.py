# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Problems (5) and (6) written down plainly and solved by SciPy's HiGHS.

None of the library's mechanics is used: a ContactSet is read as data. HiGHS alone is accurate to its
tolerances, about 1e-9 of the forces at play. Three steps make the oracle sharper than that:

1. Wrenches are rational numbers, computed exactly from the numbers of the contact set.
2. The rows of balance are combined so that all singular values are equal (contacts nearly on a line make
   some of them tiny), still exactly, and rounded once. Forces and z are in units of their own sizes.
3. On request, a solution is refined: its residuals are computed in extended precision, magnified, and
   corrected by another run of HiGHS, until they vanish (Gleixner, Steffy and Wolter 2012).
"""

import functools
from fractions import Fraction

import numpy as np
from scipy.optimize import linprog
from scipy.sparse import coo_array

from graspless.mechanics import ContactMode, FingerMode

DEPENDENT = 1e-13  # ratio of singular values below which contacts do not resist some wrench
TIGHT = {"primal_feasibility_tolerance": 1e-10, "dual_feasibility_tolerance": 1e-10}
exact = np.frompyfunc(Fraction, 1, 1)


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
    """R^1/2 W C of one contact, exactly."""
    x, y, z = exact(edges)
    r = exact(p) - exact(contact_set.com_O)
    moments = [r[1] * z - r[2] * y, r[2] * x - r[0] * z, r[0] * y - r[1] * x]
    return times(contact_set.wrench_scale, np.array([x, y, z, *moments]))


def times(matrix, wrenches):
    """The exact product of a matrix of floats with rational columns, without its zeros."""
    rows = [
        sum(
            (Fraction(value) * wrenches[j] for j, value in enumerate(row) if value), 0 * wrenches[0]
        )
        for row in np.asarray(matrix)
    ]
    return np.array(rows)


def environment(contact_set):
    parts = [np.zeros((6, 0), object)]
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


def even_rows(generators):
    """Rows (r x 6) that make the r independent rows of `generators` equally strong."""
    left, singular, _ = np.linalg.svd(generators.astype(float))
    rank = int(np.sum(singular > DEPENDENT * singular[0]))
    return (left[:, :rank] / singular[:rank] * singular[0]).T


def rounded(rationals):
    """The nearest numbers of extended precision."""
    high = rationals.astype(float)
    return high.astype(np.longdouble) + (rationals - exact(high)).astype(float)


def solve(c, A, b, lower, upper=None):
    """linprog's answer to: minimise c x, A x = b, lower <= x <= upper."""
    bounds = np.array([lower, np.full(len(c), np.inf) if upper is None else upper], float).T
    A, b, c = A.astype(float), np.asarray(b, float), np.asarray(c, float)
    methods = [("highs-ds", True, TIGHT), ("highs-ds", False, TIGHT), ("highs-ipm", True, TIGHT)]
    for method, presolve, tolerances in [*methods, ("highs-ds", False, {})]:
        options = {"presolve": presolve, **tolerances}
        answer = linprog(c, None, None, A, b, bounds, method, options=options)
        if answer.status in (0, 2, 3):
            return answer
    return answer


def refined(c, A, b, answer, rounds=4):
    """The objective of an optimal answer for x >= 0 without upper bounds, to about 1e-15.

    Each round shifts the origin to the present solution, magnifies what is left, and solves that.
    """
    c, b = np.asarray(c, np.longdouble), np.asarray(b, np.longdouble)
    A = coo_array(A)
    x = answer.x.astype(np.longdouble)
    y = answer.eqlin.marginals.astype(np.longdouble)
    for _ in range(rounds):
        left, reduced = b.copy(), c.copy()
        np.subtract.at(left, A.row, A.data * x[A.col])
        np.subtract.at(reduced, A.col, A.data * y[A.row])
        primal, dual = max(np.abs(left).max(), -x.min()), -reduced.min()
        if max(primal, dual) < 1e-16:
            break
        for least in (1e-8, 1e-6, 1e-4):  # larger numbers confuse HiGHS, at times these too
            p, d = max(primal, least), max(dual, least)
            correction = solve(reduced / d, A, left / p, -x / p)
            if correction.status == 0:
                break
        assert correction.status == 0, correction.message
        x += correction.x * p
        y += correction.eqlin.marginals * d
    return float(c @ x)


class Problem6:
    """Problem (6) in one piece; directions are rows."""

    def __init__(self, contact_set, modes, directions):
        self.forces = force_scale(contact_set)
        self.limits = [f.max_normal_force for f in contact_set.fingers]
        env, rob = environment(contact_set), fingers(contact_set)
        generators = np.hstack([env, *[g for g, _ in rob]])
        even = even_rows(generators) if generators.size else np.zeros((0, 6))
        self.is_spanned = len(even) == 6
        if not self.is_spanned:
            return
        targets = rounded(times(even, exact(np.asarray(directions).T))).T
        self.z_unit = self.forces / float(np.abs(targets).max())
        known = times(contact_set.wrench_scale, exact(contact_set.known_wrench_O)[:, None])
        known = rounded(times(even, known))[:, 0] / self.forces
        self._write(env, rob, modes, rounded(times(even, generators)), known, targets)

    def _write(self, env, rob, modes, generators, known, targets):
        """Unknowns: z, f_com of the fingers in force control, then of each direction the
        coefficients k and what they leave of the limits of fingers in position control."""
        force = [i for i, mode in enumerate(modes) if mode == FingerMode.force]
        count = generators.shape[1]
        normals = np.zeros((len(rob), count + len(rob)))
        column = env.shape[1]
        for i, (g, normal) in enumerate(rob):
            normals[i, column : column + g.shape[1]] = normal
            column += g.shape[1]
            normals[i, count + i] = i not in force
        limits = np.array([limit / self.forces for limit in self.limits])
        first, width = 1 + len(force), count + len(rob)
        rows = Rows()
        largest = np.abs(targets).max()
        for d, target in enumerate(targets):
            k = first + d * width
            rows.add({0: -target[:, None] / largest, k: generators}, -known)
            shared = np.zeros((len(rob), first))
            for column, i in enumerate(force):
                shared[i, 1 + column] = -1
            rows.add(
                {0: shared, k: normals}, [0 if i in force else limits[i] for i in range(len(rob))]
            )
        for column, i in enumerate(force):  # f_com + slack = f_max
            slack = first + len(targets) * width + column
            rows.add({1 + column: np.ones((1, 1)), slack: np.ones((1, 1))}, [limits[i]])
        self.A, self.b = rows.system(first + len(targets) * width + len(force))
        self.c = np.zeros(self.A.shape[1])
        self.c[0] = -1

    @functools.cached_property
    def _answer(self):
        answer = solve(self.c, self.A, self.b, 0 * self.c)
        upper = np.full(len(self.c), np.inf)
        for upper[0] in (1e3, 1e6):  # where HiGHS gives up, commonly before what is unbounded
            if answer.status not in (0, 2, 3):
                answer = solve(self.c, self.A, self.b, 0 * self.c, upper)
                if answer.status == 0 and answer.x[0] > 0.99 * upper[0]:
                    answer.status = 4 if upper[0] < 1e6 else 3
        assert answer.status in (0, 2, 3), answer.message
        return answer

    def z(self, *, refine=False):
        """z [N], refined where asked."""
        if not self.is_spanned or self._answer.status == 2:
            return 0.0
        if self._answer.status == 3:
            return np.inf
        if refine:
            return max(0.0, -refined(self.c, self.A, self.b, self._answer) * self.z_unit)
        return max(0.0, -self._answer.fun * self.z_unit)


class Rows:
    """Rows of a sparse system in extended precision, block by block."""

    def __init__(self):
        self.rows, self.right, self.parts = 0, [], ([], [], [])

    def add(self, blocks, right):
        for column, block in blocks.items():
            i, j = np.nonzero(block)
            found = (i + self.rows, j + column, block[i, j])
            for part, values in zip(self.parts, found, strict=True):
                part.append(values)
        self.rows += len(right)
        self.right.extend(right)

    def system(self, columns):
        i, j, values = (np.concatenate(part) for part in self.parts)
        A = coo_array((values.astype(np.longdouble), (i, j)), shape=(self.rows, columns))
        return A, np.array(self.right, np.longdouble)


def force_scale(contact_set):
    """The forces at play [N]: of the known wrench or of all fingers."""
    known = contact_set.wrench_scale @ contact_set.known_wrench_O
    limits = [f.max_normal_force for f in contact_set.fingers]
    return max(np.linalg.norm(known), sum(limits)) or 1.0


def max_stability(contact_set, modes, directions, *, refine=True):
    """z of Problem (6)."""
    return Problem6(contact_set, modes, directions).z(refine=refine)


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
    A = coo_array(rounded(times(even_rows(generators), generators)))
    c = -np.ones(generators.shape[1])
    answer = solve(c, A, np.zeros(A.shape[0]), 0 * c, -c)
    assert answer.status == 0
    assert answer.fun > -1e-6 or answer.fun < -0.99, "neither bounded nor unbounded"
    return answer.fun > -0.5
