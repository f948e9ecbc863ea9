// The linear-phase filters that derive missing quantities, all with one band and one delay.
//
// Every filter is a product of: a low-pass (Kaiser-windowed sinc, pass band to a tenth of the sample rate, wide to 0.23); a shift by a
// fraction of a sample (Lagrange through 12 samples: error below 2e-6 up to an eighth of the sample rate); central differences
// of eighth order (wide band: of order 14); integration over six points (error 3e-6 at a twentieth of the sample rate, 2e-4 at a
// tenth), wide over twelve (2e-6 at an eighth, 3e-4 at a fifth). Because derivative and low-pass are separate factors, a signal and
// its derivative are filtered by exactly the same low-pass, whatever the order of the difference formula.
#pragma once
#include <vector>

namespace rig_file {

// Impulse response h[-half] .. h[half], oldest sample first; always of odd length.
using Impulse = std::vector<double>;

constexpr int kLowPassHalf = 12;
enum class Band { kTenth, kWide };  // kWide: where motion reaches beyond a tenth of the sample rate; costs noise

// Low-pass with unit gain at rest that takes the signal's value `advance` samples later, |advance| <= 3.
Impulse low_pass(double advance, Band band = Band::kTenth);
// Unit gain, shifted; for advance 0 the single tap 1.
Impulse shifted_all_pass(double advance);
Impulse first_difference(Band band = Band::kTenth);   // per sample: divide by the sample period
Impulse second_difference(Band band = Band::kTenth);  // per sample squared
// Turns the running sum of a signal into its integral, in units of the sample period.
Impulse sum_to_integral(Band band = Band::kTenth);
Impulse convolve(const Impulse& a, const Impulse& b);

}  // namespace rig_file
