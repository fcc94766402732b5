// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "graspless/clasp/certificate.hpp"
#include "graspless/clasp/stability.hpp"
#include "graspless/export.hpp"
#include "graspless/planning/fields.hpp"

namespace graspless::clasp {

/// Options of the search; fields() describes them.
struct Options {
  double min_linking = 0;
  int targets = 0;
  bool attract = false;
  double resolution = 0.01;
  double friction = 0.5;
  StabilityOptions stability;
  CertificateOptions certificate;
  bool must_be_secure = true;
  double max_memory = 4e9;
};

/// Table of the members: name, unit, text, range and source.
constexpr auto fields(const Options&) {
  using planning::Field, planning::Range;
  return std::make_tuple(
      Field{"min_linking", &Options::min_linking, "",
            "Virtual linking in (0, 1) that every finger curve must reach before the hand closes, "
            "and must keep. 0: the hand closes as soon as every curve is linked, and the closed "
            "hand must come half way from its open state to what it reaches around a bar as thick "
            "as the loop's handle. The plan reports the value used.",
            Range::right_open(0, 1)},
      Field{"targets", &Options::targets, "",
            "Number of clasp targets on a loop. 0: one every half width of the hand, from 4 to 64.",
            Range::closed(0, 10000)},
      Field{"attract", &Options::attract, "",
            "Attract an open hand by the Gauss integral of the open curves while it is not "
            "linked."},
      Field{"resolution", &Options::resolution, "rad",
            "Largest joint step between checked configurations. At most 0.01, the step of check().",
            Range::closed(1e-4, 0.01)},
      Field{"friction", &Options::friction, "",
            "Coefficient of friction between the object and a hand of two fingers. Such a hand may "
            "also pinch a bar that could slip out without friction. 0: it may not.",
            Range::closed(0, 10)},
      Field{"stability",
            &Options::stability,
            "",
            "Options of the stability test.",
            {},
            "Section V-A"},
      Field{"certificate", &Options::certificate, "",
            "Options of the bounds on the opening through which the loop could leave the closed "
            "hand."},
      Field{"must_be_secure", &Options::must_be_secure, "",
            "Accept a clasp only if it passes the stability test or is a pinch that friction "
            "holds; otherwise the search continues."},
      Field{"max_memory", &Options::max_memory, "bytes", "Largest memory that the search may take.",
            Range::positive()});
}

/// Throws std::invalid_argument that names the option, its value and its range.
GRASPLESS_API void validate(const Options& options);

}  // namespace graspless::clasp
