#include "laws_apart.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/link_motion.hpp"

namespace diagnosis::runs {
namespace {

struct LinkForce {
  double elastic = 0, dissipative = 0;  // N
};

// Of a link at an instant. A term in another's place has that one's coefficient; bristles are dry friction here.
LinkForce force_at(const Model& model, int link, double u, double w, double t_s, const Prepared& p) {
  LinkForce f;
  for (size_t i = 0; i < model.size(); ++i) {
    const ModelTerm& t = model[i];
    const bool replaced =
        std::any_of(model.begin(), model.end(), [&](const ModelTerm& m) { return m.host == static_cast<int>(i); });
    if (t.term.link != link || replaced) continue;
    const double value = t.host >= 0 ? model[static_cast<size_t>(t.host)].value : t.value;
    const double time = law_time(t_s, t.term.shape, p);
    const auto at = [&](double rate) {
      if (t.term.kind == Kind::kPresliding) return rate > 0 ? 1.0 : rate < 0 ? -1.0 : 0.0;
      return law(t.term.kind, u, rate, time, t.term.shape, t.term.shape2).force;
    };
    const double resting = at(0);
    f.elastic += value * resting, f.dissipative += value * (at(w) - resting);
  }
  return f;
}

struct Change {
  double difference = 0, size = 0;  // square sums
  void add(double before, double after) { difference += (after - before) * (after - before), size += before * before; }
  double share() const { return difference > 0 ? std::sqrt(difference / std::max(size, 1e-300)) : 0; }
};

double inertia(const Model& model, int dof) {
  double sum = 0;
  for (const ModelTerm& t : model)
    if (t.term.dof == dof &&
        (t.term.kind == Kind::kMass || t.term.kind == Kind::kMassError || t.term.kind == Kind::kResonance))
      sum += t.value;
  return sum;
}

}  // namespace

double laws_apart(const Task& task, const Model& before, const Model& after) {
  double most = 0;
  for (size_t l = 0; l < task.system.links.size(); ++l) {
    const rig_file::Link& link = task.system.links[l];
    Change elastic, dissipative;
    for (size_t r = 0; r < task.training; ++r) {
      const Prepared& p = task.records[r];
      const Vec u = motion_of(link, p, &Guess::x), w = motion_of(link, p, &Guess::v);
      for (Index k = 0; k < p.samples; ++k) {
        const LinkForce old = force_at(before, static_cast<int>(l), u[k], w[k], p.time_s(k), p),
                        now = force_at(after, static_cast<int>(l), u[k], w[k], p.time_s(k), p);
        elastic.add(old.elastic, now.elastic), dissipative.add(old.dissipative, now.dissipative);
      }
    }
    most = std::max({most, elastic.share(), dissipative.share()});
  }
  for (size_t d = 0; d < task.system.dofs(); ++d) {
    Change mass;
    mass.add(inertia(before, static_cast<int>(d)), inertia(after, static_cast<int>(d)));
    most = std::max(most, mass.share());
  }
  return most;
}

}  // namespace diagnosis::runs
