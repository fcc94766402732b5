# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Success over time, with Wilson 95 % bands, and times by table and object."""

from __future__ import annotations

import dataclasses
from typing import TYPE_CHECKING, Any

import matplotlib
import numpy as np
from matplotlib.figure import Figure
from matplotlib.ticker import FuncFormatter, NullLocator

from ..statistics import wilson
from ..style import COLORS, STYLE

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from ..machine import Row


@dataclasses.dataclass
class Panel:
    """Panel of a picture: curves, and points from the paper."""

    title: str
    limit: float  # of a query [s]: where the curves end
    curves: Sequence[tuple[str, Row]]  # a name for the legend, and what summary calls a curve
    paper: Sequence[tuple[float, float, int]] = ()  # time [s], rate [%], index of the curve


def write_success(panels: Sequence[Panel], path: Path) -> None:
    """Draws success over time."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(4.6 * len(panels), 4), layout="constrained")
        axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
        for ax, panel in zip(axes, panels, strict=True):
            _draw_success(ax, panel)
        axes[0].set_ylabel("solved [%]")
        figure.savefig(path, dpi=110)


def _draw_success(ax: Any, panel: Panel) -> None:
    for color, (name, curve) in zip(COLORS, panel.curves, strict=False):
        times = np.array(curve["times_ms"]) / 1000
        runs = curve["runs"]
        counts = np.arange(len(times) + 1)
        x = np.concatenate([[1e-9], times, [panel.limit]])
        rate = 100 * np.append(counts, len(times)) / runs
        low, high = np.array([wilson(int(k), runs) for k in np.append(counts, len(times))]).T * 100
        ax.step(x, rate, where="post", color=color, label=name, linewidth=1.5)
        ax.fill_between(x, low, high, step="post", color=color, alpha=0.12, linewidth=0)
    for time, rate, index in panel.paper:
        ax.plot(time, rate, "D", color=COLORS[index], markeredgecolor="black", markersize=5)
    if panel.paper:
        ax.plot([], [], "D", color="white", markeredgecolor="black", label="the paper")
    slowest = max(_end(curve, panel.limit) for _, curve in panel.curves)
    last = max([slowest, *(1.8 * p[0] for p in panel.paper)])
    ax.set(title=panel.title, xscale="log", xlim=(3e-4, last), ylim=(0, 102), xlabel="time")
    ax.xaxis.set_major_formatter(FuncFormatter(_duration))
    ax.xaxis.set_minor_locator(NullLocator())
    ax.grid(alpha=0.3)
    ax.legend(fontsize=7.5, loc="upper center", bbox_to_anchor=(0.5, -0.16), ncols=2, frameon=False)


def _end(curve: Row, limit: float) -> float:
    """Returns the end of a curve in the picture [s], some time after the last solved run."""
    times = curve["times_ms"]
    return min(limit, 3 * times[-1] / 1000) if len(times) == curve["runs"] > 0 else limit


def _duration(seconds: float, _: object = None) -> str:
    return f"{seconds:g} s" if seconds >= 0.999 else f"{1000 * seconds:g} ms"


Series = tuple[str, "Sequence[Row]"]


def write_medians(groups: Sequence[tuple[str, Sequence[Series]]], path: Path) -> None:
    """Draws medians with a line to the 90th percentile, per group (title, [(series, rows)])."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9.2, 3.2), layout="constrained")
        axes = figure.subplots(1, len(groups), sharey=True, squeeze=False)[0]
        for ax, (title, series) in zip(axes, groups, strict=True):
            for i, (name, rows) in enumerate(series):
                _draw_medians(ax, name, rows, 0.2 * (i - (len(series) - 1) / 2), COLORS[i])
            names = [row["name"] for row in series[0][1]]
            ax.set_xticks(range(len(names)), names)
            ax.set(title=title, yscale="log", xlim=(-0.5, len(names) - 0.5))
            ax.yaxis.set_major_formatter(FuncFormatter(lambda ms, _: _duration(ms / 1000)))
            ax.grid(axis="y", alpha=0.3)
        axes[0].set_ylabel("time to a plan")
        axes[-1].legend(fontsize=7.5, title="median, line to 90 %", title_fontsize=7.5)
        figure.savefig(path, dpi=110)


def _draw_medians(ax: Any, name: str, rows: Sequence[Row], offset: float, color: str) -> None:
    x = np.arange(len(rows)) + offset
    median, p90 = (
        np.array([np.nan if row[key] is None else row[key] for row in rows])
        for key in ("p50_ms", "p90_ms")
    )
    ax.plot(x, median, "o", color=color, label=name)
    ax.vlines(x, median, p90, color=color, linewidth=1)
    ax.plot(x, p90, "_", color=color, markersize=8)


def write_roots(series: Sequence[tuple[str, Sequence[Row]]], path: Path) -> None:
    """Draws Fig. 12: mean time and success over N*. Rows are named by N*."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9.2, 3.2), layout="constrained")
        left, right = figure.subplots(1, 2)
        for color, (name, rows) in zip(COLORS, series, strict=False):
            scales = [float(row["name"]) for row in rows]
            left.plot(scales, [row["mean_ms"] for row in rows], "o-", color=color, label=name)
            rates = [100 * row["solved"] / row["runs"] for row in rows]
            bands = np.array([wilson(row["solved"], row["runs"]) for row in rows]).T * 100
            right.plot(scales, rates, "o-", color=color, label=name)
            right.fill_between(scales, *bands, color=color, alpha=0.15, linewidth=0)
        left.set(xscale="log", yscale="log", xlabel="N*", ylabel="mean time [ms]")
        right.set(xscale="log", ylim=(0, 102), xlabel="N*", ylabel="solved in time [%]")
        for ax in (left, right):
            ax.grid(alpha=0.3)
            ax.legend(fontsize=7.5)
        figure.savefig(path, dpi=110)
