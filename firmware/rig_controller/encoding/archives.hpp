// Those who walk the fields of a configuration: a writer, a counter, a reader and a comparer.
#pragma once
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "firmware/configuration/bytes.hpp"
#include "firmware/configuration/configuration.hpp"

namespace firmware {

// Bytes go to a buffer where there is one, and into the check sum.
class Writer {
 public:
  Writer(uint8_t* bytes, size_t capacity) : bytes_(bytes), capacity_(capacity) {}
  template <typename T>
  void field(const T& value) {
    const auto bits = static_cast<uint64_t>(static_cast<int64_t>(value));
    for (size_t i = 0; i < sizeof(T); ++i) put(static_cast<uint8_t>(bits >> (8 * i)));
  }
  template <typename T>
  void clear(const T&) {}
  void node(uint8_t number) { field(static_cast<uint8_t>(wire_node(number))); }
  static int count(int number, int) { return number; }
  size_t size() const { return size_; }
  uint32_t crc() const { return crc_.value(); }

 private:
  void put(uint8_t byte) {
    crc_.add(byte);
    if (size_ < capacity_) bytes_[size_] = byte;
    ++size_;
  }
  uint8_t* bytes_;
  size_t capacity_;
  size_t size_ = 0;
  Crc32 crc_;
};

// Bytes alone, for the length of the longest configuration.
class Counter {
 public:
  template <typename T>
  constexpr void field(const T&) {
    size_ += sizeof(T);
  }
  template <typename T>
  constexpr void clear(const T&) {}
  constexpr void node(uint8_t) { ++size_; }
  static constexpr int count(int number, int) { return number; }
  constexpr size_t size() const { return size_; }

 private:
  size_t size_ = 0;
};

class Reader {
 public:
  Reader(const uint8_t* bytes, size_t size) : bytes_(bytes), size_(size) {}
  template <typename T>
  void field(T& value) {
    uint64_t bits = 0;
    for (size_t i = 0; i < sizeof(T); ++i) bits |= static_cast<uint64_t>(next()) << (8 * i);
    if constexpr (std::is_same<T, bool>::value) {
      value = bits != 0;
    } else {
      value = static_cast<T>(bits);
    }
  }
  template <typename T, size_t N>
  void clear(T (&values)[N]) {
    for (T& value : values) value = T{};
  }
  void node(uint8_t& number) {
    const int index = node_of_wire(next());
    refused_ = refused_ || index < 0;
    number = static_cast<uint8_t>(index < 0 ? kGroundNode : index);
  }
  // What does not fit this core is refused.
  int count(int number, int capacity) {
    refused_ = refused_ || number > capacity;
    return number > capacity ? capacity : number;
  }
  size_t read() const { return place_; }
  bool overrun() const { return refused_ || place_ > size_; }

 private:
  uint8_t next() { return place_ < size_ ? bytes_[place_++] : (++place_, uint8_t{0}); }
  const uint8_t* bytes_;
  size_t size_;
  size_t place_ = 0;
  bool refused_ = false;
};

// Whether bytes are those of a configuration in memory.
class Comparer {
 public:
  Comparer(const uint8_t* bytes, size_t size) : reader_(bytes, size) {}
  template <typename T>
  void field(const T& value) {
    T stored{};
    reader_.field(stored);
    same_ = same_ && stored == value;
  }
  template <typename T>
  void clear(const T&) {}
  void node(uint8_t number) { field(static_cast<uint8_t>(wire_node(number))); }
  static int count(int number, int) { return number; }
  bool same() const { return same_ && !reader_.overrun(); }
  size_t read() const { return reader_.read(); }

 private:
  Reader reader_;
  bool same_ = true;
};

}  // namespace firmware
