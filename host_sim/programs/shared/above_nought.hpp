// An option's value that has to be a number above 0; the library's own check prints the largest number there is.
#pragma once
#include <CLI/CLI.hpp>
#include <cmath>
#include <string>

namespace host_sim {

inline CLI::Validator above_nought() {
  return CLI::Validator(
      [](const std::string& text) {
        double number = 0.0;
        const bool is_number = CLI::detail::lexical_cast(text, number);
        return is_number && number > 0.0 && std::isfinite(number) ? std::string()
                                                                  : "is \"" + text + "\", expected a number above 0";
      },
      "POSITIVE");
}

}  // namespace host_sim
