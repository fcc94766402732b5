// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In place of CGAL's reader, which reads numbers by the program's locale.
#include "geometry/read_obj.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

#include "graspless/watch.hpp"

#include "geometry/words.hpp"

namespace graspless::geometry {
namespace {

class ObjReader {
 public:
  explicit ObjReader(std::istream& file) : file_(file) {}

  PolygonSoup read() {
    while (read_line()) {
      poll();
      const std::string_view what = word();
      if (what == "v") soup_.points.push_back(vertex());
      if (what == "f") soup_.polygons.push_back(face());
    }
    return std::move(soup_);
  }

 private:
  [[noreturn]] void refuse(const std::string& fault) const {
    throw std::invalid_argument("line " + std::to_string(number_) + ": " + fault);
  }

  /// Reads a line; a backslash at its end continues it.
  bool read_line() {
    at_ = 0;
    line_.clear();
    for (std::string more; std::getline(file_, more);) {
      ++number_;
      if (!more.empty() && more.back() == '\r') more.pop_back();
      const bool goes_on = !more.empty() && more.back() == '\\';
      if (goes_on) more.back() = ' ';
      line_ += more;
      if (!goes_on) return true;
    }
    return !line_.empty();
  }

  /// Returns the next word of the line; empty at its end or at a comment.
  std::string_view word() {
    const std::string_view found = next_word(line_, at_);
    return !found.empty() && found[0] == '#' ? std::string_view() : found;
  }

  Eigen::Vector3d vertex() {
    Eigen::Vector3d point;
    for (double& value : point) {
      const std::string_view text = word();
      const auto found = to_number(text);
      if (!found) refuse("'" + shortened(text) + "' is not a number; a vertex has three");
      value = *found;
    }
    return point;
  }

  /// Reads corners v, v/vt, v//vn or v/vt/vn. Negative numbers count from the last vertex.
  std::vector<std::size_t> face() {
    std::vector<std::size_t> corners;
    for (std::string_view text = word(); !text.empty(); text = word()) {
      const auto found = to_number(text.substr(0, text.find('/')));
      const double count = static_cast<double>(soup_.points.size());
      const bool is_whole = found && *found == std::floor(*found) && *found != 0;
      if (!is_whole || *found < -count || *found > 4294967295.0) {
        refuse("'" + shortened(text) +
               "' is not a corner of a face: the number of a vertex, from 1, or from -1 backwards");
      }
      corners.push_back(static_cast<std::size_t>(*found > 0 ? *found - 1 : count + *found));
    }
    return corners;
  }

  std::istream& file_;
  PolygonSoup soup_;
  std::string line_;
  std::size_t at_ = 0, number_ = 0;  // place in the line, and the number of its last one
};

}  // namespace

PolygonSoup read_obj(std::istream& file) { return ObjReader(file).read(); }

}  // namespace graspless::geometry
