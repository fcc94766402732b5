# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Experiments with plans in the physics engine."""

# Kind of plans that has the experiment, or any; end of the message for other kinds; help.
EXPERIMENTS = {
    "ablation": (
        "slide",
        " has none (slide has)",
        "slide: the paper's formula on the commanded tip",
    ),
    "disturb": (
        "fingertip",
        " plans have no stability margin (fingertip plans do)",
        "fingertip: instead of trials, the smallest wrench that breaks the weakest row (slow)",
    ),
    "withstands": (
        "fingertip",
        ": only rows of fingertip plans are tested",
        "fingertip: instead of trials, the smallest wrenches that break rows of plans for other "
        "objects, against the disturbance that the rows withstand",
    ),
    "closed_loop": (
        "slide",
        ": only slide plans are followed",
        "slide: instead of trials, each condition in open and in closed loop",
    ),
    "prove": (
        "",
        "",
        "instead of trials, plan until a plan holds as planned and in N varied trials",
    ),
    "mutants": (
        "",
        "",
        "instead of trials, break every plan on purpose, and see what check and simulate find",
    ),
    "locked": (
        "clasp",
        " plans have no certificate (clasp plans do)",
        "clasp: instead of trials, certificates against hands with locked motors",
    ),
}
