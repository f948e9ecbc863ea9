// Scenario files: the shipped ones, what a right one means, and what a wrong one is told.
#include "host_sim/plant/scenario/scenario.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>

#include "hal/rig_file/compile_rig.hpp"
#include "tests/plant/scenario_texts.hpp"

namespace {

using plant_test::small_scenario;
using plant_test::spoiled;

TEST(Scenario, TheNineShippedOnesAreRead) {
  const std::vector<std::string> expected = {"paper_1dof",
                                             "paper_2dof",
                                             "paper_2dof_noise",
                                             "paper_3dof_two_frequencies",
                                             "paper_3dof_one_frequency",
                                             "paper_3dof_two_frequencies_noise",
                                             "paper_3dof_random",
                                             "paper_3dof_random_noise",
                                             "paper_3dof_free_decay"};
  EXPECT_EQ(host_sim::shipped_scenario_names(), expected);
  for (const std::string& name : expected) {
    const host_sim::Scenario scenario = host_sim::load_scenario(name);
    EXPECT_EQ(scenario.name, name);
    EXPECT_EQ(scenario.truth.size(), rig_file::parameter_names(scenario.rig).size());
    const bool noisy = name.find("noise") != std::string::npos;
    EXPECT_EQ(scenario.sensors.every.noise_percent, noisy ? 5.0 : 0.0) << name;
  }
}

// Eq. 14 and its values: k W0 = 10 * (40, 80, 180) N at 8 pi rad/s = 4 Hz; one cycle at 1 kHz is 250 samples.
TEST(Scenario, PaperTwoDofIsEquation14) {
  const host_sim::Scenario s = host_sim::load_scenario("paper_2dof_noise");
  ASSERT_EQ(s.levels.size(), 3u);
  const double amplitude[] = {400.0, 800.0, 1800.0};
  for (size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(s.levels[i].kind, host_sim::LevelKind::kSine);
    EXPECT_EQ(s.levels[i].amplitude, amplitude[i]);
    EXPECT_EQ(s.levels[i].frequency_Hz, 4.0);
    EXPECT_EQ(s.levels[i].samples, 250u);
  }
  EXPECT_EQ(s.truth, (std::vector<double>{6.0, 10.0, 6.0, 10.0}));
  EXPECT_FALSE(s.plant.links[1].viscous_N_s_m.estimate);
  EXPECT_EQ(s.plant.links[1].coulomb_N.value, 10.0);
  EXPECT_TRUE(s.rig.links[1].viscous_N_s_m.estimate);
}

TEST(Scenario, LengthsAreSecondsOrCycles) {
  const host_sim::Scenario seconds = host_sim::parse_scenario(small_scenario(), "small.toml");
  EXPECT_EQ(seconds.levels[0].settle_samples, 1000u);
  EXPECT_EQ(seconds.levels[0].samples, 2000u);
  const host_sim::Scenario cycles = host_sim::parse_scenario(spoiled("duration_s = 2.0", "cycles = 3"), "small.toml");
  EXPECT_EQ(cycles.levels[0].samples, 750u);
}

TEST(Scenario, RigAndPlantMayStandInFilesBesideIt) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("scenario_test_" + std::to_string(getpid()));
  std::filesystem::create_directories(folder);
  const std::string rig =
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 100.0\nviscous_N_s_m = "
      "\"estimate\"\n";
  std::ofstream(folder / "rig.toml") << rig;
  std::ofstream(folder / "plant.toml") << rig << "[[link.effect]]\nkind = \"cubic_stiffness\"\ncoefficient = 5.0\n";
  std::ofstream(folder / "s.toml")
      << "schema = \"scenario/1\"\nrig = \"rig.toml\"\nplant = \"plant.toml\"\n[truth]\n\"viscous[1-0]\" = 2.0\n"
         "[[level]]\nkind = \"free_decay\"\ndisplacement_m = [0.1]\nduration_s = 1.0\n";
  const host_sim::Scenario s = host_sim::load_scenario((folder / "s.toml").string());
  EXPECT_TRUE(s.rig.links[0].effects.empty());
  ASSERT_EQ(s.plant.links[0].effects.size(), 1u);
  EXPECT_EQ(s.plant.links[0].viscous_N_s_m.value, 2.0);
  std::filesystem::remove_all(folder);
}

struct Broken {
  const char* from;
  const char* to;
  int line;           // where the message points; 0: not checked
  const char* named;  // what the message must hold
};

