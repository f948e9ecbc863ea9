// What the board takes out of a channel by itself: delays and gains among the three channels of a DOF.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "draw.hpp"
#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "host_sim/records/digitise.hpp"
#include "verdict_counts.hpp"

namespace {

using firmware::EstimateStatus;
using firmware::EstimatorCore;
using hidden_rig::Draw;
using hidden_rig::Settings;
using rig_file::to_double;

constexpr uint32_t kWindow = 1000;  // samples, as a board at 1 kHz

// A board's core, asked once a window and at the end.
class Board {
 public:
  explicit Board(const Draw& draw, bool corrects = true) {
    calibrations_ = host_sim::calibrate(draw.records, draw.rig);
    configuration_ = rig_file::compile_rig(draw.rig, draw.records.front().sample_period_s, calibrations_);
    configuration_.corrects_channels = corrects;
    core_ = std::make_unique<EstimatorCore>(configuration_);
  }
  void measure(const Draw& draw) {
    host_sim::RecordSampleSource source(draw.records.front(), calibrations_);
    firmware::RawSample sample;
    core_->begin_level();
    for (uint32_t n = 1; source.read(sample) == hal::SampleResult::kSample; ++n) {
      sample.sequence = sequence_++;
      core_->push(sample);
      if (n % kWindow == 0) core_->solve();
    }
    core_->end_level();
    core_->solve();
  }
  EstimatorCore& core() { return *core_; }
  const firmware::Estimates& estimates() const { return core_->estimates(); }
  const firmware::Warrant& warrant() const { return estimates().warrant; }
  bool all_valid() const {
    return std::all_of(estimates().parameters, estimates().parameters + estimates().unknown_count,
                       [](const auto& p) { return p.status == EstimateStatus::kValid; });
  }

