// Where a driven rig rests, whose displacements count from anywhere.
#include "host_sim/programs/shared/rest_balance.hpp"

#include <cmath>
#include <cstdio>
#include <random>

#include "tests/host_sim/program_test.hpp"

namespace {

using host_sim::Channel;
using host_sim::Quantity;
using host_sim::Record;

// k1 = 100 N/m to the ground, k2 = 50 N/m between, no masses; constant forces of 3 N and 1 N beside what the motion takes.
//   K = (150 -50; -50 50), d = K^-1 (3, 1) = (50 * 3 + 50 * 1, 50 * 3 + 150 * 1) / (150 * 50 - 50 * 50) = (0.04, 0.06)
TEST(RestBalance, OfAChainIsWhereItsSpringsHoldTheMeanForces) {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(2);
  rig.links[0].a = 1, rig.links[0].b = rig_file::kGround, rig.links[0].stiffness_N_m.value = 100;
  rig.links[1].a = 1, rig.links[1].b = 2, rig.links[1].stiffness_N_m.value = 50;
  Record record;
  record.file = "held.csv", record.sample_period_s = 1e-3;
  std::vector<double> f1, f2, x1, x2;
  for (int i = 0; i < 4000; ++i) {
    x1.push_back(0.5 * std::sin(0.05 * i)), x2.push_back(0.5 * std::cos(0.07 * i));
    f1.push_back(3 + 150 * x1.back() - 50 * x2.back()), f2.push_back(1 - 50 * x1.back() + 50 * x2.back());
  }
  record.channels = {{"force_1_N", Quantity::kForce, 1, f1},
                     {"displacement_1_m", Quantity::kDisplacement, 1, x1},
                     {"force_2_N", Quantity::kForce, 2, f2},
                     {"displacement_2_m", Quantity::kDisplacement, 2, x2}};
  host_sim::SharedRecords records({record});
  ASSERT_TRUE(balance_rest(host_sim::MeanOf::kDriven, rig, {1, 3}, records));
  EXPECT_NEAR(records.get()[0].channels[1].values[7] - x1[7], 0.04, 1e-9);
  EXPECT_NEAR(records.get()[0].channels[3].values[7] - x2[7], 0.06, 1e-9);
  EXPECT_FALSE(balance_rest(host_sim::MeanOf::kDriven, rig, {1, 3}, records));  // it is there
  rig.links[0].stiffness_N_m.value = rig.links[1].stiffness_N_m.value = 0;      // nothing holds them any more
  EXPECT_FALSE(balance_rest(host_sim::MeanOf::kDriven, rig, {1, 3}, records));
}

// Two masses that float, 50 N/m between them and nothing to the ground, pulled apart by 2 N: K = (50 -50; -50 50), and of all d with
// K d = (2, -2) the smallest is (0.02, -0.02).
TEST(RestBalance, OfMassesThatFloatIsThatOfTheSpringBetweenThem) {
  rig_file::RigModel rig;
  rig.dofs.resize(2), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = 2, rig.links[0].stiffness_N_m.value = 50;
  Record record;
  record.file = "floats.csv", record.sample_period_s = 1e-3;
  std::vector<double> f1, f2, x1, x2;
  for (int i = 0; i < 4000; ++i) {
    x1.push_back(0.5 * std::sin(0.05 * i)), x2.push_back(0.5 * std::cos(0.07 * i));
    const double pull = 50 * (x1.back() - x2.back());
    f1.push_back(2 + pull), f2.push_back(-2 - pull);
  }
  record.channels = {{"force_1_N", Quantity::kForce, 1, f1},
                     {"displacement_1_m", Quantity::kDisplacement, 1, x1},
                     {"force_2_N", Quantity::kForce, 2, f2},
                     {"displacement_2_m", Quantity::kDisplacement, 2, x2}};
  host_sim::SharedRecords records({record});
  ASSERT_TRUE(balance_rest(host_sim::MeanOf::kDriven, rig, {1, 3}, records));
  EXPECT_NEAR(records.get()[0].channels[1].values[7] - x1[7], 0.02, 1e-9);
  EXPECT_NEAR(records.get()[0].channels[3].values[7] - x2[7], -0.02, 1e-9);
}

const char* const kRig =
    "schema = \"rig/1\"\nname = \"oscillator\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 400.0\nviscous_N_s_m = \"estimate\"\n";

// 1 kg, 400 N/m, 2 N s/m under fourteen tones of 1 to 8 Hz and a pull of 0.9 N, by fourth order Runge-Kutta; a distance sensor 0.35 m away
// reads it with 20 um of noise.
std::string pulled() {
  std::mt19937_64 random(3);
  std::normal_distribution<double> normal;
  const auto force = [](double t) {
    double sum = 0.9;
    for (int i = 0; i < 14; ++i) sum += 0.8 * std::sin(2 * M_PI * (1 + 0.51 * i) * t + i * i);
    return sum;
  };
  const auto slope = [&](double t, double x, double v) { return force(t) - 2 * v - 400 * x; };
  std::string text = "t_s,force_1_N,displacement_1_m\n";
  double x = 0.9 / 400, v = 0;
  const double h = 1e-3;
  for (int i = 0; i < 30000; ++i) {
    const double t = i * h;
    if (i % 2 == 0) {
      char row[96];
      std::snprintf(row, sizeof row, "%.3f,%.9g,%.9g\n", t, force(t) + 0.02 * normal(random),
                    0.35 + x + 2e-5 * normal(random));
      text += row;
    }
    const double a1 = slope(t, x, v), a2 = slope(t + h / 2, x + h / 2 * v, v + h / 2 * a1),
                 a3 = slope(t + h / 2, x + h / 2 * (v + h / 2 * a1), v + h / 2 * a2),
                 a4 = slope(t + h, x + h * (v + h / 2 * a2), v + h * a3);
    x += h * v + h * h / 6 * (a1 + a2 + a3), v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  return text;
}

class ZeroOfDisplacement : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("pulled.csv", pulled());
  }
};

// Counted from its mean alone, 2.2 mm from where it rests, the spring seems to pull with 0.9 N that nobody has put there.
TEST_F(ZeroOfDisplacement, IsNoForceThatTheEstimatesAreWithdrawnFor) {
  const auto result = host_sim({"estimate", "--rig", "rig.toml", "--data", "pulled.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  const auto out = json("out.json");
  EXPECT_NEAR(value(out, "viscous[1-0]"), 2.0, 0.03);
  EXPECT_EQ(out["parameters"][0]["status"], "VALID") << result.output;
  EXPECT_EQ(result.output.find("force_offset"), std::string::npos) << result.output;
  EXPECT_NE(result.output.find("never comes to its zero"), std::string::npos) << result.output;
}

TEST_F(ZeroOfDisplacement, IsNoForceThatTheRigFileLacks) {
  const auto result = host_sim({"diagnose", "--rig", "rig.toml", "--data", "pulled.csv", "--json", "out.json"});
  ASSERT_EQ(result.status, 0) << result.errors << result.output;
  EXPECT_EQ(json("out.json")["verdict"], "none") << result.output;
  EXPECT_NE(result.errors.find("never comes to its zero"), std::string::npos) << result.errors;
  EXPECT_NEAR(value(json("out.json")["baseline"], "viscous[1-0]"), 2.0, 0.02);
}

}  // namespace
