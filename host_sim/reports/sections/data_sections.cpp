#include "host_sim/reports/sections/data_sections.hpp"

#include <filesystem>

#include "host_sim/reports/figures/numbers.hpp"
#include "host_sim/reports/page/shared_parts.hpp"
#include "host_sim/reports/sections/verdict.hpp"

namespace host_sim::reports {
namespace {

using data_check::Finding;
using data_check::Weight;

const char* weight_html(Weight weight) {
  switch (weight) {
    case Weight::kInforms:
      return "<span class=\"dim\">note</span>";
    case Weight::kDoubt:
      return "<span class=\"warn\">doubt</span>";
    case Weight::kFault:
      return "<span class=\"bad\">fault</span>";
  }
  return "";
}

void add_findings(HtmlTable& table, const std::string& where, const std::vector<Finding>& findings) {
  for (const Finding& finding : findings) {
    std::string detail = finding.detail;
    table.rows.push_back(
        {weight_html(finding.weight),
         escaped(where) + (finding.channel.empty() ? "" : " <code>" + escaped(finding.channel) + "</code>"),
         escaped(finding.kind), "<span class=\"sentence\">" + escaped(detail) + "</span>"});
  }
}

std::string name_of(const data_check::RecordReport& record) {
  return std::filesystem::path(record.file).filename().string();
}

// A finding of all records together may be about one of them, whose name stands at its front.
void add_of_all(HtmlTable& table, const data_check::Report& check, Finding finding) {
  for (const data_check::RecordReport& record : check.records) {
    const std::string& file = record.file;
    if (file.empty() || finding.detail.compare(0, file.size(), file) != 0) continue;
    if (finding.detail.compare(file.size(), 2, ": ") == 0) finding.detail.erase(0, file.size() + 2);
    return add_findings(table, name_of(record), {finding});
  }
  add_findings(table, check.records.size() == 1 ? name_of(check.records.front()) : "all records", {finding});
}

HtmlTable findings_table(const data_check::Report& check) {
  HtmlTable table;
  table.heading = {"", "where", "kind", "finding"};
  table.numeric = {false, false, false, false};
  for (const data_check::RecordReport& record : check.records) {
    add_findings(table, name_of(record), record.findings);
    for (const data_check::ChannelReport& channel : record.channels) {
      std::vector<Finding> named = channel.findings;
      for (Finding& finding : named) finding.channel = channel.name;
      add_findings(table, name_of(record), named);
    }
  }
  for (const Finding& finding : check.findings) add_of_all(table, check, finding);
  return table;
}

HtmlTable channels_table(const data_check::Report& check) {
  HtmlTable table;
  table.heading = {"record", "channel", "rms", "mean", "noise", "resolution"};
  table.numeric = {false, false, true, true, true, true};
  for (const data_check::RecordReport& record : check.records)
    for (const data_check::ChannelReport& channel : record.channels)
      table.rows.push_back({escaped(name_of(record)), "<code>" + escaped(channel.name) + "</code>",
                            number_html(channel.rms, 4), number_html(channel.mean, 3),
                            number_html(channel.noise_floor, 3),
                            channel.resolution > 0.0 ? number_html(channel.resolution, 3) : ""});
  return table;
}

std::string size_text(const WarrantFinding& finding) {
  std::string out = number_html(finding.size, 4);
  if (finding.std > 0.0) out += " ± " + number_html(finding.std, 2);
  return out + " " + escaped(unit_text(finding.unit));
}

}  // namespace

void add_data_check(Page& page, const std::optional<data_check::Report>& check) {
  if (!check) return;
  const std::string verdict = check->verdict();
  page.section("check", "Check of the data",
               verdict == "good"     ? "The check found nothing wrong with these recordings."
               : verdict == "usable" ? "The recordings can be used. The doubts below make the numbers worse."
                                     : "These recordings have faults: the numbers on this page are not to be trusted.");
  const HtmlTable findings = findings_table(*check);
  if (!findings.rows.empty()) page.html(table_html(findings));
  page.html(
      "<details><summary>Every channel: rms about its mean, noise from sample to sample, smallest step, in SI "
      "units</summary>\n" +
      table_html(channels_table(*check)) + "</details>\n");
}

void add_warrant(Page& page, const std::optional<WarrantView>& warrant) {
  if (!warrant) return;
  const WarrantView& said = *warrant;
  page.section(
      "warrant", "What the board says of the model",
      !said.not_the_cause.empty() ? "The data contradict the rig file, and none of the board's candidates explains it. "
                                    "The nearest is not the cause: " +
                                        said.not_the_cause + "."
      : !said.named.effect.empty()
          ? "The data contradict the rig file. The board suspects the first cause; the second is the next best."
      : said.tested ? "The data were able to contradict the rig file, and they do not."
                    : "These data cannot contradict the rig file: that the numbers look right proves nothing.");
  if (said.named.effect.empty()) return;
  HtmlTable table;
  table.heading = {"", "cause", "size (± one standard deviation)", "likelihood gain, %"};
  table.numeric = {false, false, true, true};
  table.rows.push_back({said.not_the_cause.empty() ? "suspected" : "nearest",
                        "<b>" + escaped(cause_text(said.named.effect, said.named.where)) + "</b>",
                        size_text(said.named), "100"});
  if (!said.rival.effect.empty())
    table.rows.push_back({"next best", escaped(cause_text(said.rival.effect, said.rival.where)), size_text(said.rival),
                          number_html(said.rival_percent, 2)});
  page.html(table_html(table));
}

}  // namespace host_sim::reports
