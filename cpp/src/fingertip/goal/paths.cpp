// SPDX-FileCopyrightText: 2026 The graspless authors
// SPDX-License-Identifier: BSD-3-Clause
//
// Paths over given edges, with one slide and one turn at different times.
#include <algorithm>
#include <cmath>

#include "graspless/watch.hpp"

#include "fingertip/goal/goal.hpp"

namespace graspless::fingertip {
namespace {

// Motions smaller than this are rounding: of the object's size, and [rad].
constexpr double kNoMotion = 1e-7;

int segments(double amount, double step) {
  return std::max(1, static_cast<int>(std::ceil(std::abs(amount) / step - 1e-6)));
}

void append(const Path& leg, Path* path) {
  path->X_WO.insert(path->X_WO.end(), leg.X_WO.begin() + 1, leg.X_WO.end());
}

void add_tumble(const Goal& goal, const TumbleEdge& edge, Path* path) {
  const Eigen::Isometry3d X_WO = path->X_WO.back();
  append(turn_path(X_WO, X_WO * edge.p_O, X_WO.linear() * edge.axis_O, edge.angle,
                   segments(edge.angle, goal.turn_step)),
         path);
}

/// Times at which a path turns and slides: before the tumble of that number.
struct Schedule {
  enum class Order { turn_first, slide_first, at_once };
  double yaw;  // of the turn, right hand about the floor's normal [rad]
  std::size_t turn, slide;
  Order order;
};

class PathMaker {
 public:
  PathMaker(const Problem& problem, const Goal& goal, const TumbleSequence& tumbles)
      : problem_(problem), goal_(goal), tumbles_(tumbles), n_W_(problem.planes.front().n_W) {
    rolled_.push_back(goal.X_WO_start);
    for (const TumbleEdge* edge : tumbles) rolled_.push_back(tumbled(rolled_.back(), *edge));
    floor_motion_ = goal.X_WO_goal * rolled_.back().inverse();
    const Eigen::Quaterniond q(floor_motion_.linear());
    yaw_ = 2 * std::atan2(q.vec().dot(n_W_), q.w());
    yaw_ = std::remainder(yaw_, 2 * M_PI);
  }

  bool turns() const { return std::abs(yaw_) > kNoMotion; }
  bool slides_after_turn_at(std::size_t time) const {
    return slide_for(time).norm() > kNoMotion * problem_.object.size();
  }
  /// The yaw to turn by; both directions if half a turn is needed.
  std::vector<double> yaws() const {
    if (std::abs(std::abs(yaw_) - M_PI) < 1e-6)
      return {yaw_, yaw_ > 0 ? yaw_ - 2 * M_PI : yaw_ + 2 * M_PI};
    return {yaw_};
  }

  Path make(const Schedule& schedule) const {
    Path path{{goal_.X_WO_start}};
    const Eigen::Vector3d t_W = slide_for(schedule.turn);
    for (std::size_t time = 0; time <= tumbles_.size(); ++time) {
      const bool slide_first = schedule.order == Schedule::Order::slide_first;
      if (schedule.order == Schedule::Order::at_once) {
        if (time == schedule.turn) add_turn_about_pole(schedule.yaw, time, &path);
      } else {
        if (time == schedule.slide && slide_first) add_slide(t_W, &path);
        if (time == schedule.turn) add_turn(schedule.yaw, &path);
        if (time == schedule.slide && !slide_first) add_slide(t_W, &path);
      }
      if (time < tumbles_.size()) add_tumble(goal_, *tumbles_[time], &path);
    }
    return path;
  }

 private:
  /// The slide that remains when the object turns about its centre of mass at this time. It is the
  /// same whether it comes before or after the turn.
  Eigen::Vector3d slide_for(std::size_t turn) const {
    const Eigen::Vector3d p_W = rolled_[turn] * problem_.object.com();
    const Eigen::Vector3d t_W = floor_motion_ * p_W - p_W;
    return t_W - n_W_.dot(t_W) * n_W_;
  }

  void add_slide(const Eigen::Vector3d& t_W, Path* path) const {
    if (t_W.norm() <= kNoMotion * problem_.object.size()) return;
    append(slide_path(path->X_WO.back(), t_W, segments(t_W.norm(), goal_.slide_step)), path);
  }
  void add_turn(double yaw, Path* path) const {
    if (std::abs(yaw) <= kNoMotion) return;
    const Eigen::Isometry3d X_WO = path->X_WO.back();
    append(turn_path(X_WO, X_WO * problem_.object.com(), n_W_, yaw, segments(yaw, goal_.turn_step)),
           path);
  }
  void add_turn_about_pole(double yaw, std::size_t time, Path* path) const {
    const Eigen::Isometry3d X_WO = path->X_WO.back();
    const Eigen::Vector3d p_W = X_WO * problem_.object.com();
    const Eigen::Vector3d t_W = slide_for(time);
    // The fixed point of the turn, which sees p_W and p_W + t_W under the angle.
    const Eigen::Vector3d pole_W = p_W + t_W / 2 + n_W_.cross(t_W) / (2 * std::tan(yaw / 2));
    const double arc = std::abs(yaw) * (pole_W - p_W).norm();
    const int count = std::max(segments(yaw, goal_.turn_step), segments(arc, goal_.slide_step));
    append(turn_path(X_WO, pole_W, n_W_, yaw, count), path);
  }
  const Problem& problem_;
  const Goal& goal_;
  const TumbleSequence& tumbles_;
  Eigen::Vector3d n_W_;
  std::vector<Eigen::Isometry3d> rolled_;  // after each tumble, without slides and turns
  Eigen::Isometry3d floor_motion_;
  double yaw_;
};

/// The times at which the object stands by itself.
std::vector<std::size_t> standing_times(const ContactStates& states, int start_face,
                                        const TumbleSequence& tumbles) {
  std::vector<std::size_t> times;
  for (std::size_t time = 0; time <= tumbles.size(); ++time) {
    const int face = time == 0 ? start_face : tumbles[time - 1]->to;
    if (states[face].is_stable) times.push_back(time);
  }
  return times;
}

}  // namespace

std::vector<Path> goal_paths(const Problem& problem, const Goal& goal, const ContactStates& states,
                             int start_face, const TumbleSequence& tumbles) {
  using Order = Schedule::Order;
  const PathMaker maker(problem, goal, tumbles);
  const std::vector<std::size_t> times = standing_times(states, start_face, tumbles);
  std::vector<Schedule> schedules;
  for (const double yaw : maker.yaws()) {
    for (const std::size_t turn : maker.turns() ? times : std::vector<std::size_t>{0}) {
      if (!maker.slides_after_turn_at(turn)) {
        schedules.push_back({yaw, turn, turn, Order::turn_first});
        continue;
      }
      for (const std::size_t slide : times) {
        schedules.push_back({yaw, turn, slide, Order::turn_first});
        if (slide == turn && maker.turns()) {
          schedules.push_back({yaw, turn, slide, Order::slide_first});
          schedules.push_back({yaw, turn, slide, Order::at_once});
        }
      }
    }
  }
  std::vector<Path> paths;
  for (const Schedule& schedule : schedules) {
    poll();
    paths.push_back(maker.make(schedule));
  }
  return paths;
}

Path tumbles_alone(const Goal& goal, const TumbleSequence& tumbles) {
  Path path{{goal.X_WO_start}};
  for (const TumbleEdge* edge : tumbles) add_tumble(goal, *edge, &path);
  return path;
}

}  // namespace graspless::fingertip
