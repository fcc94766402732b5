// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "conversions.hpp"

#include <cmath>
#include <iomanip>
#include <limits>
#include <sstream>
#include <stdexcept>

namespace graspless::bindings {
namespace {

template <class T>
std::string shape_of(const T& array) {
  std::string text = "(";
  for (py::ssize_t i = 0; i < array.ndim(); ++i) {
    text += (i > 0 ? ", " : "") + std::to_string(array.shape(i));
  }
  return text + (array.ndim() == 1 ? ",)" : ")");
}

template <class T>
[[noreturn]] void refuse_shape(const T& array, const std::string& name,
                               const std::string& expected) {
  throw std::invalid_argument(name + " has shape " + shape_of(array) + "; it must have shape " +
                              expected);
}

void require_finite(const Array& array, const std::string& name) {
  const double* values = array.data();
  for (py::ssize_t i = 0; i < array.size(); ++i) {
    if (!std::isfinite(values[i])) {
      throw std::invalid_argument(name + " has a value that is not finite (" +
                                  std::to_string(values[i]) + " at position " + std::to_string(i) +
                                  ")");
    }
  }
}

// Rows of `dim` values are, in memory, columns of `dim` values.
template <int Dim>
Eigen::Matrix<double, Dim, Eigen::Dynamic> to_columns(const Array& rows, const std::string& name) {
  if (rows.ndim() != 2 || rows.shape(1) != Dim) {
    refuse_shape(rows, name, "(N, " + std::to_string(Dim) + ")");
  }
  return Eigen::Map<const Eigen::Matrix<double, Dim, Eigen::Dynamic>>(rows.data(), Dim,
                                                                      rows.shape(0));
}

Eigen::Isometry3d rigid(const double* rows, const std::string& name) {
  const Pose X = Eigen::Map<const Pose>(rows);
  const Eigen::Matrix3d R = X.topLeftCorner<3, 3>();
  const double skew = (R.transpose() * R - Eigen::Matrix3d::Identity()).norm();
  const bool is_rigid = skew < 1e-6 && R.determinant() > 0 &&
                        (X.row(3) - Eigen::RowVector4d(0, 0, 0, 1)).norm() < 1e-6;
  if (!is_rigid) {
    throw std::invalid_argument(
        name +
        " is not a rigid transform: its upper left 3 x 3 must be a rotation "
        "and its last row 0 0 0 1");
  }
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = R;
  if (skew > 1e-14) {  // a pose of our own comes back as it left, bit by bit
    result.linear() = Eigen::Quaterniond(R).normalized().toRotationMatrix();
  }
  result.translation() = X.topRightCorner<3, 1>();
  return result;
}

}  // namespace

Eigen::VectorXd to_vector(const Array& values, const std::string& name, Eigen::Index size) {
  if (values.ndim() != 1 || (size >= 0 && values.shape(0) != size)) {
    refuse_shape(values, name, size < 0 ? "(N,)" : "(" + std::to_string(size) + ",)");
  }
  require_finite(values, name);
  return Eigen::Map<const Eigen::VectorXd>(values.data(), values.shape(0));
}

Eigen::Vector2d to_vector2(const Array& values, const std::string& name) {
  return to_vector(values, name, 2);
}

Eigen::Vector3d to_vector3(const Array& values, const std::string& name) {
  return to_vector(values, name, 3);
}

Eigen::Matrix3d to_matrix3(const Array& rows, const std::string& name) {
  if (rows.ndim() != 2 || rows.shape(0) != 3 || rows.shape(1) != 3) {
    refuse_shape(rows, name, "(3, 3)");
  }
  require_finite(rows, name);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(rows.data());
}

Eigen::Matrix2Xd to_points2(const Array& rows, const std::string& name) {
  return to_columns<2>(rows, name);
}

Eigen::Matrix3Xd to_points3(const Array& rows, const std::string& name) {
  return to_columns<3>(rows, name);
}

Eigen::Matrix3Xi to_triangles(const Array& rows, const std::string& name) {
  if (rows.ndim() != 2 || rows.shape(1) != 3) {
    refuse_shape(rows, name, "(M, 3)");
  }
  const Eigen::Map<const Eigen::Matrix3Xd> values(rows.data(), 3, rows.shape(0));
  for (Eigen::Index i = 0; i < values.size(); ++i) {
    const double value = values.data()[i];
    if (value >= 0 && value <= std::numeric_limits<int>::max() && value == std::floor(value)) {
      continue;
    }
    std::ostringstream fault;
    fault << name << "[" << i / 3 << "][" << i % 3 << "] is " << std::setprecision(15) << value
          << "; it must be the index of a vertex, from 0";
    throw std::invalid_argument(fault.str());
  }
  return values.cast<int>();
}

Eigen::Isometry3d to_pose(const Array& X, const std::string& name) {
  if (X.ndim() != 2 || X.shape(0) != 4 || X.shape(1) != 4) {
    refuse_shape(X, name, "(4, 4)");
  }
  require_finite(X, name);
  return rigid(X.data(), name);
}

Poses to_poses(const Array& X, const std::string& name) {
  if (X.ndim() != 3 || X.shape(1) != 4 || X.shape(2) != 4) {
    refuse_shape(X, name, "(N, 4, 4)");
  }
  require_finite(X, name);
  Poses poses;
  for (py::ssize_t i = 0; i < X.shape(0); ++i) {
    poses.push_back(rigid(X.data(i, 0, 0), name + "[" + std::to_string(i) + "]"));
  }
  return poses;
}

Configurations to_configurations(const Array& rows, const std::string& name) {
  if (rows.ndim() != 2) {
    refuse_shape(rows, name, "(N, dof)");
  }
  require_finite(rows, name);
  Configurations result;
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const double* row = rows.data() + i * rows.shape(1);  // there may be no columns
    result.emplace_back(Eigen::Map<const Eigen::VectorXd>(row, rows.shape(1)));
  }
  return result;
}

