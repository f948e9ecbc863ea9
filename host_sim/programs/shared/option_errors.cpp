#include "host_sim/programs/shared/option_errors.hpp"

#include <vector>

#include "hal/rig_file/toml/toml_checks.hpp"

namespace host_sim {
namespace {

std::vector<std::string> names_of_options(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options())
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  return names;
}

// The first word of what no option took that looks like one; negative numbers and "-" are values.
std::string unknown_option(const CLI::App& command) {
  for (const std::string& word : command.remaining())
    if (word.size() > 2 && word.compare(0, 2, "--") == 0) return word.substr(0, word.find('='));
  for (const std::string& word : command.remaining())
    if (word.size() > 1 && word[0] == '-' && std::isalpha(static_cast<unsigned char>(word[1]))) return word;
  return "";
}

}  // namespace

std::string option_error_text(const CLI::App& app, const CLI::ParseError& error) {
  const std::vector<const CLI::App*> chosen = app.get_subcommands([](const CLI::App* a) { return a->parsed() > 0; });
  const CLI::App& command = chosen.empty() ? app : *chosen.front();
  const std::string name = chosen.empty() ? "host_sim" : "host_sim " + command.get_name(),
                    unknown = unknown_option(command);
  std::string text = error.what();
  if (!unknown.empty()) {
    const std::string near = rig_file::nearest_word(unknown, names_of_options(command));
    text = unknown + " is no option of " + name + (near.empty() ? "" : ", did you mean " + near + "?");
  }
  return text + " (" + name + " --help lists the options)";
}

}  // namespace host_sim
