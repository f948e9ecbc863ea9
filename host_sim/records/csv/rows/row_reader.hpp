// A row of numbers into the columns of its table.
#pragma once
#include <optional>

#include "host_sim/records/csv/rows/csv_table.hpp"
#include "host_sim/records/csv/rows/field_format.hpp"
#include "host_sim/records/csv/text/clock_time.hpp"

namespace host_sim {

class RowReader {
 public:
  // Of a table whose targets are found; it outlives this.
  explicit RowReader(CsvTable& table) : table_(table), format_{table.layout.separator, table.layout.decimal_comma} {}

  // Throws DataFileError where a field is no number, or there are more or fewer than there are columns.
  void read(const Row& row);

  const FieldFormat& format() const { return format_; }

 private:
  double value_of(const char*& position, const char* end, const Target& target, const Row& row);
  bool take_clock(const char*& position, const char* end, double& value);

  CsvTable& table_;
  FieldFormat format_;
  ClockTime first_clock_;
  std::optional<DateOrder> date_order_;  // once there is a date
};

}  // namespace host_sim
