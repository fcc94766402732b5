"""Plans a slide with the installed package alone; says which libraries came from where."""

from __future__ import annotations

import pathlib
import sys

import numpy as np

import graspless
from graspless import planning, robot, slide
from graspless._data import directory


def main() -> int:
    package = pathlib.Path(graspless.__file__).parent
    wam = robot.Robot.from_urdf_file(str(directory("urdf") / "wam_t42.urdf"))
    square = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]])
    place = np.eye(4)
    place[0, 3] = 0.65
    q_home = wam.state("open").copy()
    q_home[3] = 1.5708
    card = slide.Object.from_polygon("card", 0.05 * square, thickness=0.004)
    table = slide.Support(0.35 * square, place)
    problem = slide.Problem(wam, slide.Hand(), card, table, place, q_home)
    plan = slide.plan(problem, budget=planning.Budget(seconds=20))
    faults = slide.check(problem, plan) if plan else [plan.reason]
    for fault in faults[:5]:
        print(fault)
    maps = pathlib.Path("/proc/self/maps").read_text(encoding="utf-8").split()
    libraries = sorted({name for name in maps if ".so" in name})
    own = [name for name in libraries if name.startswith(str(package.parent))]
    print(f"{plan.status.name} in {plan.statistics.seconds:.3f} s by {package}")
    print(f"{len(own)} libraries from the wheel and its requirements; from elsewhere:")
    print(*(name for name in libraries if name not in own), sep="\n")
    if list(package.rglob("*bench*")) or list(package.rglob("*peers*")):
        faults.append("the wheel holds benchmarks")
        print(faults[-1])
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
