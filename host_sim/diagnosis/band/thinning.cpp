#include "thinning.hpp"

#include <algorithm>

#include "band.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kSamplesPerTop = 24;    // of the fastest motion: one Runge-Kutta step each is right to 1e-4
constexpr double kFewestSamples = 4000;  // that are left: short work as it is
// Of the motion of its ends, that of a link: where it is less, the part of their power that thinning may lose can be a hundredth of its own.
constexpr double kTogether = 0.1;

// What moves a shaft is lost in the spectra of its ends where they turn together.
double top_of_link(const rig_file::Link& link, const host_sim::Record& record, host_sim::Quantity quantity) {
  const host_sim::Channel *a = record.find(quantity, link.a), *b = record.find(quantity, link.b);
  if (link.a < 1 || link.b < 1 || !a || !b) return 0;
  const Vec end = values_of(*a), between = end - values_of(*b);
  if (rms_about_mean(between) > kTogether * rms_about_mean(end)) return 0;
  return top_frequency(between, record.sample_period_s, quantity == host_sim::Quantity::kDisplacement);
}

}  // namespace

Vec values_of(const host_sim::Channel& c) { return Vec::Map(c.values.data(), static_cast<Index>(c.values.size())); }

Thinning thinning_of(const rig_file::RigModel& rig, const host_sim::Record& record) {
  Thinning thinning;
  for (const host_sim::Channel& c : record.channels) {
    if (c.quantity == host_sim::Quantity::kForce) continue;
    thinning.top_Hz = std::max(thinning.top_Hz, top_frequency(values_of(c), record.sample_period_s,
                                                              c.quantity == host_sim::Quantity::kDisplacement));
  }
  for (const rig_file::Link& link : rig.links)
    for (const auto quantity :
         {host_sim::Quantity::kDisplacement, host_sim::Quantity::kVelocity, host_sim::Quantity::kAcceleration})
      thinning.top_Hz = std::max(thinning.top_Hz, top_of_link(link, record, quantity));
  const double wanted = 1 / (record.sample_period_s * kSamplesPerTop * thinning.top_Hz);
  const double most = static_cast<double>(record.samples()) / kFewestSamples;
  thinning.by = std::max(1, static_cast<int>(std::min(wanted, most)));
  return thinning;
}

}  // namespace diagnosis::runs
