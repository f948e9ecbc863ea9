// The three frames of the diagnosis.
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/messages/raw_values.hpp"

namespace firmware {

CanFrame pack_diagnosis(int node, const Diagnosis& diagnosis) {
  return can::pack<can::kDiagnosis>(node, 0,
                                    {static_cast<int64_t>(diagnosis.cause), diagnosis.place_a, diagnosis.place_b,
                                     diagnosis.quantity, diagnosis.unexplained_permille, diagnosis.gained_permille});
}

bool unpack_diagnosis(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[6];
  if (!unpack(can::kDiagnosis, message, node, raw)) return false;
  assign(diagnosis.cause, raw[0]);
  assign(diagnosis.place_a, raw[1]);
  assign(diagnosis.place_b, raw[2]);
  assign(diagnosis.quantity, raw[3]);
  assign(diagnosis.unexplained_permille, raw[4]);
  assign(diagnosis.gained_permille, raw[5]);
  return true;
}

CanFrame pack_diagnosis_size(int node, const Diagnosis& diagnosis) {
  const DecimalSize& size = diagnosis.size;
  return can::pack<can::kDiagnosisSize>(node, 0,
                                        {size.value, size.std, size.exponent - can::kDiagnosisSizeSignals[2].offset,
                                         size.std_exponent, diagnosis.corrected ? 1 : 0});
}

bool unpack_diagnosis_size(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[5];
  if (!unpack(can::kDiagnosisSize, message, node, raw)) return false;
  assign(diagnosis.size.value, raw[0]);
  assign(diagnosis.size.std, raw[1]);
  assign(diagnosis.size.exponent, raw[2] + can::kDiagnosisSizeSignals[2].offset);
  assign(diagnosis.size.std_exponent, raw[3]);
  diagnosis.corrected = raw[4] != 0;
  return true;
}

CanFrame pack_diagnosis_rival(int node, const Diagnosis& diagnosis) {
  return can::pack<can::kDiagnosisRival>(node, 0,
                                         {static_cast<int64_t>(diagnosis.rival), diagnosis.rival_place_a,
                                          diagnosis.rival_place_b, diagnosis.rival_quantity, diagnosis.rival_permille});
}

bool unpack_diagnosis_rival(const CanFrame& message, int& node, Diagnosis& diagnosis) {
  int64_t raw[5];
  if (!unpack(can::kDiagnosisRival, message, node, raw)) return false;
  assign(diagnosis.rival, raw[0]);
  assign(diagnosis.rival_place_a, raw[1]);
  assign(diagnosis.rival_place_b, raw[2]);
  assign(diagnosis.rival_quantity, raw[3]);
  assign(diagnosis.rival_permille, raw[4]);
  return true;
}

}  // namespace firmware
