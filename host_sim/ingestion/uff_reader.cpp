#include "host_sim/ingestion/uff_reader.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <set>

#include "hal/rig_file/channel_name.hpp"
#include "host_sim/ingestion/uff_dataset.hpp"
#include "host_sim/records/data_file_error.hpp"
#include "host_sim/records/record_checks.hpp"

namespace host_sim {
namespace {

using Place = std::pair<int, int>;  // node, direction without its sign

bool ends_with(const std::string& text, const char* end) {
  const std::string_view tail(end);
  return text.size() >= tail.size() && std::equal(tail.rbegin(), tail.rend(), text.rbegin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

bool is_base(const uff::Function& function) {
  std::string name = function.entity;
  for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  return name == "BASE";
}

[[noreturn]] void fail(const std::string& file, const uff::Function& function, const std::string& problem) {
  throw DataFileError(file, function.line, "dataset 58 that begins here: " + problem);
}

firmware::Quantity quantity_of(const std::string& file, const uff::Function& function) {
  switch (function.ordinate_type) {
    case 8:
      return firmware::Quantity::kDisplacement;
    case 11:
      return firmware::Quantity::kVelocity;
    case 12:
      return firmware::Quantity::kAcceleration;
    case 13:
      return firmware::Quantity::kForce;
    default:
      fail(file, function,
           "ordinate type " + std::to_string(function.ordinate_type) +
               ", expected 8 (displacement), 11 (velocity), 12 (acceleration) or 13 (excitation force)");
  }
}

struct Contents {
  std::vector<uff::Function> functions;
  uff::Units units;
};

Contents read_contents(std::string_view content, const std::string& file) {
  Contents contents;
  uff::Lines lines(content, file);
  std::string_view line;
  while (lines.next(line)) {
    if (uff::trimmed(line).empty()) continue;
    if (uff::trimmed(line) != "-1") lines.fail("expected -1, the start of a dataset");
    const std::string number(uff::trimmed(lines.required("the number of a dataset")));
    if (number.rfind("58b", 0) == 0) lines.fail("the binary form 58b, expected the ASCII form of dataset 58");
    if (number == "58") {
      contents.functions.push_back(uff::read_function(lines));
    } else if (number == "164") {
      contents.units = uff::read_units(lines);
    } else {
      while (uff::trimmed(lines.required("-1, the end of the dataset")) != "-1") {
      }
    }
  }
  if (contents.functions.empty()) throw DataFileError(file, 0, "no dataset 58, expected one per channel");
  return contents;
}

// Place -> DOF number.
std::vector<Place> places_in_order(const Contents& contents, const std::string& file, const rig_file::RigModel& model) {
  std::set<Place> places;
  for (const uff::Function& function : contents.functions)
    if (!is_base(function)) places.insert({function.node, std::abs(function.direction)});
  if (places.size() != model.dofs.size()) {
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

Channel channel_of(const uff::Function& function, int dof, const uff::Units& units, const std::string& file,
                   const rig_file::RigModel& model) {
  if (function.function_type > 1)
    fail(file, function, "function type " + std::to_string(function.function_type) + ", expected 1 (time response)");
  if (function.ordinate_unit == "g" || function.ordinate_unit == "G")
    fail(file, function, "ordinate unit \"g\", expected m/s^2");
  const firmware::Quantity quantity = quantity_of(file, function);
  const int direction = std::abs(function.direction);
  const bool rotates = direction == 0 ? (dof == rig_file::kBase ? base_rotates(model)
                                                                : model.dofs[static_cast<size_t>(dof - 1)].rotating)
                                      : direction > 3;
  Channel channel =
      channel_of_name(rig_file::format_channel_name({quantity, dof, rotates}), model, file, function.line);
  const double factor = (function.direction < 0 ? -1.0 : 1.0) / unit_factor(units, quantity, rotates);
  for (double value : function.values) channel.values.push_back(value * factor);
  return channel;
}

void check_alike(const Record& record, const uff::Function& function, const std::string& file) {
  if (function.values.size() != record.samples())
    fail(file, function,
         std::to_string(function.values.size()) + " values, expected " + std::to_string(record.samples()) +
             " as in the first channel");
  if (std::abs(function.step_s / record.sample_period_s - 1.0) > 1e-4)
    fail(file, function, "another sample period than the first channel, expected the same");
  if (std::abs(function.start_s - record.start_s) > 0.01 * record.sample_period_s)
    fail(file, function, "starts at another time than the first channel, expected the same");
}

}  // namespace

bool is_uff(const std::string& path, std::string_view content) {
  if (ends_with(path, ".uff") || ends_with(path, ".unv") || ends_with(path, ".58")) return true;
  return uff::trimmed(content.substr(0, content.find_first_of("\r\n"))) == "-1";
}

Record parse_uff(std::string_view content, const std::string& file, const rig_file::RigModel& model) {
  const Contents contents = read_contents(content, file);
  const std::vector<Place> places = places_in_order(contents, file, model);
  Record record;
  record.file = file;
  for (const uff::Function& function : contents.functions) {
    const auto place = std::find(places.begin(), places.end(), Place(function.node, std::abs(function.direction)));
    const int dof = is_base(function) ? rig_file::kBase : static_cast<int>(place - places.begin()) + 1;
    Channel channel = channel_of(function, dof, contents.units, file, model);
    if (record.find(channel.quantity, channel.dof) != nullptr)
      fail(file, function, channel.name + " for the second time, expected each channel once (one file per record)");
    if (record.channels.empty()) {
      record.sample_period_s = function.step_s;
      record.start_s = function.start_s;
    } else {
      check_alike(record, function, file);
    }
    record.channels.push_back(std::move(channel));
  }
  return record;
}

}  // namespace host_sim
