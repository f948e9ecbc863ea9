#include "host_sim/reports/page/page.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <sstream>

#include "host_sim/reports/figures/figure_csv.hpp"

namespace host_sim::reports {
namespace {

constexpr const char* kFiguresLine = "<meta name=\"host_sim-figures\" content=\"";

// The picture with its name for those who cannot see it.
std::string picture_html(const Plot& plot) {
  return "<svg role=\"img\" aria-label=\"" + escaped(plot.title) + "\"" + draw(plot, Target::kPage).substr(4);
}

const char* swatch(Shape shape) {
  switch (shape) {
    case Shape::kBand:
      return "band";
    case Shape::kDashed:
      return "dashed";
    default:
      return "line";
  }
}

// "link 1-0" and "DOF 2" stay on one line: neither the blank nor the hyphen breaks.
std::string unbroken(std::string html) {
  for (const std::string word : {"link ", "DOF "})
    for (size_t at = 0; (at = html.find(word, at)) != std::string::npos; at += word.size())
      if (std::isdigit(static_cast<unsigned char>(html[at + word.size()])))
        html.replace(at + word.size() - 1, 1, "&nbsp;");
  std::string out;
  for (size_t i = 0; i < html.size(); ++i) {
    const bool between_digits = html[i] == '-' && i > 0 && i + 1 < html.size() &&
                                std::isdigit(static_cast<unsigned char>(html[i - 1])) &&
                                std::isdigit(static_cast<unsigned char>(html[i + 1]));
    out += between_digits ? "&#8209;" : std::string(1, html[i]);
  }
  return out;
}

// The legend of a row of pictures: every label once, in order of appearance.
std::string legend_html(const std::vector<Plot>& plots) {
  std::vector<std::string> entries;
  for (const Plot& plot : plots) {
    for (const Curve& curve : plot.curves) {
      if (curve.label.empty()) continue;
      const std::string entry = std::string("<li><i class=\"") + swatch(curve.shape) +
                                "\" style=\"--c:" + role_variable(curve.role) + "\"></i>" + escaped(curve.label) +
                                "</li>";
      if (std::find(entries.begin(), entries.end(), entry) == entries.end()) entries.push_back(entry);
    }
  }
  std::string out;
  for (const std::string& entry : entries) out += entry;
  return out.empty() ? out : "<ul class=\"legend\">" + out + "</ul>\n";
}

}  // namespace

std::string figures_line(const std::vector<Plot>& plots) {
  std::string names;
  for (size_t i = 0; i < plots.size(); ++i) names += (i == 0 ? "" : " ") + figure_file_name(i + 1, plots[i]);
  return kFiguresLine + names + "\">\n";
}

std::set<std::string> figures_of_page(const std::string& html) {
  std::set<std::string> names;
  const size_t at = html.find(kFiguresLine);
  if (at == std::string::npos) return names;
  const size_t begin = at + std::strlen(kFiguresLine), end = html.find('"', begin);
  std::istringstream words(html.substr(begin, end == std::string::npos ? 0 : end - begin));
  for (std::string name; words >> name;)
    if (is_figure_file_name(name)) names.insert(name);
  return names;
}

std::string escaped(const std::string& plain) {
  std::string out;
  for (char c : plain) {
    switch (c) {
      case '&':
        out += "&amp;";
        break;
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '"':
        out += "&quot;";
        break;
      case '\'':
        out += "&#39;";
        break;
      default:
        out += c;
    }
  }
  return out;
}

std::string table_html(const HtmlTable& table) {
  const auto cell = [&](const char* tag, size_t column, const std::string& content) {
    const bool numeric = column < table.numeric.size() && table.numeric[column];
    return std::string("<") + tag + (numeric ? " class=\"n\">" : ">") + content + "</" + tag + ">";
  };
  std::string out = "<div class=\"scroll\" tabindex=\"0\"><table><thead><tr>";
  for (size_t i = 0; i < table.heading.size(); ++i) out += cell("th", i, table.heading[i]);
  out += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) {
    out += "<tr>";
    for (size_t i = 0; i < row.size(); ++i) out += cell("td", i, row[i]);
    out += "</tr>\n";
  }
  return out + "</tbody></table></div>\n";
}

std::string bar_html(double share, const char* colour) {
  char width[32];
  std::snprintf(width, sizeof width, "%.1f", 100.0 * (std::isfinite(share) ? std::clamp(share, 0.0, 1.0) : 0.0));
  return std::string("<span class=\"bar\"><span style=\"width:") + width + "%;background:" + colour +
         "\"></span></span>";
}

Page::Page(std::string title, std::string kicker, std::string lead)
    : title_(std::move(title)), kicker_(std::move(kicker)), lead_(std::move(lead)) {}

void Page::section(const std::string& id, const std::string& heading, const std::string& explanation) {
  last_legend_.clear();
  contents_ += "<a href=\"#" + id + "\">" + escaped(heading) + "</a>";
  body_ += "<h2 id=\"" + id + "\">" + escaped(heading) + "</h2>\n";
  if (!explanation.empty()) body_ += "<p class=\"why\">" + explanation + "</p>\n";
}

void Page::figures(const std::vector<Plot>& plots) {
  if (plots.empty()) return;
  const std::string legend = legend_html(plots);
  if (legend != last_legend_) body_ += legend;
  last_legend_ = legend;
  const size_t columns = plots.size() == 4 ? 2 : std::min<size_t>(plots.size(), 3);
  body_ += "<div class=\"row row" + std::to_string(columns) + "\">\n";
  for (const Plot& plot : plots) {
    body_ += "<figure><figcaption>" + escaped(plot.title) + "</figcaption>" + picture_html(plot);
    if (!plot.note.empty()) body_ += "<p>" + escaped(plot.note) + "</p>";
    body_ += "</figure>\n";
  }
  body_ += "</div>\n";
  plots_.insert(plots_.end(), plots.begin(), plots.end());
}

std::string Page::finish() const {
  return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
         "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n" +
         figures_line(plots_) + "<title>" + escaped(title_) + "</title>\n<style>" + page_style() +
         "</style></head>\n<body><main>\n<header><p class=\"kicker\">" + escaped(kicker_) + "</p><h1>" +
         unbroken(escaped(title_)) + "</h1>\n" + lead_ + "</header>\n<nav>" + contents_ + "</nav>\n" + body_ +
         "</main></body></html>\n";
}

}  // namespace host_sim::reports
