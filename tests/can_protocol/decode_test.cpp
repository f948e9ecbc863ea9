// decode as its reader sees it: whole lines, worked out from the page; foreign and broken lines survive.
#include "host_sim/can_log/decode.hpp"

#include <gtest/gtest.h>

#include <cstdio>
#include <random>
#include <sstream>
#include <string>

#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/known_names.hpp"

namespace can_log {
namespace {

struct Decoded {
  std::string text, messages;
  DecodeSummary summary;
};

Decoded decoded(const std::string& log, DecodeOptions options = {}) {
  std::istringstream input(log);
  std::ostringstream output, messages;
  Decoded result;
  result.summary = decode(input, output, messages, options);
  result.text = output.str();
  result.messages = messages.str();
  return result;
}

TEST(Decode, AnEstimateIsOneLineWithItsName) {
  // The frames of the page: estimate 0 of node 1 is viscous[1-2], 20.0012 +- 0.0123.
  const Decoded result = decoded(
      "(1000000000.000000) vcan0 681#000502010200\n"
      "(1000000000.050250) vcan0 410#C06837770C301072\n");
  EXPECT_EQ(
      result.text,
      "1000000000.000000  vcan0  node 1  parameter     estimate 0 of 5 is viscous[1-2] in N s/m\n"
      "1000000000.050250  vcan0  node 1  estimate      viscous[1-2]   = 20.0012 N s/m         std 0.012     VALID\n");
  EXPECT_EQ(result.messages, "");
}

// The same estimate as single precision (20 is 0x41A00000, 0.5 is 0x3F000000, low byte first): under its number, and whose it is as
// soon as that is known.
TEST(Decode, AFloatEstimateSaysWhoseItIs) {
  char id[8];
  std::snprintf(id, sizeof id, "%03X", firmware::pack_estimate_float(1, 0, {}).id);
  const std::string frame = std::string(" can0 ") + id + "#0000A0410000003F\n";
  const std::string text = decoded("(1.0)" + frame + "(2.0) can0 681#000502010200\n(3.0)" + frame).text;
  EXPECT_NE(text.find("float 0 value = 20 SI\n"), std::string::npos) << text;
  EXPECT_NE(text.find("float 0 value = 20 N s/m  of viscous[1-2]\n"), std::string::npos) << text;
  EXPECT_NE(text.find("float 0 std = 0.5 N s/m  of viscous[1-2]\n"), std::string::npos) << text;
}

TEST(Decode, NamesAreThoseOfTheNodeThatSentThem) {
  // Node 2 sends the same estimate without a name: index and SI. A rotating Coulomb term on the base: coulomb[3-base]
  // in N m.
  const Decoded result = decoded(
      "(1.0) vcan0 681#000502010200\n(2.0) vcan0 420#C06837770C301072\n"
      "(3.0) vcan0 682#000503031101\n(4.0) vcan0 420#C06837770C303072\n");
  EXPECT_NE(result.text.find("node 2  estimate      estimate 0     = 20.0012 SI"), std::string::npos) << result.text;
  // Status bits: 0x30 = 0x10 + 1 * 32: STALE.
  EXPECT_NE(result.text.find("coulomb[3-base] = 20.0012 N m           std 0.012     STALE"), std::string::npos)
      << result.text;
}

TEST(Decode, AnEstimateShowsTheDigitsThatItsStandardDeviationLeaves) {
  // 20.0012 = 2000120000e-8 = 0x773768C0 each time; std 1 (one count): e-8, e-6, e-2, e+4: byte 7 is 0, 2, 6 and C.
  // 20 / 1e-8: ten digits; 20 / 1e-6 = 2e7: 8 + 2 = ten; 20 / 1e-2 = 2e3: 4 + 2 = six; 20 / 1e4: four at the least.
  // A std of 0 leaves all digits. 1999999963e-8 = 0x773593DB is told from 20 where the std allows it.
  EXPECT_NE(decoded("(1.0) can0 410#C068377701001000\n").text.find(" = 20.0012 SI "), std::string::npos);
  EXPECT_NE(decoded("(1.0) can0 410#DB93357701001002\n").text.find(" = 19.99999963 SI "), std::string::npos);
  EXPECT_NE(decoded("(1.0) can0 410#DB93357701001006\n").text.find(" = 20 SI "), std::string::npos);
  EXPECT_NE(decoded("(1.0) can0 410#C06837770100100C\n").text.find(" = 20 SI "), std::string::npos);
  EXPECT_NE(decoded("(1.0) can0 410#DB93357700001000\n").text.find(" = 19.99999963 SI "), std::string::npos);
}

TEST(Decode, ChangesOnlyLeavesOutWhatSaysTheSame) {
  const std::string log =
      "(0.1) vcan0 701#05\n(0.2) vcan0 701#05\n(0.2) vcan0 702#05\n(0.3) vcan0 701#04\n(0.4) vcan0 701#05\n"
      "(0.5) vcan0 681#000502010200\n(0.6) vcan0 681#000502010200\n";
  DecodeOptions options;
  options.changes_only = true;
  EXPECT_EQ(decoded(log, options).text,
            "         0.100000  vcan0  node 1  heartbeat     state = OPERATIONAL\n"
            "         0.200000  vcan0  node 2  heartbeat     state = OPERATIONAL\n"
            "         0.300000  vcan0  node 1  heartbeat     state = STOPPED\n"
            "         0.400000  vcan0  node 1  heartbeat     state = OPERATIONAL\n"
            "         0.500000  vcan0  node 1  parameter     estimate 0 of 5 is viscous[1-2] in N s/m\n");
  EXPECT_EQ(decoded(log).summary.frames, 7u);
}

TEST(Decode, OneLinePerSignalWithUnitsAndStates) {
  EXPECT_EQ(decoded("(0.1) vcan0 187#1100440A04030201\n").text,
            "         0.100000  vcan0  node 7  status        faults = EMERGENCY_STOP | DRIVE_LIMIT\n"
            "         0.100000  vcan0  node 7  status        mode = INTEGRATE\n"
            "         0.100000  vcan0  node 7  status        quality = ILL_CONDITIONED\n"
            "         0.100000  vcan0  node 7  status        condition_log2 = 10\n"
            "         0.100000  vcan0  node 7  status        update_counter = 16909060\n");
  EXPECT_EQ(decoded("(0.1) vcan0 481#010102077B000A00\n").text,
            "         0.100000  vcan0  node 1  diagnosis     cause = cubic_stiffness on link 1-2\n"
            "         0.100000  vcan0  node 1  diagnosis     unexplained = 12.3 %\n"
            "         0.100000  vcan0  node 1  diagnosis     gained = 1 %\n");
  EXPECT_EQ(decoded("(0.1) vcan0 082#02FF1143E8030000\n").text,
            "         0.100000  vcan0  node 2  emergency     code = SENSOR_SATURATED\n"
            "         0.100000  vcan0  node 2  emergency     error_register = GENERIC | COMMUNICATION\n"
            "         0.100000  vcan0  node 2  emergency     channel = velocity[3]\n"
            "         0.100000  vcan0  node 2  emergency     detail = 1000\n");
}

// value 1172023785, std 8215, exponent -8 (less 24: 16), std_exponent 4, corrected: 11.72023785 +- 0.8215.
TEST(Decode, TheSizeOfACauseIsANumber) {
  const std::string frame = "(0.2) vcan0 3A1#E9A9DB4517201014\n";
  EXPECT_EQ(decoded(frame).text,
            "         0.200000  vcan0  node 1  diagnosis_size  size = 11.72 SI  std 0.82  CORRECTED\n");
  const std::string cubic = decoded("(0.1) vcan0 481#010102077B000A00\n" + frame).text;
  EXPECT_NE(cubic.find("diagnosis_size  cubic_stiffness[1-2] = 11.72 N/m^3  std 0.82"), std::string::npos) << cubic;
  const std::string late = decoded("(0.1) vcan0 481#1201FF027B000A00\n" + frame).text;
  EXPECT_NE(late.find("sensor_delay[velocity[1]] = 11.72 s  std 0.82"), std::string::npos) << late;
  const std::string unknown = decoded("(0.1) vcan0 481#FF1F1F077B000A00\n" + frame).text;
  EXPECT_NE(unknown.find("diagnosis_size  size = 11.72 SI"), std::string::npos) << unknown;
}

TEST(Decode, SensorCodesInUnitsOnceTheScalingIsKnown) {
  // displacement[1]: 1e-9 m per code (1000000000e-18), offset 45; the code 12345 is 12300e-9 m.
  const Decoded result = decoded(
      "(0.1) vcan0 1C1#7011393000FFFFFF\n(0.2) vcan0 691#21EE00CA9A3B0000\n(0.3) vcan0 6A1#212D0000FFFF7F\n"
      "(0.4) vcan0 1C1#7111393000FFFFFF\n");
  EXPECT_NE(result.text.find("DOF 1   motion_24     displacement[1] = 12345 codes\n"), std::string::npos)
      << result.text;
  EXPECT_NE(result.text.find("displacement[1] = 12345 codes = 1.23e-05 m\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("velocity[1] = -1 codes\n"), std::string::npos) << result.text;
}

TEST(Decode, SdoInWords) {
  const Decoded result = decoded(
      "(0.1) can0 601#4008100000000000\n(0.2) can0 581#410810000B000000\n(0.3) can0 601#6000000000000000\n"
      "(0.4) can0 581#0072696720646170\n(0.5) can0 601#2B171000F4010000\n(0.6) can0 581#6017100000000000\n"
      "(0.7) can0 601#2310100173617665\n(0.8) can0 581#8010100100000606\n");
  for (const char* line :
       {"read device_name (1008.0)\n", "device_name (1008.0) has 11 characters\n", "read on\n", "part = 'rig dap'\n",
        "write heartbeat_time (1017.0) = 500 (0x01F4)\n", "heartbeat_time (1017.0) written\n",
        "write save (1010.1) = 1702257011 (0x65766173) 'save'\n",
        "abort of save (1010.1): 0x06060000 hardware error\n"})
    EXPECT_NE(result.text.find(line), std::string::npos) << line << result.text;
}

TEST(Decode, ForeignErrorFdAndBrokenLinesSurvive) {
  const Decoded result = decoded(
      "(1700000000.000001)    can0 123#00 R\n"
      "(1700000000.000000001) can0 20000004#0004000000000000\n"
      "noise\n"
      "(1700000000.2) vcan0 700##50000000000000000\n"
      "(1.0) can0 181#00\n"
      "(1.0) can0 701#R\n"
      "  can0  081   [8]  00 00 00 00 FF 00 00 00\n");
  EXPECT_NE(result.text.find("0x123         [1] 00   (not of this protocol)\n"), std::string::npos) << result.text;
  EXPECT_NE(result.text.find("error frame   controller problem (receive error warning)\n"), std::string::npos);
  EXPECT_NE(result.text.find("0x700         [8] 00 00 00 00 00 00 00 00   (not of this protocol)\n"),
            std::string::npos);
  EXPECT_NE(result.text.find("status        [1] 00   (too short: 8 bytes expected)\n"), std::string::npos);
  EXPECT_NE(result.text.find("0x701         remote request\n"), std::string::npos);
  EXPECT_NE(result.text.find("                -  can0   node 1  emergency     code = NO_ERROR\n"), std::string::npos);
  EXPECT_EQ(result.messages, "decode: 1 of 7 lines skipped: no candump frame (the first is line 3)\n");
  EXPECT_EQ(result.summary.frames, 6u);
  EXPECT_EQ(result.summary.foreign_frames, 4u);  // 123, 700, the short one, the remote one
  EXPECT_EQ(result.summary.skipped_lines, 1u);
}

TEST(Decode, RandomFramesAreSurvived) {
  std::mt19937_64 random(6);
  static const char kDigits[] = "0123456789ABCDEF";
  std::string log;
  for (int i = 0; i < 20000; ++i) {
    log += "(1.0) can0 ";
    for (uint64_t id = random() % 0x800, k = 3; k-- > 0;) log += kDigits[id >> (4 * k) & 15];
    const bool fd = random() % 8 == 0;
    log += fd ? "##1" : "#";
    const bool full = random() % 2 == 0;
    for (uint64_t n = full ? (fd ? 64 : 8) : random() % 9; n > 0; --n) {
      log += kDigits[random() % 16];
      log += kDigits[random() % 16];
    }
    log += '\n';
  }
  const Decoded result = decoded(log);
  EXPECT_EQ(result.summary.frames, 20000u);
  EXPECT_EQ(result.summary.skipped_lines, 0u);
  EXPECT_LT(result.summary.foreign_frames, 20000u);
}

}  // namespace
}  // namespace can_log
