// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <clocale>
#include <locale>

#include <gtest/gtest.h>

#include "graspless/robot/robot.hpp"

#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

const std::string kLimit = "<limit lower='-1.5' upper='1.5' velocity='1' effort='1'/>";

std::string joint(const std::string& name, const std::string& parent, const std::string& child,
                  const std::string& more = kLimit, const std::string& type = "revolute") {
  return "<joint name='" + name + "' type='" + type + "'><parent link='" + parent +
         "'/><child link='" + child + "'/><axis xyz='0 0 1'/>" + more + "</joint>";
}

std::string links(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += "<link name='" + name + "'/>";
  return text;
}

Robot read(const std::string& body, const Robot::Options& options = {}) {
  return Robot::from_urdf("<robot name='r'>" + body + "</robot>", options);
}

std::string refused(const std::string& body, const Robot::Options& options = {}) {
  return complaint([&] { read(body, options); });
}

std::string with_shape(const std::string& geometry) {
  return "<link name='a'><collision><geometry>" + geometry + "</geometry></collision></link>";
}

TEST(UrdfReader, RefusesWhatIsNoUrdf) {
  EXPECT_EQ(complaint([] { Robot::from_urdf("", {}); }), "URDF: not XML: has no element");
  EXPECT_EQ(complaint([] { Robot::from_urdf("robot", {}); }), "URDF: not XML: has no element");
  EXPECT_CONTAINS(complaint([] { Robot::from_urdf("<robot name='r'>\n<link", {}); }), "line 2");
  EXPECT_CONTAINS(complaint([] { Robot::from_urdf("<model/>", {}); }), "no <robot>");
  EXPECT_CONTAINS(complaint([] { Robot::from_urdf("<robot><link name='a'/></robot>", {}); }),
                  "name");
  EXPECT_EQ(complaint([] { Robot::from_urdf_file("/no/such.urdf"); }),
            "/no/such.urdf: cannot be read: No such file or directory");
  EXPECT_EQ(complaint([] { Robot::from_urdf_file(data_file()); }),
            data_file() + ": cannot be read: is a folder, not a file");
  EXPECT_CONTAINS(refused(""), "no links");
  EXPECT_CONTAINS(refused("<link/>"), "no attribute 'name'");
}

TEST(UrdfReader, RefusesWhatIsNoTree) {
  EXPECT_CONTAINS(refused(links({"a", "a"})), "link 'a' occurs twice");
  EXPECT_CONTAINS(refused(links({"a", "b"})), "more than one root link: 'a' and 'b'");
  EXPECT_CONTAINS(refused(links({"a", "b", "c"}) + joint("j", "a", "b") + joint("j", "b", "c")),
                  "joint 'j' occurs twice");
  EXPECT_CONTAINS(refused(links({"a"}) + joint("j", "a", "b")), "its child 'b' is not a link");
  EXPECT_CONTAINS(refused(links({"a"}) + joint("j", "b", "a")), "its parent 'b' is not a link");
  EXPECT_CONTAINS(refused(links({"a", "b"}) + joint("j", "a", "b") + joint("k", "b", "a")),
                  "cycle");
  EXPECT_CONTAINS(refused(links({"a", "b", "c"}) + joint("j", "b", "c") + joint("k", "c", "b")),
                  "cycle");
  EXPECT_CONTAINS(refused(links({"a", "b"}) + joint("j", "b", "b")), "cycle");
  EXPECT_CONTAINS(refused(links({"a", "b", "c"}) + joint("j", "a", "b") + joint("k", "a", "c") +
                          joint("l", "c", "b")),
                  "link 'b' has two parent joints, 'j' and 'l': a closed chain");
  EXPECT_CONTAINS(refused(links({"a"}) + "<joint name='j' type='fixed'><child link='a'/></joint>"),
                  "joint 'j' has no <parent>");
}

