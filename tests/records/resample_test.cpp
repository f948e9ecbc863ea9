// Samples at uneven times onto even steps.
#include "host_sim/records/times/resample.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace {

using host_sim::DataFileError;
using host_sim::Record;
using host_sim::resampled;

Record made(const std::vector<double>& time_s, double (*of)(double)) {
  Record record;
  record.file = "made.csv";
  record.time_s = time_s;
  record.channels.push_back({"displacement_1_m", host_sim::Quantity::kDisplacement, 1, {}});
  for (const double t : time_s) record.channels[0].values.push_back(of(t));
  return record;
}

// Every 10 ms, each up to 3 ms early or late.
std::vector<double> uneven_times(size_t count) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> late(-0.003, 0.003);
  std::vector<double> time_s(count);
  for (size_t i = 0; i < count; ++i) time_s[i] = 0.01 * static_cast<double>(i) + late(random);
  return time_s;
}

TEST(Resample, APolynomialOfFifthDegreeIsExact) {
  const auto of = [](double t) { return 1 - t + t * t * (2 - t * (1 - t * (3 - t))); };
  const auto records = resampled(made(uneven_times(200), of), 100.0);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].sample_period_s, 0.01);
  ASSERT_GE(records[0].samples(), 198u);
  for (size_t i = 0; i < records[0].samples(); ++i)
    EXPECT_NEAR(records[0].channels[0].values[i], of(records[0].start_s + 0.01 * static_cast<double>(i)), 1e-10) << i;
}

// 1 Hz at 100 rows a second, every seventh row with a second one 50 us behind it, all within 0.003. What lies between two rows whose
// polynomial passes through that pair would be off by the noise times 200 and more; two rows alone are off by their noise, and by
// (w h)^2 / 8 = 0.0005 of the height.
TEST(Resample, RowsThatNearlyCoincideMakeNoSpikes) {
  std::mt19937 random(6);
  std::uniform_real_distribution<double> noise(-0.003, 0.003);
  Record record = made({}, nullptr);
  for (int i = 0; i < 700; ++i)
    for (const double later : {0.0, 5e-5}) {
      if (later > 0.0 && i % 7 != 3) continue;
      record.time_s.push_back(0.01 * i + later);
      record.channels[0].values.push_back(std::sin(2 * M_PI * record.time_s.back()) + noise(random));
    }
  const Record even = resampled(record, 110.0).at(0);
  for (size_t i = 0; i < even.samples(); ++i)
    EXPECT_NEAR(even.channels[0].values[i], std::sin(2 * M_PI * static_cast<double>(i) / 110.0), 3 * 0.003 + 0.0005)
        << i;
}

TEST(Resample, ASineOfEightSamplesAPeriodIsRightToATenthOfAPercent) {
  // Error of six points at steps h, in the middle: (0.5 1.5 2.5)^2 / 6! (w h)^6 = 0.00488 * 0.785^6 = 0.0011.
  const auto of = [](double t) { return std::sin(2 * M_PI * 12.5 * t); };
  std::vector<double> time_s(400);
  for (size_t i = 0; i < time_s.size(); ++i) time_s[i] = 0.01 * static_cast<double>(i);
  const Record record = resampled(made(time_s, of), 250.0).at(0);
  double worst = 0;
  for (size_t i = 10; i + 10 < record.samples(); ++i)  // inside, where there are three samples on both sides
    worst = std::max(worst, std::abs(record.channels[0].values[i] - of(0.004 * static_cast<double>(i))));
  EXPECT_LT(worst, 0.00115);
  EXPECT_GT(worst, 0.0005);  // it is this formula's error and no other's
}

