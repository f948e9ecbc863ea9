// What the tests of pages look for in them.
#pragma once
#include <gtest/gtest.h>

#include <string>

#include "host_sim/reports/zoom/dygraphs.hpp"

namespace page_parts {

inline bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

// Without the library that zooms and its packed numbers.
inline std::string own_part(std::string page) {
  for (const std::string library : {host_sim::reports::dygraphs_script(), host_sim::reports::dygraphs_style()})
    if (const size_t at = page.find(library); !library.empty() && at != std::string::npos)
      page.erase(at, library.size());
  const size_t from = page.find("id=\"zoom-records\">");
  if (from != std::string::npos) page.erase(from, page.find("</script>", from) - from);
  return page;
}

// Nothing that a browser would fetch: the script that zooms stands in the page (what it does is seen in the browser's
// test), the rest names no other place.
inline void expect_offline(const std::string& whole) {
  const std::string page = own_part(whole);
  for (const char* part : {"http:", "https:", "src=", "<link", "@import", "url("})
    EXPECT_FALSE(contains(page, part)) << part;
}

}  // namespace page_parts
