#include "host_sim/programs/shared/failures.hpp"

#include <cstdio>
#include <new>

#include "hal/rig_file/rig_file_error.hpp"
#include "host_sim/diagnosis/record/motion.hpp"
#include "host_sim/records/files/data_file_error.hpp"
#include "host_sim/records/files/output_file.hpp"
#include "host_sim/reports/page/report.hpp"

namespace host_sim {
namespace {

int say(ExitStatus status, const char* prefix, const char* message) {
  std::fprintf(stderr, "host_sim: %s%s\n", prefix, message);
  return static_cast<int>(status);
}

}  // namespace

int report_failure() noexcept {
  try {
    throw;
  } catch (const rig_file::RigFileError& error) {
    return say(ExitStatus::kBadInput, "", error.what());
  } catch (const DataFileError& error) {
    return say(ExitStatus::kBadInput, "", error.what());
  } catch (const UsageError& error) {
    return say(ExitStatus::kBadInput, "", error.what());
  } catch (const OutputError& error) {
    return say(ExitStatus::kBadInput, "", error.what());
  } catch (const CannotAnswer& error) {
    return say(ExitStatus::kCannotAnswer, "the data cannot answer: ", error.what());
  } catch (const diagnosis::CannotAnswer& error) {
    return say(ExitStatus::kCannotAnswer, "the data cannot answer: ", error.what());
  } catch (const std::bad_alloc&) {
    return say(ExitStatus::kOther, "out of memory: ", "give fewer or shorter records, or a lower --resample");
  } catch (const std::exception& error) {
    return say(ExitStatus::kOther, "internal error: ", error.what());
  } catch (...) {
    return say(ExitStatus::kOther, "internal error", "");
  }
}

}  // namespace host_sim
