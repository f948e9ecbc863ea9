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
  struct Acting;  // what the terms do in a window
  struct Way {    // displacement and velocity, or elongation and rate, over a window
    Vec u, v;
    Way less(const Way& other) const { return {u - other.u, v - other.v}; }
  };

  // columns.cpp
  Acting acting(const std::vector<Term>& terms, const Window& w, const WindowRun& run,
                const std::vector<MotionTrace>& traces, Mat& out);
  void balance(const Acting& acting, const Window& w, const std::vector<MotionTrace>& traces, Mat& out) const;
  void carry(const Acting& acting, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
             Mat& out) const;

  // column_forces.cpp: positive against the motion of the link's first end, or of the DOF.
  Vec force(const Term& t, const Window& w, const WindowRun& run, Memory& memory) const;
  Vec link_force(const Term& t, const Window& w, const WindowRun& run, bool follows, Memory& memory) const;
  Vec bristle_force(const Term& t, const Way& along, bool follows, Memory& memory) const;
  Vec resonance_force(const Term& t, const Window& w, const WindowRun& run, bool follows, Memory& memory) const;
  Vec drive_fault(const Term& t, const Window& w) const;
  bool has_coulomb(int link) const;
  Way simulated_way(int end, const Window& w, const WindowRun& run) const;
  Way measured_way(int end, const Window& w) const;
  Way outer_way(int end, const Window& w) const;  // of the base, or of the ground

  // column_readings.cpp: what is no force on the nodes.
  bool of_channel(const Term& t, const Window& w, const WindowRun& run, const std::vector<MotionTrace>& traces,
                  Vec& rows) const;
  // What a base that is read late by a second changes at once: forces on the nodes, and the base's acceleration (where it
  // carries the rig).
  void base_delay(const Window& w, const WindowRun& run, Mat& forces, Vec& carried) const;
  double base(const Window& w, Index k, bool rate) const;

  const System& system_;
  const Model& model_;
  const std::vector<Prepared>& records_;
  bool massless_;
  std::vector<Memory> memory_;
};

}  // namespace diagnosis::runs
