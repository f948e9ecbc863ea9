// Where a free decay begins in its recording.
#include "host_sim/data_check/decay/release.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <random>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/decay/free_decays.hpp"
#include "host_sim/data_check/windows/decay_in.hpp"

namespace {

using host_sim::Quantity;
using host_sim::Record;

constexpr double kPi = 3.14159265358979323846, kTurn = 2 * kPi * 3.0;  // 3 Hz
constexpr size_t kPeriod = 33;                                         // samples at 100 Hz

// Where the only decay begins; 0 where it is the whole record, or none is found.
size_t samples_before_release(const Record& record) {
  const auto decays = host_sim::data_check::free_decays(record);
  EXPECT_LE(decays.size(), 1u);
  if (decays.empty()) return 0;
  EXPECT_EQ(decays[0].to, record.samples());
  return decays[0].from;
}

// 12 s at 100 Hz of y(t) with noise of 1 % of one.
Record record_of(const std::function<double(double)>& y, Quantity quantity = Quantity::kDisplacement, double s = 12) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0.0, 0.01);
  constexpr const char* kNames[] = {"force_1_N", "displacement_1_m", "velocity_1_m_s", "acceleration_1_m_s2"};
  Record record;
  record.file = "made.csv", record.sample_period_s = 0.01;
  record.channels.push_back({kNames[static_cast<int>(quantity)], quantity, 1, {}});
  for (int i = 0; i < static_cast<int>(100 * s); ++i) record.channels[0].values.push_back(y(0.01 * i) + noise(random));
  return record;
}
double decay(double t, double tau_s) { return std::exp(-t / tau_s) * std::cos(kTurn * t); }

TEST(Release, OfADecayFromItsFirstSampleTakesNothing) {
  for (const double tau_s : {0.5, 2.0, 10.0, 500.0})
    for (const double zero : {0.0, 7.0}) {
      const auto y = [=](double t) { return zero + decay(t + 0.05, tau_s); };
      EXPECT_EQ(samples_before_release(record_of(y)), 0u) << tau_s;
      EXPECT_EQ(samples_before_release(record_of(y, Quantity::kAcceleration)), 0u) << tau_s;
    }
}

// Dry friction takes the same from each swing: 1 - t / 4 s.
TEST(Release, OfADecayThatStopsTakesNothing) {
  EXPECT_EQ(samples_before_release(record_of([](double t) { return std::max(0.0, 1 - t / 4) * std::cos(kTurn * t); })),
            0u);
}

// A mode of 40 Hz that is gone after 2 s and one of 3 Hz and a third of it that loses half in 14 s, 10 s at 500 Hz. A period is 16 samples by
// the many fast swings, 166 in the end: the mean square over 16 is that of a piece of the slow swing then, next to nothing at its turns.
TEST(Release, OfASlowModeThatOutlivesAFastOneTakesNothing) {
  Record record = record_of(
      [](double t) {
        return std::exp(-t / 5) * std::cos(2 * kPi * 8 * t) + 0.35 * std::exp(-t / 100) * std::cos(2 * kPi * 0.6 * t);
      },
      Quantity::kAcceleration, 50);
  record.sample_period_s = 0.002;  // all five times as fast
  EXPECT_EQ(host_sim::data_check::find_release(record), std::nullopt);
}

// 30 windows that lose a hundredth each, by 1.35 in all. A rise by a fourth is a blow, and what loses a thousandth each is no decay.
TEST(Release, EnergyFallsThroughout) {
  const auto falls = [](double loss, double rise) {
    host_sim::data_check::Windows energy;
    for (int i = 0; i < 30; ++i) energy.push_back((i < 20 ? 1 : rise) * std::pow(1 - loss, i));
    return host_sim::data_check::falls_throughout(energy);
  };
  EXPECT_TRUE(falls(0.01, 1.0));
  EXPECT_FALSE(falls(0.01, 1.3));
  EXPECT_FALSE(falls(0.001, 1.0));
}

// Let go at 1.5 s: after that, and no more than one and a half periods after.
void expect_release(const Record& record, const char* what) {
  const size_t led = samples_before_release(record);
  EXPECT_GT(led, 150u) << what;
  EXPECT_LE(led, 150 + 3 * kPeriod / 2) << what;
}

