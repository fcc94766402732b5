# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""python -m graspless."""

import sys

from .cli import main

if __name__ == "__main__":
    sys.exit(main())
