// The tables of the documentation that list effects, written from the vocabulary's rows.
#pragma once
#include <string>

namespace vocabulary {

std::string rig_file_table();  // how a rig file writes each effect
std::string effects_table();   // what each is, who estimates it, which experiment sets it apart

// The page with everything between its marker lines written anew:
//   <!-- generated from firmware/vocabulary by vocabulary_page: rig_file_table -->
//   <!-- end of the generated part -->
// Empty where it has no such lines, or names a table that does not exist.
std::string renewed_page(const std::string& page);

}  // namespace vocabulary
