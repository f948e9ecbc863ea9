#include "tests/examples/example_page.hpp"

#include <algorithm>
#include <cmath>

#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/diagnosis_pictures.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace examples {
namespace {

using namespace host_sim::reports;

std::string command(const Example& example) {
  std::string out = "    python3 docs/examples/convert.py " + example.conversion +
                    "\n    build/host/bin/host_sim diagnose --rig docs/examples/" + example.rig;
  for (const std::string& file : example.data) out += " \\\n        --data recordings/" + file;
  for (const std::string& file : example.holdout) out += " \\\n        --holdout recordings/" + file;
  return out + " \\\n        --report " + example.name + "\n\n";
}

std::string with_interval(const Interval& interval) {
  if (!std::isfinite(interval.value)) return "-";
  const int digits = digits_for(interval);
  std::string out = number_text(interval.value, digits);
  if (std::isfinite(interval.low))
    out += " (" + number_text(interval.low, digits) + " to " + number_text(interval.high, digits) + ")";
  return out;
}

std::string tables(const DiagnosisReportData& data) {
  std::string out = "| parameter | unit | rig as given | extended rig |\n|---|---|---|---|\n";
  for (const ParameterChange& row : data.parameters)
    out += "| `" + row.name + "` | " + unit_text(row.unit) + " | " + with_interval(row.before) + " | " +
           with_interval(row.after) + " |\n";
  out += "\n| held-out data | rig as given | extended rig | gain |\n|---|---|---|---|\n";
  for (const DofGain& row : data.gains)
    out += "| NRMSE of DOF " + std::to_string(row.dof) + ", % | " + number_text(row.nrmse_before_percent, 3) + " | " +
           number_text(row.nrmse_after_percent, 3) + " | " +
           number_text(row.nrmse_before_percent / row.nrmse_after_percent, 3) + " |\n";
  return out + "\n";
}

std::string picture(const Example& example, const char* kind, const Plot& plot, const std::string& docs) {
  const std::string file = "pictures/" + example.name + "_" + kind + ".svg";
  host_sim::write_output_file(docs + "/" + file, draw(plot, Target::kStandalone) + "\n");
  return "![" + plot.title + "](" + file + ")\n\n";
}

}  // namespace

std::string section(const Example& example, const DiagnosisReportData& data, const std::string& docs) {
  std::string out = "## " + example.title + "\n\n" + example.introduction + "\n**Where it is published.** " +
                    example.source + "\n" + command(example) + "Verdict: **" + data.verdict + "**. " +
                    verdict_sentence(data) + "\n\n";
  for (const Cause& cause : data.causes) {
    out += "- " + cause_text(cause.effect, cause.where) + ": ";
    for (size_t i = 0; i < cause.parameters.size(); ++i) out += (i ? "; " : "") + ("`" + cause.parameters[i] + "`");
    out += "\n";
  }
  out += "\n" + tables(data) + example.reading + "\n";
  for (const std::string& advice : data.advice) out += "- Advice: " + advice + "\n";
  if (!data.advice.empty()) out += "\n";
  const DofView& view = data.dofs.front();
  out += picture(example, "worst_moment", waveform_pictures(view, view.waveforms.back(), kColumns).at(0), docs);
  const std::vector<Plot> link = link_pictures(data.links.front());
  out += picture(example, "force_against_rate", link.at(1), docs);
  out += picture(example, "force_against_elongation", link.at(0), docs);
  out += picture(example, "energy_left", energy_pictures(view, energy_terms(data.dofs), kColumns).at(1), docs);
  return out;
}

}  // namespace examples
