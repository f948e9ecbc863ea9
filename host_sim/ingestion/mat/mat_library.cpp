#include "host_sim/ingestion/mat/mat_library.hpp"

#include <dlfcn.h>

#include <optional>

namespace host_sim {
namespace {

// False where the library lacks it.
template <typename Function>
bool find(void* library, const char* name, Function& function) {
  function = reinterpret_cast<Function>(dlsym(library, name));
  return function != nullptr;
}

std::optional<MatLibrary> load() {
  void* const library = dlopen(HOST_SIM_MATIO, RTLD_NOW | RTLD_LOCAL);  // stays until the program ends
  if (library == nullptr) return std::nullopt;
  MatLibrary mat;
  const bool complete =
      find(library, "Mat_LogInitFunc", mat.log_to) && find(library, "Mat_Open", mat.open) &&
      find(library, "Mat_CreateVer", mat.create) && find(library, "Mat_Close", mat.close) &&
      find(library, "Mat_VarReadNext", mat.read_next) && find(library, "Mat_VarGetNumberOfFields", mat.field_count) &&
      find(library, "Mat_VarGetStructFieldnames", mat.field_names) &&
      find(library, "Mat_VarGetStructFieldByIndex", mat.field) && find(library, "Mat_VarCreate", mat.make_variable) &&
      find(library, "Mat_VarSetCell", mat.set_cell) && find(library, "Mat_VarWrite", mat.write) &&
      find(library, "Mat_VarFree", mat.free);
  find(library, "uncompress", mat.unpack);
  return complete ? std::optional<MatLibrary>(mat) : std::nullopt;
}

}  // namespace

const char* const kNoMatLibrary = "MAT files need " HOST_SIM_MATIO ", which cannot be loaded on this machine";

const MatLibrary* mat_library() {
  static const std::optional<MatLibrary> loaded = load();
  return loaded ? &*loaded : nullptr;
}

}  // namespace host_sim
