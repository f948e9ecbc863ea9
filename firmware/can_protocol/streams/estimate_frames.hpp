// The estimates of a window as frames.
//
// An estimate carries its own decimal exponent: value = mantissa * 10^exponent, the finest exponent whose mantissa fits
// 32 bits. So nine to ten digits of any value from 2e-16 to 2e16 are on the bus (relative resolution 5e-9 or better), a
// person can read them from candump, and no table has to be agreed on before a number can be read. The exponent changes
// where the digits pass 2147483647 (at 21.47, 0.2147, ...), away from round numbers, so a settled estimate keeps its
// exponent. The standard deviation has an exponent of its own, counted from that of the value: four to five digits of
// it, from 5e-10 of the value up to 6.5e19 in units of the last digit; beyond that it saturates.
#pragma once
#include "firmware/can_protocol/can_frame.hpp"
#include "firmware/can_protocol/values/decimal.hpp"
#include "firmware/identification/estimate.hpp"

namespace firmware {

struct EstimateRecord {
  int32_t value = 0;
  uint16_t std = 0;
  int8_t exponent = 0;       // -24 to 7
  uint8_t std_exponent = 0;  // 0 to 15, above exponent
  EstimateStatus status = EstimateStatus::kStale;
  uint8_t window = 0;  // modulo 8
};
EstimateRecord estimate_record(const ParameterEstimate& estimate, uint32_t window_counter);
bool is_absent(const EstimateRecord& record);  // an unused record of a CAN FD frame
Scaled record_value(const EstimateRecord& record);
Scaled record_std(const EstimateRecord& record);

// Classic CAN: one frame for the estimate of an index.
CanFrame pack_estimate(int node, int index, const ParameterEstimate& estimate, uint32_t window_counter);
EstimateRecord record_at(const CanFrame& message, int bit_offset);  // whatever frame it is: the caller knows
bool unpack_estimate(const CanFrame& message, int& node, int& index, EstimateRecord& record);

// CAN FD: frame j of a window holds the estimates 8j to 8j + 7; records beyond unknown_count hold the value -2^31 and are STALE.
constexpr int kEstimatesPerFdFrame = 8;
constexpr int fd_frames(int unknown_count) { return (unknown_count + kEstimatesPerFdFrame - 1) / kEstimatesPerFdFrame; }
CanFrame pack_estimates_fd(int node, int frame_index, const Estimates& estimates);
// records[i] is that of index 8j + i; present[i] is false where the sender left it unused.
bool unpack_estimates_fd(const CanFrame& message, int& node, int& frame_index,
                         EstimateRecord (&records)[kEstimatesPerFdFrame], bool (&present)[kEstimatesPerFdFrame]);

// The same as 32-bit floats in SI units (single_precision.hpp). Where nothing was estimated (STALE, NO_EXCITATION,
// SATURATED) both are not a number, so that a plot shows a gap and not a zero.
CanFrame pack_estimate_float(int node, int index, const ParameterEstimate& estimate);
CanFrame pack_estimates_float_fd(int node, int frame_index, const Estimates& estimates);
// Whether the estimates and their floats together take less than 30 % of a bus of 500 kbit/s (CAN FD: 2 Mbit/s for the
// data), at worst.
bool float_estimates_fit(int unknown_count, int64_t window_us, bool fd);

}  // namespace firmware
