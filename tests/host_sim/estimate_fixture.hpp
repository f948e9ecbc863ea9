// What the tests of estimate share: data whose answer is known by hand, m = 2 kg, k = 800 N/m, c = 1.5 N s/m, free decay.
#pragma once
#include <string>

#include "tests/host_sim/program_test.hpp"

namespace estimate_test {

constexpr const char* kRig =
    "schema = \"rig/1\"\nname = \"oscillator\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\n"
    "stiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n";

// x = e^-dt cos(w t) with d = c / 2m, w = sqrt(k/m - d^2); late_s shifts the displacement.
std::string free_decay(int samples, double late_s = 0.0);

// In a folder with that rig and 4 s of its decay.
class Estimate : public test_support::ProgramTest {
 protected:
  void SetUp() override {
    workspace_.write("rig.toml", kRig);
    workspace_.write("data.csv", free_decay(4000));
  }
};

}  // namespace estimate_test
