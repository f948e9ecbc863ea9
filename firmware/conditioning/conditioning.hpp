// Raw codes to the signals of the energy equations: offset removed, missing quantities derived, every signal with the same delay.
//
//   code - offset -> [another time and gain] -> [high-pass and integrations] -> [FIR] -> rounded shift -> column of the frame
//
// Another time and gain: what the warrant has found wrong with a channel is taken out (channel_shift.hpp).
//
// Where signals pass a high-pass, which leads by up to a quarter of a turn, friction takes its sign from a velocity of its own
// (kSignVelocityColumn): as measured, or integrated with a corner eight times lower and one section that takes the offset away, with what
// both take of it added again to the first order.
//
// Where signals pass a low-pass, friction's sign passes it too: the velocity it is taken from comes as many samples early as that
// filter needs (links/low_passed_sign.hpp), all other signals wait for it.
//
// Signals made from one channel share its history; those whose filters fit each other are made in one pass over it, and what
// comes early as well, for friction's sign, is made once and waits.
//
// Formats: code 24 bits; section states (State) in int64, below 2^57 for two integrations at the slowest corner (shift 12);
// the slow part of a sign's velocity (below 2^48, in coarser steps by kSlowPartBits) over 2^15 samples below 2^55;
// FIR: 57 taps of 30 bits times codes of 24 bits, or of 25 bits times 31, stay below 2^62. Signals leave with |value| <= 2^23; a signal at that limit and a code at
// one of its channel's rails count as saturated.
#pragma once
#include <cstdint>

#include "firmware/acquisition/columns.hpp"
#include "firmware/acquisition/raw_sample.hpp"
#include "firmware/conditioning/channel_shift.hpp"
#include "firmware/conditioning/filter_sum.hpp"

namespace firmware {

// A pole that starts fast and comes down to 1 - 2^-leak_shift: what a level starts with is forgotten within its own length. Each pole
// stays for `time_constants` of its own. The shift of the one that is due after so many samples.
int starting_leak(uint32_t samples, int leak_shift, uint32_t time_constants);

class Conditioning {
 public:
  void configure(const CoreConfiguration& configuration);
  void restart();  // a new level: history and section states are forgotten
  // Takes one sample for position `at` of the frame. False while the filters have not enough history: position not used.
  bool append(const RawSample& sample, Frame& frame, int at);
  bool saturated() const { return saturated_; }  // of the last sample
  // Moves every signal's positions [count, count + kept) to the frame's start.
  void move_frame(Frame& frame, int count, int kept) const;
  int history_samples() const { return history_samples_; }  // samples at a level's start that give no output
  // A level of n samples makes a window of n - margin_samples() sample intervals: filters and end corrections look further.
  int margin_samples() const { return kLevelMarginSamples + history_samples_; }
  // The measured channel is read with these taps from the next level on; number: 0 to kMostShifted - 1, in order.
  void shift(int number, int node, Quantity quantity, const ShiftTaps& taps);
  void shift_nothing();

