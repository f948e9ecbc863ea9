// What to measure next, in a sentence each.
#pragma once
#include <string>
#include <vector>

#include "diagnosis.hpp"

namespace diagnosis {

std::vector<std::string> advice_for(const Diagnosis& diagnosis);

}  // namespace diagnosis
