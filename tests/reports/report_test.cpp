// The two pages as a reader gets them: complete, offline, small, and whole or not at all.
#include "host_sim/reports/page/report.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <sstream>

#include "host_sim/reports/sections/detectable_tables.hpp"
#include "host_sim/reports/sections/verdict.hpp"
#include "host_sim/reports/zoom/dygraphs.hpp"
#include "tests/reports/made_up.hpp"

namespace {

namespace fs = std::filesystem;
using namespace host_sim::reports;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

std::string content(const fs::path& path) {
  std::ostringstream out;
  out << std::ifstream(path).rdbuf();
  return out.str();
}

// A place of this process's own, gone at the end of the test.
class FreshPlace {
 public:
  explicit FreshPlace(const char* name) : path(testing::TempDir() + name + std::to_string(getpid())) {
    fs::remove_all(path);
  }
  ~FreshPlace() { fs::remove_all(path); }
  const fs::path path;
};

// Without the library that zooms and its packed numbers.
std::string own_part(std::string page) {
  for (const std::string library : {dygraphs_script(), dygraphs_style()})
    if (const size_t at = page.find(library); !library.empty() && at != std::string::npos)
      page.erase(at, library.size());
  const size_t from = page.find("id=\"zoom-records\">");
  if (from != std::string::npos) page.erase(from, page.find("</script>", from) - from);
  return page;
}

// Nothing that a browser would fetch: the script that zooms stands in the page (what it does is seen in the browser's
// test), the rest names no other place.
void expect_offline(const std::string& whole) {
  const std::string page = own_part(whole);
  for (const char* part : {"http:", "https:", "src=", "<link", "@import", "url("})
    EXPECT_FALSE(contains(page, part)) << part;
}

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

TEST(RunPage, HasEveryPart) {
  const std::string page = run_page(made_up::run());
  expect_offline(page);
  for (const char* id : {"estimates", "convergence", "signals", "accelerations"})
    EXPECT_TRUE(contains(page, std::string("<h2 id=\"") + id + "\"")) << id;
  EXPECT_TRUE(contains(page, "5 of 5 true values lie inside their 95 % interval"));
}

// A spring of 2 N/mm beside a damper: 4 x 4 cells of which one was never visited.
RigViews made_up_views() {
  RigViews views;
  ResponseView response{
      "acceleration of DOF 1 per force on DOF 1", "acceleration per force", "m/s^2/N", {}, {}, {}, {}, 9};
  for (int k = 1; k <= 200; ++k) {
    response.frequency_Hz.push_back(k);
    response.measured.push_back(1.0 / k);
    response.simulated.push_back(1.1 / k);
    response.coherence.push_back(k <= 50 ? 0.99 : 0.1);
  }
  views.responses = {response};
  views.modes = {{{9.8, 9.7, 9.9}, {0.0617, 0.0612, 0.0622}, {1.0, -0.5}}};
  ForceStateMap map;
  map.link = "1-0";
  map.columns = map.rows = 4;
  map.elongation_low = map.rate_low = -1e-3;
  map.elongation_high = map.rate_high = 1e-3;
  for (int cell = 0; cell < 16; ++cell) map.measured.push_back(cell == 5 ? NAN : 2e-3 * (cell % 4) - 3e-3);
  map.model = map.measured;
  views.maps = {map};
  views.residuals = {{1, "N", response.frequency_Hz, response.measured, response.simulated}};
  views.notes = {"no <displacement> sensor"};
  return views;
}

TEST(EstimatePage, HasEveryPart) {
  EstimateReportData data;
  data.rig_name = "rig & more";
  data.files = {"a.csv"};
  data.parameters = {{"viscous[1-0]", "N s/m", {NAN, NAN, NAN}, {20.0, 19.8, 20.2}, "VALID"},
                     {"coulomb[1-0]", "N", {NAN, NAN, NAN}, {1.0, 0.2, 1.8}, "ILL_CONDITIONED"}};
  data.advice = {"Add a second level."};
  data.dofs = made_up::diagnosis(3000).dofs;
  data.views = made_up_views();
  const std::string page = estimate_page(data);
  expect_offline(page);
  for (const char* id : {"estimates", "advice", "waveforms", "modes", "responses", "maps", "residuals"})
    EXPECT_TRUE(contains(page, std::string("<h2 id=\"") + id + "\"")) << id;
  EXPECT_TRUE(contains(page, "<h1>1 of 2 coefficients are valid</h1>"));
  EXPECT_TRUE(contains(page, "Average of 9 segments"));
  EXPECT_TRUE(contains(page, "full depth is 3.00 mN"));
  EXPECT_TRUE(contains(page, "no &lt;displacement&gt; sensor"));
  EXPECT_FALSE(contains(own_part(page), "nan"));
}

// Coherent up to 50 Hz: the running mean over 16 bins falls below a half some 8 bins later, and an eighth is added.
TEST(EstimatePage, AResponseEndsWhereNothingDrives) {
  EstimateReportData data;
  data.views = made_up_views();
  const std::string page = estimate_page(data);
  EXPECT_TRUE(contains(page, ">60</text>"));
  EXPECT_FALSE(contains(page.substr(0, page.find("id=\"maps\"")), ">100</text>"));
}

// Intervals that hold nothing fit any rig: nothing missing is then not said to be found.
TEST(Verdict, NothingIsExplainedByNumbersThatAreNotDetermined) {
  DiagnosisReportData data;
  data.verdict = "none";
  data.gains = {{1, 28.2, 28.2, 0.0, 0.0}};
  data.parameters = {{"mass[1]", "kg", {9.6, -24, 43}, {}, "ILL_CONDITIONED"},
                     {"viscous[1-0]", "N s/m", {42, -104, 188}, {}, "ILL_CONDITIONED"}};
  EXPECT_EQ(verdict_headline(data), "These records do not tell whether the rig file is right");
  EXPECT_TRUE(contains(verdict_details(data), "misses 28 % of the signal of DOF 1"));
  EXPECT_FALSE(contains(verdict_sentence(data), "Nothing is left"));
  data.parameters[1].status = "VALID";
  EXPECT_EQ(verdict_headline(data), "The rig file explains the measurement");
}

TEST(Verdict, AShortHeadlineThenTheRest) {
  DiagnosisReportData data;
  data.causes = {{"cubic_stiffness", "link 1-2", 90.0, {}}};
  data.gains = {{1, 10.0, 2.0, 0.0, 0.0}};
  data.verdict = "explained";
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-2");
  EXPECT_EQ(verdict_details(data),
            "With this taken into account, the simulation's error on unseen data is 5.0 times smaller.");
  EXPECT_EQ(verdict_sentence(data), verdict_headline(data) + ". " + verdict_details(data));
  data.causes.push_back({"backlash", "link 2-3", 5.0, {}});
  data.causes.push_back({"mass_error", "dof 2", 2.0, {}});
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-2 and 2 more");
  EXPECT_TRUE(contains(verdict_details(data), "backlash on link 2-3 and mass error on DOF 2."));
  data.verdict = "ambiguous";
  data.causes.resize(1);
  data.ambiguous_with = {{"cubic_stiffness", "link 1-2"}, {"end_stop", "link 1-2"}, {"mass_error", "dof 2"}};
  EXPECT_EQ(verdict_details(data),
            "It is one of these: cubic stiffness on link 1-2, end stop on link 1-2 or mass error on DOF 2.");
  data.verdict = "partly";
  EXPECT_TRUE(contains(verdict_details(data), "its cause is not known"));
  // Of three causes one is sure; what can replace each of the others is said of that one.
  data.causes.push_back({"force_offset", "link 1-2", 5.0, {}});
  data.causes.push_back({"cubic_damping", "link 2-3", 2.0, {}});
  data.causes[0].rivals = {{"end_stop", "link 1-2"}};
  data.causes[2].rivals = {{"quadratic_damping", "link 2-3"}, {"stribeck", "link 2-3"}};
  data.verdict = "ambiguous";
  EXPECT_EQ(
      verdict_sentence(data),
      "The rig file lacks force offset on link 1-2, and something that these data cannot tell. "
      "There is one of these: cubic stiffness on link 1-2 or end stop on link 1-2 and one of these: cubic damping "
      "on link 2-3, quadratic damping on link 2-3 or stribeck on link 2-3. With this taken into account, the "
      "simulation's error on unseen data is 5.0 times smaller. It still misses 2 % of the signal of DOF 1.");
  data.verdict = "partly", data.causes.resize(1);
  data.verdict = "unknown";
  EXPECT_TRUE(contains(verdict_details(data), "is beyond noise, and no effect in the vocabulary explains it"));
  data.causes.clear();
  EXPECT_EQ(verdict_headline(data), "The rig file does not explain the measurement");
}

// What remains is said in percent; what no rig file of this kind can describe in plain words; a held drive is no fault.
TEST(Verdict, SaysHowMuchRemains) {
  DiagnosisReportData data;
  data.verdict = "partly";
  data.causes = {{"force_hold", "channel force_1_N", 90.0, {}}};
  data.gains = {{1, 60.0, 5.66, 0.0, 0.0}, {2, 60.0, 2.0, 0.0, 0.0}};
  EXPECT_EQ(verdict_headline(data), "The rig file lacks a hold of the force between samples (channel force_1_N)");
  EXPECT_TRUE(contains(verdict_details(data), "What remains, 5.7 % of the signal of DOF 1, is beyond noise"));
  data.causes.clear();
  data.verdict = "unknown";
  EXPECT_TRUE(contains(verdict_details(data), "Its simulation misses 60 % of the signal of DOF 1 on unseen data."));
  data.gains[1].nrmse_before_percent = 379.0;
  EXPECT_TRUE(contains(verdict_details(data), "misses more than the whole signal of DOF 2"));
  data.cannot_describe = "It misses everything.";
  EXPECT_EQ(verdict_sentence(data), "The rig file cannot describe this recording. It misses everything.");
}

// A force that is mostly noise shakes every simulation: that is no force that the rig file lacks.
TEST(Verdict, SaysWhereNoiseHidesAll) {
  DiagnosisReportData data;
  data.verdict = "unknown";
  data.gains = {{1, 89.0, 89.0, 0.0, 0.0}};
  data.noise_hides = true;
  EXPECT_EQ(
      verdict_sentence(data),
      "The data are too noisy to tell whether the rig file is right. Its simulation misses 89 % of the signal of DOF "
      "1 on unseen data. What is left is no more than the noise of the channels makes of it.");
  // of a model of which nothing is known, noise hides nothing: a blow 42 dB above its noise on a chain that is none
  data.parameters = {{"mass[1]", "kg", {2.8e-5, -0.05, 0.05}, {}, "ILL_CONDITIONED"}};
  EXPECT_EQ(verdict_headline(data), "These records do not tell whether the rig file is right");
  EXPECT_TRUE(tells_nothing(data));
  data.parameters[0].status = "BIAS_SUSPECT";
  EXPECT_FALSE(tells_nothing(data));
  data.noise_hides = false;
  EXPECT_EQ(verdict_headline(data), "The rig file does not explain the measurement");
}

// "Nothing beyond noise" is said where the misfit is that of noise, and only there.
TEST(Verdict, NoneDoesNotDenyWhatIsLeft) {
  DiagnosisReportData data;
  data.verdict = "none";
  EXPECT_TRUE(contains(verdict_sentence(data), "Nothing is left beyond measurement noise"));
  data.leaves_noise_alone = false;
  EXPECT_TRUE(contains(verdict_sentence(data), "neither helps to predict unseen data nor moves a coefficient"));
}

// "Explains" beside a free run that misses most of the motion needs a word; what noise makes such a run miss is noise's.
TEST(Verdict, NoneSaysWhereAFreeRunGoesAstray) {
  DiagnosisReportData data;
  data.verdict = "none", data.leaves_noise_alone = false;
  data.gains = {{1, 70.0, 70.0, 0.0, 0.0}};
  EXPECT_TRUE(contains(verdict_sentence(data), "a free run over all unseen data misses 70 % of the signal of DOF 1"));
  data.gains[0].nrmse_before_percent = 24;
  EXPECT_FALSE(contains(verdict_sentence(data), "a free run"));
  data.gains[0].nrmse_before_percent = 70, data.leaves_noise_alone = true;
  EXPECT_FALSE(contains(verdict_sentence(data), "a free run"));
}

// A sensor is no part of the rig file.
TEST(Verdict, ASensorsFaultIsSaidToBeOne) {
  DiagnosisReportData data;
  data.causes = {{"sensor_delay", "channel force_1_N", 90.0, {}}};
  data.gains = {{1, 60.0, 2.0, 0.0, 0.0}};
  data.verdict = "explained";
  EXPECT_EQ(verdict_sentence(data),
            "A sensor is at fault: sensor delay in channel force_1_N. With this taken into account, the simulation's "
            "error on "
            "unseen data is 30 times smaller.");
  data.causes.push_back({"cubic_stiffness", "link 1-2", 5.0, {}});
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-2; a sensor is at fault");
  EXPECT_TRUE(contains(verdict_details(data), "At fault: sensor delay in channel force_1_N."));
  data.causes.resize(1);
  data.verdict = "ambiguous";
  data.ambiguous_with = {{"sensor_delay", "channel displacement_1_m"}};
  EXPECT_EQ(verdict_headline(data), "A sensor is at fault, and these data cannot tell which");
  data.ambiguous_with.push_back({"mass_error", "dof 1"});
  EXPECT_EQ(verdict_headline(data), "The rig file lacks something or a sensor is at fault");
}

// What the drive does not give is told by the force's channel, whose sensor is sound.
TEST(Verdict, ADrivesDeadBandIsNoSensorsFault) {
  DiagnosisReportData data;
  data.causes = {{"drive_dead_band", "channel torque_1_N_m", 90.0, {}}};
  data.verdict = "explained";
  EXPECT_EQ(verdict_headline(data), "The drive is at fault: drive dead band in channel torque_1_N_m");
  data.causes.push_back({"sensor_delay", "channel torque_1_N_m", 5.0, {}});
  EXPECT_EQ(verdict_headline(data),
            "A sensor and the drive are at fault: drive dead band in channel torque_1_N_m and sensor delay in channel "
            "torque_1_N_m");
  data.causes[1] = {"cubic_stiffness", "link 1-0", 5.0, {}};
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-0; the drive is at fault");
  data.causes.resize(1);
  data.verdict = "ambiguous";
  data.ambiguous_with = {{"sensor_delay", "channel angle_1_rad"}};
  EXPECT_EQ(verdict_headline(data), "A sensor or a drive is at fault, and these data cannot tell which");
  data.ambiguous_with = {{"mass_error", "dof 1"}};
  EXPECT_EQ(verdict_headline(data), "The rig file lacks something or a drive is at fault");
}

TEST(WriteReport, MakesTheFolderAndReplacesAnEarlierPage) {
  const FreshPlace place("report_written");
  const fs::path folder = place.path / "deep";
  write_diagnosis_report(folder.string(), made_up::diagnosis(3000));
  EXPECT_TRUE(contains(content(folder / "index.html"), "cubic stiffness"));
  EXPECT_TRUE(fs::exists(folder / "figures/01_dof_1_displacement_worst_moment.csv"));
  std::ofstream(folder / "figures/notes.csv") << "not of a page";
  write_run_report(folder.string(), made_up::run(2000));
  EXPECT_TRUE(contains(content(folder / "index.html"), "paper_3dof_random_noise"));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 2);  // the page and figures/
  EXPECT_TRUE(fs::exists(folder / "figures/notes.csv"));
  EXPECT_FALSE(fs::exists(
      folder / "figures/01_dof_1_displacement_worst_moment.csv"));  // a run's page begins with another picture
}

