#include "cross_spectra.hpp"

#include <cmath>

namespace diagnosis::runs {
namespace {

constexpr Index kSegments = 8;  // of a record, and as many half way between them: for a coherent mean

using Complexes = Eigen::VectorXcd;

// Of one segment: what drives the rig, and every DOF's acceleration.
struct SegmentSpectra {
  std::vector<Spectrum> force;  // per DOF; empty: none
  std::vector<Spectrum> acceleration;
};

// The steepest of a DOF's readings: what is divided by the frequency hides no noise.
const MotionTrace* steepest(const Prepared& record, int dof) {
  for (int quantity : {2, 1, 0})
    if (const MotionTrace* trace = trace_of(record, dof, quantity)) return trace;
  return nullptr;
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
      const MotionTrace* trace = steepest(record_, static_cast<int>(d));
      s.acceleration.push_back(trace ? of(trace->y, from) : Spectrum::Zero(fourier_.bins()));
      for (Index i = 1; trace && i < s.acceleration[d].size(); ++i)
        for (int q = trace->quantity; q < 2; ++q) s.acceleration[d][i] *= Complex(0, omega(i));
    }
    return s;
  }
  double omega(Index bin) const {
    return kTwoPi * static_cast<double>(bin) / (static_cast<double>(hann_.size()) * step_s_);
  }
  Index bins() const { return fourier_.bins(); }

 private:
  Spectrum of(const Vec& y, Index from) const {
    const Vec part = y.segment(from, hann_.size());
    return fourier_.forward(hann_.cwiseProduct((part.array() - part.mean()).matrix()));
  }
  const Prepared& record_;
  Fourier fourier_;
  double step_s_;
  Vec hann_;
};

void add(const SegmentSpectra& s, size_t drive, CrossSpectra& sum) {
  const Spectrum along = s.force[drive].conjugate();
  sum.power += s.force[drive].cwiseAbs2();
  for (size_t d = 0; d < s.acceleration.size(); ++d) {
    if (s.force[d].size()) sum.force[d] += along.cwiseProduct(s.force[d]);
    sum.acceleration[d] += along.cwiseProduct(s.acceleration[d]);
  }
}

}  // namespace

std::vector<CrossSpectra> cross_spectra(const Prepared& p) {
  const Index length = static_cast<Index>(fast_length(static_cast<size_t>(2 * p.samples / (kSegments + 1))));
  if (length < kLeast) return {};
  const Segments segments(p, static_cast<size_t>(length));
  const Complexes none = Complexes::Zero(segments.bins());
  std::vector<size_t> drives;
  for (size_t d = 0; d < p.force.size(); ++d)
    if (p.force[d].size() && p.force[d].cwiseAbs().maxCoeff() > 0) drives.push_back(d);
  CrossSpectra empty{
      Vec(segments.bins()), Vec::Zero(segments.bins()), {}, std::vector<Complexes>(p.force.size(), none)};
  for (Index i = 0; i < segments.bins(); ++i) empty.hertz[i] = segments.omega(i) / kTwoPi;
  for (const Vec& f : p.force) empty.force.push_back(f.size() ? none : Complexes());
  std::vector<CrossSpectra> list(drives.size(), empty);
  for (Index from = 0; !drives.empty() && from + length <= p.samples; from += length / 2) {
    const SegmentSpectra spectra = segments.at(from);
    for (size_t k = 0; k < drives.size(); ++k) add(spectra, drives[k], list[k]);
  }
  return list;
}

}  // namespace diagnosis::runs
