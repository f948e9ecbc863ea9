// The script that zooms: dygraphs, a package of Debian's, put into the page as it is. Its licence (MIT) stands in its
// first line.
#pragma once

namespace host_sim::reports {

// Empty texts where the package was not there when this program was built: the pages then do not zoom.
const char* dygraphs_script();
const char* dygraphs_style();

}  // namespace host_sim::reports
