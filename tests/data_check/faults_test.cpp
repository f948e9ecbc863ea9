// Every mistake of a sensor, a cable or a unit is called by its name and weighs what it does; table-driven.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "host_sim/data_check/data_check.hpp"
#include "host_sim/data_check/flat/clipping.hpp"
#include "host_sim/data_check/report/to_json.hpp"
#include "tests/data_check/made_records.hpp"

namespace {

using host_sim::Record;
using host_sim::data_check::check;
using host_sim::data_check::find_clipping;
using host_sim::data_check::Finding;
using host_sim::data_check::Report;
using host_sim::data_check::statistics_of;
using host_sim::data_check::to_json;
using host_sim::data_check::Weight;

struct Fault {
  const char* name;
  made::Options options;
  std::function<void(Record&)> spoil;
  const char* kind;
  const char* channel;
  bool with_rig = true;
  const char* says = "";
};

std::function<void(Record&)> times(const std::string& channel, double factor) {
  return [=](Record& record) {
    for (double& value : made::values(record, channel)) value *= factor;
  };
}
std::function<void(Record&)> all_times(char quantity, double factor) {  // 'd', 'v', 'a', 'f'
  return [=](Record& record) {
    for (host_sim::Channel& channel : record.channels)
      if (channel.name[0] == quantity)
        for (double& value : channel.values) value *= factor;
  };
}
std::function<void(Record&)> exchange(const std::string& one, const std::string& other) {
  return [=](Record& record) { std::swap(made::values(record, one), made::values(record, other)); };
}
std::function<void(Record&)> set(const std::string& channel, double constant) {
  return [=](Record& record) {
    for (double& value : made::values(record, channel)) value = constant;
  };
}
std::function<void(Record&)> spike(const std::string& channel, size_t at, double size) {
  return [=](Record& record) { made::values(record, channel)[at] += size; };
}
// At `share` of the largest value.
std::function<void(Record&)> clip(const std::string& channel, double share) {
  return [=](Record& record) {
    std::vector<double>& values = made::values(record, channel);
    double largest = 0.0;
    for (const double value : values) largest = std::max(largest, std::abs(value));
    for (double& value : values) value = std::clamp(value, -share * largest, share * largest);
  };
}

made::Options with(const std::string& sensors, made::Drive drive = made::Drive::kRandom, double noise = 1e-3) {
  made::Options options;
  options.sensors = sensors;
  options.drive = drive;
  options.noise = noise;
  return options;
}

const Finding* find(const Report& report, const std::string& kind, const std::string& channel) {
  for (const auto& record : report.records)
    for (const auto& of : record.channels)
      for (const Finding& finding : of.findings)
        if (finding.kind == kind && of.name == channel) return &finding;
  return nullptr;
}

std::string all_of(const Report& report) {
  std::string text;
  for (const std::string& line : host_sim::data_check::lines_of(report, Weight::kInforms)) text += line + "\n";
  return text;
}

const char* const kX1 = "displacement_1_m";
const char* const kV1 = "velocity_1_m_s";
const char* const kA1 = "acceleration_1_m_s2";
const char* const kA2 = "acceleration_2_m_s2";

TEST(Faults, AreCalledByTheirNames) {
  const auto drop = [](Record& record) {
    std::vector<double>& x = made::values(record, kX1);
    std::fill(x.begin() + 7000, x.begin() + 7120, 0.05);
  };
  const auto lone = [](Record& record) {
    std::vector<double>& a = made::values(record, kA1);
    for (size_t i = 97; i < a.size(); i += 211) a[i] += i % 2 == 0 ? 40.0 : -40.0;
  };
  const auto dies = [](Record& record) {
    std::vector<double>& a = made::values(record, kA2);
    for (size_t i = 13000; i < a.size(); ++i) a[i] = 0.01 * std::sin(12.9898 * static_cast<double>(i * i % 7919));
  };
  const auto freezes = [](const std::string& channel, size_t first, size_t end) {
    return [=](Record& record) {
      std::vector<double>& x = made::values(record, channel);
      std::fill(x.begin() + static_cast<std::ptrdiff_t>(first), x.begin() + static_cast<std::ptrdiff_t>(end), x[first]);
    };
  };
  const auto saturates = [](Record& record) {
    clip(kX1, 0.6)(record);
    std::vector<double>& x = made::values(record, kX1);
    for (size_t i = 0; i < x.size(); ++i) x[i] += 2e-5 * std::sin(12.9898 * static_cast<double>(i * i % 7919));
  };
  const auto copy = [](Record& record) { made::values(record, "displacement_2_m") = made::values(record, kX1); };
  made::Options coarse = with("x", made::Drive::kRandom, 0.0);
  coarse.encoder_m = 1e-4;
  const Fault faults[] = {
      {"all zero, others of the DOF move", with("xva"), set(kX1, 0.0), "dead", kX1},
      {"stuck at a value", with("xa"), set(kA2, 2.5), "dead", kA2},
      {"the only channel of its DOF", with("x"), set(kX1, 0.0), "dead", kX1},
      {"spike of 1e30 in a displacement", with("xva"), spike(kX1, 5000, 1e30), "spikes", kX1},
      {"spike of 1e30 in a force", with("xva"), spike("force_1_N", 5000, 1e30), "spikes", "force_1_N"},
      {"spike of 1e30 in an acceleration", with("a"), spike(kA1, 5000, 1e30), "spikes", kA1},
      {"spike of ten times the motion", with("x"), spike(kX1, 5000, 0.5), "spikes", kX1},
      {"lone spikes in an acceleration", with("a"), lone, "spikes", kA1},
      {"a sensor that dies in the record, noise goes on", with("xa"), dies, "dead", kA2},
      {"a velocity that stands still for a second", with("xva", made::Drive::kRandom, 0.01), freezes(kV1, 9000, 10000),
       "dead", kV1, false, "stands still"},
      {"a displacement that stands still at the end", with("x"), freezes(kX1, 19000, 20000), "dead", kX1, false,
       "stands still"},
      {"a force that stands still for a twentieth", with("xa", made::Drive::kRandom, 0.01),
       freezes("force_1_N", 19000, 20000), "dead", "force_1_N", false, "stands still"},
      {"an amplifier that saturates in front of the noise", with("x"), saturates, "clipped", kX1},
      {"a force no motion follows", with("xva"), spike("force_1_N", 5000, 1e6), "spikes", "force_1_N"},
      {"dropout to a value", with("x"), drop, "spikes", kX1},
      {"accelerometer turned over, x beside it", with("xa"), times(kA1, -1), "polarity", kA1},
      {"accelerometer turned over, x and v beside it", with("xva"), times(kA2, -1), "polarity", kA2},
      {"displacement turned over, v and a beside it", with("xva"), times(kX1, -1), "polarity", kX1},
      {"turned over in a free decay", with("xa", made::Drive::kDecay), times(kA1, -1), "polarity", kA1},
      {"turned over, two tones, no rig file", with("va", made::Drive::kTwoTones), times(kA1, -1), "polarity", kA1,
       false},
      {"accelerometers alone, one turned over", with("a"), times(kA2, -1), "polarity", kA2},
      {"accelerometers exchanged", with("xva"), exchange(kA1, kA2), "exchanged", kA1, true,
       "is exchanged with acceleration_2_m_s2"},
      {"displacements exchanged, no rig file", with("xva"), exchange(kX1, "displacement_2_m"), "exchanged", kX1, false},
      {"velocities exchanged under a hammer", with("xva", made::Drive::kHammer),
       exchange("velocity_1_m_s", "velocity_2_m_s"), "exchanged", "velocity_1_m_s"},
      {"accelerometers exchanged, x beside them", with("xa"), exchange(kA1, kA2), "exchanged", kA1, true,
       "or displacement_1_m is with displacement_2_m"},
      {"displacements alone, exchanged", with("x"), exchange(kX1, "displacement_2_m"), "exchanged", kX1},
      {"accelerometers alone, exchanged", with("a"), exchange(kA1, kA2), "exchanged", kA1},
      {"g for m/s2", with("xa"), all_times('a', 1 / 9.80665), "unit", kA1, true, "are in g"},
      {"g for m/s2 beside velocity, no rig file", with("va"), all_times('a', 1 / 9.80665), "unit", kA1, false,
       "are in g"},
      {"mm for m beside acceleration", with("xa"), all_times('d', 1e3), "unit", kX1, true, "are in mm"},
      {"mm/s for m/s", with("xva"), all_times('v', 1e3), "unit", kV1, true, "are in mm/s"},
      {"kN for N", with("xva"), times("force_1_N", 1e-3), "unit", "force_1_N", true, "kN"},
      {"lbf for N", with("xva"), times("force_1_N", 1 / 4.4482216152605), "unit", "force_1_N", true, "lbf"},
      {"displacements alone in mm", with("x"), all_times('d', 1e3), "unit", "force_1_N", true,
       "all motion channels are in mm"},
      {"accelerometers alone in g", with("a"), all_times('a', 1 / 9.80665), "unit", kA1, true, "g"},
      {"one column logged twice", with("x"), copy, "duplicate", "displacement_2_m", true,
       "holds the very samples of displacement_1_m"},
      {"clipped amid noise", with("xva"), clip(kA1, 0.5), "clipped", kA1},
      {"clipped displacement amid noise", with("x"), clip(kX1, 0.6), "clipped", kX1},
      {"clipped without noise", with("x", made::Drive::kTwoTones, 0.0), clip(kX1, 0.7), "clipped", kX1},
      {"clipped, read by a coarse encoder", coarse, clip(kX1, 0.6), "clipped", kX1},
      {"clipped acceleration without noise", with("xa", made::Drive::kRandom, 0.0), clip(kA1, 0.5), "clipped", kA1},
      {"clipped force amid noise", with("xva"), clip("force_1_N", 0.5), "clipped", "force_1_N"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    Record record = made::record(fault.options);
    fault.spoil(record);
    const rig_file::RigModel rig = made::chain();
    const Report report = check({record}, fault.with_rig ? &rig : nullptr);
    EXPECT_STREQ(report.verdict(), "unusable") << all_of(report);
    const Finding* finding = find(report, fault.kind, fault.channel);
    ASSERT_NE(finding, nullptr) << all_of(report);
    EXPECT_EQ(finding->weight, Weight::kFault);
    EXPECT_NE(finding->detail.find(fault.says), std::string::npos) << finding->detail;
  }
}

// What only informs: it is said, and stops nothing.
TEST(Faults, ThatOnlyInform) {
  const double pi = std::acos(-1.0);
  const auto hum = [=](Record& record) {
    std::vector<double>& a = made::values(record, kA1);
    for (size_t i = 0; i < a.size(); ++i) a[i] += 0.5 * std::sin(2 * pi * 50.02 * static_cast<double>(i) * 1e-3);
  };
  const auto drift = [](Record& record) {
    std::vector<double>& x = made::values(record, kX1);
    for (size_t i = 0; i < x.size(); ++i) x[i] += 0.02 * static_cast<double>(i) / static_cast<double>(x.size());
  };
  const auto late = [](Record& record) {  // by two samples, 2 ms
    std::vector<double>& a = made::values(record, kA1);
    std::rotate(a.begin(), a.end() - 2, a.end());
  };
  const auto jitter = [](Record& record) { record.time_jitter_s = 5e-6; };
  const Fault faults[] = {
      {"hum", with("xva"), hum, "hum", kA1},
      {"drift", with("xva"), drift, "drift", kX1},
      {"skew", with("xa"), late, "skew", kA1, true, "us late against displacement_1_m"},
      {"a force that is not there", with("xva", made::Drive::kDecay),
       [](Record& record) {
         record.channels.push_back({"force_1_N", host_sim::Quantity::kForce, 1, std::vector<double>(record.samples())});
       },
       "dead", "force_1_N", true, "taken as a free decay"},
      {"jitter", with("xva"), jitter, "jitter", ""},
      {"the only force turned over, displacements alone", with("x"), times("force_1_N", -1), "polarity", "force_1_N",
       true, "estimate and diagnose do"},
  };
  for (const Fault& fault : faults) {
    SCOPED_TRACE(fault.name);
    Record record = made::record(fault.options);
    fault.spoil(record);
    const rig_file::RigModel rig = made::chain();
    const Report report = check({record}, &rig);
    EXPECT_STRNE(report.verdict(), "unusable") << all_of(report);
    if (*fault.channel == '\0') {
      EXPECT_NE(all_of(report).find(fault.kind), std::string::npos);
      continue;
    }
    const Finding* finding = find(report, fault.kind, fault.channel);
    ASSERT_NE(finding, nullptr) << all_of(report);
    EXPECT_NE(finding->detail.find(fault.says), std::string::npos) << finding->detail;
  }
}

// Late by 2 ms: nothing beyond what the rig file states, 1 ms beyond half of it.
TEST(Faults, ADelayThatTheRigFileStatesIsNotTold) {
  Record record = made::record(with("xa"));
  std::vector<double>& a = made::values(record, kA1);
  std::rotate(a.begin(), a.end() - 2, a.end());
  rig_file::RigModel rig = made::chain();
  rig.channels.emplace_back();
  rig.channels.back().name = kA1;
  rig.channels.back().delay_us = 2000;
  const Report stated = check({record}, &rig);
  EXPECT_EQ(find(stated, "skew", kA1), nullptr) << all_of(stated);
  rig.channels.back().delay_us = 1000;
  const Report half = check({record}, &rig);
  const Finding* finding = find(half, "skew", kA1);
  ASSERT_NE(finding, nullptr) << all_of(half);
  EXPECT_NEAR(*finding->value, 1e-3, 1e-4);
}

// A force sensor that is dead while the shaker shakes: the motion grows again and again.
TEST(Faults, ADeadForceIsSeenByMotionThatGrows) {
  made::Options options;
  options.drive = made::Drive::kHammer;
  Record record = made::record(options);
  for (double& value : made::values(record, "force_1_N")) value = 0.0;
  const rig_file::RigModel rig = made::chain();
  const Report report = check({record}, &rig);
  const Finding* finding = find(report, "dead", "force_1_N");
  ASSERT_NE(finding, nullptr);
  EXPECT_EQ(finding->weight, Weight::kFault) << finding->detail;
}

TEST(Faults, NoiseFloorAndResolutionAreMeasured) {
  made::Options options = with("x", made::Drive::kRandom, 0.01);
  Record record = made::record(options);
  const Report fine = check({record}, nullptr);
  const auto& channel = fine.records[0].channels[1];
  EXPECT_NEAR(channel.noise_floor, 0.01 * channel.rms, 0.0005 * channel.rms);
  EXPECT_EQ(channel.resolution, 0.0);
  options.encoder_m = 1e-4;
  options.noise = 0.0;
  const Report coarse = check({made::record(options)}, nullptr);
  EXPECT_NEAR(coarse.records[0].channels[1].resolution, 1e-4, 1e-9);
}

TEST(Faults, JsonHasTheFieldsOfTheContract) {
  Record record = made::record(with("xa"));
  times(kA1, -1)(record);
  const auto json = to_json(check({record}, nullptr));
  EXPECT_EQ(json["schema"], "check/1");
  EXPECT_EQ(json["verdict"], "unusable");
  EXPECT_EQ(json["records"][0]["file"], "made.csv");
  EXPECT_EQ(json["records"][0]["samples"], 20000);
  EXPECT_DOUBLE_EQ(json["records"][0]["sample_rate_Hz"], 1000.0);
  EXPECT_EQ(json["records"][0]["channels"][2]["name"], kA1);
  EXPECT_EQ(json["records"][0]["channels"][2]["findings"][0]["kind"], "polarity");
  EXPECT_TRUE(json["records"][0]["channels"][2].contains("noise_floor"));
  EXPECT_TRUE(json["records"][0]["channels"][2].contains("rms"));
  EXPECT_TRUE(json["findings"].is_array());
}

// The chain's cables were exchanged in one of two records only: nobody does that between two runs.
TEST(Faults, AnExchangeInOneRecordOfTwoIsNone) {
  Record good = made::record(with("x")), bad = made::record(with("x"));
  std::swap(made::values(bad, kX1), made::values(bad, "displacement_2_m"));
  const rig_file::RigModel rig = made::chain();
  EXPECT_NE(find(check({bad, bad}, &rig), "exchanged", kX1), nullptr);
  EXPECT_EQ(find(check({good, bad}, &rig), "exchanged", kX1), nullptr);
}

// A motor that rests before its step: its angle and speed stay at their lowest value, whose noise shows later. A stop in
// the middle of the record, into which the angle runs at full speed, is one.
TEST(Faults, ARigThatRestsBeforeItsDriveIsNotClipped) {
  std::mt19937 random(4);
  std::normal_distribution<double> noise(0.0, 1e-3);
  host_sim::Channel angle{"angle_1_rad", host_sim::Quantity::kDisplacement, 1, {}};
  host_sim::Channel speed{"angular_velocity_1_rad_s", host_sim::Quantity::kVelocity, 1, {}};
  for (int i = 0; i < 2000; ++i) {
    const double t = std::max(0.0, 0.002 * (i - 200)), w = 20 * (1 - std::exp(-t / 0.1));
    angle.values.push_back(t > 0 ? 20 * (t - 0.1 * (1 - std::exp(-t / 0.1))) + noise(random) : 0.0);
    speed.values.push_back(t > 0 ? w + 30 * noise(random) : 0.0);
  }
  for (const host_sim::Channel& channel : {angle, speed}) {
    EXPECT_FALSE(find_clipping(channel, statistics_of(channel), 0, 0)) << channel.name;
    host_sim::Channel backwards = channel;  // and rests at its end
    std::reverse(backwards.values.begin(), backwards.values.end());
    EXPECT_FALSE(find_clipping(backwards, statistics_of(backwards), 0, 0)) << channel.name;
  }
  for (double& value : angle.values) value = std::min(value, 60.0);
  for (int i = 0; i < 500; ++i) angle.values.push_back(60.0 - 0.04 * i + noise(random));
  const auto found = find_clipping(angle, statistics_of(angle), 0, 0);
  ASSERT_TRUE(found);
  EXPECT_EQ(found->kind, "clipped");
}

// Of the record as a whole; empty: nothing is said of its times.
std::string of_times(const Record& record, bool with_rig) {
  const rig_file::RigModel rig = made::chain();
  const Report report = check({record}, with_rig ? &rig : nullptr);
  for (const Finding& finding : report.records[0].findings)
    if (finding.kind == "unit") return finding.channel + ": " + finding.detail;
  return "";
}

TEST(Faults, TimesInAnotherUnitAreNamedOnce) {
  Record record = made::record(with("xva"));
  EXPECT_EQ(of_times(record, true), "");
  record.sample_period_s *= 1000;  // milliseconds as seconds
  EXPECT_NE(of_times(record, false).find("t_s: the times are in ms"), std::string::npos) << of_times(record, false);
  EXPECT_EQ(find(check({record}, nullptr), "unit", kV1), nullptr);
  EXPECT_EQ(find(check({record}, nullptr), "unit", kA1), nullptr);
}

// One channel alone tells nothing; a rig whose two masses both hang on the ground does: 5 Hz at 1 Hz.
TEST(Faults, SamplesTooSlowForEveryModeAreDoubted) {
  Record record = made::record(with("x"));
  rig_file::RigModel rig = made::chain();
  rig.links.push_back(rig.links[0]);
  rig.links.back().a = 2, rig.links.back().b = rig_file::kGround;
  EXPECT_EQ(check({record}, &rig).worst(), Weight::kInforms);
  record.sample_period_s *= 1000;
  const Report report = check({record}, &rig);
  EXPECT_NE(all_of(report).find("are the times in seconds?"), std::string::npos) << all_of(report);
}

TEST(Faults, DayNumbersAreNoSeconds) {
  Record record = made::record(with("x"));
  record.start_s = 46082.4, record.sample_period_s = 1e-3 / 86400;
  EXPECT_NE(of_times(record, false).find("the times are days"), std::string::npos);
}

}  // namespace
