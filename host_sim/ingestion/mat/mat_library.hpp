// libmatio, loaded when the first MAT file is opened: with what it needs itself (HDF5, and through that some thirty libraries) it
// takes longer to load than everything else that a command starts with.
#pragma once
#include <matio.h>

namespace host_sim {

// Its functions, under shorter names.
struct MatLibrary {
  decltype(&::Mat_LogInitFunc) log_to;
  decltype(&::Mat_Open) open;
  decltype(&::Mat_CreateVer) create;
  decltype(&::Mat_Close) close;
  decltype(&::Mat_VarReadNext) read_next;
  decltype(&::Mat_VarGetNumberOfFields) field_count;
  decltype(&::Mat_VarGetStructFieldnames) field_names;
  decltype(&::Mat_VarGetStructFieldByIndex) field;
  decltype(&::Mat_VarCreate) make_variable;
  decltype(&::Mat_VarSetCell) set_cell;
  decltype(&::Mat_VarWrite) write;
  decltype(&::Mat_VarFree) free;
  // uncompress() of the zlib that comes with it; nullptr where it has none. With too little room it fills that.
  int (*unpack)(unsigned char* to, unsigned long* room, const unsigned char* from, unsigned long bytes);
};

// nullptr where this machine has none. From any thread.
const MatLibrary* mat_library();
// What to say then.
extern const char* const kNoMatLibrary;

}  // namespace host_sim
