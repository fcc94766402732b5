// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <array>
#include <fstream>

#include <gtest/gtest.h>

#include "graspless/geometry/shape.hpp"

#include "complaint.hpp"

namespace graspless::geometry {
namespace {

std::string off_file(const std::string& text) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = ::testing::TempDir() + "graspless_" + test->name() + ".off";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

TEST(ReadOff, ReadsOffOfEveryKind) {
  const std::vector<std::string> texts{
      "OFF\n3 1 0\n0 0 2.5\n-1 0.25 2.5\n-2 1 2.5\n3 0 1 2\n",
      "# a comment\nOFF # another\n3 1 0\n\n0 0 2.5#\n-1 +.25 25e-1 -2 1\n2.5 3 0 1 2 255 0 0",
      "OFF3 1 0\r\n0 0 2.5\r\n-1 0.25 2.5\r\n-2 1 2.5\r\n3 0 1 2\r\n",
      "COFF\n3 1 0\n0 0 2.5 red\n-1 0.25 2.5 1 0 0\n-2 1 2.5\n3 0 1 2 0.5\n",
      "STCNOFF\n3 1 0\n0 0 2.5 0 0 1 1 1 1 0 0\n-1 0.25 2.5 0\n-2 1 2.5 0\n3 0 1 2\n",
      "4OFF\n3 1 0\n0 0 5 2\n-2 0.5 5 2\n-4 2 5 2\n3 0 1 2\n"};
  for (const std::string& text : texts) {
    const Mesh mesh = read_mesh(off_file(text));
    EXPECT_EQ(mesh.vertices.transpose(),
              (Eigen::Matrix3d() << 0, 0, 2.5, -1, 0.25, 2.5, -2, 1, 2.5).finished())
        << text;
    EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2)) << text;
  }
}

TEST(ReadOff, NamesTheFaultOfAnOff) {
  const std::string points = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
  const std::vector<std::array<std::string, 2>> cases = {
      {"", "begins with ''; choose from OFF"},
      {"nOFF\n3\n3 1 0\n", "begins with 'nOFF'; choose from OFF"},
      {"OFF BINARY\n", "is a binary .off file; save it as text"},
      {"OFF\n-1 1 0\n", "number of vertices: '-1' is not a whole number in [0, 4294967295]"},
      {"OFF\n3 1.5 0\n", "number of faces: '1.5' is not a whole number"},
      {"OFF\n1000000000 1 0\n0 0 0\n", "vertex 1: the file ends"},
      {"OFF\n3 1 0\n0 0 0\n1 a 0\n", "vertex 1: 'a' is not a number"},
      {points + "400000000 0 1 2\n", "face 0: the file ends"},
      {points + "3 0 1 -2\n", "face 0: '-2' is not a whole number"},
      {points + "3 0 1 7\n", "refers to vertex 7 of 3"},
  };
  for (const auto& [text, fault] : cases) {
    const std::string error = complaint([&] { read_mesh(off_file(text)); });
    EXPECT_NE(error.find(fault), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace graspless::geometry
