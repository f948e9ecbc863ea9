// What candidates would add to a window's simulated channels, per unit of their coefficient.
#pragma once
#include "candidates.hpp"

namespace diagnosis::runs {

// Carries what candidates remember (bristles, hidden masses) from one window of a record to the next.
class Columns {
 public:
  Columns(const System& system, const Model& model, const std::vector<Prepared>& records, bool massless)
      : system_(system), model_(model), records_(records), massless_(massless) {}
  // terms x rows of the window's run, which kept its transitions (and is not yet weighted).
  void make(const std::vector<Term>& terms, const Window& w, const WindowRun& run,
            const std::vector<MotionTrace>& traces, Mat& out);

 private:
  struct Memory {
    Index ends = -1;
    size_t record = 0;
    double z = 0, v = 0;
  };
  Vec force(const Term& t, const Window& w, const WindowRun& run, Memory& memory) const;
  bool of_channel(const Term& t, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
                  Vec& rows) const;
  double base(const Window& w, Index k, bool rate) const;
  // What a base that is read late by a second changes at once: forces on the nodes, and the base's acceleration (where it
  // carries the rig).
  void base_delay(const Window& w, const WindowRun& run, Mat& forces, Vec& carried) const;
  const System& system_;
  const Model& model_;
  const std::vector<Prepared>& records_;
  bool massless_;
  std::vector<Memory> memory_;
};

}  // namespace diagnosis::runs
