// What of a channel is slower than what drives the rig.
#pragma once
#include <vector>

namespace host_sim {

// The lowest frequency of the band that drives, of a force or of a channel of the base. Down to it the power, a mean over nine bins, is over
// four times the noise (the median of the top quarter of the spectrum), and no more than 1 % of it lies below a gap. 0 where the band reaches down
// to the record's length.
double lowest_drive_Hz(const std::vector<double>& values, double sample_period_s);

// The highest frequency below lowest_Hz / 2 at which the channel stands out of its noise there, by twelve times the level between lowest_Hz / 2
// and 0.9 lowest_Hz (white noise does so once in 160000 bins). 0: nowhere, or what is slower makes less than that share of
// the motion's power in as many integrals of it.
double drift_end_Hz(const std::vector<double>& values, double sample_period_s, double lowest_Hz, int integrations,
                    double least_share);

// The channel without its cosines of half periods up to end_Hz (a discrete cosine transform's, which no jump between the record's ends
// disturbs).
void take_off_cosines(std::vector<double>& values, double sample_period_s, double end_Hz);

}  // namespace host_sim
