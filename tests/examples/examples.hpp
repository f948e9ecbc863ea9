// The worked examples of docs/examples_measured.md: real rigs, what their rig files leave out, and what came of it.
#pragma once
#include <string>
#include <vector>

namespace examples {

struct Example {
  std::string name;  // of its pictures: "emps"
  std::string title;
  std::string rig;                         // below SHARED_DIR/contract
  std::vector<std::string> data, holdout;  // below SHARED_DIR/measured
  std::string introduction;                // Markdown
  std::string reading;  // Markdown, below the numbers: what others published; no figure of our own stands here
};

const std::vector<Example>& all();

}  // namespace examples
