// documentation_figures DOCS_DIR: the figures of docs/estimation.md, DOCS_DIR/pictures/energy.svg and instrument.svg.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <exception>
#include <random>

#include "hal/rig_file/toml/rig_reader.hpp"
#include "host_sim/plant/motion/simulate.hpp"
#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/figures/plot.hpp"

namespace {

using namespace host_sim;
using reports::Curve;
using reports::Plot;
using reports::Role;
using reports::Shape;
using Values = std::vector<double>;

constexpr double kMass_kg = 2.0, kStiffness_N_m = 800.0, kViscous_N_s_m = 4.0, kCoulomb_N = 2.0, kPeriod_s = 1e-3;

// A mass on a spring with both kinds of friction, driven near its natural frequency: from rest, 1 kHz.
Record driven_mass(size_t samples) {
  const rig_file::RigModel rig = rig_file::parse_rig(
      "schema = \"rig/1\"\nname = \"r\"\n[[dof]]\nmass_kg = 2.0\n[[link]]\nbetween = [1, 0]\nstiffness_N_m = 800.0\n"
      "viscous_N_s_m = 4.0\ncoulomb_N = 2.0\n",
      "rig.toml");
  Excitation excitation;
  excitation.force_N = {random_band({12.0, 1.0, 8.0}, 0.0, static_cast<double>(samples) * kPeriod_s, kPeriod_s, 1, 1)};
  return simulate(rig, {}, excitation, SampleTimes{kPeriod_s, 0, 0, samples, 0.0});
}

const Values& channel(const Record& record, Quantity quantity) { return record.find(quantity, 1)->values; }

// Integral of a product from the start to each sample, trapezoids.
Values integral(const Values& a, const Values& b, double factor) {
  Values out(a.size(), 0.0);
  for (size_t i = 1; i < a.size(); ++i)
    out[i] = out[i - 1] + factor * 0.5 * kPeriod_s * (a[i - 1] * b[i - 1] + a[i] * b[i]);
  return out;
}

Curve curve(const Values& x, const Values& y, const char* label, Role role, Shape shape = Shape::kLine) {
  Curve out;
  const size_t step = std::max<size_t>(1, x.size() / 500);  // as many points as a picture shows
  for (size_t i = 0; i < x.size(); i += step) out.x.push_back(x[i]), out.y.push_back(y[i]);
  out.label = label, out.role = role, out.shape = shape;
  return out;
}

Plot energy_figure() {
  const Record record = driven_mass(4000);
  const Values &x = channel(record, Quantity::kDisplacement), &v = channel(record, Quantity::kVelocity),
               &a = channel(record, Quantity::kAcceleration), &f = channel(record, Quantity::kForce);
  Values time_s, sign;
  for (size_t i = 0; i < v.size(); ++i) {
    time_s.push_back(static_cast<double>(i) * kPeriod_s);
    sign.push_back(v[i] > 0.0 ? 1.0 : v[i] < 0.0 ? -1.0 : 0.0);
  }
  Values stored = integral(a, v, kMass_kg);
  const Values spring = integral(x, v, kStiffness_N_m);
  for (size_t i = 0; i < stored.size(); ++i) stored[i] += spring[i];
  Plot plot;
  plot.title = "One mass, driven: where the work of the force goes";
  plot.x_label = "time", plot.x_unit = "s", plot.y_label = "energy since the start", plot.y_unit = "J";
  plot.zero_line = true;
  plot.curves = {curve(time_s, integral(f, v, 1.0), "work of the force", Role::kMeasured),
                 curve(time_s, stored, "stored in m and k: comes back", Role::kTerm2),
                 curve(time_s, integral(v, v, kViscous_N_s_m), "used up by c", Role::kTerm3),
                 curve(time_s, integral(sign, v, kCoulomb_N), "used up by F", Role::kTerm4)};
  return plot;
}

// c from one energy row, everything else known: (work - stored - friction) / integral of the multiplier times v. The
// multiplier is the noisy velocity itself, or its interpolation from four neighbours.
double estimated(const Values& z, const Values& noisy, const Record& record) {
  const Values &x = channel(record, Quantity::kDisplacement), &a = channel(record, Quantity::kAcceleration),
               &v = channel(record, Quantity::kVelocity), &f = channel(record, Quantity::kForce);
  double top = 0.0, bottom = 0.0;
  for (size_t i = 2; i + 2 < v.size(); ++i) {
    const double friction_N = v[i] > 0.0 ? kCoulomb_N : v[i] < 0.0 ? -kCoulomb_N : 0.0;
    top += z[i] * (f[i] - kMass_kg * a[i] - kStiffness_N_m * x[i] - friction_N);
    bottom += z[i] * noisy[i];
  }
  return top / bottom;
}

Plot instrument_figure() {
  const Record record = driven_mass(20000);
  const Values& v = channel(record, Quantity::kVelocity);
  double square = 0.0;
  for (double value : v) square += value * value / static_cast<double>(v.size());
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal;
  Values percent, plain, instrument;
  for (double noise = 0.0; noise <= 20.0; noise += 1.0) {
    constexpr int kDraws = 20;
    double sum_plain = 0.0, sum_instrument = 0.0;
    for (int draw = 0; draw < kDraws; ++draw) {
      Values noisy = v, z(v.size(), 0.0);
      for (double& value : noisy) value += 0.01 * noise * std::sqrt(square) * normal(random);
      for (size_t i = 2; i + 2 < v.size(); ++i)
        z[i] = (-noisy[i - 2] + 4.0 * noisy[i - 1] + 4.0 * noisy[i + 1] - noisy[i + 2]) / 6.0;
      sum_plain += estimated(noisy, noisy, record) / kDraws;
      sum_instrument += estimated(z, noisy, record) / kDraws;
    }
    percent.push_back(noise), plain.push_back(sum_plain), instrument.push_back(sum_instrument);
  }
  Plot plot;
  plot.title = "The damper that comes out, against the noise of the velocity (truth: 4 N s/m)";
  plot.x_label = "noise, rms", plot.x_unit = "%", plot.y_label = "viscous", plot.y_unit = "N s/m";
  plot.scale_units = false;
  plot.curves = {curve(percent, plain, "multiplied by the velocity itself", Role::kGiven),
                 curve(percent, instrument, "multiplied by its neighbours", Role::kExtended)};
  return plot;
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::fputs("documentation_figures DOCS_DIR\n", stderr);
    return 2;
  }
  try {
    const std::string folder = std::string(arguments[1]) + "/pictures/";
    write_output_file(folder + "energy.svg", draw(energy_figure(), reports::Target::kStandalone) + "\n");
    write_output_file(folder + "instrument.svg", draw(instrument_figure(), reports::Target::kStandalone) + "\n");
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
