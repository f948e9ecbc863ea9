// Stage "energy": frames of signals in, batches of energies out (batch_table.hpp).
#pragma once
#include "firmware/conditioning/conditioning.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/energy/crossings.hpp"
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
  bool complete() const { return sums_.complete() && effects_.complete(); }         // the equations have found room
  const Scaled* effect_units() const { return &plan_.column_unit[kEffectColumn]; }  // SI, in the order of the terms

  void restart(uint32_t time = 0);  // a new level, or what follows a gap in it, so many samples behind its start
  bool time_is_out() const { return effects_.time_is_out(); }
  // Friction counts in samples of clear sign: at which links, and whose equations leave the others out.
  bool takes_clear_sign(int link) const { return use_[link].wants_clear_sign; }
  bool leaves_samples_out(int dof) const { return plan_.dof[dof].clear_signs_only; }
  // Works on positions [kLeadIn, kLeadIn + count) of the frame; position kLeadIn + count is the boundary to what follows.
  // First what the signals give (instruments, signs, effects), then the sums of products.
  void fill_columns(Frame& frame, int count);
  void add_block(const Frame& frame, int count);
  uint32_t samples() const { return started_ ? samples_ : 0; }  // since the batch was started
  // Energies since the last call (or restart) up to the end of the last block; starts the next batch there.
  void close_batch(const Frame& frame, int boundary, Batch& batch) {
    begin_close(frame, boundary);
    while (!go_on_closing(batch)) {
    }
  }
  // Where signs of friction are located inside a sample interval, all pieces have to be done at once.
  bool closes_at_once() const { return any_crossings_; }
  // The same in pieces, while the next batch is being summed: go_on_closing() until it says true, before the next close.
  void begin_close(const Frame& frame, int boundary);
  bool go_on_closing(Batch& batch);
  int closing_pieces() const {
    return (sums_.count() + kProductsAPiece - 1) / kProductsAPiece + configuration_->dof_count * weights_;
  }

 private:
  struct EndPoint {
    int32_t displacement[kMaxDofs], velocity[kMaxDofs];
  };
  void fill_instruments(Frame& frame, int from, int to);
  void fill_signs(Frame& frame, int link, int from, int to);
  void fill_clear_signs(Frame& frame, int from, int to, int advance);
  void filter_sign(Frame& frame, int link, int from, int to, int advance, bool* clear);
  void leave_out(Frame& frame, int link, int from, int to, const bool* clear);
  void add_crossings(const Frame& frame, int link, bool smoothed, const Rate* rate, int from, int to);
  EndPoint end_point(const Frame& frame, int at) const;
  void begin_counts();
  void clear_crossings();
  static constexpr int kProductsAPiece = 8;
  void read_sums(const Frame& frame, int boundary);
  void convert(int product);
  void close_weight(int dof, int weight, Batch& batch);
  void close_dof(int dof, Batch& batch) const;
  const Scaled& integral(int product) const;
  Scaled energy(const Incidence& incidence, int weight) const;
  Scaled friction_energy(const Incidence& incidence, int weight) const;
  Scaled kinetic_energy(int dof, int weight) const;
  Scaled shared_noise(int dof, int weight, Quantity quantity) const;

  const CoreConfiguration* configuration_ = nullptr;
  int weights_ = 1;
  // The small ones first: a short instruction reaches them.
  uint32_t samples_ = 0, closed_samples_ = 0;
  int converted_ = 0, closing_dof_ = 0, closing_weight_ = 0;  // what is done of the batch that is closed
  bool any_crossings_ = false, any_shared_noise_ = false;
  bool started_ = false;
  Scaled kinetic_end_, elastic_end_;  // of the DOF that is being closed
  EquationPlan plan_;
  Effects effects_;
  RowLayout layout_;
  ProductSums sums_;
  RateGains gains_[kMaxLinks];
  struct LinkUse {
    bool has_sign : 1;
    bool wants_clear_sign : 1;   // friction of a DOF whose equation is taken only where signs are clear
    bool wants_all_signs : 1;    // friction of a DOF whose equation is taken everywhere
    bool locates_crossings : 1;  // a DOF at the link has no measured acceleration
    bool smooth_is_white : 1;    // both velocities are measured: the noise of the two sign streams is known to scale
  };
  LinkUse use_[kMaxLinks];
  ClearSign clear_sign_[kMaxLinks];
  static constexpr int kSignFilters = kDerivesSignals ? kMaxLinks : 1;
  HighPassedSign high_passed_sign_[kSignFilters];
  LowPassedSign low_passed_sign_[kSignFilters];
  Crossing crossing_[kMaxTermIncidences][kWeights];
  // Of the batch that is closed: 24 times the sum with its ends, piece by piece turned into the integral in SI units.
  Scaled integral_[kMaxProducts];
  Scaled integral_unit_[kMaxProducts];  // of one twenty-fourth of a product sum
  EndPoint start_;
  EndPoint closed_start_, closed_end_;
  // Of the samples, in equations that leave samples out; where nothing is derived no noise is shared that it would matter for.
  static constexpr int kCounted = kDerivesSignals ? kMaxDofs : 1;
  uint32_t counted_[kCounted] = {}, closed_counted_[kCounted] = {};
};

}  // namespace firmware
