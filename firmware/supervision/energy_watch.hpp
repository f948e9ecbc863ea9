// The board's own look at what the model of the rig lacks, from the running energy sums alone. The host's diagnosis
// (`host_sim diagnose`) sees far more; this one is for knowing at once that something is off, and says less rather than
// something wrong.
//
// Judged in this order, the first finding is told:
//   1. skew of a channel that the kinematic identities show                    -> sensor_delay, channel
//   2. displacement-weighted equations that do not balance (they see masses and springs, dampers hardly)
//   3. velocity-weighted equations that do not balance after the fit           -> UNKNOWN, DOF
//
// For 2, the residual energy R of a DOF in each level is compared with what each cause would leave there. With V the
// integral of v^2, w^2 = integral of a^2 / V, T the length of the level:
//   mass_error  -dm V        stiffness_error  dk V / w^2        cubic_stiffness  (V / w^2)^2 / T        sensor noise  T
// One DOF off balance: a mass, a spring to ground. Two linked DOFs off balance: the spring between them. The cause that
// fits all levels is told; several that fit: AMBIGUOUS (one level alone never tells them apart); none: UNKNOWN.
//
// A DOF also counts where it leans to the same side by 0.4 % in every level while another is off balance.
//
// Off balance: |R| over six times its scatter (from eight groups of consecutive batches) and over 1 % of the energy
// that moves through the DOF; 3 % for the velocity weight.
#pragma once
#include "firmware/can_protocol/messages.hpp"
#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/identification/rows.hpp"

namespace firmware {

class EnergyWatch {
 public:
  // False: the data do not allow a judgement (yet): an estimate that is not to be believed, or too few batches.
  bool judge(const CoreConfiguration& configuration, const BatchTable& table, const Estimates& estimates,
             Diagnosis& diagnosis);

 private:
  // One DOF in one level.
  struct Balance {
    bool present = false;
    Scaled residual;     // R
    Scaled uncertainty;  // its scatter, with a floor for what integration itself leaves
    Scaled energy;       // that moves through the DOF
    Scaled motion;       // V
    Scaled rate_square;  // w^2
    Scaled duration_s;   // T
  };
  struct Finding {
    Cause cause = Cause::kNone;
    Scaled left_over;  // part of the chi-squared that the cause leaves
  };

  static constexpr int kGroups = 8;
  bool believable(const Estimates& estimates) const;
  bool skewed(const Estimates& estimates, Diagnosis& diagnosis) const;
  void load(const CoreConfiguration& configuration, const BatchTable& table, Weight weight);
  void load_balance(const BatchTable& table, const Level& level, int dof, Weight weight, Balance& balance) const;
  Scaled displacement_energy(const CoreConfiguration& configuration, int dof, const Balance& balance) const;
  Scaled damping_energy(const BatchTable& table, const Level& level, int dof, Weight weight) const;
  bool off_balance(const Balance& balance, int per_mille) const;
  void judge_damping(const CoreConfiguration& configuration, const BatchTable& table, Diagnosis& diagnosis);
  uint32_t dofs_leaning() const;
  uint32_t dofs_off_balance(int per_mille, int& worst, uint16_t& worst_per_mille) const;
  Finding explain(int dof, bool may_be_mass) const;
  void name_displacement_finding(const CoreConfiguration& configuration, uint32_t dofs, int worst,
                                 Diagnosis& diagnosis) const;

  int levels_ = 0, dofs_ = 0;
  Scaled parameters_[kMaxUnknowns];
  Balance balance_[kMaxLevels][kMaxDofs];
};

}  // namespace firmware
