# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Every code block of README.md and the site runs, and shows what its page says."""

import contextlib
import importlib
import io
import os
import pathlib
import re
import runpy
import shlex
import subprocess
import sys

import pydantic
import pytest
import yaml

import graspless
from graspless.tasks.shapes import Fields

ROOT = pathlib.Path(__file__).parents[2]
BUILD = ROOT / "build" / "make"
LISTED = runpy.run_path(str(ROOT / "tools" / "blocks.py"))
BLOCKS = {page: LISTED["blocks"](page) for page in LISTED["pages"]()}
ELSEWHERE = {"cd", "source", "cmake"}  # the C++ tests install; the others change nothing here


def pages_with(*languages):
    """The pages that have such blocks, as parameters of a test."""
    found = [
        page for page, blocks in BLOCKS.items()
        if any(block.language in languages and not block.reason for block in blocks)
    ]  # fmt: skip
    return pytest.mark.parametrize(
        "page", found, ids=[str(page.relative_to(ROOT)) for page in found]
    )


class Reader:
    """Does what a page says, block after block, in a folder that looks like the checkout."""

    def __init__(self, folder):
        self.folder = folder
        self.names = {"__name__": "__page__"}
        self.shown = ""
        for name in ("examples", "urdf"):
            (folder / name).symlink_to(ROOT / name)

    def follow(self, block):
        """Runs a block; its errors name page and line."""
        where = f"{block.page.relative_to(ROOT)}:{block.line}"
        if block.file:
            (self.folder / block.file).write_text(block.text)
        if block.language == "python":
            self._python(block.text, where)
        elif block.language == "sh":
            for line in block.text.replace("\\\n", " ").splitlines():
                self._command(line, where)
        elif block.language == "yaml":
            self._task(block.text, block.file or "task.yaml", where)
        elif block.language == "output":
            self._compare(block.text, where)

    def _python(self, text, where):
        shown = io.StringIO()
        with contextlib.redirect_stdout(shown):
            exec(compile(text, where, "exec"), self.names)
        self.shown = shown.getvalue()

    def _task(self, text, name, where):
        """A whole task can be loaded; anything else is a part of one."""
        fields = yaml.safe_load(text)
        if "kind" in fields:
            (self.folder / name).write_text(text)
            assert graspless.load_task(self.folder / name).kind == fields["kind"], where
        else:
            assert fits_a_model(fields), f"{where}: fits no task"

    def _command(self, line, where):
        words = shlex.split(line, comments=True)
        if not words or words[0] in ELSEWHERE:
            return
        program, *arguments = words
        if program == "make":
            assert f"\n{arguments[0]}:" in (ROOT / "Makefile").read_text(), where
        elif program == "tools/install":
            assert set(arguments[0].split(",")) <= extras(), where
        elif program == "tools/fuzz":  # takes too long to run here
            known = (ROOT / program).read_text()
            assert all(f'"{argument}"' in known for argument in arguments), where
        elif program == ".venv/bin/pip":
            assert set(re.findall(r"\w+", arguments[-1])) <= extras(), where
        else:
            command = {"graspless": [sys.executable, "-m", "graspless"], "python": [sys.executable]}
            self._run([*command[program], *arguments], line, where)

    def _run(self, command, line, where):
        expected = re.search(r"# exit code (\d+)", line)
        done = subprocess.run(command, cwd=self.folder, capture_output=True, text=True, check=False)
        self.shown = done.stdout + done.stderr
        code = int(expected[1]) if expected else 0
        assert done.returncode == code, f"{where}: {line}\n{self.shown}"

    def _compare(self, text, where):
        for line in filter(str.strip, text.splitlines()):
            pattern = r"\s+".join(re.escape(word) for word in line.split())
            pattern = pattern.replace(re.escape("..."), ".*")
            assert re.search(pattern, self.shown), f"{where}: {line!r} is not in\n{self.shown}"


KINDS = ("slide", "fingertip", "clasp.hand", "carry", "chain")
for room in (*(f"tasks.{kind}" for kind in KINDS), "perception.view_files"):
    importlib.import_module(f"graspless.{room}")  # or models() misses some


def models(base=Fields):
    """All parts that a task file can have."""
    for model in base.__subclasses__():
        yield model
        yield from models(model)


