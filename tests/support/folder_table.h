// The table of folders of architecture_test: which may include which, and what from outside.
#pragma once

#include <set>
#include <string>
#include <vector>

namespace test_support {

using Strings = std::vector<std::string>;

// What a folder may include beside itself and the standard library. Folders stand in the order of the house: each
// may include only folders that stand before it, so there is no circle. "knit/" stands for all of knit's.
struct Arrow {
  std::string folder;
  Strings ours, outside;
};

inline const Strings json{"nlohmann/json.hpp", "nlohmann/json_fwd.hpp"};

inline const std::vector<Arrow> arrows{
    {"knit/base", {}, {}},
    {"knit/mesh", {"knit/base"}, {"glm/"}},
    {"knit/import", {"knit/base", "knit/mesh"}, {"glm/", "tiny_obj_loader.h"}},
    {"knit/curves", {"knit/base", "knit/mesh"}, {"glm/"}},
    {"knit/model", {"knit/base", "knit/mesh"}, {"glm/"}},
    {"knit/fabric", {"knit/mesh", "knit/model"}, {"glm/"}},
    {"knit/timing", {"knit/mesh", "knit/import", "knit/model"}, {"glm/", "Eigen/"}},
    {"knit/tubes", {"knit/mesh", "knit/import", "knit/model", "knit/fabric", "knit/timing"}, {"glm/"}},
    {"knit/rhythm", {"knit/mesh", "knit/model"}, {}},
    {"knit/rows",
     {"knit/mesh", "knit/model", "knit/fabric", "knit/timing", "knit/tubes", "knit/rhythm"},
     {"glm/"}},
    {"knit/short_rows",
     {"knit/mesh", "knit/model", "knit/fabric", "knit/timing", "knit/tubes", "knit/rows"},
     {"glm/"}},
    {"knit/settle", {"knit/mesh", "knit/model", "knit/fabric", "knit/timing"}, {"glm/"}},
    {"knit/relax", {"knit/mesh", "knit/model", "knit/fabric", "knit/timing", "knit/settle"}, {"glm/"}},
    {"knit/yarn", {"knit/mesh", "knit/model", "knit/fabric", "knit/relax"}, {"glm/"}},
    {"knit/stitches", {"knit/model", "knit/fabric", "knit/timing", "knit/tubes", "knit/rows"}, {"glm/"}},
    {"knit/order", {"knit/model", "knit/fabric", "knit/tubes", "knit/stitches"}, {}},
    {"knit/run",
     {"knit/mesh", "knit/model", "knit/fabric", "knit/timing", "knit/tubes", "knit/rows", "knit/stitches",
      "knit/order", "knit/settle", "knit/relax", "knit/rhythm", "knit/short_rows"},
     {"glm/"}},
    {"knit/quality", {"knit/mesh", "knit/model", "knit/settle", "knit/run"}, {"glm/"}},
    {"knit/insight",
     {"knit/base", "knit/model", "knit/tubes", "knit/rows", "knit/relax", "knit/run", "knit/quality"},
     {"glm/"}},
    {"knit/limbs", {"knit/model", "knit/fabric", "knit/stitches", "knit/order", "knit/run"}, {}},
    {"knit/pattern",
     {"knit/model", "knit/fabric", "knit/stitches", "knit/order", "knit/run", "knit/limbs"},
     {}},
    {"knit/trade", {"knit/import", "knit/model"}, {}},
    {"knit/reader", {"knit/import", "knit/model", "knit/pattern", "knit/trade"}, {}},

    {"app/base", {"knit/base", "knit/import", "knit/model"}, {"glm/", json[0], json[1], "unistd.h"}},
    {"app/scene", {"knit/base", "knit/mesh", "knit/model"}, {"glm/"}},
    {"app/curves", {"knit/base", "knit/mesh", "knit/curves", "app/base"}, {"glm/", json[0], json[1]}},
    {"app/checker", {"knit/base", "knit/mesh", "knit/model", "knit/reader", "app/scene"}, {"glm/"}},
    {"app/session", {"knit/", "app/base", "app/scene", "app/curves"}, {"glm/"}},
    {"app/explain", {"knit/", "app/base", "app/session"}, {"glm/"}},
    {"app/compare", {"knit/", "app/base", "app/session"}, {}},
    {"app/lessons", {"knit/", "app/base", "app/session", "app/explain"}, {"glm/"}},
    {"app/yarn", {"knit/", "app/base", "app/scene", "app/session"}, {"glm/", json[0], json[1]}},
    {"app/describe",
     {"knit/", "app/base", "app/scene", "app/checker", "app/session", "app/explain", "app/lessons",
      "app/yarn"},
     {"glm/"}},
    {"app/facing", {"knit/", "app/scene", "app/session", "app/describe"}, {"glm/"}},
    {"app/files",
     {"knit/", "app/base", "app/scene", "app/curves", "app/session", "app/explain", "app/describe",
      "app/yarn"},
     {json[0], json[1], "unistd.h"}},
    {"app/reader",
     {"knit/import", "knit/stitches", "knit/pattern", "knit/reader", "app/base"},
     {json[0], json[1]}},
    {"app/actions",
     {"knit/", "app/base", "app/curves", "app/checker", "app/session", "app/explain", "app/compare",
      "app/lessons", "app/describe", "app/facing", "app/files"},
     {json[0], json[1]}},
    {"app/entries",
     {"knit/", "app/base", "app/scene", "app/curves", "app/checker", "app/session", "app/explain",
      "app/compare", "app/lessons", "app/files", "app/actions"},
     {}},
    {"app/script",
     {"knit/", "app/base", "app/scene", "app/curves", "app/checker", "app/session", "app/explain",
      "app/compare", "app/lessons", "app/files", "app/reader", "app/actions"},
     {"CLI/CLI.hpp", json[0]}},

    {"app/panels/kit", {"knit/", "app/"}, {"glm/", "imgui.h", "imgui_internal.h"}},
    {"app/panels/offers", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/view", {"knit/", "app/", "app/panels/kit", "app/panels/offers"}, {"glm/", "imgui.h"}},
    {"app/panels/checker", {"knit/", "app/", "app/panels/kit", "app/panels/view"}, {"glm/", "imgui.h"}},
    {"app/panels/timeline", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/parameters", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/step", {"knit/", "app/", "app/panels/kit", "app/panels/offers"}, {"imgui.h"}},
    {"app/panels/tubes", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/report", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/compare", {"knit/", "app/", "app/panels/kit"}, {"imgui.h"}},
    {"app/panels/dialogs", {"knit/", "app/", "app/panels/kit", "app/panels/offers"}, {"imgui.h"}},
    {"app/panels/pattern", {"knit/", "app/", "app/panels/kit", "app/panels/dialogs"}, {"imgui.h"}},
    {"app/panels",
     {"knit/", "app/", "app/panels/kit", "app/panels/view", "app/panels/timeline", "app/panels/parameters",
      "app/panels/step", "app/panels/dialogs", "app/panels/pattern", "app/panels/checker"},
     {"imgui.h"}},

    {"app/render",
     {"knit/", "app/base", "app/scene", "app/files", "shaders_embedded.h"},
     {"glm/", "glad/", "GLES3/", "EGL/", "imgui", "stb_image.h", "stb_image_write.h", "gif_lib.h", "dlfcn.h",
      "malloc.h", "unistd.h"}},
    {"app/window",
     {"knit/", "app/", "app/panels", "app/panels/kit", "app/panels/offers", "app/render"},
     {"glm/", "glad/", "GLFW/"}},
    {"app/web",
     {"knit/", "app/", "app/panels/kit", "app/render", "app/window"},
     {"emscripten.h", "emscripten/html5.h"}},
    {"app", {"knit/", "app/session", "app/actions", "app/script", "app/window"}, {}}};

// Folders of the app that "app/" stands for: all that knows no window.
inline const std::set<std::string> app_core{"app/base",     "app/scene",   "app/curves",  "app/checker",
                                            "app/session",  "app/explain", "app/compare", "app/lessons",
                                            "app/describe", "app/facing",  "app/yarn",    "app/files",
                                            "app/reader",   "app/actions", "app/entries", "app/script"};

}  // namespace test_support
