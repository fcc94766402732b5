# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Scratch: constant pace until graspless.time is there."""

from __future__ import annotations

import numpy as np

from ...timing import Trajectory


def time(plan):
    speeds = {"press": 0.1, "slide": 0.15, "lift": 0.2, "close": 0.3, "grasp": 0.3}
    times, seg, rows, q, X = [], [], [], [], []
    t = 0.0
    for k, s in enumerate(plan.segments):
        d = np.abs(np.diff(s.positions, axis=0)).max(axis=1)
        L = np.concatenate([[0], np.cumsum(d)])
        v = speeds.get(s.name, 0.6)
        T = max(L[-1] / v * 1.5, 0.3)
        n = 400
        tau = np.linspace(0, 1, n)
        sm = 3 * tau**2 - 2 * tau**3
        r = np.interp(sm * L[-1], L, np.arange(len(L)))
        times.append(t + tau * T); t += T + 1e-6
        seg.append(np.full(n, k)); rows.append(r)
        q.append(np.stack([np.interp(r, np.arange(len(L)), c) for c in s.positions.T], 1))
        X.append(s.object_poses[np.round(r).astype(int)])
    q = np.concatenate(q)
    return Trajectory(plan, plan.segments, np.concatenate(times), np.concatenate(seg), np.concatenate(rows),
        plan.joint_names, q, q * 0, q * 0, np.concatenate(X))
