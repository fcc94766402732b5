# SPDX-FileCopyrightText: 2026 The graspless authors
# SPDX-License-Identifier: BSD-3-Clause
"""Small robots for the tests of inspect: an arm of six joints, and hands for it."""

SHAPE = '<collision><origin xyz="{xyz}"/><geometry>{shape}</geometry></collision>'


def link(name, xyz="0 0 0", shape=""):
    inner = SHAPE.format(xyz=xyz, shape=shape) if shape else ""
    return f'<link name="{name}">{inner}</link>\n'


def box(name, xyz, size):
    return link(name, xyz, f'<box size="{size}"/>')


def joint(name, kind, parent, child, xyz="0 0 0", axis="0 0 1", limits=(-2.9, 2.9), mimic=""):
    limit = f'<limit lower="{limits[0]}" upper="{limits[1]}" velocity="1" effort="50"/>'
    inner = "" if kind == "fixed" else f'<axis xyz="{axis}"/>{limit}'
    follows = f'<mimic joint="{mimic}"/>' if mimic else ""
    return (
        f'<joint name="{name}" type="{kind}"><origin xyz="{xyz}"/><parent link="{parent}"/>'
        f'<child link="{child}"/>{inner}{follows}</joint>\n'
    )


def robot(name, *parts):
    return f'<robot name="{name}">\n{"".join(parts)}</robot>\n'


def arm(prefix="", base="base"):
    """Six joints in a row; the last link, `wrist`, turns about its Z."""
    p = prefix
    sizes = [("0.1 0.1 0.2", 0.1), ("0.08 0.08 0.36", 0.22), ("0.07 0.07 0.3", 0.2)]
    parts = []
    at, parent = "0 0 0.1", base
    for i, ((size, middle), axis) in enumerate(
        zip(sizes, ("0 0 1", "0 1 0", "0 1 0"), strict=True)
    ):
        parts.append(box(f"{p}link_{i}", f"0 0 {middle}", size))
        parts.append(joint(f"{p}joint_{i}", "revolute", parent, f"{p}link_{i}", at, axis))
        at, parent = f"0 0 {0.24 + 0.18 * (i > 0)}", f"{p}link_{i}"
    parts.append(link(f"{p}link_3") + joint(f"{p}joint_3", "revolute", parent, f"{p}link_3", at))
    parts.append(box(f"{p}link_4", "0 0 0.05", "0.06 0.06 0.05"))
    parts.append(joint(f"{p}joint_4", "revolute", f"{p}link_3", f"{p}link_4", "0 0 0", "0 1 0"))
    parts.append(box(f"{p}wrist", "0 0 0.02", "0.05 0.05 0.02"))
    parts.append(joint(f"{p}joint_5", "revolute", f"{p}link_4", f"{p}wrist", "0 0 0.1"))
    return "".join(parts)


def base(name="base"):
    return box(name, "0 0 0.04", "0.2 0.2 0.08")


def palm(prefix="", parent="wrist"):
    made = box(f"{prefix}palm", "0 0 0.02", "0.04 0.1 0.04")
    return made + joint(f"{prefix}mount", "fixed", parent, f"{prefix}palm", "0 0 0.03")


def prismatic(prefix="", parent="wrist", mimic=True):
    """Two fingers of 80 mm, 20 mm wide and 10 mm thick, up to 60 mm apart."""
    p = prefix
    follows = f"{p}slide_left" if mimic else ""
    return (
        palm(p, parent)
        + box(f"{p}left", "0 0.005 0.04", "0.02 0.01 0.08")
        + box(f"{p}right", "0 -0.005 0.04", "0.02 0.01 0.08")
        + joint(f"{p}slide_left", "prismatic", f"{p}palm", f"{p}left", "0 0 0.04", "0 1 0", (0, 0.03))
        + joint(
            f"{p}slide_right", "prismatic", f"{p}palm", f"{p}right", "0 0 0.04", "0 -1 0",
            (0, 0.03), follows,
        )
    )  # fmt: skip


def revolute():
    """Two fingers of 90 mm that turn inwards for positive angles."""
    return (
        palm()
        + box("left_finger", "0 0 0.045", "0.02 0.01 0.09")
        + box("right_finger", "0 0 0.045", "0.02 0.01 0.09")
        + joint("turn_left", "revolute", "palm", "left_finger", "0 0.04 0.04", "1 0 0", (-0.2, 1.0))
        + joint(
            "turn_right", "revolute", "palm", "right_finger", "0 -0.04 0.04", "-1 0 0",
            (-0.2, 1.0), "turn_left",
        )
    )  # fmt: skip


