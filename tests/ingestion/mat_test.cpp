// MAT files: written with libmatio, read back; structs, number classes, and what is refused.
#include <gtest/gtest.h>
#include <matio.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>

#include "host_sim/ingestion/mat/mat_reader.hpp"
#include "host_sim/ingestion/record_reader.hpp"
#include "tests/ingestion/rigs.hpp"

namespace {

using host_sim::Quantity;
// The one record of a file.
host_sim::Record one_record(const std::string& path, const rig_file::RigModel& model,
                            const host_sim::ReadingOptions& options = {}) {
  auto records = host_sim::read_mat(path, model, options);
  EXPECT_EQ(records.size(), 1u);
  return records.front();
}
using test_rigs::dampers;
using test_rigs::expect_says;
using test_rigs::refusal;

// A MAT file in the making; removed at the end.
class MatFile {
 public:
  explicit MatFile(mat_ft version = MAT_FT_MAT5)
      : path_(testing::TempDir() + "written_by_test_" + std::to_string(getpid()) + ".mat"),
        file_(Mat_CreateVer(path_.c_str(), nullptr, version)) {}
  ~MatFile() {
    close();
    std::remove(path_.c_str());
  }
  MatFile& add(const char* name, std::vector<double> values, size_t rows = 0) {
    matvar_t* const variable = vector(name, values, rows);
    Mat_VarWrite(file_, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
    return *this;
  }
  MatFile& add(matvar_t* variable) {
    Mat_VarWrite(file_, variable, MAT_COMPRESSION_NONE);
    Mat_VarFree(variable);
    return *this;
  }
  static matvar_t* vector(const char* name, std::vector<double>& values, size_t rows = 0) {
    size_t sizes[2] = {rows ? rows : values.size(), rows ? values.size() / rows : 1};
    return Mat_VarCreate(name, MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, values.data(), 0);
  }
  const std::string& path() {
    close();
    return path_;
  }

 private:
  void close() {
    if (file_ != nullptr) Mat_Close(file_);
    file_ = nullptr;
  }
  std::string path_;
  mat_t* file_;
};

TEST(Mat, ReadsVectorsByName) {
  MatFile file;
  file.add("t_s", {0.5, 0.6, 0.7}).add("force_1_N", {1, 2, 3}, 1).add("displacement_1_m", {0.1, -0.2, 1.0 / 3.0});
  const auto record = one_record(file.path(), dampers(1));
  EXPECT_NEAR(record.sample_period_s, 0.1, 1e-15);
  EXPECT_EQ(record.start_s, 0.5);
  EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{1, 2, 3}));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{0.1, -0.2, 1.0 / 3.0}));
}

TEST(Mat, VersionWithHdf5ReadsTheSame) {
  MatFile file(MAT_FT_MAT73);
  file.add("sample_rate_Hz", {250}).add("displacement_1_m", {1, 2, 3});
  const auto record = one_record(file.path(), dampers(1));
  EXPECT_EQ(record.sample_period_s, 0.004);
  EXPECT_EQ(record.start_s, 0.0);
  EXPECT_EQ(record.channels.at(0).values, (std::vector<double>{1, 2, 3}));
}

TEST(Mat, FieldsOfAStructAreChannels) {
  std::vector<double> rate = {100}, force = {4, 5}, speed = {6, 7};
  const char* names[] = {"sample_rate_Hz", "force_1_N", "velocity_1_m_s"};
  size_t one[2] = {1, 1};
  matvar_t* const record_variable = Mat_VarCreateStruct("run_1", 2, one, names, 3);
  matvar_t* const fields[] = {MatFile::vector(nullptr, rate), MatFile::vector(nullptr, force),
                              MatFile::vector(nullptr, speed)};
  for (int i = 0; i < 3; ++i) Mat_VarSetStructFieldByName(record_variable, names[i], 0, fields[i]);
  MatFile file;
  file.add(record_variable);
  const auto record = one_record(file.path(), dampers(1));
  EXPECT_EQ(record.sample_period_s, 0.01);
  EXPECT_EQ(record.find(Quantity::kVelocity, 1)->values, (std::vector<double>{6, 7}));
}

TEST(Mat, AnyRealNumberClassIsTaken) {
  float single[] = {0.5f, 1.5f};
  int16_t codes[] = {-3, 4};
  size_t sizes[2] = {1, 2};
  MatFile file;
  file.add("sample_rate_Hz", {10});
  file.add(Mat_VarCreate("force_1_N", MAT_C_SINGLE, MAT_T_SINGLE, 2, sizes, single, 0));
  file.add(Mat_VarCreate("displacement_1_m", MAT_C_INT16, MAT_T_INT16, 2, sizes, codes, 0));
  const auto record = one_record(file.path(), dampers(1));
  EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{0.5, 1.5}));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{-3, 4}));
}

