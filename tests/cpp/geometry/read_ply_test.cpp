// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cstring>
#include <fstream>

#include <gtest/gtest.h>

#include "graspless/geometry/shape.hpp"

#include "complaint.hpp"

namespace graspless::geometry {
namespace {

std::string ply_file(const std::string& text) {
  const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
  const std::string path = ::testing::TempDir() + "graspless_" + test->name() + ".ply";
  std::ofstream(path, std::ios::binary) << text;
  return path;
}

std::string ply(const std::string& header, const std::string& body) {
  return "ply\nformat ascii 1.0\n" + header + "end_header\n" + body;
}

constexpr const char* kPlyVertices =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";

TEST(ReadPly, ReadsPlyOfEveryFormat) {
  const auto header = [](const std::string& format) {
    return "ply\nformat " + format + " 1.0\ncomment x\nelement vertex 3\nproperty uchar red\n" +
           "property short x\nproperty double y\nproperty float32 z\nelement extra 1\n" +
           "property list ushort int8 bag\nelement face 1\nproperty list uint uint8 vertex_index" +
           "\nend_header\n";
  };
  const auto binary = [](bool big) {
    std::string body;
    const auto put = [&](auto number) {
      std::string raw(sizeof number, ' ');
      std::memcpy(raw.data(), &number, sizeof number);
      if (big) std::reverse(raw.begin(), raw.end());
      body += raw;
    };
    for (int i = 0; i < 3; ++i) {
      put(static_cast<unsigned char>(255));
      put(static_cast<short>(-i));
      put(0.25 * i * i);
      put(2.5F);
    }
    put(static_cast<unsigned short>(1));
    put(static_cast<signed char>(-7));
    put(3U);
    for (const char corner : {'\0', '\1', '\2'}) put(corner);
    return body;
  };
  const std::vector<std::string> texts = {
      (header("ascii") + "255 0 0 2.5\n255 -1 .25 +2.5\r\n255 -2 1 25e-1\n1 -7\n" + "3 0 1 2"),
      (header("binary_little_endian") + binary(false)),
      (header("binary_big_endian") + binary(true))};
  for (const std::string& text : texts) {
    const Mesh mesh = read_mesh(ply_file(text));
    EXPECT_EQ(mesh.vertices.transpose(),
              (Eigen::Matrix3d() << 0, 0, 2.5, -1, 0.25, 2.5, -2, 1, 2.5).finished())
        << text;
    EXPECT_EQ(mesh.triangles, Eigen::Vector3i(0, 1, 2)) << text;
  }
}

TEST(ReadPly, NamesTheFaultOfAPly) {
  const std::string points = "0 0 0\n1 0 0\n0 1 0\n";
  const std::string list = "property list int int vertex_indices\n";
  const std::vector<std::array<std::string, 2>> cases = {
      {"ply\nformat ascii 1.0\nproperty float x\n", "line 3 has a property before any element"},
      {"ply\nformat ascii 1.0\n", "line 3 is missing"},
      {"ply\nformat binary 1.0\n", "line 2 has format 'binary'; choose from ascii"},
      {ply("element vertex -1\n", ""), "line 3 has count '-1' of element 'vertex'"},
      {ply("element vertex 1\nproperty long x\n", ""), "line 4 has type 'long'; choose from char"},
      {ply("element vertex 1\nproperty int x\nproperty int x\n", ""), "property 'x' again"},
      {ply("element vertex 0\nproperty int x\n", ""), "'vertex' has no property 'y'"},
      {ply("element thing 9\n", ""), "element 'thing' has no property"},
      {ply("element vertex 4000000000\nproperty float x\n", "1 2 3\n"),
       "states 4000000000 of element 'vertex', but the rest of the file holds 3 at most"},
      {ply("element vertex 1\nproperty float x\nproperty float y\nproperty float z\n", "0 a 0\n"),
       "vertex 0: 'a' is not a number"},
      {ply("element vertex 1\nproperty float x\nproperty float y\nproperty float z\n",
           "1e300 0 0\n"),
       "vertex 0: '1e300' is too large for a float"},
      {ply(kPlyVertices + ("element face 1\n" + list), points + "400000000 0 1 2\n"),
       "face 0: list 'vertex_indices' states length 4e+08, but the rest of the file holds 0 to 4"},
      {ply(kPlyVertices + ("element face 1\n" + list), points + "-1 0 1 2\n"), "states length -1"},
      {ply(kPlyVertices + ("element face 1\n" + list), points + "3 0 1 -2\n"),
       "face 0: -2 is not the index of a vertex"},
      {ply(kPlyVertices + ("element face 2\n" + list), points + "3 0 1 2 3 0\n"),
       "face 1: list 'vertex_indices' states length 3"},
      {ply(kPlyVertices + std::string("element face 1\nproperty int vertex_indices\n"),
           points + "3"),
       "has no list 'vertex_indices'"},
  };
  for (const auto& [text, fault] : cases) {
    const std::string error = complaint([&] { read_mesh(ply_file(text)); });
    EXPECT_NE(error.find(fault), std::string::npos) << error;
  }
}

}  // namespace
}  // namespace graspless::geometry
