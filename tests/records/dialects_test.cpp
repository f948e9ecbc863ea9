// Every way in which people's programs write a table of numbers: each row makes its file and says what comes out of it.
#include <gtest/gtest.h>

#include <string>

#include "host_sim/records/csv/csv_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "tests/records/two_dofs.hpp"

namespace {

using host_sim::Quantity;
using two_dofs::rig;

std::string utf16(const std::string& ascii, bool big, bool mark) {
  std::string out = mark ? (big ? "\xFE\xFF" : "\xFF\xFE") : "";
  for (const char c : ascii) out += big ? std::string(1, '\0') + c : std::string(1, c) + '\0';
  return out;
}

std::string with_line_ends(std::string text, const std::string& end) {
  for (size_t at = 0; (at = text.find('\n', at)) != std::string::npos; at += end.size()) text.replace(at, 1, end);
  return text;
}

const std::string kPlain = "t_s,force_1_N,displacement_1_m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n";

struct Dialect {
  const char* name;
  std::string text;
  const char* note;  // must stand in the notes; nullptr: there are none
};

// All of them are the plain table.
TEST(Dialects, AllSayTheSame) {
  const Dialect dialects[] = {
      {"plain", kPlain, nullptr},
      {"a line below the names",
       "t_s, force_1_N, displacement_1_m\n-------------\n0, 1.5, -0.25\n0.5, 2, 0.5\n1, -3e-3, 0.75\n", nullptr},
      {"a line of another sign",
       "t_s\tforce_1_N\tdisplacement_1_m\n=====\t=====\t=====\n0\t1.5\t-0.25\n0.5\t2\t0.5\n1\t-3e-3\t0.75\n", nullptr},
      {"semicolons", "t_s;force_1_N;displacement_1_m\n0;1.5;-0.25\n0.5;2;0.5\n1;-3e-3;0.75\n", nullptr},
      {"tabs", "t_s\tforce_1_N\tdisplacement_1_m\n0\t1.5\t-0.25\n0.5\t2\t0.5\n1\t-3e-3\t0.75\n", nullptr},
      {"blanks", "  t_s   force_1_N  displacement_1_m\n 0   1.5 -0.25\n0.5 2   0.5 \n1 -3e-3 0.75\n", nullptr},
      {"decimal commas", "t_s;force_1_N;displacement_1_m\n0;1,5;-0,25\n0,5;2;0,5\n1;-3e-3;0,75\n", nullptr},
      {"decimal commas, tabs", "t_s\tforce_1_N\tdisplacement_1_m\n0\t1,5\t-0,25\n0,5\t2,0\t0,5\n1\t-3E-3\t0,75\n",
       nullptr},
      {"quoted heads", "\"t_s\",\"force_1_N\",\"displacement_1_m\"\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"quoted numbers",
       "\"t_s\",\"force_1_N\",\"displacement_1_m\"\n\"0\",\"1.5\",\"-0.25\"\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"quoted decimal commas", "t_s;force_1_N;displacement_1_m\n\"0\";\"1,5\";\"-0,25\"\n0,5;2;0,5\n1;-3e-3;0,75\n",
       nullptr},
      {"comments",
       "# rig 7, 21 November\n% level 1\nt_s,force_1_N,displacement_1_m\n# start\n0,1.5,-0.25\n# "
       "knock\n0.5,2,0.5\n1,-3e-3,0.75\n# end\n",
       nullptr},
      {"names in a comment", "# t_s force_1_N displacement_1_m\n0 1.5 -0.25\n0.5 2 0.5\n1 -3e-3 0.75\n", nullptr},
      {"names in a comment, commas",
       "# run 3\n# t_s,force_1_N,displacement_1_m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"row of SI units", "t_s,force_1_N,displacement_1_m\ns,N,m\n0,1.5,-0.25\n0.5,2,0.5\n1,-3e-3,0.75\n", nullptr},
      {"row of units", "t_s,force_1,displacement_1\ns,kN,mm\n0,1.5e-3,-250\n0.5,2e-3,500\n1,-3e-6,750\n",
       "displacement_1_m from column \"displacement_1\" in mm: values times 0.001"},
      {"row of units in brackets", "Time;Force 1;Displacement 1\n[s];[N];[mm]\n0;1,5;-250,0\n0,5;2;500\n1;-3e-3;750\n",
       "values times 0.001"},
      {"units in heads", "Time (s),Force 1 (N),Displacement 1 (cm)\n0,1.5,-25\n0.5,2,50\n1,-3e-3,75\n",
       "values times 0.01"},
      {"units in names", "time_ms,force_1_kN,displacement_1_um\n0,1.5e-3,-0.25e6\n500,2e-3,0.5e6\n1000,-3e-6,0.75e6\n",
       "force_1_N from column \"force_1_kN\" in kN: values times 1000"},
      {"further columns",
       "t_s,date,force_1_N,displacement_1_m,temperature_C\n0,\"22.11.2026, "
       "noon\",1.5,-0.25,20\n0.5,later,2,0.5,20\n1,,-3e-3,0.75,\n",
       "ignored: \"date\", \"temperature_C\""},
      {"time behind", "force_1_N,displacement_1_m,t_s\n1.5,-0.25,0\n2,0.5,0.5\n-3e-3,0.75,1\n", nullptr},
      {"separator at line ends", "t_s;force_1_N;displacement_1_m;\n0;1.5;-0.25;\n0.5;2;0.5;\n1;-3e-3;0.75;\n", nullptr},
      {"separator at rows' ends alone", "t_s;force_1_N;displacement_1_m\n0;1.5;-0.25;\n0.5;2;0.5;\n1;-3e-3;0.75;\n",
       nullptr},
      {"a preamble",
       "Operator;Miller\nTime;12:00:07\n\nt_s;force_1_N;displacement_1_m\n0;1.5;-0.25\n0.5;2;0.5\n1;-3e-3;0.75\n",
       "passed over: 2 lines"},
      {"dates",
       "timestamp,force_1_N,displacement_1_m\n2026-03-01T23:59:59.500,1.5,-0.25\n"
       "2026-03-02T00:00:00.000Z,2,0.5\n2026-03-02 00:00:00.5,-3e-3,0.75\n",
       nullptr},
      {"dates of Europe",
       "Zeit;force_1_N;displacement_1_m\n28.02.2026 23:59:59,500;1,5;-0,25\n"
       "01.03.2026 00:00:00;2;0,5\n01.03.2026 00:00:00,500;-3e-3;0,75\n",
       nullptr},
      {"dates of America, quoted",
       "Time,force_1_N,displacement_1_m\n\"12/31/2026 23:59:59.0\",1.5,-0.25\n"
       "\"12/31/2026 23:59:59.5\",2,0.5\n\"01/01/2027 00:00:00\",-3e-3,0.75\n",
       nullptr},
      {"times of day past midnight",
       "time\tforce_1_N\tdisplacement_1_m\n23:59:59.5\t1.5\t-0.25\n0:00:00\t2\t0.5\n00:00:00.5\t-3e-3\t0.75\n",
       nullptr},
      {"twelve hours, and words behind some rows",
       "Device Serial Number: 0\nSample, Date/Time, Force 1 (N), Displacement 1 (m), Events\n"
       "1, 05/13/2022 11:59:59.500 AM, 1.5, -0.25, Start\n2, 05/13/2022 12:00:00.000 PM, 2, 0.5\n"
       "3, 05/13/2022 12:00:00.5 pm, -3e-3, 0.75, Pause, Stop\n",
       "ignored: \"Sample\", \"Events\""},
      {"words behind units, and ends without values",
       "Time (s) Run 1;Force 1 (N) Run 1;Displacement 1 (m) Run "
       "1\n-0,5;;0\n0;1,5;-0,25\n0,5;2;0,5\n1;-3e-3;0,75\n1,5;4;\n2;;\n",
       "left out: 1 rows at the start and 2 at the end without a value of force_1_N, displacement_1_m"},
      {"NaN at the ends",
       "t_s,force_1_N,displacement_1_m\n0,NaN,NaN\n0.5,1.5,-0.25\n1,2,0.5\n1.5,-3e-3,0.75\n2,nan,1\n",
       "left out: 1 rows at the start and 1 at the end"},
      {"LabVIEW",
       "LabVIEW Measurement\t\nSeparator\tTab\nTime\t10:11:12.1\n***End_of_Header***\t\n\t\nY_Unit_Label\tkN\tmm\n"
       "X_Dimension\tTime\tTime\nX0\t0.0\t0.0\n***End_of_Header***\t\t\nX_Value\tForce 1\tDisplacement 1\tComment\n"
       "0\t0.0015\t-250\n0.5\t0.002\t500\n1\t-3e-6\t750\n",
       "in kN: values times 1000"},
      {"a row of units with a clock's pattern",
       "Time,Force 1,Displacement 1\nhh:mm:ss.f,N,mm\n10:59:59.5,1.5,-250\n11:00:00.0,2,500\n11:00:00.5,-3e-3,750\n",
       "in mm: values times 0.001"},
      {"a clock's pattern in the head",
       "Zeit [hh:mm:ss];force_1_N;displacement_1_m\n10:59:59,5;1,5;-0,25\n11:00:00;2;0,5\n11:00:00,5;-3e-3;0,75\n",
       nullptr},
      {"CASSY Lab, with quotes around the names' words",
       "MIN=0\t-5\t-1\nMAX=900\t1\t5\nSCALE=900\t0,5\t5\nDEC=1\t3\t4\n"
       "DEF=\"Zeit\" t / s\t\"Force 1\" / kN\t\"Displacement 1\" / "
       "mm\n0\t0,0015\t-250\n0,5\t0,002\t500\n1\t-3e-6\t750\n",
       "in kN: values times 1000"},
      {"CRLF", with_line_ends(kPlain, "\r\n"), nullptr},
      {"CR", with_line_ends(kPlain, "\r"), nullptr},
      {"UTF-8 mark", "\xEF\xBB\xBF" + kPlain, nullptr},
      {"UTF-16 little endian", utf16(kPlain, false, true), nullptr},
      {"UTF-16 big endian", utf16(kPlain, true, true), nullptr},
      {"UTF-16 without a mark", utf16(kPlain, false, false), nullptr},
      {"UTF-16 with CRLF", utf16(with_line_ends(kPlain, "\r\n"), false, true), nullptr},
  };
  for (const Dialect& dialect : dialects) {
    SCOPED_TRACE(dialect.name);
    host_sim::Record record;
    ASSERT_NO_THROW(
        try { record = host_sim::parse_csv(dialect.text, "d.csv", rig()); } catch (const std::exception& e) {
          ADD_FAILURE() << e.what();
          throw;
        });
    ASSERT_EQ(record.channels.size(), 2u);
    ASSERT_EQ(record.samples(), 3u);
    EXPECT_DOUBLE_EQ(record.sample_period_s, 0.5);
    const double force[] = {1.5, 2.0, -3e-3}, displacement[] = {-0.25, 0.5, 0.75};
    for (size_t i = 0; i < 3; ++i) {
      EXPECT_DOUBLE_EQ(record.find(Quantity::kForce, 1)->values[i], force[i]);
      EXPECT_DOUBLE_EQ(record.find(Quantity::kDisplacement, 1)->values[i], displacement[i]);
    }
    std::string notes;
    for (const std::string& note : record.notes) notes += note + "\n";
    if (dialect.note == nullptr) {
      EXPECT_EQ(notes, "");
    } else {
      EXPECT_NE(notes.find(dialect.note), std::string::npos) << notes;
    }
  }
}

}  // namespace
