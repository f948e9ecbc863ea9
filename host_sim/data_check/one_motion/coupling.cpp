#include "host_sim/data_check/one_motion/coupling.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>

#include "hal/rig_file/channel_entry.hpp"
#include "host_sim/data_check/measures/bell.hpp"
#include "host_sim/records/ac_coupling.hpp"

namespace host_sim::data_check {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr size_t kBlocks = 16, kFewestInBlock = 16;
constexpr double kSameMotion = 0.5;  // of the square of what the lower channel says
constexpr double kOwnShare = 1e-3;   // of the square of a column: else another says the same
constexpr double kDeviations = 8.0, kTakes = 0.002, kAgrees = 0.1;

// Columns of one equation, at every h-th sample: derivatives of y, 1, and a'. The first stands for the gain, the second for a delay, the
// further ones for filters that differ, as a series.
enum Place { kReading, kSlope, kCurve, kThird, kFourth, kLower, kOne, kPlaces };
constexpr int kKnown = kLower;  // columns that y makes
using Products = Eigen::Matrix<double, kPlaces, kPlaces>;
using Row = Eigen::Matrix<double, kPlaces, 1>;
using Columns = std::array<std::vector<double>, kOne>;

void thin(std::vector<double>& values, size_t h) {
  size_t count = 0;
  for (size_t i = 0; i < values.size(); i += h) values[count++] = values[i];
  values.resize(count);
}

// Under the narrowest bell.
Columns narrowest(const Channel& lower, const Channel& acceleration, double sample_period_s) {
  constexpr size_t kNarrowest = 2;
  Columns columns;
  for (int k = 0; k < kKnown; ++k)
    columns[static_cast<size_t>(k)] = bell(acceleration.values, k, kNarrowest, sample_period_s);
  columns[kLower] = bell(lower.values, lower.quantity == Quantity::kVelocity ? 2 : 3, kNarrowest, sample_period_s);
  for (std::vector<double>& column : columns) thin(column, kNarrowest);
  return columns;
}

std::vector<Products> products_of_blocks(const Columns& columns) {
  std::vector<Products> blocks(kBlocks, Products::Zero());
  const size_t count = columns[0].size();
  for (size_t i = 0; i < count; ++i) {
    Row row;
    row[kOne] = 1.0;
    for (size_t k = 0; k < columns.size(); ++k) row[static_cast<int>(k)] = columns[k][i];
    blocks[i * kBlocks / count] += row * row.transpose();
  }
  return blocks;
}

struct Fit {
  double wc = 0.0, explained = 0.0;  // share of the lower channel's square
};
// About the means. Nothing where what a corner takes away is what the other columns make of it.
std::optional<Fit> fit_of(const Products& p) {
  using Square = Eigen::Matrix<double, kKnown, kKnown>;
  const Eigen::Matrix<double, kLower + 1, 1> mean = p.col(kOne).head<kLower + 1>() / p(kOne, kOne);
  Eigen::Matrix<double, kLower + 1, kLower + 1> q =
      p.topLeftCorner<kLower + 1, kLower + 1>() - p(kOne, kOne) * mean * mean.transpose();
  const Eigen::Matrix<double, kLower + 1, 1> scale = q.diagonal().cwiseSqrt().cwiseInverse();
  if (!scale.allFinite()) return std::nullopt;
  q = scale.asDiagonal() * q * scale.asDiagonal();
  const Square inverse = q.topLeftCorner<kKnown, kKnown>().inverse();
  if (!(inverse(kReading, kReading) < 1.0 / kOwnShare)) return std::nullopt;
  const Eigen::Matrix<double, kKnown, 1> shared = q.col(kLower).head<kKnown>(), x = inverse * shared;
  return Fit{x[kReading] * scale[kReading] / (x[kSlope] * scale[kSlope]), x.dot(shared)};
}

// Under one bell, its deviation by the jackknife.
std::optional<Corner> corner_under_bell(const Columns& columns) {
  const std::vector<Products> blocks = products_of_blocks(columns);
  Products all = Products::Zero();
  for (const Products& block : blocks) all += block;
  const std::optional<Fit> fit = fit_of(all);
  if (!fit || !(fit->explained > kSameMotion)) return std::nullopt;
  double square = 0.0;
  for (const Products& block : blocks) {
    const std::optional<Fit> without = fit_of(all - block);
    if (!without) return std::nullopt;
    square += std::pow(without->wc - fit->wc, 2) * static_cast<double>(kBlocks - 1) / static_cast<double>(kBlocks);
  }
  return Corner{fit->wc / kTwoPi, std::sqrt(square) / kTwoPi};
}

// A corner is the same for slow motion and fast; what a series misses of a filter is not.
bool agree(const Corner& corner, const Corner& wider) {
  return wider.corner_Hz > 3.0 * wider.std_Hz &&
         std::abs(wider.corner_Hz - corner.corner_Hz) < kAgrees * corner.corner_Hz + 3.0 * wider.std_Hz;
}

Finding finding_of(const Channel& channel, const Channel& beside, const Corner& corner,
                   const rig_file::RigModel* model) {
  const rig_file::ChannelEntry* const entry = model == nullptr ? nullptr : rig_file::entry_of(*model, channel.name);
  const double corner_Hz = corner.corner_Hz + (entry == nullptr ? 0.0 : entry->ac_coupling_Hz);
  const int digits = std::max(1, static_cast<int>(std::ceil(std::log10(corner_Hz / corner.std_Hz))));
  const std::string number = fmt::format("{:.{}g}", corner_Hz, std::min(digits, 4));
  return {
      "ac_coupling", Weight::kDoubt, channel.name,
      fmt::format("has passed a high-pass of {} Hz (+- {:.1g}), as of a piezo sensor or an AC input, as {} tells: it "
                  "makes a damper of it. ac_coupling_Hz = {} in the rig file's [[channel]] of that name undoes it",
                  number, 2.0 * corner.std_Hz, beside.name, number),
      corner_Hz};
}

}  // namespace