TEST(Mat, TextAndOtherScalarsArePassedOver) {
  char text[] = "shaker 2";
  size_t sizes[2] = {1, 8};
  MatFile file;
  file.add(Mat_VarCreate("comment", MAT_C_CHAR, MAT_T_UINT8, 2, sizes, text, 0));
  file.add("run", {7}).add("sample_rate_Hz", {10}).add("displacement_1_m", {1, 2});
  EXPECT_EQ(one_record(file.path(), dampers(1)).channels.size(), 1u);
}

TEST(Mat, ReadRecordKnowsTheFormat) {
  MatFile file;
  file.add("sample_rate_Hz", {10}).add("displacement_1_m", {1, 2});
  EXPECT_EQ(host_sim::read_record(file.path(), dampers(1)).samples(), 2u);
}

TEST(Mat, RefusesWithTheVariablesName) {
  const auto say = [](MatFile& file) { return refusal([&] { one_record(file.path(), dampers(1)); }); };
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10}).add("displacement_2_m", {1, 2})), "\"displacement_2_m\"");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10}).add("data", {1, 2})), "\"data\"");
  }
  {
    MatFile file;
    expect_says(say(file.add("displacement_1_m", {1, 2})), "no time, expected a variable t_s or sample_rate_Hz");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10})), "no channel, expected variables such as");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {-1}).add("displacement_1_m", {1, 2})),
                "variable \"sample_rate_Hz\": expected one number above 0");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10}).add("displacement_1_m", {1, 2, 3, 4}, 2)),
                "variable \"displacement_1_m\": not a vector");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10}).add("displacement_1_m", {1, 2}).add("force_1_N", {1, 2, 3})),
                "variable \"force_1_N\": 3 values, expected 2 as in displacement_1_m");
  }
  {
    MatFile file;
    expect_says(say(file.add("sample_rate_Hz", {10}).add("displacement_1_m", {1, NAN})),
                "variable \"displacement_1_m\": element 2 is not a finite number");
  }
  {
    MatFile file;  // steps 0.1, 0.1, 0.2: the fourth element is off
    expect_says(say(file.add("t_s", {0, 0.1, 0.2, 0.4}).add("displacement_1_m", {1, 2, 3, 4})), "element 4 of ");
  }
}

// 1e307 kN are more newtons than a double holds.
TEST(Mat, RefusesAValueThatItsUnitMakesInfinite) {
  MatFile file;
  file.add("fs", {250}).add("force_1_kN", {1, 1e307, 3});
  expect_says(refusal([&] { one_record(file.path(), dampers(1)); }),
              "variable \"force_1_kN\": element 2 is too large in SI units");
}

TEST(Mat, RefusesComplexNumbers) {
  double real[] = {1, 2}, imaginary[] = {3, 4};
  mat_complex_split_t both = {real, imaginary};
  size_t sizes[2] = {2, 1};
  {
    MatFile file;
    file.add("sample_rate_Hz", {10});
    file.add(Mat_VarCreate("force_1_N", MAT_C_DOUBLE, MAT_T_DOUBLE, 2, sizes, &both, MAT_F_COMPLEX));
    expect_says(refusal([&] { one_record(file.path(), dampers(1)); }), "variable \"force_1_N\": complex numbers");
  }
}

// runs(1) and runs(2): a record each; the sample rate stands beside them.
TEST(Mat, ArraysOfStructsAreRecords) {
  const char* names[] = {"force_1_N", "displacement_1_m"};
  size_t two[2] = {2, 1};
  matvar_t* const runs = Mat_VarCreateStruct("runs", 2, two, names, 2);
  std::vector<double> values[] = {{1, 2}, {3, 4}, {5, 6}, {7, 8}};
  for (size_t element = 0; element < 2; ++element)
    for (size_t field = 0; field < 2; ++field)
      Mat_VarSetStructFieldByName(runs, names[field], element, MatFile::vector(nullptr, values[2 * element + field]));
  MatFile file;
  file.add("fs", {100});
  file.add(runs);
  const auto records = host_sim::read_mat(file.path(), dampers(1));
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[1].find(Quantity::kForce, 1)->values, (std::vector<double>{5, 6}));
  EXPECT_EQ(records[1].sample_period_s, 0.01);
  EXPECT_NE(records[1].file.find("runs(2)"), std::string::npos);
}

