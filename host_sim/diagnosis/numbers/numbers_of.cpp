#include "numbers_of.hpp"

#include <algorithm>
#include <cmath>

#include "lasting_error.hpp"

namespace diagnosis::runs {
namespace {

constexpr double kNoNumber = 1e3;  // times what was fitted: of what only a sum is known

// A shape is fitted in its logarithm, but for a phase.
void take_std(const Parameter& parameter, const Determined& found, ActiveTerm& to) {
  const Term& t = to.term;
  if (parameter.shape == 0)
    to.std = found.std, to.alike = found.alike;
  else if (parameter.shape == 1)
    to.shape_std = found.std * t.shape;
  else
    to.shape2_std = t.kind == Kind::kCogging ? found.std : found.std * t.shape2;
}

// The first that is measured of displacement, velocity and acceleration.
std::string base_channel(const Task& task) {
  constexpr const char* kNames[] = {"displacement_base_m", "velocity_base_m_s", "acceleration_base_m_s2"};
  const auto& reading = task.records[0].base.reading;
  size_t quantity = 0;
  while (quantity < 2 && reading[quantity].size() == 0) ++quantity;
  return kNames[quantity];
}

}  // namespace

std::vector<ActiveTerm> fitted_terms(const Model& model, const std::vector<Determined>& found) {
  std::vector<ActiveTerm> list;
  for (const ModelTerm& t : model) {
    ActiveTerm a;
    a.term = t.term, a.known = t.known && t.host < 0, a.added = t.added;
    a.value = t.host >= 0 ? model[static_cast<size_t>(t.host)].value : t.value;
    if (t.term.kind == Kind::kBacklash && t.added)
      a.value = -a.value;  // a rig file takes its stiffness away inside the gap
    if (t.host >= 0) a.known = model[static_cast<size_t>(t.host)].known;
    list.push_back(a);
  }
  const std::vector<Parameter> parameters = runs::parameters_of(model);
  for (size_t i = 0; i < parameters.size() && i < found.size(); ++i)
    take_std(parameters[i], found[i], list[parameters[i].term]);
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].host >= 0) list[i].std = list[static_cast<size_t>(model[i].host)].std;
  return list;
}

std::string place_of_term(const Task& task, const Term& t) {
  if (t.kind == Kind::kBaseDelay) return "channel " + base_channel(task);
  if (of_motion_channel(t.kind))
    for (const MotionTrace& trace : task.records[0].traces)
      if (trace.dof == t.dof && trace.quantity == t.quantity) return "channel " + trace.channel;
  return place_of(task.system, t, FusedRecord());
}

std::vector<diagnosis::Parameter> parameters_of_cause(const Task& task, const std::vector<ActiveTerm>& list,
                                                      const ActiveTerm& a) {
  std::vector<diagnosis::Parameter> numbers;
  if (of_motion_channel(a.term.kind)) {
    const std::string channel = place_of_term(task, a.term).substr(8);
    const bool delay = a.term.kind == Kind::kChannelDelay || a.term.kind == Kind::kBaseDelay;
    numbers = {{std::string(word_of(a.term.kind)) + "[" + channel + "]", a.value, delay ? "s" : "1", a.std, true}};
  } else {
    numbers = parameters_of_term(task.system, list, a);
  }
  for (diagnosis::Parameter& p : numbers) {
    p.undetermined = a.alike;
    if (a.alike) p.std = std::max(p.std, kNoNumber * std::abs(p.value));
  }
  return numbers;
}

std::vector<diagnosis::Parameter> all_parameters(const Task& task, const std::vector<ActiveTerm>& list) {
  std::vector<diagnosis::Parameter> out;
  for (const ActiveTerm& a : list)
    if (a.added || !a.known)
      for (diagnosis::Parameter& p : parameters_of_cause(task, list, a)) out.push_back(p);
  return out;
}

NamedPlace named_place(const Task& task, const Term& term) { return {word_of(term.kind), place_of_term(task, term)}; }

void list_equal(const NamedPlace& place, Diagnosis& d) {
  if (std::find(d.ambiguous_with.begin(), d.ambiguous_with.end(), place) == d.ambiguous_with.end())
    d.ambiguous_with.push_back(place);
}

bool of_sensor(const diagnosis::Parameter& p) { return p.name.rfind("sensor_", 0) == 0; }

bool contradicts(const diagnosis::Parameter& rows, const diagnosis::Parameter& runs) {
  return std::max(rows.std, runs.std) > 0 && rows.estimated &&
         std::abs(rows.value - runs.value) > kByChance * std::hypot(rows.std, runs.std);
}

std::vector<diagnosis::Parameter> numbers_of(const Task& task, const State& fitted) {
  if (!fitted.fit.ok) return {};
  return all_parameters(task, fitted_terms(fitted.model, determined_beside_drives(task, fitted)));
}

std::vector<diagnosis::Parameter> values_of(const Task& task, const Model& model) {
  return all_parameters(task, fitted_terms(model, {}));
}

void take_numbers(const std::vector<diagnosis::Parameter>& runs, bool values_too,
                  std::vector<diagnosis::Parameter>& parameters) {
  for (diagnosis::Parameter& p : parameters) {
    const auto other =
        std::find_if(runs.begin(), runs.end(), [&](const diagnosis::Parameter& o) { return o.name == p.name; });
    if (other == runs.end() || !p.estimated) continue;
    if (values_too && !of_sensor(p))
      p.value = other->value, p.std = other->std;
    else
      p.std = std::max(p.std, other->std);
  }
}

}  // namespace diagnosis::runs
