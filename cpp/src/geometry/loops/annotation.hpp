// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/loops/edge_graph.hpp"

namespace graspless::geometry {

/// Which class of H_1(K; Z_2) a cycle belongs to: the sum of what its edges carry (Busaryev,
/// Cabello, Chen, Dey, Wang 2012). A class is words() words of bits.
class Annotation {
 public:
  using Word = std::uint64_t;

  Annotation(const Complex& complex, const EdgeGraph& graph);

  int num_classes() const { return num_classes_; }  ///< the dimension of H_1
  int words() const { return words_; }
  const Word* of(int edge) const {
    return bits_.data() + static_cast<std::size_t>(edge) * static_cast<std::size_t>(words_);
  }
  bool is_zero(int edge) const;

 private:
  int num_classes_, words_;
  std::vector<Word> bits_;  // words() an edge
};

}  // namespace graspless::geometry
