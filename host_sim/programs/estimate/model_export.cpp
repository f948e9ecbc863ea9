#include "host_sim/programs/estimate/model_export.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "host_sim/ingestion/mat/mat_library.hpp"
#include "host_sim/records/files/output_file.hpp"
#include "host_sim/response/linear_rig.hpp"

namespace host_sim {
namespace {

namespace fs = std::filesystem;
using nlohmann::ordered_json;
using Matrix = std::vector<std::vector<double>>;

Matrix rows_of(const Eigen::MatrixXd& m) {
  Matrix out(static_cast<size_t>(m.rows()));
  for (Eigen::Index r = 0; r < m.rows(); ++r)
    for (Eigen::Index c = 0; c < m.cols(); ++c) out[static_cast<size_t>(r)].push_back(m(r, c));
  return out;
}

// Everything that both files hold, by name.
struct Export {
  std::vector<std::string> names, units, status;
  std::vector<std::pair<std::string, Matrix>> matrices;
};

Export gather(const rig_file::RigModel& model, const EstimateResult& result, const std::vector<UncertainMode>& modes) {
  Export out;
  Matrix values, standard;
  for (const ParameterResult& p : result.parameters) {
    out.names.push_back(p.info.name);
    out.units.push_back(p.info.unit);
    out.status.push_back(status_word(p.status));
    values.push_back({p.value, p.std, p.ci95_low, p.ci95_high});
  }
  out.matrices.emplace_back("parameter_value_std_low_high", values);
  out.matrices.emplace_back("covariance", result.covariance);
  Matrix frequency, damping, real, imaginary;
  for (const UncertainMode& mode : modes) {
    frequency.push_back({mode.frequency_Hz.value, mode.frequency_Hz.low, mode.frequency_Hz.high});
    damping.push_back({mode.damping_ratio.value, mode.damping_ratio.low, mode.damping_ratio.high});
    real.emplace_back();
    imaginary.emplace_back();
    for (const std::complex<double>& value : mode.shape) {
      real.back().push_back(value.real());
      imaginary.back().push_back(value.imag());
    }
  }
  out.matrices.emplace_back("natural_frequency_Hz_value_low_high", frequency);
  out.matrices.emplace_back("damping_ratio_value_low_high", damping);
  out.matrices.emplace_back("mode_shape_real", real);
  out.matrices.emplace_back("mode_shape_imaginary", imaginary);
  if (modes.empty()) return out;  // without masses there is no state space
  const StateSpace space = state_space(linear_rig(rig_file::with_values(model, values_of(result))));
  out.matrices.emplace_back("A", rows_of(space.a));
  out.matrices.emplace_back("B", rows_of(space.b));
  out.matrices.emplace_back("C", rows_of(space.c));
  out.matrices.emplace_back("D", rows_of(space.d));
  return out;
}

void write_json(const fs::path& path, const std::string& name, const Export& all) {
  ordered_json json = {{"schema", "model/1"},
                       {"rig", name},
                       {"parameter_names", all.names},
                       {"parameter_units", all.units},
                       {"parameter_status", all.status}};
  for (const auto& [key, matrix] : all.matrices) json[key] = matrix;
  write_output_file(path.string(), json.dump(1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n");
}

void put_matrix(const MatLibrary& mat, mat_t* file, const std::string& name, const Matrix& rows) {
  size_t size[2] = {rows.size(), rows.empty() ? 0 : rows.front().size()};
  std::vector<double> by_columns;
  for (size_t c = 0; c < size[1]; ++c)
    for (size_t r = 0; r < size[0]; ++r) by_columns.push_back(rows[r][c]);
  matvar_t* variable = mat.make_variable(name.c_str(), MAT_C_DOUBLE, MAT_T_DOUBLE, 2, size, by_columns.data(), 0);
  mat.write(file, variable, MAT_COMPRESSION_NONE);
  mat.free(variable);
}

void put_words(const MatLibrary& mat, mat_t* file, const std::string& name, const std::vector<std::string>& words) {
  size_t size[2] = {words.size(), 1};
  matvar_t* cells = mat.make_variable(name.c_str(), MAT_C_CELL, MAT_T_CELL, 2, size, nullptr, 0);
  for (size_t i = 0; i < words.size(); ++i) {
    size_t length[2] = {1, words[i].size()};
    std::string text = words[i];
    mat.set_cell(cells, static_cast<int>(i),
                 mat.make_variable(nullptr, MAT_C_CHAR, MAT_T_UINT8, 2, length, text.data(), 0));
  }
  mat.write(file, cells, MAT_COMPRESSION_NONE);
  mat.free(cells);
}

// Under a temporary name first, so that a full disk leaves no half of a file.
void write_mat(const fs::path& path, const Export& all) {
  const fs::path temporary = path.string() + ".part";
  const MatLibrary* const mat = mat_library();
  if (mat == nullptr) throw OutputError(path.string() + ": " + kNoMatLibrary);
  mat_t* file = mat->create(temporary.c_str(), "MATLAB 5.0 MAT-file", MAT_FT_MAT5);
  if (file == nullptr) throw OutputError(path.string() + ": cannot be written");
  put_words(*mat, file, "parameter_names", all.names);
  put_words(*mat, file, "parameter_units", all.units);
  put_words(*mat, file, "parameter_status", all.status);
  for (const auto& [name, matrix] : all.matrices) put_matrix(*mat, file, name, matrix);
  std::error_code failure;
  if (mat->close(file) != 0) failure = std::make_error_code(std::errc::io_error);
  if (!failure) fs::rename(temporary, path, failure);
  if (!failure) return;
  fs::remove(temporary, failure);
  throw OutputError(path.string() + ": cannot be written");
}

std::string response_csv(const reports::ResponseView& view) {
  std::string out = "frequency_Hz,measured,simulated,coherence\n";
  for (size_t k = 0; k < view.frequency_Hz.size(); ++k) {
    out += fmt::format("{:.9g},{:.9g},", view.frequency_Hz[k], view.measured[k]);
    if (k < view.simulated.size()) out += fmt::format("{:.9g}", view.simulated[k]);
    out += fmt::format(",{:.9g}\n", view.coherence[k]);
  }
  return out;
}

}  // namespace

void export_model(const std::string& directory, const rig_file::RigModel& model, const EstimateResult& result,
                  const std::vector<UncertainMode>& modes, const reports::RigViews& views) {
  std::error_code failure;
  fs::create_directories(directory, failure);
  if (failure) throw OutputError(directory + ": expected a folder, or a place to make one (" + failure.message() + ")");
  const fs::path folder(directory);
  const Export all = gather(model, result, modes);
  write_json(folder / "model.json", model.name, all);
  write_mat(folder / "model.mat", all);
  for (size_t i = 0; i < views.responses.size(); ++i)
    write_output_file((folder / ("response_" + std::to_string(i + 1) + ".csv")).string(),
                      response_csv(views.responses[i]));
}

}  // namespace host_sim