 private:
  static_assert(kMaxNodes * kQuantities % 2 == 0, "places in pairs");
  static constexpr int kHistory = 2 * kFilterHalf + 1;
  static constexpr int kWaiting = 3;  // displacement, velocity and acceleration
  static_assert(kWaiting * kSignFilterHalf <= 2 * kHistory || !kDerivesSignals, "in the place of a history");
  static constexpr int kMaxSections = kDerivesSignals ? 3 : 1;
  static constexpr int kMaxPaths = kMaxNodes * (kQuantities + (kDerivesSignals ? 1 : 0));
  using State = Fixed<int64_t, 16>;
  enum Turn : uint8_t {
    kKeepsHistory = 1,
    kAlone = 2,
    kThree = 4,  // early: it and the next two are the displacement, velocity and acceleration of one channel
    kFused = 8,
    kDelayed = 16,      // what the path `partner` gave some samples ago
    kKeepsOutput = 32,  // for such a path, where its history would be
  };
  static constexpr uint8_t kNone = UINT8_MAX;
  // One signal. In front stands what few ask for: what stands there would take an address of its own with every sample.
  struct Path {
    uint8_t partner = kNone;  // of a fused velocity: the node's acceleration
    uint8_t signal = 0;       // node * kQuantities + quantity
    // High-pass: differences come first, then integrations, all with the pole 1 - 2^-shift; but a displacement from a measured
    // velocity is integrated first (high_passed()).
    uint8_t sections = 0, integrations = 0, shift = 0;
    uint8_t history_of = 0;  // the path that keeps the samples it is made from
    uint8_t turn = 0;        // what is done for it with each sample
    int8_t parity = 0;       // of the filter's taps (filter_sum.hpp)
    uint16_t history = 0;    // its place in history_
    uint16_t window =
        0;  // middle of its window in history_, behind the newest sample's place there; delayed: the value;
            // the velocity of an early three: the early one's column
    uint16_t column = 0;          // of the frame, as so many numbers from its start
    uint16_t channel_column = 0;  // that of the channel it is made from
    State section[kMaxSections] = {};
    State previous[kMaxSections] = {};  // last input of a difference section
  };
  // The difference of the two velocities after one and two high-pass sections, and the last slope; in the unit of the taps'
  // sums, which SignalConfiguration::shift takes back to codes.
  struct FusionState {
    int64_t once = 0, twice = 0, slope = 0;
  };
  // A measured channel. Codes at or beyond its rails are saturated; beyond them they are taken for the rails, so that
  // code - offset holds 24 bits with sign whatever a converter delivers.
  struct Channel {
    int32_t offset = 0;
    int32_t inside = 0;  // the lowest code that is not saturated: the one below it is the rail
    uint32_t count = 0;  // of such codes: behind them is the other rail
  };
  struct Place {
    uint32_t code;    // among the sample's: node * kQuantities + quantity
    uint32_t column;  // of the frame, as so many numbers from its start
  };
  static constexpr int kSlowPart = kMaxSections - 1, kSlowPartBits = 8;
  State with_its_slow_part(Path& path, State velocity) const;
  void add_channel(int node, int quantity);
  // All channels to their columns; column: the frame's first, at the sample. The first says false, with some of them copied,
  // where they are not alike or a code is at a rail; the second says whether one is.
  bool copy_alike(const int32_t* code, int32_t* column) const;
  bool copy_each(const int32_t* code, int32_t* column) const;
  bool derive(int32_t* column);
  bool shift_channels(int32_t* column);
  bool filter(int32_t* column);
  void list_turns();
  static void keep(Code* place, Code code) { place[0] = place[kHistory] = code; }
  void link_fused_paths();
  void share_histories();
  void delay_velocity(int number);
  void share_early_three(int displacement);
  const SignalConfiguration& signal_of(const Path& path) const { return (&configuration_->signals[0][0])[path.signal]; }
  static int node_of(const Path& path) { return path.signal / kQuantities; }
  static bool is(Quantity quantity, const Path& path) {
    return path.signal % kQuantities == static_cast<int>(quantity);
  }
  static bool integrates_first(const Path& path) { return path.integrations == 1 && is(Quantity::kDisplacement, path); }
  static bool for_sign(const Path& path) { return path.column >= kSignVelocityColumn * kFrameStride; }
  // Samples by which it comes before the others.
  int early(const Path& path) const { return for_sign(path) ? configuration_->sign_half_length : 0; }
  void work_on(const Path& path, Code* newest, int32_t* column);
  void work_on_early_threes(Code* newest, int32_t* column);
  void limit_waiting(Code* waiting);
  Code delayed(Code value);
  Code fused(const Path& path);
  Code clipped(bool high, bool counts);
  Code within_limit(Code value, bool counts);
  Code high_passed(Path& path, Code code);
  Code held(State value, const Path& path);
  Path& add_path(int node, int quantity, int column);
  void add_sign_velocity(int node);

  // In the order of their use with each sample, the small ones first: a processor's loads reach 4 KiB.
  const CoreConfiguration* configuration_ = nullptr;
  int channel_count_ = 0;
  int alike_count_ = 0;  // as many places, rounded up to pairs, where all channels have one range and offset, else 0
  bool plain_ = true;    // no filter anywhere: codes are copied
  bool copies_alone_ = true;  // and none is shifted
  bool saturated_ = false;
  bool shifts_ = false;  // some channel
  int history_at_ = 0;
  uint32_t received_ = 0;
  int history_samples_ = 0;
  int waits_at_ = 0, waiting_ = 0;  // of what waits where all three came early: the next place, and their number
  // A bit for each of the last samples: one that waits was at its limit; and the bit of the sample whose time has come.
  uint32_t limits_ = 0, limit_bit_ = 0;
  int reach_ = 0;  // longest half_length: the common delay in samples
  int path_count_ = 0;
  // In the order of the paths: those that keep a history, and those that work on one, of which kThree come first.
  int keep_count_ = 0, work_count_ = 0, three_count_ = 0;
  uint8_t keeps_[kDerivesSignals ? kMaxPaths : 1], works_[kDerivesSignals ? kMaxPaths : 1];
  Path path_[kMaxPaths];
  Place place_[kMaxNodes * kQuantities];  // of the channels
  Channel channel_[kMaxNodes * kQuantities];
  ChannelShift shift_;
  FusionState fusion_[kDerivesSignals ? kMaxNodes : 1];
  Code history_[kDerivesSignals ? kMaxPaths * 2 * kHistory : 1] =
      {};  // of each path; every entry twice, so that a window is contiguous
};

}  // namespace firmware
