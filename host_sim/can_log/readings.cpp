#include "host_sim/can_log/readings.hpp"

#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/readable.hpp"
#include "host_sim/can_log/table_text.hpp"

namespace can_log {
namespace {

namespace can = firmware::can;
using can::Address;
using can::FrameDescription;
using can::Signal;
using firmware::CanFrame;

std::string without_blanks(std::string names) {
  std::string text;
  for (const char c : names)
    if (c != ' ') text += c;
  return text;
}

Reading plain(const Signal& signal, int64_t raw) {
  Reading reading;
  reading.name = signal.name;
  reading.value = physical(signal, raw);
  const std::string unit = signal.unit;
  const bool named = signal.names.count > 0 || unit == "hex" || unit == "DOF";
  reading.unit = named ? "1" : unit;
  if (signal.names.flags) {
    reading.status = without_blanks(flag_names(signal.names, raw));
  } else {
    reading.status = state_name(signal.names, raw);
  }
  return reading;
}

std::string sender_name(const Address& address) {
  if (address.node > 0) return "node " + std::to_string(address.node);
  if (address.frame->sender != can::Sender::kSensor) return "master";
  const int place = address.member + 1;
  return place == can::kPlaceBase ? "base" : "DOF " + std::to_string(place);
}

std::string with_semicolons(std::string text) {  // commas part the columns of a CSV
  for (char& c : text)
    if (c == ',') c = ';';
  return text;
}

}  // namespace

std::string FrameReader::estimate_name(int node, int index) const {
  return names_.knows(node, index) ? names_.parameter(node, index) : "estimate[" + std::to_string(index) + "]";
}

Reading FrameReader::estimate(int node, int index, const CanFrame& message, int bit_offset) const {
  const firmware::EstimateRecord record = firmware::record_at(message, bit_offset);
  Reading reading;
  reading.name = estimate_name(node, index);
  reading.value = times_power_of_ten(record.value, record.exponent);
  reading.std = times_power_of_ten(record.std, record.exponent + record.std_exponent);
  reading.unit = names_.unit(node, index);
  reading.status = state_name(can::states(can::kQualityStates), static_cast<int64_t>(record.status));
  return reading;
}

void FrameReader::estimates(const Address& address, const CanFrame& message, FrameReadings& result) const {
  const FrameDescription& frame = *address.frame;
  for (int record = 0; record < frame.repeats; ++record) {
    const int bit_offset = record * can::record_bits(frame);
    if (firmware::is_absent(firmware::record_at(message, bit_offset))) continue;
    result.readings.push_back(estimate(address.node, address.member * frame.repeats + record, message, bit_offset));
  }
}

void FrameReader::floats(const Address& address, const CanFrame& message, FrameReadings& result) const {
  const FrameDescription& frame = *address.frame;
  for (int record = 0; record < frame.repeats; ++record) {
    const int index = address.member * frame.repeats + record, offset = record * can::record_bits(frame);
    Reading reading;
    reading.name = estimate_name(address.node, index);
    reading.value = static_cast<double>(float_of_bits(can::get_raw(message, frame.signals[0], offset)));
    reading.std = static_cast<double>(float_of_bits(can::get_raw(message, frame.signals[1], offset)));
    reading.unit = names_.unit(address.node, index);
    if (!frame.fd || !std::isnan(reading.value)) result.readings.push_back(reading);
  }
}

// A channel in SI units under its own name; as long as its scaling has not been seen, in codes under another.
void FrameReader::sensor(const Address& address, const CanFrame& message, FrameReadings& result) const {
  const int place = address.member + 1;
  for (int i = 0; i < address.frame->signal_count; ++i) {
    const Signal& signal = address.frame->signals[i];
    const int64_t raw = can::get_raw(message, signal);
    Reading reading = plain(signal, raw);
    const int quantity = quantity_of(signal.name);
    if (quantity >= 0) {
      const std::string where = "[" + place_label(place) + "]";
      reading.name = std::string(signal.name) + "_code" + where;
      if (names_.in_si_units(place, quantity, raw, reading.value, reading.unit)) reading.name = signal.name + where;
    }
    result.readings.push_back(reading);
  }
}

// What mantissa and exponents say, under a name that goes with the unit.
void FrameReader::size(const CanFrame& message, FrameReadings& result) const {
  int node = 0;
  firmware::Diagnosis diagnosis;
  if (!firmware::unpack_diagnosis_size(message, node, diagnosis)) return;
  const CauseSize size = size_of(diagnosis.size);
  Reading reading;
  reading.name = causes_.label(node);
  reading.value = size.value;
  reading.std = size.std;
  reading.unit = causes_.unit(node, names_);
  if (diagnosis.corrected) reading.status = "CORRECTED";
  result.readings.push_back(reading);
}

bool FrameReader::read(const LogEntry& entry, FrameReadings& result) {
  result = FrameReadings();
  if (entry.frame.error) {
    result.sender = "bus";
    result.frame = "error";
    Reading reading;
    reading.name = "error";
    reading.value = entry.frame.id;
    reading.unit = "1";
    reading.status = with_semicolons(error_frame_text(entry.frame));
    result.readings.push_back(reading);
    return true;
  }
  const CanFrame message = to_message(entry.frame);
  const Address address = entry.frame.remote ? Address() : can::identify(message);
  if (address.frame == nullptr) {
    result.sender = "-";
    result.frame = hex_text(entry.frame.id, entry.frame.extended ? 8 : 3);
    Reading reading;
    reading.name = entry.frame.remote ? "remote_request" : "bytes";
    reading.status = bytes_text(entry.frame);
    result.readings.push_back(reading);
    return false;
  }
  names_.learn(message);
  causes_.learn(message);
  result.sender = sender_name(address);
  result.frame = address.frame->name;
  if (address.frame == &can::kEstimate || address.frame == &can::kEstimateFd) {
    estimates(address, message, result);
  } else if (address.frame == &can::kEstimateFloat || address.frame == &can::kEstimateFloatFd) {
    floats(address, message, result);
  } else if (address.frame->sender == can::Sender::kSensor) {
    sensor(address, message, result);
  } else {
    for (int i = 0; i < address.frame->signal_count; ++i)
      result.readings.push_back(plain(address.frame->signals[i], can::get_raw(message, address.frame->signals[i])));
  }
  if (address.frame == &can::kDiagnosisSize) size(message, result);
  return true;
}

}  // namespace can_log
