// decode --csv and --json: fixed columns, numbers that read back, names that do not change.
#include <gtest/gtest.h>

#include <sstream>
#include <string>

#include "host_sim/can_log/decode.hpp"

namespace can_log {
namespace {

std::string rows(const std::string& log, DecodeFormat format, bool changes_only = false) {
  std::istringstream input(log);
  std::ostringstream output, messages;
  DecodeOptions options;
  options.format = format;
  options.changes_only = changes_only;
  decode(input, output, messages, options);
  return output.str();
}

const char* const kHead = "time_s,interface,sender,frame,name,value,std,unit,status\n";

// The frames of the protocol page: estimate 0 of node 1 is viscous[1-2], 20.0012 +- 0.0123; then a status frame with the
// faults EMERGENCY_STOP and DRIVE_LIMIT (bits 0 and 4), mode 4, quality 4.
const char* const kLog =
    "(1000000000.000000) vcan0 410#C06837770C301072\n"
    "(1000000000.010000) vcan0 681#000502010200\n"
    "(1000000000.050250) vcan0 410#C06837770C301072\n"
    "(1000000000.100000) vcan0 187#1100440A04030201\n";

TEST(Rows, CsvHasAHeadAndOneRowForEachSignal) {
  EXPECT_EQ(rows(kLog, DecodeFormat::kCsv),
            std::string(kHead) +
                "1000000000.000000,vcan0,node 1,estimate,estimate[0],20.0012,0.0123,SI,VALID\n"
                "1000000000.010000,vcan0,node 1,parameter,index,0,,1,\n"
                "1000000000.010000,vcan0,node 1,parameter,count,5,,1,\n"
                "1000000000.010000,vcan0,node 1,parameter,kind,2,,1,viscous\n"
                "1000000000.010000,vcan0,node 1,parameter,place_a,1,,1,\n"
                "1000000000.010000,vcan0,node 1,parameter,place_b,2,,1,\n"
                "1000000000.010000,vcan0,node 1,parameter,motion,0,,1,TRANSLATION\n"
                "1000000000.050250,vcan0,node 1,estimate,viscous[1-2],20.0012,0.0123,N s/m,VALID\n"
                "1000000000.100000,vcan0,node 7,status,faults,17,,1,EMERGENCY_STOP|DRIVE_LIMIT\n"
                "1000000000.100000,vcan0,node 7,status,mode,4,,1,INTEGRATE\n"
                "1000000000.100000,vcan0,node 7,status,quality,4,,1,ILL_CONDITIONED\n"
                "1000000000.100000,vcan0,node 7,status,condition_log2,10,,1,\n"
                "1000000000.100000,vcan0,node 7,status,update_counter,16909060,,1,\n");
}

TEST(Rows, JsonIsOneObjectALine) {
  EXPECT_EQ(
      rows("(0.1) can0 701#05\n(0.2) can0 590#0000A0410000803E\n(0.3) can0 590#0000C07F0000C07F\n",
           DecodeFormat::kJson),
      "{\"time_s\":0.100000,\"interface\":\"can0\",\"sender\":\"node 1\",\"frame\":\"heartbeat\",\"name\":\"state\","
      "\"value\":5,\"std\":null,\"unit\":\"1\",\"status\":\"OPERATIONAL\"}\n"
      "{\"time_s\":0.200000,\"interface\":\"can0\",\"sender\":\"node 1\",\"frame\":\"estimate_float\",\"name\":"
      "\"estimate[0]\",\"value\":20,\"std\":0.25,\"unit\":\"SI\",\"status\":\"\"}\n"
      // Not a number is null: JSON has no word for it.
      "{\"time_s\":0.300000,\"interface\":\"can0\",\"sender\":\"node 1\",\"frame\":\"estimate_float\",\"name\":"
      "\"estimate[0]\",\"value\":null,\"std\":null,\"unit\":\"SI\",\"status\":\"\"}\n");
}

// Beside mantissa and exponents what they mean, under a name that goes with the unit.
TEST(Rows, TheSizeOfACauseIsANumberBesideItsParts) {
  const std::string text =
      rows("(0.1) vcan0 481#010102077B000A00\n(0.2) vcan0 3A1#E9A9DB4517201014\n", DecodeFormat::kCsv);
  for (const char* row : {"diagnosis_size,value,1172023785,,10^exponent,\n", "diagnosis_size,std,8215,,10^(e+s),\n",
                          "diagnosis_size,exponent,-8,,1,\n", "diagnosis_size,std_exponent,4,,1,\n",
                          "diagnosis_size,cubic_stiffness[1-2],11.72023785,0.8215,N/m^3,CORRECTED\n"})
    EXPECT_NE(text.find(row), std::string::npos) << row << text;
}

// displacement[1]: 1e-9 m per code, offset 45; the code 12345 is 12300e-9 m. Until the scaling is known the name says
// that the number is a code, so a column never changes its unit.
TEST(Rows, SensorCodesAndSiValuesHaveDifferentNames) {
  const std::string text = rows(
      "(0.1) vcan0 1C1#7011393000FFFFFF\n(0.2) vcan0 691#21EE00CA9A3B0000\n(0.3) vcan0 6A1#212D0000FFFF7F\n"
      "(0.4) vcan0 1C1#7111393000FFFFFF\n",
      DecodeFormat::kCsv);
  EXPECT_NE(text.find("0.100000,vcan0,DOF 1,sensor_motion_24,displacement_code[1],12345,,codes,\n"), std::string::npos)
      << text;
  EXPECT_NE(text.find("0.400000,vcan0,DOF 1,sensor_motion_24,displacement[1],1.23e-05,,m,\n"), std::string::npos)
      << text;
}

TEST(Rows, ForeignAndErrorFramesKeepTheColumns) {
  const std::string text =
      rows("(0.1) can0 20000060#0000000000000000\n  can0  123   [2]  11 22\n(0.3) a,b\"c 124#\n", DecodeFormat::kCsv);
  EXPECT_NE(text.find("0.100000,can0,bus,error,error,96,,1,no acknowledgement; bus-off\n"), std::string::npos) << text;
  EXPECT_NE(text.find("\n,can0,-,0x123,bytes,,,,11 22\n"), std::string::npos) << text;
  EXPECT_NE(text.find("0.300000,a_b_c,-,0x124,bytes,,,,\n"), std::string::npos) << text;
}

TEST(Rows, ChangesOnly) {
  EXPECT_EQ(
      rows("(0.1) can0 701#05\n(0.2) can0 701#05\n(0.3) can0 702#05\n(0.4) can0 701#04\n", DecodeFormat::kCsv, true),
      std::string(kHead) +
          "0.100000,can0,node 1,heartbeat,state,5,,1,OPERATIONAL\n"
          "0.300000,can0,node 2,heartbeat,state,5,,1,OPERATIONAL\n"
          "0.400000,can0,node 1,heartbeat,state,4,,1,STOPPED\n");
}

}  // namespace
}  // namespace can_log