Eigen::VectorXd to_configuration(const robot::Robot& robot, const Array& q,
                                 const std::string& name) {
  if (q.ndim() != 1 || q.shape(0) != robot.dof()) {
    refuse_shape(q, name,
                 "(" + std::to_string(robot.dof()) + ",), one value for each joint of '" +
                     robot.name() + "'");
  }
  return to_vector(q, name);
}

Pose from_pose(const Eigen::Isometry3d& X) { return X.matrix(); }

py::array_t<double> from_poses(const Poses& X) {
  py::array_t<double> result({static_cast<py::ssize_t>(X.size()), py::ssize_t{4}, py::ssize_t{4}});
  for (std::size_t i = 0; i < X.size(); ++i) {
    Eigen::Map<Pose>(result.mutable_data(static_cast<py::ssize_t>(i), 0, 0)) = X[i].matrix();
  }
  return result;
}

py::array_t<double> Python<Poses>::shown(const Poses& X) {
  py::array_t<double> result = from_poses(X);
  result.attr("setflags")(py::arg("write") = false);
  return result;
}

Rows from_configurations(const Configurations& q, Eigen::Index dof) {
  Rows rows(static_cast<Eigen::Index>(q.size()), dof);
  for (std::size_t i = 0; i < q.size(); ++i) {
    rows.row(static_cast<Eigen::Index>(i)) = q[i];
  }
  return rows;
}

py::arg_v pose_arg(const char* name) {
  Array value({4, 4});
  Eigen::Map<Pose>(value.mutable_data()) = Pose::Identity();
  return {name, value, "identity"};
}

py::arg_v Python<Eigen::Vector3d>::arg(const char* name, const Eigen::Vector3d& value) {
  Array rows(py::ssize_t{3});
  Eigen::Map<Eigen::Vector3d>(rows.mutable_data()) = value;
  return {name, rows};
}

int frame_index(const robot::Robot& robot, const Key& frame, const std::string& name) {
  if (const auto* text = std::get_if<std::string>(&frame)) {
    return robot.frame(*text);
  }
  const int index = std::get<int>(frame);
  const auto count = static_cast<int>(robot.frame_names().size());
  if (index < 0 || index >= count) {
    throw std::invalid_argument(name + " is " + std::to_string(index) + "; '" + robot.name() +
                                "' has frames 0 to " + std::to_string(count - 1));
  }
  return index;
}

int body_index(const collision::World& world, const Key& body, const char* owner) {
  if (const auto* name = std::get_if<std::string>(&body)) {
    return world.body(*name);
  }
  const int index = std::get<int>(body);
  if (index < 0 || index >= world.num_bodies()) {
    throw std::invalid_argument("body must be the index of one of the " + std::string(owner) +
                                "'s " + std::to_string(world.num_bodies()) + " bodies, not " +
                                std::to_string(index));
  }
  return index;
}

namespace {

/// As Python shows it; of a long array its shape alone.
std::string represent_value(const py::object& value) {
  constexpr py::ssize_t kLongest = 32;
  if (py::isinstance<py::array>(value) && py::array(value).size() > kLongest) {
    return "<array of shape " + shape_of(py::array(value)) + ">";
  }
  return py::repr(value);
}

}  // namespace

std::string represent(const py::handle& self, const std::vector<const char*>& names) {
  std::string text = py::str(py::type::handle_of(self).attr("__name__"));
  text += "(";
  for (const char* name : names) {
    if (name != names.front()) {
      text += ", ";
    }
    text += std::string(name) + "=" + represent_value(self.attr(name));
  }
  return text + ")";
}

}  // namespace graspless::bindings
