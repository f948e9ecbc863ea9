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
       "**What it says.** c = 194 - 40 sgn(w): near 154 N s/m one way and 234 the other. The authors of the benchmark "
       "found\n"
       "166.7 and 240.4 and put it down to fatigue of the screw. A static force, the other candidate, leaves four "
       "times "
       "the\n"
       "error. Nothing holds the carriage in its place, so the simulation is judged over spans of one second, each "
       "from the\n"
       "measured state; there the error of the velocity falls from 11.7 to 1.2 %.\n\n"
       "**What remains.** About 1 N, far above the noise of the encoder: hence *unknown* beside the named cause. It is "
       "of the\n"
       "size that torque ripple and the stiffness of the screw would leave.\n"},
      {"pendulum",
       "A pendulum that slows down by more than viscous friction",
       "pendulum.toml",
       {"pendulum_free_swing.csv"},
       {},
       "A single pendulum let go at about 1.5 rad: 55 s at 1 kHz, only the angle (Kaheman et al. 2022). Nothing drives "
       "it.\n"
       "The rig file knows gravity, viscous and Coulomb friction; the authors used viscous friction alone. With their "
       "rig "
       "file\n"
       "(delete its line `coulomb_N_m`) both `missing_coulomb` and `quadratic_damping` are named.\n",
       "**What it says.** Viscous damping is the middle way between two laws that are really there: a friction of the "
       "bearing,\n"
       "which ends the small swings, and a drag that grows with the square of the speed, which brakes the large ones. "
       "Given\n"
       "both, nothing viscous is left (its value even turns a little negative: the drag is not quite quadratic). A "
       "cubic law\n"
       "fits the seen swings as well, but simulates the unseen ones twice as badly.\n\n"
       "**What remains.** Forces at twice the swinging frequency, which do no work over a cycle: an encoder that sits "
       "slightly\n"
       "off its axis would show so.\n"},
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
       "**What it says.** The gas spring of the damper pushes with 134 N, which no rig file of a plain damper "
       "mentions; the\n"
       "friction does not jump when the motion turns but builds up over some 0.04 mm. The published Dahl model has "
       "0.80 "
       "N/(mm/s),\n"
       "50.2 N and 42.7 1/mm (0.023 mm), and a static force. A late force channel (15 ms) would look alike; it leaves "
       "more of\n"
       "the unseen records.\n\n"
       "**What remains.** 14 % of the force. Further terms fit the seen records better and the unseen ones not.\n"}};
  return list;
}

}  // namespace examples
