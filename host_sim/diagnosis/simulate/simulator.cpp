#include "simulator.hpp"

#include <algorithm>
#include <cmath>

#include "../band/between_samples.hpp"

namespace diagnosis::runs {
namespace {

constexpr int kMostEvents = 12;
constexpr double kAtOnce = 1e-9;  // of a substep

}  // namespace

void Simulator::start(Index sample, const Vec& y) {
  at_ = std::min(sample, record_.samples - 2) * 2 * substeps_;
  const Outside o = outside(0);
  for (Friction& f : friction_) f.sign = relative(y, nodes_, f.a, f.b, o.v) < 0 ? -1 : 1;
  yield_old_ = true;
  begun_.is = false;
}

// The first of the links whose rate passes zero within the rest of a substep, and the share of it that is gone by then.
std::pair<Simulator::Friction*, double> Simulator::first_to_turn(const Vec& y0, const Vec& y, double from) {
  std::pair<Friction*, double> first{nullptr, 2};
  const double base0 = base_rate(from), base1 = base_rate(1);
  for (Friction& f : friction_) {
    if (f.sign == 0) continue;
    const double w0 = f.sign * relative(y0, nodes_, f.a, f.b, base0),
                 w1 = f.sign * relative(y, nodes_, f.a, f.b, base1);
    if (w1 >= 0) continue;
    const double share = w0 <= 0 ? 0 : w0 / (w0 - w1);
    if (share < first.second) first = {&f, share};
  }
  return first;
}

// The instant at which a link's rate is nought, by secants from a first guess.
double Simulator::share_to_turn(const Friction& f, const Vec& y0, double from, double share) {
  Vec y;
  for (int search = 0; search < 3 && share > kAtOnce; ++search) {
    y = y0;
    step(from, share * (1 - from), y, nullptr);
    const double w0 = f.sign * relative(y0, nodes_, f.a, f.b, base_rate(from));
    const double w = f.sign * relative(y, nodes_, f.a, f.b, base_rate(from + share * (1 - from)));
    if (w0 <= 0 || std::abs(w) < 1e-6 * w0) break;
    share = std::clamp(share * w0 / (w0 - w), 0.0, 1.0);
  }
  return share;
}

bool Simulator::advance(Index sample, Vec& y, Sensitivity* s) {
  static thread_local Sensitivity kept;
  static thread_local Vec y0;
  for (int sub = 0; sub < substeps_; ++sub) {
    at_ = (sample * substeps_ + sub) * 2;
    double from = 0;
    for (int events = 0; from < 1; ++events) {
      if (!friction_.empty()) y0 = y;
      if (s && !friction_.empty()) kept = *s;
      step(from, 1 - from, y, s);
      if (friction_.empty()) break;
      auto [link, share] = first_to_turn(y0, y, from);
      const auto [loose, until] = events < kMostEvents ? first_to_let_go(y0, y, from) : std::make_pair(link, 3.0);
      const bool lets_go = until < share;
      if (!link && !lets_go) break;
      if (lets_go)
        link = loose, share = until;
      else
        share = share_to_turn(*link, y0, from, share);
      y = y0;
      if (s) *s = kept;
      if (share > kAtOnce) step(from, share * (1 - from), y, s);
      from += share * (1 - from);
      if (events >= kMostEvents) {
        link->sign = 0, yield_old_ = true;
        if (events >= 2 * kMostEvents) return false;
        continue;
      }
      if (lets_go)
        let_go(*link, from, y);
      else
        turn(*link, from, y, s);
      if (from > 1 - kAtOnce) break;
    }
    if (!y.allFinite()) return false;
  }
  return true;
}

void Simulator::accelerations(Index sample, const Vec& y, Vec& a, Mat* slopes) {
  const bool last = sample + 1 >= record_.samples;
  at_ = (last ? sample - 1 : sample) * 2 * substeps_;
  if (last) at_ += 2 * (substeps_ - 1);
  Outside o = outside(last ? 1 : 0);
  for (size_t i = 0; i < fine_.size() && (late_ || (steps_ && last));
       ++i) {  // what is read at this instant acts at once
    const Vec& f = *fine_[i];
    const double behind = late_ ? 0.5 * record_.read_every_s / record_.step_s : 0;
    const double share = static_cast<double>(2 * substeps_), now = static_cast<double>(sample) * share;
    o.force[fine_node_[i]] += between(f, static_cast<Index>(now + behind * share), std::fmod(behind * share, 1)) -
                              (steps_ ? drive_at(f, 1) : f[sample * 2 * substeps_]);
  }
  accelerations(y, o, acc_[0], slopes != nullptr);
  begun_.is = !last && !late_, begun_.slopes = slopes != nullptr, begun_.at = at_, begun_.y = y, begun_.rows = nullptr;
  a = acc_[0].array() + o.carried;
  if (!slopes) return;
  *slopes = slope_x_;
  if (by_base_delay_ >= 0 && record_.base.ridden) slopes->col(states() + by_base_delay_).array() += o.jerk;
}

const Sensitivity& Simulator::rows_of_accelerations(const Mat& slopes, const Sensitivity& of_state) {
  answer(slopes, of_state, ka_[0]);
  const bool against_base = by_base_delay_ >= 0 && record_.base.ridden;  // there the step's own are others
  if (begun_.is && !against_base) begun_.rows = &of_state;
  return ka_[0];
}

double Simulator::elongation(const Vec& y, size_t link, Index sample) const {
  const auto [a, b] = link_ends_[link];
  return relative(y, 0, a, b, record_.guess.back().given ? record_.guess.back().x[sample] : 0);
}

}  // namespace diagnosis::runs
