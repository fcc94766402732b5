# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Both engines against SciPy's HiGHS: a sample, and twenty thousand contact sets (-m long)."""

import collections
import itertools

import numpy as np
import pytest

import mechanics_oracle as oracle
import mechanics_sets as sets
from graspless.mechanics import (
    Engine,
    FingerMode,
    best_control_modes,
    disturbance_directions,
    internal_force_is_bounded,
    max_stability,
)

AGREE = 1e-9
ALL = disturbance_directions()


def directions(rng):
    """The axes and some more; all 76 in one of fifty cases."""
    if rng.random() < 0.02:
        return ALL
    return np.vstack([ALL[:12], rng.normal(size=(8, 6))])


def difference(a, b, forces):
    """Relative to z, or to a thousandth of the forces at play where z is less."""
    return 0 if a == b else abs(a - b) / max(abs(b), 1e-3 * forces)


def compare(seed, kind, engines=tuple(Engine)):
    """Differences of z by engine, z, and the forces at play; that of (5) must be none."""
    rng = np.random.default_rng(seed)
    contact_set, modes = sets.contact_set(rng, kind)
    l = directions(rng)  # noqa: E741
    bounded = oracle.is_bounded(contact_set, modes)
    for engine in engines:
        assert internal_force_is_bounded(contact_set, modes, engine=engine) == bounded, engine
    problem = oracle.Problem6(contact_set, modes, l)
    forces = oracle.force_scale(contact_set)
    found = {}
    for engine in engines:
        z = max_stability(contact_set, modes, directions=l, engine=engine).z
        found[engine.name] = difference(z, problem.z(), forces)
        if found[engine.name] > 0.01 * AGREE:  # HiGHS alone is not sharper than that
            found[engine.name] = difference(z, problem.z(refine=True), forces)
    return found, problem.z(), forces


@pytest.mark.parametrize("kind", [*sets.KINDS, *sets.HARD])
def test_engines_agree_with_highs(kind):
    for seed in range(4):
        found, *_ = compare((seed, len(kind)), kind)
        assert max(found.values()) < AGREE, (seed, found)


# Sets among 40,000 that an earlier condition estimate let through: contacts that hardly span the
# space of wrenches, small prices with a large condition, and forces that jam up to rounding.
@pytest.mark.parametrize("index", [156, 4139, 4670, 6901, 11710, 25246, 25894, 28259, 30467, 32134])
def test_engines_agree_on_sets_found_by_search(index):
    kinds = [*sets.KINDS, *sets.HARD]
    found, *_ = compare((5, index), kinds[index % len(kinds)])
    assert max(found.values()) < AGREE


def test_best_modes_are_the_best_of_all():
    kinds = [*list(sets.KINDS)[:6], "nearly collinear", *sets.HARD]
    for seed, kind in enumerate(kinds):
        rng = np.random.default_rng((99, seed))
        contact_set, _ = sets.contact_set(rng, kind)
        l = ALL[:12]  # noqa: E741
        values = [
            oracle.Problem6(contact_set, modes, l).z(refine=True)
            for modes in itertools.product(FingerMode, repeat=len(contact_set.fingers))
            if oracle.is_bounded(contact_set, modes)
        ]
        best, forces = max(values, default=0), oracle.force_scale(contact_set)
        for engine in Engine:
            found = best_control_modes(contact_set, directions=l, engine=engine)
            assert bool(found) == (best > 1e-12 * forces), kind
            if found:
                assert difference(found.stability.z, best, forces) < AGREE, kind
                assert oracle.is_bounded(contact_set, found.modes)


@pytest.mark.parametrize("friction", [0, 1e-6, 1e-4, 0.5])
def test_best_modes_agree_with_max_stability(friction):
    for seed in range(30):
        contact_set, _ = sets.contact_set(np.random.default_rng((98, seed)), "cube slides")
        for touch in [*contact_set.contacts, *contact_set.fingers]:
            touch.friction = friction
        found = best_control_modes(contact_set)
        if found:
            z = max_stability(contact_set, found.modes).z
            assert found.stability.z == pytest.approx(z, rel=AGREE)


def run_many(kinds, seed, count):
    """Compares `count` sets of these kinds; prints a table, returns those that differ.

    Contacts within 1e-6 of a line may withstand less than 1e-9 of the forces at play, and GLPK is not
    sharper than that. So a set differs if z does by 1e-9 of the larger of z and these forces, and the
    table counts those that differ by 1e-9 of z, or of a thousandth of the forces where z is less.
    """
    worst = collections.defaultdict(lambda: collections.defaultdict(float))
    counts = collections.defaultdict(collections.Counter)
    wrong, small = [], 0
    for i in range(count):
        kind = kinds[i % len(kinds)]
        try:
            found, z, forces = compare((seed, i), kind)
        except (AssertionError, RuntimeError) as error:
            wrong.append((i, kind, f"{type(error).__name__}: {error}"))
            continue
        counts[kind]["none" if z == 0 else "unbounded" if np.isinf(z) else "stable"] += 1
        for name, value in found.items():
            worst[kind][name] = max(worst[kind][name], value)
        if max(found.values()) >= AGREE:
            small += 1
            if max(found.values()) * max(z, 1e-3 * forces) >= AGREE * max(z, forces):
                wrong.append((i, kind, found))
    print(f"\n{'kind':24}{'stable':>8}{'none':>8}{'unbounded':>10}{'fast':>12}{'reference':>12}")
    for kind in kinds:
        row = [counts[kind][name] for name in ("stable", "none", "unbounded")]
        print(f"{kind:24}{row[0]:8}{row[1]:8}{row[2]:10}", end="")
        print("".join(f"{worst[kind][engine.name]:12.1e}" for engine in Engine))
    print(f"{small} of {count} differ by {AGREE} of z or of a thousandth of the forces")
    print(f"{len(wrong)} differ by {AGREE} of z or of the forces, or failed", *wrong[:20], sep="\n")
    return wrong


@pytest.mark.long
@pytest.mark.parametrize(
    ("kinds", "seed"), [(sets.KINDS, 7), (sets.HARD, 8)], ids=["common", "hard"]
)
def test_ten_thousand(capsys, kinds, seed):
    with capsys.disabled():
        assert not run_many(list(kinds), seed, 10_000)
