// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/masks.hpp"

namespace graspless::geometry {

Mask opened(const Mask& mask) {
  Mask result = Mask::Constant(mask.rows(), mask.cols(), false);
  for (Eigen::Index v = 0; v + 1 < mask.rows(); ++v) {
    for (Eigen::Index u = 0; u + 1 < mask.cols(); ++u) {
      if (mask(v, u) && mask(v, u + 1) && mask(v + 1, u) && mask(v + 1, u + 1))
        result.block<2, 2>(v, u).setConstant(true);
    }
  }
  return result;
}

void take_connected(Mask& mask, Eigen::Index seed, std::vector<Eigen::Index>& members) {
  const Eigen::Index width = mask.cols();
  members.assign(1, seed);
  mask.data()[seed] = false;
  for (std::size_t k = 0; k < members.size(); ++k) {
    const Eigen::Index at = members[k], u = at % width;
    const auto visit = [&](bool exists, Eigen::Index next) {
      if (!exists || !mask.data()[next]) return;
      mask.data()[next] = false;
      members.push_back(next);
    };
    visit(u > 0, at - 1);
    visit(u + 1 < width, at + 1);
    visit(at >= width, at - width);
    visit(at + width < mask.size(), at + width);
  }
}

}  // namespace graspless::geometry
