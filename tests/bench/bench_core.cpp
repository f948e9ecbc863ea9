// bench_core [--json FILE] [--quick]: cost per sample of the fixed-point core and of what a user would write instead.
// All rows run in one process, repetitions interleaved at random, so that a change of the machine's speed hits all alike;
// the median of the repetitions is reported. The ratios are the result, the nanoseconds are this machine's.
#include <benchmark/benchmark.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <string>

#include "firmware/estimator_core.hpp"
#include "tests/bench/baselines.hpp"
#include "tests/bench/bench_rig.hpp"

namespace {

constexpr int kDofs[] = {1, 2, 3, 4, 8, 16};

void core(benchmark::State& state, int dofs, firmware::CoreDetail detail, uint16_t probe_products = 0) {
  const auto configuration = std::make_unique<firmware::CoreConfiguration>(bench::chain(dofs));
  configuration->probe_products_per_sample = probe_products;
  auto estimator = std::make_unique<firmware::EstimatorCore>(*configuration, detail);
  auto samples = bench::raw_samples(dofs);
  estimator->begin_level();
  uint32_t sequence = 0;
  // A measurement's first seconds close many short batches; what is timed is the state after two minutes at 1 kHz.
  for (int n = 0; n < 131072; ++n) {
    samples[0].sequence = sequence++;
    estimator->push(samples[0]);
  }
  for (auto _ : state)
    for (firmware::RawSample& sample : samples) {
      sample.sequence = sequence++;
      estimator->push(sample);
    }
  benchmark::DoNotOptimize(estimator->health().samples);
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * samples.size()));
}

template <typename Method>
void baseline(benchmark::State& state, int dofs) {
  Method method(dofs);
  const auto samples = bench::samples(dofs);
  for (auto _ : state) {
    for (const bench::Sample& sample : samples) method.step(sample);
    benchmark::ClobberMemory();
  }
  state.SetItemsProcessed(static_cast<int64_t>(state.iterations() * samples.size()));
}

// Keeps the repetitions of each row: nanoseconds of processor time per sample.
class Collector : public benchmark::BenchmarkReporter {
 public:
  bool ReportContext(const Context&) override { return true; }
  void ReportRuns(const std::vector<Run>& runs) override {
    for (const Run& run : runs)
      if (run.run_type == Run::RT_Iteration)
        times[run.run_name.function_name].push_back(1e9 / run.counters.at("items_per_second"));
  }
  std::map<std::string, std::vector<double>> times;
};

struct Result {
  std::string name;
  int dofs;
  double ns_per_sample;
};

void print_table(const std::vector<Result>& results) {
  const auto at = [&](const std::string& name, int dofs) {
    for (const Result& r : results)
      if (r.name == name && r.dofs == dofs) return r.ns_per_sample;
    return 0.0;
  };
  std::printf("ns per DOF and sample\n%4s %8s %10s %11s %13s %12s %16s %14s\n", "DOF", "core", "core_full",
              "double_rls", "double_batch", "double_sums", "double_rls/core", "core_full/core");
  for (int d : kDofs)
    std::printf("%4d %8.2f %10.2f %11.2f %13.2f %12.2f %16.1f %14.2f\n", d, at("core", d) / d, at("core_full", d) / d,
                at("double_rls", d) / d, at("double_batch", d) / d, at("double_sums", d) / d,
                at("double_rls", d) / at("core", d), at("core_full", d) / at("core", d));
  std::printf("core with score tests over core_full: default budget");
  for (int d : kDofs) std::printf(" %.2f", at("core_warrant", d) / at("core_full", d));
  std::printf("; all");
  for (int d : kDofs) std::printf(" %.2f", at("core_warrant_all", d) / at("core_full", d));
  std::printf("\n");
  std::printf("cost per sample of 16 DOF against 2 DOF: core %.2f, core_full %.2f\n", at("core", 16) / at("core", 2),
              at("core_full", 16) / at("core_full", 2));
}

bool write_json(const std::string& path, const std::vector<Result>& results) {
  const std::string part = path + ".part";
  std::ofstream out(part);
  out << "{\"schema\":\"bench/1\",\"rows\":[";
  for (size_t i = 0; i < results.size(); ++i)
    out << (i ? "," : "") << "\n{\"name\":\"" << results[i].name << "\",\"dof\":" << results[i].dofs
        << ",\"ns_per_sample\":" << results[i].ns_per_sample
        << ",\"ns_per_dof_sample\":" << results[i].ns_per_sample / results[i].dofs << "}";
  out << "\n]}\n";
  out.close();
  return out.good() && std::rename(part.c_str(), path.c_str()) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  std::string json;
  bool quick = false;
  for (int i = 1; i < argc; ++i) {
    if (!std::strcmp(argv[i], "--json") && i + 1 < argc) {
      json = argv[++i];
    } else if (!std::strcmp(argv[i], "--quick")) {
      quick = true;
    } else {
      const bool help = !std::strcmp(argv[i], "--help");
      (help ? std::cout : std::cerr) << "Usage: bench_core [--json FILE] [--quick]\n";
      return help ? 0 : 2;
    }
  }
  std::string options[] = {"bench_core", "--benchmark_enable_random_interleaving=true",
                           quick ? "--benchmark_repetitions=3" : "--benchmark_repetitions=9",
                           quick ? "--benchmark_min_time=0.005" : "--benchmark_min_time=0.03"};
  char* arguments[] = {options[0].data(), options[1].data(), options[2].data(), options[3].data()};
  int count = 4;
  benchmark::Initialize(&count, arguments);
  std::vector<std::pair<std::string, int>> order;
  for (int d : kDofs) {
    const auto add = [&](const char* name, auto function) {
      order.emplace_back(name, d);
      benchmark::RegisterBenchmark((std::string(name) + ":" + std::to_string(d)).c_str(), function);
    };
    add("core", [d](benchmark::State& s) { core(s, d, firmware::CoreDetail::kPlain); });
    add("core_full", [d](benchmark::State& s) { core(s, d, firmware::CoreDetail::kFull); });
    add("core_warrant",
        [d](benchmark::State& s) { core(s, d, firmware::CoreDetail::kFull, firmware::kDefaultProbes); });
    add("core_warrant_all",
        [d](benchmark::State& s) { core(s, d, firmware::CoreDetail::kFull, firmware::kAllProbes); });
    add("double_rls", [d](benchmark::State& s) { baseline<bench::RecursiveLeastSquares>(s, d); });
    add("double_batch", [d](benchmark::State& s) { baseline<bench::BatchLeastSquares>(s, d); });
    add("double_sums", [d](benchmark::State& s) { baseline<bench::EnergySumsInDouble>(s, d); });
  }
  Collector collector;
  benchmark::RunSpecifiedBenchmarks(&collector);
  std::vector<Result> results;
  for (const auto& [name, dofs] : order) {
    std::vector<double>& times = collector.times[name + ":" + std::to_string(dofs)];
    if (times.empty()) return 1;
    std::sort(times.begin(), times.end());
    results.push_back({name, dofs, times[times.size() / 2]});
  }
  print_table(results);
  if (!json.empty() && !write_json(json, results)) {
    std::cerr << "bench_core: " << json << " cannot be written\n";
    return 1;
  }
  return 0;
}
