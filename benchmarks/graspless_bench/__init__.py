# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""The papers' experiments, repeated: `graspless bench` in a checkout."""
