# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Proposal for a robot: what was found, why, and how sure it is."""

from __future__ import annotations

import re
import textwrap
from dataclasses import dataclass, field
from html import escape
from pathlib import Path
from typing import TYPE_CHECKING, Any

import yaml

from .. import files

if TYPE_CHECKING:
    from collections.abc import Mapping

    from matplotlib.figure import Figure

    from .._core.robot import Robot

WIDTH = 44  # letters of a column of a table
SHOWN = ("fingertip", "finger_model", "pitch")  # fields of the hand in a summary


@dataclass(frozen=True)
class Finding:
    """A value that was found.

    Attributes
    ----------
    field : str
        Its place: a part of the SRDF, a field of the hand, or a link of the URDF.
    value : str
        As it is printed.
    reason : str
    is_sure : bool
        False if a person should look at it.
    """

    field: str
    value: str
    reason: str
    is_sure: bool = True


@dataclass(frozen=True)
class Proposal:
    """Description of a robot, proposed from its URDF.

    Attributes
    ----------
    name : str
        Name of the files, in which _ replaces what is not a letter, a digit, a dot or a dash.
    robot : Robot
        The robot with the proposed frames, groups and states.
    findings : list of Finding
    urdf : str
        URDF with the frames F and H added as fixed links.
    srdf : str
        Groups, states, and pairs of links that are never tested.
    hand : dict
        Fields of the hand for slides; empty unless the hand has two fingers and an arm.
    clasp : dict
        Fields of the hand for clasps; empty if none could be proposed.
    hand_links : tuple of str
        Links of palm and fingers.
    largest_gap, smallest_gap : float
        Distance between the ends of two fingers, open and closed [m]; 0 for other hands.
    """

    name: str
    robot: Robot
    findings: list[Finding]
    urdf: str
    srdf: str
    hand: dict[str, Any] = field(default_factory=dict)
    clasp: dict[str, Any] = field(default_factory=dict)
    hand_links: tuple[str, ...] = ()
    largest_gap: float = 0.0
    smallest_gap: float = 0.0

    def __repr__(self) -> str:
        """Name and counts; `print` shows the findings, as `graspless robot inspect` does."""
        found = f"{len(self.findings)} findings, {len(self.unsure)} unsure"
        return f"<proposal for '{self.name}': {found}>"

    def __str__(self) -> str:
        fields = max(len(finding.field) for finding in self.findings)
        rows = [f"{'field':{fields}}  {'value':{WIDTH}}  {'reason':{WIDTH}}"]
        for finding in self.findings:
            rows += _rows(finding, fields)
        unsure = ", ".join(finding.field for finding in self.unsure)
        rows.append(f"unsure, please check: {unsure}" if unsure else "nothing is unsure")
        return "\n".join(line.rstrip() for line in rows)

    def _repr_html_(self) -> str:
        return f"<pre>{escape(str(self))}</pre>"

    @property
    def unsure(self) -> list[Finding]:
        """Findings that a person should look at."""
        return [finding for finding in self.findings if not finding.is_sure]

    def summary(self, kind: str = "slide", given: Mapping[str, Any] | None = None) -> str:
        """Returns what is used of the proposal in one line.

        Parameters
        ----------
        kind : str
            Kind of the task: slide or clasp.
        given : mapping, optional
            Fields of the hand that replace the proposed ones.
        """
        fields = self.clasp if kind == "clasp" else self.hand
        used = {k for k, value in fields.items() if (given or {}).get(k, value) == value}
        values = {f.field.removeprefix("state "): f.value for f in self.findings}
        shown = {"arm": f"arm of {len(self.robot.group(fields['arm']))} joints"} if fields else {}
        if kind == "clasp":
            shown["frame"] = f"palm {fields.get('frame')}"
            thumb = fields["thumb"][-1]["link"] if fields else ""
            names = ", ".join(fields.get("fingers", ()))
            shown["fingers"] = f"curves of {names} against {thumb}"
        else:
            shown |= {name: f"{name} {fields[name]}" for name in SHOWN if name in fields}
            shown |= {name: f"{name} {values[name]}" for name in ("open", "closed") if name in used}
        parts = "; ".join(text for name, text in shown.items() if name in used)
        return f"{parts or 'pairs of links'}; graspless robot inspect shows and writes it"

    def refusal(self, kind: str) -> str:
        """Returns why there is no hand for a kind of task, in one line."""
        if not self.hand and not self.clasp:
            return "no joint carries the hand; join it to an arm"
        needed = "two fingers" if kind == "slide" else "fingers that close against a thumb"
        return f"no hand for this task was found: it needs {needed}"

    def files(self) -> dict[str, str]:
        """Returns the text of each file, by its name."""
        from .files import with_absolute_meshes

        name = re.sub(r"[^\w.-]", "_", self.name).lstrip(".") or "robot"  # a URDF may give any
        texts = {
            f"{name}.urdf": with_absolute_meshes(self.robot, self.urdf),
            f"{name}.srdf": self.srdf,
        }
        for end, fields in (("hand", self.hand), ("clasp", self.clasp)):
            if fields:
                texts[f"{name}.{end}.yaml"] = _as_yaml(fields)
        return texts

    def write(self, folder: str | Path) -> list[Path]:
        """Writes NAME.urdf, NAME.srdf, and NAME.hand.yaml or NAME.clasp.yaml or both.

        Parameters
        ----------
        folder : str or Path
            Made if it does not exist. Files of the same names are replaced.

        Returns
        -------
        list of Path
            The files.

        Raises
        ------
        TaskError
            A file cannot be written.
        """
        made, texts = Path(folder), self.files()
        files.make_folder(made)
        for name, text in texts.items():
            files.write(made / name, text)
        return [made / name for name in texts]

    def plot(self) -> Figure:
        """Returns the picture of the hand, open and closed, and of the robot at home."""
        from ..view import hand

        return hand.draw(self)

    def serve(self, port: int = 8080) -> None:
        """Serves a viewer on this machine until Ctrl-C: a slider per joint, a button per state.

        Parameters
        ----------
        port : int
            Port on localhost, in [1, 65535].

        Raises
        ------
        TaskError
            The port cannot be used, or a package of `graspless[view]` is missing.
        """
        from ..view import serve_proposal

        serve_proposal(self, port)

    def to_dict(self) -> dict[str, Any]:
        """Returns the proposal in plain types."""
        found = [
            {"field": f.field, "value": f.value, "reason": f.reason, "sure": f.is_sure}
            for f in self.findings
        ]
        return {"name": self.name, "findings": found, "hand": self.hand, "clasp": self.clasp}


def _as_yaml(fields: dict[str, Any]) -> str:
    head = "# Proposed by `graspless robot inspect`; docs/task-files.md explains every field.\n"
    return head + yaml.safe_dump(fields, sort_keys=False, default_flow_style=None)


def _rows(finding: Finding, fields: int) -> list[str]:
    values = textwrap.wrap(finding.value, WIDTH) or [""]
    reason = finding.reason if finding.is_sure else f"UNSURE: {finding.reason}"
    reasons = textwrap.wrap(reason, WIDTH) or [""]
    count = max(len(values), len(reasons))
    values += [""] * (count - len(values))
    reasons += [""] * (count - len(reasons))
    names = [finding.field] + [""] * (count - 1)
    return [
        f"{name:{fields}}  {value:{WIDTH}}  {why:{WIDTH}}"
        for name, value, why in zip(names, values, reasons, strict=True)
    ]
