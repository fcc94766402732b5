// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

// Products `rows` W (rows: m x 6, W: scaled wrenches as columns) that are rounded once. Where
// contacts are nearly on a line, some combination of the six components of W is tiny, and rounding W
// itself would destroy it.

Eigen::MatrixXd exact_product(const Eigen::MatrixXd& rows, const Matrix6Xd& wrenches);
/// W = R^1/2 W_env C_env, a column an edge.
Eigen::MatrixXd exact_environment(const Eigen::MatrixXd& rows, const ContactSet& set);
/// W = R^1/2 W_rob C_rob of one finger, a column an edge.
Eigen::MatrixXd exact_finger(const Eigen::MatrixXd& rows, const ContactSet& set, int finger);
/// W = R^1/2 Q_known.
Eigen::VectorXd exact_known(const Eigen::MatrixXd& rows, const ContactSet& set);

}  // namespace graspless::mechanics
