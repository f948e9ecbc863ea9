#include "clock.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../first_values/start.hpp"
#include "numbers_of.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kFewest = 2;         // of one spring nobody can say that all are
constexpr double kAlike = 0.03;       // of the factor: what masses and springs are known to
constexpr double kLeastShare = 0.02;  // less is a matter of their calibration

// What the recording makes of each known number of that kind over what the rig file says; empty where one is not named.
std::vector<double> factors_of(const Task& task, Kind known, Kind error, const Diagnosis& d) {
  std::vector<double> factors;
  for (const ModelTerm& t : rig_as_given(task.system, task.records)) {
    if (t.term.kind != known || !t.known || t.value == 0) continue;
    const Term wrong = known == Kind::kMass ? on_dof(error, t.term.dof) : on_link(error, t.term.link);
    const NamedPlace place = named_place(task, wrong);
    const auto cause = std::find_if(d.causes.begin(), d.causes.end(), [&](const Cause& c) {
      return c.effect == place.effect && c.where == place.where && !c.parameters.empty();
    });
    if (cause == d.causes.end()) return {};
    factors.push_back(1 + cause->parameters[0].value / t.value);
  }
  return factors;
}

// 0: they are not off by one factor.
double one_factor(const std::vector<double>& factors) {
  if (factors.size() < kFewest) return 0;
  const auto [least, most] = std::minmax_element(factors.begin(), factors.end());
  if (*least <= 0 || *most > (1 + kAlike) * *least) return 0;
  const double factor = std::sqrt(*least * *most);
  return std::abs(factor - 1) < kLeastShare ? 0 : factor;
}

// Ten or a thousand times: a decimal point, N/mm, grams, kilopond. No clock is off by the root of that.
bool slip(double factor) {
  const double decades = std::abs(std::log10(factor)), odd = 2 * std::floor(decades / 2) + 1;
  return std::abs(decades - odd) < kAlike;
}

}  // namespace

void say_clock(const Task& task, Diagnosis& d) {
  const double springs = one_factor(factors_of(task, Kind::kStiffness, Kind::kStiffnessError, d)),
               masses = one_factor(factors_of(task, Kind::kMass, Kind::kMassError, d));
  if ((springs == 0) == (masses == 0)) return;
  const double factor = springs + masses, times = std::sqrt(factor);
  if (slip(factor)) return;
  for (ModelScore* score : {&d.baseline, &d.extended})
    for (diagnosis::Parameter& p : score->parameters)
      if (p.name.find("viscous") != std::string::npos) p.may_be_bent = true;
  char text[320];
  std::snprintf(
      text, sizeof text,
      "all %s are %.4g times those of the rig file: or the times of the records are off by a factor of %.4g (their "
      "sampling rate), and every damper above is %.4g times what it is; look at the clock first",
      springs != 0 ? "springs" : "masses", factor, std::max(times, 1 / times), times);
  d.advice.push_back(text);
}

}  // namespace diagnosis::runs
