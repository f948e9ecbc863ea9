// Rigs for the readers' tests, and what a refused file says.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/records/files/data_file_error.hpp"

namespace test_rigs {

// `masses` and then `discs`; every DOF has a damper to ground.
inline rig_file::RigModel dampers(int masses, int discs = 0, const std::string& more = "") {
  std::string text = "schema = \"rig/1\"\nname = \"dampers\"\n";
  for (int i = 0; i < masses; ++i) text += "[[dof]]\nmass_kg = 1\n";
  for (int i = 0; i < discs; ++i) text += "[[dof]]\ninertia_kg_m2 = 1\n";
  for (int i = 1; i <= masses; ++i)
    text += "[[link]]\nbetween = [" + std::to_string(i) + ", 0]\nviscous_N_s_m = \"estimate\"\n";
  for (int i = masses + 1; i <= masses + discs; ++i)
    text += "[[link]]\nbetween = [" + std::to_string(i) + ", 0]\nviscous_N_m_s_rad = \"estimate\"\n";
  return rig_file::parse_rig(text + more, "rig.toml");
}

// The message with which a call refuses its file.
template <typename Call>
std::string refusal(Call call) {
  try {
    call();
  } catch (const host_sim::DataFileError& error) {
    return error.what();
  }
  return "nothing was refused";
}

inline void expect_says(const std::string& message, const std::string& part) {
  EXPECT_NE(message.find(part), std::string::npos) << "\"" << message << "\" does not say \"" << part << "\"";
}

}  // namespace test_rigs
