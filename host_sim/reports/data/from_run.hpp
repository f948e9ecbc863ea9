// What `host_sim run` leaves behind, as the data of its report.
#pragma once
#include "host_sim/reports/data/report_data.hpp"
#include "host_sim/reports/data/run_report_data.hpp"
#include "host_sim/virtual_rig/run_scenario.hpp"

namespace host_sim::reports {

// Keeps every estimate as the windows close and passes everything on to another sink.
class ConvergenceRecorder : public ProgressSink {
 public:
  explicit ConvergenceRecorder(ProgressSink& next) : next_(next) {}
  void begin(const Scenario& scenario, const firmware::CoreConfiguration& configuration) override;
  void progress(double share) override { next_.progress(share); }
  void frame(const hal::CanFrame& frame) override { next_.frame(frame); }
  void window(uint64_t time_ns, const firmware::Estimates& estimates, const firmware::CoreHealth& health,
              bool last) override;
  // One per unknown.
  const std::vector<Convergence>& convergence() const { return convergence_; }

 private:
  ProgressSink& next_;
  std::vector<Convergence> convergence_;
};

RunReportData run_report_data(const Scenario& scenario, uint64_t seed, const RunResult& result,
                              const std::vector<Convergence>& convergence);

}  // namespace host_sim::reports