TEST(Mat, OtherNamesUnitsAndVariables) {
  MatFile file;
  file.add("fs", {100})
      .add("Chan3", {1, 2})
      .add("force_1_kN", {3, 4})
      .add("temperature", {20, 21})
      .add("table", {1, 2, 3, 4}, 2);
  host_sim::ReadingOptions options;
  options.columns = {{"acceleration_1", "Chan3"}};
  options.units = {{"acceleration_1", "g"}};
  const auto record = one_record(file.path(), dampers(1), options);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kAcceleration, 1)->values[1], 2 * 9.80665);
  EXPECT_DOUBLE_EQ(record.find(Quantity::kForce, 1)->values[0], 3000.0);
  std::string notes;
  for (const std::string& note : record.notes) notes += note + "\n";
  EXPECT_NE(notes.find("ignored: \"temperature\", \"table\""), std::string::npos) << notes;
}

// A signal as Simulink logs it: struct{time, signals: struct{values}}.
matvar_t* logged(const char* name, std::vector<double> time, std::vector<double> values) {
  size_t one[2] = {1, 1};
  const char *outer[] = {"time", "signals"}, *inner[] = {"values"};
  matvar_t* const signals = Mat_VarCreateStruct("signals", 2, one, inner, 1);
  Mat_VarSetStructFieldByName(signals, "values", 0, MatFile::vector("values", values));
  matvar_t* const variable = Mat_VarCreateStruct(name, 2, one, outer, 2);
  Mat_VarSetStructFieldByName(variable, "time", 0, MatFile::vector("time", time));
  Mat_VarSetStructFieldByName(variable, "signals", 0, signals);
  return variable;
}

TEST(Mat, WhatSimulinkLogsIsOneRecord) {
  const std::vector<double> times = {0, 0.01, 0.02, 0.03};
  MatFile file;
  file.add(logged("shaker", times, {1, 2, 3, 4}))
      .add(logged("x", times, {5, 6, 7, 8}))
      .add(logged("other", times, {0, 0, 0, 0}));
  host_sim::ReadingOptions options;
  options.columns = {{"force_1", "shaker"}, {"displacement_1", "x"}};
  const auto record = one_record(file.path(), dampers(1), options);
  EXPECT_NEAR(record.sample_period_s, 0.01, 1e-12);
  EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{1, 2, 3, 4}));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{5, 6, 7, 8}));
}

TEST(Mat, WhatSimulinkLogsAtOtherTimesIsRefused) {
  MatFile file;
  file.add(logged("force_1_N", {0, 0.01, 0.02}, {1, 2, 3})).add(logged("displacement_1_m", {0, 0.02, 0.04}, {1, 2, 3}));
  const std::string message = refusal([&] { one_record(file.path(), dampers(1)); });
  expect_says(message, "\"displacement_1_m\"");
  expect_says(message, "other times");
}

// Two accelerations over time in the rows of a matrix, as some acquisition programs keep them, within a struct of a struct.
TEST(Mat, RowsOfAMatrixWithinAStructAreChannels) {
  MatFile file;
  std::vector<double> time = {0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7}, both;
  for (int i = 0; i < 8; ++i) both.push_back(i), both.push_back(10 + i);  // column by column
  const char* outer[] = {"Out"};
  const char* inner[] = {"Acc", "Time"};
  size_t one[2] = {1, 1};
  matvar_t* const out = Mat_VarCreateStruct("Out", 2, one, inner, 2);
  Mat_VarSetStructFieldByName(out, "Acc", 0, MatFile::vector("Acc", both, 2));
  Mat_VarSetStructFieldByName(out, "Time", 0, MatFile::vector("Time", time, 1));
  matvar_t* const beam = Mat_VarCreateStruct("Beam", 2, one, outer, 1);
  Mat_VarSetStructFieldByName(beam, "Out", 0, out);
  file.add(beam);
  host_sim::ReadingOptions options;
  options.columns = {{"acceleration_1", "Acc row 2"}};
  const auto record = one_record(file.path(), dampers(1), options);
  EXPECT_NE(record.file.find(", Beam.Out"), std::string::npos);
  EXPECT_NEAR(record.sample_period_s, 0.1, 1e-12);
  EXPECT_EQ(record.find(Quantity::kAcceleration, 1)->values, (std::vector<double>{10, 11, 12, 13, 14, 15, 16, 17}));
  const auto said = refusal([&] { host_sim::read_mat(file.path(), dampers(1), {}); });
  expect_says(said, "\"Acc row 1\", \"Acc row 2\", \"Time\"");
}

