// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/planning/path.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>
#include <utility>

#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::planning {

namespace {

void require_one_size(const Path& path) {
  for (const Eigen::VectorXd& q : path) {
    if (q.size() != path.front().size())
      throw std::invalid_argument("configurations of a path must have one size");
  }
}

}  // namespace

double length(const Path& path) {
  require_one_size(path);
  double sum = 0;
  for (std::size_t i = 1; i < path.size(); ++i) sum += (path[i] - path[i - 1]).norm();
  return sum;
}

Path shortcut(Path path, const Connect& connect, int rounds, std::mt19937_64& rng) {
  require_one_size(path);
  std::set<std::pair<std::size_t, std::size_t>> refused;  // of this path
  for (int round = 0; round < rounds && path.size() > 2; ++round) {
    poll();
    std::uniform_int_distribution<std::size_t> draw(0, path.size() - 1);
    std::size_t i = draw(rng), j = draw(rng);
    if (i > j) std::swap(i, j);
    if (j - i < 2 || !refused.insert({i, j}).second) continue;
    const auto first = path.begin() + i;
    const auto last = path.begin() + j;
    const auto detour = connect(path[i], path[j]);
    if (!detour || length(*detour) >= length(Path(first, last + 1)) - 1e-9) continue;
    Path shorter(path.begin(), first);
    shorter.insert(shorter.end(), detour->begin(), detour->end());
    shorter.insert(shorter.end(), last + 1, path.end());
    path = std::move(shorter);
    refused.clear();
  }
  return path;
}

Path subdivided(const Path& path, double step, const Eigen::VectorXd& weights) {
  constexpr double kMost = 1e7;
  require(step > 0, "step", step, "must be positive");
  const auto span = [&](const Eigen::VectorXd& change) {
    return weights.size() == 0 ? change.lpNorm<Eigen::Infinity>()
                               : change.cwiseProduct(weights).lpNorm<Eigen::Infinity>();
  };
  require_one_size(path);
  if (!path.empty() && weights.size() > 0 && weights.size() != path.front().size())
    throw std::invalid_argument("weights must have the size of the path's configurations");
  Path fine;
  for (const Eigen::VectorXd& q : path) {
    if (!fine.empty()) {
      const Eigen::VectorXd from = fine.back();
      const double steps = std::ceil(span(q - from) / step);
      require(steps <= kMost, "step", step, "must be larger for such a path");
      const int pieces = static_cast<int>(steps);
      for (int i = 1; i < pieces; ++i, poll()) fine.push_back(from + (q - from) * i / pieces);
    }
    fine.push_back(q);
  }
  return fine;
}

}  // namespace graspless::planning
