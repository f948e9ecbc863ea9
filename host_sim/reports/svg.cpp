// gnuplot's SVG documents -> elements that fit into a page, or picture files with the colours filled in.
#include <cstdio>

#include "host_sim/reports/compact_path.hpp"
#include "host_sim/reports/plot.hpp"

namespace host_sim::reports {
namespace {

struct Palette {
  const char* variable;
  const char* light;
};

constexpr Palette kRolePalette[kRoles] = {
    {"var(--measured)", "#24292f"}, {"var(--given)", "#cf5a0c"}, {"var(--extended)", "#1466c4"},
    {"var(--truth)", "#2c7a3f"},    {"var(--term1)", "#1466c4"}, {"var(--term2)", "#cf5a0c"},
    {"var(--term3)", "#2c7a3f"},    {"var(--term4)", "#7d4fa6"}, {"var(--term5)", "#a87b00"},
    {"var(--term6)", "#0b7f8a"},    {"var(--term7)", "#b93a72"}, {"var(--term8)", "#75563b"},
};
// Grid, frame, text, background: markers 0x70 to 0x73.
constexpr Palette kFramePalette[4] = {
    {"var(--grid)", "#e4e7eb"}, {"var(--frame)", "#9aa3ad"}, {"var(--soft)", "#57606a"}, {"none", "#ffffff"}};

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
    text.replace(at, from.size(), to);
}

void remove_between(std::string& text, const std::string& open, const std::string& close) {
  for (size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    const size_t end = text.find(close, at + open.size());
    if (end == std::string::npos) return;
    text.erase(at, end + close.size() - at);
  }
}

void colour(std::string& svg, int marker, const Palette& palette, Target target) {
  const char* value = target == Target::kPage ? palette.variable : palette.light;
  char as_rgb[32], as_short_rgb[32], as_hex[16];
  std::snprintf(as_rgb, sizeof as_rgb, "rgb(  0,   0, %3d)", marker);
  std::snprintf(as_short_rgb, sizeof as_short_rgb, "rgb(0,0,%d)", marker);
  std::snprintf(as_hex, sizeof as_hex, "#0000%02x", static_cast<unsigned>(marker));
  replace_all(svg, as_rgb, value);
  replace_all(svg, as_short_rgb, value);
  replace_all(svg, as_hex, value);
}

// Groups that draw nothing: gnuplot opens one for every change of pen.
void remove_empty_groups(std::string& svg) {
  size_t at = 0;
  while ((at = svg.find("<g fill=", at)) != std::string::npos) {
    const size_t end = svg.find('>', at);
    if (end != std::string::npos && svg.compare(end + 1, 5, "\n</g>") == 0) {
      svg.erase(at, end + 6 - at);
    } else {
      ++at;
    }
  }
}

// What the page's style sheet says once need not be said at every mark.
void shorten(std::string& svg) {
  replace_all(svg,
              "<g fill=\"none\" stroke=\"currentColor\" stroke-width=\"1.00\" stroke-linecap=\"round\" "
              "stroke-linejoin=\"round\">",
              "<g class=\"p\">");
  replace_all(svg, " stroke=\"none\" fill=\"var(--soft)\" font-size=\"12.00\" ", " class=\"t\"");
  replace_all(svg, "<path stroke='var(--grid)' class=\"gridline\" ", "<path class=\"gridline\"");
  replace_all(svg, "\t", "");
  replace_all(svg, "/></g>\n<g class=\"p\">\n", "/>\n");
  replace_all(svg, "</g>\n</g>\n<g class=\"p\">\n", "</g>\n");
}

std::string finish_one(std::string svg, Target target) {
  remove_between(svg, "<defs>", "</defs>\n");
  remove_between(svg, "<title>", "</title>\n");
  remove_between(svg, "<desc>", "</desc>\n");
  remove_between(svg, " id=\"", "\"");
  replace_all(svg, " xmlns:xlink=\"http://www.w3.org/1999/xlink\"\n", "");
  if (target == Target::kPage) {
    replace_all(svg, " xmlns=\"http://www.w3.org/2000/svg\"\n", "");
    remove_between(svg, "<rect x=\"0\" y=\"0\"", "/>\n");
    replace_all(svg, " font-family=\"sans-serif\"", "");
  }
  for (int i = 0; i < kRoles; ++i) colour(svg, i + 1, kRolePalette[i], target);
  for (int i = 0; i < 4; ++i) colour(svg, 0x70 + i, kFramePalette[i], target);
  const char* ink = target == Target::kPage ? "var(--soft)" : "#57606a";
  replace_all(svg, "color=\"black\" ", "");
  replace_all(svg, "'black'", std::string("'") + ink + "'");
  replace_all(svg, "\"black\"", std::string("\"") + ink + "\"");
  remove_empty_groups(svg);
  if (target == Target::kPage) shorten(svg);
  replace_all(svg, "<tspan >", "<tspan>");
  replace_all(svg, "\n\n", "\n");
  replace_all(svg, "  '/>", "'/>");
  return target == Target::kPage ? with_compact_paths(svg) : svg;
}

}  // namespace

const char* role_variable(Role role) { return kRolePalette[static_cast<int>(role)].variable; }
const char* role_colour(Role role) { return kRolePalette[static_cast<int>(role)].light; }

std::vector<std::string> finish_svg(const std::string& gnuplot_output, Target target) {
  std::vector<std::string> documents;
  const std::string close = "</svg>";
  for (size_t at = gnuplot_output.find("<svg"); at != std::string::npos; at = gnuplot_output.find("<svg", at)) {
    const size_t end = gnuplot_output.find(close, at);
    if (end == std::string::npos) break;
    documents.push_back(finish_one(gnuplot_output.substr(at, end + close.size() - at), target));
    at = end;
  }
  return documents;
}

}  // namespace host_sim::reports
