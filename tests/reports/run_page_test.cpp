// The pages of a run and of an estimate as a reader gets them: complete and offline.
#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "host_sim/reports/figures/figure_csv.hpp"
#include "host_sim/reports/figures/range.hpp"
#include "host_sim/reports/page/report.hpp"
#include "host_sim/reports/sections/run_pictures.hpp"
#include "tests/reports/made_up.hpp"
#include "tests/reports/page_parts.hpp"

namespace {

using namespace host_sim::reports;
using page_parts::contains;
using page_parts::expect_offline;
using page_parts::own_part;

TEST(RunPage, HasEveryPart) {
  const std::string page = run_page(made_up::run());
  expect_offline(page);
  for (const char* id : {"estimates", "convergence", "signals", "accelerations"})
    EXPECT_TRUE(contains(page, std::string("<h2 id=\"") + id + "\"")) << id;
  EXPECT_TRUE(contains(page, "5 of 5 true values lie inside their 95 % interval"));
  EXPECT_TRUE(contains(page, "first cycles of every force, and of each DOF's displacement"));
}

// A spring of 2 N/mm beside a damper: 4 x 4 cells of which one was never visited.
RigViews made_up_views() {
  RigViews views;
  ResponseView response{
      "acceleration of DOF 1 per force on DOF 1", "acceleration per force", "m/s^2/N", {}, {}, {}, {}, 9};
  for (int k = 1; k <= 200; ++k) {
    response.frequency_Hz.push_back(k);
    response.measured.push_back(1.0 / k);
    response.simulated.push_back(1.1 / k);
    response.coherence.push_back(k <= 50 ? 0.99 : 0.1);
  }
  views.responses = {response};
  views.modes = {{{9.8, 9.7, 9.9}, {0.0617, 0.0612, 0.0622}, {1.0, -0.5}}};
  ForceStateMap map;
  map.link = "1-0";
  map.columns = map.rows = 4;
  map.elongation_low = map.rate_low = -1e-3;
  map.elongation_high = map.rate_high = 1e-3;
  for (int cell = 0; cell < 16; ++cell) map.measured.push_back(cell == 5 ? NAN : 2e-3 * (cell % 4) - 3e-3);
  map.model = map.measured;
  views.maps = {map};
  views.residuals = {{1, "N", response.frequency_Hz, response.measured, response.simulated}};
  views.notes = {"no <displacement> sensor"};
  return views;
}

// The first window says 1000 +- 500, the later ones 20 +- 1: the frame shows 19 to 21 with three tenths of these 2 as air on both sides,
// and the first lies outside it, where the data of the picture have it as it was.
TEST(Convergence, WhatLeavesTheFrameIsNotMovedIntoIt) {
  RunParameter parameter{"viscous[1-0]", "N s/m", "VALID", 20.0, {20.0, 19.0, 21.0}, {}};
  for (int window = 0; window < 4; ++window) {
    const double value = window == 0 ? 1000.0 : 20.0, half = window == 0 ? 500.0 : 1.0;
    parameter.convergence.time_s.push_back(window);
    parameter.convergence.value.push_back(value);
    parameter.convergence.low.push_back(value - half), parameter.convergence.high.push_back(value + half);
  }
  const Plot plot = convergence_picture(parameter);
  EXPECT_DOUBLE_EQ(plot.curves[1].y[0], 1000.0);
  EXPECT_DOUBLE_EQ(plot.curves[0].y[0], 500.0);
  EXPECT_DOUBLE_EQ(plot.curves[0].y_high[0], 1500.0);
  EXPECT_DOUBLE_EQ(y_range(plot).low, 18.4);
  EXPECT_DOUBLE_EQ(y_range(plot).high, 21.6);
  EXPECT_TRUE(contains(figure_csv(plot), "\nestimate,0,1000,\n")) << figure_csv(plot);
}

// A rig that could not be simulated is not said to be: its pictures are of forces.
TEST(EstimatePage, SaysWhetherItSimulated) {
  EstimateReportData data;
  data.dofs = made_up::diagnosis(3000).dofs;
  EXPECT_TRUE(contains(own_part(estimate_page(data)), "simulated freely under the measured force"));
  data.free = false;
  const std::string page = own_part(estimate_page(data));
  EXPECT_FALSE(contains(page, "simulated freely"));
  EXPECT_TRUE(contains(page, "not simulated: the measured force beside the one that it needs"));
}

TEST(EstimatePage, HasEveryPart) {
  EstimateReportData data;
  data.rig_name = "rig & more";
  data.files = {"a.csv"};
  data.parameters = {{"viscous[1-0]", "N s/m", {NAN, NAN, NAN}, {20.0, 19.8, 20.2}, "VALID"},
                     {"coulomb[1-0]", "N", {NAN, NAN, NAN}, {1.0, 0.2, 1.8}, "ILL_CONDITIONED"}};
  data.advice = {"Add a second level."};
  data.dofs = made_up::diagnosis(3000).dofs;
  data.views = made_up_views();
  const std::string page = estimate_page(data);
  expect_offline(page);
  for (const char* id : {"estimates", "advice", "waveforms", "modes", "responses", "maps", "residuals"})
    EXPECT_TRUE(contains(page, std::string("<h2 id=\"") + id + "\"")) << id;
  EXPECT_TRUE(contains(page, "<h1>1 of 2 coefficients are valid</h1>"));
  EXPECT_TRUE(contains(page, "Average of 9 segments"));
  EXPECT_TRUE(contains(page, "full depth is 3.00 mN"));
  EXPECT_TRUE(contains(page, "no &lt;displacement&gt; sensor"));
  EXPECT_FALSE(contains(own_part(page), "nan"));
}

// Maps and residuals are of one record: which, is said where there are several.
TEST(EstimatePage, MapsAndResidualsNameTheirRecord) {
  EstimateReportData data;
  data.views = made_up_views();
  EXPECT_FALSE(contains(estimate_page(data), "the first of"));
  data.views.one_record = "level_1.csv, the first of 3 records";
  const std::string page = own_part(estimate_page(data));
  EXPECT_TRUE(contains(page, "at an elongation. Of level_1.csv, the first of 3 records."));
  EXPECT_TRUE(contains(page, "accelerates it). Of level_1.csv, the first of 3 records."));
}

// Coherent up to 50 Hz: the running mean over 16 bins falls below a half some 8 bins later, and an eighth is added.
TEST(EstimatePage, AResponseEndsWhereNothingDrives) {
  EstimateReportData data;
  data.views = made_up_views();
  const std::string page = estimate_page(data);
  EXPECT_TRUE(contains(page, ">60</text>"));
  EXPECT_FALSE(contains(page.substr(0, page.find("id=\"maps\"")), ">100</text>"));
}

// What is said of one record among several stands at its name, not at that of all.
TEST(EstimatePage, AFindingOfOneRecordStandsAtItsName) {
  EstimateReportData data;
  host_sim::data_check::Report check;
  check.records.resize(2);
  check.records[0].file = "some/a.csv", check.records[1].file = "some/b.csv";
  check.findings = {{"excitation", host_sim::data_check::Weight::kInforms, "", "some/b.csv: force_1_N: 3 N rms", {}},
                    {"unlike", host_sim::data_check::Weight::kDoubt, "", "some/b.csv lacks force_1_N", {}},
                    {"level", host_sim::data_check::Weight::kInforms, "", "one level", {}}};
  data.check = check;
  const std::string page = own_part(estimate_page(data));
  EXPECT_TRUE(contains(page, "<td>b.csv</td><td>excitation</td><td><span class=\"sentence\">force_1_N: 3 N rms"));
  EXPECT_TRUE(contains(page, "<td>b.csv</td><td>unlike</td>"));
  EXPECT_TRUE(contains(page, "<td>all records</td><td>level</td>"));
}

}  // namespace
