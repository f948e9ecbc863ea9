#include "host_sim/records/turns/joined_turns.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "host_sim/records/median.hpp"

namespace host_sim {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kJump = 0.5;  // of the range: a motion of four samples a period moves by as much
constexpr size_t kFewestBeside = 3, kBeside[] = {8, 20};  // samples that a line is laid through
constexpr double kBeyondNoise = 4;                        // what the line climbs, over what it leaves
constexpr double kSameSlope = 0.5;                        // of the steeper one
constexpr double kSamePeriod = 0.02, kWholeTurn = 0.01;
constexpr double kOffPeriod = 0.1;         // of a jump: what the motion goes on by meanwhile
constexpr double kMostDoubtful = 1.0 / 3;  // of the jumps: where the motion turns round at one

struct Line {
  double slope, at, left;  // per sample; where it meets the middle of the jump; rms of what it leaves
};

// Through samples [first, first + count); of their ends the middle of the jump is half a sample before the first or behind the last.
Line line_through(const std::vector<double>& x, size_t first, size_t count, bool jump_behind) {
  const double middle = 0.5 * static_cast<double>(count - 1);
  double mean = 0, moment = 0, square = 0;
  for (size_t i = 0; i < count; ++i) mean += x[first + i] / static_cast<double>(count);
  for (size_t i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) - middle;
    moment += t * (x[first + i] - mean), square += t * t;
  }
  Line line{moment / square, 0, 0};
  line.at = mean + line.slope * (jump_behind ? middle + 0.5 : -middle - 0.5);
  for (size_t i = 0; i < count; ++i) {
    const double off = x[first + i] - mean - line.slope * (static_cast<double>(i) - middle);
    line.left += off * off / static_cast<double>(count);
  }
  line.left = std::sqrt(line.left);
  return line;
}

std::vector<size_t> jumps_in(const std::vector<double>& x, double range) {
  std::vector<size_t> jumps;
  for (size_t i = 1; i < x.size(); ++i)
    if (std::abs(x[i] - x[i - 1]) > kJump * range) jumps.push_back(i);
  return jumps;
}

// What a jump leaves out where the motion goes on over it, by lines through so many samples on either side; nothing where it does not, or
// where nothing can be said.
std::optional<double> left_out_at(const std::vector<double>& x, size_t at, size_t before, size_t behind) {
  if (before < kFewestBeside || behind < kFewestBeside) return {};
  const Line b = line_through(x, at - before, before, true), a = line_through(x, at, behind, false);
  const double steeper = std::max(std::abs(b.slope), std::abs(a.slope));
  const double climbs =
      std::min(std::abs(b.slope) * static_cast<double>(before), std::abs(a.slope) * static_cast<double>(behind));
  if (!(b.slope * a.slope > 0) || std::abs(b.slope - a.slope) > kSameSlope * steeper) return {};
  if (!(climbs > kBeyondNoise * std::max(b.left, a.left))) return {};
  const double jump = a.at - b.at;
  return jump * b.slope < 0 ? std::optional<double>(std::abs(jump)) : std::nullopt;
}

// Short lines bend little, long ones are beyond noise.
std::optional<double> left_out_at(const std::vector<double>& x, const std::vector<size_t>& jumps, size_t number) {
  const size_t at = jumps[number], begin = number == 0 ? 0 : jumps[number - 1],
               end = number + 1 == jumps.size() ? x.size() : jumps[number + 1];
  for (const size_t most : kBeside)
    if (const auto size = left_out_at(x, at, std::min(at - begin, most), std::min(end - at, most))) return size;
  return {};
}

// The period by which it counts over; nothing where it may not.
std::optional<double> period_of(const std::vector<double>& x, const std::vector<size_t>& jumps, double range) {
  std::vector<double> left_out;
  for (size_t i = 0; i < jumps.size(); ++i)
    if (const auto size = left_out_at(x, jumps, i)) left_out.push_back(*size);
  if (left_out.empty() ||
      static_cast<double>(jumps.size() - left_out.size()) > kMostDoubtful * static_cast<double>(jumps.size()))
    return {};
  const double middle = median(left_out);
  const bool whole_turn = std::abs(middle / kTurn - 1) < kWholeTurn;
  if (left_out.size() < 2 && !whole_turn) return {};
  const double period = whole_turn ? kTurn : middle;
  const auto differs = [&](double size) { return std::abs(size - period) > kSamePeriod * period; };
  if (range > (1 + kSamePeriod) * period || std::any_of(left_out.begin(), left_out.end(), differs)) return {};
  const auto is_other = [&](size_t at) { return std::abs(std::abs(x[at] - x[at - 1]) - period) > kOffPeriod * period; };
  if (std::any_of(jumps.begin(), jumps.end(), is_other)) return {};
  return period;
}

void join(std::vector<double>& x, double period) {
  double turns = 0, last = x.front();
  for (double& value : x) {
    turns -= std::round((value - last) / period);
    last = value;
    value += turns * period;
  }
}

}  // namespace

void join_turns(Record& record) {
  for (Channel& channel : record.channels) {
    if (channel.quantity != Quantity::kDisplacement || channel.values.size() < 2 * kFewestBeside) continue;
    const auto [lowest, highest] = std::minmax_element(channel.values.begin(), channel.values.end());
    const double low = *lowest, high = *highest;
    if (!(high > low) || !std::isfinite(high - low)) continue;
    const std::vector<size_t> jumps = jumps_in(channel.values, high - low);
    const auto period = jumps.empty() ? std::nullopt : period_of(channel.values, jumps, high - low);
    if (!period) continue;
    join(channel.values, *period);
    record.notes.push_back(fmt::format("{}: counts over by {:.4g} {} ({:.4g} to {:.4g}): turns joined", channel.name,
                                       *period, jumps.size() == 1 ? "once" : fmt::format("{} times", jumps.size()), low,
                                       high));
  }
}

}  // namespace host_sim
