// What is said of a row that cannot be read. All throw DataFileError with its line.
#pragma once
#include <string>

#include "host_sim/records/csv/rows/csv_table.hpp"

namespace host_sim {

// field: as it stands in the row, where a number of the column `name` was expected.
[[noreturn]] void refuse_field(const CsvTable& table, const Row& row, const std::string& field,
                               const std::string& name);

// A number that its unit makes larger than any that can be kept.
[[noreturn]] void refuse_too_large(const CsvTable& table, const Row& row, const std::string& field,
                                   const std::string& name);

// More fields than columns, or only so many.
[[noreturn]] void refuse_count(const CsvTable& table, const Row& row, size_t fields);

// A LabVIEW file's second segment.
[[noreturn]] void refuse_segment(const CsvTable& table, size_t line);

}  // namespace host_sim
