// Random numbers that are the same on every machine: the generator is std::mt19937_64, whose output the standard fixes;
// the distributions are written out here because the standard's own are left to each library.
#pragma once
#include <cstdint>
#include <random>

namespace host_sim {

class RandomNumbers {
 public:
  // stream: numbers of one seed that must not depend on how many another consumer draws (one stream per level, channel
  // ...).
  RandomNumbers(uint64_t seed, uint64_t stream);
  double uniform();  // [0, 1), 53 bits
  double normal();   // mean 0, standard deviation 1 (polar method)

 private:
  std::mt19937_64 generator_;
  bool spare_ready_ = false;
  double spare_ = 0.0;
};

}  // namespace host_sim
