// What the keys mean. Pure: keys in, frames to send and what to show out.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "firmware/can_protocol/messages/messages.hpp"
#include "firmware/can_protocol/messages/packing.hpp"

namespace live {

// Keys that are no characters.
enum Key : int { kKeyNone = -1, kKeyUp = 1000, kKeyDown, kKeyPageUp, kKeyPageDown, kKeyResize };

class Controls {
 public:
  explicit Controls(bool can_send) : can_send_(can_send) {}

  // nodes: those that were heard. A frame comes back where one is to be sent.
  std::optional<firmware::CanFrame> press(int key, const std::vector<int>& nodes);

  bool quit() const { return quit_; }
  int node() const { return node_; }
  int first_row() const { return first_row_; }
  void limit_rows(int last_first_row);         // after each change of the screen
  void follow(const std::vector<int>& nodes);  // shows the first node that is heard
  // What became of a frame, shown until the next key.
  void tell(const std::string& news) { news_ = news; }

  std::string prompt() const;  // the last line: keys, a question, or news
  bool asks() const { return asked_.has_value(); }

 private:
  std::optional<firmware::CanFrame> ask(firmware::NetworkCommandCode command, int key);
  std::optional<firmware::CanFrame> answer(int key);
  void scroll(int rows);
  void next_node(const std::vector<int>& nodes);

  bool can_send_;
  bool quit_ = false;
  int node_ = 1, first_row_ = 0;
  bool node_chosen_ = false;
  std::optional<firmware::NetworkCommandCode> asked_;
  int asked_key_ = kKeyNone;
  std::string news_;
};

}  // namespace live
