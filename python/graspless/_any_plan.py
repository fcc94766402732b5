# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Base of the plans of all kinds: their task, their file, their pictures."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, ClassVar, TypeVar

from . import files, view

if TYPE_CHECKING:
    from pathlib import Path

    from matplotlib.figure import Figure

    from . import planning
    from ._plan import Plan
    from .frames import Matrix
    from .proving.proof import Proof
    from .scene import EdgeCertificate
    from .tasks import Task

Self = TypeVar("Self", bound="AnyPlan")


class AnyPlan:
    """Base of slide.Plan, pinch.Plan, fingertip.Plan, clasp.Plan, carry.Plan and chain.Plan.

    False unless solved. Two plans are equal if their files are. They may be copied and pickled, not
    hashed. Numbers are those of the file: a plan that is saved and loaded is equal, bit by bit. To
    change a plan, assign to its attributes: arrays are copies, and a change inside of any other
    attribute, such as `plan.statistics.iterations = 0`, may not reach the file.
    """

    kind: ClassVar[str]
    """Planner that made it: slide, pinch, fingertip, clasp or carry; chain: one per stage."""

    proof: Proof | None = None
    """Trials in the physics engine, if it was planned with `prove`. `check` reports a fault if the
    plan was changed since."""

    _planner: ClassVar[Any]  # its own plan() and check()
    _task: Any = None
    _document: dict[str, Any] | None = None  # the file's fields, once asked for
    _rows: Matrix | None = None  # of all poses in the file, until one is assigned

    @property
    def task(self) -> Task[Any, Any, Any]:
        """Task that the plan was made for."""
        if self._task is None:
            raise AttributeError("a plan that no planner made has no task")
        task: Task[Any, Any, Any] = self._task
        return task

    @property
    def seed(self) -> int:
        """Seed of all randomness."""
        return self.task.seed

    def to_json(self) -> str:
        """Returns the text of the plan file, which `load_plan(io.StringIO(text))` reads.

        Raises
        ------
        TaskError
            The plan was made for a problem that no task file can state.
        """
        from .plan_files.text import text_of

        return text_of(self._any)

    def save(self, path: str | Path) -> None:
        """Writes the plan file, whole or not at all.

        Parameters
        ----------
        path : str or Path
            Name of the file, by custom .json.

        Raises
        ------
        TaskError
            The file cannot be written, or the plan was made for a problem that no task file can
            state.
        """
        files.write(path, self.to_json())

    def plot(self) -> Figure:
        """Returns the picture of the plan as a figure of matplotlib.

        Raises
        ------
        TaskError
            A solved plan has no rows to draw, or a package of `graspless[view]` is missing.
        """
        return view.figure(self._any)

    def show(self) -> None:
        """Shows the replay: inline in a notebook, otherwise in the web browser."""
        view.show(self._any)

    def _repr_html_(self) -> str:
        return view.html(self._any)

    @property
    def _any(self) -> Plan:
        plan: Any = self  # its kind has what is missing here
        return plan  # type: ignore[no-any-return]

    def __repr__(self) -> str:
        plan = self._any
        rows = ", ".join(f"{segment.name} {len(segment)}" for segment in plan.segments if plan)
        proof = "" if self.proof is None else f"; {self.proof}"
        return f"<{self.kind} plan, {plan.status}: {rows or plan.reason}{proof}>"

    def __setattr__(self, name: str, value: Any) -> None:
        super().__setattr__(name, value)
        if name not in ("_task", "_document", "_rows", "proof"):
            super().__setattr__("_document", None)
            if self._rows is not None:
                from .plan_files.table import posed, table

                if name in posed(table(self.kind)):
                    super().__setattr__("_rows", None)

    def __eq__(self, other: object) -> bool:
        if self is other or type(self) is not type(other):
            return self is other
        assert isinstance(other, AnyPlan)
        if (self._fields(), self.proof) != (other._fields(), other.proof):
            return False
        return bool(self._task == other._task)

    __hash__ = None  # type: ignore[assignment]

    def __copy__(self: Self) -> Self:
        copy = self._made(self._fields(), self._task)
        copy.proof = self.proof
        return copy

    def __deepcopy__(self: Self, memo: Any) -> Self:
        return self.__copy__()

    def __reduce__(self) -> Any:
        from .plan_files.text import document_of

        return type(self)._of_document, (document_of(self._any), "pickled plan: task")

    @classmethod
    def _of_document(
        cls: type[Self], document: dict[str, Any], where: str, fields: Any = None
    ) -> Self:
        """Returns the plan of a valid document; error messages call its task `where`.

        `fields` are those of its task, if they are known.
        """
        from .plan_files.table import HEAD
        from .proving.proof import Proof
        from .tasks import task_from_dict

        own = {key: value for key, value in document.items() if key not in HEAD or key == "stats"}
        plan = cls._made(own, task_from_dict(document["task"], where, fields=fields))
        if document.get("proof") is not None:
            plan.proof = Proof(**document["proof"])
        return plan

    def _fields(self) -> dict[str, Any]:
        """Returns the fields of the plan file without head, proof and task, in plain types."""
        if self._document is None:
            from .plan_files.table import fields_of, table

            self._document = fields_of(self, table(self.kind), known=self._rows)
        return self._document

    @classmethod
    def _made(cls: type[Self], fields: dict[str, Any], task: Any) -> Self:
        """Returns the plan of a plan file's fields."""
        from .plan_files.table import fill, table

        plan = cls()
        plan._rows = fill(plan, fields, table(cls.kind))
        plan._task, plan._document = task, fields
        return plan

    @classmethod
    def _of(cls: type[Self], found: Any, task: Any) -> Self:
        """Returns the planner's result with the numbers of the file."""
        from .plan_files.table import adopt, table

        plan = cls()
        plan._rows, plan._task = adopt(plan, found, table(cls.kind)), task
        return plan

    @classmethod
    def _of_changed(cls: type[Self], found: Any, task: Any, changes: dict[str, Any]) -> Self:
        """Returns the same where the planner's fields are not those of the file."""
        from .plan_files.table import fields_of, table

        return cls._made(fields_of(found, table(cls.kind), changes), task)

    @classmethod
    def _status(cls, name: str) -> Any:
        """Returns the status of a name."""
        return cls._planner.Status[name]

    @classmethod
    def _planned(cls: type[Self], problem: Any, options: Any, budget: Any) -> Self:
        """Plans a problem made in Python. None means default options or budget."""
        from .tasks import Task

        task: Task[Any, Any, Any] = Task.of(problem, options, budget)
        return cls._search(task, task.budget)

    @classmethod
    def _search(cls: type[Self], task: Any, budget: planning.Budget) -> Self:
        """Plans; `budget` instead of the task's."""
        try:
            found = cls._planner.plan(task.problem, task.options, budget)
        except ValueError as error:
            name, _, what = str(error).partition(" ")
            if not hasattr(task.options, name):
                raise
            raise task.source.error(("options", name), what) from None
        plan = cls._of(found, task)
        note = getattr(task._fields, "proposed", None)
        if note is not None and hasattr(plan, "warnings"):  # a pinch has none
            warned: Any = plan
            warned.warnings = [note, *warned.warnings]
        return plan

    def _settings(self, options: Any, budget: Any) -> tuple[Any, Any]:
        """Returns options and budget of a plan that goes on from this one; None: those of this."""
        options = self.task.options if options is None else options
        return options, self.task.budget if budget is None else budget

    def _faults(self) -> list[str]:
        """Returns the faults of a solved plan."""
        return list(self._planner.check(self.task.problem, self, self.task.options))

    def _certificates(self) -> list[tuple[str, EdgeCertificate | None]]:
        """Returns the certificates of a solved plan, each with the words before its doubts.

        None stands for a motion that has no joints.
        """
        task = self.task
        return [("", self._planner.certify(task.problem, self, task.options))]


def of_found(base: Any, name: str, *statuses: Any) -> Any:
    """Returns an attribute of the core's plan as one that is None unless the status is given."""
    core = getattr(base, name)
    return property(
        lambda self: core.fget(self) if self.status in statuses else None,
        core.fset,
        doc=core.__doc__,
    )


def own_segments(base: Any) -> Any:
    """Returns `segments` of the core's plan as one that keeps the objects it was given."""
    core = base.segments

    def give(self: Any, segments: Any) -> None:
        core.fset(self, list(segments))
        self.__dict__["_segments"] = tuple(segments)

    return property(lambda self: self.__dict__.get("_segments", ()), give, doc=core.__doc__)


if not TYPE_CHECKING:
    Plan = AnyPlan  # graspless.Plan, of which type checkers see the protocol
