#include "host_sim/ingestion/uff/uff_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <set>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/ingestion/channel_options.hpp"
#include "host_sim/ingestion/uff/uff_dataset.hpp"
#include "host_sim/ingestion/uff/uff_ordinate.hpp"
#include "host_sim/records/columns/plan/column_choices.hpp"
#include "host_sim/records/columns/units/units.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/files/file_extension.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

using Place = std::pair<int, int>;  // node, direction without its sign

bool is_base(const uff::Function& function) {
  std::string name = function.entity;
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name == "BASE";
}

[[noreturn]] void fail(const std::string& file, const uff::Function& function, const std::string& problem) {
  throw DataFileError(file, function.line, "dataset 58 that begins here: " + problem);
}

struct Contents {
  std::vector<uff::Function> functions;  // time responses of a quantity that is used
  uff::Units units;
  std::vector<std::string> ignored;  // what the others are, each once
};

void keep(uff::Function function, Contents& contents) {
  std::string why;
  if (function.function_type > 1)
    why = "function type " + std::to_string(function.function_type) + " (no time response)";
  else if (!uff::quantity_of(function.ordinate_type))
    why = "ordinate type " + std::to_string(function.ordinate_type) + " (" +
          uff::ordinate_word(function.ordinate_type) + ")";
  if (why.empty()) {
    contents.functions.push_back(std::move(function));
  } else if (std::find(contents.ignored.begin(), contents.ignored.end(), why) == contents.ignored.end()) {
    contents.ignored.push_back(why);
  }
}

std::string joined(const std::vector<std::string>& texts) {
  std::string all;
  for (const std::string& text : texts) all += (all.empty() ? "" : ", ") + text;
  return all;
}

Contents read_contents(std::string_view content, const std::string& file) {
  Contents contents;
  uff::Lines lines(content, file);
  std::string_view line;
  while (lines.next(line)) {
    if (uff::trimmed(line).empty()) continue;
    if (uff::trimmed(line) != "-1") lines.fail("expected -1, the start of a dataset");
    const std::string_view number = lines.required("the number of a dataset");
    if (uff::trimmed(number).substr(0, 3) == "58b") {
      const uff::BinaryForm form = uff::read_binary_form(lines, number);
      keep(uff::read_function(lines, &form), contents);
    } else if (uff::trimmed(number) == "58") {
      keep(uff::read_function(lines), contents);
    } else if (uff::trimmed(number) == "164") {
      contents.units = uff::read_units(lines);
    } else {
      while (uff::trimmed(lines.required("-1, the end of the dataset")) != "-1") {
      }
    }
  }
  if (contents.functions.empty())
    throw DataFileError(file, 0,
                        contents.ignored.empty()
                            ? "no dataset 58, expected one per channel"
                            : "no channel of use, only " + joined(contents.ignored) +
                                  "; expected time responses (function type 1) of ordinate type 8 (displacement), 11 "
                                  "(velocity), 12 (acceleration) or 13 (excitation force)");
  return contents;
}

// Place -> DOF number.
std::vector<Place> places_in_order(const Contents& contents, const std::string& file, const rig_file::RigModel& model) {
  std::set<Place> places;
  for (const uff::Function& function : contents.functions)
    if (!is_base(function)) places.insert({function.node, std::abs(function.direction)});
  if (!model.dofs.empty() && places.size() != model.dofs.size()) {
    std::string found;
    for (const Place& place : places)
      found +=
          (found.empty() ? "" : ", ") + std::to_string(place.first) + " in direction " + std::to_string(place.second);
    throw DataFileError(file, 0,
                        "channels at the nodes " + found + ", expected as many places as the rig has DOFs (" +
                            std::to_string(model.dofs.size()) + ")");
  }
  return std::vector<Place>(places.begin(), places.end());
}

// What a value is divided by to be in SI.
double unit_factor(const uff::Units& units, firmware::Quantity quantity, bool rotates) {
  if (quantity == firmware::Quantity::kForce) return rotates ? units.force * units.length : units.force;
  return rotates ? 1.0 : units.length;
}

bool base_rotates(const rig_file::RigModel& model) {
  for (const rig_file::Link& link : model.links)
    if (link.b == rig_file::kBase) return rig_file::link_rotates(model, link);
  return false;
}

// What a value is multiplied with: by the ordinate's label where it is a unit other than SI, else by dataset 164.
double to_si(const uff::Function& function, const uff::Units& units, firmware::Quantity quantity, bool rotates,
             const std::string& file) {
  const Dimension dimension = dimension_of(quantity, rotates);
  const double by_dataset = 1.0 / unit_factor(units, quantity, rotates);
  const auto label = find_unit(function.ordinate_unit, dimension);
  if (!label || label->dimension != dimension || label->to_si == 1.0) return by_dataset;
  if (by_dataset != 1.0 && std::abs(by_dataset / label->to_si - 1.0) > 1e-3)
    fail(file, function,
         "ordinate unit \"" + function.ordinate_unit + "\" and dataset 164 disagree, expected one unit");
  return label->to_si;
}

rig_file::ChannelName name_of(const uff::Function& function, int dof, const rig_file::RigModel& model) {
  const int direction = std::abs(function.direction);
  const bool of_rig = !model.dofs.empty();
  const bool rig_rotates =
      of_rig && (dof == rig_file::kBase ? base_rotates(model) : model.dofs[static_cast<size_t>(dof - 1)].rotating);
  const bool rotates = direction == 0 ? rig_rotates : direction > 3;
  return {*uff::quantity_of(function.ordinate_type), dof, rotates};
}

