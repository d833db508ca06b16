// What can be saved, for the File menu and the dialog, and what the two dialogs about files remember.
#pragma once

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "app/panels/kit/widgets.h"
#include "app/session/action.h"

namespace app {

struct SaveKind {
  ExportKind kind;
  std::string_view words;   // "stitch map"
  std::string_view ending;  // of the suggested name: "-map.txt"
};

std::span<const SaveKind> save_kinds();

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
  std::optional<ExportKind> wanted;  // open for this
  bool shown = false;
  TextBuffer path;
};

}  // namespace app