TEST(Mat, ColumnsOfAMatrixAreChannels) {
  MatFile file;
  file.add("sample_rate_Hz", {250}).add("data", {1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 13, 14, 15, 16, 17, 18}, 8);
  host_sim::ReadingOptions options;
  options.columns = {{"force_1", "data column 2"}, {"displacement_1", "data column 1"}};
  const auto record = one_record(file.path(), dampers(1), options);
  EXPECT_EQ(record.find(Quantity::kForce, 1)->values, (std::vector<double>{11, 12, 13, 14, 15, 16, 17, 18}));
  EXPECT_EQ(record.find(Quantity::kDisplacement, 1)->values, (std::vector<double>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST(Mat, RefusesAFileThatIsNone) {
  const std::string path = (std::filesystem::path(testing::TempDir()) / "none.mat").string();
  std::FILE* const file = std::fopen(path.c_str(), "wb");
  std::fputs("this is not a MAT file, whatever its name says, and long enough to look like one...", file);
  std::fclose(file);
  expect_says(refusal([&] { one_record(path, dampers(1)); }), path + ": is no MAT file that can be read");
  std::remove(path.c_str());
}

// The sizes of a variable, as they stand in the file, and the bytes of its numbers contradict each other: 200 numbers are there.
TEST(Mat, SizesThatTheNumbersDoNotFillAreRefused) {
  for (const uint32_t rows : {199u, 201u, 0x6D01012Cu}) {
    MatFile file;
    file.add("sample_rate_Hz", {250}).add("force_1_N", std::vector<double>(200, 1.5));
    const std::string path = file.path();
    std::fstream bytes(path, std::ios::binary | std::ios::in | std::ios::out);
    std::string text((std::istreambuf_iterator<char>(bytes)), {});
    const size_t sizes = text.find(std::string("\5\0\0\0\10\0\0\0\310\0\0\0", 12));  // type 5, 8 bytes, 200
    ASSERT_NE(sizes, std::string::npos);
    bytes.clear();
    bytes.seekp(static_cast<std::streamoff>(sizes + 8));
    bytes.write(reinterpret_cast<const char*>(&rows), 4);
    bytes.close();
    const std::string said = refusal([&] { one_record(path, dampers(1)); });
    expect_says(said, "variable \"force_1_N\": is to hold " + std::to_string(rows) + " numbers");
    expect_says(said, "its bytes are those of 200");
  }
}

// The same in a compressed variable, made with Python's zlib: force_1_N of 200 noughts that is to hold so many numbers.
TEST(Mat, SizesOfACompressedVariableAreCheckedToo) {
  const auto bytes_of = [](const std::string& digits) {
    std::string bytes;
    for (size_t i = 0; i + 1 < digits.size(); i += 2)
      bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
  };
  std::string head = "MATLAB 5.0 MAT-file, by hand";
  head.resize(124, ' ');
  head += std::string("\0\1IM", 4) +
          bytes_of(
              "0e0000003800000006000000080000000600000000000000050000000800000001000000010000000100020066730000"
              "0900000008000000000000000000f03f");  // fs = 1
  const std::string sound =
                        "0f0000003d00000078dae3636060686063600022060e06080d02ac50fe09206684624e204ecb2f4a4e8d378cf783aa"
                        "038939c0348d8251300a46c1281805240200b68a0524",
                    claims =
                        "0f0000004000000078dae3636060686063600022060e06080d02ac50be83133f03239006614e204ecb2f4a4e8d378c"
                        "f783aa038939c0348d8251300a46c128180524020055c304ed";
  for (const std::string* variable : {&sound, &claims}) {
    const std::string path = testing::TempDir() + "compressed_" + std::to_string(getpid()) + ".mat";
    std::ofstream(path, std::ios::binary) << head << bytes_of(*variable);
    const std::string said = refusal([&] { EXPECT_EQ(one_record(path, {}).samples(), 200u); });
    EXPECT_EQ(said.find("is to hold 1000000 numbers") != std::string::npos, variable == &claims) << said;
    std::remove(path.c_str());
  }
}

// The library beneath fills what is missing with noughts, and says so to its log alone.
TEST(Mat, AFileThatEndsEarlyIsRefused) {
  for (const mat_ft version : {MAT_FT_MAT5, MAT_FT_MAT4})
    for (const uintmax_t missing : {1u, 8u, 800u}) {
      MatFile file(version);
      file.add("sample_rate_Hz", {250}).add("force_1_N", std::vector<double>(200, 1.5));
      file.add("displacement_1_m", std::vector<double>(200, 0.25));
      const std::string path = file.path();
      EXPECT_EQ(one_record(path, dampers(1)).samples(), 200u);
      std::filesystem::resize_file(path, std::filesystem::file_size(path) - missing);
      expect_says(refusal([&] { one_record(path, dampers(1)); }),
                  "ends early, " + std::to_string(missing) + " bytes are missing");
    }
}

}  // namespace
