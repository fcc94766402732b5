// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "graspless/mechanics/contact.hpp"

namespace graspless::mechanics {

// Products `rows` W, rounded only once (rows: m x 6, W: scaled wrenches as columns). For contacts
// nearly on a line, some combination of the six components of W is tiny, and rounding W itself
// would destroy it.

/// W = `wrenches`, which are taken as exact.
Eigen::MatrixXd exact_product(const Eigen::MatrixXd& rows, const Matrix6Xd& wrenches);
/// W = R^1/2 W_env C_env, one column per edge.
Eigen::MatrixXd exact_environment(const Eigen::MatrixXd& rows, const ContactSet& set);
/// W = R^1/2 W_rob C_rob of one finger, one column per edge.
Eigen::MatrixXd exact_finger(const Eigen::MatrixXd& rows, const ContactSet& set, int finger);
/// W = R^1/2 Q_known.
Eigen::VectorXd exact_known(const Eigen::MatrixXd& rows, const ContactSet& set);

}  // namespace graspless::mechanics
