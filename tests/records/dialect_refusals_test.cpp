// Tables that cannot be read, and the reason that is given.
#include <gtest/gtest.h>

#include <string>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "tests/records/two_dofs.hpp"

namespace {

using host_sim::ReadingOptions;
using two_dofs::rig;

struct Refused {
  const char* name;
  std::string text;
  ReadingOptions options;
  const char* says;
};

ReadingOptions column(const char* channel, const char* name) {
  ReadingOptions options;
  options.columns = {{channel, name}};
  return options;
}

TEST(Dialects, RefusesWithTheReason) {
  const Refused cases[] = {
      {"shaped like a channel",
       "t_s,wobble_1_m\n0,1\n1,1\n",
       {},
       "d.csv:1: channel \"wobble_1_m\": is not a channel name"},
      {"no channel", "t_s,a,b\n0,1,2\n1,1,2\n", {}, "d.csv:1: names no channel (\"t_s\", \"a\", \"b\")"},
      {"unknown column", "t_s,a\n0,1\n1,1\n", column("force_1", "b"),
       "has no column \"b\" for force_1, expected one of \"t_s\", \"a\""},
      {"number in place of a name", "t_s,a\n0,1\n1,1\n", column("force_1", "2"),
       "has no column \"2\" for force_1, expected one of \"t_s\", \"a\", or a place: force_1=#2"},
      {"column of no channel", "t_s,a\n0,1\n1,1\n", column("wobble", "a"), "channel \"wobble\": is not a channel name"},
      {"unknown unit", "t_s,force_1 [parsec]\n0,1\n1,1\n", {}, "is in \"parsec\", which is no known unit"},
      {"wrong kind of unit", "t_s,force_1 [mm]\n0,1\n1,1\n", {}, "is in mm, expected a unit such as N for force_1_N"},
      {"name against units row",
       "t_s,force_1_N\ns,kN\n0,1\n1,1\n",
       {},
       "has the unit \"kN\", expected N as its name says"},
      {"voltage alone", "t_s,acceleration_1 [mV]\n0,1\n1,1\n", {}, "--sensitivity acceleration_1=\"100 mV/m/s2\""},
      {"two columns of one channel", "t_s,force_1_N,force_1_kN\n0,1,1\n1,1,1\n", {}, "stands twice"},
      {"mixed decimals", "t_s;force_1_N\n0;1,5\n1;1.5\n2;2,5\n", {}, "expected a finite number"},
      {"comma among points",
       "t_s;force_1_N\n0;1.5\n1;1,5\n",
       {},
       "d.csv:3: column force_1_N is \"1,5\", expected a finite number with a decimal point"},
      {"decimal commas between commas",
       "t_s,force_1_N\n0,000,1,5\n0,001,2,5\n",
       {},
       "d.csv:2: has more fields, expected 2 numbers separated by commas, as many as line 1 has names; where commas "
       "are the "
       "decimal points too, save it with semicolons between the fields"},
      {"no time", "force_1_N,velocity_1_m_s\n1,2\n1,2\n", {}, "expected t_s, then channels, or --sample-rate"},
      {"a value missing amid others",
       "t_s;force_1_N;velocity_1_m_s\n0;1;\n1;1;2\n2;1;\n3;1;2\n",
       {},
       "d.csv:4: column velocity_1_m_s is \"\", expected a finite number"},
      {"no value at all", "t_s;force_1_N\n0;\n1;\n", {}, "column force_1_N is \"\", expected a finite number"},
      {"names missing", "0 1 2\n1 1 2\n", {}, "d.csv:1: holds no names of columns above its 3 columns of numbers"},
      {"no unit", "t_s,force_1\n0,1\n1,1\n", {}, "has no unit; did you mean \"force_1_N\"?"},
      {"line behind comments", "# a\nt_s,force_1_N\n0,1\n# b\n1,x\n", {}, "d.csv:5: column force_1_N is \"x\""},
      {"uneven behind comments", "t_s,force_1_N\n0,1\n1,1\n# b\n2,1\n4,1\n5,1\n6,1\n", {}, "d.csv:6: t_s steps by 2 s"},
  };
  for (const Refused& refused : cases) {
    SCOPED_TRACE(refused.name);
    try {
      host_sim::parse_csv(refused.text, "d.csv", rig(), refused.options);
      ADD_FAILURE() << "accepted";
    } catch (const host_sim::DataFileError& error) {
      EXPECT_NE(std::string(error.what()).find(refused.says), std::string::npos) << error.what();
    }
  }
}

}  // namespace
