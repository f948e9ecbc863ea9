// A channel that is late or has another gain is corrected by `host_sim estimate`, and it is said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "host_sim/programs/estimate/estimation.hpp"
#include "tests/hidden_rig/draw.hpp"

namespace {

hidden_rig::Draw two_masses(uint64_t seed) {
  hidden_rig::Settings settings;
  settings.masses = 2;
  return hidden_rig::make_draw(seed, settings);
}

void delay_by_one_sample(host_sim::Record& record, const std::string& name) {
  for (host_sim::Channel& channel : record.channels)
    if (channel.name == name)
      std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
}

bool scale(host_sim::Record& record, const std::string& name, double gain) {
  for (host_sim::Channel& channel : record.channels) {
    if (channel.name != name) continue;
    for (double& value : channel.values) value *= gain;
    return true;
  }
  return false;
}

bool said(const host_sim::Estimation& estimation, const std::string& text) {
  return std::any_of(estimation.result.notes.begin(), estimation.result.notes.end(),
                     [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

// One sample at 1 kHz: 1000 us. Left alone it adds k tau, 4 to 30 N s/m, to a damper of 8 to 40.
TEST(ChannelCorrection, TakesALateDisplacementOut) {
  for (uint64_t seed = 6000; seed < 6003; ++seed) {
    hidden_rig::Draw draw = two_masses(seed);
    delay_by_one_sample(draw.records[0], "displacement_2_m");
    const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
    EXPECT_TRUE(said(estimation, "displacement_2_m was ")) << seed;
    EXPECT_TRUE(said(estimation, " us late against the other channels of its DOF")) << seed;
    for (size_t k = 0; k < draw.coefficients.size(); ++k) {
      const host_sim::ParameterResult& p = estimation.result.parameters[k];
      EXPECT_NEAR(p.value, draw.coefficients[k].value, 0.02 * draw.coefficients[k].value + 4 * p.std)
          << seed << " " << p.info.name;
    }
  }
}

TEST(ChannelCorrection, SaysNothingWhereNothingIsLate) {
  for (uint64_t seed = 6000; seed < 6003; ++seed) {
    const hidden_rig::Draw draw = two_masses(seed);
    EXPECT_FALSE(said(host_sim::estimate_records(draw.rig, draw.records, {}), "corrected")) << seed;
  }
}

// Displacement and acceleration late by the same time against the velocity: it is the velocity that is early... or, here, late.
TEST(ChannelCorrection, BlamesTheVelocityWhereTheOtherTwoAgree) {
  hidden_rig::Draw draw = two_masses(6001);
  delay_by_one_sample(draw.records[0], "velocity_1_m_s");
  const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
  EXPECT_TRUE(said(estimation, "velocity_1_m_s was "));
}

// Every channel of the first mass and the force, 5 % off either way, 1 % noise: each is named, the gain is right within 0.3 % and
// the worst coefficient within 2 % and its noise. Left alone a velocity bends its damper by 5 %, a force every damper by more.
TEST(ChannelCorrection, TakesAGainOut) {
  for (const std::string name : {"displacement_1_m", "velocity_1_m_s", "acceleration_1_m_s2", "force_1_N"})
    for (const double gain : {1.05, 0.95}) {
      hidden_rig::Draw draw = two_masses(6000);
      host_sim::Record& record = draw.records[0];
      if (!scale(record, name, gain)) continue;
      const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
      const auto note = std::find_if(estimation.result.notes.begin(), estimation.result.notes.end(),
                                     [&](const std::string& text) { return text.rfind(name, 0) == 0; });
      ASSERT_NE(note, estimation.result.notes.end()) << name << " " << gain;
      double said_gain = 0;
      ASSERT_EQ(std::sscanf(note->c_str() + std::string(name).size(), " said %lf times", &said_gain), 1) << *note;
      EXPECT_NEAR(said_gain, gain, 0.003) << name;
      for (size_t k = 0; k < draw.coefficients.size(); ++k) {
        const host_sim::ParameterResult& p = estimation.result.parameters[k];
        EXPECT_EQ(p.status, firmware::EstimateStatus::kValid) << name << " " << gain << " " << p.info.name;
        EXPECT_NEAR(p.value, draw.coefficients[k].value, 0.02 * draw.coefficients[k].value + 2 * p.std)
            << name << " " << gain << " " << p.info.name;
      }
    }
}

// Without velocities displacement and acceleration disagree, and the equations of motion say whose fault it is.
TEST(ChannelCorrection, OfDisplacementAndAccelerationTheRightOneIsCorrected) {
  for (const char* name : {"displacement_2_m", "acceleration_2_m_s2"})
    for (const bool late : {true, false}) {
      hidden_rig::Settings settings;
      settings.sensors = "xa";
      settings.masses = 2;
      hidden_rig::Draw draw = hidden_rig::make_draw(6020, settings);
      late ? delay_by_one_sample(draw.records[0], name) : static_cast<void>(scale(draw.records[0], name, 1.05));
      const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
      const host_sim::WarrantResult& warrant = estimation.result.warrant;
      ASSERT_EQ(warrant.corrected.size(), 1u) << name << late;
      EXPECT_EQ(warrant.corrected[0].where, std::string("channel ") + name) << late;
      EXPECT_NEAR(warrant.corrected[0].size, late ? 1e-3 : 0.05, late ? 3e-5 : 0.002) << name;
      for (size_t k = 0; k < draw.coefficients.size(); ++k) {
        const host_sim::ParameterResult& p = estimation.result.parameters[k];
        EXPECT_NEAR(p.value, draw.coefficients[k].value, 0.02 * draw.coefficients[k].value + 3 * p.std)
            << name << late << " " << p.info.name;
      }
    }
}

// A force that is one sample, 1000 us, late: no other channel of its DOF is, so the equations of motion are the witness.
TEST(ChannelCorrection, TakesALateForceOut) {
  for (uint64_t seed = 6000; seed < 6003; ++seed) {
    hidden_rig::Draw draw = two_masses(seed);
    for (host_sim::Channel& channel : draw.records[0].channels)
      if (channel.quantity == host_sim::Quantity::kForce)
        std::copy_backward(channel.values.begin(), channel.values.end() - 1, channel.values.end());
    const host_sim::Estimation estimation = host_sim::estimate_records(draw.rig, draw.records, {});
    EXPECT_TRUE(said(estimation, " us late against the rig's equations of motion")) << seed;
    for (size_t k = 0; k < draw.coefficients.size(); ++k) {
      const host_sim::ParameterResult& p = estimation.result.parameters[k];
      EXPECT_NEAR(p.value, draw.coefficients[k].value, 0.02 * draw.coefficients[k].value + 3 * p.std) << seed;
    }
  }
}

// What is wrong with the rig file is no matter of a channel; a sensor turned over is for a person to look at.
TEST(ChannelCorrection, LeavesOtherCausesAlone) {
  for (const char* hidden :
       {"quadratic_damping", "cubic_stiffness", "missing_viscous", "mass_error", "drive_dead_band", "polarity"}) {
    hidden_rig::Settings settings;
    settings.hidden = hidden;
    settings.masses = 3;
    settings.rho_low = 0.3;
    const hidden_rig::Draw draw = hidden_rig::make_draw(6010, settings);
    EXPECT_FALSE(said(host_sim::estimate_records(draw.rig, draw.records, {}), "corrected")) << hidden;
  }
}

}  // namespace
