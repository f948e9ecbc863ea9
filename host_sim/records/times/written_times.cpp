#include "host_sim/records/times/written_times.hpp"

#include <algorithm>
#include <cmath>

namespace host_sim {
namespace {

// Whole to 1e-3 of a unit, and to what a number of double precision leaves of it: `spacing_s`, 0.2 us of seconds since 1970.
bool whole_in(double t, double place_s, double spacing_s) {
  const double units = t / place_s;
  return std::abs(units - std::nearbyint(units)) < std::min(0.25, 1e-3 + spacing_s / place_s);
}

constexpr size_t kTells = 16;  // so many times are no chance: all whole by ten finer places at one in 10^16

}  // namespace

size_t Written::index_of(double t) const {
  const int decade = t == 0.0 ? latest : static_cast<int>(std::floor(std::log10(std::abs(t)) + 1e-12));
  return static_cast<size_t>(std::clamp(latest - decade, 0, static_cast<int>(places_s.size()) - 1));
}

Written in_decimals(const std::vector<double>& time_s, double latest_s, double spacing_s) {
  constexpr size_t kDecades = 8;
  Written written;
  written.places_s.assign(kDecades, 1.0);
  written.latest = static_cast<int>(std::floor(std::log10(latest_s) + 1e-12));
  std::vector<size_t> count(kDecades, 0);
  for (const double t : time_s) {
    if (t == 0.0) continue;
    const size_t at = written.index_of(t);
    double& place = written.places_s[at];
    ++count[at];
    for (const double finest = 0.5e-9 * std::pow(10.0, -static_cast<double>(at)); !whole_in(t, place, spacing_s);)
      if ((place *= 0.1) < finest) return {};
  }
  double earlier_s = 0.0;  // a few times may be whole by chance: no more than tenfold from decade to decade
  for (size_t at = kDecades; at-- > 0;) {
    double& place = written.places_s[at];
    if (earlier_s > 0.0 && count[at] < kTells) place = std::min(place, count[at] > 0 ? 10.0 * earlier_s : earlier_s);
    if (count[at] > 0) earlier_s = place;
    if (count[at] >= kTells) written.place_s = std::max(written.place_s, place);
  }
  for (size_t at = 1; at < kDecades; ++at)
    written.places_s[at] = std::min(written.places_s[at], written.places_s[at - 1]);
  if (written.place_s == 0.0) written.place_s = written.places_s[0];
  return written;
}

Written in_single_precision(const std::vector<double>& time_s, double latest_s) {
  const auto single = [](double t) { return static_cast<double>(static_cast<float>(t)) == t; };
  const auto upper = static_cast<float>(latest_s);
  if (!std::all_of(time_s.begin(), time_s.end(), single)) return {};
  return {std::nextafterf(upper, 2.0F * upper) - upper, 0, {}};
}

}  // namespace host_sim