// What the values of a channel are multiplied with: by what the user says, else by what the file says.
double factor_of(const uff::Function& function, const rig_file::ChannelName& name, const uff::Units& units,
                 const ColumnContext& context, std::vector<std::string>& notes) {
  const std::string channel = rig_file::format_channel_name(name);
  const auto said = said_unit(context, channel, dimension_of(name.quantity, name.rotating));
  const double size = said ? said->to_si : to_si(function, units, name.quantity, name.rotating, context.file);
  if (size == 1.0) return size;
  const std::string unit = said                             ? said->word + ", as --unit says"
                           : function.ordinate_unit.empty() ? "the units of dataset 164"
                                                            : function.ordinate_unit;
  notes.push_back(channel + " in " + unit + fmt::format(": values times {:.10g}", size));
  return size;
}

Channel channel_of(const uff::Function& function, const rig_file::ChannelName& name, const uff::Units& units,
                   const ColumnContext& context, std::vector<std::string>& notes) {
  Channel channel = channel_of_name(rig_file::format_channel_name(name), context.model, context.file, function.line);
  const double size = factor_of(function, name, units, context, notes);
  const double factor = function.direction < 0 ? -size : size;
  channel.values.reserve(function.values.size());
  for (const double value : function.values) channel.values.push_back(value * factor);
  for (size_t i = 0; i < channel.values.size(); ++i)
    if (!std::isfinite(channel.values[i]))
      fail(context.file, function, "value " + std::to_string(i + 1) + " is too large in SI units: check the unit");
  return channel;
}

// rate_Hz: that the user says; 0: the file's times hold.
void check_alike(const Record& record, const uff::Function& function, double rate_Hz, const std::string& file) {
  if (function.values.size() != record.samples())
    fail(file, function,
         std::to_string(function.values.size()) + " values, expected " + std::to_string(record.samples()) +
             " as in the first channel");
  if (rate_Hz > 0.0) return;
  if (std::abs(function.step_s / record.sample_period_s - 1.0) > 1e-4)
    fail(file, function, "another sample period than the first channel, expected the same");
  if (std::abs(function.start_s - record.start_s) > 0.01 * record.sample_period_s)
    fail(file, function, "starts at another time than the first channel, expected the same");
}

// A channel that one of the runs lacks would leave its place to that of the next run.
void require_whole_records(const std::vector<Record>& records, const std::string& file) {
  for (size_t i = 0; i < records.size(); ++i)
    for (const Channel& channel : records.front().channels)
      if (records[i].find(channel.quantity, channel.dof) == nullptr)
        throw DataFileError(file, 0,
                            fmt::format("holds {} records of {} and {} of {}, expected every channel in every record, "
                                        "or a file for each record",
                                        records.size(), records.back().channels.front().name, i, channel.name));
}

}  // namespace

bool is_uff(const std::string& path, std::string_view content) {
  if (has_extension(path, ".uff") || has_extension(path, ".unv") || has_extension(path, ".58")) return true;
  return uff::trimmed(content.substr(0, content.find_first_of("\r\n"))) == "-1";
}

std::vector<Record> parse_uff(std::string_view content, const std::string& file, const rig_file::RigModel& model,
                              const ReadingOptions& options) {
  const ColumnContext context{model, options, file, 0};
  require_channel_options(context, "");
  Contents contents = read_contents(content, file);
  const std::vector<Place> places = places_in_order(contents, file, model);
  std::vector<Record> records(1);
  for (uff::Function& function : contents.functions) {
    const auto place = std::find(places.begin(), places.end(), Place(function.node, std::abs(function.direction)));
    const int dof = is_base(function) ? rig_file::kBase : static_cast<int>(place - places.begin()) + 1;
    const rig_file::ChannelName name = name_of(function, dof, model);
    if (is_left_out(name, options)) continue;
    const Quantity quantity = static_cast<Quantity>(name.quantity);
    size_t number = 0;  // a channel's first function is of the first record, its second of the second, ...
    while (number < records.size() && records[number].find(quantity, dof) != nullptr) ++number;
    if (number == records.size()) records.emplace_back();
    Record& record = records[number];
    Channel channel = channel_of(function, name, contents.units, context, record.notes);
    if (record.channels.empty()) {
      record.sample_period_s = options.sample_rate_Hz > 0.0 ? 1.0 / options.sample_rate_Hz : function.step_s;
      record.start_s = options.sample_rate_Hz > 0.0 ? 0.0 : function.start_s;
    } else {
      check_alike(record, function, options.sample_rate_Hz, file);
    }
    record.channels.push_back(std::move(channel));
    function.values = {};
  }
  require_whole_records(records, file);
  if (records.front().channels.empty()) context.refuse("no channel is left, expected fewer --column CHANNEL=");
  for (size_t i = 0; i < records.size(); ++i)
    records[i].file = file + (records.size() > 1 ? ", record " + std::to_string(i + 1) : "");
  if (!contents.ignored.empty()) records.front().notes.push_back("ignored: " + joined(contents.ignored));
  return records;
}

}  // namespace host_sim
