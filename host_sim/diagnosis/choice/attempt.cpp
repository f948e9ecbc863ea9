#include "attempt.hpp"

#include <algorithm>
#include <cmath>

#include "shown.hpp"

namespace diagnosis::runs {
namespace {

// Where most of the residual is not noise the share of it and unseen data decide: chance is no rival, kSure is enough.
constexpr double kEnoughRows = 3000;  // samples of a part: some 60 periods
constexpr double kShows = 0.02;       // of unseen windows' squared residual: less is lost in its scatter
constexpr double kNoHarm = 1.01;      // of their squared residual, where they cannot show it
constexpr double kSmallStart = 0.3;   // of the value that the linearisation gives
constexpr double kPromised = 0.8;     // of the linearisation's gain, that a fit should reach
constexpr double kLeastSureShare =
    0.2;                            // of what is still to be explained, where seen and unseen windows are both sure
constexpr double kMostGain = 0.2;   // error of a calibration
constexpr double kThird = 1.0 / 3;  // of the share that a cause has to take
constexpr int kFirstSteps = 3;      // with shapes held
constexpr double kAsFound = 1.3;    // of the error over a part of the windows, that over all of them may be

double least_z(const Attempt& a, size_t added_from) {
  const std::vector<Determined> d = determined(a.state.fit, a.state.model);
  const std::vector<Parameter> p = parameters_of(a.state.model);
  double least = 1e300;
  for (size_t i = 0; i < p.size(); ++i)
    if (p[i].term >= added_from && !p[i].shape) least = std::min(least, std::abs(d[i].z));
  return least;
}

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

// Noise's share of what a model leaves of unseen windows over that of seen ones: channel by channel, as one may be noise alone while
// another shows what is missing. Where the noise is not known: as of one channel.
double quieter_of(const State& beside) {
  if (!beside.unseen_fit.ok) return 1;
  if (beside.noise.size() == 0) return error_over(beside.fit, beside.unseen_fit);
  const auto share = [&](const Fitted& f) { return beside.noise.cwiseQuotient(f.mean_square).cwiseMin(1.0).mean(); };
  return share(beside.unseen_fit) / std::max(1e-12, share(beside.fit));
}

// As share_of(), on unseen windows: where they are quieter noise is more of what is left there.
double unseen_share_of(const Attempt& a, double noise) {
  return (1 - a.unseen) / std::max(1e-12, 1 - std::min(std::min(1.0, noise * a.quieter), a.unseen));
}

constexpr double kNearlyAll = 0.9;  // of what is not noise
constexpr double kMuch = 0.5;       // of what the better one leaves beyond noise, for each number that it has more

// Seen and unseen blocks together.
Fitted all_blocks(const State& s) {
  Fitted f = s.fit;
  f.block_ss.insert(f.block_ss.end(), s.unseen_fit.block_ss.begin(), s.unseen_fit.block_ss.end());
  return f;
}

}  // namespace

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

void settle(const Task& task, State& s, int steps) {
  s.fit = fit(task.system, task.records, s.model, s.seen, steps);
  if (!s.fit.ok) return;
  Model frozen = s.model;
  s.unseen_fit = fit(task.system, task.records, frozen, s.unseen, steps, true);
}

// Windows start from the measured motion again.
void forget_states(State& s) {
  for (std::vector<Window>* windows : {&s.seen, &s.unseen})
    for (Window& w : *windows) w.state.resize(0);
}

State part_of(const Task& task, const State& whole, double noise) {
  double rows = 0;
  for (const Window& w : whole.seen) rows += static_cast<double>(w.length);
  const size_t shortest = std::min(whole.seen.size(), 2 * whole.unseen.size());
  const size_t every = std::min(static_cast<size_t>(rows / kEnoughRows), shortest / (2 * kEnoughWindows));
  if (noise > kMostlyNoise || every < 2) return whole;
  State part;
  part.model = whole.model, part.noise = whole.noise;
  for (size_t i = 0; i < whole.seen.size(); i += every) part.seen.push_back(whole.seen[i]);
  for (size_t i = 0; i < whole.unseen.size(); i += every) part.unseen.push_back(whole.unseen[i]);
  settle(task, part, kTrialSteps);
  return part.fit.ok && part.unseen_fit.ok ? part : whole;
}

State on_all(const Task& task, const State& whole, const State& found) {
  State s = whole;
  s.model = found.model;
  if (found.seen.size() == whole.seen.size() && found.unseen.size() == whole.unseen.size())
    s.seen = found.seen, s.unseen = found.unseen;
  settle(task, s, kBaseSteps);
  if (s.fit.ok && motion_error(task, s) < kAsFound * motion_error(task, found)) return s;
  State measured = whole;
  measured.model = found.model;
  forget_states(measured);
  approach(task.system, task.records, measured.model, measured.seen, kBaseSteps,
           true);  // states first: one that is far off holds all back
  settle(task, measured, kBaseSteps);
  return measured.fit.ok && (!s.fit.ok || error_over(measured.fit, s.fit) < 1) ? measured : s;
}

namespace {

// Mean over blocks of what `of(before, after)` makes of their square sums, as a normal deviate.
template <typename Of>
double deviate_over_blocks(const Fitted& before, const Fitted& after, Of of) {
  const size_t n = std::min(before.block_ss.size(), after.block_ss.size()) / kFiner;
  if (n < 2) return 0;
  double sum = 0, square = 0;
  for (size_t w = 0; w < n; ++w) {
    Vec old = Vec::Zero(before.mean_square.size()), now = old;
    for (size_t b = kFiner * w; b < kFiner * (w + 1); ++b) old += before.block_ss[b], now += after.block_ss[b];
    const double d = of(old.cwiseQuotient(before.mean_square).sum(), now.cwiseQuotient(before.mean_square).sum());
    sum += d, square += d * d;
  }
  const double mean = sum / static_cast<double>(n);
  const double variance = (square / static_cast<double>(n) - mean * mean) / (static_cast<double>(n) - 1);
  return normal_deviate(mean / std::sqrt(variance + 1e-300), static_cast<double>(n) - 1);
}

}  // namespace

double paired_z(const Fitted& before, const Fitted& after) {
  return deviate_over_blocks(before, after, [](double old, double now) { return old - now; });
}

double paired_share_z(const Fitted& before, const Fitted& after) {
  return deviate_over_blocks(before, after,
                             [](double old, double now) { return std::log((old + 1e-300) / (now + 1e-300)); });
}

namespace {

// The only channel of a rig that nothing drives tells its own gain by the bend of a law alone. More than a calibration may be
// off is that law, not the gain.
bool is_no_calibration(const Task& task, const ModelTerm& t) {
  const Prepared& p = task.records[0];
  return t.term.kind == Kind::kChannelGain && std::abs(t.value) > kMostGain && p.traces.size() == 1 &&
         !forced(task.records) && !p.guess.back().given;
}

// What a settled attempt brings, and whether chance could bring it.
void judge(const Task& task, const State& beside, bool hosted, Attempt& a) {
  a.error = error_over(a.state.fit, beside.fit), a.unseen = error_over(a.state.unseen_fit, beside.unseen_fit);
  a.quieter = quieter_of(beside);
  for (size_t i = beside.model.size(); i < a.state.model.size(); ++i) {
    if (is_no_calibration(task, a.state.model[i])) a.state.fit.ok = false;
    if (shown(task, a.state.model[i])) continue;
    if (a.state.model[i].term.kind == Kind::kPresliding)
      a.rounds = true;
    else
      a.state.fit.ok = false;
  }
  if (!a.state.fit.ok || a.rounds) return;
  a.z = std::min(1e300, least_z(a, beside.model.size()));
  a.unseen_deviations = a.candidates.size() <= 2 ? deviations_unseen(beside, a) : 0;
  a.expected_unseen = expected_unseen(a.state, beside.model.size());
  a.shows_unseen = !a.state.unseen_fit.ok || 1 - a.unseen > kShows || a.expected_unseen > kShows;
  // what acts in another's place has no coefficient of its own: what it brings, block by block
  // (of a sweep two or three are by far the loudest: as a share of their own)
  if (hosted) a.z = std::min(a.z, std::max(paired_z(beside.fit, a.state.fit), paired_share_z(beside.fit, a.state.fit)));
}

}  // namespace

Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& candidates,
                const std::vector<std::vector<double>>& values, int steps, From from) {
  Attempt a;
  a.candidates = candidates;
  a.state.model = beside.model, a.state.seen = beside.seen, a.state.unseen = beside.unseen;
  if (from == From::kMeasured) forget_states(a.state);
  bool hosted = false;
  for (size_t i = 0; i < candidates.size(); ++i) {
    a.state.model = joined(a.state.model, candidates[i], values[i]);
    a.complexity += candidates[i].complexity, hosted = hosted || candidates[i].host >= 0;
  }
  if (from == From::kMeasured) approach(task.system, task.records, a.state.model, a.state.seen, steps, true);
  // shapes wait until their coefficients have a size
  const Model shapes = a.state.model;
  bool any_free = false;
  for (ModelTerm& m : a.state.model)
    if (m.added) any_free = any_free || m.shape_free || m.shape2_free, m.shape_free = m.shape2_free = false;
  if (any_free) approach(task.system, task.records, a.state.model, a.state.seen, kFirstSteps);
  for (size_t i = 0; i < shapes.size(); ++i)
    a.state.model[i].shape_free = shapes[i].shape_free, a.state.model[i].shape2_free = shapes[i].shape2_free;
  settle(task, a.state, steps);
  judge(task, beside, hosted, a);
  return a;
}

