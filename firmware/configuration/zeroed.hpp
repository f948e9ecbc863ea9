// Memory that is cleared at once, for working memory whose initial values do not matter or are zero: a constructor that goes through
// its members one by one takes room in flash.
#pragma once
#include <type_traits>

namespace firmware {

// A T of zero bits; what T's own constructor would set otherwise its user sets before it reads it.
template <typename T>
class Zeroed {
 public:
  T& operator*() { return *reinterpret_cast<T*>(bytes_); }
  const T& operator*() const { return *reinterpret_cast<const T*>(bytes_); }
  T* operator->() { return &**this; }
  const T* operator->() const { return &**this; }

 private:
  static_assert(std::is_trivially_copyable<T>::value && std::is_trivially_destructible<T>::value,
                "bits are all there is");
  alignas(T) unsigned char bytes_[sizeof(T)] = {};
};

}  // namespace firmware
