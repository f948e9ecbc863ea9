// report_preview DIAGNOSIS_DIR RUN_DIR: both pages with made-up data.
#include <cstdio>
#include <exception>

#include "host_sim/reports/page/report.hpp"
#include "tests/reports/made_up.hpp"

int main(int count, char** arguments) {
  if (count != 3) {
    std::fputs("report_preview DIAGNOSIS_DIR RUN_DIR\n", stderr);
    return 2;
  }
  try {
    host_sim::reports::write_diagnosis_report(arguments[1], made_up::diagnosis());
    host_sim::reports::write_run_report(arguments[2], made_up::run());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
  return 0;
}
