#include "zero_of_channel.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace diagnosis::runs {
namespace {

constexpr double kAgree = 0.02;  // of the offset: springs are known no better

struct Offset {
  double value = 0, std = 0;
};

const Cause* constant_force(const Diagnosis& d, const std::string& where) {
  for (const Cause& c : d.causes)
    if (c.effect == "force_offset" && c.where == where && !c.parameters.empty()) return &c;
  return nullptr;
}

std::string place_of_link(const rig_file::Link& link) { return "link " + rig_file::link_label(link); }

// What the DOF's reading would have to be off by for each of its springs; empty where one has no constant force.
std::vector<Offset> offsets_at(const System& system, int dof, const Diagnosis& d, std::vector<std::string>& places) {
  std::vector<Offset> list;
  for (size_t l = 0; l < system.known_links; ++l) {
    const rig_file::Link& link = system.links[l];
    const double turn = link.a == dof ? 1 : link.b == dof ? -1 : 0, k = link.stiffness_N_m.value;
    if (turn == 0 || (k == 0 && !link.stiffness_N_m.estimate)) continue;
    const Cause* const force = constant_force(d, place_of_link(link));
    if (!force || k == 0) return {};  // or a spring whose size is in question too
    places.push_back(force->where);
    list.push_back({-turn * force->parameters[0].value / k, force->parameters[0].std / std::abs(k)});
  }
  return list;
}

// Their mean where they agree.
std::optional<Offset> common(const std::vector<Offset>& list) {
  if (list.size() < 2) return {};
  Offset mean;
  double weight = 0;
  for (const Offset& o : list) {
    const double w = 1 / std::max(1e-300, o.std * o.std);
    mean.value += w * o.value, weight += w;
  }
  mean.value /= weight, mean.std = 1 / std::sqrt(weight);
  for (const Offset& o : list)
    if (std::abs(o.value - mean.value) > kSure * o.std + kAgree * std::abs(mean.value)) return {};
  return mean;
}

}  // namespace

void name_zeros(const Task& task, Diagnosis& d) {
  for (size_t dof = 1; dof <= task.system.dofs(); ++dof) {
    const MotionTrace* const reading = trace_of(task.records[0], static_cast<int>(dof) - 1, 0);
    std::vector<std::string> places;
    const std::vector<Offset> offsets = offsets_at(task.system, static_cast<int>(dof), d, places);
    const std::optional<Offset> zero = reading ? common(offsets) : std::nullopt;
    if (!zero) continue;
    const auto is_one = [&](const Cause& c) {
      return c.effect == "force_offset" && std::find(places.begin(), places.end(), c.where) != places.end();
    };
    Cause told = *std::find_if(d.causes.begin(), d.causes.end(), is_one);
    for (const Cause& c : d.causes)
      if (is_one(c)) told.significance = std::max(told.significance, c.significance);
    told.effect = "sensor_offset", told.where = "channel " + reading->channel, told.rivals.clear();
    const std::string unit = task.system.rig.dofs[dof - 1].rotating ? "rad" : "m";
    told.parameters = {{"sensor_offset[" + reading->channel + "]", zero->value, unit, zero->std, true}};
    d.causes.erase(std::remove_if(d.causes.begin(), d.causes.end(), is_one), d.causes.end());
    d.causes.push_back(told);
  }
}

}  // namespace diagnosis::runs
