// A rig file in memory, in SI units (docs/formats.md describes the file). Used by the board program and the simulator.
#pragma once
#include <map>
#include <string>
#include <vector>

namespace rig_file {

struct Coefficient {
  double value = 0.0;     // SI units, where known
  bool estimate = false;  // "estimate" in the file: unknown
};

constexpr int kGround = 0;
constexpr int kBase = -1;  // DOF numbers count from 1

// An extension term of a link or DOF; kind is the contract's word ("cubic_stiffness", ...).
struct Effect {
  std::string kind;
  Coefficient coefficient;
  std::map<std::string, double> shape;  // further keys with unit, e.g. {"gap_m", 1e-4}, {"stribeck_velocity_m_s", 0.01}
};

struct Dof {
  bool rotating = false;
  Coefficient mass_kg;  // inertia_kg_m2 where rotating
  std::vector<Effect> effects;
};

struct Link {
  int a = 0;  // DOF number from 1
  int b = 0;  // DOF number, kGround or kBase
  Coefficient stiffness_N_m, viscous_N_s_m, coulomb_N, gravity_torque_N_m;
  std::vector<Effect> effects;
};

// What is known of one sensor channel; a field left out of the file keeps its default.
struct ChannelEntry {
  std::string name;            // as in the data file: "force_1_N"
  double delay_us = 0.0;       // how late the channel is against the others
  double unit_per_code = 0.0;  // SI units per converter code; 0: chosen from the data
  int offset_code = 0;         // code at zero
  // The converter's rails, a code at or beyond them is a saturated sensor; equal: not told.
  int lowest_code = 0;
  int highest_code = 0;
  std::string column;           // of the data file that holds the channel: "Chan 3"; empty: the channel's name
  std::string unit;             // that column is in: "g"; empty: what the file says
  std::string sensitivity;      // of a sensor whose column is a voltage: "100 mV/g"
  double ac_coupling_Hz = 0.0;  // corner of the first-order high-pass that the channel has passed; 0: none
};

struct RigModel {
  std::string file;  // where it was read from, for messages
  std::string name;
  std::vector<Dof> dofs;
  std::vector<Link> links;
  std::vector<ChannelEntry> channels;
};

// "1-0", "1-2", "2-base"
std::string link_label(const Link& link);
// Does the link turn (torque against angle)? It does where its DOFs rotate.
bool link_rotates(const RigModel& model, const Link& link);

}  // namespace rig_file
