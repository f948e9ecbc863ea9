#include "host_sim/can_log/dbc.hpp"

#include <functional>

#include "firmware/can_protocol/frame_table.hpp"
#include "host_sim/can_log/known_names.hpp"
#include "host_sim/can_log/table_text.hpp"

namespace can_log {
namespace {

using firmware::can::Frame;
using firmware::can::Signal;

constexpr int kStandardCanFd = 14;  // place of "StandardCAN_FD" in the usual list of frame formats

// One message of the file: a frame of the table at one identifier.
struct Message {
  const Frame& frame;
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
  const char* unit;
  std::string comment;
  const char* flag;  // null where the signal is no single flag
};

std::string sender_name(const Frame& frame, int node) {
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

std::string message_name(const Frame& frame, int node, int member) {
  std::string name = frame.name;
  if (node > 0) name += "_" + std::to_string(node);
  if (frame.ids.members == 1) return name;
  if (frame.sender != firmware::can::Sender::kSensor) return name + "_" + std::to_string(member);
  const int place = member + 1;
  return name + (place == firmware::can::kPlaceBase ? "_base" : "_dof_" + std::to_string(place));
}

std::string message_comment(const Frame& frame, int member, const std::vector<std::string>& names) {
  std::string comment = frame.comment;
  if (&frame == &firmware::can::kEstimate && !names.empty()) return names[static_cast<size_t>(member)] + ". " + comment;
  if (&frame == &firmware::can::kEstimateFd && !names.empty()) {
    comment += " Here:";
    for (size_t i = static_cast<size_t>(member) * 8; i < names.size() && i < static_cast<size_t>(member + 1) * 8; ++i)
      comment += " " + names[i];
  }
  return comment;
}

int members(const Frame& frame, const std::vector<std::string>& names) {
  const int count = static_cast<int>(names.size());
  if (count > 0 && &frame == &firmware::can::kEstimate) return std::min<int>(count, frame.ids.members);
  if (count > 0 && &frame == &firmware::can::kEstimateFd) return std::min<int>((count + 7) / 8, frame.ids.members);
  return frame.ids.members;
}

void for_each_message(const std::vector<std::string>& names, const std::function<void(const Message&)>& visit) {
  for (const Frame* frame : firmware::can::kFrames) {
    const bool per_node = frame->ids.node_stride > 0;
    const int first = per_node ? firmware::can::kFirstNode : 0, last = per_node ? firmware::can::kLastNode : 0;
    for (int node = first; node <= last; ++node)
      for (int member = 0; member < members(*frame, names); ++member)
        visit(Message{*frame, firmware::can::frame_id(frame->ids, node, member), message_name(*frame, node, member),
                      sender_name(*frame, node), message_comment(*frame, member, names)});
  }
}

void for_each_signal(const Frame& frame, const std::function<void(const DbcSignal&)>& visit) {
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

void write_message(std::ostream& output, const Message& message) {
  output << "\nBO_ " << message.id << " " << message.name << ": " << static_cast<int>(message.frame.length) << " "
         << message.sender << "\n";
  for_each_signal(message.frame, [&](const DbcSignal& entry) {
    const Signal& s = entry.signal;
    const double lowest = entry.flag ? 0 : physical(s, lowest_raw(s)),
                 highest = entry.flag ? 1 : physical(s, highest_raw(s));
    output << " SG_ " << entry.name << " : " << entry.start_bit << "|" << entry.length << "@1"
           << (s.is_signed ? "-" : "+") << " (" << shortest(factor(s)) << "," << s.offset << ") [" << shortest(lowest)
           << "|" << shortest(highest) << "] \"" << entry.unit << "\" Vector__XXX\n";
  });
}

void write_comments(std::ostream& output, const Message& message) {
  output << "CM_ BO_ " << message.id << " \"" << message.comment << "\";\n";
  for_each_signal(message.frame, [&](const DbcSignal& entry) {
    output << "CM_ SG_ " << message.id << " " << entry.name << " \"" << entry.comment << "\";\n";
  });
}

void write_attributes(std::ostream& output, const std::vector<std::string>& names) {
  output << "BA_DEF_ \"BusType\" STRING ;\n"
            "BA_DEF_ BO_ \"GenMsgCycleTime\" INT 0 65535;\n"
            "BA_DEF_ BO_ \"VFrameFormat\" ENUM \"StandardCAN\",\"ExtendedCAN\"";
  for (int i = 2; i < kStandardCanFd; ++i) output << ",\"reserved\"";
  output << ",\"StandardCAN_FD\",\"ExtendedCAN_FD\";\n"
            "BA_DEF_DEF_ \"BusType\" \"CAN FD\";\n"
            "BA_DEF_DEF_ \"GenMsgCycleTime\" 0;\n"
            "BA_DEF_DEF_ \"VFrameFormat\" \"StandardCAN\";\n";
  for_each_message(names, [&](const Message& message) {
    output << "BA_ \"GenMsgCycleTime\" BO_ " << message.id << " " << message.frame.cycle_ms << ";\n";
    if (message.frame.fd) output << "BA_ \"VFrameFormat\" BO_ " << message.id << " " << kStandardCanFd << ";\n";
  });
}

void write_values(std::ostream& output, const Message& message) {
  for_each_signal(message.frame, [&](const DbcSignal& entry) {
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

}  // namespace

void dbc(std::ostream& output, const std::vector<std::string>& parameter_names) {
  write_head(output);
  for_each_message(parameter_names, [&](const Message& message) { write_message(output, message); });
  output << "\n";
  for_each_message(parameter_names, [&](const Message& message) { write_comments(output, message); });
  write_attributes(output, parameter_names);
  for_each_message(parameter_names, [&](const Message& message) { write_values(output, message); });
}

}  // namespace can_log
