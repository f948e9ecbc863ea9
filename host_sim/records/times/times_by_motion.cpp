#include "host_sim/records/times/times_by_motion.hpp"

#include <algorithm>

#include "host_sim/records/derived/noise_variance.hpp"

namespace host_sim {
namespace {

constexpr double kClearly = 2.0;  // times the variance
constexpr double kNone =
    1e-20;  // of the mean square: what is left of a motion without any noise is the last bits of its numbers

double mean_square_of(const std::vector<double>& x) {
  double sum = 0.0;
  for (const double value : x) sum += value * value;
  return x.empty() ? 0.0 : sum / static_cast<double>(x.size());
}

}  // namespace

bool smoother_as_given(const Record& record, size_t first, const std::vector<double>& given_s,
                       const std::vector<double>& even_s) {
  if (!std::is_sorted(given_s.begin(), given_s.end(), std::less_equal<double>())) return false;  // two rows at one time
  double for_given = 1.0, for_even = 1.0;  // the channel that says it most clearly
  for (const Channel& channel : record.channels) {
    if (channel.held || channel.values.size() < first + given_s.size()) continue;
    const auto from = channel.values.begin() + static_cast<std::ptrdiff_t>(first);
    const std::vector<double> x(from, from + static_cast<std::ptrdiff_t>(given_s.size()));
    const double least = kNone * mean_square_of(x), as_given = noise_variance(x, given_s) + least,
                 as_even = noise_variance(x, even_s) + least;
    if (!(least > 0.0)) continue;
    for_given = std::max(for_given, as_even / as_given), for_even = std::max(for_even, as_given / as_even);
  }
  return for_given > kClearly && for_given > for_even;
}

}  // namespace host_sim
