// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <utility>
#include <vector>

#include "geometry/cycles/edge_graph.hpp"

namespace graspless::geometry {

/// A label per edge such that the labels of a cycle's edges sum to its class in H_1(K; Z_2)
/// (Busaryev, Cabello, Chen, Dey, Wang 2012). Labels and classes are bit vectors of words() words.
class Annotation {
 public:
  using Word = std::uint64_t;

  /// Of all classes of a complex.
  Annotation(const Complex& complex, const EdgeGraph& graph);
  /// Of the classes that have labels. All others count as zero.
  explicit Annotation(ClassLabels labels)
      : num_classes_(labels.num_classes), words_(labels.words), bits_(std::move(labels.bits)) {
    find_zeros();
  }

  int num_classes() const { return num_classes_; }  ///< dimension of H_1
  int words() const { return words_; }
  const Word* of(int edge) const {
    return bits_.data() + static_cast<std::size_t>(edge) * static_cast<std::size_t>(words_);
  }
  bool is_zero(int edge) const { return is_zero_[edge]; }

 private:
  void find_zeros();

  int num_classes_, words_;
  std::vector<Word> bits_;     // words() per edge
  std::vector<char> is_zero_;  // per edge: true if its label is zero
};

}  // namespace graspless::geometry
