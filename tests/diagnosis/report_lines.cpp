#include "report_lines.hpp"

#include <algorithm>
#include <cmath>
#include <ctime>
#include <nlohmann/json.hpp>
#include <ostream>

#include "hal/rig_file/toml/effect_words.hpp"
#include "sensors.hpp"

namespace hidden {
namespace {

Settings setting(Hide hide, double noise, const std::string& sensors = "xva") {
  Settings s;
  s.hide = hide, s.noise = noise, s.sensors = sensors;
  return s;
}

// The rig file with the hidden effect in its place, coefficient to be estimated; false where a rig file cannot say it.
bool add_truth(const Draw& draw, rig_file::RigModel& rig) {
  const TrueEffect& e = draw.true_rig.effects[0];
  if (e.kind == "backlash" || e.kind == "presliding_hysteresis" || e.kind == "unmodelled_resonance") return false;
  if (e.kind == "mass_error") {
    rig.dofs[static_cast<size_t>(e.dof)].mass_kg.value += e.strength;
    return true;
  }
  const TrueLink& true_link = draw.true_rig.links[static_cast<size_t>(e.link)];
  for (rig_file::Link& link : rig.links) {
    if (link.a != true_link.a + 1 || link.b != true_link.b + 1) continue;
    if (e.kind == "stiffness_error")
      link.stiffness_N_m.value += e.strength;
    else if (e.kind == "missing_viscous")
      link.viscous_N_s_m = {0, true};
    else if (e.kind == "missing_coulomb")
      link.coulomb_N = {0, true};
    else {
      rig_file::Effect effect;
      effect.kind = e.kind, effect.coefficient = {0, true};
      const firmware::EffectRow* word = rig_file::find_effect_row(e.kind);
      if (!word) return false;
      if (const std::string key = rig_file::shape_key(*word, 0, false); !key.empty()) effect.shape[key] = e.shape;
      link.effects.push_back(effect);
    }
    return true;
  }
  return false;
}

double mean(const std::vector<double>& v) {
  double sum = 0;
  for (double x : v) sum += x;
  return sum / static_cast<double>(v.size());
}

// Gain on unseen data over what the true model gains there.
void compare_gain(const Draw& draw, const diagnosis::Diagnosis& answer, Tally& t) {
  rig_file::RigModel truth = draw.rig;
  if (!add_truth(draw, truth)) return;
  const diagnosis::Diagnosis best = diagnosis::diagnose(truth, {draw.record}, {});
  t.gain_shares.push_back(mean(best.baseline.holdout_nrmse_percent) / mean(answer.extended.holdout_nrmse_percent));
}

bool of_motion_channel(const diagnosis::DetectionLimit& l) {
  return l.where.rfind("channel ", 0) == 0 && l.where.rfind("channel force", 0) != 0;
}

// "sensor_gain of a motion sensor" is another quantity than that of the force.
std::string limit_name(const diagnosis::DetectionLimit& l) {
  return of_motion_channel(l) ? l.effect + " of motion" : l.effect;
}

// Percent of the damping force; of a motion channel: a delay in us, a gain in percent, a hum in percent of the channel's rms.
double percent_of(const host_sim::Record& record, const diagnosis::DetectionLimit& l) {
  if (!of_motion_channel(l)) return l.percent_of_damping_force;
  if (l.effect == "sensor_delay") return 1e6 * l.strength;
  if (l.effect == "sensor_gain") return 100 * l.strength;
  for (const host_sim::Channel& c : record.channels)
    if (l.where == "channel " + c.name) return 100 * l.strength / rms(c.values);
  return 0;
}

}  // namespace

std::vector<Line> report_lines(double share) {
  std::vector<Line> list;
  const auto add = [&](const std::string& title, const Settings& settings, int draws, double mark, bool sets = true) {
    list.push_back({title, settings, mark, sets, std::max(1, static_cast<int>(std::lround(share * draws)))});
  };
  for (double noise : {0.01, 0.05}) {
    const std::string at = noise < 0.02 ? ", 1 % noise" : ", 5 % noise";
    add("one effect" + at, setting(Hide::kOne, noise), 200, noise < 0.02 ? 98 : 97);
    add("nothing" + at, setting(Hide::kNothing, noise), 500, 99);
    add("two effects" + at, setting(Hide::kTwo, noise), 200, 95);
    add("outside the vocabulary" + at, setting(Hide::kOutside, noise), 100, 95);
    add("sensor fault" + at, setting(Hide::kSensorFault, noise), 100, 0);
  }
  for (const std::string sensors : {"x", "a", "xa", "va"}) {
    Settings one = setting(Hide::kOne, 0.01, sensors);
    one.rho_low = 0.1;
    const bool asked = sensors.size() == 1;
    add("one effect over 0.1, 1 % noise, sensors " + sensors, one, asked ? 200 : 40,
        sensors == "x"   ? 85
        : sensors == "a" ? 60
                         : 0);
    add("nothing, 1 % noise, sensors " + sensors, setting(Hide::kNothing, 0.01, sensors), asked ? 200 : 40,
        asked ? 98 : 0);
    if (asked) add("sensor fault, 1 % noise, sensors " + sensors, setting(Hide::kSensorFault, 0.01, sensors), 100, 0);
  }
  Settings coloured = setting(Hide::kNothing, 0.01), coarse = setting(Hide::kNothing, 0.001);
  coloured.noise_corner_Hz = 10, coarse.bits = 12;
  add("nothing, 1 % noise with a 10 Hz corner", coloured, 200, 98);
  add("nothing, 12 bit, 0.1 % noise", coarse, 200, 98);
  for (Drive drive : {Drive::kLinear, Drive::kSteps}) {
    Settings one = setting(Hide::kOne, 0.01), none = setting(Hide::kNothing, 0.01);
    one.drive = none.drive = drive;
    const std::string way =
        drive == Drive::kLinear ? ", force straight between samples" : ", force held between samples";
    add("one effect, 1 % noise" + way, one, 100, 0);
    add("nothing, 1 % noise" + way, none, 100, 0);
  }
  for (const std::string sensors : {"xva", "a"}) {
    add("nothing, no noise, sensors " + sensors, setting(Hide::kNothing, 0, sensors), 100, 0);
    add("nothing, 0.1 % noise, sensors " + sensors, setting(Hide::kNothing, 0.001, sensors), 100, 0);
  }
  for (double seconds : {20.0, 60.0}) {
    Settings s = setting(Hide::kOne, 0.01);
    s.dofs = 3, s.seconds = seconds;
    add("one effect, 3 masses, " + std::to_string(static_cast<int>(seconds)) + " s", s, 20, 0);
  }
  return list;
}

Tally run_line(const Line& line, uint64_t first_seed, std::ostream* list) {
  Tally t;
  for (int i = 0; i < line.draws; ++i) {
    const uint64_t seed = first_seed + static_cast<uint64_t>(i);
    const Draw draw = make_draw(seed, line.settings);
    const std::clock_t start = std::clock();
    const diagnosis::Diagnosis answer = diagnosis::diagnose(draw.rig, {draw.record}, {});
    const double spent = static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
    t.seconds += spent, t.slowest = std::max(t.slowest, spent);
    const Outcome outcome = judge(draw, answer);
    ++t.draws, t.exact += outcome == Outcome::kExact, t.set += outcome == Outcome::kSet;
    const std::string truth = draw.truth.empty() ? "nothing" : draw.truth[0].effect;
    const std::string said = outcome == Outcome::kExact ? "exact"
                             : outcome == Outcome::kSet ? "in a set"
                             : answer.causes.empty()    ? diagnosis::verdict_word(answer.verdict)
                                                        : answer.causes[0].effect;
    ++t.confusion[truth][said];
    if (!draw.truth.empty()) {
      auto& bin = t.power[static_cast<int>(draw.truth[0].rho * 10)];
      ++bin.second, bin.first += outcome != Outcome::kWrong;
    }
    if (answer.verdict == diagnosis::Verdict::kNone)
      for (const diagnosis::DetectionLimit& l : answer.minimum_detectable) {
        const double percent = percent_of(draw.record, l);
        if (percent > 0 && std::isfinite(percent)) t.limits[limit_name(l)].push_back(percent);
      }
    if (outcome == Outcome::kExact && line.settings.hide == Hide::kOne && line.settings.sensors == "xva" &&
        line.settings.drive == Drive::kSmooth && i % 4 == 0)
      compare_gain(draw, answer, t);
    if (outcome == Outcome::kExact) continue;
    const std::string text = (outcome == Outcome::kSet ? "set   " : "wrong ") + std::to_string(seed) +
                             ", n = " + std::to_string(draw.rig.dofs.size()) + ": " + told(draw, answer);
    t.misses.push_back(text);
    if (list) *list << text << "\n" << std::flush;
  }
  return t;
}

double quantile(std::vector<double> v, double share) {
  if (v.empty()) return 0;
  std::sort(v.begin(), v.end());
  return v[static_cast<size_t>(share * static_cast<double>(v.size() - 1))];
}

void write(std::ostream& out, const Tally& t) {
  out << nlohmann::json{
      {"draws", t.draws},     {"exact", t.exact},         {"set", t.set},     {"seconds", t.seconds},
      {"slowest", t.slowest}, {"confusion", t.confusion}, {"power", t.power}, {"gain_shares", t.gain_shares},
      {"limits", t.limits},   {"misses", t.misses}};
}

Tally read_tally(std::istream& in) {
  const nlohmann::json j = nlohmann::json::parse(in);
  Tally t;
  t.draws = j["draws"], t.exact = j["exact"], t.set = j["set"], t.seconds = j["seconds"], t.slowest = j["slowest"];
  j["confusion"].get_to(t.confusion), j["power"].get_to(t.power), j["gain_shares"].get_to(t.gain_shares);
  j["limits"].get_to(t.limits), j["misses"].get_to(t.misses);
  return t;
}

}  // namespace hidden
