// Time records on their way into the page.
#include "host_sim/reports/zoom/zoom.hpp"

#include <gtest/gtest.h>

namespace {

using namespace host_sim::reports;

// -32767 is 0x8001, 0 is 0x0000, 32767 is 0x7FFF; little endian 01 80 00 00 FF 7F, in base 64 "AYAA" "AP9/".
TEST(Zoom, ValuesArePackedInSixteenBits) {
  EXPECT_EQ(packed({-2.0, 0.0, 2.0}, -2.0, 2.0), "AYAAAP9/");
  EXPECT_EQ(packed({-2.0}, -2.0, 2.0), "AYA=");
  EXPECT_EQ(packed({-2.0, -2.0}, -2.0, 2.0), "AYABgA==");
}

// Two bins of three: (1, 5, 2) and (4, 0, 3). In the first the smallest comes before the largest, in the second after.
TEST(Zoom, LongRecordsKeepTheirExtremes) {
  EXPECT_EQ(thinned({1, 5, 2, 4, 0, 3}, 2), (std::vector<double>{1, 5, 4, 0}));
  EXPECT_EQ(thinned({1, 5, 2, 4}, 2), (std::vector<double>{1, 5, 2, 4}));
}

TEST(Zoom, AViewBecomesARecordWithWhatIsThere) {
  DofView view;
  view.dof = 2;
  view.waveforms.push_back({"displacement", "m", {1, 2}, {1, 1}, {}, ""});
  const std::vector<DofView> views = {view};
  const auto records = zoom_records(views);
  ASSERT_EQ(records.size(), 1u);
  EXPECT_EQ(records[0].title, "DOF 2 displacement");
  ASSERT_EQ(records[0].curves.size(), 2u);
  EXPECT_EQ(records[0].curves[1].label, "rig as given");
}

TEST(Zoom, ATitleCannotEndTheScript) {
  const std::vector<double> values = {0.0, 1.0};
  ZoomRecord record{"</script>", "x", "m", 0.0, 1.0, {{"one", Role::kMeasured, &values}}};
  Page page("t", "k", "");
  add_zoom(page, {record});
  EXPECT_EQ(page.finish().find("\"title\":\"</script>\""), std::string::npos);
}

// The errors' axis takes the unit at the end of the quantity's name: "error (mm)".
TEST(Zoom, TheErrorsHaveTheUnitOfTheSignal) {
  const std::vector<double> values = {0.0, 1.0};
  Page page("t", "k", "");
  add_zoom(page, {{"DOF 1", "displacement", "m", 0.0, 1.0, {{"one", Role::kMeasured, &values}}}});
  const std::string html = page.finish();
  EXPECT_NE(html.find("\"quantity\":\"displacement (m)\""), std::string::npos);
  EXPECT_NE(html.find("'error' + record.quantity.slice(record.quantity.lastIndexOf(' ('))"), std::string::npos);
}

}  // namespace
