#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "core_run.hpp"
#include "firmware/warrant/verdict/verdict.hpp"
#include "hal/rig_file/scaled_double.hpp"

using rig_file::to_double;
static const char* const kForms[] = {"u",   "u2", "u3", "gap", "stop", "1", "w",    "w|w|", "w3",   "|w|",
                                     "u2w", "s",  "sn", "sw",  "s|u|", "a", "jerk", "f",    "frate"};

int main(int argc, char** argv) {
  CLI::App app;
  hidden_rig::Settings s;
  int first = 1, count = 10;
  unsigned budget = firmware::kAllProbes;
  bool verbose = false;
  app.add_option("--condition", s.condition);
  app.add_option("--sensors", s.sensors);
  app.add_option("--hidden", s.hidden);
  app.add_option("--masses", s.masses);
  app.add_option("--first", first);
  app.add_option("--count", count);
  app.add_option("--budget", budget);
  app.add_flag("-v", verbose);
  CLI11_PARSE(app, argc, argv);
  int bad_before = 0, bad_after = 0, flagged = 0, valid = 0, total = 0, named = 0;
  for (int seed = first; seed < first + count; ++seed) {
    hidden_rig::Draw draw;
    try {
      draw = hidden_rig::make_draw(static_cast<uint64_t>(seed), s);
    } catch (std::exception& e) {
      std::printf("%s\n", e.what());
      continue;
    }
    auto run = warrant_test::run_core(draw, static_cast<uint16_t>(budget));
    const auto& est = run.core->estimates();
    const auto& test = run.core->score_tests().test();
    const auto& plan = run.core->score_tests().sums().plan();
    int wrong = 0, wrong_any = 0;
    std::string text;
    for (int k = 0; k < est.unknown_count; ++k) {
      const auto& p = est.parameters[k];
      const double v = to_double(p.value), sd = to_double(p.std), t = draw.coefficients[k].value;
      ++total;
      const bool ok = p.status == firmware::EstimateStatus::kValid;
      valid += ok;
      const bool w = std::fabs(v - t) > 0.05 * std::fabs(t) && std::fabs(v - t) > 4 * sd;
      if (ok && w) ++wrong;
      if (w) ++wrong_any;
      char b[200];
      std::snprintf(b, sizeof b, " %s=%.3g/%.3g(%d)%s[%.3f;%.3f+-%.3f]", draw.coefficients[k].name.c_str(), v, t,
                    (int)p.status, w ? "!" : "", to_double(test.rate_kurtosis(0)), to_double(test.of(k).difference) / v,
                    to_double(test.of(k).difference_std) / v);
      text += b;
    }
    std::string hid;
    for (auto& h : draw.hidden) hid += h.effect + " " + h.where + " ";
    if (wrong_any) ++bad_before;
    const bool suspect = test.best() >= 0;
    flagged += suspect;
    if (wrong) ++bad_after;
    std::printf("%d [%s] stretches %d probes %d values %d%s%s\n", seed, hid.c_str(),
                run.core->score_tests().sums().table().stretches(), plan.probe_count, plan.value_count,
                wrong ? " WRONG" : "", text.c_str());
    auto show = [&](int j) {
      const auto& q = plan.probe[j];
      const auto& pl = plan.place[q.place];
      const auto& r = test.score(j);
      std::printf("    %s%d-%d %s: wald %.2f nu %.1f effect %.4g +- %.3g gain %.0f%s\n",
                  pl.kind == firmware::PlaceKind::kDof    ? "dof "
                  : pl.kind == firmware::PlaceKind::kLink ? "link "
                                                          : "nolink ",
                  pl.node_a + 1, pl.node_b == 17 ? 0 : pl.node_b + 1, kForms[(int)q.form], to_double(r.wald),
                  to_double(r.freedom), to_double(r.effect), to_double(r.std), to_double(r.gain),
                  r.flagged ? " FLAG" : "");
    };
    if (verbose)
      for (int j = plan.base_count; j < plan.probe_count; ++j) show(j);
    if (suspect) {
      show(test.best());
      if (test.rival() >= 0) show(test.rival());
    }
    (void)named;
  }
  std::printf("flagged %d of %d, wrong before %d after %d, valid %d of %d\n", flagged, count, bad_before, bad_after,
              valid, total);
}
