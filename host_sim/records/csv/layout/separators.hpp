// What separates the fields of a line, by what is in them and by the lines around it.
#pragma once
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace host_sim {

using MeansChannel = std::function<bool(const std::string&)>;  // of a head

// How many fields mean a channel, and with which separator most do.
size_t channel_fields(std::string_view line, const MeansChannel& means_channel, char& separator);

// "0.004  -1,5e-3": numbers of a table, whatever separates them.
bool is_row_of_numbers(std::string_view line);

// Names above so many blank-separated numbers: of several words each, where two blanks and more part them into as many.
std::vector<std::string> split_names(std::string_view names, char separator, size_t fields);

// What separates names that mean nothing to us: with it they are as many as the fields of the next row, and most.
char likely_separator(std::string_view names, std::string_view rest);

// Two rows of one table: as many fields in both, with a separator that is there; or single numbers.
bool same_table(std::string_view row, std::string_view next);

// With which a line has as many fields as a row of numbers; nothing where none does.
std::optional<char> separator_of_names(std::string_view names, std::string_view row);

// How many fields a row has, with that separator or, where it is in none of them, another one.
size_t fields_of(std::string_view row, char separator);

}  // namespace host_sim
