#include "host_sim/live/terminal/controls.hpp"

#include <algorithm>

namespace live {
namespace {

using firmware::NetworkCommandCode;
constexpr int kInterrupt = 3, kEscape = 27, kPage = 8;  // ctrl-C; rows

std::string word_of(NetworkCommandCode command) {
  switch (command) {
    case NetworkCommandCode::kStart:
      return "START";
    case NetworkCommandCode::kStop:
      return "STOP";
    case NetworkCommandCode::kReset:
      break;
  }
  return "RESET";
}

std::string consequence_of(NetworkCommandCode command) {
  switch (command) {
    case NetworkCommandCode::kStart:
      return "the shaker moves";
    case NetworkCommandCode::kStop:
      return "ramps down; no emergency stop";
    case NetworkCommandCode::kReset:
      break;
  }
  return "forgets a fault, or what was recorded";
}

}  // namespace

std::optional<firmware::CanFrame> Controls::press(int key, const std::vector<int>& nodes) {
  if (key == kKeyNone || key == kKeyResize) return std::nullopt;
  news_.clear();
  if (key == kInterrupt) quit_ = true;
  if (asked_) return answer(key);
  switch (key) {
    case 'q':
    case 'Q':
      quit_ = true;
      break;
    case 'w':
      if (can_send_) return firmware::pack_sync();
      news_ = "only an interface takes commands";
      break;
    case 's':
      return ask(NetworkCommandCode::kStart, key);
    case 'x':
      return ask(NetworkCommandCode::kStop, key);
    case 'r':
      return ask(NetworkCommandCode::kReset, key);
    case '\t':
      next_node(nodes);
      break;
    case kKeyUp:
      scroll(-1);
      break;
    case kKeyDown:
      scroll(1);
      break;
    case kKeyPageUp:
      scroll(-kPage);
      break;
    case kKeyPageDown:
      scroll(kPage);
      break;
    default:
      break;
  }
  return std::nullopt;
}

std::optional<firmware::CanFrame> Controls::ask(NetworkCommandCode command, int key) {
  if (!can_send_) {
    news_ = "only an interface takes commands";
    return std::nullopt;
  }
  asked_ = command;
  asked_key_ = key;
  return std::nullopt;
}

// The same key again says yes too: a stop is two presses of x.
std::optional<firmware::CanFrame> Controls::answer(int key) {
  const NetworkCommandCode command = *asked_;
  asked_.reset();
  if (key != 'y' && key != 'Y' && key != asked_key_) {
    if (key != kEscape && key != kInterrupt) news_ = word_of(command) + " not sent";
    return std::nullopt;
  }
  return firmware::pack_network_command({command, static_cast<uint8_t>(node_)});
}

void Controls::scroll(int rows) { first_row_ = std::max(0, first_row_ + rows); }

void Controls::limit_rows(int last_first_row) { first_row_ = std::min(first_row_, last_first_row); }

void Controls::next_node(const std::vector<int>& nodes) {
  if (nodes.empty()) return;
  const auto next = std::upper_bound(nodes.begin(), nodes.end(), node_);
  node_ = next == nodes.end() ? nodes.front() : *next;
  node_chosen_ = true;
  first_row_ = 0;
}

void Controls::follow(const std::vector<int>& nodes) {
  if (!node_chosen_ && !nodes.empty()) node_ = nodes.front();
}

std::string Controls::prompt() const {
  if (asked_) return word_of(*asked_) + " node " + std::to_string(node_) + "? " + consequence_of(*asked_) + ": y/n";
  if (!news_.empty()) return news_;
  return can_send_ ? "w window  s start  x stop  r reset  Tab node  q quit" : "Tab node  arrows scroll  q quit";
}

}  // namespace live