// Line numbers count in small_scenario(): 1 schema, 3 rate, 5 mass, 7 between, 11 truth, 12 [[level]] ...
const Broken kBroken[] = {
    {"scenario/1", "scenario/2", 1, "scenario/1"},
    {"schema = \"scenario/1\"", "", 0, "schema"},
    {"name = \"small\"", "nam = \"small\"", 2, "did you mean \"name\""},
    {"sample_rate_Hz = 1000.0", "sample_rate_Hz = 0.0", 3, "1 to 1e6"},
    {"sample_rate_Hz = 1000.0", "sample_rate_Hz = \"fast\"", 3, "expected a number"},
    {"mass_kg = 2.0", "mass_kg = 0.0", 0, "mass[1]"},
    {"between = [1, 0]", "between = [1, 3]", 7, "between"},
    {"viscous_N_s_m = \"estimate\"", "viscous_N_s_m = \"guess\"", 9, "viscous_N_s_m"},
    {"\"viscous[1-0]\" = 4.0", "\"viscous[1-2]\" = 4.0", 11, "viscous[1-0]"},
    {"\"viscous[1-0]\" = 4.0", "", 0, "viscous[1-0]"},
    {"\"viscous[1-0]\" = 4.0", "\"viscous[1-0]\" = nan", 11, "finite"},
    {"[truth]\n\"viscous[1-0]\" = 4.0", "", 0, "truth"},
    {"kind = \"sine\"", "kind = \"sinus\"", 13, "free_decay"},
    {"kind = \"sine\"", "", 0, "kind"},
    {"kind = \"sine\"", "kind = \"base_sine\"", 0, "amplitude_N"},
    {"amplitude_N = 20.0", "amplitude_N = -20.0", 14, "above 0"},
    {"amplitude_N = 20.0", "", 0, "amplitude_N"},
    {"amplitude_N = 20.0", "amplitude_N = 20.0\ndof = 2", 15, "from 1 to 1"},
    {"frequency_Hz = 4.0", "frequency_Hz = 500.0", 15, "half the sample rate"},
    {"frequency_Hz = 4.0", "frequency_Hz = 4.0\nband_Hz = [1, 2]", 16, "band_Hz"},
    {"settle_s = 1.0", "settle_s = -1.0", 16, "0 or more"},
    {"settle_s = 1.0", "settle_s = 1.0\nsettle_cycles = 4", 17, "settle_cycles"},
    {"duration_s = 2.0", "duration_s = 1e9", 17, "2e7"},
    {"duration_s = 2.0", "duration_s = 0.001", 0, "8 sample periods"},
    {"duration_s = 2.0", "", 0, "duration_s"},
    {"duration_s = 2.0", "duration_s = 2.0\ndisplacement_m = [1.0, 2.0]", 18, "list of 1 numbers"},
    {"bits = 24", "bits = 25", 19, "8 to 24"},
    {"bits = 24", "noise_percent = -1.0", 19, "0 or more"},
    {"bits = 24", "channels = [\"speed\"]", 19, "acceleration"},
    {"bits = 24", "channels = [\"force\"]", 0, "DOF 1"},
    {"bits = 24", "noise = 5.0", 19, "noise"},
    {"bits = 24", "headroom = 0.5", 19, "headroom"},
    {"bits = 24", "[[sensors.channel]]\nname = \"velocity_3_m_s\"", 20, "DOF 3"},
    {"bits = 24", "[[sensors.channel]]\nname = \"velocity_1_m_s\"\ndelay_us = -5", 21, "0 to 1e6"},
    {"bits = 24", "[[sensors.channel]]\nbits = 12", 0, "name"},
    {"bits = 24", "bits = 24\nbits = 12", 20, "TOML"},
    {"name = \"small\"", "rig = \"nowhere.toml\"", 0, "dof"},
};

TEST(Scenario, ABrokenFileIsToldWhereAndWhatWasExpected) {
  for (const Broken& broken : kBroken) {
    try {
      host_sim::parse_scenario(spoiled(broken.from, broken.to), "small.toml");
      ADD_FAILURE() << "accepted: " << broken.to;
    } catch (const rig_file::RigFileError& error) {
      EXPECT_EQ(error.file, "small.toml") << broken.to;
      EXPECT_NE(std::string(error.what()).find(broken.named), std::string::npos) << broken.to << " -> " << error.what();
      EXPECT_NE(std::string(error.what()).find("xpected"), std::string::npos) << error.what();
      if (broken.line > 0) {
        EXPECT_EQ(error.line, static_cast<unsigned>(broken.line)) << broken.to << " -> " << error.what();
      }
    }
  }
}

TEST(Scenario, ANameThatIsNoneIsToldTheShippedOnes) {
  try {
    host_sim::load_scenario("paper_4dof");
    FAIL();
  } catch (const rig_file::RigFileError& error) {
    EXPECT_NE(std::string(error.what()).find("paper_3dof_random"), std::string::npos);
  }
}

}  // namespace
