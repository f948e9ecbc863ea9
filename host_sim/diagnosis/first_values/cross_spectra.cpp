#include "cross_spectra.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr Index kSegments = 8;  // of a record, and as many half way between them: for a coherent mean

using Complexes = Eigen::VectorXcd;

// Of one segment: what drives the rig, and every DOF's acceleration, a moving base's last.
struct SegmentSpectra {
  std::vector<Spectrum> force;  // per DOF; empty: none
  std::vector<Spectrum> acceleration;
};

struct Reading {
  const Vec* y = nullptr;
  int quantity = 0;
};

// The steepest of a DOF's readings: what is divided by the frequency hides no noise.
Reading steepest(const Prepared& record, int dof) {
  for (int quantity : {2, 1, 0})
    if (const MotionTrace* trace = trace_of(record, dof, quantity)) return {&trace->y, quantity};
  return {};
}

Reading steepest_of_base(const Prepared& record) {
  for (int quantity : {2, 1, 0})
    if (const Vec& y = record.base.reading[static_cast<size_t>(quantity)]; y.size()) return {&y, quantity};
  return {};
}

class Segments {
 public:
  Segments(const Prepared& record, size_t length)
      : record_(record), fourier_(length), step_s_(record.step_s), hann_(static_cast<Index>(length)) {
    for (Index k = 0; k < hann_.size(); ++k)
      hann_[k] = 0.5 - 0.5 * std::cos(kTwoPi * (static_cast<double>(k) + 0.5) / static_cast<double>(length));
  }
  SegmentSpectra at(Index from) const {
    SegmentSpectra s;
    for (size_t d = 0; d < record_.force.size(); ++d) {
      s.force.push_back(record_.force[d].size() ? of(record_.force[d], from) : Spectrum());
      s.acceleration.push_back(acceleration_of(steepest(record_, static_cast<int>(d)), from));
    }
    if (record_.base.given()) s.acceleration.push_back(acceleration_of(steepest_of_base(record_), from));
    return s;
  }
  double omega(Index bin) const {
    return kTwoPi * static_cast<double>(bin) / (static_cast<double>(hann_.size()) * step_s_);
  }
  Index bins() const { return fourier_.bins(); }

 private:
  Spectrum acceleration_of(const Reading& reading, Index from) const {
    if (!reading.y) return Spectrum::Zero(fourier_.bins());
    Spectrum a = of(*reading.y, from);
    for (Index i = 1; i < a.size(); ++i)
      for (int q = reading.quantity; q < 2; ++q) a[i] *= Complex(0, omega(i));
    return a;
  }
  Spectrum of(const Vec& y, Index from) const {
    const Vec part = y.segment(from, hann_.size());
    return fourier_.forward(hann_.cwiseProduct((part.array() - part.mean()).matrix()));
  }
  const Prepared& record_;
  Fourier fourier_;
  double step_s_;
  Vec hann_;
};

// drive: a DOF's force; from the last DOF on: the base.
void add(const SegmentSpectra& s, size_t drive, CrossSpectra& sum) {
  const Spectrum& driving = drive < s.force.size() ? s.force[drive] : s.acceleration.back();
  const Spectrum along = driving.conjugate();
  sum.power += driving.cwiseAbs2();
  for (size_t d = 0; d < s.force.size(); ++d)
    if (s.force[d].size()) sum.force[d] += along.cwiseProduct(s.force[d]);
  for (size_t d = 0; d < s.acceleration.size(); ++d) {
    sum.acceleration[d] += along.cwiseProduct(s.acceleration[d]);
    sum.acceleration_power[d] += s.acceleration[d].cwiseAbs2();
  }
}

}  // namespace

double CrossSpectra::coherence(Index bin) const {
  double most = 0;
  for (size_t d = 0; d < force.size(); ++d)
    most = std::max(most, std::norm(acceleration[d][bin]) / std::max(1e-300, power[bin] * acceleration_power[d][bin]));
  return most;
}

std::vector<CrossSpectra> cross_spectra(const Prepared& p) {
  const Index length = static_cast<Index>(fast_length(static_cast<size_t>(2 * p.samples / (kSegments + 1))));
  if (length < kLeast) return {};
  const Segments segments(p, static_cast<size_t>(length));
  const Complexes none = Complexes::Zero(segments.bins());
  std::vector<size_t> drives;
  for (size_t d = 0; d < p.force.size(); ++d)
    if (p.force[d].size() && p.force[d].cwiseAbs().maxCoeff() > 0) drives.push_back(d);
  if (p.base.given()) drives.push_back(p.force.size());
  const size_t moving = p.force.size() + (p.base.given() ? 1 : 0);
  CrossSpectra empty;
  empty.hertz.resize(segments.bins()), empty.power = Vec::Zero(segments.bins());
  empty.acceleration.assign(moving, none), empty.acceleration_power.assign(moving, empty.power);
  for (Index i = 0; i < segments.bins(); ++i) empty.hertz[i] = segments.omega(i) / kTwoPi;
  for (const Vec& f : p.force) empty.force.push_back(f.size() ? none : Complexes());
  std::vector<CrossSpectra> list(drives.size(), empty);
  if (p.base.given()) list.back().of_base = true;
  for (Index from = 0; !drives.empty() && from + length <= p.samples; from += length / 2) {
    const SegmentSpectra spectra = segments.at(from);
    for (size_t k = 0; k < drives.size(); ++k) add(spectra, drives[k], list[k]);
  }
  return list;
}

}  // namespace diagnosis::runs
