#include "host_sim/reports/data/channel_words.hpp"

#include "hal/rig_file/channel_name.hpp"

namespace host_sim::reports {
namespace {

struct Words {
  const char* word;
  const char* unit;
};
// In the order of Quantity.
constexpr Words kTranslating[] = {
    {"force", "N"}, {"displacement", "m"}, {"velocity", "m/s"}, {"acceleration", "m/s^2"}};
constexpr Words kRotating[] = {
    {"torque", "N m"}, {"angle", "rad"}, {"angular velocity", "rad/s"}, {"angular acceleration", "rad/s^2"}};

const Words& words(Quantity quantity, bool rotating) {
  return (rotating ? kRotating : kTranslating)[static_cast<int>(quantity)];
}

}  // namespace

std::string quantity_word(Quantity quantity, bool rotating) { return words(quantity, rotating).word; }

std::string quantity_unit(Quantity quantity, bool rotating) { return words(quantity, rotating).unit; }

bool channel_rotates(const Channel& channel) {
  const auto name = rig_file::parse_channel_name(channel.name);
  return name && name->rotating;
}

std::string channel_words(const Channel& channel) {
  return quantity_word(channel.quantity, channel_rotates(channel)) + " of " +
         (channel.dof == rig_file::kBase ? std::string("the base") : "DOF " + std::to_string(channel.dof));
}

}  // namespace host_sim::reports
