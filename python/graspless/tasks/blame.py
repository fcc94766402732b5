# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Fields of a file that messages of the core are about."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from collections.abc import Mapping

    from ..errors import TaskError
    from .source import Location, Source

_OF_BODIES = {"X_WB": "pose"}  # field of what the core calls a part of a body
_BELOW = r"((?:\.\w+|\[\d+\])*):? (.*)"  # the rest of a name, and of the message


def blamed(source: Source, message: str, places: Mapping[str, Location]) -> TaskError:
    """Returns the error of a message of the core, at the field that the message names.

    `places` has the fields of what the core names first, and at "" that of all else.
    """
    found = {name: re.match(re.escape(name) + _BELOW, message, re.DOTALL) for name in places}
    name = max((name for name, match in found.items() if match), key=len, default="")
    match, place = found[name], places[name]
    for key in re.findall(r"\w+", match[1]) if match else ():
        below = (*place, int(key) if key.isdigit() else _OF_BODIES.get(key, key))
        if not source.look_up(below)[1]:
            break
        place = below
    value = re.escape(str(source.look_up(place)[0]))  # which the error shows by itself
    what = match[2] if match else message
    return source.error(place, re.sub(f"^'{value}'(?! and):? |, not {value}(?=:|$)", "", what))
