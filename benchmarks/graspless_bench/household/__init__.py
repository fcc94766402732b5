# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Objects of a folder: seen by a rendered camera, picked up, and lifted in MuJoCo."""
