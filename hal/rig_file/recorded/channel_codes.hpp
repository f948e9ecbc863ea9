// The codes of one channel by themselves.
#pragma once
#include <cstdint>
#include <vector>

#include "firmware/acquisition/raw_sample.hpp"

namespace rig_file {

using ChannelCodes = std::vector<std::vector<int32_t>>;  // one vector a record

inline ChannelCodes codes_of(const std::vector<std::vector<firmware::RawSample>>& records, int node, int quantity) {
  ChannelCodes codes;
  for (const auto& record : records) {
    codes.emplace_back();
    codes.back().reserve(record.size());
    for (const firmware::RawSample& sample : record) codes.back().push_back(sample.code[node][quantity]);
  }
  return codes;
}

}  // namespace rig_file
