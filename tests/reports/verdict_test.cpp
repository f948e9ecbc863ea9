// What a diagnosis comes to, in a headline and the rest.
#include "host_sim/reports/sections/verdict.hpp"

#include <gtest/gtest.h>

#include <string>

#include "tests/reports/made_up.hpp"
#include "tests/reports/page_parts.hpp"

namespace {

using namespace host_sim::reports;
using page_parts::contains;

// Intervals that hold nothing fit any rig: nothing missing is then not said to be found.
TEST(Verdict, NothingIsExplainedByNumbersThatAreNotDetermined) {
  DiagnosisReportData data;
  data.verdict = "unknown", data.determines_nothing = true;
  data.gains = {{1, 28.2, 28.2, 0.0, 0.0}};
  data.parameters = {{"mass[1]", "kg", {9.6, -24, 43}, {}, "ILL_CONDITIONED"},
                     {"viscous[1-0]", "N s/m", {42, -104, 188}, {}, "ILL_CONDITIONED"}};
  EXPECT_EQ(verdict_headline(data), "These records do not tell whether the rig file is right");
  EXPECT_TRUE(contains(verdict_details(data), "misses 28 % of the signal of DOF 1"));
  EXPECT_FALSE(contains(verdict_sentence(data), "Nothing is left"));
  data.verdict = "none", data.determines_nothing = false;
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
  EXPECT_TRUE(contains(verdict_details(data),
                       "It lacks cubic stiffness on link 1-2 and backlash on link 2-3 and has a mass error on DOF 2."));
  data.causes.erase(data.causes.begin() + 1);
  EXPECT_EQ(verdict_headline(data), "The rig file lacks cubic stiffness on link 1-2 and has a mass error on DOF 2");
  data.causes.erase(data.causes.begin());
  EXPECT_EQ(verdict_headline(data), "The rig file has a mass error on DOF 2");
  data.causes = {{"missing_coulomb", "link 1-0", 90.0, {}}};  // what is missing is not lacked a second time
  EXPECT_EQ(verdict_headline(data), "The rig file lacks Coulomb friction on link 1-0");
  data.causes = {{"cubic_stiffness", "link 1-2", 90.0, {}}};
  data.verdict = "ambiguous";
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

// 99.7 % to two digits is no number that anybody reads.
TEST(Verdict, SaysNearlyAllInWholePercent) {
  DiagnosisReportData data;
  data.verdict = "unknown";
  data.gains = {{1, 99.7, 99.7, 0.0, 0.0}};
  EXPECT_TRUE(contains(verdict_details(data), "misses 100 % of the signal of DOF 1"));
}

TEST(Verdict, SaysWhichChannelsWereLeftOut) {
  DiagnosisReportData data;
  data.verdict = "none";
  data.channels_left_out = {"acceleration_1_m_s2"};
  EXPECT_TRUE(
      contains(verdict_sentence(data), "without acceleration_1_m_s2, which does not go with the other channels"));
  data.channels_left_out.push_back("acceleration_2_m_s2");
  EXPECT_TRUE(contains(verdict_sentence(data), "without acceleration_1_m_s2 and acceleration_2_m_s2, which do not go"));
}

TEST(Verdict, SaysFromWhereItHolds) {
  DiagnosisReportData data;
  data.verdict = "none";
  EXPECT_FALSE(contains(verdict_sentence(data), "s on"));
  data.told_from_s = {4.3516};
  EXPECT_TRUE(contains(verdict_sentence(data), "This is said of the motion from 4.35 s on: before, "));
  data.told_from_s = {4.3516, 7.0};
  EXPECT_TRUE(contains(verdict_sentence(data), "from 4.35 and 7.00 s on"));
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

// Where nothing is determined nothing that is missing could be seen: that is not said to be absent.
TEST(Verdict, DoesNotDenyWhatCannotBeSeen) {
  DiagnosisReportData data;
  data.verdict = "unknown";
  data.determines_nothing = true;
  EXPECT_TRUE(tells_nothing(data));
  EXPECT_EQ(verdict_headline(data), "These records do not tell whether the rig file is right");
  EXPECT_TRUE(contains(verdict_sentence(data), "nothing that is missing can be seen"));
  EXPECT_FALSE(contains(verdict_sentence(data), "no effect that could be missing is seen"));
}

// "Nothing beyond noise" is said where the misfit is that of noise, and only there.
TEST(Verdict, NoneDoesNotDenyWhatIsLeft) {
  DiagnosisReportData data;
  data.verdict = "none";
  EXPECT_TRUE(contains(verdict_sentence(data), "Nothing is left beyond measurement noise"));
  data.leaves_noise_alone = false;
  EXPECT_TRUE(contains(verdict_sentence(data), "neither helps to predict unseen data nor moves a coefficient"));
}

// A rig that follows with a friction that drives has another law in its place.
TEST(Verdict, NoneSaysWhichNumberCannotBe) {
  DiagnosisReportData data;
  data.verdict = "none";
  data.parameters = {{"viscous[1-0]", "N s/m", {3.0, 2.9, 3.1}, {}, "BIAS_SUSPECT"},
                     {"coulomb[1-0]", "N", {-0.4, -0.5, -0.3}, {}, "BIAS_SUSPECT"}};
  EXPECT_FALSE(contains(verdict_sentence(data), "below nought"));
  data.parameters[1].impossible = true;
  EXPECT_TRUE(contains(verdict_sentence(data),
                       "It does so with coulomb[1-0] below nought, which cannot be: another law has its place."));
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

}  // namespace
