#include "outsiders.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "../terms/naming.hpp"

namespace diagnosis {
namespace {

std::string number(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

// A column times cos(2 pi shift t / T) or its sine: its spectrum moved by `shift` bins both ways.
Column modulated(const Column& c, const Rows& rows, Eigen::Index shift, bool sine) {
  Column out = c;
  for (size_t r = 0; r < c.spectra.size(); ++r) {
    const Spectrum& s = c.spectra[r];
    const Eigen::Index first = rows.records()[r].first_bin;
    const auto at = [&](Eigen::Index bin) -> Complex {
      const Eigen::Index i = std::abs(bin) - first;
      if (i < 0 || i >= s.size()) return 0;
      return bin < 0 ? std::conj(s[i]) : s[i];
    };
    for (Eigen::Index i = 0; i < s.size(); ++i) {
      const Complex below = at(i + first - shift), above = at(i + first + shift);
      out.spectra[r][i] = sine ? Complex(0, -0.5) * (below - above) : 0.5 * (below + above);
    }
  }
  return out;
}

constexpr Eigen::Index kSlowest = 48;  // periods in a record of what changes with time

struct Scan {
  const Rows& rows;
  const CandidateBank& bank;
  const std::vector<ActiveTerm>& model;
  const Fit& fit;
  Outsider best;

  double base() const { return rows.absolute() ? 60 : 150; }
  void consider(double gain, double threshold, const std::string& description, double hertz = 0, int repeats_on = -1) {
    const double score = gain / std::max(1.0, (fit.chi2 - gain) / fit.dof);
    if (score - threshold > best.score - best.threshold) best = {score, threshold, description, hertz, repeats_on};
  }
  // Gains of pairs of columns (a cosine and its sine) at one place.
  std::vector<double> pair_gains(const Place& place, const std::vector<Column>& columns) const {
    std::vector<const Spectra*> list;
    for (const Column& c : columns) list.push_back(&c.spectra);
    const Projection::Products p = fit.projection->products(place, list);
    std::vector<double> gains;
    for (Eigen::Index i = 0; i + 1 < p.residual.size(); i += 2) {
      const Eigen::Matrix2d gram = fit.projection->free_gram(place, list, p, i, 2);
      const bool free = gram(0, 0) > 1e-7 * p.square[i];
      const Eigen::Vector2d moment = p.residual.segment(i, 2);
      gains.push_back(free ? moment.dot(gram.ldlt().solve(moment)) : 0);
    }
    return gains;
  }
  void tones() {
    for (const Tone& t : rows.loudest_tones(fit.projection->residual()))
      consider(t.gain, base(), "a tone of " + number(t.hertz) + " Hz on dof " + std::to_string(t.dof + 1), t.hertz);
  }
  void link(int l) {
    Term term;
    term.link = l;
    const std::string place = place_of(rows.system(), term, rows.records()[0]);
    const double threshold = base() + bank.reversal_doubt(model, term);
    const FusedRecord& f = rows.records()[0];
    const double length_s = static_cast<double>(f.samples) * f.period_s;
    for (Kind kind : {Kind::kMissingViscous, Kind::kStiffnessError}) {
      term.kind = kind;
      const Column column = *rows.column(term);
      if (rows.records().size() > 1) break;  // the phase differs between records
      std::vector<Column> columns;
      for (Eigen::Index k = 1; k <= kSlowest; ++k)
        columns.push_back(modulated(column, rows, k, false)), columns.push_back(modulated(column, rows, k, true));
      const std::vector<double> gains = pair_gains(rows.place(term), columns);
      for (size_t k = 0; k < gains.size(); ++k)
        consider(gains[k], threshold,
                 std::string(kind == Kind::kMissingViscous ? "a damping" : "a stiffness") + " of " + place +
                     " that changes with time, period near " + number(length_s / static_cast<double>(k + 1)) + " s");
    }
    double peak = 0;
    for (size_t r = 0; r < rows.records().size(); ++r)
      peak = std::max(peak, rows.link(r, static_cast<size_t>(l)).u_peak);
    std::vector<Column> columns;
    std::vector<double> pitches;
    for (double share = 1.3; peak > 0 && share > 0.1; share *= 0.8) {
      pitches.push_back(share * peak);
      term.kind = Kind::kUnknownPitch, term.shape = pitches.back();
      for (double phase : {0.0, 1.5707963267948966}) {
        term.shape2 = phase;
        columns.push_back(*rows.column(term));
      }
    }
    const std::vector<double> gains = pair_gains(rows.place(term), columns);
    for (size_t i = 0; i < gains.size(); ++i)
      consider(gains[i], threshold,
               "a force of " + place + " that repeats with the elongation, pitch near " + number(pitches[i]), 0, l);
  }
};

}  // namespace

Outsider strongest_outsider(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model,
                            const Fit& fit) {
  Scan scan{rows, bank, model, fit, {}};
  scan.tones();
  for (size_t l = 0; l < rows.system().known_links; ++l) scan.link(static_cast<int>(l));
  return scan.best;
}

}  // namespace diagnosis
