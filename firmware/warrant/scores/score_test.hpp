// Is there a force in the record that the rig's model lacks? Score tests of the residual against every probe.
//
// With r the residual of the equations of motion at the window's estimates, phi a probe's force made from each sample's
// neighbours and g its place's weights (b' Omega^-1, b the signs of the force in the place's equations, Omega the
// covariance of the residual there, from the scatter of the stretches), every stretch s of the record gives
//   m_s = sum of phi g' r,   G_s = sum of phi g' columns,   P_s = sum of phi g' b own force
// and, with the scores z of the estimated terms themselves and C = (sum G) (sum N)^-1, N the z's own matrix,
//   psi_s = m_s - C z_s,   d_s = P_s - C G'_s - G_s b + C N_s b,   b = (sum N)^-1 (sum G'):
// what the estimated coefficients cannot take up; b is how far a unit of the force bends them. For given estimates both are
// linear combinations of the stretch's sums, the same for all stretches of a level. Then
//   effect = sum psi / sum d,    Wald = sum psi / sqrt( sum of ((psi_s - effect d_s) / (1 - h_s))^2 ),  h_s = d_s / sum d.
// The scatter is what is left with the effect included (the plain one holds the effect itself); 1 - h_s is the
// leave-one-out correction for the share of the information that one stretch holds. Where that is near a limit, h_s also holds
// what the estimated coefficients, fitted to the same stretches, take up of a score's variance: g' (sum N)^-1 g / d_s with
// g = G_s - C N_s. Limits are Student's for the
// effective number of stretches, at the chance of 4.5 deviations of the normal distribution (7e-6). The even Wald has
//   mean of left_s^2 / d_s, times sum d
// in place of the scatter: the noise alike in all stretches, so that those that hold little information tell it too.
#pragma once
#include "firmware/identification/estimate.hpp"
#include "firmware/warrant/sums/combination.hpp"
#include "firmware/warrant/sums/score_sums.hpp"

