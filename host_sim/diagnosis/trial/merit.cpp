#include "merit.hpp"

#include <algorithm>
#include <cmath>

#include "paired.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNoHarm = 1.01;  // of their squared residual, where they cannot show it
constexpr double kLeastSureShare =
    0.2;                            // of what is still to be explained, where seen and unseen windows are both sure
constexpr double kThird = 1.0 / 3;  // of the share that a cause has to take
constexpr double kNearlyAll = 0.9;  // of what is not noise
constexpr double kMuch = 0.5;       // of what the better one leaves beyond noise, for each number that it has more

// What each part of the unseen windows leaves less than beside the model alone, in variances of what that leaves.
std::vector<double> gained_unseen(const Fitted& before, const Fitted& now) {
  std::vector<double> list;
  const size_t blocks = std::min(before.block_ss.size(), now.block_ss.size());
  for (size_t from = 0; from < blocks; from += kFiner) {
    list.push_back(0);
    for (size_t b = from; b < std::min(blocks, from + kFiner); ++b)
      list.back() += (before.block_ss[b] - now.block_ss[b]).cwiseQuotient(before.mean_square).sum();
  }
  return list;
}

// As share_of(), on unseen windows: where they are quieter noise is more of what is left there.
double unseen_share_of(const Attempt& a, double noise) {
  return (1 - a.unseen) / std::max(1e-12, 1 - std::min(std::min(1.0, noise * a.quieter), a.unseen));
}

}  // namespace

// A cause of a deviations that is there or not changes the squared error by 2 a n - a^2 variances of what is left, n a normal deviate of
// what noise makes of it: x variances less need n >= (x + a^2) / 2a, at least sqrt(x), whatever a. Not counted is what one part
// alone gains most: a run beside friction that sticks falls from one valley of its error into another.
double deviations_unseen(const State& beside, const Attempt& a) {
  if (!a.state.unseen_fit.ok || !beside.unseen_fit.ok) return 0;
  const std::vector<double> gained = gained_unseen(beside.unseen_fit, a.state.unseen_fit);
  double sum = 0, most = 0;
  for (const double g : gained) sum += g, most = std::max(most, g);
  if (gained.size() > 1) sum -= most;
  return std::sqrt(std::max(0.0, sum / a.state.unseen_fit.memory));
}

double expected_unseen(const State& s, size_t added_from) {
  const std::vector<Parameter> p = parameters_of(s.model);
  double sum = 0, rows = 0;
  for (const Window& w : s.unseen) rows += static_cast<double>(w.length);
  rows *= static_cast<double>(s.unseen_fit.mean_square.size());
  for (const Mat& gram : s.unseen_fit.gram)
    for (size_t i = 0; i < p.size(); ++i) {
      if (p[i].shape) continue;
      const ModelTerm& t = s.model[p[i].term];
      const bool hosted = std::any_of(s.model.begin() + static_cast<std::ptrdiff_t>(added_from), s.model.end(),
                                      [&](const ModelTerm& m) { return m.host == static_cast<int>(p[i].term); });
      if (p[i].term >= added_from || hosted)
        sum += t.value * t.value * gram(static_cast<Index>(i), static_cast<Index>(i));
    }
  return rows > 0 ? sum / rows : 0;
}

double least_share(size_t causes) { return 1 - std::pow(1 - kShare, static_cast<double>(causes)); }

bool hopeless(double gain, size_t causes, double noise) {
  return gain < kThird * least_share(causes) * (1 - std::min(1.0, noise));
}

double share_of(const Attempt& a, double noise) {
  return (1 - a.error) / std::max(1e-12, 1 - std::min(noise, a.error));
}

double whole_error(const Attempt& a) {
  double seen = 0, unseen = 0;
  for (const Window& w : a.state.seen) seen += static_cast<double>(w.length);
  for (const Window& w : a.state.unseen) unseen += static_cast<double>(w.length);
  return (seen * a.error + unseen * a.unseen) / (seen + unseen);
}

bool unseen_agrees(const Attempt& a) { return a.unseen < (a.shows_unseen ? 1 : kNoHarm); }

bool moves_a_number(const State& beside, const Attempt& a) {
  const std::vector<Determined> before = determined(beside.fit, beside.model);
  const std::vector<Parameter> p = parameters_of(beside.model);
  for (size_t i = 0; i < p.size(); ++i)
    if (!p[i].shape &&
        std::abs(a.state.model[p[i].term].value - beside.model[p[i].term].value) > kByChance * before[i].std)
      return true;
  return false;
}

