// A chain 0 - 1 - 2 whose first mass is driven: what a mass of open scale does to the numbers beside it. Statuses by hand.
#include "firmware/identification/conditions/open_scale.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace {

using firmware::EstimateStatus;
using firmware::TermKind;

// Unknowns: 0 to 2 the masses, 3 and 4 the springs 0 - 1 and 1 - 2, 5 a damper of mass 0 and ground.
struct Chain {
  std::unique_ptr<firmware::CoreConfiguration> configuration = std::make_unique<firmware::CoreConfiguration>();
  firmware::EquationList list;
  firmware::Estimates estimates;
  Chain() {
    firmware::CoreConfiguration& c = *configuration;
    c.dof_count = 3, c.link_count = 3, c.unknown_count = 6;
    c.channels[0][static_cast<int>(firmware::Quantity::kForce)].present = true;
    c.links[0].node_a = 0, c.links[0].node_b = 1;
    c.links[1].node_a = 1, c.links[1].node_b = 2;
    c.links[2].node_a = 0, c.links[2].node_b = firmware::kGroundNode;
    for (uint8_t d = 0; d < 3; ++d) add(TermKind::kMass, d);
    add(TermKind::kStiffness, 0), add(TermKind::kStiffness, 1), add(TermKind::kViscous, 2);
    list.dof_count = 3;
    list.neighbours[0] = 0b011, list.neighbours[1] = 0b111, list.neighbours[2] = 0b110;
    estimates.unknown_count = 6;
    for (int k = 0; k < 6; ++k) estimates.parameters[k].status = EstimateStatus::kValid;
  }
  void add(TermKind kind, uint8_t place) {
    firmware::Term& term = configuration->terms[configuration->term_count];
    term.kind = kind, term.place = place, term.unknown = static_cast<int8_t>(configuration->term_count++);
  }
  void not_found(int unknown) { estimates.parameters[unknown].status = EstimateStatus::kIllConditioned; }
  // v: VALID, b: BIAS_SUSPECT, i: ILL_CONDITIONED
  std::string told() {
    firmware::doubt_beside_open_scale(*configuration, list, estimates);
    std::string text;
    for (int k = 0; k < 6; ++k)
      text += estimates.parameters[k].status == EstimateStatus::kValid         ? 'v'
              : estimates.parameters[k].status == EstimateStatus::kBiasSuspect ? 'b'
                                                                               : 'i';
    return text;
  }
};

TEST(OpenScale, WhereAllMassesAreFoundNothingIsDoubted) { EXPECT_EQ(Chain().told(), "vvvvvv"); }

// Mass 1 is not found and no force is measured on it: its springs carry anything into the equations of 0 and 2.
TEST(OpenScale, BendsTheNeighbours) {
  Chain chain;
  chain.not_found(1);
  EXPECT_EQ(chain.told(), "bibbbb");
}

// Mass 2 joins mass 1 alone: mass 0 and its damper are as they were, but for the spring that they share with mass 1.
TEST(OpenScale, EndsWithTheNeighbours) {
  Chain chain;
  chain.not_found(2);
  EXPECT_EQ(chain.told(), "vbibbv");
}

// A force on it, or one known number, sets its scale.
TEST(OpenScale, IsSetByAForceOrAKnownNumber) {
  Chain forced;
  forced.not_found(1);
  forced.configuration->channels[1][static_cast<int>(firmware::Quantity::kForce)].present = true;
  EXPECT_EQ(forced.told(), "vivvvv");
  Chain known;
  known.not_found(1);
  known.configuration->terms[4].unknown = -1;
  EXPECT_EQ(known.told(), "vivvvv");
  Chain driven;
  driven.not_found(0);
  EXPECT_EQ(driven.told(), "ivvvvv");
}

}  // namespace
