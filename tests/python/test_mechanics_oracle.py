# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Both engines against SciPy's HiGHS: a sample, and ten thousand contact sets (-m long)."""

import collections
import itertools

import numpy as np
import pytest

import mechanics_oracle as oracle
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


def difference(a, b):
    return 0 if a == b else abs(a - b) / max(1, abs(b))


def compare(seed, kind):
    """Differences of z by name; that of (5) must be none."""
    rng = np.random.default_rng(seed)
    contact_set, modes = oracle.contact_set(rng, kind)
    l = directions(rng)  # noqa: E741
    bounded = oracle.is_bounded(contact_set, modes)
    for engine in Engine:
        assert internal_force_is_bounded(contact_set, modes, engine=engine) == bounded, engine
    highs = oracle.max_stability(contact_set, modes, l)
    fast = max_stability(contact_set, modes, directions=l)
    reference = max_stability(contact_set, modes, directions=l, engine=Engine.reference)
    return {
        "fast": difference(fast.z, highs),
        "reference": difference(reference.z, highs),
        "each other": difference(fast.z, reference.z),
    }, highs


ILL_POSED = pytest.mark.xfail(
    strict=False, reason="fast: about one in fifty is wrong where contacts are 1e-6 off a line"
)


@pytest.mark.parametrize(
    "kind",
    [pytest.param(k, marks=ILL_POSED if k == "nearly collinear" else ()) for k in oracle.KINDS],
)
def test_engines_agree_with_highs(kind):
    for seed in range(6):
        found, _ = compare((seed, len(kind)), kind)
        assert max(found.values()) < AGREE, (seed, found)


def test_best_modes_are_the_best_of_all():
    for seed in range(12):
        rng = np.random.default_rng((99, seed))
        contact_set, _ = oracle.contact_set(rng, list(oracle.KINDS)[seed % 6])
        l = ALL[:12]  # noqa: E741
        values = [
            oracle.max_stability(contact_set, modes, l)
            for modes in itertools.product(FingerMode, repeat=len(contact_set.fingers))
            if oracle.is_bounded(contact_set, modes)
        ]
        best = max(values, default=0)
        for engine in Engine:
            found = best_control_modes(contact_set, directions=l, engine=engine)
            assert bool(found) == (best > AGREE)
            if found:
                assert found.stability.z == pytest.approx(best, rel=AGREE, abs=AGREE)
                assert oracle.is_bounded(contact_set, found.modes)


@pytest.mark.long
def test_ten_thousand(capsys):
    """Some minutes. Prints what was found."""
    worst = collections.defaultdict(lambda: collections.defaultdict(float))
    counts = collections.defaultdict(collections.Counter)
    wrong = []
    kinds = list(oracle.KINDS)
    for i in range(10_000):
        kind = kinds[i % len(kinds)]
        try:
            found, z = compare((7, i), kind)
        except (AssertionError, RuntimeError) as error:
            wrong.append((i, kind, f"{type(error).__name__}: {error}"))
            continue
        counts[kind]["none" if z == 0 else "unbounded" if np.isinf(z) else "stable"] += 1
        for name, value in found.items():
            worst[kind][name] = max(worst[kind][name], value)
        if max(found.values()) >= AGREE:
            wrong.append((i, kind, found))
    with capsys.disabled():
        print(f"\n{'kind':18}{'stable':>8}{'none':>8}{'unbounded':>10}", end="")
        print("".join(f"{name:>12}" for name in ("fast", "reference", "each other")))
        for kind in kinds:
            row = [counts[kind][name] for name in ("stable", "none", "unbounded")]
            print(f"{kind:18}{row[0]:8}{row[1]:8}{row[2]:10}", end="")
            print("".join(f"{worst[kind][n]:12.1e}" for n in ("fast", "reference", "each other")))
        print(f"{len(wrong)} of 10000 differ by {AGREE} or more", *wrong[:20], sep="\n")
    assert {kind for _, kind, _ in wrong} <= {"nearly collinear"}
    assert len(wrong) < 30  # known to fall short; see ILL_POSED
