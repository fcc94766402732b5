// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include <Eigen/Core>

namespace graspless::planning {

/// Some joints of a robot, as a box of their own. It keeps references.
struct Joints {
  const std::vector<int>& index;
  const Eigen::VectorXd& rest;  // values of the others

  Eigen::VectorXd part(const Eigen::VectorXd& q) const {
    Eigen::VectorXd out(static_cast<Eigen::Index>(index.size()));
    for (Eigen::Index i = 0; i < out.size(); ++i) out[i] = q[index[i]];
    return out;
  }
  Eigen::VectorXd full(const Eigen::VectorXd& part) const {
    Eigen::VectorXd out = rest;
    for (Eigen::Index i = 0; i < part.size(); ++i) out[index[i]] = part[i];
    return out;
  }
  std::vector<Eigen::VectorXd> full(const std::vector<Eigen::VectorXd>& parts) const {
    std::vector<Eigen::VectorXd> all;
    for (const Eigen::VectorXd& part : parts) all.push_back(full(part));
    return all;
  }
};

}  // namespace graspless::planning
