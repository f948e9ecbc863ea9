// Does the best candidate explain what stands out, or is it only the nearest of all to something that none of them is?
//
// Along its force the stretches' scores had a sum of squares before; its one effect leaves the scatter. What is left of the right
// force is noise, as the place's least scatter per information tells it. What is left of another is also what the two forces differ
// by: it grows with the effect, so that the wrong name of something strong leaves ten and a hundred times the noise.
#include "firmware/warrant/scores/score_test.hpp"

namespace firmware {
namespace {

// The least of a dozen probes of a place is by chance, and by where in the record each has its information, up to half the noise.
constexpr int kNoiseLog2 = 1;
// Right names leave less than an eighth of what is not noise in 97 of 100 drawn records, false ones more in every second or third.
constexpr int kExplainedEighths = 7;
// Two words for one force have Wald statistics within a fourth of each other. What stands out more is no chance.
constexpr int kOutdoneLog2 = -2;
// What stands out by less than half of what is named is what that looks like from elsewhere.
constexpr int kStandsOutLog2 = -1;
constexpr int kBeyondAll = 200;  // exponent of what no deviation of a coefficient reaches

}  // namespace

Scaled share_taken(const Scaled& before, const Scaled& left, const Scaled& noise) {
  if (noise >= left) return kScaledOne;
  return left >= before ? Scaled{} : (before - left) / (before - noise);
}

Scaled ScoreTest::least_scatter(int place) const {
  const ProbePlan& plan = sums_->plan();
  Scaled least;
  for (int j = 0; j < plan.probe_count; ++j) {
    const ProbeScore& score = score_[j];
    if (plan.probe[j].place != place || !score.tested) continue;
    const Scaled level = score.scatter / score.information;
    if (least.is_zero() || level < least) least = level;
  }
  return least;
}

Scaled ScoreTest::explained(int noise_log2) const {
  const ProbeScore& best = score_[best_];
  const Scaled least = least_scatter(sums_->plan().probe[best_].place);
  return share_taken(best.before, best.scatter, scale_by_power_of_two(least * best.information, noise_log2));
}

// Another force, be it one that cannot be, stands out more beside its own scatter.
bool ScoreTest::outdone() const {
  const ProbePlan& plan = sums_->plan();
  const Probe& named = plan.probe[best_];
  const Scaled own = abs(score_[best_].wald), most = own + scale_by_power_of_two(own, kOutdoneLog2);
  for (int j = 0; j < plan.probe_count; ++j) {
    const Probe& other = plan.probe[j];
    const bool same = other.place == named.place && other.cause == named.cause;
    if (!same && score_[j].tested && score_[j].matters && exceeds(score_[j].wald, most)) return true;
  }
  return false;
}

// Of a displacement that is integrated, what the estimated terms do not take up of a spring's force is what integration makes of noise
// below the motion.
bool ScoreTest::made_by_integration() const {
  const Probe& named = sums_->plan().probe[best_];
  if (!kDerivesSignals || score_[best_].apart || named.form > Form::kBeyondStop) return false;
  const Place& place = sums_->plan().place[named.place];
  const auto integrated = [&](int node) {
    return node < configuration_->dof_count &&
           configuration_->signals[node][static_cast<int>(Quantity::kDisplacement)].integrations > 0;
  };
  return integrated(place.node_a) || integrated(place.node_b);
}

// A channel that nobody measures is not late. And a delay times the slope of a force stands for the delay while it is small beside the
// force: from half of it on it is a force of another kind.
bool ScoreTest::is_a_fault() const {
  const ProbePlan& plan = sums_->plan();
  const Probe& named = plan.probe[best_];
  const Place& place = plan.place[named.place];
  if (named.quantity == kNoQuantity || place.kind != PlaceKind::kDof) return true;
  if (!configuration_->channels[place.node_a][named.quantity].present) return false;
  if (named.form != Form::kForceRate) return true;
  const Scaled of_delay = force_square(best_);
  for (int j = 0; j < plan.summed_count; ++j)
    if (plan.probe[j].place == named.place && plan.probe[j].form == Form::kForce)
      return exceeds(own_square_[j], scale_by_power_of_two(of_delay, 2));
  return true;
}

// What cannot be is named where nothing else stands out, and explains nothing.
Naming ScoreTest::naming() const {
  // Channels that contradict each other need no model of the rig.
  if (compares_channels(sums_->plan().place_of(best_).kind)) return Naming::kExplains;
  if (explained(kNoiseLog2) < Scaled::from_int(kExplainedEighths, -3)) return Naming::kInPart;
  if (outdone()) return Naming::kOutdone;
  if (made_by_integration()) return Naming::kTakenUp;
  return is_a_fault() && !impossible(best_) ? Naming::kExplains : Naming::kNoFault;
}

// Neither what a channel is off by, which stands in every equation that it enters, nor a force that is linear in the motion and takes no
// energy: a mode that the rig file lacks looks like that, and its other half is a damper that no probe sees.
bool ScoreTest::is_all_of_it(int number) const {
  const Probe& probe = sums_->plan().probe[number];
  const PlaceKind kind = sums_->plan().place[probe.place].kind;
  const bool on_rig = kind == PlaceKind::kLink || kind == PlaceKind::kNoLink || kind == PlaceKind::kDof;
  const bool of_mode =
      probe.form == Form::kElongation || probe.form == Form::kAcceleration || probe.form == Form::kJerk;
  return on_rig && probe.quantity == kNoQuantity && !of_mode;
}

// Where another law of the place leaves less, what the named one leaves may be a force too, and nobody knows its law: bristles that are
// told as a gap, a friction that wears as a damper that does. It acts where the named one does: no coefficient of that link is spared.
void ScoreTest::doubt_named_link() {
  const Place& place = sums_->plan().place_of(best_);
  if (place.kind != PlaceKind::kLink || explained(0) == kScaledOne) return;
  for (int t = 0; t < configuration_->term_count; ++t) {
    const Term& term = configuration_->terms[t];
    if (term.unknown >= 0 && term.kind != TermKind::kMass && term.place == place.link)
      tested_[term.unknown].named_bend = power_of_two(kBeyondAll);
  }
}

void ScoreTest::find_named_bends() {
  names_a_force_ = best_ >= 0 && naming() == Naming::kExplains;
  if (!names_a_force_) return;
  const Scaled least = scale_by_power_of_two(score_[best_].wald, kStandsOutLog2);
  for (int k = 0; k < unknowns_; ++k) tested_[k].named_bend = Scaled{};
  for (int j = 0; j < sums_->plan().probe_count; ++j) {
    const ProbeScore& score = score_[j];
    if (!score.tested || exceeds(least, score.wald)) continue;
    names_a_force_ = names_a_force_ && is_all_of_it(j);
    open(sums_->plan().probe[j]);
    if (probe_->drifts()) keep_times();
    share_out();
    const Scaled most = score.most(1);
    for (int k = 0; k < unknowns_; ++k) keep_larger(tested_[k].named_bend, most * abs(bend_[k]));
  }
  doubt_named_link();
}

}  // namespace firmware
