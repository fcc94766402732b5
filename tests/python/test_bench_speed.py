# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Queries beside those of another build, the profile of their rooms, and the page of both."""

import json
import sys
from pathlib import Path

import pytest

import graspless
from graspless.cli import main
from graspless_bench import machine
from graspless_bench.speed import builds, measure, profile, report
from graspless_bench.speed.queries import OF_NAME, QUERIES

RESULTS = Path(__file__).parents[2] / "docs" / "results"
SLOW = {
    "fingertip: d, 23 locations a side",
    "fingertip: d, 31 locations a side",
    "fingertip: a, four fingers",
    "loops: chair, 100,000 points, polished",
}


class Scripted:
    """A build that answers with the times, and the results, that it is given."""

    def __init__(self, seconds, value=1.0, is_good=True, fails=None):
        self.seconds, self.asked = seconds, []
        self.answer = {"is_good": is_good, "value": value}
        self.fails = fails

    def ask(self, **request):
        self.asked.append(request)
        if self.fails in request:
            raise builds.NoAnswerError("lacks it")
        if "open" in request:
            return {"problems": len(self.seconds)}
        if "run" in request:
            return self.answer | {"seconds": self.seconds[request["run"]]}
        return {"megabytes": 1.5}


def row_of(**asked):
    rows, is_complete = measure.run([OF_NAME["slide"]], asked)
    assert is_complete
    return rows[0]


# The queries


@pytest.mark.parametrize(
    "query",
    [pytest.param(q, marks=pytest.mark.slow) if q.name in SLOW else q for q in QUERIES],
    ids=lambda q: q.name,
)
def test_the_first_problem_of_each_query_has_a_result(query):
    first, again = (next(iter(query.make()))() for _ in range(2))
    assert first.is_good
    assert first.value == again.value


def test_unknown_queries_are_refused_with_the_choices(capsys):
    assert main(["bench", "all", "--query", "boxes"]) == 2
    assert "--query: 'boxes': should be the beginning of one of 'slide', " in (
        capsys.readouterr().err
    )


# Two builds


def test_a_worker_answers_with_the_installed_build():
    with builds.Build(None) as build:
        assert build.ask(open="slide: plan file saved and loaded") == {"problems": 1}
        answer = build.ask(run=0)
        assert answer["is_good"]
        assert 0 < answer["seconds"] < 10
        assert build.ask(close=True)["megabytes"] > 0
        with pytest.raises(builds.NoAnswerError, match="KeyError"):
            build.ask(open="boxes")


def test_a_worker_takes_graspless_from_a_folder(tmp_path):
    (tmp_path / "graspless").mkdir()
    (tmp_path / "graspless" / "__init__.py").write_text("raise SystemExit(3)")
    with builds.Build(tmp_path) as build, pytest.raises(builds.NoAnswerError, match="code 3"):
        build.ask(open="slide")


def test_the_builds_are_asked_in_turn_and_compared():
    old, new = Scripted([1.0, 4.0]), Scripted([0.5, 1.0])
    row = row_of(old=old, new=new)
    assert [r["run"] for r in old.asked if "run" in r] == 5 * [0, 1]
    assert row["old"] == {
        "problems": 2, "good": 2, "p50": 1.0, "p99": 4.0, "worst": 4.0, "megabytes": 1.5,
    }  # fmt: skip
    assert (row["ratio_p25"], row["ratio_p75"], row["same"]) == (0.25, 0.5, 2)


def test_long_queries_are_not_repeated():
    build = Scripted([30.0])
    row_of(new=build)
    assert len([r for r in build.asked if "run" in r]) == 1


def test_other_results_are_counted():
    assert row_of(old=Scripted([1.0]), new=Scripted([1.0], value=2.0))["same"] == 0


def test_fewer_results_than_before_are_a_complaint():
    rows = [row_of(old=Scripted([1.0]), new=Scripted([1.0], is_good=False))]
    result = report.as_result("all", rows, True, [0, 0, 0], "old.whl")
    assert result["complaints"] == ["slide: 0 results, 1 before"]


def test_another_build_that_answers_nothing_is_a_complaint():
    rows = [row_of(old=Scripted([1.0], fails="open"), new=Scripted([1.0]))]
    result = report.as_result("all", rows, True, [0, 0, 0], "old.whl")
    assert result["complaints"] == ["the other build answers nothing: lacks it"]


def test_a_worker_that_has_ended_is_started_again():
    with builds.Build(None) as build:
        build.ask(open="slide: plan file saved and loaded")
        build._process.kill()
        with pytest.raises(builds.NoAnswerError, match="code -9"):
            build.ask(run=0)
        assert build.ask(open="slide: plan file saved and loaded") == {"problems": 1}


