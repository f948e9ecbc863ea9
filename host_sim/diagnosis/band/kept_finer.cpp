#include "kept_finer.hpp"

#include <algorithm>

#include "between_samples.hpp"

namespace diagnosis::runs {
namespace {

constexpr size_t kKept = 4;  // series: two forces, or a base's three; more masses with a force are few

}  // namespace

std::shared_ptr<const Vec> KeptFiner::of(const Vec& y, double late, Index per) {
  const std::lock_guard<std::mutex> lock(mutex_);
  const auto same = [&](const Made& m) {
    return m.late == late && m.per == per && m.y.size() == y.size() && std::equal(y.begin(), y.end(), m.y.begin());
  };
  const auto found = std::find_if(made_.begin(), made_.end(), same);
  if (found != made_.end()) {
    made_.splice(made_.begin(), made_, found);
    return made_.front().finer;
  }
  made_.push_front({y, late, per, std::make_shared<const Vec>(finer(late != 0 ? delayed(y, late) : y, per))});
  if (made_.size() > kKept) made_.pop_back();
  return made_.front().finer;
}

}  // namespace diagnosis::runs
