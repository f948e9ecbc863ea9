// Which products make up each DOF's energy equations: worked out once from the configuration.
#pragma once
#include "firmware/configuration/configuration.hpp"
#include "firmware/energy/batch_table.hpp"
#include "firmware/energy/product_sums.hpp"

namespace firmware {

struct WeightProducts {  // a product for each weight
  int16_t of[kWeights] = {};
  WeightProducts() {
    for (int16_t& product : of) product = kNoProduct;
  }
  int16_t& operator[](int weight) { return of[weight]; }
  int16_t operator[](int weight) const { return of[weight]; }
};

// One coefficient in one DOF's equation. Its energy per unit coefficient under weight q is
//   sign * (integral of q * column(a) - integral of q * column(b)); friction and effect terms have no b.
struct Incidence {
  uint8_t dof = 0;
  uint8_t term = 0;
  int8_t sign = 1;
  int16_t column_slot = -1;  // place among RowLayout::unknown, -1 where the coefficient is known
  uint16_t column_a = 0, column_b = 0;
  WeightProducts product_a, product_b;
  int16_t product_smooth = kNoProduct;  // instrument times the sign of the smoothed rate
};
constexpr int kMaxTermIncidences = 2 * kMaxTerms;

struct DofProducts {
  bool has_displacement = false, has_velocity = false, has_acceleration = false;
  // The equation is taken only where the signs of all friction at the DOF are clear (links/clear_sign.hpp).
  bool clear_signs_only = false;
  WeightProducts force, displacement, acceleration;  // q f, q x, q a
  int16_t velocity_square = kNoProduct, velocity_instrument = kNoProduct, acceleration_square = kNoProduct;
  int16_t weight_square = kNoProduct;  // weight of the velocity row times velocity
};

struct EquationPlan {
  Incidence incidence[kMaxTermIncidences];      // DOF by DOF, in the order of the terms
  uint16_t first_incidence[kMaxDofs + 1] = {};  // of a DOF
  int incidence_count = 0;
  DofProducts dof[kMaxDofs];
  Scaled column_unit[kMaxColumns];
};

// weights: how many of the Weight kinds are summed, from the first: 1 plain, 2 and the instrument, 3 and the displacement.
void make_equation_plan(const CoreConfiguration& configuration, int weights, EquationPlan& plan, ProductSums& sums,
                        RowLayout& layout);
// The column that weighs DOF i's equation.
int weight_column(const EquationPlan& plan, int i, int weight);

}  // namespace firmware
