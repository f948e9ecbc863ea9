// Every mistake of a sensor, a cable or a unit is called by its name and weighs what it does; table-driven.
#include "tests/data_check/faults.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace {

using faults::all_of;
using faults::all_times;
using faults::clip;
using faults::exchange;
using faults::Fault;
using faults::find;
using faults::Finding;
using faults::kA1;
using faults::kA2;
using faults::kV1;
using faults::kX1;
using faults::Record;
using faults::Report;
using faults::set;
using faults::spike;
using faults::times;
using faults::Weight;
using faults::with;
using host_sim::data_check::check;

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

}  // namespace
