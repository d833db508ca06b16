#include "app/session/view.h"

namespace app {

namespace {
constexpr std::array<std::string_view, layer_count> layer_names{"Surface",           "Time colours",
                                                                "Isolines of time",  "Critical points",
                                                                "Mesh edges",        "Cycle and candidates",
                                                                "Anchor and band",   "Stitches",
                                                                "Row edges",         "Column edges",
                                                                "Faces by label",    "Edges by stretch",
                                                                "Moves of stitches", "Yarn"};
constexpr std::array<std::string_view, layer_count> layer_keys{
    "surface",  "times",     "isolines",     "criticals", "wire",    "cycle", "band",
    "stitches", "row-edges", "column-edges", "faces",     "stretch", "moves", "yarn"};
}  // namespace

std::string_view name_of(Layer layer) { return layer_names.at(static_cast<std::size_t>(layer)); }
std::string_view key_of(Layer layer) { return layer_keys.at(static_cast<std::size_t>(layer)); }

}  // namespace app
