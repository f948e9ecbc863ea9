// Of one value per sample.
#pragma once
#include "fourier.hpp"

namespace diagnosis {

double rms_about_mean(const Series& y);

// Running integral from nought, exact for cubics but at the ends.
Series integral(const Series& y, double period_s);

}  // namespace diagnosis