TEST(Resample, AFlatTopStaysFlat) {
  // 5 Hz of height 1, cut at 0.9: of its 20 samples a period sin > 0.9 for 2 acos(0.9) / (2 pi) = 0.144 of it, 2.9 samples.
  const Record record = resampled(
      made(uneven_times(400), [](double t) { return std::clamp(std::sin(2 * M_PI * 5 * t), -2.0, 0.9); }), 100.0)[0];
  const std::vector<double>& y = record.channels[0].values;
  EXPECT_EQ(*std::max_element(y.begin(), y.end()), 0.9);
  EXPECT_GT(std::count(y.begin(), y.end(), 0.9), 30);        // 20 tops
  EXPECT_LT(*std::min_element(y.begin(), y.end()), -0.987);  // cos(pi / 20): a sample on each side of the turn
}

// What rests is as still as before: rounding would part its longest rest into hundreds, each an end of the channel's range.
TEST(Resample, ARestStaysARest) {
  const auto of = [](double t) { return t < 1.0 ? 0.1 * std::sin(0.5 * M_PI * t) : 0.1; };
  const std::vector<double> y = resampled(made(uneven_times(400), of), 100.0)[0].channels[0].values;
  EXPECT_EQ(std::count(y.begin() + 104, y.end(), 0.1), static_cast<std::ptrdiff_t>(y.size()) - 104);
}

TEST(Resample, ATurnBetweenTwoEqualSamplesIsNotCutOff) {
  // Eight samples a period at odd sixteenths: the highest are two in a row, at cos(pi / 8) = 0.924 of the height.
  std::vector<double> time_s(400);
  for (size_t i = 0; i < time_s.size(); ++i) time_s[i] = 0.01 * static_cast<double>(i);
  const auto of = [](double t) { return std::sin(2 * M_PI * 12.5 * (t + 0.005)); };
  const std::vector<double> y = resampled(made(time_s, of), 200.0).at(0).channels[0].values;
  EXPECT_NEAR(*std::max_element(y.begin() + 10, y.end() - 10), 1.0, 0.00115);
}

TEST(Resample, WholeMillisecondsAreNoJitter) {
  // 0.4 Hz of 1 rad, every 10.04 ms, stamped in whole milliseconds, now and then a sample lost: at 2.5 rad/s half a
  // millisecond would be 1.3 mrad. Six points miss (0.5 1.5 2.5)^2 / 6! (w h)^6 = 1.3e-12 where none is lost.
  const auto of = [](double t) { return std::sin(2 * M_PI * 0.4 * t); };
  Record record = made({}, of);
  for (int i = 0; i < 2000; ++i) {
    if (i % 301 == 300) continue;
    record.time_s.push_back(1e-3 * std::floor(10.04 * i));
    record.channels[0].values.push_back(of(0.01004 * i));
  }
  const Record even = resampled(record, 100.0).at(0);
  for (size_t i = 0; i < even.samples(); ++i)
    // the line through the stamps is half a millisecond early: a shift of all samples, which is no noise
    EXPECT_NEAR(even.channels[0].values[i], of(even.start_s + 0.01 * static_cast<double>(i) + 0.0005), 5e-5) << i;
}

TEST(Resample, AGapPartsTheRecord) {
  std::vector<double> time_s;
  for (int i = 0; i < 400; ++i) {
    const bool two_lost = i == 50 || i == 51, ten_lost = i >= 200 && i < 210, alone = i >= 240 && i < 250;
    if (!two_lost && !ten_lost && !alone) time_s.push_back(0.01 * i);
  }
  const auto of = [](double t) { return std::sin(6 * t); };
  const auto records = resampled(made(time_s, of), 100.0);  // 0 to 1.99 s; 2.10 to 2.39, too short; 2.50 to 3.99 s
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0].samples(), 200u);
  EXPECT_EQ(records[1].samples(), 150u);
  EXPECT_DOUBLE_EQ(records[1].start_s, 2.5);
  EXPECT_EQ(records[1].file, "made.csv, part 2");
  for (size_t i = 0; i < 200; ++i)
    EXPECT_NEAR(records[0].channels[0].values[i], of(0.01 * static_cast<double>(i)), 1e-6) << i;
  ASSERT_EQ(records[0].notes.size(), 1u);
  EXPECT_NE(records[0].notes[0].find("in 2 parts between gaps: 350 samples of 378"), std::string::npos)
      << records[0].notes[0];
}

