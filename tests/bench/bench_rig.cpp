#include "tests/bench/bench_rig.hpp"

#include <cmath>

namespace bench {
namespace {

constexpr int kCount = 64;
constexpr double kUnit = 1.0 / (1 << 20);

double wave(int dof, int n, int derivative) {
  const double w[2] = {2.0 * M_PI * 7.0, 2.0 * M_PI * 23.0}, t = n * kPeriod_s;
  double sum = 0.0;
  for (int k = 0; k < 2; ++k) {
    const double phase = w[k] * t + 0.7 * dof * (k + 1) + derivative * M_PI / 2;
    sum += std::pow(w[k], derivative - 1) * std::sin(phase);
  }
  return sum * 0.01;
}

}  // namespace

firmware::CoreConfiguration chain(int dofs, bool all_unknown) {
  using namespace firmware;
  CoreConfiguration c;
  c.dof_count = static_cast<uint8_t>(dofs);
  c.link_count = static_cast<uint8_t>(dofs + 1);
  c.sample_period_s = Scaled::ratio(1, 1000);
  const auto add = [&](TermKind kind, int place, bool unknown, int64_t value) {
    Term& term = c.terms[c.term_count++];
    term.kind = kind;
    term.place = static_cast<uint8_t>(place);
    term.unknown = unknown ? static_cast<int8_t>(c.unknown_count++) : static_cast<int8_t>(-1);
    term.value = Scaled::from_int(value);
  };
  for (int l = 0; l <= dofs; ++l) {
    // Ground is always the second node.
    c.links[l].node_a = static_cast<uint8_t>(l < dofs ? l : dofs - 1);
    c.links[l].node_b = static_cast<uint8_t>(l == 0 || l == dofs ? kGroundNode : l - 1);
    add(TermKind::kViscous, l, true, 0);
    if (all_unknown || l == dofs) add(TermKind::kCoulomb, l, true, 0);
  }
  for (int l = 0; l <= dofs; ++l) add(TermKind::kStiffness, l, all_unknown && c.unknown_count < kMaxUnknowns, 10000);
  for (int i = 0; i < dofs; ++i) {
    add(TermKind::kMass, i, false, 1);
    for (int q = i == 0 ? 0 : 1; q < kQuantities; ++q) {
      c.channels[i][q].present = true;
      c.channels[i][q].unit_per_code = Scaled::from_int(1, -20);
    }
  }
  copy_measured_signals(c);
  return c;
}

std::vector<firmware::RawSample> raw_samples(int dofs) {
  std::vector<firmware::RawSample> result(kCount);
  for (int n = 0; n < kCount; ++n)
    for (int i = 0; i < dofs; ++i) {
      for (int q = 1; q < firmware::kQuantities; ++q)
        result[static_cast<size_t>(n)].code[i][q] = static_cast<int32_t>(std::lround(wave(i, n, q - 1) / kUnit));
      if (i == 0) result[static_cast<size_t>(n)].code[0][0] = static_cast<int32_t>(std::lround(wave(99, n, 1) / kUnit));
    }
  return result;
}

std::vector<Sample> samples(int dofs) {
  std::vector<Sample> result;
  for (const firmware::RawSample& raw : raw_samples(dofs)) {
    Sample s;
    for (int i = 0; i < dofs; ++i) {
      s.f.push_back(raw.code[i][0] * kUnit);
      s.x.push_back(raw.code[i][1] * kUnit);
      s.v.push_back(raw.code[i][2] * kUnit);
      s.a.push_back(raw.code[i][3] * kUnit);
    }
    result.push_back(s);
  }
  return result;
}

}  // namespace bench
