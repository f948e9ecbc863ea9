// Renews the tables of effects in the documentation: vocabulary_page docs/formats.md docs/effects.md
#include <fstream>
#include <iostream>
#include <sstream>

#include "host_sim/vocabulary/effects_page.hpp"

int main(int argc, char** argv) {
  if (argc < 2) {
    std::cerr << "usage: vocabulary_page PAGE.md [...]\n";
    return 2;
  }
  for (int i = 1; i < argc; ++i) {
    std::ostringstream page;
    page << std::ifstream(argv[i]).rdbuf();
    const std::string renewed = vocabulary::renewed_page(page.str());
    if (renewed.empty()) {
      std::cerr << argv[i] << ": expected a page with the marker lines of a generated table\n";
      return 2;
    }
    std::ofstream output(argv[i], std::ios::trunc);
    output << renewed;
    if (!output.flush()) return 1;
  }
  return 0;
}
