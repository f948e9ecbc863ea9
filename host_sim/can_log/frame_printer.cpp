#include "host_sim/can_log/frame_printer.hpp"

#include <fmt/format.h>

#include <cmath>

#include "firmware/can_protocol/streams/estimate_frames.hpp"
#include "host_sim/can_log/readable.hpp"
#include "host_sim/can_log/sdo_text.hpp"

namespace can_log {
namespace {

using firmware::CanFrame;
using firmware::can::Address;
using firmware::can::FrameDescription;

std::string padded(std::string text, size_t width) {
  if (text.size() < width) text.append(width - text.size(), ' ');
  return text;
}

// Seconds as in the log, without leading zeros; "-" where the log has no times.
std::string time_text(const LogEntry& entry) {
  if (!entry.has_time) return "                -";
  return fmt::format("{:10}.{:06}", entry.frame.time_ns / 1000000000u, entry.frame.time_ns / 1000u % 1000000u);
}

bool is_sensor(const FrameDescription& frame) { return frame.sender == firmware::can::Sender::kSensor; }

std::string sender_text(const Address& address) {
  if (address.node > 0) return "node " + std::to_string(address.node);
  if (!is_sensor(*address.frame)) return "all";
  const int place = address.member + 1;
  return place == firmware::can::kPlaceBase ? "base" : "DOF " + std::to_string(place);
}

// The sender's column says that a frame is a sensor's: "motion_24" for "sensor_motion_24".
std::string frame_text(const FrameDescription& frame) {
  const std::string name = frame.name;
  return is_sensor(frame) && name.substr(0, 7) == "sensor_" ? name.substr(7) : name;
}

// As many digits as the standard deviation leaves meaning, and two more; all ten that are on the bus where it is 0.
int meaningful_digits(double value, double std) {
  constexpr int kFewest = 4, kMost = 10;
  if (std <= 0.0) return kMost;
  const double digits = std::ceil(std::log10(std::fabs(value) / std)) + 2;
  return digits < kFewest ? kFewest : digits > kMost ? kMost : static_cast<int>(digits);
}

}  // namespace

// A line is "name = value" or words; its name is what stands before the sign.
void FramePrinter::line(const std::string& text) {
  if (changes_only_) {
    const size_t sign = text.find(" = ");
    std::string& last = last_[lead_ + text.substr(0, sign)];
    if (last == text) return;
    last = text;
  }
  output_ << time_ << lead_ << text << '\n';
}

bool FramePrinter::print(const LogEntry& entry) {
  const CanFrame message = to_message(entry.frame);
  const Address address = entry.frame.error || entry.frame.remote ? Address() : firmware::can::identify(message);
  time_ = time_text(entry) + "  ";
  lead_ = padded(entry.interface, 5) + "  ";
  if (address.frame == nullptr) return unknown_frame(entry, message);
  names_.learn(message);
  causes_.learn(message);
  lead_ += padded(sender_text(address), 6) + "  " + padded(frame_text(*address.frame), 12) + "  ";
  known_frame(address, message);
  return true;
}

void FramePrinter::known_frame(const Address& address, const CanFrame& message) {
  namespace can = firmware::can;
  if (address.frame == &can::kEstimate) {
    estimate(address.node, address.member, 0, message);
  } else if (address.frame == &can::kEstimateFd) {
    for (int i = 0; i < can::kEstimateFd.repeats; ++i)
      estimate(address.node, address.member * can::kEstimateFd.repeats + i, i * can::record_bits(can::kEstimateFd),
               message);
  } else if (address.frame == &can::kEstimateFloat || address.frame == &can::kEstimateFloatFd) {
    float_estimates(address, message);
  } else if (address.frame == &can::kParameter) {
    parameter(message);
  } else if (address.frame == &can::kScaling || address.frame == &can::kRange) {
    channel_description(address, message);
  } else if (address.frame == &can::kDiagnosis) {
    diagnosis(message);
  } else if (address.frame == &can::kDiagnosisSize) {
    diagnosis_size(message);
  } else if (address.frame == &can::kEmergency) {
    emergency(message);
  } else if (address.frame == &can::kSdoRequest) {
    line(sdo_request_text(message));
  } else if (address.frame == &can::kSdoReply) {
    line(sdo_reply_text(message));
  } else if (address.frame == &can::kIdentity) {
    identity(message);
  } else if (is_sensor(*address.frame)) {
    sensor(address, message);
  } else {
    every_signal(*address.frame, message);
  }
}

void FramePrinter::estimate(int node, int index, int bit_offset, const CanFrame& message) {
  const firmware::EstimateRecord record = firmware::record_at(message, bit_offset);
  if (firmware::is_absent(record)) return;
  const std::string status =
      state_name(firmware::can::states(firmware::can::kQualityStates), static_cast<int64_t>(record.status));
  const double value = record.value * std::pow(10.0, record.exponent);
  const double std = record.std * std::pow(10.0, record.exponent + record.std_exponent);
  line(padded(names_.parameter(node, index), 14) + " = " +
       padded(number_text(value, meaningful_digits(value, std)) + " " + names_.unit(node, index), 20) + "  std " +
       padded(number_text(std, 2), 8) + "  " + status);
}

// The same estimates once more, under numbers: the history that a name has of `estimate` is not doubled. Behind it stands whose.
void FramePrinter::float_estimates(const Address& address, const CanFrame& message) {
  const FrameDescription& frame = *address.frame;
  for (int record = 0; record < frame.repeats; ++record) {
    const int index = address.member * frame.repeats + record, offset = record * firmware::can::record_bits(frame);
    const float value = float_of_bits(firmware::can::get_raw(message, frame.signals[0], offset));
    const float std = float_of_bits(firmware::can::get_raw(message, frame.signals[1], offset));
    if (frame.fd && std::isnan(value)) continue;  // an unused record says nothing
    const std::string name = "float " + std::to_string(index), unit = " " + names_.unit(address.node, index);
    const std::string of =
        names_.knows(address.node, index) ? "  of " + names_.parameter(address.node, index) : std::string();
    line(name + " value = " + number_text(value, 9) + unit + of);
    line(name + " std = " + number_text(std, 9) + unit + of);
  }
}

void FramePrinter::parameter(const CanFrame& message) {
  int node = 0;
  firmware::ParameterDescription description;
  if (!firmware::unpack_parameter(message, node, description)) return;
  line("estimate " + std::to_string(description.index) + " of " + std::to_string(description.count) + " is " +
       parameter_label(description) + " in " + parameter_unit(description.kind, description.rotating));
}

void FramePrinter::channel_description(const Address& address, const CanFrame& message) {
  const FrameDescription& frame = *address.frame;
  const std::string channel = channel_label(static_cast<int>(firmware::can::get_raw(message, frame.signals[0])),
                                            static_cast<int>(firmware::can::get_raw(message, frame.signals[1])));
  int node = 0;
  firmware::ChannelScaling scaling;
  if (firmware::unpack_scaling(message, node, scaling)) {
    line(channel + " per code = " + number_text(scaling.unit_per_code * std::pow(10.0, scaling.exponent), 10) + " " +
         channel_unit(static_cast<int>(scaling.quantity), scaling.rotating));
    line(channel + " delay = " + std::to_string(scaling.delay_us) + " us");
    return;
  }
  for (int i = 3; i < frame.signal_count; ++i)
    line(channel + " " + frame.signals[i].name + " = " +
         signal_text(frame.signals[i], firmware::can::get_raw(message, frame.signals[i])));
}

void FramePrinter::sensor(const Address& address, const CanFrame& message) {
  for (int i = 0; i < address.frame->signal_count; ++i) {
    const firmware::can::Signal& signal = address.frame->signals[i];
    const int64_t raw = firmware::can::get_raw(message, signal);
    const int quantity = quantity_of(signal.name);
    if (quantity < 0) {
      line(std::string(signal.name) + " = " + signal_text(signal, raw));
    } else {
      const int place = address.member + 1;
      line(channel_label(place, quantity) + " = " + signal_text(signal, raw) + names_.in_units(place, quantity, raw));
    }
  }
}

void FramePrinter::emergency(const CanFrame& message) {
  int node = 0;
  firmware::Emergency emergency;
  if (!firmware::unpack_emergency(message, node, emergency)) return;
  const FrameDescription& frame = firmware::can::kEmergency;
  line("code = " + signal_text(frame.signals[0], static_cast<int64_t>(emergency.code)));
  line("error_register = " + signal_text(frame.signals[1], emergency.error_register));
  if (emergency.quantity != firmware::kNoQuantity) {
    line("channel = " + channel_label(emergency.place, emergency.quantity));
  } else if (emergency.place != firmware::can::kPlaceNone) {
    line("place = " + signal_text(frame.signals[2], emergency.place));
  }
  line("detail = " + std::to_string(emergency.detail));
}

void FramePrinter::identity(const CanFrame& message) {
  int node = 0;
  firmware::Identity identity;
  if (!firmware::unpack_identity(message, node, identity)) return;
  line("firmware = " + std::to_string(identity.version_major) + "." + std::to_string(identity.version_minor) + "." +
       std::to_string(identity.version_patch));
  line("parameters = " + std::to_string(identity.parameters));
  line("configuration_crc = " + hex_text(identity.configuration_crc, 8));
}

void FramePrinter::diagnosis(const CanFrame& message) {
  int node = 0;
  firmware::Diagnosis diagnosis;
  if (!firmware::unpack_diagnosis(message, node, diagnosis)) return;
  const FrameDescription& frame = firmware::can::kDiagnosis;
  std::string cause = signal_text(frame.signals[0], static_cast<int64_t>(diagnosis.cause));
  if (diagnosis.quantity != firmware::kNoQuantity) {
    cause += " on channel " + channel_label(diagnosis.place_a, diagnosis.quantity);
  } else if (diagnosis.place_b != firmware::can::kPlaceNone) {
    cause += " on link " + place_label(diagnosis.place_a) + "-" + place_label(diagnosis.place_b);
  } else if (diagnosis.place_a != firmware::can::kPlaceNone) {
    cause += " on dof " + place_label(diagnosis.place_a);
  }
  line("cause = " + cause);
  for (int i = 4; i < frame.signal_count; ++i)
    line(std::string(frame.signals[i].name) + " = " +
         signal_text(frame.signals[i], firmware::can::get_raw(message, frame.signals[i])));
}

void FramePrinter::diagnosis_size(const CanFrame& message) {
  int node = 0;
  firmware::Diagnosis diagnosis;
  if (!firmware::unpack_diagnosis_size(message, node, diagnosis)) return;
  const CauseSize size = size_of(diagnosis.size);
  line(causes_.label(node) + " = " + number_text(size.value, meaningful_digits(size.value, size.std)) + " " +
       causes_.unit(node, names_) + "  std " + number_text(size.std, 2) + (diagnosis.corrected ? "  CORRECTED" : ""));
}

void FramePrinter::every_signal(const FrameDescription& frame, const CanFrame& message) {
  if (frame.signal_count == 0) line("(no data)");
  for (int i = 0; i < frame.signal_count; ++i)
    line(std::string(frame.signals[i].name) + " = " +
         signal_text(frame.signals[i], firmware::can::get_raw(message, frame.signals[i])));
}

// Error frames are of the bus, so they count as understood.
bool FramePrinter::unknown_frame(const LogEntry& entry, const CanFrame& message) {
  if (entry.frame.error) {
    line("bus     error frame   " + error_frame_text(entry.frame));
    return true;
  }
  const std::string id = hex_text(entry.frame.id, entry.frame.extended ? 8 : 3);
  if (entry.frame.remote) {
    line("-       " + padded(id, 12) + "  remote request");
    return false;
  }
  CanFrame whole = message;
  whole.length = 64;
  const Address address = firmware::can::identify(whole);
  const std::string bytes = "[" + std::to_string(entry.frame.length) + "] " + bytes_text(entry.frame);
  if (address.frame != nullptr) {
    line(padded(sender_text(address), 6) + "  " + padded(frame_text(*address.frame), 12) + "  " + bytes +
         "   (too short: " + std::to_string(address.frame->length) + " bytes expected)");
  } else {
    line("-       " + padded(id, 12) + "  " + bytes + "   (not of this protocol)");
  }
  return false;
}

}  // namespace can_log
