# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Replays and the viewer in a browser, used as a user does: slider, play, and layers."""

import os
import shutil
import sys
import types
import unittest.mock

import pytest

import browser_common
import graspless
from browser_common import (
    BROWSERS,
    DRIVERS,
    click_slider,
    errors,
    find,
    needed,
    open_page,
    requests,
    served,
    shown,
    start_browser,
    until,
    until_moved,
    until_same,
    value,
)  # fmt: skip
from clasp_common import PURSE
from fingertip_common import PUSH
from graspless import view
from graspless.tasks import read_task
from tasks_common import GOOD

needed("viser")
pytestmark = pytest.mark.slow

TASKS = {"slide": GOOD, "fingertip": PUSH, "clasp": PURSE}
LAYERS = {"slide": "robot", "fingertip": "object", "clasp": "robot"}  # that cover much


@pytest.fixture
def driver(tmp_path):
    """A browser of each test's own: a page's workers outlive it and still log to its browser."""
    driver = start_browser(tmp_path / "profile")
    yield driver
    driver.quit()


@pytest.fixture(scope="module", params=TASKS)
def plan(request):
    plan = graspless.plan(read_task(TASKS[request.param], "task.yaml"))
    assert plan, plan.reason
    return plan


def test_replay_is_used_in_a_browser(driver, plan, tmp_path):
    view.write_html(plan, tmp_path / "a.html")
    driver.set_window_size(420, 400)
    open_page(driver, (tmp_path / "a.html").as_uri())
    assert driver.title == f"graspless: {plan.task.problem.object.name}, solved"
    click_slider(driver, 0.02)  # which ends the play
    first = click_slider(driver, 0.02)
    start = shown(driver)
    assert click_slider(driver, 0.5) > first
    until_moved(driver, start)
    assert click_slider(driver, 0.02) == first  # back
    until_same(driver, start)

    click_eye(driver, LAYERS[plan.kind])
    until_moved(driver, start)
    hidden = shown(driver)
    click_slider(driver, 0.5)
    shown(driver)
    click_slider(driver, 0.02)
    until_same(driver, hidden)  # it stays hidden
    click_eye(driver, LAYERS[plan.kind])
    until_same(driver, start)

    find(driver, "button[data-variant='subtle'][data-size='md']").click()
    until("play", lambda: value(driver) > first + 0.2)
    until_moved(driver, start)
    assert errors(driver) == []
    assert [
        url for url in requests(driver) if not url.startswith(("file:", "data:", "blob:"))
    ] == []


# A clasp takes minutes to draw without a graphics card; its replay has the same scene.
@pytest.mark.parametrize("plan", ["slide", "fingertip"], indirect=True)
def test_viewer_is_used_in_a_browser(driver, plan, tmp_path):
    driver.set_window_size(760, 420)  # room beside the panel
    with served(plan, tmp_path) as address:
        open_page(driver, address)
        click_box(driver, "play")
        click_slider(driver, 0.02)
        start = shown(driver)
        click_slider(driver, 0.5)
        until_moved(driver, start)
        click_slider(driver, 0.02)
        until_same(driver, start)
        click_box(driver, LAYERS[plan.kind])
        until_moved(driver, start)
        click_box(driver, LAYERS[plan.kind])
        until_same(driver, start)
        click_box(driver, "play")
        until_moved(driver, start)
        assert errors(driver) == []
        asked = requests(driver)
        own = (address, address.replace("http", "ws"), "data:", "blob:")
        assert [url for url in asked if not url.startswith(own)] == []


def click_eye(driver, layer):
    """Clicks the eye of a layer in the scene tree, which then gives the view free again."""
    find(driver, "[aria-label='Show scene tree']").click()
    find(driver, f"[data-scene-node='/{layer}'] svg[style*='1.5em']").click()
    find(driver, "[aria-label='Hide scene tree']").click()
    click_slider(driver, 0.02)  # the pointer away from what it would explain


def click_box(driver, name):
    """Clicks the box beside a name."""
    path = f"//label[normalize-space()='{name}']/following::input[@type='checkbox'][1]"
    until(name, lambda: driver.find_elements("xpath", path))[0].click()


@pytest.mark.parametrize("absent", ["chromedriver", "Chromium or Chrome", "selenium.webdriver"])
@pytest.mark.parametrize("required", ["", "1"])
def test_what_is_missing_skips_or_fails(monkeypatch, tmp_path, absent, required):
    gone = {"chromedriver": DRIVERS, "Chromium or Chrome": BROWSERS}.get(absent, ())
    monkeypatch.setattr(shutil, "which", lambda name: None if name in gone else f"/bin/{name}")
    monkeypatch.setitem(sys.modules, "selenium.webdriver", None)
    monkeypatch.setenv("GRASPLESS_REQUIRE_BROWSER", required)
    outcome = pytest.fail.Exception if required else pytest.skip.Exception
    with pytest.raises(outcome, match=f"no {absent}"):
        start_browser(tmp_path)


@pytest.mark.parametrize("step", ["set_script_timeout", "get", "get_log"])
def test_a_browser_that_fails_early_is_closed(monkeypatch, tmp_path, step):
    driver = unittest.mock.Mock(**{f"{step}.side_effect": RuntimeError("no")})
    selenium = unittest.mock.Mock(**{"Chrome.return_value": driver})
    monkeypatch.setattr(shutil, "which", lambda name: f"/bin/{name}")
    monkeypatch.setitem(sys.modules, "selenium.webdriver", selenium)
    with pytest.raises(RuntimeError, match="no"):
        start_browser(tmp_path)
    driver.quit.assert_called_once_with()


VIEWER = """import os, signal, sys, time
print(os.getpid(), {said}, flush=True)
signal.signal(signal.SIGINT, signal.SIG_IGN)
sys.stderr.write("x" * 10**6)  # more than a pipe holds
time.sleep(600)
"""


@pytest.mark.parametrize("said", ["''", "'http://localhost:' + sys.argv[-1]"])
def test_a_viewer_that_hangs_is_ended(monkeypatch, tmp_path, said):
    monkeypatch.setattr(browser_common, "PATIENCE", 3.0)
    hangs = (sys.executable, "-c", VIEWER.format(said=said))
    monkeypatch.setattr(browser_common, "GRASPLESS", hangs)
    plan = types.SimpleNamespace(save=lambda path: None)
    message = "wrong page" if "http" in said else "not within 3 s: the address"
    with pytest.raises(AssertionError, match=message), served(plan, tmp_path):
        raise AssertionError("wrong page")
    with pytest.raises(ProcessLookupError):
        os.kill(int((tmp_path / "out").read_text().split()[0]), 0)
