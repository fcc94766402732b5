// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

#include <Eigen/Core>

namespace graspless::fuzz {

/// Decodes the bytes of one case into values. Once the bytes are used up, all further ones are 0.
/// Not clang's FuzzedDataProvider, because other compilers replay the regression files.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size) : next_(data), end_(data + size) {}

  std::uint8_t byte() { return next_ == end_ ? std::uint8_t{0} : *next_++; }
  bool chance(int one_in) { return byte() % one_in == one_in - 1; }

  /// Whole number in [least, most], which differ by less than 256.
  int whole(int least, int most) { return least + byte() % (most - least + 1); }

  /// Number in [least, most] in 256 steps, so that values coincide often. One in 64 lies elsewhere,
  /// at any magnitude.
  double number(double least, double most) {
    const std::uint8_t kind = byte();
    if (kind >= 252) return odd();
    if (kind >= 128) return least + (most - least) * (byte() + byte() / 256.0) / 256.0;
    return least + (most - least) * (kind % 9) / 8.0;
  }

  Eigen::Vector3d vector(double least, double most) {
    const double x = number(least, most), y = number(least, most), z = number(least, most);
    return {x, y, z};
  }

  /// All bytes that are left.
  std::string rest() {
    std::string text(reinterpret_cast<const char*>(next_), static_cast<std::size_t>(end_ - next_));
    next_ = end_;
    return text;
  }

 private:
  double odd() {
    constexpr std::array<double, 16> values{0,   1e-308, 1e-100, 1e-12, 1e-9, 1e-6,  1e-3,  1,
                                            1e3, 1e4,    1e6,    1e9,   1e12, 1e100, 1e308, 0};
    const std::uint8_t kind = byte();
    if (kind >= 250) return std::numeric_limits<double>::quiet_NaN();
    if (kind >= 244) return std::numeric_limits<double>::infinity();
    return (kind & 16) != 0 ? -values[kind % 16] : values[kind % 16];
  }

  const std::uint8_t *next_, *end_;
};

/// Thrown when a law is broken.
struct Violation : std::runtime_error {
  using std::runtime_error::runtime_error;
};

inline void require(bool holds, const std::string& law) {
  if (!holds) throw Violation("not fulfilled: " + law);
}

/// Runs a call that may refuse its input; returns true if it did not. Lets all other exceptions
/// through.
template <typename Call>
bool accepts(Call call) {
  try {
    call();
    return true;
  } catch (const std::invalid_argument& error) {
    require(error.what()[0] != '\0', "a refusal has a message");
    return false;
  }
}

}  // namespace graspless::fuzz
