// Every effect that could be missing, at every place, with its shapes on a grid; and what each would bring, from one
// pass over the windows.
#pragma once
#include "../fit/fit.hpp"

namespace diagnosis::runs {

// One or two columns that stand or fall together (cosine and sine of a hum, of a force that repeats along the way).
struct Candidate {
  std::vector<Term> terms;
  int host = -1;       // index of the model's term in whose place it acts
  int sign = 0;        // that its coefficient must have; 0: either
  int complexity = 0;  // numbers that it has beside its coefficient
  bool same_place(const Candidate& o) const { return terms[0].same_place(o.terms[0]); }
  bool allows(double value) const { return !(sign * value < 0); }
};

// periodic_too: forces that repeat along the way, at pitches of which there are many.
std::vector<Candidate> candidates_beside(const System& system, const Model& model, const std::vector<Prepared>& records,
                                         bool periodic_too);

// From the lowest to the highest elongation of a link, over all records.
double way_of(const System& system, const std::vector<Prepared>& records, int link);
// Its rate, rms, of the fastest record.
double rate_of(const System& system, const std::vector<Prepared>& records, int link);

struct Screened {
  size_t candidate = 0;
  double gain = 0;  // share of the squared residual that it would take
  double z = 0;     // significance, as a normal deviate
  std::vector<double> value;
  Vec moves = {};  // of the model's numbers beside it, linearised
};
struct ScreenedPair {
  size_t first = 0, second = 0;
  double gain = 0;
};
struct Screen {
  std::vector<Screened> singles;  // best first; one per kind and place, its best shape
  std::vector<ScreenedPair> pairs;
};
// `fit` has settled over `windows`. pairs: how many of the best singles are tried two by two.
Screen screen(const System& system, const std::vector<Prepared>& records, const Model& model,
              const std::vector<Window>& windows, const Fitted& fit, const std::vector<Candidate>& candidates,
              size_t pairs);

// The model with a candidate and its first values.
Model joined(const Model& model, const Candidate& candidate, const std::vector<double>& value);

}  // namespace diagnosis::runs
