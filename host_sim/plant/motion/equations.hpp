// The equations of motion of a rig: M a = f(t) - sum over links of their force (Eq. 5), with friction that can stick.
//
// State y = [ x of every DOF | v of every DOF | memories z of the effects that have some ]. The forces are the laws of the
// vocabulary (host_sim/vocabulary) times their coefficients: of a link subtracted from a and added to b, of a DOF (a hidden
// resonance) subtracted from it, of a drive subtracted from the force that is asked for.
// Between two events the right-hand side is smooth: signs and gap sides are held in Modes and change only at the roots
// of root_functions(). A link whose friction level (Coulomb + Stribeck peak) holds it has sign 0: its ends move as
// one body.
#pragma once
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/plant/instruments/signal.hpp"
#include "host_sim/vocabulary/law.hpp"

namespace host_sim {

struct Modes {
  std::vector<int> rate_sign;  // per link: sign of w in sgn, |w| and w|w| terms; 0 = stuck
  std::vector<int> gap_side;   // per gap term: -1 below -gap, 0 inside, +1 above gap
};

// How large motion is so far: what an elongation or a rate near zero is measured against.
struct MotionScale {
  double displacement = 1.0, velocity = 1.0, force = 1.0;
};

// A law with its coefficient at a place.
struct PlantTerm {
  vocabulary::EffectKind kind = vocabulary::EffectKind::kStiffness;
  double coefficient = 0.0;
  vocabulary::Shape shape;
  size_t memory = 0;  // first of its entries of z, where its law has memory
  size_t gap = 0;     // which gap side, where its law has a gap
};

struct PlantLink {
  size_t a = 0, b = 0;      // nodes: masses, then ground, then base
  double hold = 0.0;        // friction level at rest; sticks where > 0
  bool watch_rate = false;  // w = 0 is an event
  std::vector<PlantTerm> terms;
};

class Equations {
 public:
  // Throws PlantError: a coefficient still to be estimated, a DOF without mass, an effect it does not know or without
  // shape.
  explicit Equations(const rig_file::RigModel& rig);

  size_t masses() const { return mass_.size(); }  // one to a DOF
  size_t states() const { return 2 * masses() + memory_of_.size(); }
  size_t roots() const { return roots_; }
  double mass(size_t i) const { return mass_[i]; }
  const std::vector<PlantLink>& links() const { return links_; }

  // Between events nothing but springs, viscous dampers and constant friction, all of them in links?
  bool linear_between_events() const;
  // Masses that stuck links tie together, and to the ground (masses()) or the base (masses() + 1), have the same number; empty
  // where nothing is stuck.
  std::vector<size_t> stuck_bodies(const Modes& modes) const;

  // What a state beyond the displacements and velocities is measured against: 1, or the scale of what it follows.
  double memory_scale(size_t memory, const MotionScale& scale) const;

  // Full state from displacement and velocity of the DOFs (missing entries 0); memories as vocabulary::start_memory says.
  std::vector<double> initial_state(const std::vector<double>& x, const std::vector<double>& v,
                                    const Motion& base) const;

  // force: per DOF (N), as it is asked of the drive. dy has states() entries.
  void derivative(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                  double* dy) const;

  // g[] = one function per watched link (its rate; while stuck, what its hold has in reserve), two per gap term. All are
  // shares of `scale` or of the hold: the integrator takes anything below 1e-10 for zero.
  void root_functions(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                      const MotionScale& scale, double* g) const;

  // Modes of a state that no event led to: signs of the rates, of the accelerations where a rate is zero.
  Modes start_modes(double t_s, double* y, const double* force, const Motion& base) const;
  // Corrects signs that the state contradicts (two events inside one step); true where a friction link was among them.
  bool resync(double* y, const double* force, const Motion& base, Modes& modes) const;
  // Updates modes from ARKODE's root directions, and says which links may now be at rest.
  std::vector<bool> apply_roots(const int* direction, Modes& modes) const;
  // Decides for every link marked resting whether it sticks or slides and where to (velocities of the marked links are
  // made exactly equal first). The hold forces solve  min 1/2 h'Ah - b'h, |h| <= hold: the friction law at w = 0.
  void solve_rest(double t_s, double* y, const double* force, const Motion& base, const std::vector<bool>& resting,
                  Modes& modes) const;
  // Makes the ends of stuck links move exactly alike.
  void equalise(double* y, const Motion& base, const Modes& modes) const;

 private:
  struct Node {
    double x, v;
  };
  Node node(const double* y, const Motion& base, size_t index) const;
  vocabulary::Point point(const PlantTerm& term, double t_s, double u, double w, int sign, const double* z,
                          const Modes& modes) const;
  // The memories of the terms in a place: dy gets their rates.
  void memory_rates(const std::vector<PlantTerm>& terms, const Node& at, double t_s, int sign, const double* y,
                    const Modes& modes, double* dy) const;
  void net_forces(double t_s, const double* y, const double* force, const Motion& base, const Modes& modes,
                  double* net) const;
  void accelerations(const double* net, const Motion& base, const Modes& modes, double* a) const;
  std::vector<size_t> bodies(const std::vector<bool>& joined) const;
  void hold_forces(const double* net, const Motion& base, const std::vector<size_t>& links,
                   std::vector<double>& hold) const;
  // The same without bounds; where loops of links leave it open, shared in proportion to the holds.
  void unbounded_hold(const double* net, const Motion& base, const std::vector<size_t>& links,
                      std::vector<double>& hold) const;
  // visit(term, what its gap is measured in) for every term with a gap, in the order of the gap sides.
  template <typename Visit>
  void each_gap(const double* y, const double* force, const Motion& base, Visit visit) const;
  void find_gap_sides(const double* y, const double* force, const Motion& base, Modes& modes) const;
  bool stuck(size_t link, const Modes& modes) const { return links_[link].hold > 0.0 && modes.rate_sign[link] == 0; }
  // Links that are stuck; empty where none is.
  std::vector<bool> stuck_links(const Modes& modes) const;
  size_t ground() const { return masses(); }
  size_t base_node() const { return masses() + 1; }
  friend class EquationsBuilder;

  size_t gaps_ = 0, roots_ = 0;
  std::vector<double> mass_;
  std::vector<PlantLink> links_;
  std::vector<std::vector<PlantTerm>> on_dof_, on_drive_;  // per DOF
  struct MemoryPlace {
    vocabulary::EffectKind kind;
    int entry;
  };
  std::vector<MemoryPlace> memory_of_;  // per entry of z
};

}  // namespace host_sim