TEST(Release, IsFoundBehindAHandAPullAndABlow) {
  const auto free = [](double t) { return decay(t - 1.5, 3); };
  expect_release(record_of([&](double t) { return t < 1.5 ? 0.6 * std::sin(5 * t) : free(t); }), "a hand");
  expect_release(record_of([&](double t) { return t < 1.5 ? std::min(1.0, 2 * t) : free(t); }), "a pull");
  expect_release(
      record_of([&](double t) { return t < 1.5 ? 0.0 : std::exp((1.5 - t) / 3) * std::sin(kTurn * (t - 1.5)); }),
      "a blow");
  // an accelerometer shows the blow itself: 20 ms, five times as much as what follows
  const Record blow =
      record_of([&](double t) { return t < 1.5    ? 0.0
                                       : t < 1.52 ? 5.0
                                                  : free(t); }, Quantity::kAcceleration);
  expect_release(blow, "a blow seen by an accelerometer");
}

// A short decay, six periods until a hundredth of its energy is left, loses half a period.
TEST(Release, OfAShortDecayCostsHalfAPeriod) {
  const size_t led =
      samples_before_release(record_of([](double t) { return t < 1.5 ? 0.6 * std::sin(5 * t) : decay(t - 1.5, 0.8); }));
  EXPECT_GT(led, 150u);
  EXPECT_LE(led, 150 + kPeriod);
}

// Of a long decay little is recorded: in the 10.5 s the energy falls to exp(-2 * 10.5 / tau), 0.35 for 20 s and 0.50 for 30 s.
TEST(Release, OfALongDecayIsFoundBeforeItHasHalved) {
  for (const double tau_s : {20.0, 30.0}) {
    const auto free = [=](double t) { return decay(t - 1.5, tau_s); };
    expect_release(record_of([&](double t) { return t < 1.5 ? std::min(1.0, 2 * t) : free(t); }), "a pull");
    expect_release(record_of([&](double t) { return t < 1.5 ? 0.6 * std::sin(5 * t) : free(t); }), "a hand");
  }
}

// What an unrecorded coil keeps swinging, at once or after it has overshot by a fifth (energy 1.44), is none.
TEST(Release, IsNotFoundWhereAMotionIsKeptUp) {
  const auto kept = [](double overshoot) {
    return [=](double t) {
      return t < 1.5 ? 0.0 : (1 + overshoot * std::exp(-(t - 1.5) / 1.5)) * std::sin(kTurn * (t - 1.5));
    };
  };
  EXPECT_EQ(samples_before_release(record_of(kept(0.0))), 0u);
  EXPECT_EQ(samples_before_release(record_of(kept(0.2))), 0u);
}

TEST(Release, IsNotFoundWhereNothingDecays) {
  std::mt19937 random(9);
  std::normal_distribution<double> normal;
  double x = 0, v = 0;  // wind: ambient vibration never dies away
  const Record ambient = record_of([&](double) {
    for (int k = 0; k < 10; ++k) v += 1e-3 * (-kTurn * kTurn * x - 0.6 * v) + 0.3 * normal(random), x += 1e-3 * v;
    return 10 * x;
  });
  EXPECT_EQ(samples_before_release(ambient), 0u);
  EXPECT_EQ(samples_before_release(record_of([](double t) { return std::exp((t - 12) / 3) * std::cos(kTurn * t); })),
            0u);
  // the swing of two that beat comes back, and never higher than it was
  const auto beats = [](double t) { return std::exp(-t / 4) * std::cos(kTurn * t) * std::cos(2.2 * t); };
  EXPECT_EQ(samples_before_release(record_of(beats)), 0u);
}

// Where a force is recorded the rig follows it from the first sample on.
TEST(Release, IsNotLookedForWhereSomethingDrives) {
  Record record = record_of([](double t) { return t < 1.5 ? 0.0 : decay(t - 1.5, 3); });
  ASSERT_GT(samples_before_release(record), 0u);
  record.channels.push_back({"force_1_N", Quantity::kForce, 1, std::vector<double>(1200, 0.0)});
  EXPECT_GT(samples_before_release(record), 0u);  // of noughts
  record.channels[1].values[150] = 4;
  EXPECT_EQ(samples_before_release(record), 0u);
}

// Blows at 0.5, 4 and 8 s, each as loud as the first: three records, each ending before the next blow. The swings that are left
// (exp(-3.5 / 1.5) = 0.1) are a tenth of what is added.
TEST(Release, OfSeveralBlowsMakesSeveralRecords) {
  const double at[] = {0.5, 4.0, 8.0};
  const auto y = [&](double t) {
    double sum = 0;
    for (const double blow : at)
      if (t > blow) sum += std::exp((blow - t) / 1.5) * std::sin(kTurn * (t - blow));
    return sum;
  };
  std::vector<Record> records = {record_of(y)};
  ASSERT_EQ(host_sim::data_check::keep_decays(records).size(), 1u);
  ASSERT_EQ(records.size(), 3u);
  for (size_t i = 0; i < 3; ++i) {
    const double end_s = records[i].start_s + 0.01 * static_cast<double>(records[i].samples());
    EXPECT_GT(records[i].start_s, at[i]);
    EXPECT_LE(records[i].start_s, at[i] + 0.01 * 3 * kPeriod / 2);
    EXPECT_LE(end_s, i < 2 ? at[i + 1] : 12.0);
    EXPECT_GE(end_s, (i < 2 ? at[i + 1] : 12.0) - 0.01 * 1.5 * kPeriod);
  }
  EXPECT_EQ(records[2].file, "made.csv, decay 3");
}

