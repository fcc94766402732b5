# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading of the stages of a chain.

A field of the stage itself takes precedence, then one of the file that it names, then one that
the chain gives to all stages.

"""

from __future__ import annotations

from pathlib import Path
from typing import TYPE_CHECKING, Any

from ... import _data
from ...errors import TaskError, suggestion
from ...files import absence
from ...kinds import KINDS, part
from ..reading import read_yaml
from ..source import Source
from ..units import warn_of_units
from .joints import require_held
from .model import SHARED, ChainTask
from .stage import Stage, StageSource
from .start import hold_place

if TYPE_CHECKING:
    from ..source import Location

STAGES = tuple(kind for kind in KINDS if kind != "chain")
FILES = ("urdf", "srdf", "directory", "packages", "hand", "cloud", "scene", "file")


def read_stages(chain: ChainTask, source: Source, directory: Path) -> list[Stage]:
    """Returns the stages of a task file, with the content of all files that they name.

    Parameters
    ----------
    chain : ChainTask
        Task read from `source`.
    source : Source
        Source of the task, for error messages.
    directory : Path
        Folder to which its paths are relative.
    """
    named = [_merged(source, i, directory) for i in range(len(chain.stages))]
    _require_names(named, source)
    require_held([(stage.name, _kind(stage), stage) for stage in named])
    kinds = {_kind(stage) for stage in named} - {"carry"}  # it takes what the stage before it has
    taken = {key for kind in kinds for key in part("tasks", kind).Fields.model_fields}
    for key in SHARED:
        if getattr(chain, key) is not None and key not in taken:
            raise source.error((key,), "no stage of this chain has such a field")
    stages = [_resolved(stage, i, directory) for i, stage in enumerate(named)]
    _require_bare(stages)
    return stages


def stages_of_plan(chain: ChainTask, source: Source) -> list[Stage]:
    """Returns the stages of a chain in a plan file."""
    found = []
    for i, document in enumerate(chain.stages):
        fields = {key: value for key, value in document.items() if key != "name"}
        stage = StageSource(source.file, fields, parts=[(source, ("stages", i))])
        kind = part("tasks", _kind(stage))
        validated = stage.validate(kind.Fields)
        kind.require_resolved(validated, stage)
        found.append(Stage(stage.name, validated, stage, stage))
    return found


def _require_bare(stages: list[Stage]) -> None:
    """Raises TaskError if a carried object lies, or is put down, on something with a padding."""
    around: list[Any] = []
    for stage in stages:
        own = getattr(stage.fields, "obstacles", None)
        around = around if own is None else own
        if stage.fields.kind != "carry":
            continue
        places: dict[Location, str] = {
            ("rests_on", i): name for i, name in enumerate(stage.fields.rests_on)
        }
        if stage.fields.place is not None:
            places["place", "on"] = stage.fields.place.on
        for place, name in places.items():
            if any(body.name == name and body.padding > 0 for body in around):
                what = "the object stands on it, but it has a padding: should have none"
                raise stage.source.error(place, f"{name}: {what} in the obstacles of this stage")


def _merged(source: Source, index: int, directory: Path) -> StageSource:
    """Returns a stage whose missing fields come from its file and from the chain."""
    place = ("stages", index)
    own = dict(source.data["stages"][index])
    name = own.pop("name", None)
    if name is not None and not isinstance(name, str):
        raise source.error((*place, "name"), "should be text")
    parts: list[tuple[Source, Location]] = [(source, place)]
    given: dict[str, Any] = {}
    if "file" in own:
        read = _read(own.pop("file"), source, place, directory)
        parts.append((read, ()))
        given = absolute(read.data, Path(read.file).parent)
        given.pop("budget", None)  # the chain's stands for all
    stage = StageSource(source.file, {**given, **own}, {}, source.is_trusted, parts)
    if "budget" in own:
        raise source.error((*place, "budget"), "must not be given: all stages share the chain's")
    kind = part("tasks", _kind(stage))
    known = ("obstacles",) if stage.data["kind"] == "carry" else kind.Fields.model_fields
    shared = {
        key: value
        for key, value in source.data.items()
        if key in SHARED and key in known and value is not None
    }
    _require_one_object(stage, shared)
    stage.data = {**shared, **stage.data}
    stage.parts.append((source, ()))
    return stage


def _read(name: Any, source: Source, place: Location, directory: Path) -> Source:
    field = (*place, "file")
    if not isinstance(name, str):
        raise source.error(field, "should be the path of a task file")
    if not (path := directory / name).is_file():
        raise source.error(field, absence(path))
    return read_yaml(path.resolve())


def _kind(stage: StageSource) -> str:
    name = stage.data.get("kind")
    choices = " or ".join(f"'{kind}'" for kind in STAGES)
    if name is None:
        raise TaskError(f"{stage.where(('kind',))}missing; should be {choices}")
    if name not in STAGES:
        nested = " (a chain holds no chain)" if name == "chain" else suggestion(name, STAGES)
        raise stage.error(("kind",), f"should be {choices}{nested}")
    return str(name)


def _require_names(stages: list[StageSource], source: Source) -> None:
    """Raises TaskError if a stage is given the name of another one."""
    names = [stage.name for stage in stages]
    for i, name in enumerate(names):
        if "name" in source.data["stages"][i] and names.count(name) > 1:
            raise source.error(("stages", i, "name"), "another stage has this name")


def _require_one_object(stage: StageSource, shared: dict[str, Any]) -> None:
    """Raises TaskError if a stage has another object than the chain. Adds name and mass."""
    own, common = stage.data.get("object"), shared.get("object")
    if not isinstance(own, dict) or not isinstance(common, dict):
        return
    fields = part("tasks", _kind(stage)).Fields.model_fields["object"].annotation.model_fields
    named = {"name": common.get("name", "object")}
    if "mass" in common and "mass" in fields:
        named["mass"] = common["mass"]
    for key, value in named.items():
        if own.setdefault(key, value) != value:
            raise stage.error(("object", key), f"the chain's object has {value}")


def absolute(value: Any, directory: Path, key: str = "") -> Any:
    """Returns a task or a robot with absolute paths; names of robots stay."""
    if isinstance(value, dict) and key != "xacro_args":
        inner = key if key == "packages" else ""
        known: Any = {"hand": ""} if key else {}  # below the task, `hand` is a group
        if "gripper" in value:
            known["arm"] = "urdf"  # elsewhere it is a group
        return {
            name: absolute(v, directory, inner or known.get(name, name))
            for name, v in value.items()
        }
    if isinstance(value, list):
        return [absolute(item, directory, key) for item in value]
    if key not in FILES or not isinstance(value, str):
        return value
    path = directory / value
    is_name = key in ("urdf", "file") and not path.is_file() and _data.robot(value) is not None
    return value if is_name else str(path)


def _resolved(stage: StageSource, index: int, directory: Path) -> Stage:
    kind = part("tasks", _kind(stage))
    if index > 0:
        hold_place(stage)
    named = stage.validate(kind.Fields)
    warn_of_units(named, stage)
    fields, other = kind.resolve(named, stage, directory)
    return Stage(stage.name, fields, stage, other)
