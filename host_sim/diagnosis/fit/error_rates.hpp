// How sure the diagnosis has to be: every deviate that it asks for, in standard errors, as a normal deviate.
#pragma once
#include "host_sim/diagnosis/interval.hpp"

namespace diagnosis::runs {

// To name a cause: chance passes it on one of 200 candidates once in 500 records, with a margin for what is not normal.
constexpr double kNamed = 4.5;
// Where a single question is asked: chance says yes once in 370.
constexpr double kSure = 3;
// Of a difference: chance makes one of twenty as large.
constexpr double kByChance = 2;
// Of the squared error, that may remain where something pays: a twentieth less is missed, and less is nothing that anybody
// would act on.
constexpr double kPays = 0.9;

}  // namespace diagnosis::runs
