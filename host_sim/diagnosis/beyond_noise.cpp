#include "beyond_noise.hpp"

#include <algorithm>
#include <cmath>

#include "tune.hpp"

namespace diagnosis {
namespace {

constexpr double kWorthwhile = 0.75;  // what a term may leave of the simulation's error
constexpr double kAsGood = 1.2;       // errors closer than this do not tell two terms apart
constexpr size_t kTried = 8;

// Candidates of the rig's own links as free columns, thinned where they differ in shape only.
std::vector<Candidate> spanning(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model) {
  std::vector<Candidate> list;
  Term last;
  int repeat = 0;
  for (Candidate c : bank.beside(model)) {
    const Term& t = c.term();
    if (t.link < 0 || static_cast<size_t>(t.link) >= rows.system().known_links) continue;
    repeat = t.same_place(last) ? repeat + 1 : 0;
    last = t;
    if (repeat % 3 != 0) continue;
    c.host = -1, c.fixed = false, c.coefficient_sign = 0;
    list.push_back(c);
  }
  return list;
}

struct Trial {
  Found found;
  std::vector<ActiveTerm> model;
  double error = 0, unseen = 0;  // of the simulation of training and of unseen data, %
};

Trial tried(const Rows& rows, const Judge& judge, std::vector<ActiveTerm> model, const Found& found) {
  Trial t{found, std::move(model), 0, 0};
  t.error = tune(rows.system(), t.model, rows.records());
  t.unseen = mean(judge.score(t.model).nrmse_percent);
  return t;
}

// The terms of a link that an effect may need beside it before it shows: friction, where the rig file has none.
std::vector<std::vector<ActiveTerm>> with_friction(const Rows& rows, const CandidateBank& bank,
                                                   const std::vector<ActiveTerm>& model) {
  std::vector<std::vector<ActiveTerm>> list;
  for (const Candidate& c : bank.beside(model))
    if (c.term().kind == Kind::kMissingCoulomb && static_cast<size_t>(c.term().link) < rows.system().known_links)
      list.push_back(joined(model, c, {}));
  return list;
}

class Selection {
 public:
  Selection(Rows& rows, const CandidateBank& bank, const Judge& judge) : rows_(rows), bank_(bank), judge_(judge) {
    model_ = base_model(rows);
    fit_ = settle(rows, model_, 3);
    present_ = tried(rows, judge, model_, {});
    result_.base = result_.model = present_.model, result_.base_fit = result_.fit = fit_;
  }
  SearchResult run() {
    while (result_.added.size() < kMostTerms && (extend(model_) || extend_beside_friction())) {
    }
    return result_;
  }

 private:
  bool extend_beside_friction() {
    if (result_.added.size() + 2 > kMostTerms) return false;
    for (const auto& start : with_friction(rows_, bank_, model_))
      if (extend(start)) return true;
    return false;
  }
  bool extend(std::vector<ActiveTerm> start) {
    const Fit fit = settle(rows_, start, 2);
    std::vector<Trial> trials;
    size_t count = 0;
    for (const Found& f : ranked(rows_, bank_, start, fit, 5)) {
      if (count++ == kTried || f.score < f.candidate.threshold) break;
      std::vector<ActiveTerm> more = joined(start, f.candidate, f.gain);
      settle(rows_, more, 1);
      const Trial t = tried(rows_, judge_, more, f);
      if (std::max(t.error / present_.error, t.unseen / present_.unseen) < kWorthwhile) trials.push_back(t);
    }
    const auto best = std::min_element(trials.begin(), trials.end(),
                                       [](const Trial& a, const Trial& b) { return a.unseen < b.unseen; });
    if (best == trials.end()) return false;
    for (size_t i = model_.size(); i <= start.size(); ++i) take(best->model[i].term, best->found);
    for (const Trial& t : trials)
      if (&t != &*best && t.unseen < kAsGood * best->unseen) result_.rivals.back().push_back(t.found);
    present_ = *best;
    result_.model = present_.model, result_.fit = fit_;
    return true;
  }
  // One more term, with the shape that simulates best.
  void take(const Term& term, const Found& found) {
    const Candidate c = bank_.again(term, model_);
    result_.added.push_back({c, found.gain, found.score});
    result_.rivals.emplace_back();
    model_ = joined(model_, c, gain_of(rows_, model_, fit_, c));
    fit_ = settle(rows_, model_, 2);
  }
  Rows& rows_;
  const CandidateBank& bank_;
  const Judge& judge_;
  std::vector<ActiveTerm> model_;  // fitted to the equation error
  Fit fit_;
  Trial present_;  // the same, tuned
  SearchResult result_;
};

}  // namespace

Eigen::Index end_of_motion(const FusedRecord& f) {
  return std::min(f.last_bin, std::max<Eigen::Index>(60, 10 * motion_bin(f, 0.99)));
}

void colour_by_vocabulary(Rows& rows, const CandidateBank& bank) {
  for (int round = 0; round < 4; ++round) {
    std::vector<ActiveTerm> model = base_model(rows);
    settle(rows, model, 2);
    for (const Candidate& c : spanning(rows, bank, model)) model = joined(model, c, {});
    const Fit fit = fit_model(rows, model);
    rows.colour(fit.projection->residual(), fit.dof / static_cast<double>(rows.size()));
  }
}

SearchResult search_by_simulation(Rows& rows, const CandidateBank& bank, const Judge& judge) {
  return Selection(rows, bank, judge).run();
}

SearchResult transferred(const SearchResult& found, Rows& rows, const CandidateBank& bank) {
  SearchResult out = found;
  out.base = base_model(rows);
  out.base_fit = settle(rows, out.base, 3);
  out.model = out.base;
  Fit before = out.base_fit;
  for (Found& f : out.added) {
    const Candidate c = bank.again(f.candidate.term(), out.model);
    out.model = joined(out.model, c, gain_of(rows, out.model, before, c));
    out.fit = settle(rows, out.model, 2);
    f.candidate = c;
    f.gain.chi2 = before.chi2 - out.fit.chi2;
    f.score = f.gain.chi2 / std::max(1.0, out.fit.ratio());
    before = out.fit;
  }
  if (out.added.empty()) out.fit = out.base_fit;
  tune(rows.system(), out.base, rows.records());
  if (out.added.empty())
    out.model = out.base;
  else
    tune(rows.system(), out.model, rows.records());
  return out;
}

double misfit(Rows& rows, const std::vector<ActiveTerm>& model) {
  std::vector<ActiveTerm> copy = on_rows(rows, model);
  return settle(rows, copy, 2).ratio();
}

}  // namespace diagnosis
