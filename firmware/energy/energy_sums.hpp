// Stage "energy": frames of signals in, batches of energies out (batch_table.hpp).
#pragma once
#include "firmware/conditioning/conditioning.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/energy/equation_plan.hpp"
#include "firmware/energy/product_sums.hpp"
#include "firmware/links/clear_sign.hpp"
#include "firmware/links/effects.hpp"
#include "firmware/links/high_passed_sign.hpp"
#include "firmware/links/link_motion.hpp"
#include "firmware/links/low_passed_sign.hpp"

namespace firmware {

class EnergySums {
 public:
  // weights: 1 plain sums only, 2 with the instrument, 3 with the displacement weight too.
  void configure(const CoreConfiguration& configuration, int weights);
  const RowLayout& layout() const { return layout_; }
  const Scaled* effect_units() const { return &plan_.column_unit[kEffectColumn]; }  // SI, in the order of the terms

  void restart();  // a new level
  // Friction counts in samples of clear sign: at which links, and whose equations leave the others out.
  bool takes_clear_sign(int link) const { return wants_clear_sign_[link]; }
  bool leaves_samples_out(int dof) const { return plan_.dof[dof].clear_signs_only; }
  // Works on positions [kLeadIn, kLeadIn + count) of the frame; position kLeadIn + count is the boundary to what follows.
  void add_block(Frame& frame, int count);
  uint32_t samples() const { return started_ ? samples_ : 0; }  // since the batch was started
  // Energies since the last call (or restart) up to the end of the last block; starts the next batch there.
  void close_batch(const Frame& frame, int boundary, Batch& batch);

 private:
  struct EndPoint {
    int32_t displacement[kMaxDofs], velocity[kMaxDofs];
  };
  void fill_columns(Frame& frame, int count);
  void fill_instruments(Frame& frame, int from, int to);
  void fill_signs(Frame& frame, int link, int from, int to);
  void fill_clear_signs(Frame& frame, int from, int to, int advance);
  void leave_out(Frame& frame, int link, int from, int to, const int32_t* clear);
  void add_crossings(const Frame& frame, int link, bool smoothed, const int64_t* rate, int from, int to);
  void start_batch(const Frame& frame, int at);
  EndPoint end_point(const Frame& frame, int at) const;
  void clear_crossings();
  void read_integrals();
  Scaled integral(int product) const { return product == kNoProduct ? Scaled{} : integral_[product]; }
  Scaled energy(const Incidence& incidence, int weight) const;
  Scaled friction_energy(const Incidence& incidence, int weight) const;
  Scaled kinetic_energy(int dof, int weight) const;
  Scaled shared_noise(int dof, int weight, Quantity quantity) const;
  void close_dof(int dof, const EndPoint& end, Batch& batch) const;

  const CoreConfiguration* configuration_ = nullptr;
  int weights_ = 1;
  EquationPlan plan_;
  Effects effects_;
  RowLayout layout_;
  ProductSums sums_;
  RateGains gains_[kMaxLinks];
  bool has_sign_[kMaxLinks];
  bool wants_clear_sign_[kMaxLinks];  // friction of a DOF whose equation is taken only where signs are clear
  bool wants_all_signs_[kMaxLinks];   // friction of a DOF whose equation is taken everywhere
  ClearSign clear_sign_[kMaxLinks];
  HighPassedSign high_passed_sign_[kMaxLinks];
  LowPassedSign low_passed_sign_[kMaxLinks];
  bool locates_crossings_[kMaxLinks];  // a DOF at the link has no measured acceleration
  bool
      smooth_is_white_[kMaxLinks];  // both velocities are measured: the noise of the two sign streams is known to scale
  int64_t crossing_q16_[kMaxTermIncidences][kWeights];
  Scaled integral_[kMaxProducts];       // of the batch that was closed last, SI units
  Scaled integral_unit_[kMaxProducts];  // of one twenty-fourth of a product sum
  EndPoint start_;
  EndPoint end_;
  uint32_t samples_ = 0;
  bool started_ = false;
};

}  // namespace firmware
