// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/geometry/shape.hpp"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <stdexcept>

#include <gtest/gtest.h>

#include "complaint.hpp"
#include "other_locale.hpp"

namespace graspless::geometry {
namespace {

constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::string complaint_about(const Shape& shape) {
  return complaint([&] { validate(shape, "link2"); });
}

Mesh tetrahedron() {
  Mesh mesh;
  mesh.vertices.resize(3, 4);
  mesh.vertices << 0, 1, 0, 0,  //
      0, 0, 1, 0,               //
      0, 0, 0, 1;
  mesh.triangles.resize(3, 4);
  mesh.triangles << 0, 0, 0, 1,  //
      2, 1, 3, 2,                //
      1, 3, 2, 3;
  return mesh;
}

TEST(Validate, AcceptsWholeShapes) {
  EXPECT_NO_THROW(validate(Box{{1, 2, 3}}, "box"));
  EXPECT_NO_THROW(validate(Sphere{1e-6}, "sphere"));
  EXPECT_NO_THROW(validate(Capsule{0.1, 0.2}, "capsule"));
  EXPECT_NO_THROW(validate(Convex{tetrahedron().vertices}, "convex"));
  EXPECT_NO_THROW(validate(Convex{tetrahedron().vertices * 1e-4}, "convex"));
  EXPECT_NO_THROW(validate(tetrahedron(), "mesh"));
}

TEST(Validate, NamesTheFieldAndTheValue) {
  EXPECT_EQ(complaint_about(Box{{1, 0, 3}}), "link2.size[1] must be in [1e-06, 10000] m, not 0");
  EXPECT_EQ(complaint_about(Sphere{-1}), "link2.radius must be in [1e-06, 10000] m, not -1");
  EXPECT_EQ(complaint_about(Capsule{kNotANumber, 1}),
            "link2.radius must be in [1e-06, 10000] m, not nan");
  EXPECT_EQ(complaint_about(Capsule{1, kInf}), "link2.length must be in [1e-06, 10000] m, not inf");
}

TEST(Validate, RefusesAHullWithoutVolume) {
  Eigen::Matrix3Xd flat = Eigen::Matrix3Xd::Random(3, 20);
  flat.row(2) = flat.row(0) - 2 * flat.row(1);
  EXPECT_NE(complaint_about(Convex{flat}).find("span a volume"), std::string::npos);
  EXPECT_NE(complaint_about(Convex{flat.leftCols(3)}).find("not 3"), std::string::npos);
  EXPECT_NE(complaint_about(Convex{Eigen::Matrix3Xd::Ones(3, 5)}), "");
  EXPECT_NE(complaint_about(Convex{Eigen::Matrix3Xd(3, 0)}), "");
  flat(0, 7) = kInf;
  EXPECT_NE(complaint_about(Convex{flat}).find("point 7"), std::string::npos);
}

TEST(Validate, RefusesWrongIndices) {
  Mesh mesh = tetrahedron();
  mesh.triangles(1, 2) = 4;
  EXPECT_EQ(complaint_about(mesh),
            "link2.triangles must be indices of the 4 vertices, but column 2 is (0 4 2)");
  mesh.triangles(1, 2) = -1;
  EXPECT_NE(complaint_about(mesh), "");
  mesh = tetrahedron();
  mesh.vertices(0, 0) = kNotANumber;
  EXPECT_NE(complaint_about(mesh).find("vertices must be within 10000 m"), std::string::npos);
  mesh.triangles.resize(3, 0);
  EXPECT_EQ(complaint_about(mesh), "link2.triangles must not be empty");
}

class ReadMesh : public ::testing::Test {
 protected:
  void SetUp() override {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        std::filesystem::path(::testing::TempDir()) / ("graspless_" + std::string(test->name()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  std::string write(const std::string& name, const std::string& content) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << content;
    return path;
  }

  static std::string error_of_file(const std::string& path) {
    return complaint([&] { read_mesh(path); });
  }

  std::filesystem::path folder_;
};

std::string ascii_stl(const Mesh& mesh) {
  std::ostringstream out;
  out << "solid test\n";
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    out << "facet normal 0 0 0\nouter loop\n";
    for (int k = 0; k < 3; ++k) {
      out << "vertex " << mesh.vertices.col(mesh.triangles(k, i)).transpose() << "\n";
    }
    out << "endloop\nendfacet\n";
  }
  out << "endsolid test\n";
  return out.str();
}

template <typename T>
void append(std::string& bytes, T value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
}

std::string binary_stl(const Mesh& mesh, std::string header) {
  header.resize(80, ' ');
  append(header, static_cast<std::uint32_t>(mesh.triangles.cols()));
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    for (int k = 0; k < 3; ++k) append(header, 0.0f);
    for (int k = 0; k < 3; ++k) {
      for (int axis = 0; axis < 3; ++axis) {
        append(header, static_cast<float>(mesh.vertices(axis, mesh.triangles(k, i))));
      }
    }
    append(header, static_cast<std::uint16_t>(0));
  }
  return header;
}

double volume(const Mesh& mesh) {
  double six = 0;
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    const Eigen::Vector3d a = mesh.vertices.col(mesh.triangles(0, i));
    const Eigen::Vector3d b = mesh.vertices.col(mesh.triangles(1, i));
    six += a.cross(b).dot(mesh.vertices.col(mesh.triangles(2, i)));
  }
  return six / 6;
}

void expect_tetrahedron(const Mesh& mesh) {
  EXPECT_EQ(mesh.vertices.cols(), 4);
  EXPECT_EQ(mesh.triangles.cols(), 4);
  EXPECT_NEAR(volume(mesh), 1.0 / 6, 1e-12);
  EXPECT_NO_THROW(validate(mesh, "mesh"));
}

TEST_F(ReadMesh, ReadsStl) {
  expect_tetrahedron(read_mesh(write("ascii.stl", ascii_stl(tetrahedron()))));
  expect_tetrahedron(read_mesh(write("binary.stl", binary_stl(tetrahedron(), "made by hand"))));
  expect_tetrahedron(read_mesh(write("UPPER.STL", ascii_stl(tetrahedron()))));
}

TEST_F(ReadMesh, ReadsBinaryStlWhoseHeaderSaysSolid) {
  expect_tetrahedron(read_mesh(write("solid.stl", binary_stl(tetrahedron(), "solid of some CAD"))));
}

TEST_F(ReadMesh, ReadsObjOffPly) {
  expect_tetrahedron(read_mesh(write("t.obj",
                                     "# a comment\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"
                                     "f 1 3 2\nf 1\t2 4\nf\t1\t4\t3\nf 2 3\t4\n")));
  expect_tetrahedron(read_mesh(write("t.off",
                                     "OFF\n4 4 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                     "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")));
  expect_tetrahedron(read_mesh(write("t.ply",
                                     "ply\nformat ascii 1.0\nelement vertex 4\n"
                                     "property float x\nproperty float y\nproperty float z\n"
                                     "element face 4\nproperty list uchar int vertex_indices\n"
                                     "end_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n"
                                     "3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n")));
}

TEST_F(ReadMesh, ReadsObjWithTexturesAndNormals) {
  const Mesh mesh = read_mesh(write("t.obj",
                                    "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvn 0 0 1\n"
                                    "f 1/1/1 2/1/1 3/1/1\n"));
  EXPECT_EQ(mesh.triangles.cols(), 1);
}

TEST_F(ReadMesh, TriangulatesPolygons) {
  const Mesh mesh =
      read_mesh(write("cube.off",
                      "OFF\n8 6 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n0 0 1\n1 0 1\n1 1 1\n0 1 1\n"
                      "4 3 2 1 0\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n4 3 0 4 7\n"));
  EXPECT_EQ(mesh.triangles.cols(), 12);
  EXPECT_NEAR(volume(mesh), 1, 1e-12);
}

TEST_F(ReadMesh, ScalesEachAxisAndKeepsOutwardOutward) {
  const std::string path = write("t.stl", ascii_stl(tetrahedron()));
  const Mesh mesh = read_mesh(path, {2, 3, -0.5});
  EXPECT_DOUBLE_EQ(mesh.vertices.row(0).maxCoeff(), 2);
  EXPECT_DOUBLE_EQ(mesh.vertices.row(1).maxCoeff(), 3);
  EXPECT_DOUBLE_EQ(mesh.vertices.row(2).minCoeff(), -0.5);
  EXPECT_NEAR(volume(mesh), 0.5, 1e-12);
  EXPECT_NE(complaint([&] { read_mesh(path, {1, 0, 1}); }).find("scale"), std::string::npos);
  EXPECT_NE(complaint([&] {
              read_mesh(path, {1, kNotANumber, 1});
            }).find("scale"),
            std::string::npos);
}

TEST_F(ReadMesh, NamesThePathOfABadFile) {
  const std::string missing = (folder_ / "none.stl").string();
  EXPECT_EQ(error_of_file(missing), "mesh '" + missing + "' is missing");
  const std::string dae = write("mesh.dae", "<COLLADA/>");
  EXPECT_EQ(error_of_file(dae), "mesh '" + dae +
                                    "' has extension '.dae', which is read in Python only; convert "
                                    "it to .stl or .obj, or give a reader to set_mesh_reader()");
  const std::string no_extension = write("mesh", "x");
  EXPECT_NE(error_of_file(no_extension).find("extension ''"), std::string::npos);
  std::filesystem::create_directories(folder_ / "folder.stl");
  EXPECT_NE(error_of_file((folder_ / "folder.stl").string()), "");
}

TEST_F(ReadMesh, ReadsTheFacesOfAnObjWithOtherElements) {
  expect_tetrahedron(read_mesh(write("t.obj",
                                     "# lines\r\nmtllib a.mtl\no body\nv 0 0 0\r\nv 1 0 0\n"
                                     "v 0 1 0\n\tv 0 0 \\\n1\nl 1 2 3\np 1\nvn 0 0 1\nsurely not\n"
                                     "f 1 3 2\nf 1/1 2/2 \\\r\n4/3\nf 2 3 4\nf 1 4 3\nl -1 -2\n"
                                     "face 1 2 9\n")));
}

TEST_F(ReadMesh, AsksTheReaderOfOtherFormats) {
  const std::string glb = write("mesh.GLB", "x");
  set_mesh_reader([&](const std::string& path) {
    EXPECT_EQ(path, glb);
    return tetrahedron();
  });
  const Mesh mesh = read_mesh(glb, {2, 1, 1});
  EXPECT_DOUBLE_EQ(mesh.vertices.row(0).maxCoeff(), 2);
  set_mesh_reader([](const std::string&) { return Mesh{}; });
  EXPECT_NE(error_of_file(glb).find("is empty"), std::string::npos);
  set_mesh_reader({});
}

TEST_F(ReadMesh, RefusesDamagedFiles) {
  const std::string whole = binary_stl(tetrahedron(), "cut short");
  const std::vector<std::string> bad = {
      write("empty.stl", ""),
      write("empty.obj", ""),
      write("empty.off", ""),
      write("empty.ply", ""),
      write("none.off", "OFF\n0 0 0\n"),
      write("cut.stl", whole.substr(0, whole.size() - 30)),
      write("cut_ascii.stl", ascii_stl(tetrahedron()).substr(0, 200)),
      write("text.stl",
            "this is not a mesh, although it is long enough to hold a header of eighty "
            "characters and a count"),
      write("index.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n"),
      write("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
      write("negative.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n"),
      write("index.ply",
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
            "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 9\n"),
      write("greedy.ply",
            "ply\nformat ascii 1.0\nelement vertex 4000000000\nproperty float x\n"
            "property float y\nproperty float z\nend_header\n0 0 0\n"),
      write("binary.off", "OFF BINARY\n"),
      write("greedy.off", "OFF\n2000000000 2000000000 0\n0 0 0\n"),
      write("line.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 2\n"),
      write("nan.off", "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n"),
  };
  for (const std::string& path : bad) {
    EXPECT_NE(error_of_file(path).find(path), std::string::npos) << path;
  }
}

TEST_F(ReadMesh, TellsAnEmptyStlFromADamagedOne) {
  const Mesh none{Eigen::Matrix3Xd(3, 0), Eigen::Matrix3Xi(3, 0)};
  for (const std::string& text : {std::string(), ascii_stl(none), binary_stl(none, "binary")})
    EXPECT_NE(error_of_file(write("empty.stl", text)).find("is empty: it has no triangle"),
              std::string::npos);
  for (const std::string text :
       {"this is not a mesh", "solid of a CAD that was cut short",
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
        "endloop\nendfacet\nendsolid a\n"})
    EXPECT_NE(error_of_file(write("text.stl", text)).find("it is damaged, or its format"),
              std::string::npos);
}

TEST_F(ReadMesh, ReadsDecimalPointsUnderAnyLocale) {
  const std::string obj = "v 0.125 -1.000 2.5e-1\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  const std::string stl =
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0.125 -1.000 2.5e-1\nvertex 1 0 0\n"
      "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
  const OtherLocale comma;
  for (const std::string& path : {write("decimal.obj", obj), write("decimal.stl", stl)}) {
    const Mesh mesh = read_mesh(path);
    ASSERT_EQ(mesh.vertices.cols(), 3) << path;
    EXPECT_EQ(mesh.vertices.col(0), Eigen::Vector3d(0.125, -1, 0.25)) << path;
  }
}

TEST_F(ReadMesh, NamesTheLineOfAnObj) {
  const std::string corners = "# made\nv 0 0 0\nv 1 0 0\nv 0 1 0\n";
  EXPECT_NE(error_of_file(write("a.obj", corners + "v 1 2\n"))
                .find("line 5: '' is not a number; a vertex has three"),
            std::string::npos);
  for (const std::string face : {"f 1 2 x", "f 1 2 0", "f 1 2 -4", "f 1 2 1.5", "f 1 2 /3"}) {
    const std::string error = error_of_file(write("f.obj", corners + face + "\n"));
    EXPECT_NE(error.find("line 5: '" + face.substr(6) + "' is not a corner of a face"),
              std::string::npos)
        << error;
  }
  EXPECT_EQ(read_mesh(write("c.obj", corners + "f 1/1/1 2//2 \\\n -1 # all\n")).triangles,
            Eigen::Vector3i(0, 1, 2));
}

TEST_F(ReadMesh, RefusesCoordinatesThatAreNotFinite) {
  Mesh mesh = tetrahedron();
  mesh.vertices(1, 2) = kInf;
  const std::string path = write("inf.stl", binary_stl(mesh, "binary"));
  EXPECT_NE(error_of_file(path).find("vertices must be within 10000 m of the origin, but point"),
            std::string::npos);
}

}  // namespace
}  // namespace graspless::geometry
