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

from .statistics import wilson

if TYPE_CHECKING:
    from collections.abc import Sequence
    from pathlib import Path

    from .summary import Row

COLORS = ["#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"]
STYLE = {"font.size": 9, "axes.spines.top": False, "axes.spines.right": False}


@dataclasses.dataclass
class Panel:
    """Curves side by side, and points of the paper's."""

    title: str
    curves: Sequence[tuple[str, Row]]  # a name for the legend, and what summary calls a curve
    paper: Sequence[tuple[float, float, str, int]] = ()  # time [s], rate [%], text, index of curve


def write_success(panels: Sequence[Panel], limit: float, path: Path) -> None:
    """Success over time; `limit` [s] is where the curves end."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(4.6 * len(panels), 3.5), layout="constrained")
        axes = figure.subplots(1, len(panels), sharey=True, squeeze=False)[0]
        for ax, panel in zip(axes, panels, strict=True):
            _draw_success(ax, panel, limit)
        axes[0].set_ylabel("solved [%]")
        figure.savefig(path, dpi=110)


def _draw_success(ax: Any, panel: Panel, limit: float) -> None:
    for color, (name, curve) in zip(COLORS, panel.curves, strict=False):
        times = np.array(curve["times_ms"]) / 1000
        runs = curve["runs"]
        counts = np.arange(len(times) + 1)
        x = np.concatenate([[1e-9], times, [limit]])
        rate = 100 * np.append(counts, len(times)) / runs
        low, high = np.array([wilson(int(k), runs) for k in np.append(counts, len(times))]).T * 100
        ax.step(x, rate, where="post", color=color, label=name, linewidth=1.5)
        ax.fill_between(x, low, high, step="post", color=color, alpha=0.15, linewidth=0)
    for time, rate, text, index in panel.paper:
        ax.plot(time, rate, "D", color=COLORS[index], markeredgecolor="black", markersize=5)
        ax.annotate(
            text, (time, rate), (-6, 0), textcoords="offset points", ha="right", va="center", fontsize=7
        )
    last = max([limit, *(1.3 * p[0] for p in panel.paper)])
    ax.set(title=panel.title, xscale="log", xlim=(3e-4, last), ylim=(0, 102), xlabel="time [s]")
    ax.xaxis.set_major_formatter(FuncFormatter(lambda t, _: f"{t:g}"))
    ax.xaxis.set_minor_locator(NullLocator())
    ax.grid(alpha=0.3)
    ax.legend(fontsize=7.5, loc="center left", bbox_to_anchor=(0.0, 0.5) if panel.paper else None)


def write_bars(groups: Sequence[tuple[str, Sequence[tuple[str, Sequence[Row]]]]], path: Path) -> None:
    """Medians with the 90th percentile above, for each group: (title, [(series, rows)])."""
    with matplotlib.rc_context(STYLE):
        figure = Figure(figsize=(9.2, 3.2), layout="constrained")
        axes = figure.subplots(1, len(groups), sharey=True, squeeze=False)[0]
        for ax, (title, series) in zip(axes, groups, strict=True):
            for i, (name, rows) in enumerate(series):
                _draw_bars(ax, name, rows, (i - (len(series) - 1) / 2) * 0.8 / len(series), 0.7 / len(series), COLORS[i])
            names = [row["name"] for row in series[0][1]]
            ax.set_xticks(range(len(names)), names)
            ax.set_title(title)
            ax.grid(axis="y", alpha=0.3)
            ax.set_axisbelow(True)
        axes[0].set_ylabel("time to a plan [ms]")
        axes[-1].legend(fontsize=7.5, title="median; line to 90 %", title_fontsize=7.5)
        figure.savefig(path, dpi=110)


def _draw_bars(
    ax: Any, name: str, rows: Sequence[Row], offset: float, width: float, color: str
) -> None:
    x = np.arange(len(rows)) + offset
    median = np.array([row["p50_ms"] or np.nan for row in rows], dtype=float)
    p90 = np.array([row["p90_ms"] or np.nan for row in rows], dtype=float)
    ax.bar(x, median, width, color=color, label=name)
    ax.vlines(x, median, p90, color="black", linewidth=0.8)
    ax.plot(x, p90, "_", color="black", markersize=6)


def write_roots(series: Sequence[tuple[str, Sequence[Row]]], path: Path) -> None:
    """Mean time and success over N*: Fig. 12. Rows are named by N*."""
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
