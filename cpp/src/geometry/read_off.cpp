// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// In place of CGAL's reader, which reads through a null pointer where a colour is not a number.
#include "geometry/read_off.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "graspless/watch.hpp"

#include "geometry/words.hpp"

namespace graspless::geometry {
namespace {

class OffReader {
 public:
  explicit OffReader(const std::string& text) : text_(text) {}

  PolygonSoup read() {
    read_header();
    PolygonSoup soup;
    const std::size_t vertices = whole("number of vertices"), faces = whole("number of faces");
    whole("number of edges");
    for (std::size_t i = 0; i < vertices; ++i) {
      poll();
      soup.points.push_back(vertex("vertex " + std::to_string(i)));
    }
    for (std::size_t i = 0; i < faces; ++i) {
      poll();
      soup.polygons.push_back(face("face " + std::to_string(i)));
    }
    return soup;
  }

 private:
  [[noreturn]] static void refuse(const std::string& fault) { throw std::invalid_argument(fault); }

  void skip_line() { at_ = std::min(text_.find('\n', at_), text_.size()); }

  /// Returns the next word that is not part of a comment.
  std::string_view word() {
    std::string_view word = next_word(text_, at_);
    for (; !word.empty() && word[0] == '#'; word = next_word(text_, at_)) {
      at_ -= word.size();
      skip_line();
    }
    const std::size_t comment = std::min(word.find('#'), word.size());
    at_ -= word.size() - comment;
    return word.substr(0, comment);
  }

  /// Reads the keyword: OFF behind prefixes, which state what a vertex has besides its position.
  void read_header() {
    const std::string_view keyword = word();
    const std::size_t off = keyword.find("OFF");
    const std::string_view prefixes = keyword.substr(0, off);
    if (off == std::string_view::npos ||
        prefixes.find_first_not_of("STCN4") != std::string_view::npos) {
      refuse("it begins with '" + shortened(keyword) +
             "'; choose from OFF, with ST, C, N or 4 before it");
    }
    at_ -= keyword.size() - off - 3;  // the counts may follow without a space
    is_homogeneous_ = prefixes.find('4') != std::string_view::npos;
    has_more_ = prefixes.find_first_of("STCN") != std::string_view::npos;
    const std::size_t counts = at_;
    if (word() == "BINARY") refuse("it is a binary .off file; save it as text");
    at_ = counts;
  }

  std::string_view needed_word(const std::string& item) {
    const std::string_view found = word();
    if (found.empty()) refuse(item + ": the file ends");
    return found;
  }

  double number(const std::string& item) {
    const std::string_view text = needed_word(item);
    const auto found = to_number(text);
    if (!found) refuse(item + ": '" + shortened(text) + "' is not a number");
    return *found;
  }

  std::size_t whole(const std::string& item) {
    const std::string_view text = needed_word(item);
    const auto found = to_number(text);
    if (!found || !(*found >= 0 && *found <= 4294967295.0 && *found == std::floor(*found))) {
      refuse(item + ": '" + shortened(text) + "' is not a whole number in [0, 4294967295]");
    }
    return static_cast<std::size_t>(*found);
  }

  Eigen::Vector3d vertex(const std::string& item) {
    const double x = number(item), y = number(item), z = number(item);
    const double w = is_homogeneous_ ? number(item) : 1;
    if (has_more_) skip_line();
    return Eigen::Vector3d(x, y, z) / w;
  }

  std::vector<std::size_t> face(const std::string& item) {
    std::vector<std::size_t> corners;
    for (std::size_t left = whole(item); left > 0; --left) corners.push_back(whole(item));
    skip_line();  // a colour
    return corners;
  }

  const std::string& text_;
  std::size_t at_ = 0;
  bool is_homogeneous_ = false, has_more_ = false;
};

}  // namespace

PolygonSoup read_off(const std::string& text) { return OffReader(text).read(); }

}  // namespace graspless::geometry
