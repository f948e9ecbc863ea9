#include "outsiders.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "naming.hpp"

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

struct Scan {
  const Rows& rows;
  const CandidateBank& bank;
  const std::vector<ActiveTerm>& model;
  const Fit& fit;
  Outsider best;

  double base() const { return rows.absolute() ? 60 : 150; }
  void consider(double gain, double threshold, const std::string& description) {
    const double score = gain / std::max(1.0, (fit.chi2 - gain) / fit.dof);
    if (score - threshold > best.score - best.threshold) best = {score, threshold, description};
  }
  double pair_gain(const Column& a, const Column& b) const {
    Candidate c;
    c.column = std::make_shared<const Column>(a);
    c.companions.push_back(std::make_shared<const Column>(b));
    return gain_of(rows, model, fit, c).chi2;
  }
  void tones() {
    for (const Tone& t : rows.loudest_tones(fit.residual))
      consider(t.gain, base(), "a tone of " + number(t.hertz) + " Hz on dof " + std::to_string(t.dof + 1));
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
      const Column column = rows.column(term);
      if (rows.records().size() > 1) break;  // the phase differs between records
      for (Eigen::Index k = 1; k <= 48; ++k)
        consider(pair_gain(modulated(column, rows, k, false), modulated(column, rows, k, true)), threshold,
                 std::string(kind == Kind::kMissingViscous ? "a damping" : "a stiffness") + " of " + place +
                     " that changes with time, period near " + number(length_s / static_cast<double>(k)) + " s");
    }
    double peak = 0;
    for (size_t r = 0; r < rows.records().size(); ++r) peak = std::max(peak, rows.link(r, static_cast<size_t>(l)).u_peak);
    for (double share = 1.3; peak > 0 && share > 0.1; share *= 0.8) {
      term.kind = Kind::kUnknownPitch;
      term.shape = share * peak;
      Term cosine = term;
      cosine.shape2 = 1.5707963267948966;
      const double gain = pair_gain(rows.column(term), rows.column(cosine));
      consider(gain, threshold, "a force of " + place + " that repeats with the elongation, pitch near " + number(term.shape));
    }
  }
};

}  // namespace

Outsider strongest_outsider(const Rows& rows, const CandidateBank& bank, const std::vector<ActiveTerm>& model, const Fit& fit) {
  Scan scan{rows, bank, model, fit, {}};
  scan.tones();
  for (size_t l = 0; l < rows.system().known_links; ++l) scan.link(static_cast<int>(l));
  return scan.best;
}

}  // namespace diagnosis
