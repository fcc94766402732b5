// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include <Eigen/Geometry>
#include <pybind11/eigen.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/typing.h>

#include "graspless/collision/world.hpp"
#include "graspless/robot/robot.hpp"

/// Between numpy and Eigen. In Python many points are rows (N x 3) and poses are 4 x 4; here points
/// are columns and poses Isometry3d. What Python gives is checked for shape and finite values;
/// `name` is the argument that std::invalid_argument (ValueError) blames.
namespace graspless::bindings {

namespace py = pybind11;

using Array = py::array_t<double, py::array::c_style | py::array::forcecast>;
using FloatImage = py::array_t<float, py::array::c_style | py::array::forcecast>;
using Rows = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
using Rows2 = Eigen::Matrix<double, Eigen::Dynamic, 2, Eigen::RowMajor>;
using Rows3 = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Rows6 = Eigen::Matrix<double, Eigen::Dynamic, 6, Eigen::RowMajor>;
using Rows3i = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Pose = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
using Configurations = std::vector<Eigen::VectorXd>;
using Poses = std::vector<Eigen::Isometry3d>;

/// `size` values, or any number when it is negative.
Eigen::VectorXd to_vector(const Array& values, const std::string& name, Eigen::Index size = -1);
Eigen::Vector2d to_vector2(const Array& values, const std::string& name);
Eigen::Vector3d to_vector3(const Array& values, const std::string& name);
Eigen::Matrix3d to_matrix3(const Array& rows, const std::string& name);
Eigen::Matrix2Xd to_points2(const Array& rows, const std::string& name);
Eigen::Matrix3Xd to_points3(const Array& rows, const std::string& name);
/// Throws unless all values are whole numbers that an int holds: a conversion would wrap or round.
Eigen::Matrix3Xi to_triangles(const Array& rows, const std::string& name);
/// Throws unless X is a rigid transform (to 1e-6); its rotation is made orthonormal.
Eigen::Isometry3d to_pose(const Array& X, const std::string& name);
Poses to_poses(const Array& X, const std::string& name);
Configurations to_configurations(const Array& rows, const std::string& name);
/// A configuration of this robot: dof() finite values.
Eigen::VectorXd to_configuration(const robot::Robot& robot, const Array& q,
                                 const std::string& name);

Pose from_pose(const Eigen::Isometry3d& X);
py::array_t<double> from_poses(const Poses& X);                       ///< N x 4 x 4
Rows from_configurations(const Configurations& q, Eigen::Index dof);  ///< N x dof

/// A pose argument whose default is the identity.
py::arg_v pose_arg(const char* name);

/// What may stand for a frame or a body: its name or its index.
using Key = std::variant<std::string, int>;
int frame_index(const robot::Robot& robot, const Key& frame, const std::string& name = "frame");
/// `owner` is what std::invalid_argument says the bodies belong to.
int body_index(const collision::World& world, const Key& body, const char* owner = "world");

/// How Python gives and sees a value of a plain struct; a specialization where it is not as here.
template <class Value>
struct Python {
  using Given = Value;
  static Value from(Given value, const char* /*name*/) { return value; }
  static const Value& shown(const Value& value) { return value; }
  static py::arg_v arg(const char* name, const Value& value) { return py::arg(name) = value; }
};

template <>
struct Python<Eigen::Vector3d> {
  using Given = Array;
  static Eigen::Vector3d from(const Array& value, const char* name) {
    return to_vector3(value, name);
  }
  static Eigen::Vector3d shown(const Eigen::Vector3d& value) { return value; }
  static py::arg_v arg(const char* name, const Eigen::Vector3d& value);
};

template <>
struct Python<Eigen::Isometry3d> {
  using Given = Array;
  static Eigen::Isometry3d from(const Array& X, const char* name) { return to_pose(X, name); }
  static Pose shown(const Eigen::Isometry3d& X) { return from_pose(X); }
  static py::arg_v arg(const char* name, const Eigen::Isometry3d&) { return pose_arg(name); }
};

/// What a getter returns. Of a const matrix, pybind11 makes a read-only array: it is a copy, and a
/// change of it would be lost. Of another const value, it might keep a reference.
template <class Value,
          class Type = std::decay_t<decltype(Python<Value>::shown(std::declval<const Value&>()))>>
using Shown = std::conditional_t<std::is_base_of_v<Eigen::EigenBase<Type>, Type>, const Type, Type>;

template <class Item>
struct Python<std::optional<Item>> {
  using Given = std::optional<typename Python<Item>::Given>;
  static std::optional<Item> from(const Given& value, const char* name) {
    return value ? std::optional<Item>(Python<Item>::from(*value, name)) : std::nullopt;
  }
  static std::optional<Shown<Item>> shown(const std::optional<Item>& value) {
    return value ? std::optional<Shown<Item>>(Python<Item>::shown(*value)) : std::nullopt;
  }
  static py::arg_v arg(const char* name, const std::optional<Item>& value) {
    return py::arg(name) = value;
  }
};

using MaybePose = Python<std::optional<Eigen::Isometry3d>>;

// What Python cannot set: many points, poses or configurations.

template <class Scalar, int Dim>
struct Python<Eigen::Matrix<Scalar, Dim, Eigen::Dynamic>> {
  static Eigen::Matrix<Scalar, Eigen::Dynamic, Dim, Eigen::RowMajor> shown(
      const Eigen::Matrix<Scalar, Dim, Eigen::Dynamic>& points) {
    return points.transpose();
  }
};

template <>
struct Python<Poses> {
  static py::array_t<double> shown(const Poses& X);  ///< read-only
};

template <>
struct Python<Configurations> {
  static Rows shown(const Configurations& q) {
    return from_configurations(q, q.empty() ? 0 : q.front().size());
  }
};

/// Getter of a member, or of what a member function returns, as Python sees it.
template <class Struct, class Member>
auto shown(Member Struct::*member) {
  using Value = std::decay_t<std::invoke_result_t<decltype(member), const Struct&>>;
  return [member](const Struct& self) -> Shown<Value> {
    return Python<Value>::shown(std::invoke(member, self));
  };
}

/// Getter of a tuple, since appending to a copy of the list would be lost.
template <class Struct, class Item>
auto as_tuple(std::vector<Item> Struct::*member) {
  using Tuple = py::typing::Tuple<Item, py::ellipsis>;
  return [member](const Struct& self) { return Tuple(py::tuple(py::cast(self.*member))); };
}

/// A member of a plain struct, and what Python shall call and say of it.
template <class Struct, class Value>
struct Field {
  const char* name;
  Value Struct::*member;
  std::string doc;
};
template <class Struct, class Value>
Field(const char*, Value Struct::*, std::string) -> Field<Struct, Value>;

template <class Value>
constexpr bool is_optional = false;
template <class Item>
constexpr bool is_optional<std::optional<Item>> = true;

/// A reference to a part of the struct, but a copy of an optional part: once None is assigned,
/// there is nothing to refer to.
template <class Struct, class Value>
void bind_field(py::class_<Struct>& cls, const Field<Struct, Value>& field) {
  using Type = Python<Value>;
  if constexpr (std::is_same_v<typename Type::Given, Value> && !is_optional<Value>) {
    cls.def_readwrite(field.name, field.member, field.doc.c_str());
  } else {
    cls.def_property(
        field.name, shown(field.member),
        [field](Struct& self, const typename Type::Given& value) {
          self.*(field.member) = Type::from(value, field.name);
        },
        field.doc.c_str());
  }
}

template <class Struct, class Item>
void bind_field(py::class_<Struct>& cls, const Field<Struct, std::vector<Item>>& field) {
  cls.def_property(
      field.name, as_tuple(field.member),
      [member = field.member](Struct& self, std::vector<Item> value) {
        self.*member = std::move(value);
      },
      field.doc.c_str());
}

/// How many members an aggregate has: the most initializers it takes.
struct Anything {
  template <class T>
  operator T() const;
};
template <class Struct, class... Given>
constexpr std::size_t num_members(long) {
  return sizeof...(Given);
}
template <class Struct, class... Given>
constexpr auto num_members(int) -> decltype(Struct{Given{}..., Anything{}}, std::size_t{}) {
  return num_members<Struct, Given..., Anything>(0);
}

/// "Name(field=value, ...)" from attributes of a bound object.
std::string represent(const py::handle& self, const std::vector<const char*>& names);

/// Lets Python pickle and copy the objects of a class. They are made anew from the attributes that
/// the constructor takes by keyword.
template <class Class>
void bind_pickling(Class& cls, std::vector<const char*> names) {
  using Tuple = py::typing::Tuple<py::object, py::ellipsis>;
  cls.def("__reduce__", [names = std::move(names)](const py::object& self) {
    py::dict given;
    for (const char* name : names) given[name] = self.attr(name);
    const py::object make = py::module_::import("functools").attr("partial");
    return Tuple(py::make_tuple(make(py::type::of(self), **given), py::tuple()));
  });
}

/// Binds a plain struct from one table: a constructor of keywords with the struct's own defaults,
/// attributes that can be read and set, and a repr.
template <class Struct, class... Values>
void bind_fields(py::class_<Struct>& cls, const char* init_doc, Field<Struct, Values>... fields) {
  static_assert(num_members<Struct>(0) == sizeof...(Values), "a member is missing in this table");
  const Struct defaults{};
  cls.def(py::init([fields...](typename Python<Values>::Given... values) {
            Struct result;
            ((result.*(fields.member) = Python<Values>::from(std::move(values), fields.name)), ...);
            return result;
          }),
          py::kw_only(), Python<Values>::arg(fields.name, defaults.*(fields.member))..., init_doc);
  (bind_field(cls, fields), ...);
  cls.def("__repr__", [names = std::vector<const char*>{fields.name...}](const py::object& self) {
    return represent(self, names);
  });
  bind_pickling(cls, {fields.name...});
}

}  // namespace graspless::bindings
