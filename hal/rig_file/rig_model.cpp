#include "hal/rig_file/rig_model.hpp"

namespace rig_file {

std::string link_label(const Link& link) {
  return std::to_string(link.a) + "-" + (link.b == kBase ? "base" : std::to_string(link.b));
}

bool link_rotates(const RigModel& model, const Link& link) {
  const int dof = link.a > 0 ? link.a : link.b;
  return dof > 0 && dof <= static_cast<int>(model.dofs.size()) && model.dofs[static_cast<size_t>(dof - 1)].rotating;
}

}  // namespace rig_file
