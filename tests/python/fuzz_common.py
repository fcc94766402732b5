# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Mutations of files, and the laws of everything that reads them.

A short fixed set of cases runs with the other tests. GRASPLESS_FUZZ_CASES=N runs N random ones a
test, as `make fuzz HOURS=1` does.
"""

import copy
import math
import os
import pathlib
import re
import time

from hypothesis import HealthCheck, settings
from hypothesis import strategies as st

from graspless import TaskError

ROOT = pathlib.Path(__file__).parents[2]
CASES = int(os.environ.get("GRASPLESS_FUZZ_CASES", "0"))
MAX_SECONDS = 20  # of processor time a case, whose budget is 0.2 s

fuzzed = settings(
    max_examples=CASES or 40,
    derandomize=not CASES,
    deadline=None,
    database=None,
    print_blob=True,
    suppress_health_check=list(HealthCheck),
)

ODD = [
    None, True, -1, 0, 1, 2**31, 2**63, 10**40, 1e-300, 1e-12, -1e-3, 1e4, 1e9, 1e300, math.nan,
    math.inf, -math.inf, "", "x", "0", "1e400", "\0", "\ud800", "é" * 300, "..", ".", "/dev/zero",
    "/etc", [], {}, [[]], [0, 0], [0, 0, 0], {"x": 0}, {"": None},
]  # fmt: skip
VALUES = st.one_of(
    st.sampled_from(ODD),
    st.integers(-3, 100),
    st.floats(-10, 10),
    st.floats(),
    st.text(max_size=6),
    st.lists(st.floats(-2, 2), max_size=4),
)


def places(value, path=()):
    """The paths of all values in nested lists and dictionaries, but of the longest lists."""
    items = value.items() if isinstance(value, dict) else enumerate(value[:50])
    for key, inner in items:
        yield (*path, key)
        if isinstance(inner, (dict, list)):
            yield from places(inner, (*path, key))


@st.composite
def edited(draw, documents):
    """A document with one to three values replaced, removed, renamed or repeated."""
    document = copy.deepcopy(draw(st.sampled_from(documents)))
    for _ in range(draw(st.integers(1, 3))):
        paths = list(places(document))
        if not paths:
            break
        *above, last = draw(st.sampled_from(paths))
        owner = document
        for key in above:
            owner = owner[key]
        how = draw(st.integers(0, 7))
        if how == 0:
            del owner[last]
        elif how == 1 and isinstance(owner, dict):
            owner[draw(st.text(max_size=6))] = owner.pop(last)
        elif how == 2 and isinstance(owner, list):
            owner.insert(last, copy.deepcopy(owner[last]))
        elif how == 3 and isinstance(owner[last], (int, float)):
            owner[last] *= draw(st.sampled_from([-1, 0, 0.5, 2, 10, 1e3, 1e-3, 1e6]))
        else:
            owner[last] = copy.deepcopy(draw(VALUES))  # a later edit must not change ODD
    return document


@st.composite
def spliced(draw, seeds, words):
    """Bytes of a file with one to four places cut out, repeated, or overwritten."""
    data = bytearray(draw(st.sampled_from(seeds)))
    for _ in range(draw(st.integers(1, 4))):
        start = draw(st.integers(0, len(data)))
        end = min(len(data), start + draw(st.integers(0, 12)))
        piece = draw(
            st.one_of(
                st.sampled_from(words),
                st.binary(max_size=4),
                st.just(bytes(data[start:end]) * draw(st.integers(0, 3))),
            )
        )
        data[start:end] = piece
    return bytes(data)


def refused_or(call):
    """The result of a call; None if it refused its input as the library promises."""
    start = time.process_time()
    try:
        return call()
    except TaskError as error:
        require_message(str(error))
        return None
    finally:
        assert time.process_time() - start < MAX_SECONDS


def require_message(text):
    """A message names no exception of Python: that would be a fault nobody thought of."""
    assert text.strip()
    assert not re.search(r"\b(?!TaskError)[A-Z]\w+(Error|Exception)\b", text), text
    assert "Traceback" not in text
