# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""One truth per option: the tables in the C++ headers, and everything that is made from them."""

import importlib.util
import json
import math
import pathlib

import pytest

import graspless
from graspless import TaskError, carry, clasp, fingertip, planning, slide
from graspless.tasks.budget import Budget
from graspless.tasks.carry import model as carry_model
from graspless.tasks.clasp import model as clasp_model
from graspless.tasks.fingertip import model as fingertip_model
from graspless.tasks.slide import model as slide_model
from tasks_common import GOOD

ROOT = pathlib.Path(__file__).parents[2]
MODELS = {
    "planning.Budget": (planning.Budget, Budget),
    "slide.Options": (slide.Options, slide_model.Options),
    "carry.Options": (carry.Options, carry_model.Options),
    "clasp.Options": (clasp.Options, clasp_model.Options),
    "clasp.StabilityOptions": (clasp.StabilityOptions, clasp_model.Stability),
    "clasp.CertificateOptions": (clasp.CertificateOptions, clasp_model.Certificate),
    "fingertip.Options": (fingertip.Options, fingertip_model.Options),
    "mechanics.Compliance": (fingertip.Compliance, fingertip_model.Compliance),
    "fingertip.RealizeOptions": (fingertip.RealizeOptions, fingertip_model.Realize),
}
VALIDATED = [
    (slide, slide.Options),
    (carry, carry.Options),
    (clasp, clasp.Options),
    (fingertip, fingertip.Options),
]
ROWS = [(room, core, field) for room, core in VALIDATED for field in core.fields() if field.bounds]


def name(value):
    return getattr(value, "name", None) or getattr(value, "__name__", "")


def page():
    spec = importlib.util.spec_from_file_location("page", ROOT / "tools" / "options_page.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def test_page_is_that_of_the_headers():
    made = page()
    assert made.PAGE.read_text() == made.text(), "run `make stubs`"


@pytest.mark.parametrize(("core", "model"), MODELS.values(), ids=MODELS)
def test_task_files_have_the_same_options(core, model):
    names = [field.name for field in core.fields()]
    assert [n for n, info in model.model_fields.items() if not info.exclude] == names
    for field in core.fields():
        assert field.text.endswith(".")
        assert hasattr(core(), field.name)


def just_outside(field):
    """A value outside each end of the range."""
    for bound, value in field.bounds.items():
        if isinstance(value, int):
            yield value - 1 if bound == "ge" else value + 1
        elif bound in ("gt", "lt"):
            yield value
        else:
            yield math.nextafter(value, -math.inf if bound == "ge" else math.inf)


@pytest.mark.parametrize(("room", "core", "field"), ROWS, ids=name)
def test_core_and_task_files_refuse_the_same_values(room, core, field):
    model = MODELS[f"{core.__module__.rpartition('.')[2]}.{core.__name__}"][1]
    for value in just_outside(field):
        if isinstance(value, float) and math.isinf(value):
            continue  # every number of a task file is finite
        options = core(**{field.name: value})
        with pytest.raises(ValueError, match=rf"options\.{field.name} must lie in"):
            room.validate(options)
        with pytest.raises(ValueError, match=field.name):
            model(**{field.name: value})


@pytest.mark.parametrize("field", fingertip.Compliance.fields(), ids=name)
def test_springs_are_bounded_like_options(field):
    for value in just_outside(field):
        springs = fingertip.Compliance(**{field.name: value})
        with pytest.raises(ValueError, match=rf"options\.compliance\.{field.name} must lie in"):
            fingertip.validate(fingertip.Options(compliance=springs))
        with pytest.raises(ValueError, match=field.name):
            fingertip_model.Compliance(**{field.name: value})


@pytest.mark.parametrize(("core", "model"), MODELS.values(), ids=MODELS)
def test_defaults_lie_in_their_ranges(core, model):
    for field in core.fields():
        value = getattr(core(), field.name)
        if field.bounds and value is not None:
            assert getattr(model(**{field.name: value}), field.name) == value


def test_an_end_of_a_range_belongs_to_it_or_not():
    slide.validate(slide.Options(resolution=0.01))
    slide.validate(slide.Options(max_depth=0.099, min_depth=0))
    with pytest.raises(ValueError, match=r"options.min_overhang must lie in \(0, inf\) m, not 0"):
        slide.validate(slide.Options(min_overhang=0))


@pytest.mark.parametrize("room", [slide, carry, clasp])
def test_a_resolution_that_would_fill_the_memory_is_refused(room):
    room.validate(room.Options(resolution=1e-4))
    what = r"options.resolution must lie in \[0.0001, 0.01\] rad, not 1e-09"
    with pytest.raises(ValueError, match=what):
        room.validate(room.Options(resolution=1e-9))


CONSTANTS = [
    (model, former, value)
    for model, table in [
        (clasp_model.Options, clasp_model._CONSTANTS),
        (slide_model.Options, slide_model._CONSTANTS),
    ]
    for former, value in table.items()
]


@pytest.mark.parametrize(("model", "former", "value"), CONSTANTS, ids=str)
def test_former_options_are_read_when_they_have_the_built_in_value(model, former, value):
    assert former not in model(**{former: value}).model_dump()
    other = not value if isinstance(value, bool) else value + 1
    with pytest.raises(ValueError, match=f"is no longer an option; it is always {value}"):
        model(**{former: other})


def test_a_former_option_in_a_task_is_refused_with_line_and_value(tmp_path):
    task = tmp_path / "task.yaml"
    task.write_text(GOOD + "options:\n  roll_tolerance: 0.02\n")
    with pytest.raises(TaskError, match=r"task.yaml:\d+: options.roll_tolerance: 0.02: is no long"):
        graspless.load_task(task)
    task.write_text(GOOD + "options:\n  roll_tolerance: 0.001\n")
    fields = json.loads(graspless.plan(graspless.load_task(task), iterations=0).to_json())["task"]
    assert "roll_tolerance" not in fields["options"]