@pytest.mark.parametrize("fails", ["open", "run", "close"])
def test_a_build_that_cannot_answer_leaves_the_other_alone(fails):
    rows = [row_of(old=Scripted([1.0], fails=fails), new=Scripted([1.0]))]
    assert rows[0]["new"]["good"] == 1
    if fails == "close":
        assert rows[0]["old"]["good"] == 1
        return
    assert rows[0]["old"] == {"error": "lacks it"}
    text = report.as_text(report.as_result("all", rows, True, [0, 0, 0], "old.whl"))
    assert "the other build cannot answer slide: lacks it" in text


def test_a_query_that_the_new_build_cannot_answer_is_a_complaint():
    rows = [row_of(new=Scripted([1.0], fails="run"))]
    result = report.as_result("all", rows, True, [0, 0, 0], "")
    assert result["complaints"] == ["slide: lacks it"]
    report.as_text(result)


@pytest.mark.parametrize("name", ["missing.whl", "folder", "text.whl"])
def test_what_is_no_build_is_refused(tmp_path, capsys, name):
    (tmp_path / "folder").mkdir()
    (tmp_path / "text.whl").write_text("no wheel")
    path = tmp_path / name
    assert main(["bench", "all", "--against", str(path)]) == 2
    assert f"--against: {path}: " in capsys.readouterr().err


def test_the_command_compares_a_build_with_itself(tmp_path, capsys):
    package = Path(graspless.__file__).parents[1]
    arguments = ["--query", "slide: plan file", "--against", str(package), "--json"]
    assert main(["bench", "all", *arguments, "--out", str(tmp_path)]) == 0
    result = json.loads(capsys.readouterr().out)
    assert [row["same"] for row in result["rows"]] == [1]
    assert {path.name for path in tmp_path.iterdir()} == {"speed.md", "speed_all.json"}
    assert "| slide: plan file saved and loaded |" in (tmp_path / "speed.md").read_text()


# The profile

ANNOTATED = """
1,000  ???:graspless::robot::place(Eigen::Matrix<double> const&) [/tmp/libgraspless.so]
  200  ???:std::vector<graspless::slide::Node>::push_back() [/tmp/libgraspless.so]
   90  ./malloc/./malloc/malloc.c:_int_free [/usr/lib/libc.so.6]
   80  ???:KDL::operator*(KDL::Rotation const&, KDL::Rotation const&) [/usr/lib/kdl.so]
   70  ./math/../sysdeps/ieee754/dbl-64/s_sin.c:__sincos_fma
   60  ???:glp_simplex [/usr/lib/libglpk.so.40]
    5  ???:std::__cxx11::basic_string<char>::_M_create() [/usr/lib/libstdc++.so.6]
no numbers here
"""


def test_instructions_are_counted_by_room():
    assert profile.counted(ANNOTATED.splitlines()) == {
        "robot": 1000, "slide": 200, "memory": 90, "KDL": 80, "sines, roots": 70, "GLPK": 60,
        "other": 5,
    }  # fmt: skip


def test_only_rooms_of_a_hundredth_are_shown(tmp_path):
    old = {"robot": 1, "slide": 1, "KDL": 1}
    rows = [{"name": "slide", "new": {"robot": 995, "slide": 5}, "old": old}]
    rows += [{"name": "clasp", "new": {"robot": 995, "slide": 5}}]
    result = report.as_result("profile", rows, True, [0, 0, 0], "")
    report.write(result, tmp_path)
    slide, clasp = (tmp_path / "speed.md").read_text().split("| clasp |")
    assert "| slide |" in slide.split("| slide | old | new |")[1]
    assert "| KDL | 0.0 M, 33.3 % | 0.0 M, 0 % |" in slide
    assert "| slide |" not in clasp
    assert "| robot |" in clasp


def test_profiles_need_valgrind(monkeypatch, capsys):
    monkeypatch.setenv("PATH", "/nowhere")
    assert main(["bench", "profile"]) == 2
    assert "bench profile: needs valgrind" in capsys.readouterr().err


@pytest.mark.parametrize("part", ["all", "profile"])
def test_results_were_made_by_this_code(part):
    result = json.loads((RESULTS / f"speed_{part}.json").read_text())
    assert result["complete"]
    expected = [query.name for query in QUERIES if part == "all" or query.room]
    assert [row["name"] for row in result["rows"]] == expected
    assert not [row["name"] for row in result["rows"] if "error" in row.get("old", {})]


@pytest.mark.parametrize(
    ("given", "shown"),
    [
        (["bench", "all", "--against=/x/y/", "--out", "/tmp/my dir"], "bench all --against y"),
        (["bench", "all", "--out=/x", "--against", "/x/a.whl"], "bench all --against a.whl"),
        (["bench", "slide", "--runs", "3"], "bench slide --runs 3"),
    ],
)
def test_commands_in_results_have_no_folders(monkeypatch, given, shown):
    monkeypatch.setattr(sys, "argv", ["/usr/bin/graspless", *given])
    assert machine.machine([0, 0, 0], 0)["command"] == f"graspless {shown}"
