// Pieces of a page, and gnuplot as a child process.
#include "host_sim/reports/page.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>

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

// The largest value is 0.002 m, so the axis is in mm; the name of a parameter is text, not gnuplot's markup.
TEST(Draw, AxesCarryLabelsAndUnits) {
  const std::vector<std::string> pictures = draw({plot("viscous_{1}^2"), plot("y")}, Target::kPage);
  ASSERT_EQ(pictures.size(), 2u);
  EXPECT_EQ(count(pictures[0], "time (s)"), 1u);
  EXPECT_EQ(count(pictures[0], "viscous_{1}^2 (mm)"), 1u);
  EXPECT_EQ(count(pictures[0], "var(--given)"), 1u);
}

TEST(Draw, AStandalonePictureHasItsOwnColoursTitleAndLegend) {
  const std::string picture = draw({plot("y")}, Target::kStandalone).at(0);
  EXPECT_EQ(count(picture, "var(--"), 0u);
  EXPECT_GE(count(picture, "#cf5a0c"), 1u);
  EXPECT_EQ(count(picture, ">one</text>"), 1u);
  EXPECT_EQ(count(picture, ">a 'title'</text>"), 1u);
  EXPECT_EQ(count(picture, "xmlns=\"http://www.w3.org/2000/svg\""), 1u);
}

TEST(Draw, DataWithoutFiniteNumbersStillDraws) {
  Plot empty = plot("y");
  empty.curves[0].y = {NAN, NAN, NAN};
  Plot none = plot("y");
  none.curves.clear();
  EXPECT_EQ(draw({empty, none}, Target::kPage).size(), 2u);
}

// Values that agree to nine digits, as the last estimates of a clean run do.
TEST(Draw, ValuesThatHardlyDifferStillDraw) {
  Plot narrow = plot("y");
  narrow.curves[0].y = {4.0, 4.000000001, 4.000000002};
  Plot constant = plot("y");
  constant.curves[0].y = {4.0, 4.0, 4.0};
  EXPECT_EQ(draw({narrow, constant}, Target::kPage).size(), 2u);
}

TEST(Gnuplot, ItsOwnMessageIsPassedOn) {
  try {
    run_gnuplot("plot nonsense(\n");
    FAIL() << "expected an error";
  } catch (const DrawingError& error) {
    EXPECT_NE(std::string(error.what()).find("gnuplot failed"), std::string::npos);
  }
}

TEST(Gnuplot, MissingIsSaidWithThePackageToInstall) {
  const std::string path = std::getenv("PATH");
  setenv("PATH", "/nonexistent", 1);
  std::string message;
  try {
    run_gnuplot("");
  } catch (const DrawingError& error) {
    message = error.what();
  }
  setenv("PATH", path.c_str(), 1);
  EXPECT_NE(message.find("gnuplot-nox"), std::string::npos) << message;
}

}  // namespace
