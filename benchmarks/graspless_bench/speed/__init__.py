# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Times of every planner's queries beside another build's, and the rooms they are spent in."""
