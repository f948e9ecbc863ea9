// The forces that a rig's model may lack, in the order in which they are tried, and the form of the law of each.
#pragma once
#include "firmware/warrant/probes/probe.hpp"

namespace firmware {

// What the vocabulary says of the effect is read when compiling: the table's words stay out of the image.
struct Candidate {
  Form form;
  Cause cause;
  CoreTerm core;
  constexpr Candidate(Form f, EffectKind effect) : form(f), cause(cause_of(effect)), core(row_of(effect).core) {}
};

// Most telling first: what does not fit is left out from the end.
inline constexpr Candidate kOnLink[] = {
    {Form::kElongation, EffectKind::kStiffnessError},
    {Form::kElongationCube, EffectKind::kCubicStiffness},
    {Form::kRateSquare, EffectKind::kQuadraticDamping},
    {Form::kRate, EffectKind::kMissingViscous},
    {Form::kSign, EffectKind::kMissingCoulomb},
    {Form::kElongationSquareRate, EffectKind::kDisplacementDependentDamping},
    {Form::kRateMagnitude, EffectKind::kAsymmetricViscous},
    {Form::kElongationSquare, EffectKind::kQuadraticStiffness},
    {Form::kConstant, EffectKind::kForceOffset},
    {Form::kWithinGap, EffectKind::kBacklash},
    {Form::kBeyondStop, EffectKind::kEndStop},
    {Form::kRateCube, EffectKind::kCubicDamping},
    {Form::kSignNarrow, EffectKind::kStribeck},
    {Form::kSignWide, EffectKind::kStribeck},
    {Form::kSignElongation, EffectKind::kPreslidingHysteresis},
};

// At the other places; quantity: of the channel that the cause is in, of a base's end what is measured there.
struct Elsewhere {
  PlaceKind kind;
  Form form;
  Cause cause;
  uint8_t quantity;
  constexpr Elsewhere(PlaceKind k, Form f, EffectKind effect)
      : kind(k), form(f), cause(cause_of(effect)), quantity(kNoQuantity) {}
  constexpr Elsewhere(PlaceKind k, Form f, EffectKind effect, Quantity q)
      : kind(k), form(f), cause(cause_of(effect)), quantity(static_cast<uint8_t>(q)) {}
};
inline constexpr Elsewhere kElsewhere[] = {
    {PlaceKind::kNoLink, Form::kRate, EffectKind::kMissingViscous},
    {PlaceKind::kNoLink, Form::kSign, EffectKind::kMissingCoulomb},
    {PlaceKind::kVelocityChannels, Form::kRate, EffectKind::kSensorGain, Quantity::kVelocity},
    {PlaceKind::kAccelerationChannels, Form::kAcceleration, EffectKind::kSensorGain, Quantity::kAcceleration},
    {PlaceKind::kBaseEnd, Form::kRate, EffectKind::kSensorDelay},
    {PlaceKind::kBaseEnd, Form::kElongation, EffectKind::kSensorGain},
    {PlaceKind::kDof, Form::kAcceleration, EffectKind::kMassError},
    {PlaceKind::kDof, Form::kJerk, EffectKind::kSensorDelay, Quantity::kAcceleration},
    {PlaceKind::kDof, Form::kForce, EffectKind::kSensorGain, Quantity::kForce},
    {PlaceKind::kDof, Form::kForceWithinGap, EffectKind::kDriveDeadBand, Quantity::kForce},
    {PlaceKind::kDof, Form::kForceRate, EffectKind::kSensorDelay, Quantity::kForce},
};

// The law by which an estimated term is weighed.
inline Form form_of(TermKind kind) {
  if (kind == TermKind::kMass) return Form::kAcceleration;
  if (kind == TermKind::kDriftingViscous) return Form::kRate;
  for (const Candidate& candidate : kOnLink)
    if (candidate.core.estimable && candidate.core.term == kind) return candidate.form;
  return Form::kElongation;
}

}  // namespace firmware
