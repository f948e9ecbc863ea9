// Renews the generated tables of docs/can_protocol.md: can_protocol_page docs/can_protocol.md
#include <fstream>
#include <iostream>
#include <sstream>

#include "host_sim/can_log/protocol_page.hpp"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: can_protocol_page docs/can_protocol.md\n";
    return 2;
  }
  std::ostringstream page;
  page << std::ifstream(argv[1]).rdbuf();
  const std::string renewed = can_log::renewed_page(page.str());
  if (renewed.empty()) {
    std::cerr << argv[1] << ": expected a page with the two marker lines of the generated part\n";
    return 2;
  }
  std::ofstream output(argv[1], std::ios::trunc);
  output << renewed;
  return output.flush() ? 0 : 1;
}
