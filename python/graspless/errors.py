# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The one error of files that people write."""

from __future__ import annotations


class TaskError(ValueError):
    """A task file, a file it names, or a plan file is not as it may be.

    The message has one line a fault, ``file:line: field: value: what it may be``.
    """