TEST(UrdfReader, RefusesJointsThatCannotBe) {
  const auto two = [](const std::string& more, const std::string& type = "revolute") {
    return refused(links({"a", "b"}) + joint("elbow", "a", "b", more, type));
  };
  EXPECT_CONTAINS(two(""),
                  "URDF line 1: revolute joint 'elbow' has no limits; give <limit lower=... "
                  "upper=... effort=... velocity=...> or make it continuous");
  EXPECT_CONTAINS(two("<limit velocity='1' effort='1'/>", "prismatic"),
                  "joint 'elbow' has no limits");
  EXPECT_CONTAINS(two("<limit lower='2' upper='1' velocity='1' effort='1'/>"), "'elbow': lower 2");
  EXPECT_CONTAINS(two("<limit lower='nan' upper='1' velocity='1' effort='1'/>"), "nan");
  EXPECT_CONTAINS(two("<limit lower='0' upper='1,5' velocity='1' effort='1'/>"), "1,5");
  EXPECT_CONTAINS(two("", "spherical"), "type 'spherical'; choose from revolute");
  for (const std::string type : {"floating", "planar"}) {
    EXPECT_CONTAINS(refused(links({"a", "b", "c"}) + joint("one", "a", "b") +
                            joint("two", "b", "c", kLimit, type)),
                    "joint 'two' is of type '" + type + "', which is possible at the root alone");
  }
  EXPECT_CONTAINS(refused(links({"a", "b"}) +
                          "<joint name='j' type='continuous'><parent link='a'/><child link='b'/>"
                          "<axis xyz='0 0 0'/></joint>"),
                  "joint 'j': its axis must not be zero");
  EXPECT_CONTAINS(two(kLimit + "<origin xyz='0 0'/>"), "0 0");
}

TEST(UrdfReader, FixesABaseThatFloats) {
  for (const std::string type : {"floating", "planar"}) {
    const Robot robot = read(links({"world", "base", "arm"}) +
                             joint("float", "world", "base", "<origin xyz='0 0 2'/>", type) +
                             joint("turn", "base", "arm"));
    EXPECT_EQ(robot.joint_names(), std::vector<std::string>{"turn"});
    EXPECT_EQ(robot.pose(2, Eigen::VectorXd::Zero(1)).translation().z(), 2);
    EXPECT_EQ(robot.warnings(), std::vector<std::string>{"URDF line 1: joint 'float' is of type '" +
                                                         type + "'; treated as fixed"});
  }
}

// The specification requires both. Files of real robots lack them, and no planner needs them.
TEST(UrdfReader, WarnsOfLimitsWithoutEffortOrVelocity) {
  const std::string chain =
      links({"a", "b", "c"}) + joint("one", "a", "b", "<limit lower='-1' upper='2.5'/>") +
      joint("two", "b", "c", "<limit effort='3' lower='-1' upper='0.125'/>", "prismatic");
  const Robot robot = read(chain);
  const std::string taken = ", which is taken as unknown: joints ";
  EXPECT_EQ(robot.warnings(),
            (std::vector<std::string>{"URDF: <limit> without effort" + taken + "'one'",
                                      "URDF: <limit> without velocity" + taken + "'one', 'two'"}));
  EXPECT_EQ(robot.upper(), Eigen::Vector2d(2.5, 0.125));
  EXPECT_TRUE(std::isinf(robot.max_effort()[0]));
  EXPECT_EQ(robot.max_effort()[1], 3);
  EXPECT_TRUE(std::isinf(robot.max_velocity().minCoeff()));
  EXPECT_EQ(robot.urdf(), "<robot name='r'>" + chain + "</robot>");
}

TEST(UrdfReader, ReadsCapsulesThatUrdfDoesNotHave) {
  const std::string of = "<origin xyz='0.1 0.2 0.3' rpy='0.4 -1 2'/><geometry>";
  const std::string capsule = of + "<capsule radius='0.05' length='0.2'/></geometry>";
  const std::string link =
      "<link name='a'><visual><geometry><capsule radius='1' length='1'/>"
      "</geometry></visual><collision>";
  const Robot robot = read(link + capsule + "</collision></link>");
  EXPECT_TRUE(robot.warnings().empty());
  ASSERT_EQ(robot.shapes().size(), 1u);
  const auto& placed = robot.shapes()[0].placed;
  const auto& found = std::get<geometry::Capsule>(placed.shape);
  EXPECT_EQ(found.radius, 0.05);
  EXPECT_EQ(found.length, 0.2);
  const Eigen::Isometry3d X_LG = Eigen::Translation3d(0.1, 0.2, 0.3) *
                                 Eigen::AngleAxisd(2, Eigen::Vector3d::UnitZ()) *
                                 Eigen::AngleAxisd(-1, Eigen::Vector3d::UnitY()) *
                                 Eigen::AngleAxisd(0.4, Eigen::Vector3d::UnitX());
  EXPECT_TRUE(placed.X_BG.isApprox(X_LG, 1e-9));
  EXPECT_CONTAINS(refused(link + "<geometry><capsule radius='1'/></geometry></collision></link>"),
                  "URDF line 1: <capsule> has no attribute 'length'");
  EXPECT_CONTAINS(refused(link + of +
                          "<capsule radius='1' length='x'/></geometry></collision>"
                          "</link>"),
                  "URDF line 1: <capsule>: ");
}

