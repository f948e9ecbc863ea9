// Where the names, the units and the numbers of a table in a text file stand, and what separates its fields.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/csv/layout/separators.hpp"

namespace host_sim {

struct CsvLayout {
  char separator = ',';
  bool decimal_comma = false;
  std::vector<Column> columns;  // "1", "2" and so on where the file has no names
  bool unnamed = false;
  std::string unfit;               // of unnamed ones: a comment that may name them, and why it was not taken
  size_t header_line = 1;          // from 1
  std::string_view data;           // the rest of the content, from the first row of numbers on
  size_t data_line = 2;            // its line
  double step_s = 0.0;             // where the header tells it in place of a column of time; else 0
  std::vector<std::string> notes;  // what was passed over
};

// The header is the first line in which some separator (tab, semicolon, comma, blanks) leaves a field that means a
// channel or the time; a comment line may be it, where it names each column (or more: from the left). Without one it is the first line above the numbers that has as many fields as
// they; where there is none above them, the columns have no names. A row of numbers above rows of another width, and what
// stands above it, is no part of the table. Below the header a row
// of units may follow: fields that are units, or blank, and no number; or one stands above it, behind a word (LabVIEW). A
// comma is a decimal point where fields are separated otherwise and the first numbers hold commas and no points.
CsvLayout find_layout(std::string_view content, const MeansChannel& means_channel);

}  // namespace host_sim