namespace firmware {

constexpr int kLeastCertain =
    8;  // deviations of the tests' own fit, in those of the estimates: beyond, it is hardly determined

// Student's quantiles at the chance of 4.5, 4, 3 and 2 deviations of the normal distribution.
enum class Chance : uint8_t {
  kOfFinding,     // 7e-6: with 80 probes one false finding in 2000 records
  kOfDoubt,       // 6e-5: one of 80 right probes reaches it in one of 200 records. The force may well be there
  kBearsOut,      // 3e-3: for a force that other reasons make likely
  kOfOneQuantity  // 5e-2
};
int tenths_of_limit(const Scaled& freedom, Chance chance);
// All that is known of some DOF's velocity comes from this one quantity; of kVelocity: and of the rest of its motion.
bool one_quantity(const CoreConfiguration& configuration, Quantity which);

struct ProbeScore {
  bool tested = false;   // the record can tell this force from the estimated ones
  bool matters = false;  // large enough beside the damping forces
  bool flagged = false;  // and beyond chance
  bool apart = false;    // over a quarter of the force is not taken up by the estimated terms
  Scaled effect, std;    // SI units of the probe's coefficient
  Scaled wald;           // effect over its deviation
  Scaled freedom;        // effective number of stretches
  Scaled even_wald;      // the same, were the noise alike in all stretches
  Scaled even_freedom;   // and their number then
  Scaled information;    // sum of d
  Scaled before;         // sum of psi^2
  Scaled scatter;        // what is left: sum of (psi - effect d)^2
  Scaled gain;           // of the log-likelihood, twice; comparable between probes
  // What the effect may be at the most: what is found of it, and 2^deviations_log2 deviations.
  Scaled most(int deviations_log2) const { return abs(effect) + scale_by_power_of_two(std, deviations_log2); }
};

// What of a size is beyond doubt. Signals as they are measured share no noise that could be doubted.
inline Scaled beyond_doubt(const Scaled& size, const Scaled& doubt) {
  if (!kKeepsProbeNoise) return size;
  return size > doubt ? size - doubt : Scaled{};
}

// What an effect takes away of a sum of squares, of what is not noise in it: 0 where it takes nothing, 1 where noise alone is left. All
// three in one unit.
Scaled share_taken(const Scaled& before, const Scaled& left, const Scaled& noise);

// Sums of a probe, and pairs of an estimated term's scores with the columns there.
constexpr int kMostProbeSums = kPlaceEquations + kMaxPlaceColumns + 3;
constexpr int kMostBaseSums = kMaxUnknowns * kMaxPlaceColumns;

// What the score tests say of an estimated coefficient.
struct CoefficientTest {
  // How far a force that the record does not exclude may bend it, at the most: what is found of it, and its deviation,
  // where it is near the limit of chance, or would be had all samples been looked at (score_naming.cpp). Of a damping law of its own
  // link also what is found where no deviation is known (score_statistic.cpp).
  Scaled possible_bend;
  // The same from two deviations of a force on, which chance makes of one in 20: for what is in doubt already.
  Scaled unlikely_bend;
  // How far a damping law of another power at its own link may bend it: what is found of it, and two deviations.
  Scaled bend_of_shape;
  // Where a force is named: how far it may bend the coefficient at the most, or any other force that stands out half as much beside its
  // own scatter: what is found of it, and two deviations (score_share.cpp).
  Scaled named_bend;
  // What the instrument of the score tests says of it, less the estimate; 0 where it cannot say. Its deviation, and what of it may be
  // noise of a doubtful size.
  Scaled difference, difference_std, difference_doubt;
  uint16_t difference_tenths = 0;
  // A damper where the rig file has no link at all would not show, and the unknown would hold over a quarter of it.
  bool mimics = false;
  // Deviations that the difference of a right rig exceeds once in 16,000 cases: more than four where few stretches tell it.
  Scaled difference_limit() const { return Scaled::ratio(difference_tenths, 10); }
};

class ScoreTest {
 public:
  // False: there is nothing to test with (yet).
  bool judge(const CoreConfiguration& configuration, const ScoreSums& sums, const Estimates& estimates);
  void forget() { best_ = rival_ = -1; }  // nothing is named
  const ProbeScore& score(int probe) const { return score_[probe]; }
  int best() const { return best_; }    // of the flagged candidates, -1: none
  int rival() const { return rival_; }  // the next one of another cause or place, -1: none
  // Of the best candidate, where there is one: whether it is more than the nearest to something else, and the share of what stands
  // out along its force that its effect takes away, 0 to 1 (score_share.cpp), with 2^noise_log2 of the place's least scatter for noise.
  Naming naming() const;
  Scaled explained(int noise_log2 = 0) const;
  // Mean of w^4 over the squared mean of w^2 of a link's rate; 0 where it is not known.
  Scaled rate_kurtosis(int link) const;
  // rms force of a probe's effect over that of the dampers beside it.
  Scaled force_ratio(int probe) const;
  Scaled force_square(int probe) const;  // sum of the effect's forces squared
  // What is named explains what stands out, and is all of it: no fault of a channel, which bends more than its own equation, and no mode.
  bool names_a_force() const { return names_a_force_; }
  // The record cannot tell a damping law of the link from its estimated coefficients.
  bool blind(int link) const { return blind_[link]; }
  const CoefficientTest& of(int unknown) const { return tested_[unknown]; }

