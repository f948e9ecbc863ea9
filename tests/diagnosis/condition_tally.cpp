#include "condition_tally.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <ctime>
#include <ostream>
#include <stdexcept>

#include "tests/hidden_rig/dice.hpp"

namespace hidden_rig {
namespace {

constexpr size_t kLargestSet = 4;  // names, the first included: more tell a person nothing

bool same(const Hidden& h, const std::string& effect, const std::string& where) {
  return h.effect == effect && h.where == where;
}

std::vector<std::string> that_can_hide() {
  std::vector<std::string> words;
  for (const std::string& word : effects()) {
    static const char* const kOfData[] = {"dead", "clipped", "spikes", "polarity", "unit", "drift"};
    if (std::none_of(std::begin(kOfData), std::end(kOfData), [&](const char* w) { return word == w; }))
      words.push_back(word);
  }
  return words;
}

// Coefficients that the rig file leaves open: how many intervals hold the truth. Those that do not are told, with their error in
// standard deviations.
std::string count_intervals(const Draw& draw, const diagnosis::Diagnosis& d, Said& said) {
  std::string outside;
  char text[128];
  for (const TrueCoefficient& c : draw.coefficients)
    for (const diagnosis::Parameter& p : d.extended.parameters)
      if (p.name == c.name && p.std > 0) {
        const bool holds = std::abs(p.value - c.value) <= 1.96 * p.std;
        ++said.intervals, said.holding += holds;
        if (holds) continue;
        std::snprintf(text, sizeof text, "; outside: %s = %.6g for %.6g (%+.1f sd)", p.name.c_str(), p.value, c.value,
                      (p.value - c.value) / p.std);
        outside += text;
      }
  return outside;
}

std::string told(const Draw& draw, const diagnosis::Diagnosis& d) {
  char text[128];
  std::string line = "hidden:";
  for (const Hidden& h : draw.hidden) {
    std::snprintf(text, sizeof text, " %s on %s (rho %.3f)", h.effect.c_str(), h.where.c_str(), h.rho);
    line += text;
  }
  if (draw.hidden.empty()) line += " nothing";
  std::snprintf(text, sizeof text, "; %zu masses; answer: %s", draw.rig.dofs.size(),
                diagnosis::verdict_word(d.verdict));
  line += text;
  for (const diagnosis::Cause& c : d.causes) line += " " + c.effect + " on " + c.where;
  for (const diagnosis::NamedPlace& p : d.ambiguous_with) line += " | or " + p.effect + " on " + p.where;
  double worst = 0;
  for (double v : d.extended.holdout_nrmse_percent) worst = std::max(worst, v);
  std::snprintf(text, sizeof text, "; misfit %.3f to %.3f; free run misses %.3g %%", d.baseline_misfit,
                d.extended_misfit, worst);
  return line + text;
}

struct Row {
  int none = 0, none_right = 0, none_unknown = 0, hidden = 0, right = 0, set = 0, missed = 0, wrong = 0, refused = 0;
  int intervals = 0, holding = 0;
  std::vector<double> seconds;
  void add(const Said& s) {
    if (!s.hides) {
      ++none, none_right += s.outcome == Outcome::kRight, none_unknown += s.outcome == Outcome::kMissed;
    } else {
      ++hidden, right += s.outcome == Outcome::kRight, set += s.outcome == Outcome::kInSet;
      missed += s.outcome == Outcome::kMissed, wrong += s.outcome == Outcome::kWrong;
    }
    refused += s.outcome == Outcome::kRefused;
    intervals += s.intervals, holding += s.holding;
    seconds.push_back(s.seconds);
  }
};

void print(std::ostream& out, const std::string& name, Row row) {
  char text[256], held[32] = "-";
  if (row.intervals > 0) std::snprintf(held, sizeof held, "%.0f", 100.0 * row.holding / row.intervals);
  std::sort(row.seconds.begin(), row.seconds.end());
  std::snprintf(text, sizeof text, "| %s | %d of %d | %d | %d | %d | %d | %d | %d | %s | %.2f | %.1f |\n", name.c_str(),
                row.none_right, row.none, row.none_unknown, row.right, row.set, row.missed, row.wrong, row.refused,
                held, row.seconds.empty() ? 0 : row.seconds[row.seconds.size() / 2],
                row.seconds.empty() ? 0 : row.seconds.back());
  out << text;
}

void print_rows(std::ostream& out, const std::string& first, const std::vector<Said>& all,
                const std::string& (*key)(const Said&)) {
  out << "| " << first
      << " | nothing hidden: `none` | `unknown` | hidden: exact | in a set | missed | wrong | refused | intervals "
         "that hold, % | median s | longest s |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
  std::vector<std::string> order;
  std::map<std::string, Row> rows;
  for (const Said& s : all) {
    if (!rows.count(key(s))) order.push_back(key(s));
    rows[key(s)].add(s);
  }
  Row total;
  for (const std::string& name : order) print(out, "`" + name + "`", rows[name]);
  for (const Said& s : all) total.add(s);
  print(out, "all", total);
}

// Springs that are straight lines and dry friction do not know where their middle is: only a displacement shows a constant force, and
// not where nothing drives the rig: there it is the displacement's zero. And the one channel of a rig that nothing drives may be late,
// or have a gain: the motion is as good a one a little later, and all forces grow with it.
bool hides_from_sensors(const Draw& draw) {
  if (draw.hidden.empty()) return false;
  const std::vector<host_sim::Channel>& channels = draw.records[0].channels;
  const auto any = [&](auto is) { return std::any_of(channels.begin(), channels.end(), is); };
  const bool driven = any(
      [](const host_sim::Channel& c) { return c.quantity == host_sim::Quantity::kForce || c.dof == rig_file::kBase; });
  const bool shows_place = any([](const host_sim::Channel& c) {
    return c.quantity == host_sim::Quantity::kDisplacement && c.dof != rig_file::kBase;
  });
  const std::string& word = draw.hidden[0].effect;
  if (word == "sensor_delay" || word == "sensor_gain") return !driven && channels.size() == 1;
  return word == "force_offset" && !(driven && shows_place);
}

// Numbers that the rig file leaves open hold what is hidden in them; and where it gives no mass and no spring, all of them grow with a
// gain of the force, and the motion stays.
bool hides_in_open_numbers(const Draw& draw) {
  if (draw.hidden.empty()) return false;
  const std::string &word = draw.hidden[0].effect, &where = draw.hidden[0].where;
  bool any_given = false, open = false;
  for (size_t d = 0; d < draw.rig.dofs.size(); ++d) {
    const bool estimated = draw.rig.dofs[d].mass_kg.estimate;
    any_given = any_given || !estimated;
    open = open || (estimated && word == "mass_error" && where == "dof " + std::to_string(d + 1));
  }
  for (const rig_file::Link& l : draw.rig.links) {
    any_given = any_given || !l.stiffness_N_m.estimate;
    open =
        open || (l.stiffness_N_m.estimate && word == "stiffness_error" && where == "link " + rig_file::link_label(l));
  }
  return open || (!any_given && word == "sensor_gain" && where.rfind("channel force", 0) == 0);
}

}  // namespace

const char* outcome_word(Outcome outcome) {
  static const char* const kWords[] = {"right", "set", "missed", "WRONG", "refused"};
  return kWords[static_cast<size_t>(outcome)];
}

namespace {

// A damper that really changes from record to record may be said to drift, where or where not an effect is hidden besides.
bool warms(const Draw& draw, const diagnosis::Cause& c) {
  if (c.effect != "drifting_viscous" || c.where.rfind("link ", 0) != 0) return false;
  const std::string name = "viscous[" + c.where.substr(5) + "]";
  for (const TrueCoefficient& t : draw.coefficients)
    if (t.name == name)
      return std::any_of(t.of_record.begin(), t.of_record.end(),
                         [&](double v) { return std::abs(v - t.value) > 0.01 * std::abs(t.value); });
  return false;
}

// What holds its value between the samples holds it for every force: no wrong name where the draw's word is of another channel.
bool held_too(const Draw& draw, const diagnosis::Cause& c) {
  return c.effect == "force_hold" && !draw.drive.empty() && draw.drive[0].held &&
         std::none_of(draw.hidden.begin(), draw.hidden.end(), [&](const Hidden& h) { return h.where == c.where; });
}

}  // namespace

Outcome judge(const Draw& draw, diagnosis::Diagnosis d) {
  using diagnosis::Verdict;
  const size_t said = d.causes.size();
  d.causes.erase(
      std::remove_if(d.causes.begin(), d.causes.end(), [&](const diagnosis::Cause& c) { return held_too(draw, c); }),
      d.causes.end());
  const auto hidden_there = [&](const diagnosis::Cause& c) {
    return std::any_of(draw.hidden.begin(), draw.hidden.end(),
                       [&](const Hidden& h) { return same(h, c.effect, c.where); });
  };
  d.causes.erase(std::remove_if(d.causes.begin(), d.causes.end(),
                                [&](const diagnosis::Cause& c) { return warms(draw, c) && !hidden_there(c); }),
                 d.causes.end());
  if (draw.hidden.empty()) {
    if (!d.causes.empty()) return Outcome::kWrong;
    if (said > 0) return d.verdict == Verdict::kExplained ? Outcome::kRight : Outcome::kMissed;
    return d.verdict == Verdict::kNone ? Outcome::kRight : Outcome::kMissed;
  }
  size_t named = 0, listed = 0;
  for (const Hidden& h : draw.hidden) {
    const bool cause = std::any_of(d.causes.begin(), d.causes.end(),
                                   [&](const diagnosis::Cause& c) { return same(h, c.effect, c.where); });
    named += cause;
    listed += cause || std::any_of(d.ambiguous_with.begin(), d.ambiguous_with.end(),
                                   [&](const diagnosis::NamedPlace& p) { return same(h, p.effect, p.where); });
  }
  const size_t hidden = draw.hidden.size();
  if (d.causes.empty()) return Outcome::kMissed;
  if (listed < hidden || d.causes.size() > hidden) return Outcome::kWrong;
  if (d.ambiguous_with.empty()) return named == hidden ? Outcome::kRight : Outcome::kWrong;
  return d.ambiguous_with.size() + 1 <= kLargestSet ? Outcome::kInSet : Outcome::kMissed;
}

Said ask(const std::string& condition, const std::string& sensors, bool hides, uint64_t seed,
         const std::string& effect) {
  Said said;
  said.condition = condition, said.sensors = sensors, said.hides = hides, said.seed = seed;
  Settings settings;
  settings.condition = condition, settings.sensors = sensors;
  settings.rho_low = 0.1;  // rms of the hidden force over that of its link's damping
  Draw draw;
  // an effect that this condition cannot show at all (a dead band without a drive, a constant force without one displacement)
  // is drawn again
  Dice dice(seed ^ 0x5DEECE66DULL);
  const std::vector<std::string> words = that_can_hide();
  for (int attempt = 0;; ++attempt) {
    if (hides)
      settings.hidden =
          !effect.empty() ? effect : words[static_cast<size_t>(dice.below(static_cast<int>(words.size())))];
    try {
      draw = make_draw(seed, settings);
      if (effect.empty() && (hides_from_sensors(draw) || hides_in_open_numbers(draw))) continue;
      break;
    } catch (const std::runtime_error&) {
      if (attempt > 20) throw;
    }
  }
  const std::clock_t begin = std::clock();
  try {
    const diagnosis::Diagnosis answer = diagnosis::diagnose(draw.rig, draw.records, {});
    said.outcome = judge(draw, answer);
    said.text = told(draw, answer);
    if (said.outcome == Outcome::kRight) said.text += count_intervals(draw, answer, said);
  } catch (const std::exception& e) {
    said.outcome = Outcome::kRefused;
    said.text = std::string("refused: ") + e.what();
  }
  said.seconds = static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
  return said;
}

void write_table(std::ostream& out, const std::vector<Said>& all) {
  print_rows(out, "condition", all, [](const Said& s) -> const std::string& { return s.condition; });
  out << "\n";
  print_rows(out, "sensors", all, [](const Said& s) -> const std::string& { return s.sensors; });
}

}  // namespace hidden_rig
