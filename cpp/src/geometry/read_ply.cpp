// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In place of CGAL's reader, which trusts the file: a property before any element, or coordinates
// of another type than float and double, end the process, and a list may claim any length.
#include "geometry/read_ply.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "graspless/watch.hpp"

#include "geometry/words.hpp"

namespace graspless::geometry {
namespace {

enum class PlyKind { signed_integer, unsigned_integer, real };

struct PlyType {
  const char *name, *sized_name;
  std::size_t bytes;
  PlyKind kind;
};

constexpr std::array<PlyType, 8> kPlyTypes{{{"char", "int8", 1, PlyKind::signed_integer},
                                            {"uchar", "uint8", 1, PlyKind::unsigned_integer},
                                            {"short", "int16", 2, PlyKind::signed_integer},
                                            {"ushort", "uint16", 2, PlyKind::unsigned_integer},
                                            {"int", "int32", 4, PlyKind::signed_integer},
                                            {"uint", "uint32", 4, PlyKind::unsigned_integer},
                                            {"float", "float32", 4, PlyKind::real},
                                            {"double", "float64", 8, PlyKind::real}}};

struct PlyProperty {
  std::string name;
  const PlyType* type;
  const PlyType* length = nullptr;  // of a list: type of its length
};

struct PlyElement {
  std::string name;
  std::uint64_t count;
  std::vector<PlyProperty> properties;
};

enum class PlyFormat { ascii, little_endian, big_endian };

struct PlyHeader {
  PlyFormat format = PlyFormat::ascii;
  std::vector<PlyElement> elements;
  std::size_t end = 0;  // where the values begin
};

class PlyHeaderReader {
 public:
  explicit PlyHeaderReader(const std::string& text) : text_(text) {}

  PlyHeader read() {
    require(next_word() == "ply", "must be 'ply'");
    for (;;) {
      const std::string keyword = next_word();
      if (keyword == "format") read_format();
      if (keyword == "element") read_element();
      if (keyword == "property") read_property();
      if (keyword == "end_header") break;
    }
    header_.end = next_;
    return header_;
  }

 private:
  void require(bool holds, const std::string& fault) const {
    if (!holds) throw std::invalid_argument("line " + std::to_string(line_) + " " + fault);
  }

  /// Goes to the next line; returns its first word, empty in an empty line.
  std::string next_word() {
    poll();
    ++line_;
    require(next_ < text_.size(), "is missing: the header does not end");
    const std::size_t end = std::min(text_.find('\n', next_), text_.size());
    words_ = std::istringstream(text_.substr(next_, end - next_));
    next_ = std::min(end + 1, text_.size());
    return word();
  }

  std::string word() {
    std::string word;
    words_ >> word;
    return word;
  }

  void read_format() {
    const std::string format = word();
    const std::array<std::string, 3> formats{"ascii", "binary_little_endian", "binary_big_endian"};
    const auto* found = std::find(formats.begin(), formats.end(), format);
    require(found != formats.end(), "has format '" + format +
                                        "'; choose from ascii, binary_little_endian, "
                                        "binary_big_endian");
    header_.format = static_cast<PlyFormat>(found - formats.begin());
  }

  void read_element() {
    PlyElement element{word(), 0, {}};
    const std::string count = word();
    const auto [end, error] =
        std::from_chars(count.data(), count.data() + count.size(), element.count);
    require(error == std::errc() && end == count.data() + count.size(),
            "has count '" + count + "' of element '" + element.name + "', not a whole number");
    header_.elements.push_back(element);
  }

  const PlyType* type() {
    const std::string name = word();
    const auto* found = std::find_if(kPlyTypes.begin(), kPlyTypes.end(), [&](const PlyType& type) {
      return name == type.name || name == type.sized_name;
    });
    require(found != kPlyTypes.end(),
            "has type '" + name +
                "'; choose from char, uchar, short, ushort, int, uint, float, double");
    return found;
  }

  void read_property() {
    require(!header_.elements.empty(), "has a property before any element");
    auto& properties = header_.elements.back().properties;
    PlyProperty property{};
    const std::istringstream::pos_type start = words_.tellg();
    if (word() == "list") {
      property.length = type();
      require(property.length->kind != PlyKind::real, "has a list whose length is not an integer");
    } else {
      words_.clear();
      words_.seekg(start);
    }
    property.type = type();
    property.name = word();
    for (const PlyProperty& other : properties) {
      if (other.name == property.name) require(false, "has property '" + property.name + "' again");
    }
    properties.push_back(property);
  }

  const std::string& text_;
  PlyHeader header_;
  std::istringstream words_;
  std::size_t next_ = 0;  // start of the next line
  int line_ = 0;
};

class PlyBodyReader {
 public:
  PlyBodyReader(const std::string& text, const PlyHeader& header)
      : text_(text), format_(header.format), at_(header.end) {}

  void read(const PlyElement& element, PolygonSoup& soup) {
    require_room(element);
    const bool is_vertex = element.name == "vertex" || element.name == "vertices";
    const bool is_face = element.name == "face" || element.name == "faces";
    const std::size_t x = is_vertex ? scalar(element, "x") : 0;
    const std::size_t y = is_vertex ? scalar(element, "y") : 0;
    const std::size_t z = is_vertex ? scalar(element, "z") : 0;
    const std::size_t corners = is_face ? corner_list(element) : 0;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      poll();
      item_ = {&element, i};
      read_item(element);
      if (is_vertex) soup.points.emplace_back(values_[x][0], values_[y][0], values_[z][0]);
      if (is_face) soup.polygons.push_back(indices(values_[corners]));
    }
  }

