// Accelerometers behind a high-pass: undone where another channel shows it, and no delay where none does.
#include <cmath>
#include <random>

#include "host_sim/programs/estimate/channel_pairs.hpp"
#include "tests/host_sim/estimate_fixture.hpp"

namespace {

using estimate_test::Estimate;
using host_sim::Quantity;
using host_sim::Record;

constexpr double kTwoPi = 6.28318530717958647692;

// 2 kg on 800 N/m and 40 N s/m under a random force, 20 s at 500 Hz: leapfrog over 200 steps a sample, the force straight between samples. The
// acceleration y has passed y' + 2 pi corner y = a', by the trapezoid rule. Noise of 0.1 % of each channel's size.
Record driven(double corner_Hz) {
  std::mt19937 random(2);
  std::normal_distribution<double> noise;
  std::vector<double> f, x, v, a;
  double now = 0, place = 0, speed = 0, read = 0, last = 0;
  constexpr double h = 1e-5;
  for (int k = 0; k < 10000; ++k) {
    const double acceleration = (now - 800 * place - 40 * speed) / 2, half = 0.5 * kTwoPi * corner_Hz * 0.002;
    read = k == 0 ? acceleration : ((1 - half) * read + acceleration - last) / (1 + half), last = acceleration;
    f.push_back(now), x.push_back(place + 1e-5 * noise(random)), v.push_back(speed + 2e-4 * noise(random));
    a.push_back(read + 4e-3 * noise(random));
    const double next = 0.9 * now + 3 * noise(random);
    for (int i = 0; i < 200; ++i) {
      const double force = now + (next - now) * (i + 0.5) / 200, middle = place + 0.5 * h * speed;
      speed += h * (force - 800 * middle - 40 * speed) / 2;
      place = middle + 0.5 * h * speed;
    }
    now = next;
  }
  Record record;
  record.file = "driven.csv", record.sample_period_s = 2e-3;
  record.channels = {{"force_1_N", Quantity::kForce, 1, f},
                     {"displacement_1_m", Quantity::kDisplacement, 1, x},
                     {"velocity_1_m_s", Quantity::kVelocity, 1, v},
                     {"acceleration_1_m_s2", Quantity::kAcceleration, 1, a}};
  return record;
}

std::string table(const Record& record) {
  std::string text = "t_s";
  for (const auto& channel : record.channels) text += "," + channel.name;
  for (size_t k = 0; k < record.samples(); ++k) {
    char cell[40];
    std::snprintf(cell, sizeof cell, "\n%.3f", static_cast<double>(k) * record.sample_period_s);
    text += cell;
    for (const auto& channel : record.channels)
      std::snprintf(cell, sizeof cell, ",%.9g", channel.values[k]), text += cell;
  }
  return text + "\n";
}

// The high-pass takes 2 pi 0.3 Hz times the integral of the acceleration, a damper of 2 kg * 1.885 1/s = 3.77 N s/m too much.
TEST_F(Estimate, AHighPassThatTheVelocityShowsIsUndone) {
  workspace_.write("one.toml",
                   "schema = \"rig/1\"\nname = \"one\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
                   "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n");
  for (const double corner_Hz : {0.0, 0.3}) {
    workspace_.write("one.csv", table(driven(corner_Hz)));
    const auto result = host_sim({"estimate", "--rig", "one.toml", "--data", "one.csv", "--json", "out.json"});
    ASSERT_EQ(result.status, 0) << result.errors << result.output;
    EXPECT_NEAR(value(json("out.json"), "viscous[1-0]"), 40.0, 0.4) << result.output;
    const bool told = result.output.find("has passed a high-pass of 0.3") != std::string::npos;
    EXPECT_EQ(told, corner_Hz > 0) << result.output;
    EXPECT_EQ(result.output.find("early"), std::string::npos) << result.output;
  }
}

// Without a velocity: what leads by less the faster it is has passed a high-pass, and is no late displacement, which the equations of motion
// may well bear out: it made a damper 26 % too small, VALID. What leads by the same time at every frequency is one.
TEST(PairCorrections, TellAHighPassFromADelay) {
  for (const double corner_Hz : {0.05, 0.1, 0.3}) {
    Record leads = driven(corner_Hz);
    leads.channels.erase(leads.channels.begin() + 2);
    EXPECT_TRUE(host_sim::pair_corrections({leads}).empty()) << corner_Hz;
  }
  Record late = driven(0.0);
  late.channels.erase(late.channels.begin() + 2);
  std::vector<double>& x = late.channels[1].values;
  x.insert(x.begin(), x.front()), x.pop_back();  // by a sample, 2000 us
  const auto corrections = host_sim::pair_corrections({late});
  ASSERT_EQ(corrections.size(), 1u);
  EXPECT_EQ(corrections.front().channel, "displacement_1_m");
  EXPECT_NEAR(corrections.front().late_us, 2000, 200);
}

// 10 Hz of 1 mm and an acceleration that leads by 0.03 rad: 480 us, or a high-pass of 0.3 Hz. One tone does not tell.
TEST(PairCorrections, OfNoToneThatLeads) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise;
  Record tone = driven(0.0);
  tone.channels.erase(tone.channels.begin() + 2);
  for (size_t k = 0; k < tone.samples(); ++k) {
    const double phase = kTwoPi * 10 * 0.002 * static_cast<double>(k);
    tone.channels[1].values[k] = 1e-3 * std::sin(phase) + 1e-6 * noise(random);
    tone.channels[2].values[k] = -3.948 * std::sin(phase + 0.03) + 4e-3 * noise(random);
  }
  EXPECT_TRUE(host_sim::pair_corrections({tone}).empty());
}

// An acceleration may be late, and is not offered as early.
TEST(PairCorrections, OfferALateAcceleration) {
  Record late = driven(0.0);
  late.channels.erase(late.channels.begin() + 2);
  std::vector<double>& a = late.channels[2].values;
  a.insert(a.begin(), a.front()), a.pop_back();  // by a sample, 2000 us
  bool offered = false;
  for (const auto& correction : host_sim::pair_corrections({late}))
    if (correction.channel == "acceleration_1_m_s2") {
      offered = true;
      EXPECT_NEAR(correction.late_us, 2000, 200);
    }
  EXPECT_TRUE(offered);
}

}  // namespace
