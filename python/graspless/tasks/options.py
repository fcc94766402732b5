# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Models of options, made from the tables in the C++ headers."""

from __future__ import annotations

from typing import TYPE_CHECKING, Annotated, Any, Literal, TypeVar

from pydantic import AfterValidator, BaseModel, Field, create_model

if TYPE_CHECKING:
    from collections.abc import Callable, Mapping

Model = TypeVar("Model", bound=BaseModel)


def described_by(
    core: Any, constants: Mapping[str, Any] | None = None
) -> Callable[[type[Model]], type[Model]]:
    """Adds every field of a struct of the core to a model, in the order of its table.

    Parameters
    ----------
    core
        The struct, with its table `fields()`. Fields that the model defines itself stay.
    constants
        Former options. They are read when they have the value that is now built in.
    """

    def described(model: type[Model]) -> type[Model]:
        default = core()
        own = {name: (info.annotation, info) for name, info in model.model_fields.items()}
        fields: dict[str, Any] = {
            field.name: own.get(field.name) or _optional(field, getattr(default, field.name))
            for field in core.fields()
        }
        fields |= {name: _constant(value) for name, value in (constants or {}).items()}
        create: Any = create_model
        made: type[Model] = create(
            model.__name__,
            __base__=model.__bases__,
            __module__=model.__module__,
            __doc__=model.__doc__,
            **fields,
        )
        return made

    return described


def _optional(field: Any, default: Any) -> tuple[Any, Any]:
    kind: Any = type(next(iter(field.bounds.values()), default))
    if kind is tuple:
        kind = list[str]
    if kind is dict:
        kind = dict[str, Annotated[int, Field(ge=0, lt=2**63)]]
    if hasattr(kind, "__members__"):
        names: Any = Literal
        kind = names[tuple(kind.__members__)]
    text = f"{field.text[:-1]} [{field.unit}]." if field.unit else field.text
    return Annotated[kind, Field(**field.bounds)] | None, Field(default=None, description=text)


def _constant(value: Any) -> tuple[Any, Any]:
    def check(given: Any) -> Any:
        if given != value:
            raise ValueError(f"is no longer an option; it is always {value}")
        return given

    kind: Any = Annotated[
        type(value), AfterValidator(check), Field(json_schema_extra={"const": value})
    ]
    text = f"Former option, now always {value}."
    return kind | None, Field(default=None, exclude=True, description=text)