 private:
  std::string item() const { return item_.first->name + " " + std::to_string(item_.second); }
  [[noreturn]] static void refuse(const std::string& fault) { throw std::invalid_argument(fault); }

  /// Least number of bytes that a value takes. In a text it is followed by a space, except the
  /// last.
  std::size_t bytes(const PlyType& type) const {
    return format_ == PlyFormat::ascii ? 2 : type.bytes;
  }
  std::size_t room(std::size_t bytes_each) const { return (text_.size() - at_ + 1) / bytes_each; }

  void require_room(const PlyElement& element) const {
    if (element.count == 0) return;
    std::size_t least = 0;
    for (const PlyProperty& p : element.properties) least += bytes(p.length ? *p.length : *p.type);
    if (least == 0) refuse("element '" + element.name + "' has no property");
    if (element.count <= room(least)) return;
    refuse("states " + std::to_string(element.count) + " of element '" + element.name +
           "', but the rest of the file holds " + std::to_string(room(least)) + " at most");
  }

  static std::size_t scalar(const PlyElement& element, const std::string& name) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      if (element.properties[k].name == name && !element.properties[k].length) return k;
    }
    refuse("element '" + element.name + "' has no property '" + name + "' that is a number");
  }

  static std::size_t corner_list(const PlyElement& element) {
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& p = element.properties[k];
      if (p.length && (p.name == "vertex_indices" || p.name == "vertex_index")) return k;
    }
    refuse("element '" + element.name + "' has no list 'vertex_indices' or 'vertex_index'");
  }

  void read_item(const PlyElement& element) {
    values_.resize(element.properties.size());
    for (std::size_t k = 0; k < element.properties.size(); ++k) {
      const PlyProperty& p = element.properties[k];
      const double length = p.length ? value(*p.length) : 1;
      if (!(length >= 0 && length <= static_cast<double>(room(bytes(*p.type))) &&
            length == std::floor(length))) {
        std::ostringstream fault;
        fault << item() << ": list '" << p.name << "' states length " << length
              << ", but the rest of the file holds 0 to " << room(bytes(*p.type)) << " values";
        refuse(fault.str());
      }
      values_[k].resize(static_cast<std::size_t>(length));
      for (double& v : values_[k]) v = value(*p.type);
    }
  }

  double value(const PlyType& type) {
    if (format_ == PlyFormat::ascii) return written(type);
    if (text_.size() - at_ < type.bytes) refuse(item() + ": the file ends");
    std::array<char, 8> raw{};
    std::copy_n(text_.begin() + at_, type.bytes, raw.begin());
    at_ += type.bytes;
    if (format_ == PlyFormat::big_endian) std::reverse(raw.begin(), raw.begin() + type.bytes);
    return decoded(raw, type);
  }

  template <typename Number>
  static double as(const std::array<char, 8>& raw) {
    Number number;
    std::memcpy(&number, raw.data(), sizeof number);
    return static_cast<double>(number);
  }

  /// The number in little-endian bytes.
  static double decoded(const std::array<char, 8>& raw, const PlyType& type) {
    if (type.kind == PlyKind::real) return type.bytes == 4 ? as<float>(raw) : as<double>(raw);
    if (type.kind == PlyKind::unsigned_integer) return as<std::uint32_t>(raw);
    if (type.bytes == 1) return as<std::int8_t>(raw);
    return type.bytes == 2 ? as<std::int16_t>(raw) : as<std::int32_t>(raw);
  }

  double written(const PlyType& type) {
    const std::string_view word = next_word(text_, at_);
    if (word.empty()) refuse(item() + ": the file ends");
    const auto number = to_number(word);
    if (!number) refuse(item() + ": '" + shortened(word) + "' is not a number");
    const bool is_float = type.kind == PlyKind::real && type.bytes == 4;
    if (!is_float) return *number;
    if (std::isfinite(*number) && std::abs(*number) > std::numeric_limits<float>::max())
      refuse(item() + ": '" + shortened(word) + "' is too large for a float");
    return static_cast<float>(*number);
  }

  std::vector<std::size_t> indices(const std::vector<double>& numbers) const {
    std::vector<std::size_t> corners;
    corners.reserve(numbers.size());
    for (const double v : numbers) {
      if (!(v >= 0 && v <= 4294967295.0 && v == std::floor(v))) {
        std::ostringstream fault;
        fault << item() << ": " << v << " is not the index of a vertex";
        refuse(fault.str());
      }
      corners.push_back(static_cast<std::size_t>(v));
    }
    return corners;
  }

  const std::string& text_;
  const PlyFormat format_;
  std::size_t at_;
  std::pair<const PlyElement*, std::uint64_t> item_;  // being read
  std::vector<std::vector<double>> values_;
};

}  // namespace

PolygonSoup read_ply(const std::string& text) {
  const PlyHeader header = PlyHeaderReader(text).read();
  PlyBodyReader body(text, header);
  PolygonSoup soup;
  for (const PlyElement& element : header.elements) body.read(element, soup);
  return soup;
}

}  // namespace graspless::geometry