// Every picture of the page has its file, and no file is of another page.
TEST(WriteReport, EveryPictureHasItsData) {
  const FreshPlace place("report_figures");
  write_diagnosis_report(place.path.string(), made_up::diagnosis(3000));
  const std::string page = content(place.path / "index.html");
  size_t pictures = 0;
  for (size_t at = page.find("<figure>"); at != std::string::npos; at = page.find("<figure>", at + 1)) ++pictures;
  ASSERT_GT(pictures, 5u);
  const fs::path figures = place.path / "figures";
  EXPECT_EQ(static_cast<size_t>(std::distance(fs::directory_iterator(figures), fs::directory_iterator())), pictures);
  for (const auto& entry : fs::directory_iterator(figures)) {
    const std::string table = content(entry.path());
    EXPECT_GT(std::count(table.begin(), table.end(), '\n'), 1) << entry.path();
  }
}

TEST(WriteReport, AFileInTheWayIsNamed) {
  const FreshPlace place("report_in_the_way");
  const fs::path& folder = place.path;
  std::ofstream(folder) << "not a folder";
  try {
    write_run_report(folder.string(), made_up::run(2000));
    FAIL() << "expected an error";
  } catch (const std::runtime_error& error) {
    EXPECT_TRUE(contains(error.what(), folder.string())) << error.what();
  }
  EXPECT_EQ(content(folder), "not a folder");
}

}  // namespace
