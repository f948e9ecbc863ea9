// The measurements as a Markdown page.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tests/accuracy/special_cases.hpp"
#include "tests/accuracy/statistics.hpp"

namespace accuracy {

struct CleanRow {
  std::string name;
  double error_percent = 0.0, limit_percent = 0.0, paper_percent = 0.0;
};

std::string page_opening();
std::string page_head(int draws);
// One row a case, the weak sides included: where the direct fit does better, the lowest and highest share of intervals
// that hold, and how many parameters meet all marks.
std::string summary_section(const std::vector<std::pair<Case, CaseStatistics>>& cases);
std::string clean_section(const std::vector<CleanRow>& rows);
std::string case_section(const Case& measured, const CaseStatistics& statistics);
// Pooled share of intervals that hold, per kind of excitation.
std::string coverage_section(const std::vector<std::pair<std::string, double>>& coverage);
std::string skew_section(const SkewMeasurement& skew, const std::vector<std::string>& names);
std::string sensor_section(const std::vector<SensorSet>& sets, int draws);
std::string advice_section(const FollowedAdvice& advice);

}  // namespace accuracy