TEST(Resample, ALowerRateIsRefused) {
  const Record record = made(uneven_times(200), [](double t) { return t; });
  EXPECT_THROW(resampled(record, 50.0), DataFileError);
  EXPECT_NO_THROW(resampled(record, 97.0));  // the usual step is not known to a percent
  EXPECT_THROW(resampled(made(uneven_times(20), [](double t) { return t; }), 100.0), DataFileError);  // too short
}

TEST(Resample, TheReaderKeepsTheTimesOnlyWhereAsked) {
  const std::string text = "t_s,displacement_1_m\n0,1\n0.01,2\n0.025,3\n0.03,4\n";
  try {
    host_sim::parse_csv(text, "d.csv", {});
    ADD_FAILURE() << "taken";
  } catch (const DataFileError& error) {
    EXPECT_EQ(error.line, 4u);
    EXPECT_NE(error.problem.find("--resample 100 interpolates"), std::string::npos) << error.problem;
  }
  host_sim::ReadingOptions options;
  options.resample_Hz = 100.0;
  EXPECT_EQ(host_sim::parse_csv(text, "d.csv", {}, options).time_s, (std::vector<double>{0, 0.01, 0.025, 0.03}));
  try {
    std::string twice = "t_s,displacement_1_m\n0,1\n0.01,2\n0.01,3\n";
    for (int i = 2; i < 40; ++i) twice += std::to_string(0.01 * i) + ",4\n";
    host_sim::parse_csv(twice, "d.csv", {}, options);
    ADD_FAILURE() << "taken";
  } catch (const DataFileError& error) {
    EXPECT_EQ(error.line, 4u);
    EXPECT_NE(error.problem.find("expected times that rise: two rows have one time"), std::string::npos)
        << error.problem;
  }
}

// Times that fall by a row were exchanged; by forty rows the clock began anew. Whether they are to be interpolated or not.
TEST(Resample, RowsThatAreExchangedAreNoNewRecording) {
  const auto told = [](const std::vector<int>& row, double resample_Hz) {
    std::string text = "t_s,displacement_1_m\n";
    for (const int i : row) text += std::to_string(0.01 * i) + "," + std::to_string(i % 7) + "\n";
    host_sim::ReadingOptions options;
    if (resample_Hz > 0) options.resample_Hz = resample_Hz;
    try {
      host_sim::parse_csv(text, "d.csv", {}, options);
      return std::string("taken");
    } catch (const DataFileError& error) {
      return error.problem;
    }
  };
  std::vector<int> exchanged, anew;
  for (int i = 0; i < 80; ++i) exchanged.push_back(i == 40 ? 41 : i == 41 ? 40 : i), anew.push_back(i % 40);
  for (const double resample_Hz : {0.0, 100.0}) {
    EXPECT_NE(told(exchanged, resample_Hz).find("not in the order of time: sort them"), std::string::npos);
    EXPECT_NE(told(anew, resample_Hz).find("the clock starts anew in line 42"), std::string::npos);
  }
  // a row is lost long before the clock starts anew: the head's line, rows 0 to 9 and 11 to 59 in lines 2 to 60
  std::vector<int> lost;
  for (int i = 0; i < 120; ++i)
    if (i != 10) lost.push_back(i % 60);
  EXPECT_NE(told(lost, 0.0).find("steps by 0.02 s"), std::string::npos) << told(lost, 0.0);
  EXPECT_NE(told(lost, 0.0).find("the clock starts anew in line 61"), std::string::npos) << told(lost, 0.0);
}

// Two seconds at 1e9 a second were 2e9 samples, 16 GB for each channel.
TEST(Resample, ARateThatNoMemoryHoldsIsRefused) {
  try {
    resampled(made(uneven_times(200), [](double t) { return t; }), 1e9);
    ADD_FAILURE() << "taken";
  } catch (const DataFileError& error) {
    EXPECT_NE(error.problem.find("expected a rate that makes 1e+08 at the most"), std::string::npos) << error.problem;
  }
}

