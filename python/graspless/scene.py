# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A robot among obstacles and objects, and its collision checks."""

from ._core.scene import (
    Doubt,
    EdgeCertificate,
    Scene,
    Verdict,
    sample_contacts,
)

__all__ = [
    "EdgeCertificate",
    "Doubt",
    "Scene",
    "Verdict",
    "sample_contacts",
]


def __dir__() -> list[str]:
    return __all__
