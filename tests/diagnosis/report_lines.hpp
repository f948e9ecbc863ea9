// The lines of the diagnosis report: what is drawn, how often, and the tally of what was said.
#pragma once
#include <iosfwd>
#include <map>
#include <string>
#include <vector>

#include "judgement.hpp"

namespace hidden {

struct Line {
  std::string title;
  Settings settings;
  double mark_percent = 0;  // exact answers that the issue asks for; 0: none
  bool sets_count = false;  // an answer in a set of equivalents counts too (up to a tenth of the draws)
  int draws = 0;
};

struct Tally {
  int draws = 0, exact = 0, set = 0;
  double seconds = 0, slowest = 0;                              // of one core, per record
  std::map<std::string, std::map<std::string, int>> confusion;  // hidden effect, what was said
  std::map<int, std::pair<int, int>> power;                     // tenth of rho: found, drawn
  std::vector<double> gain_shares;                              // gain over that of the true model
  std::map<std::string, std::vector<double>> limits;            // per effect: printed limit, % of the damping force
  std::vector<std::string> misses;
};

std::vector<Line> report_lines(double share);  // share of the full number of draws

Tally run_line(const Line& line, uint64_t first_seed, std::ostream* list);

double quantile(std::vector<double> values, double share);  // the value that this share of them does not exceed

void write(std::ostream& out, const Tally& tally);
Tally read_tally(std::istream& in);

void write_page(std::ostream& out, const std::vector<Line>& lines, const std::vector<Tally>& tallies, uint64_t seed);

}  // namespace hidden
