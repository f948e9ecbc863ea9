// The worked examples of docs/examples_measured.md: real rigs, what their rig files leave out, and what came of it.
#pragma once
#include <string>
#include <vector>

namespace examples {

struct Example {
  std::string name;  // of its pictures: "emps"
  std::string title;
  std::string rig;                         // below DOCS_DIR/examples
  std::vector<std::string> data, holdout;  // below RECORDINGS_DIR
  std::string introduction;                // Markdown
  std::string source;                      // Markdown: where the recording is published
  std::string conversion;  // command that makes the files of it, without "python3 docs/examples/convert.py"
  std::string reading;     // Markdown, below the numbers: what others published; no figure of our own stands here
};

const std::vector<Example>& all();

}  // namespace examples
