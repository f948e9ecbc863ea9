#include "host_sim/records/columns/units/unit_table.hpp"

#include <iterator>

namespace host_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGravity = 9.80665;        // m/s2, standard gravity (ISO 80000-3)
constexpr double kPound = 4.4482216152605;  // N, from 0.45359237 kg and standard gravity
constexpr double kInch = 0.0254, kFoot = 0.3048;

using D = Dimension;
constexpr UnitRow kRows[] = {
    {"N", D::kForce, 1.0},
    {"mN", D::kForce, 1e-3},
    {"kN", D::kForce, 1e3},
    {"MN", D::kForce, 1e6},
    {"daN", D::kForce, 10.0},
    {"Newton", D::kForce, 1.0},
    {"Newtons", D::kForce, 1.0},
    {"lbf", D::kForce, kPound},
    {"lb", D::kForce, kPound},
    {"lbs", D::kForce, kPound},
    {"pound", D::kForce, kPound},
    {"pounds", D::kForce, kPound},
    {"kip", D::kForce, 1e3 * kPound},
    {"kgf", D::kForce, kGravity},
    {"kp", D::kForce, kGravity},
    {"gf", D::kForce, 1e-3 * kGravity},
    {"m", D::kDisplacement, 1.0},
    {"meter", D::kDisplacement, 1.0},
    {"meters", D::kDisplacement, 1.0},
    {"cm", D::kDisplacement, 1e-2},
    {"mm", D::kDisplacement, 1e-3},
    {"um", D::kDisplacement, 1e-6},
    {"micron", D::kDisplacement, 1e-6},
    {"nm", D::kDisplacement, 1e-9},
    {"in", D::kDisplacement, kInch},
    {"inch", D::kDisplacement, kInch},
    {"inches", D::kDisplacement, kInch},
    {"mil", D::kDisplacement, 1e-3 * kInch},
    {"mils", D::kDisplacement, 1e-3 * kInch},
    {"ft", D::kDisplacement, kFoot},
    {"m/s", D::kVelocity, 1.0},
    {"cm/s", D::kVelocity, 1e-2},
    {"mm/s", D::kVelocity, 1e-3},
    {"um/s", D::kVelocity, 1e-6},
    {"in/s", D::kVelocity, kInch},
    {"ips", D::kVelocity, kInch},
    {"ms1", D::kVelocity, 1.0},  // m s^-1
    {"ft/s", D::kVelocity, kFoot},
    {"km/h", D::kVelocity, 1.0 / 3.6},
    {"m/s2", D::kAcceleration, 1.0},
    {"m/s/s", D::kAcceleration, 1.0},
    {"ms2", D::kAcceleration, 1.0},  // m s^-2
    {"cm/s2", D::kAcceleration, 1e-2},
    {"Gal", D::kAcceleration, 1e-2},
    {"mm/s2", D::kAcceleration, 1e-3},
    {"g", D::kAcceleration, kGravity},
    {"gn", D::kAcceleration, kGravity},
    {"mg", D::kAcceleration, 1e-3 * kGravity},
    {"in/s2", D::kAcceleration, kInch},
    {"ft/s2", D::kAcceleration, kFoot},
    {"Nm", D::kTorque, 1.0},
    {"mNm", D::kTorque, 1e-3},
    {"kNm", D::kTorque, 1e3},
    {"Ncm", D::kTorque, 1e-2},
    {"Nmm", D::kTorque, 1e-3},
    {"lbfin", D::kTorque, kPound* kInch},
    {"lbin", D::kTorque, kPound* kInch},
    {"inlb", D::kTorque, kPound* kInch},
    {"inlbf", D::kTorque, kPound* kInch},
    {"lbfft", D::kTorque, kPound* kFoot},
    {"lbft", D::kTorque, kPound* kFoot},
    {"ftlb", D::kTorque, kPound* kFoot},
    {"ftlbf", D::kTorque, kPound* kFoot},
    {"kgfcm", D::kTorque, 1e-2 * kGravity},
    {"rad", D::kAngle, 1.0},
    {"mrad", D::kAngle, 1e-3},
    {"urad", D::kAngle, 1e-6},
    {"deg", D::kAngle, kPi / 180.0},
    {"degree", D::kAngle, kPi / 180.0},
    {"degrees", D::kAngle, kPi / 180.0},
    {"rev", D::kAngle, 2.0 * kPi},
    {"turn", D::kAngle, 2.0 * kPi},
    {"rad/s", D::kAngularVelocity, 1.0},
    {"mrad/s", D::kAngularVelocity, 1e-3},
    {"deg/s", D::kAngularVelocity, kPi / 180.0},
    {"dps", D::kAngularVelocity, kPi / 180.0},
    {"rpm", D::kAngularVelocity, kPi / 30.0},
    {"rev/min", D::kAngularVelocity, kPi / 30.0},
    {"r/min", D::kAngularVelocity, kPi / 30.0},
    {"1/min", D::kAngularVelocity, kPi / 30.0},
    {"U/min", D::kAngularVelocity, kPi / 30.0},
    {"min1", D::kAngularVelocity, kPi / 30.0},  // min^-1
    {"rev/s", D::kAngularVelocity, 2.0 * kPi},
    {"rad/s2", D::kAngularAcceleration, 1.0},
    {"rad/s/s", D::kAngularAcceleration, 1.0},
    {"deg/s2", D::kAngularAcceleration, kPi / 180.0},
    {"rev/s2", D::kAngularAcceleration, 2.0 * kPi},
    {"s", D::kTime, 1.0},
    {"sec", D::kTime, 1.0},
    {"second", D::kTime, 1.0},
    {"seconds", D::kTime, 1.0},
    {"ms", D::kTime, 1e-3},
    {"msec", D::kTime, 1e-3},
    {"us", D::kTime, 1e-6},
    {"ns", D::kTime, 1e-9},
    {"min", D::kTime, 60.0},
    {"h", D::kTime, 3600.0},
    {"V", D::kVoltage, 1.0},
    {"volt", D::kVoltage, 1.0},
    {"volts", D::kVoltage, 1.0},
    {"mV", D::kVoltage, 1e-3},
    {"uV", D::kVoltage, 1e-6},
};

}  // namespace

UnitRows unit_rows() { return {std::begin(kRows), std::end(kRows)}; }

}  // namespace host_sim
