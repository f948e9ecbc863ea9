// The rig as it really is, with what its rig file does not say. SI units; DOF and links count from 0.
#pragma once
#include <string>
#include <vector>

namespace hidden_rig {

using Values = std::vector<double>;  // one value per sample

constexpr int kToGround = -1, kToBase = -2;

struct TrueLink {
  int a = 0, b = kToGround;
  double k = 0, c = 0, F = 0, G = 0;  // N/m, N s/m, N, N m (restoring torque G sin(u))
  bool absent = false;                // carries only the hidden effect; the rig file does not have it
};

struct TrueEffect {
  std::string kind;     // the contract's word
  int link = -1;        // of an effect on a link
  int dof = -1;         // of an effect on a DOF or on the force that drives it
  std::string channel;  // of a fault of the measurement
  double strength = 0;  // coefficient in SI units: N/m^3, N, kg, s of delay, relative gain, ...
  double shape = 0;   // gap m, Stribeck velocity m/s, presliding length m, resonance Hz, pitch m, dead band N, tone Hz
  double shape2 = 0;  // resonance: damping ratio; presliding: sigma1 / sigma0 of LuGre's bristles s (0: Dahl)
  double phase = 0;   // cogging, hum: rad
};

struct TrueRig {
  bool rotating = false;
  std::vector<double> mass_kg;
  std::vector<TrueLink> links;
  std::vector<TrueEffect> effects;
};

double rms(const Values& values);
// "link 1-2", "link 3-base", "dof 2", "channel velocity_1_m_s"
std::string place(const TrueRig& rig, const TrueEffect& effect);

}  // namespace hidden_rig
