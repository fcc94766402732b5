"""Plans a slide with the installed package alone; says which libraries came from where."""

from __future__ import annotations

import pathlib
import sys

import graspless
from graspless._data import directory


def main() -> int:
    package = pathlib.Path(graspless.__file__).parent
    plan = graspless.plan(directory("examples") / "01_slide_card.yaml")
    faults = graspless.check(plan)
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