namespace {

Attempt undamped(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                 double noise) {
  const Candidate& c = all[one.candidate];
  // From a coefficient of nought the first step brings all numbers into balance; what has states of its own starts
  // small.
  std::vector<double> start(c.terms.size(), 0.0);
  if (c.terms[0].kind == Kind::kResonance) start[0] = kSmallStart * one.value[0];
  if (c.terms[0].kind == Kind::kCogging) start = one.value;  // its phase too
  Attempt a = attempt(task, beside, {c}, {start}, kTrialSteps);
  if (1 - a.error >= kPromised * one.gain || hopeless(one.gain, 1, noise)) return a;
  // Stuck on the way: from where the linearisation points, and from the measured motion.
  const auto try_again = [&](const Candidate& other, const std::vector<double>& value) {
    Attempt again = attempt(task, beside, {other}, {value}, kTrialSteps, From::kMeasured);
    const bool usable = a.state.fit.ok && !a.rounds;
    if (again.state.fit.ok && (!usable || whole_error(again) < whole_error(a))) a = std::move(again);
  };
  if (c.host < 0) {
    try_again(c, one.value);
    return a;
  }
  for (const Candidate& o : all)  // what acts in another's place has its full size at once: not every shape leads home
    if (o.same_place(c)) try_again(o, start);
  return a;
}

// Bristles that were fitted, with a damping of their own (LuGre) that starts where it takes as long as they take to bend. One
// question is asked: does it leave less than chance would? Beside its rivals it is the same cause: none is simpler for that.
Attempt damped(const Task& task, const State& beside, Attempt bristles) {
  Candidate c = bristles.candidates[0];
  keep_shape(bristles.state.model, c);
  Term& t = c.terms[0];
  t.shape2 = t.shape / rate_of(task.system, task.records, t.link);
  const Attempt a = attempt(task, beside, {c}, {{bristles.state.model.back().value}}, 2 * kTrialSteps);
  if (!a.state.fit.ok || a.rounds || whole_error(a) >= whole_error(bristles)) return bristles;
  return paired_z(all_blocks(bristles.state), all_blocks(a.state)) > kSure ? a : bristles;
}

}  // namespace

