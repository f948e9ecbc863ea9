// What is worth knowing of a record and stops nothing; table-driven.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/data_check/faults.hpp"

namespace {

using faults::all_of;
using faults::Fault;
using faults::find;
using faults::Finding;
using faults::kA1;
using faults::kX1;
using faults::Record;
using faults::Report;
using faults::times;
using faults::with;
using host_sim::data_check::check;

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

}  // namespace
