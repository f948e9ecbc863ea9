// One symbol per object of the core, as large as the object: budget.py reads the sizes from what this compiles to.
#include "firmware/rig_controller/rig_controller.hpp"

#define BUDGET(type) char budget_##type[sizeof(firmware::type)] = {1};

BUDGET(CoreConfiguration)
BUDGET(Conditioning)
BUDGET(Frame)
BUDGET(EnergySums)
BUDGET(BatchTable)
BUDGET(BatchCollector)
BUDGET(IdentificationMemory)
BUDGET(Estimates)
BUDGET(ScoreTests)
BUDGET(EstimatorCore)
BUDGET(RigController)
