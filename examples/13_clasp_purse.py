# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""A clasp from the planner's own types: a cloud goes in, joint positions and a margin come out."""

from graspless import clasp, frames, geometry, robot

urdf = robot.builtin("kr5_sdh")
arm = robot.Robot.from_urdf_file(str(urdf))
hand = clasp.hand_from_yaml_file(str(urdf.with_name("kr5_sdh.clasp.yaml")))
cloud = geometry.sample_surface(clasp.sample_object("purse"), 2000)  # or points of your own, in m
purse = clasp.Object.from_cloud("purse", cloud)
X_WO = frames.planar(0.62, 0.05, 0.3)

problem = clasp.Problem(arm, hand, purse, X_WO, arm.state("home"))
plan = clasp.plan(problem)
assert plan, plan.reason
assert plan.stability  # of every clasp that was found
assert clasp.check(problem, plan) == []

for segment in plan.segments:
    linking = segment.virtual_linking
    print(f"{segment.name:6}{len(segment):4} rows, virtual linking from", end=" ")
    print(f"{linking[0].min():.2f} to {linking[-1].min():.2f}")
print(f"secure: {plan.stability.secure}, margin {plan.stability.margin:.2f}")
for finger, value in zip(hand.fingers, plan.segments[-1].virtual_linking[-1], strict=True):
    print(f"{finger.name}: {value:.2f} linked, at least {plan.min_linking:.2f} needed")