Attempt attempt(const Task& task, const State& beside, const std::vector<Candidate>& all, const Screened& one,
                double noise) {
  const Attempt a = undamped(task, beside, all, one, noise);
  return is_bristles(a) ? damped(task, beside, a) : a;
}

bool is_bristles(const Attempt& a) {
  return a.candidates.size() == 1 && a.candidates[0].terms[0].kind == Kind::kPresliding && a.state.fit.ok && !a.rounds;
}

State rounded(const Task& task, const State& beside, const std::vector<Attempt>& tried) {
  std::vector<Candidate> list;
  std::vector<std::vector<double>> start;
  for (const Attempt& a : tried)
    if (a.rounds && a.state.fit.ok && a.candidates.size() == 1 && paired_z(beside.fit, a.state.fit) > kNamed) {
      list.push_back(a.candidates[0]), start.push_back({0.0});
      keep_shape(a.state.model, list.back());
    }
  return list.empty() ? State{} : attempt(task, beside, list, start, kTrialSteps).state;
}

Attempt without_bristles(const Task& task, const State& beside, const Attempt& bristles) {
  Attempt a;
  a.state = bristles.state;
  Model& model = a.state.model;
  const auto term = std::find_if(model.begin(), model.end(), [&](const ModelTerm& t) {
    return t.added && t.term.same_place(bristles.candidates[0].terms[0]);
  });
  if (term == model.end()) return Attempt();
  if (term->host >= 0) {
    const auto at = static_cast<int>(term - model.begin());
    model.erase(term);  // the rig's own friction, as it was fitted with them
    for (ModelTerm& t : model) t.host -= t.host > at;
  } else {
    Candidate dry = bristles.candidates[0];
    dry.terms = {on_link(Kind::kMissingCoulomb, term->term.link)}, dry.complexity = 0;
    term->term = dry.terms[0], term->shape_free = term->shape2_free = false;
    a.candidates = {dry};
  }
  for (std::vector<Window>* windows : {&a.state.seen, &a.state.unseen})
    for (Window& w : *windows)  // the bristles' state lies between those of the motion and the channels' zeros
      w.state.resize(0);
  approach(task.system, task.records, a.state.model, a.state.seen, kTrialSteps, true);
  settle(task, a.state, kTrialSteps);
  judge(task, beside, false, a);
  return a;
}