TEST(UrdfReader, WarnsOfLimitsBelowZero) {
  const Robot robot =
      read(links({"a", "b"}) +
           joint("elbow", "a", "b", "<limit lower='0' upper='1' velocity='-2' effort='-5'/>"));
  EXPECT_EQ(robot.warnings(), (std::vector<std::string>{
                                  "the velocity limit of joint 'elbow' is -2, taken for no limit",
                                  "the effort limit of joint 'elbow' is -5, taken for no limit"}));
  EXPECT_EQ(robot.max_velocity()[0], std::numeric_limits<double>::infinity());
}

TEST(UrdfReader, KeepsToSoftLimits) {
  const auto elbow = [](const std::string& safety, const std::string& type = "revolute") {
    return read(links({"a", "b"}) +
                joint("elbow", "a", "b", kLimit + "<safety_controller " + safety + "/>", type));
  };
  const auto expect_bounds = [](const Robot& robot, double lower, double upper) {
    EXPECT_EQ(robot.lower()[0], lower);
    EXPECT_EQ(robot.upper()[0], upper);
  };
  expect_bounds(elbow("k_velocity='1' soft_lower_limit='-1' soft_upper_limit='1.25'"), -1, 1.25);
  expect_bounds(elbow("k_velocity='1' soft_lower_limit='-1' soft_upper_limit='9'"), -1, 1.5);
  expect_bounds(elbow("k_velocity='1'"), -1.5, 1.5);  // gains alone
  expect_bounds(elbow("k_velocity='1' soft_lower_limit='-1' soft_upper_limit='1'", "continuous"),
                -M_PI, M_PI);
  const Robot beyond = elbow("k_velocity='1' soft_lower_limit='2' soft_upper_limit='3'");
  expect_bounds(beyond, -1.5, 1.5);
  EXPECT_EQ(beyond.warnings(), std::vector<std::string>{"the soft limits of joint 'elbow' are "
                                                        "beyond its limits; ignored"});
}

TEST(UrdfReader, PutsStatesOfTheSrdfWithinSoftLimits) {
  Robot::Options options;
  const std::string state = "<robot name='r'><group_state name='home'><joint name='elbow' value='";
  const std::string arm =
      links({"a", "b"}) + joint("elbow", "a", "b",
                                kLimit +
                                    "<safety_controller k_velocity='1' soft_lower_limit='-1' "
                                    "soft_upper_limit='1'/>");
  options.srdf = state + "1.5'/></group_state></robot>";
  const Robot robot = read(arm, options);
  EXPECT_EQ(robot.state("home")[0], 1);
  EXPECT_EQ(robot.warnings(), std::vector<std::string>{"a state has joint 'elbow' at 1.5, beyond "
                                                       "its soft limit 1, which is used"});
  options.srdf = state + "1.6'/></group_state></robot>";
  const Robot outside = read(arm, options);
  EXPECT_CONTAINS(complaint([&] { outside.state("home"); }), "1.6 is outside its limits -1.5 to 1");
}

TEST(UrdfReader, WarnsOfVelocityLimitsOfZero) {
  const std::string limit = "<limit lower='0' upper='1' effort='1' velocity='", kZero = "0.0'/>";
  const Robot robot =
      read(links({"free", "a", "b", "c", "d", "e"}) +
           joint("root", "free", "a", limit + kZero, "floating") +
           joint("elbow", "a", "b", limit + kZero) + joint("wrist", "b", "c", limit + "0.5'/>") +
           joint("echo", "c", "d", limit + kZero + "<mimic joint='wrist'/>") +
           joint("weld", "d", "e", limit + kZero, "fixed"));
  EXPECT_EQ(
      robot.warnings(),
      (std::vector<std::string>{"URDF line 1: joint 'root' is of type 'floating'; treated as fixed",
                                "URDF: <limit> with velocity 0, which is taken as unknown; "
                                "give the largest speed in rad/s or m/s: joints 'elbow'"}));
  EXPECT_TRUE(std::isinf(robot.max_velocity()[0]));
  EXPECT_EQ(robot.max_velocity()[1], 0.5);
}

