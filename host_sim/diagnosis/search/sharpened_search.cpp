#include "sharpened_search.hpp"

#include "../record/sharpen.hpp"

namespace diagnosis {
namespace {

constexpr double kWorthSharpening = 1.2;  // chi-squared per degree of freedom
constexpr int kSlowRounds = 6;

}  // namespace

SearchResult search_sharpening(std::unique_ptr<Bench>& owner) {
  SearchResult found = search(*owner->rows, *owner->bank);
  const int rounds = found.base_fit.ratio() <= kWorthSharpening ? 0 : owner->rows->absolute() ? 1 : kSlowRounds;
  for (int i = 0; i < rounds && !found.added.empty(); ++i) {
    auto sharper = std::make_unique<Bench>(Bench{owner->system, owner->records, owner->imposed});
    sharpen(sharper->records, owner->system, found.model);
    sharper->lay_out();
    const SearchResult again = search(*sharper->rows, *sharper->bank);
    if (again.fit.ratio() >= found.fit.ratio()) break;
    found = again, owner = std::move(sharper);
    if (found.fit.ratio() < kWorthSharpening) break;
  }
  return found;
}

}  // namespace diagnosis