 private:
  std::vector<rig_file::ChannelCalibration> calibrations_;
  firmware::CoreConfiguration configuration_;
  std::unique_ptr<EstimatorCore> core_;
  uint32_t sequence_ = 0;
};

// The worst coefficient's error beyond two of its deviations, as a share of the truth.
double worst_beyond_scatter(const Draw& draw, const firmware::Estimates& estimates) {
  double worst = 0;
  for (int k = 0; k < estimates.unknown_count; ++k) {
    const double truth = draw.coefficients[static_cast<size_t>(k)].value;
    const double off = std::abs(to_double(estimates.parameters[k].value) - truth);
    worst = std::max(worst, (off - 2 * to_double(estimates.parameters[k].std)) / std::abs(truth));
  }
  return worst;
}

Draw rig_of_two(uint64_t seed, const std::string& sensors = "xva") {
  Settings settings;
  settings.masses = 2;
  settings.sensors = sensors;
  return hidden_rig::make_draw(seed, settings);
}

host_sim::Channel& channel_of(Draw& draw, int dof, host_sim::Quantity quantity) {
  for (host_sim::Channel& channel : draw.records.front().channels)
    if (channel.dof == dof && channel.quantity == quantity) return channel;
  throw std::runtime_error("no such channel");
}

// One sample late: exact, whatever the noise.
void make_late(host_sim::Channel& channel) {
  std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
}

TEST(BoardsCorrection, ALateChannelIsTakenOutAndSaid) {
  for (const host_sim::Quantity quantity :
       {host_sim::Quantity::kDisplacement, host_sim::Quantity::kVelocity, host_sim::Quantity::kAcceleration}) {
    Draw draw = rig_of_two(9410);
    make_late(channel_of(draw, 2, quantity));
    Board as_told(draw, false), board(draw);
    as_told.measure(draw);
    board.measure(draw);
    EXPECT_FALSE(as_told.all_valid());
    EXPECT_FALSE(as_told.warrant().corrected);
    EXPECT_TRUE(board.warrant().corrected);
    EXPECT_EQ(board.warrant().named.cause, firmware::cause_of(firmware::EffectKind::kSensorDelay));
    EXPECT_EQ(board.warrant().named.node_a, 1);
    EXPECT_EQ(static_cast<int>(board.warrant().named.quantity), static_cast<int>(quantity));
    EXPECT_NEAR(to_double(board.warrant().named.size), 1e-3, 5e-5);
    EXPECT_TRUE(board.all_valid());
    EXPECT_LT(worst_beyond_scatter(draw, board.estimates()), 0.02);
  }
}

// Delays of a fraction of a sample and gains as the generator draws them, 1 % noise.
TEST(BoardsCorrection, WhatIsCorrectedIsRight) {
  int corrected = 0, faults = 0;
  for (const char* fault : {"sensor_delay", "sensor_gain"})
    for (uint64_t seed = 9420; seed < 9430; ++seed) {
      Settings settings;
      settings.hidden = fault;
      const Draw draw = hidden_rig::make_draw(seed, settings);
      Board board(draw);
      board.measure(draw);
      EXPECT_EQ(warrant_test::valid_and_wrong(draw, board.estimates()), 0) << fault << seed;
      if (draw.hidden.front().where.find("force") == std::string::npos) ++faults;
      if (!board.warrant().corrected) continue;
      ++corrected;
      EXPECT_LT(worst_beyond_scatter(draw, board.estimates()), 0.02) << fault << seed;
      EXPECT_NEAR(to_double(board.warrant().named.size), draw.hidden.front().strength,
                  0.2 * std::abs(draw.hidden.front().strength))
          << fault << seed;
    }
  EXPECT_GE(corrected, faults * 3 / 4);
  EXPECT_GT(faults, 8);
}

// The marks: a channel 400 us late, or 5 % too large, named, taken out, and the worst coefficient within 2 % then. All three channels of
// a DOF are asked for; a force has no second witness on the board.
TEST(BoardsCorrection, FourHundredMicrosecondsAndFivePercent) {
  struct Mark {
    const char* fault;
    double size, tolerance;
  };
  for (const Mark& mark : {Mark{"sensor_delay", 400e-6, 20e-6}, Mark{"sensor_gain", 0.05, 0.005}}) {
    int channels = 0;
    for (uint64_t seed = 9450; seed < 9456; ++seed) {
      Settings settings;
      settings.hidden = mark.fault;
      settings.fault = mark.size;
      const Draw draw = hidden_rig::make_draw(seed, settings);
      if (draw.hidden.front().where.find("force") != std::string::npos) continue;
      ++channels;
      Board board(draw);
      board.measure(draw);
      EXPECT_TRUE(board.warrant().corrected) << mark.fault << seed;
      EXPECT_NEAR(to_double(board.warrant().named.size), mark.size, mark.tolerance) << mark.fault << seed;
      EXPECT_LT(worst_beyond_scatter(draw, board.estimates()), 0.02) << mark.fault << seed;
    }
    EXPECT_GE(channels, 3) << mark.fault;
  }
}

// Of two channels that contradict each other nobody knows which is late; a force has no second witness.
TEST(BoardsCorrection, WithoutAThirdChannelNothingIsCorrected) {
  Draw draw = rig_of_two(9440, "xv");
  make_late(channel_of(draw, 2, host_sim::Quantity::kDisplacement));
  Board two(draw);
  two.measure(draw);
  EXPECT_FALSE(two.warrant().corrected);
  EXPECT_FALSE(two.all_valid());
  draw = rig_of_two(9441);
  make_late(channel_of(draw, 1, host_sim::Quantity::kForce));
  Board force(draw);
  force.measure(draw);
  EXPECT_FALSE(force.warrant().corrected);
  EXPECT_FALSE(force.all_valid());
}

// An acceleration that jumps with every sample of a held force is not late: the equation beside that force is exact. Sampled before the
// jump: Replay.AForceThatIsSampledBeforeItsJumpIsNoLateAcceleration.
TEST(BoardsCorrection, AHeldForceMakesNoAccelerationLate) {
  for (uint64_t seed = 9450; seed < 9454; ++seed) {
    Settings settings;
    settings.hidden = "force_hold";
    const Draw draw = hidden_rig::make_draw(seed, settings);
    Board board(draw);
    board.measure(draw);
    EXPECT_FALSE(board.warrant().corrected) << seed;
  }
}

// A channel turned over is a slip for a person to look at.
TEST(BoardsCorrection, ASlipIsNotCorrected) {
  Draw draw = rig_of_two(9442);
  for (double& value : channel_of(draw, 1, host_sim::Quantity::kVelocity).values) value = -value;
  Board board(draw);
  board.measure(draw);
  EXPECT_FALSE(board.warrant().corrected);
  EXPECT_EQ(board.warrant().named.cause, firmware::Cause::kPolarity);
  EXPECT_FALSE(board.all_valid());
}

// The bits of a rig without a fault do not know that a fault would be taken out; a reset forgets what was.
TEST(BoardsCorrection, ARightRigIsLeftAsItIsAndAResetForgets) {
  const Draw right = rig_of_two(9443);
  Board as_told(right, false), board(right);
  as_told.measure(right);
  board.measure(right);
  EXPECT_FALSE(board.warrant().corrected);
  for (int k = 0; k < board.estimates().unknown_count; ++k)
    EXPECT_EQ(board.estimates().parameters[k].value, as_told.estimates().parameters[k].value);
  Draw late = right;
  make_late(channel_of(late, 1, host_sim::Quantity::kAcceleration));
  board.core().reset();
  board.measure(late);
  EXPECT_TRUE(board.warrant().corrected);
  board.core().reset();
  board.measure(right);
  EXPECT_FALSE(board.warrant().corrected);
  EXPECT_EQ(board.estimates().parameters[0].value, as_told.estimates().parameters[0].value);
}

}  // namespace
