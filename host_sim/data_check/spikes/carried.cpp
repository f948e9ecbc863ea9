#include "host_sim/data_check/spikes/carried.hpp"

#include <algorithm>

#include "host_sim/data_check/measures/statistics.hpp"

namespace host_sim::data_check {
namespace {

constexpr size_t kBeside = 8, kAround = 64;  // samples to either side
constexpr size_t kFewest = 2;                // stretches, unless there is but one
constexpr double kBeyond = 4.0;              // times the mean square around

// The samples beside the spikes.
std::vector<bool> beside(const std::vector<Gap>& gaps, size_t samples) {
  std::vector<bool> of(samples, false);
  for (const Gap& gap : gaps)
    for (size_t i = gap.first - std::min(gap.first, kBeside); i < std::min(samples, gap.first + gap.width + kBeside);
         ++i)
      of[i] = true;
  return of;
}

// The mean of those samples that are beside no spike.
double mean_away(const std::vector<double>& square, const std::vector<bool>& near, size_t first, size_t end) {
  double sum = 0.0, count = 0.0;
  for (size_t i = first; i < end; ++i)
    if (!near[i]) sum += square[i], count += 1.0;
  return count > 0.0 ? sum / count : 0.0;
}

// The mean square of the louder side of a stretch.
double mean_square_around(const std::vector<double>& square, const std::vector<bool>& near, size_t first, size_t end) {
  return std::max(mean_away(square, near, first - std::min(first, kAround), first),
                  mean_away(square, near, end, std::min(square.size(), end + kAround)));
}

double harm_to(const Channel& channel, const std::vector<bool>& near) {
  const double mean = mean_and_rms(channel.values).mean;
  std::vector<double> square;
  for (const double value : channel.values) square.push_back((value - mean) * (value - mean));
  double total = 0.0, beyond = 0.0;
  size_t stretches = 0, loud = 0;
  for (const double value : square) total += value;
  for (size_t first = 0, end = 0; first < near.size(); first = end) {
    end = first + 1;
    if (!near[first]) continue;
    double sum = square[first];
    for (; end < near.size() && near[end]; ++end) sum += square[end];
    const double usual = static_cast<double>(end - first) * mean_square_around(square, near, first, end);
    ++stretches;
    if (usual > 0.0 && sum > kBeyond * usual) beyond += sum - usual, ++loud;
  }
  if (loud < std::min(kFewest, stretches)) return 1.0;
  return total > beyond ? total / (total - beyond) : 1.0;
}

}  // namespace

Carried carried(const Record& record, const Channel& channel, const std::vector<Gap>& gaps) {
  Carried most;
  const std::vector<bool> near = beside(gaps, channel.values.size());
  for (const Channel& other : record.channels) {
    if (other.dof != channel.dof || other.quantity <= channel.quantity) continue;
    if (const double harm = harm_to(other, near); harm > most.harm) most = {&other, harm};
  }
  return most;
}

}  // namespace host_sim::data_check