void keep_shape(const Model& fitted, Candidate& c) {
  for (const ModelTerm& t : fitted)
    if (t.added && t.term.same_place(c.terms[0])) c.terms = {t.term};
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
    if (p[i].term >= added_from && !p[i].shape && std::abs(with.model[p[i].term].value) < 1.96 * found[i].std)
      return true;
  return false;
}

bool passes(const Attempt& a, size_t already, double noise) {
  if (!a.state.fit.ok || a.rounds) return false;
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
  if (surely && share_of(a, noise) > kLeastSureShare) return true;
  // Something is missing, and two tests that know nothing of each other say what: 5 % twice is as rare as kSure once. Of pairs there
  // are many: one that leaves next to nothing of windows that it has not seen is none that chance picked.
  const bool whole = std::min(share_of(a, noise), unseen_share_of(a, noise)) > kNearlyAll;
  const bool twice = already == 0 && plain && a.unseen_deviations > kByChance && (single || whole);
  return a.z > (twice                ? kByChance
                : plain || borne_out ? kSure
                                     : kNamed * std::sqrt(n)) &&
         share_of(a, noise) > least && unseen_agrees(a);
}

bool nearly(const Attempt& a) {
  if (!a.state.fit.ok || a.rounds || a.candidates.size() != 1 || !(whole_error(a) < kPays)) return false;
  const bool much =
      a.z > kByChance && a.error < 1 - kShare && a.unseen < 1 - kShare;  // of a record too short to be sure
  return much || (a.z > kSure && a.unseen < 1);
}

bool leaves_much_more(const Attempt& a, const Attempt& than, double noise) {
  const double numbers = std::max(1, than.complexity - a.complexity);
  return whole_error(a) > std::pow(1 + kMuch, numbers) * std::max(noise, whole_error(than));
}

bool clearly_better(const Attempt& a, const Attempt& b, double noise) {
  const double left = whole_error(a) - std::min(noise, whole_error(a));
  const double much = std::pow(1 + kMuch, std::max(1, a.complexity - b.complexity)) - 1;
  return whole_error(b) - whole_error(a) > much * left &&
         paired_z(all_blocks(b.state), all_blocks(a.state)) > kByChance;
}

}  // namespace diagnosis::runs
