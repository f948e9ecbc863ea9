// The page of a diagnosis as a reader gets it: complete, offline, small.
#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/sections/detectable_tables.hpp"
#include "host_sim/reports/sections/verdict.hpp"
#include "tests/reports/made_up.hpp"
#include "tests/reports/page_parts.hpp"

namespace {

using namespace host_sim::reports;
using page_parts::contains;
using page_parts::expect_offline;

TEST(DiagnosisPage, HasEveryPart) {
  const std::string page = diagnosis_page(made_up::diagnosis());
  expect_offline(page);
  for (const char* id : {"advice", "gain", "parameters", "waveforms", "energy", "links", "candidates", "detectable"})
    EXPECT_TRUE(contains(page, std::string("<h2 id=\"") + id + "\"")) << id;
  // 3 DOFs x 2 channels x 3 pictures, 3 x 2 energies, 2 links x 3
  size_t pictures = 0;
  for (size_t at = page.find("<svg role"); at != std::string::npos; at = page.find("<svg role", at + 1)) ++pictures;
  EXPECT_EQ(pictures, 30u);
  EXPECT_TRUE(contains(page, "three masses &amp; a &lt;friction&gt; link"));
}

// Two links with one effect each, an offset that no strength shows, a DOF, two channels of which one has a hum.
TEST(DiagnosisPage, TablesOfWhatWouldHaveBeenSeen) {
  const double unseen = std::numeric_limits<double>::infinity();
  const std::vector<Detectable> limits = {{"cubic_stiffness", "link 1-0", "N/m^3", 4.1e5, 1.5},
                                          {"force_offset", "link 1-2", "N", unseen},
                                          {"mass_error", "dof 2", "kg", 0.0021, 0.31},
                                          {"sensor_gain", "channel force_1_N", "1", 0.002},
                                          {"mains_hum", "channel velocity_1_m_s", "m/s", 0.0001}};
  const std::vector<HtmlTable> tables = detectable_tables(limits);
  ASSERT_EQ(tables.size(), 3u);
  using Cells = std::vector<std::string>;
  EXPECT_EQ(tables[0].heading, (Cells{"effect", "link 1-0", "link 1-2"}));
  ASSERT_EQ(tables[0].rows.size(), 2u);
  EXPECT_EQ(tables[0].rows[0],
            (Cells{"cubic stiffness", "4.1 × 10<sup>5</sup> N/m³<br><span class=\"dim\">1.5 %</span>", ""}));
  EXPECT_EQ(tables[0].rows[1], (Cells{"force offset", "", "<span class=\"dim\">not in these data</span>"}));
  EXPECT_EQ(tables[1].heading, (Cells{"effect", "dof 2"}));
  EXPECT_EQ(tables[2].heading, (Cells{"channel", "sensor gain", "mains hum"}));
  ASSERT_EQ(tables[2].rows.size(), 2u);
  EXPECT_EQ(tables[2].rows[0], (Cells{"force_1_N", "0.0020", ""}));
  EXPECT_EQ(tables[2].rows[1], (Cells{"velocity_1_m_s", "", "0.00010 m/s"}));
}

TEST(DiagnosisPage, StaysSmallForALongRecord) { EXPECT_LT(diagnosis_page(made_up::diagnosis(60000)).size(), 2000000u); }

// 16 DOFs, the most that the core holds.
TEST(DiagnosisPage, StaysSmallForALargeRig) {
  DiagnosisReportData data = made_up::diagnosis();
  while (data.dofs.size() < 16) data.dofs.push_back(data.dofs[data.dofs.size() % 3]);
  while (data.links.size() < 17) data.links.push_back(data.links[data.links.size() % 2]);
  EXPECT_LT(diagnosis_page(data).size(), 2000000u);
}

TEST(DiagnosisPage, IsTheSameBytesEveryTime) {
  EXPECT_EQ(diagnosis_page(made_up::diagnosis(3000)), diagnosis_page(made_up::diagnosis(3000)));
}

TEST(DiagnosisPage, AFaultTakenOutExplainsNoShare) {
  DiagnosisReportData data;
  data.verdict = "explained";
  data.causes = {{"sensor_gain", "channel velocity_1_m_s", std::nan(""), {}}};
  const std::string page = diagnosis_page(data);
  EXPECT_TRUE(contains(page, "taken out of the record before the rig is judged"));
  EXPECT_FALSE(contains(page, "% of what the rig as given leaves over"));
}

TEST(DiagnosisPage, AnEmptyDiagnosisIsStillAPage) {
  DiagnosisReportData data;
  data.rig_name = "rig";
  data.verdict = "unknown";
  EXPECT_TRUE(contains(diagnosis_page(data), "No effect in the vocabulary explains"));
}

// What may be there is said, and what it would do; two of several.
TEST(DiagnosisPage, SaysWhatMayBeThere) {
  DiagnosisReportData data;
  data.verdict = "none", data.leaves_noise_alone = false;
  data.possible = {{"quadratic_damping", "link 1-0", 13.0, "viscous[1-0]", "0.0292 N s/m"},
                   {"cubic_damping", "link 1-0", 12.6, "", ""},
                   {"backlash", "link 1-0", 11.0, "", ""}};
  EXPECT_EQ(verdict_details(data),
            "What is left beyond measurement noise may be quadratic damping on link 1-0 or cubic damping on link 1-0, "
            "though too "
            "little of it to be sure; viscous[1-0] would then be 0.0292 N s/m.");
  data.verdict = "unknown";
  EXPECT_EQ(verdict_details(data),
            "No effect in the vocabulary explains what is left; nearest comes quadratic damping on link 1-0, which "
            "takes 13 % of "
            "it.");
}

}  // namespace