// Such links are in pictures, but planning passes through them. Frames have neither shape.
TEST(UrdfReader, WarnsOfLinksThatAreOnlyVisual) {
  const std::string sphere = "<geometry><sphere radius='1'/></geometry>";
  const std::string seen = "<visual>" + sphere + "</visual>";
  const std::string solid = "<collision>" + sphere + "</collision>";
  const auto link = [](const std::string& name, const std::string& shapes) {
    return "<link name='" + name + "'>" + shapes + "</link>";
  };
  const std::string begin =
      "URDF: links with a <visual> but no <collision>, which planning lets pass through "
      "everything: ";
  const std::string end = "; give each a <collision>, or leave out its <visual>";
  const std::string base = link("a", seen + solid) + link("frame", "") + joint("one", "a", "frame");
  EXPECT_TRUE(read(base).warnings().empty());
  EXPECT_EQ(read(base + link("b", seen + seen) + joint("two", "a", "b", "", "floating")).warnings(),
            (std::vector<std::string>{
                begin + "'b'" + end,
                "URDF line 1: joint 'two' is of type 'floating'; treated as fixed"}));
  std::string many = base;
  for (const char* name : {"b", "c", "d", "e", "f", "g", "h"})
    many += link(name, seen) + joint(std::string("to_") + name, "a", name);
  EXPECT_EQ(read(many).warnings(),
            std::vector<std::string>{begin + "'b', 'c', 'd', 'e', 'f' and 2 more" + end});
}

TEST(UrdfReader, WarnsOfInertialsWithoutMassOrInertia) {
  const std::string inertia = "<inertia ixx='1' ixy='0' ixz='0' iyy='1' iyz='0' izz='1'/>";
  const Robot robot =
      read("<link name='a'><inertial><mass value='1'/></inertial></link><link name='b'><inertial>" +
           inertia + "</inertial></link><link name='c'><inertial><mass value='1'/>" + inertia +
           "</inertial></link>" + joint("one", "a", "b") + joint("two", "b", "c"));
  EXPECT_EQ(robot.warnings(),
            std::vector<std::string>{
                "URDF: <inertial> without mass or inertia, which planning ignores and "
                "simulation needs: links 'a', 'b'"});
  EXPECT_EQ(robot.dof(), 2);
}

TEST(UrdfReader, RefusesMimicsOfNothing) {
  const auto chain = [](const std::string& first, const std::string& second) {
    return links({"a", "b", "c"}) + joint("one", "a", "b", kLimit + first) +
           joint("two", "b", "c", kLimit + second);
  };
  EXPECT_CONTAINS(refused(chain("<mimic joint='three'/>", "")),
                  "joint 'one': mimicked joint 'three'; choose from one, two");
  EXPECT_CONTAINS(refused(chain("<mimic joint='two'/>", "<mimic joint='one'/>")), "mimics itself");
  EXPECT_CONTAINS(refused(chain("<mimic joint='one'/>", "")), "mimics itself");
  EXPECT_CONTAINS(refused(links({"a", "b", "c"}) + joint("weld", "a", "b", "", "fixed") +
                          joint("j", "b", "c", kLimit + "<mimic joint='weld'/>")),
                  "mimics 'weld', which is fixed");
}

TEST(UrdfReader, WarnsOfMimicsBeyondTheirLimits) {
  const auto warnings = [](const std::string& mimic) {
    return read(links({"a", "b", "c"}) + joint("one", "a", "b") +
                joint("two", "b", "c", kLimit + mimic))
        .warnings();
  };
  EXPECT_TRUE(warnings("<mimic joint='one' multiplier='-1'/>").empty());
  EXPECT_EQ(
      warnings("<mimic joint='one' multiplier='-2' offset='1'/>"),
      std::vector<std::string>{"joint 'two' mimics 'one' and moves in [-2, 4], beyond its own "
                               "limits [-1.5, 1.5]; these are ignored"});
}

TEST(UrdfReader, RefusesBadShapes) {
  EXPECT_CONTAINS(refused(with_shape("<box size='1 0 1'/>")), "link 'a'");
  EXPECT_CONTAINS(refused(with_shape("<sphere radius='-1'/>")), "link 'a'");
  EXPECT_CONTAINS(refused(with_shape("<cylinder radius='0' length='1'/>")), "link 'a'");
  EXPECT_CONTAINS(refused(with_shape("<cone radius='1'/>")), "cone");
  EXPECT_CONTAINS(refused(with_shape("")), "URDF");
  const std::string missing = refused(with_shape("<mesh filename='none.stl'/>"));
  EXPECT_CONTAINS(missing, "link 'a'");
  EXPECT_CONTAINS(missing, "none.stl");
}

