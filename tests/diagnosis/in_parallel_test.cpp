// Work on several cores gives what it gives on one, to the last bit.
#include "host_sim/diagnosis/fit/in_parallel.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "host_sim/diagnosis/fit/evaluator.hpp"

namespace {

using namespace diagnosis;
using namespace diagnosis::runs;

TEST(InParallel, EveryPieceIsWorkedOnOnceAndOneAtATimeInALane) {
  for (const size_t count : {size_t{0}, size_t{1}, size_t{1000}}) {
    std::vector<std::atomic<int>> done(count), busy(lanes());
    in_parallel(count, [&](size_t piece, size_t lane) {
      ASSERT_LT(lane, lanes());
      EXPECT_EQ(busy[lane]++, 0);
      ++done[piece];
      --busy[lane];
    });
    for (const std::atomic<int>& times : done) EXPECT_EQ(times, 1);
  }
}

// Pieces that share out work of their own do it one after another, in the lane of index 0: so many threads are at work as there are lanes.
TEST(InParallel, PiecesOfAPieceAreDoneInTurn) {
  std::vector<std::vector<size_t>> order(4);
  in_parallel(order.size(), [&](size_t piece, size_t) {
    in_parallel(10, [&](size_t inner, size_t lane) {
      EXPECT_EQ(lane, lanes() > 1 ? 0u : lane);
      order[piece].push_back(inner);
    });
  });
  for (const std::vector<size_t>& inner : order) EXPECT_EQ(inner, (std::vector<size_t>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9}));
  std::atomic<int> done{0};
  in_parallel(100, [&](size_t, size_t) { ++done; });
  EXPECT_EQ(done, 100) << "and afterwards they are shared out again";
}

TEST(InParallel, AnErrorOfAPieceIsThrownWhenAllHaveEnded) {
  std::atomic<int> begun{0}, ended{0};
  EXPECT_THROW(in_parallel(100,
                           [&](size_t piece, size_t) {
                             ++begun;
                             ++ended;
                             if (piece == 3) throw std::runtime_error("piece 3");
                           }),
               std::runtime_error);
  EXPECT_EQ(begun, ended);
  EXPECT_GE(begun, 4);
}

// A mass that friction brings to rest and releases again, over windows of one record: a lane's runs are those of the first lane,
// whatever either has run before.
TEST(InParallel, RunsOfEveryLaneAreThoseOfTheFirst) {
  rig_file::RigModel rig;
  rig.dofs.resize(1), rig.links.resize(1);
  rig.links[0].a = 1, rig.links[0].b = 0;
  const System system = make_system(rig);
  Model model;
  for (const auto& [term, value] : {std::pair<Term, double>{on_dof(Kind::kMass, 0), 1.0},
                                    {on_link(Kind::kStiffness, 0), 39.0},
                                    {on_link(Kind::kCoulomb, 0), 2.0}}) {
    model.emplace_back();
    model.back().term = term, model.back().value = value;
  }
  constexpr Index kSamples = 400;
  Prepared p;
  p.step_s = 0.01, p.samples = kSamples, p.period_s = 1, p.top_Hz = 2;
  p.force = {Vec(kSamples)}, p.guess.resize(2);
  for (Index k = 0; k < kSamples; ++k) p.force[0][k] = 8 * std::sin(0.055 * static_cast<double>(k));
  p.guess[0] = {true, Vec::Zero(kSamples), Vec::Zero(kSamples), Vec::Zero(kSamples)};
  p.traces.push_back({0, 0, "displacement_1_m", Vec::Zero(kSamples)});
  const std::vector<Prepared> records{p};
  Evaluator evaluator(system, model, records), fresh(system, model, records);
  for (size_t lane = 0; lane < lanes(); ++lane)
    for (const Index from : {Index{0}, Index{150}, Index{40}}) {
      Window w;
      w.from = from, w.length = 200, w.state = Vec::Zero(2);
      WindowRun first, other;
      ASSERT_TRUE(fresh.run(w, true, false, first));
      ASSERT_TRUE(evaluator.run(w, true, false, other, lane));
      EXPECT_GT(first.residual.cwiseAbs().maxCoeff(), 0.05) << "it moves";
      EXPECT_EQ(first.residual, other.residual);
      EXPECT_EQ(first.slopes, other.slopes);
    }
}

}  // namespace