bool matters(const State& beside, const Attempt& a) {
  if (a.error < kPays || a.unseen < kPays) return true;
  if (!a.shows_unseen && a.z > kNamed) return true;
  return a.z > kSure && (deviations_unseen(beside, a) > kByChance || moves_a_number(beside, a));
}

bool may_be_nought(const State& with, size_t added_from) {
  const std::vector<Parameter> p = parameters_of(with.model);
  const std::vector<Determined> found = determined(with.fit, with.model);
  for (size_t i = 0; i < p.size() && i < found.size(); ++i)
    if (p[i].term >= added_from && !p[i].shape && std::abs(with.model[p[i].term].value) < kHalfOf95 * found[i].std)
      return true;
  return false;
}

bool passes(const Attempt& a, size_t already, double noise) {
  if (!a.state.fit.ok || a.rounds || a.no_sensors) return false;
  const double n = static_cast<double>(already + a.candidates.size()), least = least_share(a.candidates.size());
  // chance would have to pass twice; but what causes named before leave may be their laws' error, which unseen windows repeat
  const bool single = a.candidates.size() == 1;
  const bool borne_out = single && already == 0 && noise >= kMostlyNoise && a.unseen_deviations > kSure;
  if (!a.shows_unseen && !borne_out)  // then it has to explain nearly all by itself
    return unseen_agrees(a) && a.z > kNamed * std::sqrt(n) && share_of(a, noise) > std::max(least, 1 - kShare);
  // unseen windows are too quiet for what takes nearly all of the others (a decay's end): it is enough that they gain
  const bool too_quiet = already == 0 && a.expected_unseen < kShows && share_of(a, noise) > 1 - kShare;
  if (noise < kMostlyNoise && !too_quiet && unseen_share_of(a, noise) < least) return false;
  const bool again = too_quiet || unseen_share_of(a, noise) > 0.5 * share_of(a, noise);
  // of unseen windows no more is noise than what it leaves there
  const double unseen_noise = std::min(noise * std::max(1.0, a.quieter), std::max(noise, a.unseen));
  const bool plain = unseen_noise < kMostlyNoise && again;
  // beside something larger that nobody knows
  const bool surely = plain && single && already == 0 && a.z > kSure && a.unseen_deviations > kSure;
  // what is loud in the windows fitted may be another's: of the others it takes what a cause has to
  if (surely && (share_of(a, noise) > kLeastSureShare || unseen_share_of(a, noise) > least)) return true;
  // Something is missing, and two tests that know nothing of each other say what: 5 % twice is as rare as kSure once. Of pairs there
  // are many: one that leaves next to nothing of windows that it has not seen is none that chance picked.
  const bool whole = std::min(share_of(a, noise), unseen_share_of(a, noise)) > kNearlyAll;
  // one that leaves next to nothing of them did not have that from chance, however few of them do not resemble each other
  const bool twice = already == 0 && plain &&
                     (whole ? single || a.unseen_deviations > kByChance : single && a.unseen_deviations > kByChance);
  return a.z > (twice                ? kByChance
                : plain || borne_out ? kSure
                                     : kNamed * std::sqrt(n)) &&
         share_of(a, noise) > least && unseen_agrees(a);
}

bool nearly(const Attempt& a) {
  if (!a.state.fit.ok || a.rounds || a.no_sensors || a.candidates.size() != 1 || !(whole_error(a) < kPays))
    return false;
  const bool much =
      a.z > kByChance && a.error < 1 - kShare && a.unseen < 1 - kShare;  // of a record too short to be sure
  return much || (a.z > kSure && a.unseen < 1);
}

bool leaves_much_more(const Attempt& a, const Attempt& than, double noise) {
  const double numbers = std::max(1, than.complexity - a.complexity);
  return whole_error(a) > std::pow(1 + kMuch, numbers) * std::max(noise, whole_error(than));
}

bool clearly_better(const Attempt& a, const Attempt& b, double noise, double deviates) {
  const double left = whole_error(a) - std::min(noise, whole_error(a));
  const double much = std::pow(1 + kMuch, std::max(1, a.complexity - b.complexity)) - 1;
  return whole_error(b) - whole_error(a) > much * left && paired_z(all_blocks(b.state), all_blocks(a.state)) > deviates;
}

}  // namespace diagnosis::runs
