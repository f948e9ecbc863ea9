// chain_script DOFS SAMPLES FILE [all]: the rig of the comparison (bench_rig.hpp) as a script for a board (tests/bare_metal),
// one level, the estimates wanted at its end. all: every damper, friction and spring unknown, as far as there is room, and
// codes drawn at random, so that a solve has nothing to leave out.
#include <cstdio>
#include <fstream>
#include <iostream>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "firmware/rig_controller/settings/controller_configuration.hpp"
#include "hal/rig_file/first_batches.hpp"
#include "tests/bench/bench_rig.hpp"

namespace {

void put32(std::ofstream& out, uint32_t value) {
  for (int i = 0; i < 4; ++i) out.put(static_cast<char>(value >> (8 * i)));
}

void write(int dofs, size_t samples, const std::string& path, bool all) {
  const auto configuration = std::make_unique<firmware::ControllerConfiguration>();
  configuration->core = bench::chain(dofs, all);
  configuration->core.window.batch_samples = rig_file::first_batch_samples(samples);
  std::vector<uint8_t> bytes(firmware::kConfigurationBytes);
  const size_t length =
      firmware::encode(*configuration, *reinterpret_cast<uint8_t(*)[firmware::kConfigurationBytes]>(bytes.data()));
  std::ofstream out(path, std::ios::binary);
  out << "RIG1";
  put32(out, static_cast<uint32_t>(length));
  out.write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(length));
  out << 'L';
  const std::vector<firmware::RawSample> codes = bench::raw_samples(dofs);
  std::mt19937 random(1);
  for (size_t n = 0; n < samples; ++n) {
    out.put('S');
    for (int node = 0; node < dofs; ++node)
      for (int q = 0; q < firmware::kQuantities; ++q)
        if (configuration->core.channels[node][q].present)
          put32(out, all ? (static_cast<uint32_t>(random()) >> 12) - (1u << 19)
                         : static_cast<uint32_t>(codes[n % codes.size()].code[node][q]));
  }
  out << "EWQ";
}

}  // namespace

int main(int count, char** words) {
  const bool all = count == 5 && std::string(words[4]) == "all";
  if (count != 4 && !all) {
    std::cerr << "usage: chain_script DOFS SAMPLES FILE [all]\n";
    return 2;
  }
  write(std::stoi(words[1]), std::stoul(words[2]), words[3], all);
  return 0;
}