def linkage():
    """Fingers on parallelograms: an outer bar, a pad that stays parallel, and a shorter inner bar.

    One joint drives the five others.
    """
    made = palm()
    for side, sign in (("left", 1), ("right", -1)):
        axis, follows = f"{sign} 0 0", "" if side == "left" else "left_outer_joint"
        made += box(f"{side}_outer", "0 0 0.03", "0.01 0.01 0.06")
        made += joint(
            f"{side}_outer_joint",
            "revolute",
            "palm",
            f"{side}_outer",
            f"0 {sign * 0.045} 0.04",
            axis,
            (0, 0.7),
            follows,
        )
        made += box(f"{side}_pad", f"0 {-sign * 0.008} 0.03", "0.022 0.008 0.06")
        made += joint(
            f"{side}_pad_joint",
            "revolute",
            f"{side}_outer",
            f"{side}_pad",
            "0 0 0.06",
            f"{-sign} 0 0",
            (0, 0.7),
            "left_outer_joint",
        )
        made += box(f"{side}_inner", "0 0 0.025", "0.01 0.006 0.05")
        made += joint(
            f"{side}_inner_joint",
            "revolute",
            "palm",
            f"{side}_inner",
            f"0 {sign * 0.028} 0.045",
            axis,
            (0, 0.7),
            "left_outer_joint",
        )
    return made


def one_jaw():
    """A jaw that turns against a fixed one."""
    return (
        palm()
        + box("fixed_jaw", "0 0.005 0.05", "0.02 0.01 0.1")
        + joint("fixed_mount", "fixed", "palm", "fixed_jaw", "0 0 0.04")
        + box("moving_jaw", "0 -0.005 0.045", "0.02 0.01 0.09")
        + joint("jaw", "revolute", "fixed_jaw", "moving_jaw", "0 -0.005 0.01", "-1 0 0", (-1.4, 0))
    )


def spinning_horn():
    """A motor's horn on the palm between two fingers: it turns about its own middle."""
    return (
        prismatic()
        + box("horn", "0 0 0", "0.02 0.02 0.004")
        + joint("motor", "continuous", "palm", "horn", "0.03 0 0.02", "0 0 1")
    )


def legs():
    """Four legs on a trunk that also carries the arm."""
    made = box("trunk", "0 0 0", "0.5 0.3 0.1") + joint(
        "stand", "fixed", "trunk", "base", "0 0 0.05"
    )
    for x in (-0.2, 0.2):
        for y in (-0.2, 0.2):
            name = f"leg_{x}_{y}"
            made += box(name, "0 0 -0.2", "0.05 0.05 0.4")
            made += joint(
                f"{name}_joint", "revolute", "trunk", name, f"{x} {y} 0", "0 1 0", (-1, 1)
            )
    return made


def three_fingers():
    """Two fingers side by side, a third one opposite; each has two joints that bend inwards."""
    made = palm().replace("0.04 0.1 0.04", "0.09 0.1 0.04")
    places = {"index": ("0.03 0.04", "1 0 0"), "middle": ("-0.03 0.04", "1 0 0"),
              "opposed": ("0 -0.04", "-1 0 0")}  # fmt: skip
    for name, (at, axis) in places.items():
        for part, parent, xyz in (
            ("near", "palm", f"{at} 0.03"),
            ("far", f"{name}_near", "0 0 0.05"),
        ):
            made += box(f"{name}_{part}", "0 0 0.025", "0.015 0.015 0.05")
            made += joint(
                f"{name}_{part}_joint", "revolute", parent, f"{name}_{part}", xyz, axis, (-0.2, 1.6)
            )
    return made


def split_palm(driver=""):
    """Three fingers on a palm, and two more on a part of it that `driver` or a joint of it turns."""
    made = three_fingers()
    made += box("part", "0 0 0.02", "0.02 0.02 0.04") + joint(
        "turn", "revolute", "palm", "part", "0.08 0 0", "0 0 1", (-0.2, 1.6), driver
    )
    for name, y in (("ring", "0.02"), ("little", "-0.02")):
        made += box(name, "0 0 0.025", "0.015 0.015 0.05")
        made += joint(
            f"{name}_joint", "revolute", "part", name, f"0 {y} 0.05", "1 0 0", (-0.2, 1.6)
        )
    return made


def gripper(name="gripper", hand=None):
    return robot(name, base(), arm(), prismatic() if hand is None else hand)
