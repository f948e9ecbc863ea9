// Pieces of a page.
#include "host_sim/reports/page/page.hpp"

#include <gtest/gtest.h>

#include "tests/reports/one_curve.hpp"

namespace {

using namespace one_curve;

TEST(Page, TextIsEscaped) { EXPECT_EQ(escaped("a<b> & \"c\" 'd'"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39;"); }

TEST(Page, TableMarksNumericColumns) {
  const std::string html = table_html({{"name", "value"}, {false, true}, {{"x", "1"}}});
  EXPECT_EQ(count(html, "<td class=\"n\">1</td>"), 1u);
  EXPECT_EQ(count(html, "<td>x</td>"), 1u);
}

TEST(Page, APlaceIsNotBrokenInTheHeading) {
  const std::string html = Page("backlash on link 1-0, 20-fold", "k", "").finish();
  EXPECT_EQ(count(html, "<h1>backlash on link&nbsp;1&#8209;0, 20-fold</h1>"), 1u);
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