// 5 Hz, blows of one.
double after_blow(double t, double tau_s) { return t < 0 ? 0.0 : std::exp(-t / tau_s) * std::sin(2 * kPi * 5.0 * t); }

// Before a trigger at 5 s something of 5 % of the blow dies away: a quarter of a hundredth of its energy.
TEST(Release, IsNotFoundInTheRestBeforeABlow) {
  const auto y = [](double t) {
    return after_blow(t - 5, 1) + 0.05 * std::exp(-t / 1.5) * std::cos(2 * kPi * 5.0 * t);
  };
  std::vector<Record> records = {record_of(y)};
  const auto told = host_sim::data_check::keep_decays(records);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_GT(records[0].start_s, 5.0);
  EXPECT_NE(told.at(0).find("at rest or too short"), std::string::npos) << told[0];
}

// 1.2 s between two blows are six periods, less one that is lost and one that reaches into the next blow: 80 to 110 samples, of
// which nothing can be told. The second one has 10 s.
TEST(Release, IsDroppedWhereItIsTooShortBesideALongOne) {
  std::vector<Record> records = {record_of([](double t) { return after_blow(t - 0.5, 0.6) + after_blow(t - 1.7, 2); })};
  const auto told = host_sim::data_check::keep_decays(records);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_GT(records[0].start_s, 1.7);
  EXPECT_NE(told.at(0).find("at rest or too short"), std::string::npos) << told[0];
}

// Not more than eight records come of one call, and no file loses all of its own.
TEST(Release, OfMoreThanEightBlowsKeepsEight) {
  const auto y = [](double t) {
    double sum = 0;
    for (int i = 0; i < 12; ++i)
      if (t > 3 * i + 0.5) sum += std::exp((3 * i + 0.5 - t) / 0.6) * std::sin(kTurn * (t - 3 * i - 0.5));
    return sum;
  };
  std::vector<Record> records = {record_of(y, Quantity::kDisplacement, 36), record_of(y, Quantity::kDisplacement, 36)};
  host_sim::data_check::keep_decays(records);
  EXPECT_EQ(records.size(), 8u);
  EXPECT_LT(records.back().start_s, 1.5);  // the second file's first
}

TEST(Release, RecordsBeginThereAndSaySo) {
  std::vector<Record> records = {record_of([](double t) { return decay(t, 3); }), record_of([](double t) {
                                   return t < 1.5 ? std::min(1.0, 2 * t) : decay(t - 1.5, 3);
                                 })};
  const std::vector<Record> before = records;
  const auto told = host_sim::data_check::keep_decays(records);
  ASSERT_EQ(told.size(), 1u);
  EXPECT_EQ(told[0].rfind("made.csv: decays freely from 1.", 0), 0u) << told[0];
  EXPECT_EQ(records[0].samples(), before[0].samples());
  const size_t led = before[1].samples() - records[1].samples();
  EXPECT_NEAR(records[1].start_s, 0.01 * static_cast<double>(led), 1e-12);
  EXPECT_EQ(records[1].channels[0].values.front(), before[1].channels[0].values[led]);
}

// An hour into a logger's day, to a hundredth of a second: not "3.6e+03".
TEST(Release, IsToldInTheRecordsOwnTime) {
  Record record = record_of([](double t) { return t < 1.5 ? std::min(1.0, 2 * t) : decay(t - 1.5, 3); });
  record.start_s = 3600;
  const auto decays = host_sim::data_check::free_decays(record);
  ASSERT_EQ(decays.size(), 1u);
  char from[32];
  std::snprintf(from, sizeof from, "from %.2f", 3600 + 0.01 * static_cast<double>(decays[0].from));
  const std::string told = host_sim::data_check::find_release(record)->detail, want = from;
  const size_t zeros = want.find_last_not_of('0') + 1;
  EXPECT_NE(told.find(want.substr(0, zeros)), std::string::npos) << told;
  EXPECT_NE(told.find(" to 3612 s"), std::string::npos) << told;
}

}  // namespace