TEST(UrdfReader, FindsMeshes) {
  const std::string data = data_file();
  Robot::Options options;
  options.packages["mine"] = data;
  const auto mesh = [](const std::string& path) {
    return with_shape("<mesh filename='" + path + "'/>");
  };
  EXPECT_EQ(read(mesh("package://mine/tetrahedron.obj"), options).shapes().size(), 1u);
  EXPECT_EQ(read(mesh("file://" + data + "/tetrahedron.obj")).shapes().size(), 1u);
  EXPECT_EQ(read(mesh(data + "/tetrahedron.obj")).shapes().size(), 1u);
  options.directory = data;
  EXPECT_EQ(read(mesh("tetrahedron.obj"), options).shapes().size(), 1u);
  EXPECT_CONTAINS(refused(mesh("package://yours/x.obj"), options),
                  "mesh 'package://yours/x.obj': the folder of package 'yours' is not known");
  EXPECT_CONTAINS(refused(mesh("package://mine"), options), "names no file");
}

TEST(UrdfReader, ARobotMayBeOneLink) {
  const Robot robot = read(links({"a"}));
  EXPECT_EQ(robot.dof(), 0);
  EXPECT_EQ(distance(robot.pose(0, Eigen::VectorXd(0)), Eigen::Isometry3d::Identity()), 0);
}

/// Writes and reads numbers as much of Europe does.
class Comma : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(UrdfReader, IsTheSameUnderACommaLocale) {
  const Robot before = wam();
  const std::locale old = std::locale::global(std::locale(std::locale(), new Comma));
  for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8"}) {
    if (std::setlocale(LC_ALL, name)) break;  // where there is one
  }
  const Robot after = Robot::from_urdf_file(urdf_file("wam_t42.urdf"));
  std::setlocale(LC_ALL, "C");
  std::locale::global(old);
  EXPECT_EQ(after.upper(), before.upper());
  EXPECT_EQ(after.state("home"), before.state("home"));
  const Eigen::VectorXd q = Eigen::VectorXd::Constant(8, 0.4);
  EXPECT_EQ(distance(after.pose(9, q), before.pose(9, q)), 0);
}

TEST(UrdfReader, RefusesDeepNesting) {
  const auto nested = [](int levels, const std::string& start, const std::string& end) {
    std::string text = links({"a"});
    for (int i = 0; i < levels; ++i) text += start;
    for (int i = 0; i < levels; ++i) text += end;
    return text;
  };
  EXPECT_NO_THROW(read(nested(99, "<x>", "</x>")));
  EXPECT_NO_THROW(read(nested(1000, "<x/>", "<!-- <x> --><![CDATA[<x>]]>")));
  EXPECT_NO_THROW(read(nested(1000, "<x y='<x>'></x>", "")));
  const std::string fault = "URDF line 1: elements may be nested 100 deep at most";
  EXPECT_CONTAINS(refused(nested(100, "<x>", "</x>")), fault);
  // Parts that look like end tags, to a reader less strict than TinyXML.
  for (const std::string start : {"<x>", "<x><!-- </x> -->", "<x y='/>'>", "<x y=\"</x>\">",
                                  "<x>/>", "<x><![CDATA[</x>]]>", "<x><1 '>", "<x><?y ?>"}) {
    EXPECT_CONTAINS(refused(nested(50000, start, "")), fault);
  }
  const std::string ends = nested(50000, "</x>", ""), starts = nested(50000, "<x>", "");
  EXPECT_CONTAINS(complaint([&] { Robot::from_urdf(ends + starts, {}); }), fault);
}

TEST(UrdfReader, RefusesLongChainsAndManyLinks) {
  const auto chain = [](int count) {
    const auto name = [&](int i) { return "l" + std::to_string(1000000 - i); };
    std::string text = links({name(0)});
    for (int i = 1; i <= count; ++i) {
      text += links({name(i)}) + joint("j" + std::to_string(i), name(i - 1), name(i));
    }
    return text;
  };
  EXPECT_EQ(read(chain(1000)).dof(), 1000);
  EXPECT_CONTAINS(refused(chain(1001)), "link 'l998999' is 1001 joints away from the root");
  EXPECT_CONTAINS(refused(chain(10000)), "the robot has 10001 links, more than 10000");
}

}  // namespace
}  // namespace graspless::robot
