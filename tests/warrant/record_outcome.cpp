#include "record_outcome.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <stdexcept>

#include "core_run.hpp"
#include "hal/rig_file/channel_name.hpp"
#include "hal/rig_file/rig_file_error.hpp"
#include "hal/rig_file/scaled_double.hpp"

namespace warrant_test {
namespace {

using rig_file::to_double;

std::string node_text(int node) {
  if (node == firmware::kGroundNode) return "0";
  return node == firmware::kBaseNode ? "base" : std::to_string(node + 1);
}

std::string cause_text(firmware::Cause cause) {
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    if (static_cast<int>(cause) == row.can.number) return row.word.text;
  if (cause == firmware::Cause::kPolarity) return "polarity";
  return cause == firmware::Cause::kUnit ? "unit" : "unknown";
}

std::string place_text(const firmware::Finding& f, bool rotating) {
  if (f.quantity != firmware::kNoQuantity)
    return "channel " +
           rig_file::format_channel_name({static_cast<firmware::Quantity>(f.quantity), f.node_a + 1, rotating});
  if (f.node_b >= 0) return "link " + node_text(f.node_a) + "-" + node_text(f.node_b);
  return "dof " + node_text(f.node_a);
}

CoefficientOutcome judged(const firmware::ParameterEstimate& p, const hidden_rig::TrueCoefficient& truth) {
  CoefficientOutcome c;
  c.name = truth.name;
  c.truth = truth.value;
  c.value = to_double(p.value);
  c.std = to_double(p.std);
  c.status = p.status;
  const double off = std::abs(c.value - c.truth), low = to_double(p.ci95_low), high = to_double(p.ci95_high);
  c.wrong = off > 0.05 * std::abs(c.truth) && off > 4 * c.std;
  c.held = c.truth >= low && c.truth <= high;
  c.measurable = high - low < 2 * 0.05 * std::abs(c.truth);
  return c;
}

}  // namespace

bool RecordOutcome::bent() const {
  return std::any_of(coefficients.begin(), coefficients.end(), [](const auto& c) { return c.wrong; });
}
bool RecordOutcome::valid_and_wrong() const {
  return std::any_of(coefficients.begin(), coefficients.end(), [](const auto& c) { return c.wrong && c.valid(); });
}

RecordOutcome outcome_of(uint64_t seed, const hidden_rig::Settings& settings, uint16_t budget) {
  RecordOutcome outcome;
  outcome.seed = seed;
  hidden_rig::Draw draw;
  try {
    draw = hidden_rig::make_draw(seed, settings);
    if (!draw.hidden.empty()) {
      outcome.hidden = draw.hidden.front().effect;
      outcome.where = draw.hidden.front().where;
    }
    const CoreRun run = run_core(draw, budget);
    const firmware::Estimates& estimates = run.core->estimates();
    outcome.tested = estimates.warrant.tested;
    for (int k = 0; k < estimates.unknown_count; ++k) {
      const auto& p = estimates.parameters[k];
      outcome.suspect = outcome.suspect || p.status == firmware::EstimateStatus::kModelSuspect;
      outcome.coefficients.push_back(judged(p, draw.coefficients[static_cast<size_t>(k)]));
    }
    const firmware::Finding& named = estimates.warrant.named;
    if (named.cause != firmware::Cause::kNone) {
      outcome.named = cause_text(named.cause);
      outcome.is_cause = estimates.warrant.naming == firmware::Naming::kExplains;
      outcome.named_where = place_text(named, draw.true_rig.rotating);
    }
  } catch (const rig_file::RigFileError&) {
    outcome.refused = true;
  } catch (const std::runtime_error&) {
    outcome.refused = true;
  }
  return outcome;
}

std::string describe(const RecordOutcome& o) {
  char text[200];
  std::snprintf(text, sizeof text, "%llu %s %s%s%s%s %s %s %s\n", static_cast<unsigned long long>(o.seed),
                o.hidden.empty() ? "nothing" : o.hidden.c_str(), o.where.c_str(), o.bent() ? " BENT" : "",
                o.valid_and_wrong() ? " WRONG" : "", o.tested ? "" : " untested", o.is_cause ? "named" : "nearest",
                o.named.empty() ? "-" : o.named.c_str(), o.named_where.c_str());
  std::string all = text;
  for (const CoefficientOutcome& c : o.coefficients) {
    std::snprintf(text, sizeof text, "   %-16s truth %10.5g value %10.5g +- %8.3g z %7.2f status %d%s%s%s\n",
                  c.name.c_str(), c.truth, c.value, c.std, (c.value - c.truth) / c.std, static_cast<int>(c.status),
                  c.held ? "" : " missed", c.measurable ? " measurable" : "",
                  c.wrong ? (c.valid() ? " WRONG" : " wrong") : "");
    all += text;
  }
  return all;
}

}  // namespace warrant_test
