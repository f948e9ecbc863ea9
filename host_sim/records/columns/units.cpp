#include "host_sim/records/columns/units.hpp"

#include <charconv>
#include <cmath>

namespace host_sim {
namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kGravity = 9.80665;        // m/s2, standard gravity (ISO 80000-3)
constexpr double kPound = 4.4482216152605;  // N, from 0.45359237 kg and standard gravity
constexpr double kInch = 0.0254, kFoot = 0.3048;

struct Row {
  const char* word;  // blanks, "*", "-" and "^" left out
  Dimension dimension;
  double to_si;
};
using D = Dimension;
// The first spelling of a unit is its SI form or the usual one.
constexpr Row kRows[] = {
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

struct Spelling {
  const char* from;
  const char* to;
};
// Signs of UTF-8 and Latin-1, and what says nothing.
constexpr Spelling kSpellings[] = {{"\xC2\xB5", "u"},
                                   {"\xCE\xBC", "u"},
                                   {"\xC2\xB0", "deg"},
                                   {"\xC2\xB2", "2"},
                                   {"\xC2\xB7", ""},
                                   {"\xE2\x8B\x85", ""},
                                   {"\xE2\x81\xBB", ""},
                                   {"\xC2\xB9", "1"},
                                   {"\xB5", "u"},
                                   {"\xB0", "deg"},
                                   {"\xB2", "2"},
                                   {"\xB7", ""},
                                   {"**", ""},
                                   {" ", ""},
                                   {"*", ""},
                                   {"^", ""},
                                   {"-", ""},
                                   {".", ""},
                                   {"(", ""},
                                   {")", ""},
                                   {"[", ""},
                                   {"]", ""},
                                   {"{", ""},
                                   {"}", ""},
                                   {"\"", ""},
                                   {"\t", ""},
                                   {"_", ""}};

std::string normalised(std::string_view text) {
  std::string out(text.substr(0, 40));
  for (const Spelling& spelling : kSpellings)
    for (size_t at = out.find(spelling.from); at != std::string::npos; at = out.find(spelling.from, at))
      out.replace(at, std::char_traits<char>::length(spelling.from), spelling.to);
  return out;
}

bool same(std::string_view a, std::string_view b, bool with_case) {
  if (a.size() != b.size()) return false;
  for (size_t i = 0; i < a.size(); ++i) {
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; };
    if (with_case ? a[i] != b[i] : lower(a[i]) != lower(b[i])) return false;
  }
  return true;
}

// The one row that reads so; in other case only where that leaves one meaning.
std::optional<Unit> row_of(const std::string& word, std::optional<Dimension> expected) {
  const Row* found = nullptr;
  for (const bool with_case : {true, false}) {
    for (const Row& row : kRows) {
      if (!same(word, row.word, with_case) || (expected && row.dimension != *expected)) continue;
      if (found != nullptr && found->to_si != row.to_si) return std::nullopt;
      found = &row;
    }
    if (found != nullptr) return Unit{found->word, found->dimension, found->to_si};
  }
  return std::nullopt;
}

}  // namespace

Dimension dimension_of(firmware::Quantity quantity, bool rotating) {
  return static_cast<Dimension>(static_cast<int>(quantity) + (rotating ? static_cast<int>(Dimension::kTorque) : 0));
}

const char* si_unit(Dimension dimension) {
  if (dimension == Dimension::kTorque) return "N m";
  for (const Row& row : kRows)
    if (row.dimension == dimension && row.to_si == 1.0) return row.word;
  return "";
}

std::optional<Unit> find_unit(std::string_view text, std::optional<Dimension> expected) {
  const std::string word = normalised(text);
  if (word.empty()) return std::nullopt;
  if (expected)
    if (const auto unit = row_of(word, expected)) return unit;
  return row_of(word, std::nullopt);
}

std::optional<Unit> find_scaled_unit(const std::string& text, Dimension expected) {
  if (const auto unit = find_unit(text, expected)) return unit;  // "1/min" is a unit
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  double count = 0.0;
  const auto [end, error] = std::from_chars(text.data() + first, text.data() + text.size(), count);
  if (error != std::errc() || !std::isfinite(count) || count == 0.0) return std::nullopt;
  auto unit = find_unit(std::string_view(end, static_cast<size_t>(text.data() + text.size() - end)), expected);
  if (!unit) return std::nullopt;
  unit->word = std::string(text.data() + first, end) + " " + unit->word;
  unit->to_si *= count;
  return unit;
}

std::optional<Unit> find_unit_suffix(std::string_view suffix, Dimension expected) {
  std::string word(suffix);
  for (char& c : word)
    if (c == '_') c = '/';
  if (const auto unit = find_unit(word, expected); unit && unit->dimension == expected) return unit;
  return find_unit(suffix, expected);
}

std::optional<Sensitivity> parse_sensitivity(const std::string& text) {
  const size_t first = text.find_first_not_of(' ');
  if (first == std::string::npos) return std::nullopt;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data() + first, text.data() + text.size(), value);
  if (error != std::errc() || !std::isfinite(value) || value == 0.0) return std::nullopt;
  const std::string_view rest(end, static_cast<size_t>(text.data() + text.size() - end));
  const size_t slash = rest.find('/');
  if (slash == std::string_view::npos) return std::nullopt;
  const auto volts = find_unit(rest.substr(0, slash), Dimension::kVoltage), per = find_unit(rest.substr(slash + 1));
  if (!volts || volts->dimension != Dimension::kVoltage || !per) return std::nullopt;
  if (per->dimension == Dimension::kTime || per->dimension == Dimension::kVoltage) return std::nullopt;
  return Sensitivity{per->dimension, value * volts->to_si / per->to_si};
}

}  // namespace host_sim
