# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Numbers as text has them."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

import numpy as np

if TYPE_CHECKING:
    from numpy.typing import ArrayLike


def plain(values: ArrayLike) -> Any:
    """Nested lists of plain floats, none of them -0.0."""
    return (np.asarray(values, dtype=float) + 0.0).tolist()
