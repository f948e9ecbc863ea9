#include "search.hpp"

#include <algorithm>
#include <cmath>

namespace diagnosis {
namespace {

double score_of(const Gain& gain, const Fit& fit, const Candidate& c) {
  const double left = std::max(1.0, (fit.chi2 - gain.chi2) / fit.dof);
  return (gain.chi2 - c.penalty) / left;
}

struct Scorer {
  const Rows& rows;
  const CandidateBank& bank;
  const std::vector<ActiveTerm>& model;
  const Fit& fit;

  Found of(const Candidate& c) const {
    Found found{c, gain_of(rows, model, fit, c), 0};
    found.score = score_of(found.gain, fit, c);
    return found;
  }
  // Golden section on the logarithm of one shape parameter within a factor of its grid value.
  Found along(const Found& start, bool second, double factor, int steps) const {
    const Term& t = start.candidate.column.term;
    const double centre = std::log(second ? t.shape2 : t.shape), golden = 0.6180339887498949;
    double low = centre - std::log(factor), high = centre + std::log(factor);
    const auto at = [&](double p) {
      return of(bank.reshaped(start.candidate, second ? t.shape : std::exp(p), second ? std::exp(p) : t.shape2));
    };
    double a = high - golden * (high - low), b = low + golden * (high - low);
    Found fa = at(a), fb = at(b), best = start;
    for (int i = 0; i < steps; ++i) {
      if (fa.gain.chi2 > fb.gain.chi2) {
        high = b, b = a, fb = fa;
        a = high - golden * (high - low), fa = at(a);
      } else {
        low = a, a = b, fa = fb;
        b = low + golden * (high - low), fb = at(b);
      }
      for (const Found& f : {fa, fb})
        if (f.gain.chi2 > best.gain.chi2) best = f;
    }
    return best;
  }
  Found refined(const Found& found) const {
    const Kind kind = found.candidate.column.term.kind;
    if (!CandidateBank::has_shape(kind)) return found;
    if (kind != Kind::kResonance) return along(found, false, kind == Kind::kEndStop ? 1.3 : 2.0, 9);
    const Term& t = found.candidate.column.term;
    Found best = of(bank.reshaped(found.candidate, t.shape, t.shape2));  // from frequency response to time
    best = along(best, false, 1.05, 8);
    best = along(best, true, 8, 6);
    best = along(best, false, 1.015, 6);
    return along(best, true, 2, 4);
  }
};

bool better(const Found& a, const Found& b) { return a.score > b.score; }

// The model without one added term, fitted with the weights as they are.
struct Without {
  std::vector<ActiveTerm> model;
  Fit fit;
};
Without without(const Rows& rows, const std::vector<ActiveTerm>& model, size_t index) {
  Without w{model, {}};
  remove_term(w.model, index);
  w.fit = fit_model(rows, w.model);
  return w;
}

std::vector<size_t> added_terms(const std::vector<ActiveTerm>& model) {
  std::vector<size_t> list;
  for (size_t i = 0; i < model.size(); ++i)
    if (model[i].added) list.push_back(i);
  return list;
}

// One round of exchanging each added term for the best in its place. True if anything changed.
bool swap_terms(Rows& rows, const CandidateBank& bank, std::vector<ActiveTerm>& model, Fit& fit) {
  bool changed = false;
  for (size_t k = 0; k < added_terms(model).size(); ++k) {
    const size_t index = added_terms(model)[k];
    const Without w = without(rows, model, index);
    const std::vector<Found> list = ranked(rows, bank, w.model, w.fit, 4);
    if (list.empty()) continue;
    std::vector<ActiveTerm> trial = w.model;
    trial.push_back(activate(list[0].candidate, trial, list[0].gain));
    const Fit trial_fit = settle(rows, trial, 1);
    if (trial_fit.chi2 < fit.chi2 - 4) {
      changed = changed || !trial.back().column.term.same_place(model[index].column.term);
      model = trial;
      fit = settle(rows, model, 2);
    } else {
      fit = settle(rows, model, 1);
    }
  }
  return changed;
}

}  // namespace

void remove_term(std::vector<ActiveTerm>& model, size_t index) {
  model.erase(model.begin() + static_cast<std::ptrdiff_t>(index));
  for (size_t i = model.size(); i-- > 0;) {
    if (model[i].host == static_cast<int>(index)) {
      remove_term(model, i);
      continue;
    }
    if (model[i].host > static_cast<int>(index)) --model[i].host;
  }
}

std::vector<Found> ranked(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                          const Fit& fit, size_t refined) {
  const Scorer scorer{rows, bank, model, fit};
  std::vector<Found> best;
  for (const Candidate& c : bank.beside(model)) {
    Found found = scorer.of(c);
    if (!best.empty() && best.back().candidate.column.term.same_place(c.column.term)) {
      if (found.score > best.back().score) best.back() = found;
    } else {
      best.push_back(found);
    }
  }
  std::sort(best.begin(), best.end(), better);
  for (size_t i = 0, done = 0; i < best.size() && done < refined; ++i) {
    if (!CandidateBank::has_shape(best[i].candidate.column.term.kind) || best[i].score < 0.3 * best[0].score) continue;
    best[i] = scorer.refined(best[i]);
    ++done;
  }
  std::sort(best.begin(), best.end(), better);
  return best;
}

SearchResult search(Rows& rows, const CandidateBank& bank) {
  SearchResult result;
  result.base = base_model(rows);
  result.base_fit = settle(rows, result.base, 3);
  std::vector<ActiveTerm> model = result.base;
  Fit fit = result.base_fit;
  double first_gain = 0;
  while (added_terms(model).size() < kMostTerms) {
    const std::vector<Found> list = ranked(rows, bank, model, fit, 5);
    if (list.empty() || list[0].score < list[0].candidate.threshold) break;
    if (list[0].gain.chi2 < 0.002 * first_gain) break;
    first_gain = std::max(first_gain, list[0].gain.chi2);
    model.push_back(activate(list[0].candidate, model, list[0].gain));
    fit = settle(rows, model, 2);
    for (int i = 0; i < 3 && swap_terms(rows, bank, model, fit); ++i) {
    }
  }
  // prune, then list what could stand in for each term
  for (size_t k = 0; k < added_terms(model).size();) {
    const size_t index = added_terms(model)[k];
    const Without w = without(rows, model, index);
    std::vector<Found> list = ranked(rows, bank, w.model, w.fit, 6);
    const Term mine = model[index].column.term;
    const auto own = std::find_if(list.begin(), list.end(),
                                  [&](const Found& f) { return f.candidate.column.term.same_place(mine); });
    const double gain = w.fit.chi2 - fit.chi2;
    if (own == list.end() || (gain - own->candidate.penalty) / std::max(1.0, fit.ratio()) < own->candidate.threshold) {
      remove_term(model, index);
      fit = settle(rows, model, 2);
      k = 0, result.added.clear(), result.rivals.clear();
      continue;
    }
    Found self = *own;
    self.gain.chi2 = gain;
    self.score = std::max(self.score, (gain - self.candidate.penalty) / std::max(1.0, fit.ratio()));
    self.gain.coefficient = model[index].value, self.gain.std = model[index].std;
    list.erase(own);
    std::vector<Found> rivals;
    for (const Found& f : list)
      if (f.score > self.score - 12) rivals.push_back(f);
    result.added.push_back(self);
    result.rivals.push_back(rivals);
    ++k;
  }
  result.model = model;
  result.fit = fit;
  return result;
}

}  // namespace diagnosis
