// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
#include "graspless/scene/link_contacts.hpp"

#include <algorithm>
#include <limits>
#include <random>
#include <set>
#include <stdexcept>
#include <string>

#include "graspless/scene/scene.hpp"
#include "graspless/watch.hpp"

#include "text.hpp"

namespace graspless::scene {
namespace {

constexpr int kMaxSamples = 1000000;
constexpr int kLeastFirst = 50;    // samples that decide about pairs that touch
constexpr int kEnoughNear = 2000;  // samples in which a pair's boxes meet, but it does not touch
constexpr double kAlways = 0.95;   // of the samples, as MoveIt's set-up assistant
constexpr int kFewJoints = 3;      // between two links: the samples cover their motion
constexpr int kDescents = 12;      // towards contact, for each pair with more joints
constexpr int kSteps = 200;        // of a descent

/// A pair that is still tested, with the number of samples in which its boxes met, and it touched.
struct OpenContact {
  int pair;
  int near = 0;
  int touched = 0;
};

class ContactSampler {
 public:
  ContactSampler(const robot::Robot& robot, std::uint64_t seed, const std::set<int>& chosen)
      : robot_(robot), scene_(robot), rng_(seed), q_(robot.dof()) {
    for (int pair = 0; pair < scene_.world().num_pairs(); ++pair) {
      const auto [a, b] = links(pair);
      if (chosen.empty() || chosen.count(a) || chosen.count(b)) open_.push_back({pair});
    }
  }

  LinkContacts run(int samples) {
    const int first = std::min(samples, std::max(kLeastFirst, samples / 50));
    for (int i = 0; i < first; ++i) test(i);
    LinkContacts found;
    for (const OpenContact& contact : open_) {
      if (contact.touched >= kAlways * first) found.always.push_back(links(contact.pair));
    }
    std::vector<int> apart;  // pairs without contact in the samples
    for (int i = first; i < samples && !open_.empty(); ++i) {
      close_decided(apart);
      test(i);
    }
    close_decided(apart);
    for (const OpenContact& contact : open_) apart.push_back(contact.pair);
    for (const int pair : apart) {
      if (!can_touch(pair)) found.never.push_back(links(pair));
    }
    std::sort(found.never.begin(), found.never.end());
    return found;
  }

 private:
  double unit() { return std::uniform_real_distribution<double>(0, 1)(rng_); }

  void draw(bool at_limits) {
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      const double lower = robot_.lower()[i], upper = robot_.upper()[i], t = unit();
      q_[i] = lower + t * (upper - lower);
      if (at_limits && unit() < 0.5) q_[i] = t < 0.5 ? lower : upper;
    }
  }

  void test(int sample) {
    poll();
    draw(sample % 2 == 1);
    place();
    for (OpenContact& contact : open_) {
      constexpr double kApart = 1e-6;  // [m]
      if (scene_.world().distance_bound(contact.pair, kApart) >= kApart) continue;
      ++contact.near;
      contact.touched += scene_.world().touches(contact.pair);
    }
  }

  /// True if a descent of their distance, over the joints between them, ends in contact.
  bool can_touch(int pair) {
    const auto [a, b] = links(pair);
    std::vector<Eigen::Index> joints;
    for (Eigen::Index i = 0; i < q_.size(); ++i) {
      if ((robot_.reach(a)[i] > 0) != (robot_.reach(b)[i] > 0)) joints.push_back(i);
    }
    if (joints.size() <= kFewJoints) return false;
    for (int descent = 0; descent < kDescents; ++descent) {
      poll();
      draw(false);
      if (descends_to_contact(pair, joints)) return true;
    }
    return false;
  }

  bool descends_to_contact(int pair, const std::vector<Eigen::Index>& joints) {
    std::normal_distribution<double> normal;
    double least = gap(pair), width = 0.2;
    for (int step = 0; step < kSteps && least >= 0; ++step) {
      const Eigen::VectorXd before = q_;
      for (const Eigen::Index i : joints) {
        const double lower = robot_.lower()[i], upper = robot_.upper()[i];
        q_[i] = std::clamp(q_[i] + width * (upper - lower) * normal(rng_), lower, upper);
      }
      const double now = gap(pair);
      width = now < least ? std::min(1.5 * width, 0.3) : std::max(0.9 * width, 0.001);
      if (now > least) q_ = before;
      least = std::min(now, least);
    }
    return least < 0;
  }

  /// What a descent reduces [m]: a rough bound on the distance while the boxes are apart, then one
  /// from convex hulls; 0 where they overlap, and negative in contact.
  double gap(int pair) {
    constexpr double kApart = 100;  // beyond all distances from hulls [m]
    const auto [a, b] = links(pair);
    for (const int link : {a, b}) {
      robot_.forward_to(link, q_, X_WL_);
      scene_.world().set_pose(scene_.link_body(link), X_WL_[link]);
    }
    const double rough = scene_.world().distance_bound(pair);
    if (rough > 0) return kApart + rough;
    const double hulls =
        scene_.world().proven_distance(pair, std::numeric_limits<double>::infinity());
    if (hulls > 0) return hulls;
    return scene_.world().touches(pair) ? -1 : 0;
  }

  void place() {
    robot_.forward(q_, X_WL_);
    for (std::size_t link = 0; link < X_WL_.size(); ++link) {
      const int body = scene_.link_body(static_cast<int>(link));
      if (body >= 0) scene_.world().set_pose(body, X_WL_[link]);
    }
  }

  void close_decided(std::vector<int>& apart) {
    const auto is_decided = [&](const OpenContact& contact) {
      if (contact.touched == 0 && contact.near >= kEnoughNear) apart.push_back(contact.pair);
      return contact.touched > 0 || contact.near >= kEnoughNear;
    };
    open_.erase(std::remove_if(open_.begin(), open_.end(), is_decided), open_.end());
  }

  std::pair<int, int> links(int pair) const {
    const auto [a, b] = scene_.world().pair(pair);
    const int i = robot_.frame(scene_.world().name(a)), j = robot_.frame(scene_.world().name(b));
    return {std::min(i, j), std::max(i, j)};
  }

  const robot::Robot& robot_;
  Scene scene_;
  std::mt19937_64 rng_;
  Eigen::VectorXd q_;
  robot::Poses X_WL_;
  std::vector<OpenContact> open_;
};

}  // namespace

LinkContacts sample_contacts(const robot::Robot& robot, int samples, std::uint64_t seed,
                             const std::vector<int>& links) {
  require_within("samples", samples, 1, kMaxSamples);
  const auto count = static_cast<int>(robot.frame_names().size());
  for (const int link : links) {
    if (link >= 0 && link < count) continue;
    throw std::invalid_argument("links must be indices of the " + std::to_string(count) +
                                " links, not " + std::to_string(link));
  }
  return ContactSampler(robot, seed, {links.begin(), links.end()}).run(samples);
}

}  // namespace graspless::scene
