#include "band.hpp"
#include "fused.hpp"
#include "guess.hpp"

namespace diagnosis::runs {

void renew_base(Prepared& p) {
  if (!p.base.given()) return;
  const auto measured = [&](size_t quantity) {
    return p.base.reading[quantity].size() ? &p.base.reading[quantity] : nullptr;
  };
  const bool slower = measured(0) || measured(1);
  p.guess.back() = measured(2) && slower
                       ? fused_by_acceleration(measured(0), measured(1), *measured(2), p.step_s)
                       : guess_of({measured(0), measured(1), measured(2)}, p.step_s, p.smooth_half, p.slow_half);
  if (measured(2) && slower && !measured(0)) p.guess.back().x = integrated(p.guess.back().v, p.step_s, p.slow_half);
  if (p.base.ridden) p.guess.back().x.setZero(), p.guess.back().v.setZero();
}

}  // namespace diagnosis::runs
