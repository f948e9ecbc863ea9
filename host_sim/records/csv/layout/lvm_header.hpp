// The two headers of a LabVIEW measurement file (.lvm), which stand above its names.
#pragma once
#include <cstddef>
#include <string_view>

namespace host_sim {

struct LvmHeader {
  size_t lines = 0;  // of both headers; 0: this is no such file
  char separator = '\t';
  std::string_view below;  // from the line of names on
  double step_s = 0.0;     // Delta_X, where all channels have one
  bool has_times = true;   // X_Columns: whether X_Value holds the times (else Delta_X tells them)
};
LvmHeader lvm_header_of(std::string_view content);

// Whether a further header stands in these lines: a second segment.
bool begins_lvm_segment(std::string_view lines);

}  // namespace host_sim
