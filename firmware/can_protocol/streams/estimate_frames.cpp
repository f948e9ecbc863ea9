#include "firmware/can_protocol/streams/estimate_frames.hpp"

#include "firmware/can_protocol/load/bus_load.hpp"
#include "firmware/can_protocol/messages/packing.hpp"
#include "firmware/can_protocol/values/single_precision.hpp"

namespace firmware {
namespace {

enum SignalIndex {
  kValue,
  kStd,
  kExponent,
  kStatus,
  kStdExponent,
  kWindowCounter,
  kUntestedBit
};  // order of kEstimateSignals

constexpr const can::Signal& signal(SignalIndex index) { return can::kEstimateSignals[index]; }
constexpr int32_t kOffset = signal(kExponent).offset;
constexpr int32_t kLowestExponent = kOffset;
constexpr int32_t kHighestExponent = kOffset + static_cast<int32_t>(can::highest_raw(signal(kExponent)));
constexpr int32_t kStdExponents = static_cast<int32_t>(can::highest_raw(signal(kStdExponent)));
constexpr int64_t kLargestValue = can::highest_raw(signal(kValue));
constexpr int64_t kLargestStd = can::highest_raw(signal(kStd));
constexpr int64_t kAbsentValue = -2147483648ll;  // no estimate has it: mantissas are symmetric
static_assert(kLowestExponent == -24 && kHighestExponent == 7 && kStdExponents == 15, "as estimate_frames.hpp says");
static_assert(can::record_bits(can::kEstimateFd) == 64 && can::kEstimateFd.repeats == kEstimatesPerFdFrame,
              "one record, twice used");

void set_record(CanFrame& message, const EstimateRecord& record, int bit_offset) {
  can::set_raw(message, signal(kValue), record.value, bit_offset);
  can::set_raw(message, signal(kStd), record.std, bit_offset);
  can::set_raw(message, signal(kExponent), record.exponent - kOffset, bit_offset);
  const bool untested = record.status == EstimateStatus::kUntested;
  can::set_raw(message, signal(kStatus), static_cast<int64_t>(untested ? EstimateStatus::kModelSuspect : record.status),
               bit_offset);
  can::set_raw(message, signal(kUntestedBit), untested ? 1 : 0, bit_offset);
  can::set_raw(message, signal(kStdExponent), record.std_exponent, bit_offset);
  can::set_raw(message, signal(kWindowCounter), record.window, bit_offset);
}

void set_float_record(CanFrame& message, const ParameterEstimate& estimate, int bit_offset) {
  const bool estimated = estimate.status != EstimateStatus::kStale &&
                         estimate.status != EstimateStatus::kNoExcitation &&
                         estimate.status != EstimateStatus::kSaturated;
  const uint32_t value = estimated ? single_precision_bits(estimate.value) : kNotANumberBits;
  const uint32_t std = estimated ? single_precision_bits(abs(estimate.std)) : kNotANumberBits;
  can::set_raw(message, can::kEstimateFloatSignals[0], value, bit_offset);
  can::set_raw(message, can::kEstimateFloatSignals[1], std, bit_offset);
}

// The busiest stream: all 48 estimates and their window frame every 50 ms on a 500 kbit/s bus.
static_assert(can::load_permille(can::kEstimate, kWireUnknowns + 1, 50000, 500000) < 300,
              "estimates stay under 30 % of the bus");

}  // namespace

EstimateRecord record_at(const CanFrame& message, int bit_offset) {
  EstimateRecord record;
  record.value = static_cast<int32_t>(can::get_raw(message, signal(kValue), bit_offset));
  record.std = static_cast<uint16_t>(can::get_raw(message, signal(kStd), bit_offset));
  record.exponent = static_cast<int8_t>(can::get_raw(message, signal(kExponent), bit_offset) + kOffset);
  record.status = static_cast<EstimateStatus>(can::get_raw(message, signal(kStatus), bit_offset));
  if (can::get_raw(message, signal(kUntestedBit), bit_offset) != 0) record.status = EstimateStatus::kUntested;
  record.std_exponent = static_cast<uint8_t>(can::get_raw(message, signal(kStdExponent), bit_offset));
  record.window = static_cast<uint8_t>(can::get_raw(message, signal(kWindowCounter), bit_offset));
  return record;
}

EstimateRecord estimate_record(const ParameterEstimate& estimate, uint32_t window_counter) {
  const Decimal value = to_decimal(estimate.value, kLargestValue, kLowestExponent, kHighestExponent);
  // A standard deviation far above the value (a parameter close to 0) lifts the exponent of both.
  const Decimal std = to_decimal(abs(estimate.std), kLargestStd, value.exponent, kHighestExponent + kStdExponents);
  const int32_t excess = std.exponent - value.exponent - kStdExponents;
  const int32_t exponent = excess > 0 ? value.exponent + excess : value.exponent;
  EstimateRecord record;
  record.exponent = static_cast<int8_t>(exponent);
  record.value = static_cast<int32_t>(decimal_mantissa(estimate.value, exponent, kLargestValue));
  record.std = static_cast<uint16_t>(std.mantissa);
  record.std_exponent = static_cast<uint8_t>(std.exponent - exponent);
  record.status = estimate.status;
  record.window = static_cast<uint8_t>(window_counter & 7u);
  return record;
}

bool is_absent(const EstimateRecord& record) { return record.value == kAbsentValue; }

Scaled record_value(const EstimateRecord& record) { return from_decimal(Decimal{record.value, record.exponent}); }

Scaled record_std(const EstimateRecord& record) {
  return from_decimal(Decimal{record.std, record.exponent + record.std_exponent});
}

CanFrame pack_estimate(int node, int index, const ParameterEstimate& estimate, uint32_t window_counter) {
  CanFrame message = can::empty_frame(can::kEstimate, node, index);
  set_record(message, estimate_record(estimate, window_counter), 0);
  return message;
}

bool unpack_estimate(const CanFrame& message, int& node, int& index, EstimateRecord& record) {
  if (!can::is_frame(can::kEstimate, message, node, index)) return false;
  record = record_at(message, 0);
  return true;
}

CanFrame pack_estimates_fd(int node, int frame_index, const Estimates& estimates) {
  CanFrame message = can::empty_frame(can::kEstimateFd, node, frame_index);
  for (int i = 0; i < kEstimatesPerFdFrame; ++i) {
    const int index = frame_index * kEstimatesPerFdFrame + i;
    const int bit_offset = i * can::record_bits(can::kEstimateFd);
    if (index < estimates.unknown_count) {
      set_record(message, estimate_record(estimates.parameters[index], estimates.window_counter), bit_offset);
    } else {
      can::set_raw(message, signal(kValue), kAbsentValue, bit_offset);
      can::set_raw(message, signal(kStatus), static_cast<int64_t>(EstimateStatus::kStale), bit_offset);
    }
  }
  return message;
}

bool unpack_estimates_fd(const CanFrame& message, int& node, int& frame_index,
                         EstimateRecord (&records)[kEstimatesPerFdFrame], bool (&present)[kEstimatesPerFdFrame]) {
  if (!can::is_frame(can::kEstimateFd, message, node, frame_index)) return false;
  for (int i = 0; i < kEstimatesPerFdFrame; ++i) {
    records[i] = record_at(message, i * can::record_bits(can::kEstimateFd));
    present[i] = !is_absent(records[i]);
  }
  return true;
}

CanFrame pack_estimate_float(int node, int index, const ParameterEstimate& estimate) {
  CanFrame message = can::empty_frame(can::kEstimateFloat, node, index);
  set_float_record(message, estimate, 0);
  return message;
}

CanFrame pack_estimates_float_fd(int node, int frame_index, const Estimates& estimates) {
  static const ParameterEstimate kNothing;  // STALE
  CanFrame message = can::empty_frame(can::kEstimateFloatFd, node, frame_index);
  for (int i = 0; i < kEstimatesPerFdFrame; ++i) {
    const int index = frame_index * kEstimatesPerFdFrame + i;
    const bool present = index < estimates.unknown_count;
    set_float_record(message, present ? estimates.parameters[index] : kNothing,
                     i * can::record_bits(can::kEstimateFloatFd));
  }
  return message;
}

bool float_estimates_fit(int unknown_count, int64_t window_us, bool fd) {
  constexpr int64_t kMost_permille = 300;
  if (window_us <= 0) return false;
  const can::FrameDescription& frame = fd ? can::kEstimateFd : can::kEstimate;  // as long as its float form
  const int frames = 2 * (fd ? fd_frames(unknown_count) : unknown_count);
  return can::load_permille(frame, frames, window_us, 500000) + can::load_permille(can::kWindow, 1, window_us, 500000) <
         kMost_permille;
}

}  // namespace firmware
