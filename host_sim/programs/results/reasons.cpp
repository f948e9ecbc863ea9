#include "host_sim/programs/results/reasons.hpp"

#include <algorithm>

#include "hal/rig_file/coefficient_walk.hpp"
#include "host_sim/programs/shared/swing.hpp"

namespace host_sim {
namespace {

using firmware::EstimateStatus;

// Columns that differ well are hidden by noise, not by each other. A link that does not move makes every condition large.
constexpr double kWellConditioned = 10.0;

constexpr size_t kEnoughSwings = 20;  // docs/quickstart.md asks for as many cycles

// What no spring holds has no cycles to count, and nothing that raises its level where it rolls out.
std::string said_of_noise_unheld(const EstimateResult& result) {
  return std::string(
             "hidden by noise: the energies of these data scatter as much as they are; record several runs, each "
             "over all speeds from the highest down to rest, ") +
         (result.has_rates ? "" : "measure velocity or acceleration as well, ") +
         "or filter all channels alike and record slower (diagnose asks for less)";
}

std::string said_of_noise(const EstimateResult& result) {
  if (!result.held) return said_of_noise_unheld(result);
  std::string lacks;
  if (result.swings && *result.swings < kEnoughSwings) {
    const std::string count = *result.swings == 0   ? "not one swing"
                              : *result.swings == 1 ? "1 swing"
                                                    : std::to_string(*result.swings) + " swings";
    lacks = "the record is short (" + count +
            " of the slowest motion): record twenty cycles of the lowest frequency at least, ";
  }
  return "hidden by noise: the energies of these data scatter as much as they are; " + lacks + "raise the level, " +
         (result.has_rates ? "" : "measure velocity or acceleration as well, ") +
         "or filter all channels alike and record slower (diagnose asks for less)";
}

const Channel* motion_of(const Record& record, int dof) {
  for (const Quantity quantity : {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration})
    if (const Channel* channel = record.find(quantity, dof)) return channel;
  return nullptr;
}

}  // namespace

bool hidden_by_noise(EstimateStatus status, const EstimateResult& result) {
  return status == EstimateStatus::kIllConditioned &&
         (result.condition_number < kWellConditioned || !result.inseparable);
}

std::string reason(EstimateStatus status, const EstimateResult& result) {
  if (status == EstimateStatus::kIllConditioned && !result.force_known)
    return "no force is known: none is measured, and the rig file states no mass, spring or damper, so that nothing "
           "but the "
           "ratios of its coefficients shows in the motion; record the force, or state one of them";
  if (status == EstimateStatus::kIllConditioned && !result.hum_in.empty())
    return "hidden by the mains hum in " + result.hum_in + ": diagnose takes it out of the same data";
  if (hidden_by_noise(status, result) && suspects(result.warrant))
    return "lost in what the rig file lacks: that scatters in these energies more than the number itself; more of the "
           "same data will not help before the rig file has it";
  if (hidden_by_noise(status, result))
    return result.integrates
               ? "hidden by noise: a motion that is integrated from rates does not show what is slow, nor where "
                 "friction changes its direction; measure the displacement as well (diagnose asks for less)"
               : said_of_noise(result);
  switch (status) {
    case EstimateStatus::kStale:
      if (result.integrates)
        return "no window closed: a motion that is integrated from rates has to settle first; record fifty cycles of "
               "the lowest frequency and 2000 samples at least, in one piece, or measure the displacement as well "
               "(diagnose asks for less)";
      return "no window closed; record several cycles of the lowest frequency at least, in one piece (diagnose asks "
             "for less)";
    case EstimateStatus::kIllConditioned:
      if (!result.held)
        return "these data cannot separate it from the others; a record over a wider range of speeds can";
      return "these data cannot separate it from the others; a record at another level and another frequency, or of a "
             "random band, can";
    case EstimateStatus::kNoExcitation:
      return "what it acts on does not move, or noise hides everywhere which way its friction acts; raise the level, "
             "measure the velocity as well, or drive a DOF that moves it (diagnose asks for less)";
    case EstimateStatus::kSaturated:
      return "a sensor or a sum reached its full scale; lower the level or widen the range, then record again";
    default:
      return "";
  }
}

bool states_a_coefficient(const rig_file::RigModel& model) {
  bool any = false;
  rig_file::walk_coefficients(model, [&](const rig_file::CoefficientSite&, const rig_file::Coefficient& coefficient) {
    any = any || (!coefficient.estimate && coefficient.value != 0.0);
  });
  return any;
}

bool has_rates(const std::vector<Record>& records) {
  for (const Record& record : records)
    for (const Channel& channel : record.channels)
      if (channel.quantity == Quantity::kDisplacement && record.find(Quantity::kVelocity, channel.dof) == nullptr &&
          record.find(Quantity::kAcceleration, channel.dof) == nullptr)
        return false;
  return !records.empty();
}

std::optional<size_t> fewest_swings(const std::vector<Record>& records) {
  std::optional<size_t> fewest;
  if (records.empty()) return {};
  for (const Channel& first : records.front().channels) {
    if (first.dof < 1 || motion_of(records.front(), first.dof) != &first) continue;
    size_t swings = 0;
    for (const Record& record : records)
      if (const Channel* channel = record.find(first.quantity, first.dof)) swings += clear_swings(channel->values);
    fewest = fewest ? std::min(*fewest, swings) : swings;
  }
  return fewest;
}

}  // namespace host_sim
