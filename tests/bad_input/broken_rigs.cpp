// Rig files with one fault each.
#include "tests/bad_input/bad_input.hpp"

namespace bad_input {
namespace {

const std::string kHead = "schema = \"rig/1\"\n";
const std::string kMass = "[[dof]]\nmass_kg = 2.0\n";
const std::string kLink = "[[link]]\nbetween = [1, 0]\nstiffness_N_m = 800.0\nviscous_N_s_m = \"estimate\"\n";
const std::string kTurning = "[[dof]]\ninertia_kg_m2 = 2.0\n[[link]]\nbetween = [1, 0]\n";

std::string repeated(const std::string& text, int count) {
  std::string result;
  for (int i = 0; i < count; ++i) result += text;
  return result;
}

// 17 DOFs to the ground with three unknowns each: 51.
std::string too_many_unknowns() {
  std::string text = kHead + repeated("[[dof]]\nmass_kg = \"estimate\"\n", 16);
  for (int i = 1; i <= 16; ++i)
    text += "[[link]]\nbetween = [" + std::to_string(i) +
            ", 0]\nstiffness_N_m = \"estimate\"\nviscous_N_s_m = \"estimate\"\n" +
            (i == 1 ? "coulomb_N = \"estimate\"\n" : "");
  return text;
}

std::string too_many_links() {
  std::string text = kHead + repeated(kMass, 16);
  for (int a = 1; a <= 16; ++a) text += "[[link]]\nbetween = [" + std::to_string(a) + ", 0]\n";
  for (int a = 1; a <= 15; ++a)
    text += "[[link]]\nbetween = [" + std::to_string(a) + ", " + std::to_string(a + 1) + "]\n";
  for (int a = 1; a <= 2; ++a)
    text += "[[link]]\nbetween = [" + std::to_string(a) + ", " + std::to_string(a + 2) + "]\n";
  return text;
}

Case rig(const std::string& name, const std::string& text, std::vector<std::string> says) {
  says.push_back("rig.toml");
  return Case{name, {{"rig.toml", text}, {"data.csv", good_data()}}, estimate_command(), "", std::move(says)};
}
Case effect(const std::string& name, const std::string& lines, std::vector<std::string> says) {
  return rig(name, kHead + kMass + kLink + "[[link.effect]]\n" + lines, std::move(says));
}

}  // namespace

std::string good_rig() { return kHead + kMass + kLink; }

std::vector<Case> broken_rigs() {
  return {
      rig("RigIsEmpty", "", {"schema", "expected schema = \"rig/1\""}),
      rig("RigIsNotToml", kHead + "[[dof]\nmass_kg = 1\n", {"rig.toml:2", "not valid TOML"}),
      rig("WordWithoutQuotes", kHead + kMass + "[[link]]\nbetween = [1, 0]\nviscous_N_s_m = estimate\n",
          {"rig.toml:6", "not valid TOML", "expected a word in quotes, as in \"estimate\""}),
      rig("DecimalComma", kHead + "[[dof]]\nmass_kg = 2,5\n" + kLink, {"rig.toml:3", "expected a decimal point"}),
      rig("OneDofInSingleBrackets", kHead + "[dof]\nmass_kg = 1\n[dof]\nmass_kg = 2\n",
          {"rig.toml:4", "redefine", "expected [[dof]], as every one of a list is written"}),
      rig("ListWithoutBrackets", kHead + kMass + "[[link]]\nbetween = 1, 0\n",
          {"rig.toml:5", "expected brackets around a list, as in [1, 2]"}),
      rig("TwoValuesOnALine", kHead + "[[dof]]\nmass_kg = 2.5 kg\n" + kLink, {"rig.toml:3", "expected key = value"}),
      rig("RigIsInLatin1",
          kHead +
              "name = \"Pr\xFC"
              "fling\"\n" +
              kMass + kLink,
          {"rig.toml:2", "holds a letter that is not UTF-8", "saved as UTF-8"}),
      rig("RigIsBinary",
          std::string("\x7f"
                      "ELF\x01\0\0\0",
                      8),
          {"rig.toml:1", "not valid TOML"}),
      rig("KeyStandsTwice", kHead + "[[dof]]\nmass_kg = 1\nmass_kg = 2\n", {"rig.toml:4", "mass_kg"}),
      rig("SchemaIsOther", "schema = \"rig/2\"\n" + kMass + kLink, {"rig.toml:1", "schema", "expected \"rig/1\""}),
      rig("SchemaIsANumber", "schema = 1\n" + kMass + kLink, {"rig.toml:1", "schema", "expected text"}),
      rig("NameIsANumber", kHead + "name = 3\n" + kMass + kLink, {"rig.toml:2", "name", "expected text"}),
      rig("TopLevelKeyIsUnknown", kHead + kMass + kLink + "[[lnik]]\nbetween = [1, 0]\n",
          {"lnik", "did you mean \"link\""}),
      rig("NoDof", kHead + "[[link]]\nbetween = [1, 0]\n", {"dof", "expected at least one [[dof]]"}),
      rig("DofIsATable", kHead + "[dof]\nmass_kg = 1\n", {"rig.toml:2", "dof", "[[dof]]"}),
      rig("MassIsMissing", kHead + "[[dof]]\n" + kLink, {"dof 1", "mass_kg", "is missing"}),
      rig("MassIsNegative", kHead + "[[dof]]\nmass_kg = -1.0\n" + kLink, {"rig.toml:3", "mass_kg", "negative"}),
      rig("MassIsText", kHead + "[[dof]]\nmass_kg = \"heavy\"\n" + kLink, {"rig.toml:3", "mass_kg", "\"estimate\""}),
      rig("MassIsNotFinite", kHead + "[[dof]]\nmass_kg = inf\n" + kLink, {"rig.toml:3", "mass_kg", "finite"}),
      rig("MassIsTrue", kHead + "[[dof]]\nmass_kg = true\n" + kLink, {"rig.toml:3", "mass_kg", "expected a number"}),
      rig("MassAndInertia", kHead + "[[dof]]\nmass_kg = 1\ninertia_kg_m2 = 1\n" + kLink,
          {"rig.toml:4", "inertia_kg_m2"}),
      rig("DofKeyIsUnknown", kHead + "[[dof]]\nmas_kg = 1\n" + kLink, {"rig.toml:3", "did you mean \"mass_kg\""}),
      rig("LinkToMissingDof", kHead + kMass + "[[link]]\nbetween = [1, 5]\n", {"rig.toml:5", "link 1", "DOF 5"}),
      rig("LinkFromMissingDof", kHead + kMass + "[[link]]\nbetween = [2, 0]\n", {"rig.toml:5", "between", "expected"}),
      rig("LinkFromGround", kHead + kMass + "[[link]]\nbetween = [0, 1]\n",
          {"rig.toml:5", "between", "DOF number first"}),
      rig("LinkToItself", kHead + kMass + "[[link]]\nbetween = [1, 1]\n", {"rig.toml:5", "itself"}),
      rig("LinkHasThreeEnds", kHead + kMass + "[[link]]\nbetween = [1, 0, 1]\n", {"rig.toml:5", "between", "pair"}),
      rig("LinkEndIsText", kHead + kMass + "[[link]]\nbetween = [1, \"table\"]\n",
          {"rig.toml:5", "between", "\"base\""}),
      rig("LinkHasNoEnds", kHead + kMass + "[[link]]\nstiffness_N_m = 1\n", {"rig.toml:4", "between", "is missing"}),
      rig("LinkStandsTwice", kHead + kMass + kMass + kLink + "[[link]]\nbetween = [2, 1]\n[[link]]\nbetween = [1, 2]\n",
          {"rig.toml:13", "link 3", "repeats"}),
      rig("LinkKeyIsUnknown", kHead + kMass + "[[link]]\nbetween = [1, 0]\nvisco_N_s_m = 1\n",
          {"rig.toml:6", "did you mean \"viscous_N_s_m\""}),
      rig("StiffnessIsNegative", kHead + kMass + "[[link]]\nbetween = [1, 0]\nstiffness_N_m = -5\n",
          {"rig.toml:6", "negative"}),
      rig("TranslatingUnitsOnRotatingDof", kHead + kTurning + "stiffness_N_m = 1.0\n",
          {"rig.toml:6", "stiffness_N_m", "expected stiffness_N_m_rad"}),
      rig("RotatingUnitsOnTranslatingDof", kHead + kMass + "[[link]]\nbetween = [1, 0]\nviscous_N_m_s_rad = 1.0\n",
          {"rig.toml:6", "viscous_N_m_s_rad", "expected viscous_N_s_m"}),
      rig("GravityOnTranslatingDof", kHead + kMass + "[[link]]\nbetween = [1, 0]\ngravity_torque_N_m = 1.0\n",
          {"rig.toml:6", "gravity_torque_N_m"}),
      rig("GravityBetweenDofs",
          kHead + kTurning +
              "[[dof]]\ninertia_kg_m2 = 1\n[[link]]\nbetween = [1, 2]\ngravity_torque_N_m = \"estimate\"\n",
          {"rig.toml:10", "gravity_torque_N_m", "ground"}),
      rig("LinkOfTwoKinds", kHead + kTurning + kMass + "[[link]]\nbetween = [1, 2]\n", {"rig.toml:9", "rotating"}),
      rig("NothingToEstimate", kHead + kMass + "[[link]]\nbetween = [1, 0]\nviscous_N_s_m = 1.0\n",
          {"nothing to estimate"}),
      rig("TooManyDofs", kHead + repeated(kMass, 17) + kLink, {"rig.toml:34", "dof 17", "at most 16"}),
      rig("TooManyLinks", too_many_links(), {"link 33", "at most 32"}),
      rig("TooManyUnknowns", too_many_unknowns(), {"49", "at most 48"}),
      effect("EffectIsUnknown", "kind = \"cubic_stifness\"\ncoefficient = 1\n",
             {"rig.toml:9", "did you mean \"cubic_stiffness\""}),
      effect("EffectOfTheOtherPlace", "kind = \"mass_error\"\ncoefficient = 1\n",
             {"rig.toml:9", "mass_error", "expected one of"}),
      effect("EffectHasNoKind", "coefficient = 1\n", {"link 1, effect 1", "kind", "is missing"}),
      effect("EffectHasNoCoefficient", "kind = \"cubic_stiffness\"\n", {"coefficient", "N/m^3"}),
      effect("EffectLacksItsShape", "kind = \"backlash\"\ncoefficient = \"estimate\"\n", {"gap_m", "is missing"}),
      effect("EffectShapeIsNegative", "kind = \"end_stop\"\ncoefficient = 1\ngap_m = -1e-3\n",
             {"rig.toml:11", "gap_m", "above 0"}),
      effect("EffectShapeIsOfTheOtherKind", "kind = \"stribeck\"\ncoefficient = 1\nstribeck_velocity_rad_s = 1\n",
             {"rig.toml:11", "did you mean \"stribeck_velocity_m_s\""}),
      effect("EffectStandsTwice",
             "kind = \"force_offset\"\ncoefficient = 1\n[[link.effect]]\nkind = \"force_offset\"\ncoefficient = 2\n",
             {"rig.toml:12", "repeats"}),
      rig("HiddenMassToEstimate",
          kHead + kMass +
              "[[dof.effect]]\nkind = \"unmodelled_resonance\"\ncoefficient = \"estimate\"\nresonance_Hz = 9\n"
              "damping_ratio = 0.01\n" +
              kLink,
          {"rig.toml:6", "coefficient", "expected a number"}),
      rig("ChannelIsUnknown", good_rig() + "[[channel]]\nname = \"forse_1_N\"\n",
          {"rig.toml:9", "did you mean \"force_1_N\""}),
      rig("ChannelDelayIsText", good_rig() + "[[channel]]\nname = \"force_1_N\"\ndelay_us = \"late\"\n",
          {"rig.toml:10", "delay_us"}),
      rig("ChannelFullScaleWithoutUnit", good_rig() + "[[channel]]\nname = \"force_1_N\"\nfull_scale_code = 32767\n",
          {"rig.toml:10", "unit_per_code"}),
      rig("ChannelWithOneRail", good_rig() + "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 1\nlowest_code = 0\n",
          {"rig.toml:11", "lowest_code", "lowest_code and highest_code"}),
      rig("ChannelWithRailsTwice",
          good_rig() + "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 1\nlowest_code = 0\nhighest_code = 9\n"
                       "full_scale_code = 9\n",
          {"rig.toml:11", "full_scale_code"}),
      rig("ChannelRailsUpsideDown",
          good_rig() + "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 1\nlowest_code = 9\nhighest_code = 0\n",
          {"rig.toml:11", "below highest_code"}),
      rig("ChannelRailsFarFromItsOffset",
          good_rig() +
              "[[channel]]\nname = \"force_1_N\"\nunit_per_code = 1\nlowest_code = 0\nhighest_code = 16777215\n",
          {"rig.toml:11", "24 bits about"}),
  };
}

}  // namespace bad_input
