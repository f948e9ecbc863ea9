// Short texts in files, as sysfs has them.
#pragma once
#include <string>

namespace hal {

// The content without its last newline; empty where the file cannot be read.
std::string read_text(const std::string& path);
// False where the file cannot be written or the kernel refuses the value.
bool write_text(const std::string& path, const std::string& text);
bool file_exists(const std::string& path);

}  // namespace hal
