# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A headless browser, and how to use a replay's page in it as a user does."""

import contextlib
import importlib
import io
import json
import os
import shutil
import signal
import socket
import subprocess
import sys
import time

import numpy as np
import pytest

FLAGS = [
    "--headless=new",
    "--no-sandbox",
    "--disable-gpu",
    "--disable-dev-shm-usage",
    "--disable-quic",
    "--no-first-run",
    "--disable-background-networking",
    "--disable-component-update",
    "--disable-sync",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--window-size=420,400",
]
DPR = "?fixedDpr=1"  # viser lowers it where drawing is slow, and pictures would not compare
PATIENCE = 120.0  # of software drawing on a busy machine [s]
FRAMES = """const done = arguments[arguments.length - 1]; let left = 3;
const step = () => (left-- ? requestAnimationFrame(step) : done()); step();"""
MOVED, SAME = 0.01, 0.0005  # parts of the picture


GRASPLESS = (sys.executable, "-m", "graspless")
BROWSERS = ("chromium", "chromium-browser", "google-chrome", "google-chrome-stable")
DRIVERS = ("chromedriver", "chromium.chromedriver")  # Ubuntu's snap has the second


def missing(why):
    """Skips, or fails where tests in a browser must run."""
    if os.environ.get("GRASPLESS_REQUIRE_BROWSER"):
        pytest.fail(why)
    pytest.skip(why, allow_module_level=True)


def needed(module):
    """A module that these tests need; see `missing`."""
    try:
        return importlib.import_module(module)
    except ImportError as error:
        missing(f"no {module}: {error}")


def start_browser(profile):
    """A driver of Chromium without a window; see `missing`."""
    binary, chromedriver = (
        next(filter(None, map(shutil.which, names)), None) for names in (BROWSERS, DRIVERS)
    )
    if binary is None or chromedriver is None:
        absent = "chromedriver" if binary else "Chromium or Chrome"
        missing(f"no {absent}: see tools/apt-packages-test.txt")
    webdriver = needed("selenium.webdriver")
    options = webdriver.ChromeOptions()
    options.binary_location = binary
    for flag in (*FLAGS, f"--user-data-dir={profile}"):
        options.add_argument(flag)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL", "performance": "ALL"})
    service = webdriver.chrome.service.Service(chromedriver)
    driver = webdriver.Chrome(options=options, service=service)
    try:
        driver.set_page_load_timeout(PATIENCE)
        driver.set_script_timeout(PATIENCE)
        driver.get("about:blank")  # away from the page of a new tab, which asks for much
        for log in ("browser", "performance"):
            driver.get_log(log)
    except BaseException:  # nobody else knows of it yet
        driver.quit()
        raise
    return driver


@contextlib.contextmanager
def served(plan, folder):
    """The address of `graspless view PLAN`, which ends with the block, whatever happens in it.

    What it prints goes to files: nobody need read them for it to go on.
    """
    plan.save(folder / "plan.json")
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        port = probe.getsockname()[1]
    address, out, err = f"http://localhost:{port}", folder / "out", folder / "err"
    command = [*GRASPLESS, "view", str(folder / "plan.json"), "--port", str(port)]
    with out.open("w") as to_out, err.open("w") as to_err:
        process = subprocess.Popen(command, stdout=to_out, stderr=to_err)
    try:
        until("the address", lambda: process.poll() is not None or address in out.read_text())
        assert process.poll() is None, err.read_text()
        yield f"{address}/"
        process.send_signal(signal.SIGINT)
        assert process.wait(PATIENCE) == 130
    finally:
        process.kill()  # nothing where it has ended
        process.wait()
    assert "Traceback" not in err.read_text()


def until(what, condition):
    """The first true value of a condition."""
    end = time.monotonic() + PATIENCE
    while not (value := condition()):
        assert time.monotonic() < end, f"not within {PATIENCE:g} s: {what}"
        time.sleep(0.05)
    return value


def find(driver, css):
    """The first element, waited for."""
    return until(css, lambda: driver.find_elements("css selector", css))[0]


def open_page(driver, address):
    """Loads a replay or a viewer and takes the notice of slow drawing away."""
    driver.get(address + DPR)
    click_slider(driver, 0.02)  # which ends the play
    find(driver, ".mantine-Notification-closeButton").click()
    until(
        "notice gone",
        lambda: not driver.find_elements("css selector", ".mantine-Notification-root"),
    )


def picture(driver):
    """The scene [height, width, 3] of 0 to 1, after frames enough to show what was asked of it."""
    from PIL import Image

    driver.execute_async_script(FRAMES)
    png = find(driver, "canvas").screenshot_as_png
    return np.asarray(Image.open(io.BytesIO(png)).convert("RGB"), dtype=float) / 255


def shown(driver):
    """The scene once it stands still."""
    last = [picture(driver)]

    def is_still():
        now, before = picture(driver), last[0]
        last[0] = now
        return now.std() > 0.01 and np.array_equal(now, before)

    until("a picture that stands still and is not blank", is_still)
    return last[0]


def until_same(driver, before):
    """Waits for a picture to come again."""
    until("the same picture", lambda: changed(before, picture(driver)) < SAME)


def until_moved(driver, before):
    """Waits for a picture to change."""
    until("another picture", lambda: changed(before, picture(driver)) > MOVED)


def changed(before, after):
    """What part of a picture has changed."""
    return float((np.abs(after - before).max(axis=2) > 0.1).mean())


def click_slider(driver, part):
    """Clicks on the slider's track; the value it took."""
    from selenium.webdriver import ActionChains

    track = find(driver, ".mantine-Slider-trackContainer")
    width = track.size["width"]
    ActionChains(driver).move_to_element_with_offset(
        track, round((part - 0.5) * (width - 2)), 0
    ).click().perform()
    return value(driver)


def value(driver):
    """Where the slider is."""
    return float(find(driver, "[role=slider]").get_attribute("aria-valuenow"))


def errors(driver):
    """What the page logged that is wrong."""
    log = driver.get_log("browser")
    return [entry["message"] for entry in log if entry["level"] == "SEVERE"]


def requests(driver):
    """Addresses that the page asked for."""
    events = [json.loads(entry["message"])["message"] for entry in driver.get_log("performance")]
    names = ("Network.requestWillBeSent", "Network.webSocketCreated")
    sent = [event["params"] for event in events if event["method"] in names]
    return [params["request"]["url"] if "request" in params else params["url"] for params in sent]
