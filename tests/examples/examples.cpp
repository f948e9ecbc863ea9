#include "tests/examples/examples.hpp"

namespace examples {

const std::vector<Example>& all() {
  static const std::vector<Example> list = {
      {"emps",
       "A linear drive whose friction depends on the direction (EMPS)",
       "emps.toml",
       {"emps.csv"},
       {},
       "A carriage on a ball screw, moved back and forth by a motor: 24.8 s at 1 kHz, position and motor force, from "
       "the\n"
       "EMPS benchmark (Janot, Gautier, Brunot 2019). The rig file knows a mass with viscous and Coulomb friction, "
       "all\n"
       "three to be estimated.\n",
       "The benchmark \"EMPS\" of <https://www.nonlinearbenchmark.org>, file `DATA_EMPS.mat`. Cite its authors: A. "
       "Janot, M.\n"
       "Gautier, M. Brunot, *Data Set and Reference Models of EMPS*, 2019.\n",
       "emps DATA_EMPS.mat recordings",
       "**Published.** The authors of the benchmark found 166.7 N s/m in one direction and 240.4 in the other, and put "
       "it\n"
       "down to fatigue of the screw. Nothing holds the carriage in its place, so the simulation is judged over spans "
       "of\n"
       "one second, each from the measured state.\n"},
      {"pendulum",
       "A pendulum that slows down by more than viscous friction",
       "pendulum.toml",
       {"pendulum_free_swing.csv"},
       {},
       "A single pendulum let go at about 1.5 rad: 55 s at 1 kHz, only the angle (Kaheman et al. 2022). Nothing drives "
       "it.\n"
       "The rig file knows gravity, viscous and Coulomb friction.\n",
       "<https://github.com/dynamicslab/MultiArm-Pendulum> (MIT licence), file\n"
       "`ParameterEstimation/SinglePendulum/SinglePendulumDataForParameterEstimation.mat`. K. Kaheman et al.,\n"
       "arXiv 2205.06231.\n",
       "pendulum SinglePendulumDataForParameterEstimation.mat recordings",
       "**Published.** The authors used viscous friction alone.\n"},
      {"mr_damper",
       "A magnetorheological damper",
       "mr_damper.toml",
       {"mr_damper_0V_record_01.csv", "mr_damper_0V_record_03.csv", "mr_damper_0V_record_05.csv"},
       {"mr_damper_0V_record_07.csv", "mr_damper_0V_record_09.csv"},
       "A damper at 0 V on a crank table: displacement and force at 100 Hz (labcontrol-data, Zenodo 4445334). There is "
       "no\n"
       "mass, so nothing can run freely: what is compared is the force that the model needs for the measured motion. "
       "Two\n"
       "records are held out.\n",
       "<https://github.com/labcontrol-data/mr-damper> (MIT licence), files `data/ensaio1.1.mat`, `3.1`, `5.1`, `7.1` "
       "and `9.1`;\n"
       "the same on Zenodo, 10.5281/zenodo.4445334.\n",
       "mr_damper mr-damper/data recordings",
       "**Published.** A Dahl model with 0.80 N/(mm/s), 50.2 N, 42.7 1/mm (0.023 mm) and a static force, that of the "
       "gas\n"
       "spring in the damper.\n"}};
  return list;
}

}  // namespace examples
