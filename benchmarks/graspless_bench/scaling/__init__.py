# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Growth of times with the size of a problem, and gain by threads and workers."""
