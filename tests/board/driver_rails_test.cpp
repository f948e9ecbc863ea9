// Where converters saturate, as their drivers tell it.
#include "hal/linux/board/driver_rails.hpp"

#include <gtest/gtest.h>

#include "hal/rig_file/compile_rig.hpp"
#include "hal/rig_file/scaled_double.hpp"
#include "hal/rig_file/toml/rig_reader.hpp"

namespace {

using firmware::Quantity;

// A 12-bit converter whose file says no rails: planned for 24 bits its velocity, behind a high-pass, has the steps of its own codes; the
// driver's word tells its width, and there is room for finer ones.
TEST(DriverRails, PlanTheSignalsAnew) {
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\n[[dof]]\nmass_kg = 1.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 100.0\n"
      "viscous_N_s_m = \"estimate\"\n",
      "rig.toml");
  rig_file::ChannelCalibration force, velocity;
  force.quantity = Quantity::kForce, force.unit_per_code = 0.01;
  velocity.quantity = Quantity::kVelocity, velocity.unit_per_code = 0.001;
  firmware::CoreConfiguration core = rig_file::compile_rig(rig, 1e-3, {force, velocity});
  const std::vector<hal::IioChannel> channels = {{"in_voltage0", 0, Quantity::kForce, false},
                                                 {"in_voltage1", 0, Quantity::kVelocity, false}};
  const auto velocity_step = [&] { return rig_file::to_double(core.signals[0][2].unit_per_code); };
  EXPECT_EQ(velocity_step(), rig_file::to_double(core.channels[0][2].unit_per_code));
  const double displacement_step = rig_file::to_double(core.signals[0][1].unit_per_code);
  const auto twelve_bits = [](const hal::IioChannel&) { return hal::CodeRange{-2048, 2047}; };
  EXPECT_EQ(board::take_driver_rails(channels, twelve_bits, core), "");
  EXPECT_LT(velocity_step(), 1e-3) << "finer than its own code";
  EXPECT_LT(rig_file::to_double(core.signals[0][1].unit_per_code), 1e-3 * displacement_step);
  EXPECT_EQ(core.channels[0][2].highest_code, 2047);
  const auto far_off = [](const hal::IioChannel&) { return hal::CodeRange{0, 1 << 24}; };
  EXPECT_NE(board::take_driver_rails(channels, far_off, core).find("in_voltage0"), std::string::npos);
}

TEST(DriverRails, AConverterOfMoreThan24BitsIsTold) {
  const std::vector<hal::IioChannel> channels = {{"in_voltage0", 0, Quantity::kForce, true},
                                                 {"in_voltage1", 0, Quantity::kVelocity, false},
                                                 {"in_voltage2", 1, Quantity::kVelocity, false}};
  const auto range = [](const hal::IioChannel& channel) -> std::optional<hal::CodeRange> {
    if (channel.node == 1) return std::nullopt;
    hal::ScanType type;
    type.is_signed = true;
    type.bits = channel.element == "in_voltage0" ? 32 : 24;
    return hal::code_range(type);
  };
  EXPECT_EQ(
      board::wide_words(channels, range),
      "in_voltage0 has 32 bits, a code is their upper 24: its unit_per_code is of 2^8 of the converter's own steps\n");
}

}  // namespace
