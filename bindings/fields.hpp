// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <type_traits>
#include <vector>

#include <pybind11/native_enum.h>

#include "graspless/planning/fields.hpp"

#include "conversions.hpp"

/// Binds structs and enums from the tables that stand beside them in the public headers.
namespace graspless::bindings {

/// planning::Field without its types.
struct FieldDescription {
  std::string name, unit, text, range, source;
  py::typing::Dict<py::str, py::object> bounds;  ///< under pydantic's names: gt, ge, lt, le
};

/// Bounds of a range; integers also have those of their type.
template <class Value>
py::dict bounds(const planning::Range& range) {
  py::dict result;
  if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::optional<double>>) {
    if (!std::isinf(range.lower)) result[range.lower_is_open ? "gt" : "ge"] = range.lower;
    if (!std::isinf(range.upper)) result[range.upper_is_open ? "lt" : "le"] = range.upper;
  } else if constexpr (std::is_integral_v<Value> && !std::is_same_v<Value, bool>) {
    using Limits = std::numeric_limits<Value>;
    result["ge"] = std::isinf(range.lower) ? Limits::min() : static_cast<Value>(range.lower);
    result["le"] = std::isinf(range.upper) ? Limits::max() : static_cast<Value>(range.upper);
  }
  return result;
}

/// Descriptions of all fields of a struct, in order.
template <class Struct>
std::vector<FieldDescription> descriptions() {
  std::vector<FieldDescription> result;
  const auto add = [&](auto value, const auto& field) {
    result.push_back({field.name, field.unit, field.text, planning::to_string(field.range),
                      field.source, bounds<decltype(value)>(field.range)});
  };
  const Struct defaults{};
  std::apply([&](const auto&... field) { (add(defaults.*field.member, field), ...); },
             fields(defaults));
  return result;
}

/// Docstring of a field: its text, then unit, range, default and source.
template <class Struct, class Value>
std::string docstring(const planning::Field<Struct, Value>& field, bool has_default) {
  std::string facts;
  const auto fact = [&](const char* name, const std::string& value) {
    if (!value.empty()) facts += (facts.empty() ? "" : " ") + std::string(name) + value + ".";
  };
  fact("Unit: ", field.unit);
  fact("Range: ", planning::to_string(field.range));
  if constexpr (std::is_arithmetic_v<Value>) {
    if (has_default) fact("Default: ", py::repr(py::cast(Struct{}.*field.member)));
  }
  fact("Paper: ", field.source);
  return field.text + (facts.empty() ? "" : "\n\n" + facts);
}

template <class Struct>
void bind_descriptions(py::class_<Struct>& cls) {
  cls.def_static("fields", &descriptions<Struct>,
                 "Returns name, unit, range, text and source of every field.");
}

/// Binds options: a constructor of keywords, attributes, copies, a repr and fields().
template <class Struct>
void bind_options_struct(py::module_& m, const char* name, const char* doc) {
  py::class_<Struct> bound(m, name, doc);
  std::apply(
      [&](const auto&... field) {
        bind_fields(bound, "Any field by keyword; the others keep their defaults.",
                    Field{field.name, field.member, docstring(field, true)}...);
      },
      fields(Struct{}));
  bound.def(
      "__copy__", [](const Struct& self) { return self; }, "Returns a copy.");
  bound.def(
      "__deepcopy__", [](const Struct& self, const py::object&) { return self; }, py::arg("memo"),
      "Returns a copy.");
  bind_descriptions(bound);
}

/// Binds Statistics, what a search counted: as options, with as_dict() in the order of the table.
template <class Struct>
void bind_statistics_struct(py::module_& m) {
  py::class_<Struct> bound(m, "Statistics", "Counters of the search.");
  std::apply(
      [&](const auto&... field) {
        bind_fields(bound, "Any field by keyword; the others are zero.",
                    Field{field.name, field.member, docstring(field, false)}...);
        bound.def(
            "as_dict",
            [names = std::vector<const char*>{field.name...}](const py::object& self) {
              py::typing::Dict<py::str, py::object> result;
              for (const char* name : names) result[name] = self.attr(name);
              return result;
            },
            "Returns all fields by name.");
      },
      fields(Struct{}));
  bind_descriptions(bound);
}

/// Binds an enum with the text of each value as its docstring. Its members equal their names.
template <class Enum>
void bind_choices(py::module_& m, const char* name, const char* doc) {
  py::native_enum<Enum> bound(m, name, "graspless._named.Named", doc);
  for (const auto& choice : choices(Enum{})) bound.value(choice.name, choice.value, choice.text);
  bound.finalize();
}

}  // namespace graspless::bindings
