// What a bad board file is told.
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>

#include "hal/rig_file/rig_file_error.hpp"
#include "tests/board/board_file_fixture.hpp"

namespace {

using board_test::BoardFileTest;
using board_test::kGood;

struct Broken {
  const char* from;
  const char* to;
  std::vector<const char*> message;  // all of these are in it
};

const Broken kBroken[] = {
    {"id = 3", "id = 8", {":3:", "node", "\"id\"", "expected"}},
    {"id = 3", "id = \"three\"", {":3:", "\"id\"", "expected"}},
    {"id = 3", "identity = 3", {":3:", "\"identity\"", "expected one of id,"}},
    {"window_s = 0.5", "window_s = 0.01", {":4:", "\"window_s\"", "0.05 to 1"}},
    {"[node]\n", "[node]\nprobe_products_per_sample = 65536\n", {"\"probe_products_per_sample\"", "0 to 65535"}},
    {"[node]\n", "[node]\nheartbeat_ms = -1\n", {"\"heartbeat_ms\"", "expected"}},
    {"[node]\n", "[node]\nheartbeat_ms = 9\n", {":3:", "\"heartbeat_ms\"", "0 (none) or 10 to 65535"}},
    {"[node]\n", "[nodes]\n", {"\"nodes\"", "did you mean \"node\""}},
    {"interface = \"vcan1\"", "interface = \"can0\"\nbit_rate_kbit_s = 0", {":7:", "\"bit_rate_kbit_s\"", "10"}},
    {"interface = \"vcan1\"",
     "interface = \"can0\"\ndata_bit_rate_kbit_s = 500",
     {":7:", "\"data_bit_rate_kbit_s\"", "at least"}},
    {"interface = \"vcan1\"", "interface = 1", {":6:", "\"interface\"", "expected"}},
    {"interface = \"vcan1\"", "interface = \"vcan1\"\nfd = 1", {"\"fd\"", "true nor false"}},
    {"schema = \"rig/1\"\n[node]\nid = 3\nwindow_s = 0.5\n",
     "schema = \"rig/1\"\nnode = 3\n",
     {":2:", "\"node\"", "expected [node]"}},
    {"source = \"can\"", "source = \"serial\"", {":8:", "\"source\"", "\"can\", \"iio\", \"iio_direct\""}},
    {"wiring = \"24\"", "wiring = \"32\"", {":9:", "\"wiring\"", "\"16\", \"24\", \"fd\""}},
    {"wiring = \"24\"", "device = \"adc\"", {":9:", "\"device\"", "IIO source only"}},
    {"source = \"can\"\nwiring = \"24\"", "source = \"iio\"", {"\"device\"", "is missing"}},
    {"source = \"can\"\nwiring = \"24\"",
     "source = \"iio\"\ndevice = \"adc\"",
     {"channel 1", "\"element\"", "in_voltage0"}},
    {"unit_per_code = 0.01", "unit_per_code = 0.01\nelement = \"in_voltage0\"", {"\"element\"", "IIO source only"}},
    {"rate_Hz = 2000", "rate_Hz = 0", {":10:", "\"rate_Hz\"", "10 to 20000"}},
    {"rate_Hz = 2000", "rate_Hz = 500", {":11:", "\"timeout_ms\"", "is 2.5 at 500", "two periods"}},
    {"rate_Hz = 2000", "rate_Hz = 2000\ncycle_Hz = 501", {"\"cycle_Hz\"", "is 501 at 2000", "four of them"}},
    {"source = \"can\"\nwiring = \"24\"\nrate_Hz = 2000",
     "source = \"iio_direct\"\ndevice = \"adc\"\nrate_Hz = 4001",
     {"\"rate_Hz\"", "is 4001", "at most 4000"}},
    {"timeout_ms = 2.5", "timeout_ms = nan", {":11:", "\"timeout_ms\"", "expected"}},
    {"{ line = \"stop\", ", "{ ", {":13:", "\"line\"", "is missing"}},
    {"bias = \"pull_up\"", "bias = \"up\"", {":13:", "\"bias\"", "\"pull_up\""}},
    {"relay = \"gpiochip0:4\"\n", "", {"\"relay\"", "is missing"}},
    {"emergency_stop = { line = \"stop\", active_low = true, bias = \"pull_up\" }\n",
     "",
     {"\"emergency_stop\"", "is missing"}},
    {"output = \"can\"\n", "", {"\"output\"", "the excitation programme has levels"}},
    {"output = \"can\"", "output = \"iio\"", {"\"device\"", "is missing"}},
    {"output = \"can\"", "output = \"can\"\nelement = \"out_voltage0\"", {"\"element\"", "\"iio\" only"}},
    {"limit = 0.5", "limit = 0.2", {"excitation level 1", "[drive] limit"}},
    {"slew_per_s = 100", "slew_per_s = 1", {"excitation level 1", "slew_per_s"}},
    {"kind = \"sine\"", "kind = \"chirp\"", {":20:", "\"kind\"", "\"sine\", \"random\", \"free_decay\""}},
    {"amplitude = 0.25\n", "", {"excitation level 1", "\"amplitude\"", "is missing"}},
    {"frequency_Hz = 5\n", "", {"\"frequency_Hz\"", "is missing"}},
    {"frequency_Hz = 5", "frequency_Hz = 1500", {":22:", "\"frequency_Hz\"", "0 to 1000"}},
    {"kind = \"sine\"", "kind = \"random\"\nlow_Hz = 50", {"\"high_Hz\"", "is missing"}},
    {"kind = \"sine\"", "kind = \"random\"\nlow_Hz = 50\nhigh_Hz = 5", {"low_Hz < high_Hz"}},
    {"measure_s = 30", "measure_s = 0", {":24:", "\"measure_s\"", "expected"}},
    {"unit_per_code = 0.01\n", "", {"channel 1", "\"unit_per_code\"", "is missing"}},
    {"\"force_1_N\"", "\"force_2_N\"", {"channel 1", "\"name\""}},
    {"viscous_N_s_m = \"estimate\"", "viscous_N_s_m = 2.0", {"nothing to estimate"}},
    {"schema = \"rig/1\"\n", "", {"\"schema\"", "is missing"}},
    {"[samples]", "[samples", {":7:", "not valid TOML"}},
};

TEST_F(BoardFileTest, ABadFileIsToldWhere) {
  for (const Broken& broken : kBroken) {
    try {
      read(changed(broken.from, broken.to));
      ADD_FAILURE() << "was accepted: " << broken.to;
    } catch (const rig_file::RigFileError& error) {
      const std::string message = error.what();
      EXPECT_EQ(message.find(folder_ + "/board.toml"), 0u) << message;
      for (const char* part : broken.message)
        EXPECT_NE(message.find(part), std::string::npos) << part << " | " << message;
    }
  }
  EXPECT_THROW(board::read_board_file(folder_ + "/none.toml"), rig_file::RigFileError);
}

// Seven links to the ground with five effects each: 35, and the core has columns for 32. Six links hold 30.
TEST_F(BoardFileTest, MoreEffectsThanTheCoreHasRoomForAreRefused) {
  const auto with_links = [](int links) {
    std::string text(kGood);
    text.resize(text.find("[[dof]]"));
    for (int i = 0; i < links; ++i) text += "[[dof]]\nmass_kg = 1.0\n";
    for (int i = 1; i <= links; ++i) {
      text += "[[link]]\nbetween = [" + std::to_string(i) + ", 0]\nviscous_N_s_m = \"estimate\"\n";
      for (const char* kind :
           {"cubic_stiffness", "quadratic_stiffness", "quadratic_damping", "cubic_damping", "asymmetric_viscous"})
        text += std::string("[[link.effect]]\nkind = \"") + kind + "\"\ncoefficient = 2.0\n";
    }
    for (int i = 1; i <= links; ++i)
      text += "[[channel]]\nname = \"velocity_" + std::to_string(i) + "_m_s\"\nunit_per_code = 1e-6\n";
    return text;
  };
  EXPECT_EQ(read(with_links(6)).controller.core.term_count, 6 * (1 + 1 + 5));
  try {
    read(with_links(7));
    ADD_FAILURE() << "was accepted";
  } catch (const rig_file::RigFileError& error) {
    EXPECT_NE(std::string(error.what()).find("effects on links: 35 of them, expected at most 32"), std::string::npos)
        << error.what();
  }
}

int status_of(const std::string& command) {
  const int status = std::system((command + " >/dev/null 2>&1").c_str());
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

TEST_F(BoardFileTest, TheProgramsExitStatus) {
  const std::string program = RIG_CONTROLLER;
  std::ofstream(folder_ + "/good.toml") << kGood;
  std::ofstream(folder_ + "/bad.toml") << changed("id = 3", "id = 9");
  EXPECT_EQ(status_of(program + " --help"), 0);
  EXPECT_EQ(status_of(program + " --version"), 0);
  EXPECT_EQ(status_of(program + " --check " + folder_ + "/good.toml"), 0);
  EXPECT_EQ(status_of(program + " --check " + folder_ + "/bad.toml"), 2);
  std::ofstream(folder_ + "/full.toml") << changed("\"vcan1\"", "\"can1\"\nbit_rate_kbit_s = 125");
  EXPECT_EQ(status_of(program + " --check " + folder_ + "/full.toml"), 2);  // over 80 % of its bus
  EXPECT_EQ(status_of(program + " --safe " + folder_ + "/good.toml"), 1);   // no lines and no vcan1 here
  EXPECT_EQ(status_of(program + " --safe " + folder_ + "/none.toml"), 1);
  EXPECT_EQ(status_of(program + " --check " + folder_ + "/none.toml"), 2);
  EXPECT_EQ(status_of(program + " --check"), 2);
  EXPECT_EQ(status_of(program + " --for soon " + folder_ + "/good.toml"), 2);
  EXPECT_EQ(status_of(program + " --frobnicate " + folder_ + "/good.toml"), 2);
  EXPECT_EQ(status_of(program + " " + folder_ + "/good.toml"), 1);  // no interface vcan1 here
}

}  // namespace
