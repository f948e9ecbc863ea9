// What the columns of a data file (variables of a MAT file) mean to the rig: time, channels with their factor to SI,
// and what is left over.
#pragma once
#include <string>
#include <vector>

#include "hal/rig_file/rig_model.hpp"
#include "host_sim/records/columns/column.hpp"
#include "host_sim/records/columns/reading_options.hpp"
#include "host_sim/records/record.hpp"

namespace host_sim {

struct ColumnUse {
  enum class Kind { kIgnored, kTime, kChannel };
  Kind kind = Kind::kIgnored;
  Channel channel;      // without values
  double factor = 1.0;  // a value of the file times this is in SI
};

struct ColumnPlan {
  std::vector<ColumnUse> uses;     // one for each column
  std::vector<std::string> notes;  // what the user should know: factors and what is ignored
  bool has_time() const;
};

// A column is, in this order: what the user says (options, then `column` of the rig's [[channel]]); t_s or another
// usual name of time; a channel name with its unit in the name, in brackets or in the row of units; where none of them
// names a channel and the rig has one DOF, a quantity alone with its unit ("Position (m)"); ignored, with a note. A name
// that is shaped like a channel's and is none throws DataFileError with the line, as do a channel that stands twice, an
// unknown unit, a voltage without a sensitivity, and a choice that names no column.
// A rig without DOFs stands for "no rig file": then every channel name is taken.
ColumnPlan plan_columns(const std::vector<Column>& columns, const rig_file::RigModel& model,
                        const ReadingOptions& options, const std::string& file, size_t line);

}  // namespace host_sim
