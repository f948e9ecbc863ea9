#include "host_sim/programs/shared/rest_position.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "host_sim/programs/shared/any_force.hpp"
#include "host_sim/programs/shared/swing.hpp"
#include "host_sim/programs/shared/weighs.hpp"

namespace host_sim {
namespace {

constexpr double kOneSide = 2.0;  // rms about the mean: a sine whose mean is 1.4 of it just touches zero
constexpr double kOff = 0.02;     // of the rms: three periods of a decay tell where it rests to 0.3 % of its amplitude

constexpr double kSure = 2.0;  // times what parts of a decay say otherwise

struct Moments {
  double mean = 0, rms = 0, unsure = 0;
};

Moments moments(const std::vector<Record>& records, size_t channel) {
  double sum = 0, squares = 0, count = 0;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) sum += value, count += 1;
  if (count == 0) return {};
  const double mean = sum / count;
  for (const Record& record : records)
    for (double value : record.channels[channel].values) squares += (value - mean) * (value - mean);
  return {mean, std::sqrt(squares / count)};
}

// Gravity pulls to where the angle is zero, whatever the mean: a driven arm need not swing about there. Left alone it comes to rest.
bool is_held_off(const rig_file::RigModel& model, const std::vector<Record>& records, int dof) {
  return any_force(records) && std::any_of(model.links.begin(), model.links.end(),
                                           [&](const rig_file::Link& link) { return weighs(link) && link.a == dof; });
}

// Of one decay. One of a few swings has no centre that could be told: where it stays at its end is its rest then.
Moments rest_of(const std::vector<double>& y) {
  Swing swing;
  swing.add(y);
  const double unsure = kSure * strays_by(y);
  if (!(unsure > kOff * swing.rms())) return {swing.mean(), swing.rms()};
  if (const std::optional<double> end = stays_at(y)) return {*end, swing.rms()};
  return {swing.mean(), swing.rms(), unsure};
}

Moments about_rest(const std::vector<Record>& records, size_t channel) {
  Swing swing;
  Moments plain;  // of decays as they are, each with the same weight
  bool told = true;
  for (const Record& record : records) {
    const std::vector<double>& y = record.channels[channel].values;
    const Moments own = rest_of(y);
    Swing alone;
    alone.add(y), swing.add(y);
    told = told && own.unsure == 0 && own.mean == alone.mean();
    plain.mean += own.mean / static_cast<double>(records.size()), plain.unsure = std::max(plain.unsure, own.unsure);
  }
  if (told) return {swing.mean(), swing.rms()};
  return {plain.mean, swing.rms(), plain.unsure};
}

bool has(const rig_file::RigModel& model, std::string_view effect) {
  for (const rig_file::Link& link : model.links)
    for (const rig_file::Effect& e : link.effects)
      if (e.kind == effect) return true;
  return false;
}

// Laws that pull to one side of themselves, or a base that moves: what the motion swings about is then no place of rest.
bool swings_about_rest(const rig_file::RigModel& model, const std::vector<Record>& records) {
  for (const Channel& channel : records.front().channels)
    if (channel.dof == rig_file::kBase) return false;
  return !any_force(records) && !has(model, "force_offset") && !has(model, "asymmetric_viscous");
}

// What a free rig's motion has for a centre. Beside a spring that is stiffer on one side it moves with the square of the amplitude, and
// the place of rest is where that would be nought; nothing where the amplitude does not tell.
std::optional<Moments> centre(const rig_file::RigModel& model, const std::vector<Record>& records, size_t channel) {
  const Moments all = about_rest(records, channel);
  if (!has(model, "quadratic_stiffness")) return all;
  std::vector<const std::vector<double>*> values;
  for (const Record& record : records) values.push_back(&record.channels[channel].values);
  const std::optional<double> rest = centre_of_small_swings(values);
  if (!rest) return {};
  return Moments{*rest, all.rms};
}

// Where each record of a free rig rests, where they do not rest alike: a zero that was set anew, a string that was hung up again. Empty
// where they do.
std::vector<double> own_rests(const std::vector<Record>& records, size_t channel) {
  if (records.size() == 1) return {};
  std::vector<double> rests;
  double largest = 0, unsure = 0;
  for (const Record& record : records) {
    const Moments own = rest_of(record.channels[channel].values);
    rests.push_back(own.mean), largest = std::max(largest, own.rms), unsure = std::max(unsure, own.unsure);
  }
  const auto [least, most] = std::minmax_element(rests.begin(), rests.end());
  return *most - *least > std::max(kOff * largest, unsure) ? rests : std::vector<double>{};
}

std::string said_of_rests(const std::string& name, const std::vector<double>& rests) {
  std::vector<std::string> places;
  for (double rest : rests) places.push_back(fmt::format("{:.4g}", rest));
  return fmt::format("{} swings about {}, record by record: each counted from its own, as the position of rest", name,
                     fmt::join(places, ", "));
}

}  // namespace

CountedFromRest count_from_rest(CentreOf of, const rig_file::RigModel& model, SharedRecords& records) {
  CountedFromRest rest;
  if (records.get().empty()) return rest;
  const bool alone = swings_about_rest(model, records.get()), uneven = has(model, "quadratic_stiffness");
  for (size_t c = 0; c < records.get().front().channels.size(); ++c) {
    if (records.get().front().channels[c].quantity != Quantity::kDisplacement) continue;
    if (is_held_off(model, records.get(), records.get().front().channels[c].dof)) continue;
    const std::string& name = records.get().front().channels[c].name;
    const Moments all = moments(records.get(), c);
    const bool one_side = std::fabs(all.mean) > kOneSide * all.rms;
    if (!one_side && !(alone && of == CentreOf::kFreeSwings)) continue;
    const std::vector<double> rests = alone && !uneven ? own_rests(records.get(), c) : std::vector<double>{};
    for (size_t r = 0; r < rests.size(); ++r)
      for (double& value : records.own()[r].channels[c].values) value -= rests[r];
    if (!rests.empty()) {
      rest.swinging.push_back(c);
      rest.notes.push_back(said_of_rests(name, rests));
      continue;
    }
    const std::optional<Moments> own = alone ? centre(model, records.get(), c) : std::nullopt;
    const Moments swing = own.value_or(all);
    if (!one_side && !(own && std::fabs(swing.mean) > std::max(kOff * swing.rms, swing.unsure))) continue;
    for (Record& record : records.own())
      for (double& value : record.channels[c].values) value -= swing.mean;
    (own ? rest.swinging : rest.held_off).push_back(c);
    rest.notes.push_back(
        one_side
            ? fmt::format("{} never comes to its zero: counted from its mean, {:.4g}, as the position of rest", name,
                          swing.mean)
            : fmt::format("{} swings about {:.4g}: counted from there, as the position of rest", name, swing.mean));
  }
  return rest;
}

}  // namespace host_sim