std::optional<Corner> corner_of(const Channel& lower, const Channel& acceleration, double sample_period_s) {
  std::optional<Corner> best, beyond;  // under the bell that knows it best, and one of twice its width
  bool was_best = false;
  for (Columns columns = narrowest(lower, acceleration, sample_period_s);
       columns[0].size() >= kBlocks * kFewestInBlock;) {
    const std::optional<Corner> corner = corner_under_bell(columns);
    if (was_best) beyond = corner;
    was_best = corner && (!best || corner->std_Hz < best->std_Hz);
    if (was_best) best = corner, beyond.reset();
    for (std::vector<double>& column : columns) column = twice_as_wide(column);
  }
  return best && beyond && agree(*best, *beyond) ? best : std::nullopt;
}

std::vector<Finding> find_ac_coupling(const Record& record, const rig_file::RigModel* model, double tone_Hz) {
  const double least_share = std::max(kTakes, 0.5 * kTwoPi * tone_Hz * record.sample_period_s);
  std::vector<Finding> findings;
  for (const Channel& channel : record.channels) {
    if (channel.quantity != Quantity::kAcceleration) continue;
    for (const Quantity quantity : {Quantity::kVelocity, Quantity::kDisplacement}) {
      const Channel* const lower = record.find(quantity, channel.dof);
      if (lower == nullptr) continue;
      const auto corner = corner_of(*lower, channel, record.sample_period_s);
      if (!corner || !(corner->corner_Hz > kDeviations * corner->std_Hz) ||
          share_taken(channel.values, corner->corner_Hz, record.sample_period_s) < least_share)
        continue;
      findings.push_back(finding_of(channel, *lower, *corner, model));
      break;
    }
  }
  return findings;
}

}  // namespace host_sim::data_check
