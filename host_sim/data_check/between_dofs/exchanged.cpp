#include "host_sim/data_check/between_dofs/exchanged.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/data_check/one_motion/comparison.hpp"

namespace host_sim::data_check {
namespace {

// What a pair of channels disagrees about (1 - correlation^2) is the sum of what is wrong with each. So noise, gains and
// delays cannot make both crossed pairs agree better than both own pairs, whatever they are: the four sums are of the same
// four terms. A factor of 4 is far beyond the scatter of 30 spans and more.
constexpr double kFitsOther = 0.95, kBetterThanOwn = 4.0;
constexpr Quantity kMotion[] = {Quantity::kDisplacement, Quantity::kVelocity, Quantity::kAcceleration};

bool rotates(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return name && name->rotating;
}

// How the pairs of two quantities of DOFs i and j agree.
struct Crossing {
  bool known = false;    // both DOFs have both channels
  bool crossed = false;  // each fits the other DOF's and not its own
  double own = 0.0;      // correlation, the larger of both; where each fits the other's
};

Crossing crossing(const Record& record, Quantity lower, Quantity upper, int i, int j, Integrals& integrals) {
  const Channel *li = record.find(lower, i), *lj = record.find(lower, j);
  const Channel *ui = record.find(upper, i), *uj = record.find(upper, j);
  Crossing result;
  if (li == nullptr || lj == nullptr || ui == nullptr || uj == nullptr || rotates(*li) != rotates(*lj)) return result;
  result.known = true;
  const auto agree = [&](const Channel* one, const Channel* other) {
    return agreement(*one, *other, record.sample_period_s, integrals);
  };
  // Motions of two DOFs seldom agree, and then nothing else needs to be looked at.
  double crossed = agree(li, uj);
  if (!(crossed > kFitsOther)) return result;
  crossed = std::min(crossed, agree(lj, ui));
  if (!(crossed > kFitsOther)) return result;
  result.own = std::max(agree(li, ui), agree(lj, uj));
  result.crossed = 1.0 - result.own * result.own > kBetterThanOwn * (1.0 - crossed * crossed);
  return result;
}

Finding exchanged(const Record& record, Quantity quantity, const Quantity* or_else, int i, int j, double own) {
  const std::string first = record.find(quantity, i)->name, second = record.find(quantity, j)->name;
  std::string text = fmt::format(": each fits the motion of the other DOF, not its own (correlation {:.2f})", own);
  Finding finding{"exchanged", Weight::kFault, first, "is exchanged with " + second + text, own};
  if (or_else != nullptr)
    finding.detail += ", or " + record.find(*or_else, i)->name + " is with " + record.find(*or_else, j)->name;
  finding.detail += "; exchange the cables or the columns";
  return finding;
}

}  // namespace

std::vector<Finding> check_exchanged(const Record& record, Integrals& integrals) {
  std::set<int> dofs;
  for (const Channel& channel : record.channels)
    if (channel.quantity != Quantity::kForce) dofs.insert(channel.dof);
  std::vector<Finding> findings;
  for (auto i = dofs.begin(); i != dofs.end(); ++i)
    for (auto j = std::next(i); j != dofs.end(); ++j) {
      Crossing pair[3];  // without displacement, without velocity, without acceleration
      for (int q = 0; q < 3; ++q)
        pair[q] = crossing(record, kMotion[q == 0 ? 1 : 0], kMotion[q == 2 ? 1 : 2], *i, *j, integrals);
      for (int q = 0; q < 3; ++q) {
        const Crossing &a = pair[(q + 1) % 3], &b = pair[(q + 2) % 3];  // both hold the quantity q
        if (a.known && b.known && a.crossed && b.crossed)
          findings.push_back(exchanged(record, kMotion[q], nullptr, *i, *j, std::max(a.own, b.own)));
        else if (pair[q].crossed && !a.known && !b.known)  // of two quantities the upper one is named first
          findings.push_back(exchanged(record, kMotion[q == 2 ? 1 : 2], &kMotion[q == 0 ? 1 : 0], *i, *j, pair[q].own));
      }
    }
  return findings;
}

}  // namespace host_sim::data_check
