// A chain of masses with one or two hidden effects, integrated sample by sample. Written for the tests alone:
// it shares no code with the simulator or the diagnosis that it judges.
#pragma once
#include <cstddef>
#include <string>
#include <vector>

namespace hidden {

struct TrueLink {
  int a = 0, b = -1;  // DOF from 0; -1 is the ground
  double k = 0, c = 0, F = 0;
  bool absent = false;  // carries only the hidden effect; the rig file does not have it
};

struct TrueEffect {
  std::string kind;     // the contract's word, or a word outside it ("cogging", ...)
  int link = -1;        // link effects
  int dof = -1;         // DOF effects
  double strength = 0;  // coefficient in SI units: N/m^3, N, kg, ...
  double shape =
      0;  // gap m, Stribeck velocity m/s, presliding length m, resonance Hz, pitch m, period s, drift's time constant s
  double shape2 = 0;  // resonance: damping ratio; presliding: sigma1 / sigma0 of LuGre's bristles s (0: Dahl)
};

struct TrueRig {
  std::vector<double> mass_kg;
  std::vector<TrueLink> links;
  std::vector<TrueEffect> effects;
};

struct Motion {  // one row per DOF or link, one value per sample
  std::vector<std::vector<double>> x, v, a;
  std::vector<std::vector<double>> damping_force;  // per link: c w + friction
  std::vector<std::vector<double>> hidden_force;   // per effect
};

// The force between its samples: as drawn; straight lines; held until the next sample.
enum class Drive { kSmooth, kLinear, kSteps };

// force on DOF 0, given at half substeps: sample s, stage j at [(s * substeps * 2) + j]; the first `skip` samples are
// simulated from rest and dropped.
Motion integrate(const TrueRig& rig, const std::vector<double>& force_half_steps, int substeps, size_t samples,
                 size_t skip, double sample_period_s, Drive drive = Drive::kSmooth);

}  // namespace hidden
