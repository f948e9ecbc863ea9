// Channels of one DOF beside each other: displacement, velocity and acceleration of one motion must agree, whatever the
// rig is.
//
// Over a span of 2h samples the change of a displacement is the integral of the velocity, and so on:
//   (x[i+h] - x[i-h]) / (2 h T)          = mean of v over the span
//   (x[i+h] - 2 x[i] + x[i-h]) / (h T)^2 = mean of a over the span, weighted by a triangle
// Both sides are compared over the whole record at the span where they agree best.
#pragma once
#include <map>
#include <utility>
#include <vector>

#include "host_sim/data_check/data_check.hpp"

namespace host_sim::data_check {

// Running integrals of channels, once and twice, by trapezoids and in steps, means taken off: made when they are first asked for, as
// each channel is compared with many. The channels outlive this.
class Integrals {
 public:
  const std::vector<double>& of(const Channel& channel, bool twice);

 private:
  std::map<std::pair<const Channel*, bool>, std::vector<double>> made_;
};

struct Comparison {
  Quantity lower = Quantity::kDisplacement, upper = Quantity::kVelocity;  // upper: once or twice differentiated
  double correlation = 0.0;               // of both sides, at the span where its magnitude is largest
  double gain = 1.0;                      // upper over the derivative of lower, with its sign
  double late_s = 0.0, late_std_s = 0.0;  // upper behind lower
  bool turned = false;                    // the correlation is negative for every delay of up to 3 samples
  double independent = 0.0;               // about how many independent spans stand behind it
};

// Nothing where the record is too short to say (less than 30 independent spans).
std::optional<Comparison> compare(const Channel& lower, const Channel& upper, double sample_period_s,
                                  Integrals& integrals);

// The magnitude of that correlation alone; 0 where the record is too short to say.
double agreement(const Channel& lower, const Channel& upper, double sample_period_s, Integrals& integrals);

// Polarity, unit and lateness of the channels of one DOF (or of the base); lateness beyond what the rig file states. model: nothing
// where there is no rig file.
std::vector<Finding> check_kinematics(const Record& record, int dof, bool rotating, const rig_file::RigModel* model,
                                      Integrals& integrals);

}  // namespace host_sim::data_check
