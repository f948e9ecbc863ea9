// The line that names the columns of a table, and where there is none, what stands in for it.
#pragma once
#include <string>
#include <string_view>

#include "host_sim/records/csv/layout/lvm_header.hpp"
#include "host_sim/records/csv/layout/separators.hpp"

namespace host_sim {

struct Header {
  size_t line = 0;  // 0: none
  char separator = ',';
  std::string_view text, rest;
  size_t passed_over = 0;  // lines before it that are neither blank nor comments
  bool unnamed = false;    // it is the first row of numbers: nothing stands above
  bool surplus = false;    // it has more names than there are columns
  std::string unfit = {};  // of unnamed ones: what a comment above them says that may be names
};

// csv_layout.hpp says which line it is.
Header find_header(std::string_view content, const MeansChannel& means_channel);

// The names stand behind the headers of LabVIEW's files, in which "Time" is no column.
Header header_below(const LvmHeader& lvm);

}  // namespace host_sim
