// Pieces of a page.
#include "host_sim/reports/page/page.hpp"

#include <gtest/gtest.h>

namespace {

using namespace host_sim::reports;

size_t count(const std::string& text, const std::string& part) {
  size_t found = 0;
  for (size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

Plot plot(const std::string& y_label) {
  Plot out;
  out.title = "a 'title'";
  out.x_label = "time";
  out.x_unit = "s";
  out.y_label = y_label;
  out.y_unit = "m";
  out.curves = {{"one", Role::kGiven, Shape::kLine, {0, 1, 2}, {0.001, 0.002, 0.0015}, {}}};
  return out;
}

TEST(Page, TextIsEscaped) { EXPECT_EQ(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;"); }

TEST(Page, TableMarksNumericColumns) {
  const std::string html = table_html({{"name", "value"}, {false, true}, {{"x", "1"}}});
  EXPECT_EQ(count(html, "<td class=\"n\">1</td>"), 1u);
  EXPECT_EQ(count(html, "<td>x</td>"), 1u);
}

TEST(Page, APlaceIsNotBrokenInTheHeading) {
  const std::string html = Page("backlash on link 1-0, 20-fold", "k", "").finish();
  EXPECT_EQ(count(html, "<h1>backlash on link 1&#8209;0, 20-fold</h1>"), 1u);
  EXPECT_EQ(count(html, "<title>backlash on link 1-0, 20-fold</title>"), 1u);
}

TEST(Page, LegendStandsOncePerSection) {
  Page page("t", "k", "");
  page.section("a", "A", "");
  page.figures({plot("y"), plot("y")});
  page.figures({plot("y")});
  EXPECT_EQ(count(page.finish(), "<ul class=\"legend\">"), 1u);
}

}  // namespace
