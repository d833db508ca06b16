// What can be saved, for the File menu and the dialog.
#pragma once

#include <span>
#include <string_view>

#include "app/session/action.h"

namespace app {

struct SaveKind {
  ExportKind kind;
  std::string_view words;   // "stitch map"
  std::string_view ending;  // of the suggested name: "-map.txt"
};

std::span<const SaveKind> save_kinds();

}  // namespace app
