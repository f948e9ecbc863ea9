// Which of two numbers in the dates of a column is the month.
#pragma once
#include "host_sim/records/csv/rows/csv_table.hpp"
#include "host_sim/records/csv/rows/field_format.hpp"
#include "host_sim/records/csv/text/clock_time.hpp"

namespace host_sim {

// All dates of the table's times together tell: a number above twelve is a day; where there is none, from the first to the last date
// no more days go by than have to (a record over midnight: 03/04/2026, then 03/05/2026, is a day and no month).
DateOrder date_order_of(const CsvTable& table, const FieldFormat& format);

}  // namespace host_sim
