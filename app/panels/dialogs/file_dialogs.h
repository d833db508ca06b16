// What the two dialogs about files remember.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "app/files/export.h"
#include "app/panels/kit/widgets.h"

namespace app {

struct OpenDialog {
  struct Entry {
    std::string name;
    bool folder = false;
  };
  bool shown = false;
  std::filesystem::path folder;
  std::vector<Entry> entries;
  std::string trouble;  // why the folder cannot be read, or the path not opened
  int chosen = -1;      // by the arrow keys or a click; else what is typed counts
  int field = 0;        // changes when the field is emptied from outside
  bool refocus = false;
  TextBuffer path;
};

struct SaveDialog {
  const ExportInfo* wanted = nullptr;  // open for this; null: for none
  bool shown = false;
  TextBuffer path;
};

}  // namespace app
