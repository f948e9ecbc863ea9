// A page in the making: text goes in as HTML, pictures as data.
#pragma once
#include <set>
#include <string>
#include <vector>

#include "host_sim/reports/figures/plot.hpp"

namespace host_sim::reports {

// "&", "<", ">", quotes as entities: for every text that comes from a file or a user.
std::string escaped(const std::string& plain);

// An HTML table that scrolls sideways where the screen is narrow. Cells are HTML. Columns listed in `numeric` are set
// flush right in figures of one width.
struct HtmlTable {
  std::vector<std::string> heading;
  std::vector<bool> numeric;
  std::vector<std::vector<std::string>> rows;
};
std::string table_html(const HtmlTable& table);

// A horizontal bar of `share` (0 to 1) of its cell, in a colour of the style sheet.
std::string bar_html(double share, const char* colour);

class Page {
 public:
  // `lead` is HTML.
  Page(std::string title, std::string kicker, std::string lead);
  void section(const std::string& id, const std::string& heading, const std::string& explanation);
  void html(const std::string& fragment) { body_ += fragment; }
  // Pictures side by side where there is room, one below the other where there is not; under one legend,
  // which is left out where it would repeat the one above.
  void figures(const std::vector<Plot>& plots);
  std::string finish() const;
  const std::vector<Plot>& plots() const { return plots_; }  // in the order of the page

 private:
  std::string title_, kicker_, lead_, body_, contents_, last_legend_;
  std::vector<Plot> plots_;
};

// In the page's head: the names of its pictures' files, so that the next page in its folder knows them.
std::string figures_line(const std::vector<Plot>& plots);
// Those that stand in a page; none where it is not ours.
std::set<std::string> figures_of_page(const std::string& html);

// The style sheet of all pages.
const char* page_style();

// The page as directory/index.html, whole or not at all, and the data of its pictures as directory/figures/<number>_<title>.csv
// (figures/figure_csv.hpp); what an earlier page wrote there goes, and nothing else. Makes the directory (and removes it again where it was
// made here and the page could not be written). Throws OutputError.
void write_page(const std::string& directory, const Page& page);

}  // namespace host_sim::reports
