// What a file's name says of its kind.
#pragma once
#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>

namespace host_sim {

// extension: ".uff", in small letters; the name may have any.
inline bool has_extension(const std::string& path, std::string_view extension) {
  const auto alike = [](char a, char b) { return a == std::tolower(static_cast<unsigned char>(b)); };
  return path.size() > extension.size() && std::equal(extension.rbegin(), extension.rend(), path.rbegin(), alike);
}

}  // namespace host_sim
