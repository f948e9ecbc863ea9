#include "host_sim/programs/results/result_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "firmware/vocabulary/effect_table.hpp"
#include "host_sim/can_log/readable.hpp"
#include "host_sim/programs/shared/terminal.hpp"

namespace host_sim {
namespace {

constexpr double kNoMagnitude = 20;  // half intervals over the number: not even how large it is is known
constexpr double kMuchMissed_percent = 5;
constexpr double kMostPercent = 1000;  // more says no more than that the simulation is another motion

using can_log::rounded_to;
using firmware::EstimateStatus;

std::string plain(double value, int digits) { return fmt::format("{:.{}g}", value, digits); }

Colour colour_of(EstimateStatus status) {
  if (status == EstimateStatus::kValid) return Colour::kGood;
  const bool doubtful = status == EstimateStatus::kStale || status == EstimateStatus::kBiasSuspect ||
                        status == EstimateStatus::kUntested || status == EstimateStatus::kSkewed;
  return doubtful ? Colour::kDoubtful : Colour::kBad;
}

struct Column {
  std::string heading;
  bool right = false;
  std::vector<std::string> cells = {};
  size_t width() const {
    size_t widest = heading.size();
    for (const std::string& cell : cells) widest = std::max(widest, cell.size());
    return widest;
  }
};

std::string padded(const std::string& text, size_t width, bool right) {
  const std::string blanks(width - std::min(width, text.size()), ' ');
  return right ? blanks + text : text + blanks;
}

std::vector<Column> columns_of(const EstimateResult& result) {
  Column name{"parameter"}, truth{"truth", true}, paper{"paper", true}, value{"estimate", true}, low{"95 % from", true},
      high{"to", true}, unit{"unit"}, status{"status"};
  for (const ParameterResult& p : result.parameters) {
    const double half = 0.5 * (p.ci95_high - p.ci95_low);
    name.cells.push_back(p.info.name);
    truth.cells.push_back(p.truth ? plain(*p.truth, 6) : "");
    paper.cells.push_back(p.paper ? plain(*p.paper, 7) : "");
    const bool silent = p.status == EstimateStatus::kStale || p.status == EstimateStatus::kNoExcitation;
    const bool never = silent && p.value == 0.0 && half == 0.0;
    const bool nothing =
        never || (p.status == EstimateStatus::kIllConditioned && half > kNoMagnitude * std::abs(p.value));
    const bool known = !nothing && p.has_interval();
    value.cells.push_back(nothing ? "-" : known ? rounded_to(p.value, half) : plain(p.value, 3));
    low.cells.push_back(known ? rounded_to(p.ci95_low, half) : "-");
    high.cells.push_back(known ? rounded_to(p.ci95_high, half) : "-");
    unit.cells.push_back(p.info.unit);
    status.cells.push_back(status_word(p.status));
  }
  std::vector<Column> columns = {name};
  const auto any = [](const Column& column) {
    return std::any_of(column.cells.begin(), column.cells.end(), [](const std::string& cell) { return !cell.empty(); });
  };
  if (any(truth)) columns.push_back(truth);
  if (any(paper)) columns.push_back(paper);
  for (const Column& column : {value, low, high, unit, status}) columns.push_back(column);
  return columns;
}

// What stands between the columns. Where they are too wide, one blank instead of two; then the paper's figures and the
// truth go, which the JSON keeps. width 0: as wide as they are.
std::string fit_to(int width, std::vector<Column>& columns) {
  const auto fits = [&](size_t gap) {
    size_t total = 0;
    for (const Column& column : columns) total += column.width() + (&column == &columns.back() ? 0 : gap);
    return width <= 0 || total <= static_cast<size_t>(width);
  };
  for (const char* unneeded : {"", "paper", "truth"}) {
    const auto same = [&](const Column& column) { return column.heading == unneeded; };
    columns.erase(std::remove_if(columns.begin(), columns.end(), same), columns.end());
    for (const size_t gap : {size_t{2}, size_t{1}})
      if (fits(gap)) return std::string(gap, ' ');
  }
  return " ";
}

std::string format_fit(const EstimateResult& result) {
  // As many unknowns as equations meet them all, whatever these are.
  const bool any_freedom = result.rows > result.parameters.size();
  std::string text = "mean normalised residual " + (any_freedom ? plain(result.residual_mean_abs, 3)
                                                                : std::string("- (no more equations than unknowns)"));
  if (result.paper_residual) text += " (paper " + plain(*result.paper_residual, 3) + ")";
  text += ", condition number " + plain(result.condition_number, 3) + "\n";
  if (result.mse_percent.empty()) return text;
  text += "MSE (Eq. 13) per DOF, %:";
  const auto percent = [](double mse) { return mse > kMostPercent ? std::string("over 1000") : plain(mse, 3); };
  for (const auto& mse : result.mse_percent) text += " " + (mse ? percent(*mse) : std::string("-"));
  if (!result.paper_mse_percent.empty()) {
    text += " (paper";
    for (const double mse : result.paper_mse_percent) text += " " + plain(mse, 3);
    text += ")";
  }
  text += "; " + result.mse_of + "\n";
  if (!result.mse_note.empty()) text += "  " + result.mse_note + "\n";
  return text;
}

bool cannot_be_negative(const ParameterResult& p) {
  return p.has_interval() && firmware::row_of(p.info.kind).sign == firmware::Sign::kNotNegative &&
         p.status != EstimateStatus::kNoExcitation && p.status != EstimateStatus::kSaturated;
}

// A coefficient that is surely below nought, where it cannot be, contradicts the rig file though no force stands out.
std::string said_of_model(const EstimateResult& result) {
  if (result.warrant.named.effect.empty() && result.records_contradict)
    return warrant_text(result.warrant) + " in all records together, but they contradict each other (note below)";
  for (const ParameterResult& p : result.parameters)
    if (result.warrant.named.effect.empty() && p.status == firmware::EstimateStatus::kModelSuspect && p.ci95_high < 0)
      return p.info.name +
             " is below nought, which cannot be: another law has its place, and no other number is to be relied on "
             "before the rig file has it (diagnose looks for it)";
  for (const ParameterResult& p : result.parameters)
    if (result.warrant.named.effect.empty() && cannot_be_negative(p) && p.ci95_high < 0)
      return p.info.name +
             " is below nought, which cannot be: what stands in an equation with it is not to be relied on "
             "(a force or a push that nobody measured, a law or a mass that the rig file lacks)";
  double most_missed = 0.0;
  for (const auto& mse : result.mse_percent) most_missed = std::max(most_missed, mse.value_or(0.0));
  if (!result.warrant.tested || !result.warrant.named.effect.empty() || most_missed < kMuchMissed_percent)
    return warrant_text(result.warrant);
  return warrant_text(result.warrant) + ", though a free run with these numbers misses " +
         (most_missed > kMostPercent ? "over 1000" : plain(most_missed, 2)) +
         " % of the motion (MSE below): that may be noise; host_sim diagnose tells";
}

}  // namespace

std::string format_table(const EstimateResult& result, bool colours, int width) {
  std::vector<Column> columns = columns_of(result);
  const std::string gap = fit_to(width, columns);
  std::string text;
  for (const Column& column : columns)
    text += coloured(padded(column.heading, column.width(), column.right), Colour::kBold, colours) +
            (&column == &columns.back() ? "\n" : gap);
  for (size_t row = 0; row < result.parameters.size(); ++row)
    for (const Column& column : columns) {
      const bool last = &column == &columns.back();
      const std::string cell = padded(column.cells[row], last ? 0 : column.width(), column.right);
      text += last ? coloured(cell, colour_of(result.parameters[row].status), colours) + "\n" : cell + gap;
    }
  text += wrapped(said_of_model(result), width, "  ") + "\n";
  if (const std::string step = after_suspicion(result.warrant); !step.empty())
    text += wrapped("what to do: " + step, width, "  ") + "\n";
  std::istringstream fit(format_fit(result));
  for (std::string line; std::getline(fit, line);) text += wrapped(line, width, "  ") + "\n";
  for (const std::string& note : result.notes) text += wrapped("note: " + note, width, "  ") + "\n";
  return text;
}

}  // namespace host_sim
