#include "elastic_doubt.hpp"

#include <algorithm>
#include <cmath>

#include "../motion/link_motion.hpp"

namespace diagnosis::runs {
namespace {

// rms about the mean over all records, each weighted by its samples.
class Rms {
 public:
  void add(const Vec& y) {
    if (y.size() == 0) return;
    sum_ += (y.array() - y.mean()).square().sum(), count_ += static_cast<double>(y.size());
  }
  double value() const { return count_ > 0 ? std::sqrt(sum_ / count_) : 0; }

 private:
  double sum_ = 0, count_ = 0;
};

// What moves: elongation and rate of each link, acceleration and elastic force of each DOF.
struct Moving {
  std::vector<double> u, w, a, elastic;

  Moving(const Task& task, const Model& model) : a(task.system.dofs()), elastic(task.system.dofs()) {
    for (const rig_file::Link& l : task.system.links) {
      Rms of_u, of_w;
      for (const Prepared& p : task.records) of_u.add(motion_of(l, p, &Guess::x)), of_w.add(motion_of(l, p, &Guess::v));
      u.push_back(of_u.value()), w.push_back(of_w.value());
    }
    for (size_t d = 0; d < a.size(); ++d) {
      Rms of_a;
      for (const Prepared& p : task.records) of_a.add(p.guess[d].a);
      a[d] = of_a.value();
    }
    for (const ModelTerm& t : model) {
      if (t.term.kind != Kind::kStiffness) continue;
      const auto link = static_cast<size_t>(t.term.link);
      for (int end : {task.system.links[link].a, task.system.links[link].b})
        if (end >= 1) {
          double& sum = elastic[static_cast<size_t>(end - 1)];
          sum = std::hypot(sum, t.value * u[link]);
        }
    }
  }

  // At the end of a link that has less of it: that balance tells the link's numbers best.
  double elastic_at(const rig_file::Link& l) const {
    double least = 1e300;
    for (int end : {l.a, l.b})
      if (end >= 1) least = std::min(least, elastic[static_cast<size_t>(end - 1)]);
    return least < 1e300 ? least : 0;
  }
};

double over(double force, double per_unit) { return per_unit > 0 ? force / per_unit : 0; }

double doubt_of(const Task& task, const Moving& moving, const Term& t) {
  if (t.kind == Kind::kMass)
    return over(moving.elastic[static_cast<size_t>(t.dof)], moving.a[static_cast<size_t>(t.dof)]);
  if (t.link < 0) return 0;
  const auto link = static_cast<size_t>(t.link);
  const double force = moving.elastic_at(task.system.links[link]);
  if (t.kind == Kind::kStiffness) return over(force, moving.u[link]);
  if (t.kind == Kind::kViscous) return over(force, moving.w[link]);
  return t.kind == Kind::kCoulomb ? force : 0;
}

}  // namespace

Vec elastic_doubt(const Task& task, const Model& model) {
  const std::vector<Parameter> parameters = parameters_of(model);
  const Moving moving(task, model);
  Vec doubt = Vec::Zero(static_cast<Index>(parameters.size()));
  for (size_t i = 0; i < parameters.size(); ++i)
    if (!parameters[i].shape)
      doubt[static_cast<Index>(i)] = kKnownElastic * doubt_of(task, moving, model[parameters[i].term].term);
  return doubt;
}

}  // namespace diagnosis::runs