 private:
  void open(const Probe& probe);
  int shared_slopes() const { return kKeepsProbeNoise ? sums_->plan().slopes : 0; }
  // sum + sign x, sign -1, 0 or 1.
  static void add_signed(Scaled& sum, int sign, const Scaled& x);
  // What weights g of the place's equations take of a column there, times sign.
  static Scaled taken(const Place& place, int column, const Scaled* g, int sign);
  void take_level(int level);
  void add_scores(Combination<kMostProbeSums>& combination, const Scaled* equation) const;
  void add_sums(Combination<kMostProbeSums>& combination, const Scaled* factor) const;
  Scaled middle(int stretch) const;
  Scaled end_of(int level) const { return middle(level_begin_[level + 1] - 1); }
  Scaled time(int stretch, const Scaled& end) const;
  void keep_times();
  Scaled total(int level, int value, int power) const;
  Scaled column_total(int level, int column) const;
  Scaled doubtful_score();
  void weigh(int place);
  void weigh_level(const Place& place, int level, int place_number);
  void add_base(const Probe& probe);
  void invert();
  void find_base();
  Scaled step_of(int unknown, Scaled* share) const;
  void measure_step(bool keeps);
  void settle(const Estimates& estimates);
  void test(int number);
  void score_level(int level);
  void turn_round(ProbeScore& result);
  bool conclude(ProbeScore& result);
  void judge_by_scatter(ProbeScore& result);
  Scaled variance_of_sum(const Scaled* share, Scaled& freedom) const;
  Scaled even_variance(ProbeScore& result, const Scaled& lost) const;
  void find_answers(int level);
  void share_out();
  int list_base_sums(int level, const Scaled* times, uint8_t* unknown_of);
  Scaled give_back_level(int level, const ProbeScore& result);
  void weigh_up(ProbeScore& result, const Scaled& lost, const Scaled& doubtful);
  bool near_chance(const ProbeScore& score) const;
  void keep_bends(int probe);
  void keep_bend_of_shape(int probe);
  void keep_blind(const Probe& probe);
  bool is_at_home(const Probe& probe) const;
  void keep_unbounded(const ProbeScore& score);
  void judge_size(int number);
  void name();
  bool impossible(int probe) const;
  bool is_held_by_friction(int probe) const;
  bool is_all_of_it(int probe) const;
  void doubt_named_link();
  void find_named_bends();
  Scaled least_scatter(int place) const;
  bool outdone() const;
  bool made_by_integration() const;
  bool is_a_fault() const;
  Scaled damping_square(int place) const;
  Scaled terms_square(int place, bool own) const;
  const Scaled& coefficient(const Term& term) const {
    return term.unknown >= 0 ? parameter_[term.unknown] : term.value;
  }

  // The small ones first: a short instruction reaches them.
  const CoreConfiguration* configuration_ = nullptr;
  const ScoreSums* sums_ = nullptr;
  const Probe* probe_ = nullptr;  // at hand
  const Place* place_ = nullptr;  // its own
  int unknowns_ = 0, stretches_ = 0, levels_ = 0;
  int best_ = -1, rival_ = -1;
  Scaled samples_;    // looked at
  Scaled seen_root_;  // root of their share of all
  Scaled parameter_[kMaxUnknowns];
  uint8_t level_of_[kMostStretches];
  uint16_t level_begin_[kMaxLevels + 1];  // stretches of a level stand together
  uint8_t place_of_unknown_[kMaxUnknowns];
  bool determined_[kMaxUnknowns];
  Scaled weight_[kMaxPlaces][kMaxLevels][kPlaceEquations];
  Scaled normal_[kMaxUnknowns][kMaxUnknowns], inverse_[kMaxUnknowns][kMaxUnknowns];
  ShortScaled base_score_[kMostStretches][kMaxUnknowns];
  Scaled base_doubt_[kMaxUnknowns];  // of the sum of its scores
  // The probe at hand: SI units of its sums; what of a sum's noise stands in one of an equation or column (SI, per sum of a
  // slope); at the level at hand g' column signs and the answers of the estimated terms' scores; C and b.
  Scaled unit_[kMostProbeSums], noise_[kKeepsProbeNoise ? 2 : 1][kPlaceEquations + kMaxPlaceColumns];
  Scaled column_weight_[kMaxPlaceColumns], answer_[kMaxPlaceColumns];
  Scaled share_[kMaxUnknowns], bend_[kMaxUnknowns], sum_own_;
  Combination<kMostProbeSums> score_sum_, column_sum_;
  Combination<kMostBaseSums> base_sum_;
  // Scores, their information, what the effect leaves of them; before that, of a probe that drifts, the stretches' times.
  Scaled psi_[kMostStretches], d_[kMostStretches], left_[kMostStretches];
  CoefficientTest tested_[kMaxUnknowns];
  bool blind_[kMaxLinks];
  bool names_a_force_ = false;
  // The large ones last.
  ProbeScore score_[kMaxProbes];
  Scaled own_square_[kMaxProbes];  // sum of own forces squared, SI
};

}  // namespace firmware
