// The datasets of a Universal File, as they stand in the file.
#pragma once
#include <string>
#include <string_view>
#include <vector>

namespace host_sim::uff {

// The lines of a file, numbered from 1, without line ends.
class Lines {
 public:
  Lines(std::string_view content, std::string file) : rest_(content), file_(std::move(file)) {}
  bool next(std::string_view& line);            // false at the end
  std::string_view required(const char* what);  // throws DataFileError at the end of the file
  size_t number() const { return number_; }     // of the last line handed out
  std::string_view take_bytes(size_t count);    // throws DataFileError where the file ends before them
  [[noreturn]] void fail(const std::string& problem) const;
  const std::string& file() const { return file_; }

 private:
  std::string_view rest_;
  std::string file_;
  size_t number_ = 0;
};

std::string_view trimmed(std::string_view text);

// Columns [first, first + width) of a line as an integer; blank or missing columns are 0. Throws DataFileError.
int integer_field(const Lines& lines, std::string_view line, size_t first, size_t width, const char* name);
// Likewise a real number, Fortran's D exponent included.
double real_field(const Lines& lines, std::string_view line, size_t first, size_t width, const char* name);

struct Function {
  size_t line = 0;  // of its first record
  int function_type = 0;
  std::string entity;
  int node = 0, direction = 0;
  int ordinate_type = 0;
  std::string ordinate_unit;
  double start_s = 0.0, step_s = 0.0;
  std::vector<double> values;
};

// Factors of dataset 164: a value in the file's unit divided by its factor is in SI.
struct Units {
  double length = 1.0, force = 1.0;
};

// How the values of a dataset 58b lie in the file, from the line of its number.
struct BinaryForm {
  bool big_endian = false;
  size_t bytes = 0;  // of the values
};
// "58b" and its fields; throws DataFileError for floating point formats other than IEEE 754.
BinaryForm read_binary_form(const Lines& lines, std::string_view line);

// Reads dataset 58 after its number, through its closing -1; with a form, dataset 58b. A function that is no time
// response (type above 1) comes without values.
Function read_function(Lines& lines, const BinaryForm* binary = nullptr);
// Likewise dataset 164.
Units read_units(Lines& lines);

}  // namespace host_sim::uff
