// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
// Stabilities asked for in batches and solved by several threads.
#include "fingertip/lazy/evaluator_pool.hpp"

#include <algorithm>

namespace graspless::fingertip {

void EvaluatorPool::start(std::vector<StabilityQuery>& queries) {
  job_.emplace(std::min(evaluators_.size(), queries.size()),
               [this, &queries](std::size_t lane) { solve_lane(queries, lane); });
  crew_.start(*job_);
}

void EvaluatorPool::finish() {
  crew_.finish(*job_);
  job_.reset();
}

void EvaluatorPool::cancel() {
  if (job_) crew_.cancel(*job_);
  job_.reset();
}

void EvaluatorPool::solve_lane(std::vector<StabilityQuery>& queries, std::size_t lane) {
  Evaluator& evaluator = evaluators_[lane];
  for (std::size_t i = lane; i < queries.size() && !job_->has_ended; i += evaluators_.size()) {
    StabilityQuery& query = queries[i];
    evaluator.solver().clear_supports();
    query.z = evaluator.stability(query.instant, query.placement, query.needed);
    query.functionals = evaluator.solver().supports();
  }
}

}  // namespace graspless::fingertip