def fits_a_model(fields):
    """True if some part of a task file may have these fields with these values."""
    for model in models():
        if set(fields) <= set(model.model_fields):
            annotations = {name: model.model_fields[name].annotation for name in fields}
            part = pydantic.create_model("Part", **{k: (v, ...) for k, v in annotations.items()})
            with contextlib.suppress(pydantic.ValidationError):
                part.model_validate(fields)
                return True
    return False


def extras():
    """The names of the optional dependencies."""
    text = (ROOT / "pyproject.toml").read_text().split("[project.optional-dependencies]")[1]
    return set(re.findall(r"^(\w+) = \[", text.split("\n[project.")[0], re.MULTILINE))


@pytest.mark.slow
@pages_with("python", "sh", "yaml")
def test_page_does_what_it_says(page, tmp_path, monkeypatch):
    for extra in ("matplotlib", "mujoco", "toppra", "rosbags", "joblib"):
        pytest.importorskip(extra)
    monkeypatch.chdir(tmp_path)
    monkeypatch.setenv("PYTHONWARNINGS", "error")
    reader = Reader(tmp_path)
    for block in BLOCKS[page]:
        if not block.reason:
            reader.follow(block)


@pytest.mark.slow
@pytest.mark.skipif(not (BUILD / "CMakeCache.txt").exists(), reason="no build/make: make test")
def test_programs_build_against_an_installed_library(tmp_path):
    prefix, build = tmp_path / "prefix", tmp_path / "build"
    programs = [b for blocks in BLOCKS.values() for b in blocks if b.language == "cpp"]
    project = (ROOT / "tests" / "consumer" / "CMakeLists.txt").read_text()
    head, target = project.split("add_executable", 1)
    for k, block in enumerate(programs):
        (tmp_path / f"{k}.cpp").write_text(block.text)
        one = target.replace("consumer", f"program{k}").replace("main.cpp", f"{k}.cpp")
        head += "add_executable" + one
    (tmp_path / "CMakeLists.txt").write_text(head)
    settings = [f"-DCMAKE_PREFIX_PATH={prefix}", "-DCMAKE_BUILD_TYPE=Debug"]
    with contextlib.suppress(KeyError):
        settings.append(
            f"-DCMAKE_CXX_COMPILER_LAUNCHER={os.environ['CMAKE_CXX_COMPILER_LAUNCHER']}"
        )
    install = ["cmake", "--install", BUILD, "--component", "cpp", "--prefix", prefix]
    for command in (
        install,
        ["cmake", "-S", tmp_path, "-B", build, *settings],
        ["cmake", "--build", build],
    ):
        subprocess.run(command, check=True, capture_output=True)
    urdf = prefix / "share" / "graspless" / "urdf" / "wam_t42.urdf"
    for k, block in enumerate(programs):
        arguments = [urdf] if "argv[1]" in block.text else []
        subprocess.run([build / f"program{k}", *arguments], check=True, capture_output=True)


def test_blocks_that_do_not_run_are_few_and_say_why():
    reasons = [block.reason for blocks in BLOCKS.values() for block in blocks if block.reason]
    assert len(reasons) <= 7
    for blocks in BLOCKS.values():
        for block in blocks:
            if block.language == "python" and block.reason:
                compile(block.text, str(block.page), "exec")


@pytest.mark.parametrize("kind", ["slide", "pinch", "fingertip", "clasp", "carry"])
def test_every_status_of_a_plan_file_is_documented(kind):
    page = (ROOT / "docs" / "plan-files.md").read_text().split(f"\n## kind: {kind}\n")[1]
    told = next(line for line in page.splitlines() if line.startswith("| `status` |"))
    statuses = getattr(graspless, kind).Status.__members__
    assert [name for name in statuses if f"`{name}`" not in told] == []


def test_quoted_messages_are_those_of_the_sources():
    """The headings of the troubleshooting page are texts that graspless can print."""
    sources = "".join(
        re.sub(r'"\s*\n\s*f?"', "", path.read_text(encoding="utf-8"))
        for folder in ("python/graspless", "cpp/src", "tools")
        for path in sorted((ROOT / folder).rglob("*"))
        if path.suffix in (".py", ".cpp", ".hpp") or path.name == "install"
    )
    page = (ROOT / "docs" / "troubleshooting.md").read_text()
    quoted = re.findall(r"^### `(.+)`$", page, re.MULTILINE)
    assert len(quoted) > 20
    for text in quoted:
        for part in text.split("..."):
            assert part.strip() in sources, f"{part.strip()!r} is in no source"
