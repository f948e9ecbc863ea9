// A line of text put together without a library; it goes out when it ends.
#pragma once
#include "firmware/fixed_point/scaled.hpp"
#include "tests/bare_metal/script.hpp"

namespace bare_metal {

class Line {
 public:
  explicit Line(Text& out) : out_(out) {}
  ~Line() {
    add("\n");
    out_.print(text_, size_);
  }
  Line& add(const char* text) {
    while (*text != 0 && size_ < sizeof text_) text_[size_++] = *text++;
    return *this;
  }
  Line& add(int64_t value) {
    char digits[24];
    int n = 0;
    uint64_t rest = value < 0 ? ~static_cast<uint64_t>(value) + 1 : static_cast<uint64_t>(value);
    do {
      digits[n++] = static_cast<char>('0' + static_cast<int>(rest % 10));
      rest /= 10;
    } while (rest > 0);
    if (value < 0) digits[n++] = '-';
    while (n > 0 && size_ < sizeof text_) text_[size_++] = digits[--n];
    return *this;
  }
  Line& add(firmware::Scaled value) { return add(int64_t{value.mantissa}).add(":").add(int64_t{value.exponent}); }

 private:
  Text& out_;
  char text_[160];
  size_t size_ = 0;
};

// The work of one kind of piece.
struct Cost {
  static constexpr uint32_t kBin = 8, kBins = 8192;
  uint64_t total = 0;
  uint32_t count = 0, worst = 0;
  uint32_t histogram[kBins] = {};  // of the work, in steps of kBin
  void add(uint32_t work) {
    ++count;
    total += work;
    if (work > worst) worst = work;
    ++histogram[work / kBin < kBins ? work / kBin : kBins - 1];
  }
  uint32_t median() const {
    uint32_t below = 0, bin = 0;
    while (bin + 1 < kBins && 2 * (below + histogram[bin]) < count) below += histogram[bin++];
    return bin * kBin + kBin / 2;
  }
  void print(const char* name, Text& out) const {
    if (total == 0) return;
    Line(out)
        .add(name)
        .add(": count ")
        .add(int64_t{count})
        .add(" total ")
        .add(static_cast<int64_t>(total))
        .add(" worst ")
        .add(int64_t{worst});
  }
};

}  // namespace bare_metal
