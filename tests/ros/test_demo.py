# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""From the image to the lifted bar, in processes of their own."""

import os
import re
import subprocess
import sys


def test_the_demo_lifts_the_bar():
    domain = str(int(os.environ["ROS_DOMAIN_ID"]) + 50)
    command = [sys.executable, "-m", "graspless", "ros", "demo"]
    done = subprocess.run(
        command,
        capture_output=True,
        text=True,
        check=False,
        timeout=180,
        env=os.environ | {"ROS_DOMAIN_ID": domain},
    )
    assert done.returncode == 0, done.stdout + done.stderr
    for line in ("feedback: planning", "feedback: carry", "result: executed", "check_plan: holds"):
        assert line in done.stdout
    lifted = re.search(r"the bar was lifted by ([\d.]+) cm", done.stdout)
    assert 9.0 < float(lifted[1]) < 11.0
