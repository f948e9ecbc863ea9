#include "host_sim/can_log/dbc.hpp"

#include <cctype>
#include <functional>
#include <limits>

#include "firmware/can_protocol/frame_table.hpp"
#include "host_sim/can_log/known_names.hpp"
#include "host_sim/can_log/table_text.hpp"

namespace can_log {
namespace {

using firmware::can::FrameDescription;
using firmware::can::Signal;

constexpr int kStandardCanFd = 14;  // place of "StandardCAN_FD" in the usual list of frame formats

// One message of the file: a frame of the table at one identifier.
struct Message {
  const FrameDescription& frame;
  int member;
  uint32_t id;
  std::string name;
  std::string sender;
  std::string comment;
};

// One signal of the file: of a table of flags each named bit is one of its own.
struct DbcSignal {
  const Signal& signal;
  std::string name;
  int start_bit;
  int length;
  std::string unit;
  std::string comment;
  const char* flag;       // null where the signal is no single flag
  bool is_float = false;  // the raw value is a bit pattern of IEEE 754
};

bool is_float_form(const FrameDescription& frame) {
  return &frame == &firmware::can::kEstimateFloat || &frame == &firmware::can::kEstimateFloatFd;
}

// "viscous[1-2]" as a name of the format: viscous_1_2. With "_std" behind it no more than 32 characters: the words of
// long kinds keep four letters, disp_depe_damp_1_2.
std::string signal_name(const std::string& parameter) {
  constexpr size_t kLongest = 32 - 4, kLetters = 4;
  std::string name;
  for (const char c : parameter) {
    const bool allowed = std::isalnum(static_cast<unsigned char>(c)) != 0;
    if (allowed || (!name.empty() && name.back() != '_')) name += allowed ? c : '_';
  }
  if (!name.empty() && name.back() == '_') name.pop_back();
  if (name.size() <= kLongest) return name;
  std::string cut;
  size_t letters = 0;
  for (const char c : name) {
    letters = c == '_' ? 0 : letters + 1;
    if (letters <= kLetters) cut += c;
  }
  return cut.substr(0, kLongest);
}

std::string sender_name(const FrameDescription& frame, int node) {
  switch (frame.sender) {
    case firmware::can::Sender::kController:
      return "controller_" + std::to_string(node);
    case firmware::can::Sender::kSensor:
      return "sensors";
    case firmware::can::Sender::kMaster:
      break;
  }
  return "master";
}

std::string message_name(const FrameDescription& frame, int node, int member) {
  std::string name = frame.name;
  if (node > 0) name += "_" + std::to_string(node);
  if (frame.ids.members == 1) return name;
  if (frame.sender != firmware::can::Sender::kSensor) return name + "_" + std::to_string(member);
  const int place = member + 1;
  return name + (place == firmware::can::kPlaceBase ? "_base" : "_dof_" + std::to_string(place));
}

bool of_estimates(const FrameDescription& frame) {
  namespace can = firmware::can;
  return &frame == &can::kEstimate || &frame == &can::kEstimateFd || is_float_form(frame);
}

std::string message_comment(const FrameDescription& frame, int member, const std::vector<DbcParameter>& parameters) {
  std::string comment = frame.comment;
  if (parameters.empty() || !of_estimates(frame)) return comment;
  if (!frame.fd) return parameters[static_cast<size_t>(member)].name + ". " + comment;
  comment += " Here:";
  for (size_t i = static_cast<size_t>(member) * 8; i < parameters.size() && i < static_cast<size_t>(member + 1) * 8;
       ++i)
    comment += " " + parameters[i].name;
  return comment;
}

int members(const FrameDescription& frame, const std::vector<DbcParameter>& parameters) {
  const int count = static_cast<int>(parameters.size());
  if (count == 0 || !of_estimates(frame)) return frame.ids.members;
  return std::min<int>((count + frame.repeats - 1) / frame.repeats, frame.ids.members);
}

void for_each_message(const std::vector<DbcParameter>& parameters, const std::function<void(const Message&)>& visit) {
  for (const FrameDescription* frame : firmware::can::kFrames) {
    const bool per_node = frame->ids.node_stride > 0;
    const int first = per_node ? firmware::can::kFirstNode : 0, last = per_node ? firmware::can::kLastNode : 0;
    for (int node = first; node <= last; ++node)
      for (int member = 0; member < members(*frame, parameters); ++member)
        visit(Message{*frame, member, firmware::can::frame_id(frame->ids, node, member),
                      message_name(*frame, node, member), sender_name(*frame, node),
                      message_comment(*frame, member, parameters)});
  }
}

// Value and standard deviation of the parameters that a float frame holds, by their names.
void for_each_float(const Message& message, const std::vector<DbcParameter>& parameters,
                    const std::function<void(const DbcSignal&)>& visit) {
  const FrameDescription& frame = message.frame;
  for (int record = 0; record < frame.repeats; ++record) {
    const size_t index = static_cast<size_t>(message.member * frame.repeats + record);
    if (index >= parameters.size()) return;
    const DbcParameter& parameter = parameters[index];
    for (int i = 0; i < frame.signal_count; ++i) {
      const Signal& signal = frame.signals[i];
      visit(DbcSignal{signal, signal_name(parameter.name) + (i == 0 ? "" : "_std"),
                      signal.start_bit + record * firmware::can::record_bits(frame), signal.length, parameter.unit,
                      parameter.name + (i == 0 ? "" : ", standard deviation"), nullptr, true});
    }
  }
}

void for_each_signal(const Message& message, const std::vector<DbcParameter>& parameters,
                     const std::function<void(const DbcSignal&)>& visit) {
  const FrameDescription& frame = message.frame;
  if (is_float_form(frame) && !parameters.empty()) return for_each_float(message, parameters, visit);
  for (int record = 0; record < frame.repeats; ++record) {
    const std::string suffix = frame.repeats > 1 ? "_" + std::to_string(record) : "";
    const int offset = record * firmware::can::record_bits(frame);
    for (int i = 0; i < frame.signal_count; ++i) {
      const Signal& signal = frame.signals[i];
      const int start = signal.start_bit + offset;
      if (!signal.names.flags) {
        visit(DbcSignal{signal, signal.name + suffix, start, signal.length, signal.unit, signal.comment, nullptr});
        continue;
      }
      for (int k = 0; k < signal.names.count; ++k) {
        const firmware::can::NamedValue& flag = signal.names.entries[k];
        visit(DbcSignal{signal, std::string(signal.name) + "_" + lower_case(flag.name) + suffix, start + flag.value, 1,
                        "flag", std::string(signal.name) + ": " + signal.comment, flag.name});
      }
    }
  }
}

void write_head(std::ostream& output) {
  output << "VERSION \"\"\n\nNS_ :\n\tCM_\n\tBA_DEF_\n\tBA_\n\tVAL_\n\tBA_DEF_DEF_\n\nBS_:\n\nBU_: master sensors";
  for (int node = firmware::can::kFirstNode; node <= firmware::can::kLastNode; ++node) output << " controller_" << node;
  output << "\n";
}

void write_message(std::ostream& output, const Message& message, const std::vector<DbcParameter>& parameters) {
  output << "\nBO_ " << message.id << " " << message.name << ": " << static_cast<int>(message.frame.length) << " "
         << message.sender << "\n";
  for_each_signal(message, parameters, [&](const DbcSignal& entry) {
    const Signal& s = entry.signal;
    constexpr double kLargestFloat = std::numeric_limits<float>::max();
    const double lowest = entry.flag       ? 0
                          : entry.is_float ? -kLargestFloat
                                           : physical(s, lowest_raw(s)),
                 highest = entry.flag       ? 1
                           : entry.is_float ? kLargestFloat
                                            : physical(s, highest_raw(s));
    output << " SG_ " << entry.name << " : " << entry.start_bit << "|" << entry.length << "@1"
           << (s.is_signed || entry.is_float ? "-" : "+") << " (" << shortest(factor(s)) << "," << s.offset << ") ["
           << shortest(lowest) << "|" << shortest(highest) << "] \"" << entry.unit << "\" Vector__XXX\n";
  });
}

void write_comments(std::ostream& output, const Message& message, const std::vector<DbcParameter>& parameters) {
  output << "CM_ BO_ " << message.id << " \"" << message.comment << "\";\n";
  for_each_signal(message, parameters, [&](const DbcSignal& entry) {
    output << "CM_ SG_ " << message.id << " " << entry.name << " \"" << entry.comment << "\";\n";
  });
}

void write_attributes(std::ostream& output, const std::vector<DbcParameter>& parameters) {
  output << "BA_DEF_ \"BusType\" STRING ;\n"
            "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
            "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"ExtendedCAN\"";
  for (int i = 2; i < kStandardCanFd; ++i) output << ",\"reserved\"";
  output << ",\"StandardCAN_FD\",\"ExtendedCAN_FD\";\n"
            "BA_DEF_DEF_ \"BusType\" \"CAN FD\";\n"
            "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
            "BA_DEF_DEF_ \"VFrameFormat\" \"StandardCAN\";\n";
  for_each_message(parameters, [&](const Message& message) {
    output << "BA_ \"GenMsgCycleTime\" BO_ " << message.id << " " << message.frame.cycle_ms << ";\n";
    if (message.frame.fd) output << "BA_ \"VFrameFormat\" BO_ " << message.id << " " << kStandardCanFd << ";\n";
  });
}

void write_values(std::ostream& output, const Message& message, const std::vector<DbcParameter>& parameters) {
  for_each_signal(message, parameters, [&](const DbcSignal& entry) {
    if (entry.signal.names.count == 0) return;
    output << "VAL_ " << message.id << " " << entry.name;
    if (entry.flag != nullptr) {
      output << " 0 \"no\" 1 \"" << entry.flag << "\"";
    } else {
      for (int i = 0; i < entry.signal.names.count; ++i)
        output << " " << entry.signal.names.entries[i].value << " \"" << entry.signal.names.entries[i].name << "\"";
    }
    output << " ;\n";
  });
}

// Which raw values are bit patterns of floats: 1 is single precision.
void write_value_types(std::ostream& output, const Message& message, const std::vector<DbcParameter>& parameters) {
  for_each_signal(message, parameters, [&](const DbcSignal& entry) {
    if (entry.is_float) output << "SIG_VALTYPE_ " << message.id << " " << entry.name << " : 1;\n";
  });
}

}  // namespace

void dbc(std::ostream& output, const std::vector<DbcParameter>& parameters) {
  using Part = void (*)(std::ostream&, const Message&, const std::vector<DbcParameter>&);
  const auto each = [&](Part part) {
    for_each_message(parameters, [&](const Message& message) { part(output, message, parameters); });
  };
  write_head(output);
  each(write_message);
  output << "\n";
  each(write_comments);
  write_attributes(output, parameters);
  each(write_values);
  each(write_value_types);
}

}  // namespace can_log