// A serial port's rows in packets of four: their clock is that of their arrival, and no interpolation puts that right.
TEST(Resample, TimesOfArrivalAskForTheSampleRate) {
  std::string text = "t_s,displacement_1_m\n";
  for (int i = 0; i < 40; ++i) text += std::to_string(0.016 * (i / 4)) + "," + std::to_string(i % 7) + "\n";
  for (const double resample_Hz : {0.0, 250.0}) {
    host_sim::ReadingOptions options;
    if (resample_Hz > 0) options.resample_Hz = resample_Hz;
    try {
      host_sim::parse_csv(text, "d.csv", {}, options);
      ADD_FAILURE() << "taken";
    } catch (const DataFileError& error) {
      EXPECT_NE(error.problem.find("30 of 40 rows bear the time of the row before"), std::string::npos)
          << error.problem;
      EXPECT_NE(error.problem.find("--sample-rate"), std::string::npos) << error.problem;
      EXPECT_NE(error.problem.find("270.8 a second"), std::string::npos) << error.problem;  // 39 steps in 9 * 0.016 s
      EXPECT_EQ(error.problem.find("interpolates"), std::string::npos) << error.problem;
    }
  }
}

// A wheel whose revolutions are timed: the angle is exact where it is read, and between rows it is a line. An encoder that is read at
// uneven times has its step as resolution.
TEST(Resample, RowsThatCountMarksHaveNoResolution) {
  Record wheel = made(uneven_times(200), [](double) { return 0.0; });
  Record encoder = wheel;
  for (size_t i = 0; i < 200; ++i) {
    wheel.channels[0].values[i] = 0.5 * static_cast<double>(i);
    encoder.channels[0].values[i] = 0.5 * std::round(3 * std::sin(0.1 * static_cast<double>(i)));
  }
  EXPECT_EQ(resampled(wheel, 100.0)[0].channels[0].recorded_step, 0.0);
  EXPECT_NEAR(resampled(encoder, 100.0)[0].channels[0].recorded_step, 0.5, 1e-9);
}

// 0.2 Hz and 0.53 Hz, read every 10 and 12 ms, or 10 and 11 ms, in turn. Half a millisecond times up to 2.6 rad/s were 1.3 mrad of noise; six
// points at 0.012 s miss next to nothing of it, and a clock of whole milliseconds that reads 10.5 ms makes the same times.
TEST(Resample, StepsThatAlternateAreNoRounding) {
  const auto of = [](double t) { return std::sin(0.4 * M_PI * t) + 0.4 * std::sin(1.06 * M_PI * t + 1); };
  for (const double longer_s : {0.012, 0.011}) {
    std::vector<double> time_s = {0.0};
    while (time_s.size() < 2000) time_s.push_back(time_s.back() + (time_s.size() % 2 == 0 ? longer_s : 0.010));
    const Record even = resampled(made(time_s, of), 100.0).at(0);
    for (size_t i = 0; i < even.samples(); ++i)
      EXPECT_NEAR(even.channels[0].values[i], of(even.start_s + 0.01 * static_cast<double>(i)), 1e-8) << longer_s << i;
    // Sampled every 10.5 ms, or 11 ms, and stamped so: the line through the stamps is right but for a shift of a quarter of a step's change.
    if (longer_s > 0.011) continue;
    Record stamped = made(time_s, of);
    for (size_t i = 0; i < time_s.size(); ++i) stamped.channels[0].values[i] = of(0.0105 * static_cast<double>(i));
    const Record ticks = resampled(stamped, 100.0).at(0);
    for (size_t i = 0; i < ticks.samples(); ++i)
      EXPECT_NEAR(ticks.channels[0].values[i], of(ticks.start_s + 0.01 * static_cast<double>(i) + 0.00025), 1e-6) << i;
  }
}

}  // namespace
