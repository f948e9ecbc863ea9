// The slopes of every law, of every memory and of every event against differences of their values.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "host_sim/vocabulary/law.hpp"

using namespace vocabulary;

namespace {

struct Knob {
  const char* name;
  double (*slope)(const Slopes&);
  double& (*input)(Point&, Shape&);
};
constexpr Knob kKnobs[] = {
    {"u", [](const Slopes& s) { return s.u; }, [](Point& p, Shape&) -> double& { return p.u; }},
    {"w", [](const Slopes& s) { return s.w; }, [](Point& p, Shape&) -> double& { return p.w; }},
    {"a", [](const Slopes& s) { return s.a; }, [](Point& p, Shape&) -> double& { return p.a; }},
    {"z0", [](const Slopes& s) { return s.z[0]; }, [](Point& p, Shape&) -> double& { return p.z[0]; }},
    {"z1", [](const Slopes& s) { return s.z[1]; }, [](Point& p, Shape&) -> double& { return p.z[1]; }},
    {"shape 0", [](const Slopes& s) { return s.shape[0]; }, [](Point&, Shape& s) -> double& { return s.p[0]; }},
    {"shape 1", [](const Slopes& s) { return s.shape[1]; }, [](Point&, Shape& s) -> double& { return s.p[1]; }},
};

using Value = std::function<double(const Point&, const Shape&)>;

// Central differences over 2e-5 of an input of the order of one: error of the order of 1e-9 of the third derivative.
void expect_slopes(const Value& value, const Slopes& slopes, const Point& at, const Shape& shape) {
  for (const Knob& knob : kKnobs) {
    Point low = at, high = at;
    Shape low_shape = shape, high_shape = shape;
    const double step = 1e-5;
    knob.input(low, low_shape) -= step, knob.input(high, high_shape) += step;
    const double difference = (value(high, high_shape) - value(low, low_shape)) / (2 * step);
    EXPECT_NEAR(knob.slope(slopes), difference, 1e-6 * (1 + std::abs(difference))) << "with respect to " << knob.name;
  }
}

// Both directions of the rate, inside and beyond a gap, early and late.
struct Place {
  double u, w, t_s;
};
constexpr Place kPlaces[] = {{0.3, 0.7, 0.2}, {-0.4, -1.1, 1.5}, {0.9, -0.5, 0.7}, {-1.2, 0.8, 3.0}};
const Shape kShape{{0.6, 0.25}};

Point at_place(EffectKind kind, const Place& place) {
  Point at = point(kind, place.u, place.w, place.t_s, kShape);
  at.a = -0.35, at.z[0] = 0.45, at.z[1] = -0.2;
  return at;
}

}  // namespace

TEST(Slopes, OfEveryForce) {
  for (const firmware::EffectRow& row : firmware::kEffectTable) {
    SCOPED_TRACE(row.word.text);
    for (const Place& place : kPlaces) {
      const Point at = at_place(row.kind, place);
      expect_slopes([&](const Point& p, const Shape& s) { return force(row.kind, p, s).value; },
                    force(row.kind, at, kShape).slope, at, kShape);
    }
  }
}

TEST(Slopes, OfEveryMemory) {
  int memories = 0;
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    for (int m = 0; m < law_of(row.kind).memories; ++m, ++memories) {
      SCOPED_TRACE(row.word.text);
      for (const Place& place : kPlaces) {
        const Point at = at_place(row.kind, place);
        expect_slopes([&](const Point& p, const Shape& s) { return memory_rate(row.kind, p, s).value[m]; },
                      memory_rate(row.kind, at, kShape).slope[m], at, kShape);
      }
    }
  EXPECT_GE(memories, 3);
}

TEST(Slopes, OfEveryEvent) {
  for (const firmware::EffectRow& row : firmware::kEffectTable)
    for (int e = 0; e < events_of(row.kind); ++e) {
      SCOPED_TRACE(row.word.text);
      for (const Place& place : kPlaces) {
        const Point at = at_place(row.kind, place);
        const EventFunction g = event_function(row.kind, e, at, kShape);
        Slopes slopes;
        slopes.u = g.u, slopes.w = g.w, slopes.shape[0] = g.shape[0], slopes.shape[1] = g.shape[1];
        expect_slopes([&](const Point& p, const Shape& s) { return event_function(row.kind, e, p, s).value; }, slopes,
                      at, kShape);
      }
    }
}

// A step of advance_memory against a thousand small ones of the rate: the two forms of one law.
TEST(Memories, AdvanceAsTheirRatesSay) {
  for (const firmware::EffectRow& row : firmware::kEffectTable) {
    const int memories = law_of(row.kind).memories;
    if (memories == 0) continue;
    SCOPED_TRACE(row.word.text);
    const double h = 1e-3, w = 2.0;
    const Point from = point(row.kind, 0.1, w, 0.0, kShape), to = point(row.kind, 0.1 + w * h, w, h, kShape);
    double z[kMemories] = {0.3, 0.5}, small[kMemories] = {0.3, 0.5};
    advance_memory(row.kind, from, to, h, kShape, z);
    for (int k = 0; k < 1000; ++k) {
      Point at = point(row.kind, 0.1 + w * h * (k + 0.5) / 1000, w, 0.0, kShape);
      at.z[0] = small[0], at.z[1] = small[1];
      const MemoryRate r = memory_rate(row.kind, at, kShape);
      for (int m = 0; m < memories; ++m) small[m] += h / 1000 * r.value[m];
    }
    for (int m = 0; m < memories; ++m) EXPECT_NEAR(z[m], small[m], 5e-6);  // of the small steps' own error
  }
}
