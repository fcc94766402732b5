// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <cstdlib>
#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include "graspless/robot/description.hpp"

#include "paths.hpp"
#include "robot/robots.hpp"

namespace graspless::robot {
namespace {

namespace fs = std::filesystem;

/// A folder of its own, and environment variables that are set back.
class Packages : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(::testing::TempDir()) / ("packages_" + std::string(test->name()));
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "robots" / "arm" / "urdf");
  }
  void TearDown() override {
    fs::remove_all(folder_);
    unsetenv("ROS_PACKAGE_PATH");
    unsetenv("AMENT_PREFIX_PATH");
  }

  std::string make_package(const std::string& path, const std::string& mesh = "t.obj") const {
    fs::create_directories(folder_ / path);
    fs::copy(data_file("tetrahedron.obj"), folder_ / path / mesh);
    return fs::canonical(folder_ / path).string();
  }

  Description arm(const std::string& mesh, const std::string& kind = "collision") const {
    return {"<robot name='r'><link name='a'><" + kind + "><geometry><mesh filename='" + mesh +
                "'/></geometry></" + kind + "></link></robot>",
            "",
            {},
            (folder_ / "robots" / "arm" / "urdf").string()};
  }

  std::string found(const std::string& mesh = "package://mine/t.obj") const {
    return find_packages(arm(mesh)).at("mine");
  }

  fs::path folder_;
};

TEST_F(Packages, AreFoundBesideTheUrdf) {
  EXPECT_CONTAINS(complaint([&] { found(); }),
                  "collision shape of link 'a': mesh 'package://mine/t.obj': package 'mine' was "
                  "not found; looked in packages, ROS_PACKAGE_PATH (not set), AMENT_PREFIX_PATH "
                  "(not set) and in the folders above '");
  const std::string contained = make_package("mine");
  EXPECT_EQ(found(), contained);
  EXPECT_EQ(found("package:///mine/t.obj"), contained);
  fs::create_directories(folder_ / "robots" / "mine");
  EXPECT_EQ(found(), contained);  // the nearer one does not contain the mesh
  EXPECT_EQ(found("package://mine//t.obj"), contained);
  fs::create_directories(folder_ / "robots" / "mine" / "meshes");
  EXPECT_EQ(make_package("robots/mine/meshes", "other.obj"),
            found("package://mine/meshes/other.obj") + "/meshes");
}

TEST_F(Packages, AreFoundAboveTheUrdf) {
  const std::string above = make_package("robots/arm");
  EXPECT_EQ(find_packages(arm("package://arm/t.obj")).at("arm"), above);
}

TEST_F(Packages, AreFoundWhetherPicturesComeFirstOrLast) {
  const std::string folder = make_package("robots/collision");
  Description both = arm("package://mine/collision/t.obj");
  const std::string picture =
      "<visual><geometry><mesh filename='package://mine/visual/t.obj'/></geometry></visual>";
  const std::string urdf = both.urdf;
  for (const char* at : {"<collision>", "</link>"}) {
    both.urdf = std::string(urdf).insert(urdf.find(at), picture);
    EXPECT_EQ(find_packages(both).at("mine") + "/collision", folder) << at;
  }
}

TEST_F(Packages, MayHaveAFolderOfAnotherName) {
  const std::string folder = make_package("robots/arm/meshes");
  EXPECT_EQ(found("package://mine/meshes/t.obj") + "/meshes", folder);
}

TEST_F(Packages, AreFoundInTheEnvironment) {
  const std::string workspace = make_package("workspace/mine"),
                    prefix = make_package("p/share/mine");
  setenv("AMENT_PREFIX_PATH", ("/none:" + (folder_ / "p").string()).c_str(), 1);
  EXPECT_EQ(fs::canonical(found()).string(), prefix);
  setenv("ROS_PACKAGE_PATH", (folder_ / "workspace").c_str(), 1);
  EXPECT_EQ(fs::canonical(found()).string(), workspace);
  Description given = arm("package://mine/t.obj");
  given.packages["mine"] = "/given";
  EXPECT_EQ(find_packages(given).at("mine"), "/given");
}

TEST_F(Packages, OfPicturesMayBeMissing) {
  EXPECT_TRUE(find_packages(arm("package://mine/t.obj", "visual")).empty());
  EXPECT_TRUE(find_packages(arm("package://mine", "visual")).empty());
  EXPECT_TRUE(find_packages({"<robot", "", {}, ""}).empty());  // the reader of robots refuses it
  EXPECT_CONTAINS(complaint([&] { find_packages(arm("package://../t.obj")); }),
                  "'..' was not found");
  EXPECT_CONTAINS(complaint([&] { find_packages(arm("package://mine")); }), "names no file");
}

TEST_F(Packages, OfAFolderWhoseNameHasTheEndingOfRobots) {
  make_package("mine");
  fs::create_directories(folder_ / "robots.urdf");
  std::ofstream(folder_ / "robots.srdf") << "no SRDF of the robot";
  const std::string path = (folder_ / "robots.urdf" / "arm.xml").string();
  std::ofstream(path) << arm("package://mine/t.obj").urdf;
  EXPECT_TRUE(Robot::from_urdf_file(path).options().srdf.empty());
}

TEST_F(Packages, AreFoundForFiles) {
  make_package("mine");
  const std::string path = (folder_ / "robots" / "arm" / "urdf" / "arm.urdf").string();
  std::ofstream(path) << arm("package://mine/t.obj").urdf;
  const Robot robot = Robot::from_urdf_file(path);
  EXPECT_EQ(robot.shapes().size(), 1u);
  EXPECT_EQ(robot.options().packages.count("mine"), 1u);
  std::ofstream(path) << arm("package://mine/none.stl").urdf;
  const std::string fault = complaint([&] { Robot::from_urdf_file(path); });
  EXPECT_CONTAINS(fault, "'package://mine/none.stl': mesh '");
  EXPECT_CONTAINS(fault, "/mine/none.stl' is missing");
}

}  // namespace
}  // namespace graspless::robot
