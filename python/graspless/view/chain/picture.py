# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Picture of a chain: those of its stages below each other."""

from __future__ import annotations

import io
from typing import TYPE_CHECKING

from ...kinds import part
from . import stages_of

if TYPE_CHECKING:
    from ...plans.chain import Plan


def draw(plan: Plan) -> bytes:
    """Returns the picture as the bytes of a PNG file."""
    from PIL import Image  # matplotlib needs it too

    drawn = [part("view", stage.kind).draw(stage) for _, stage in stages_of(plan)]
    pictures = [Image.open(io.BytesIO(picture)).convert("RGB") for picture in drawn]
    width = max(picture.width for picture in pictures)
    page = Image.new("RGB", (width, sum(picture.height for picture in pictures)), "white")
    top = 0
    for picture in pictures:
        page.paste(picture, (0, top))
        top += picture.height
    written = io.BytesIO()
    page.save(written, "png")
    return written.getvalue()
