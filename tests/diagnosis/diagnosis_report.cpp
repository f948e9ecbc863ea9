// development bench: lines of draws
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

#include "draw.hpp"
#include "host_sim/diagnosis/diagnosis.hpp"

int main(int argc, char** argv) {
  hidden::Settings s;
  uint64_t seed = 1000000;
  int count = 20;
  bool verbose = false;
  for (int i = 1; i + 1 < argc; i += 2) {
    const std::string k = argv[i], v = argv[i + 1];
    if (k == "noise") s.noise = atof(v.c_str());
    if (k == "n") count = atoi(v.c_str());
    if (k == "seed") seed = strtoull(v.c_str(), 0, 10);
    if (k == "sensors") s.sensors = v;
    if (k == "corner") s.noise_corner_Hz = atof(v.c_str());
    if (k == "bits") s.bits = atoi(v.c_str());
    if (k == "kind") s.kind = v;
    if (k == "lo") s.rho_low = atof(v.c_str());
    if (k == "hi") s.rho_high = atof(v.c_str());
    if (k == "dofs") s.dofs = atoi(v.c_str());
    if (k == "seconds") s.seconds = atof(v.c_str());
    if (k == "v") verbose = v == "1";
    if (k == "hide") s.hide = v == "none" ? hidden::Hide::kNothing : v == "one" ? hidden::Hide::kOne : v == "two" ? hidden::Hide::kTwo : v == "outside" ? hidden::Hide::kOutside : hidden::Hide::kSensorFault;
  }
  int exact = 0, in_set = 0;
  double t_gen = 0, t_diag = 0, t_max = 0;
  std::map<std::string, int> verdicts;
  for (int i = 0; i < count; ++i) {
    const auto t0 = std::chrono::steady_clock::now();
    const hidden::Draw draw = hidden::make_draw(seed + static_cast<uint64_t>(i), s);
    const auto t1 = std::chrono::steady_clock::now();
    diagnosis::Diagnosis d;
    try { d = diagnosis::diagnose(draw.rig, {draw.record}, {}); } catch (const std::exception& e) { printf("seed %d: %s\n", i, e.what()); continue; }
    const auto t2 = std::chrono::steady_clock::now();
    t_gen += std::chrono::duration<double>(t1 - t0).count();
    const double td = std::chrono::duration<double>(t2 - t1).count();
    t_diag += td; if (td > t_max) t_max = td;
    std::string verdict = diagnosis::verdict_word(d.verdict);
    ++verdicts[verdict];
    size_t hit = 0;
    for (const auto& t : draw.truth)
      for (const auto& c : d.causes) hit += c.effect == t.effect && c.where == t.where;
    size_t hit_set = hit;
    for (const auto& t : draw.truth)
      for (const auto& c : d.ambiguous_with) hit_set += c.effect == t.effect && c.where == t.where;
    bool ok, set = false;
    if (s.hide == hidden::Hide::kOutside) ok = verdict == "unknown";
    else if (draw.truth.empty()) ok = verdict == "none";
    else {
      ok = hit == draw.truth.size() && d.causes.size() == hit && verdict == "explained";
      set = !ok && verdict == "ambiguous" && hit_set == draw.truth.size() && d.causes.size() == draw.truth.size();
    }
    exact += ok; in_set += set;
    if (!ok || verbose) {
      printf("%s %lu n=%zu %s base %.3f ext %.3f | truth", ok ? "ok  " : set ? "SET " : "MISS", seed + static_cast<uint64_t>(i), draw.rig.dofs.size(), verdict.c_str(), d.baseline_misfit, d.extended_misfit);
      for (size_t j = 0; j < draw.truth.size(); ++j) { const auto& t = draw.truth[j]; printf(" %s@%s rho %.3f", t.effect == "outside" ? draw.true_rig.effects[j].kind.c_str() : t.effect.c_str(), t.where.c_str(), t.rho); if (j < draw.true_rig.effects.size()) printf(" (%.4g; %.4g)", t.strength, draw.true_rig.effects[j].shape); }
      printf(" | found");
      for (const auto& c : d.causes) { printf(" %s@%s %.0f (", c.effect.c_str(), c.where.c_str(), c.significance); for (const auto& p : c.parameters) printf(" %.4g", p.value); printf(" )"); }
      if (!d.ambiguous_with.empty()) printf(" | with");
      for (const auto& c : d.ambiguous_with) printf(" %s@%s", c.effect.c_str(), c.where.c_str());
      printf("\n");
    }
    fflush(stdout);
  }
  printf("exact %d set %d of %d; gen %.2f s, diag %.2f s mean, %.2f max;", exact, in_set, count, t_gen / count, t_diag / count, t_max);
  for (const auto& v : verdicts) printf(" %s %d", v.first.c_str(), v.second);
  printf("\n");
}
