// From a file or an example to a checked mesh and the parameters to begin with.
#pragma once

#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "app/curves/curve_wish.h"
#include "knit/import/check.h"
#include "knit/import/progress.h"
#include "knit/import/repair.h"
#include "knit/model/settings_table.h"

namespace app {

struct Loaded {
  std::shared_ptr<const knit::Mesh> original;  // as read, and repaired where that was asked for
  std::shared_ptr<const knit::Input> input;    // welded where the parameters say so, and cut along the curves
  knit::Parameters parameters;
  std::vector<knit::Finding> findings;     // warnings
  std::string mesh_hash;                   // hash_text of `original`
  std::vector<knit::RepairStep> repaired;  // what was done
  std::vector<knit::Cycle> curves;         // that it was cut along
};

// Why nothing was opened, in one sentence, and what would make the mesh fit.
struct NotOpened {
  std::string sentence;
  std::shared_ptr<const knit::RepairPlan> plan;  // of the mesh as read; null: no repairs would do
  std::vector<knit::Cycle> curves{};             // that it was to be cut along
};

// The error is one sentence: what is wrong, where, and what to do. `progress`: told how far it has come; loading
// stops with knit::Cancelled when that is wished.
std::variant<Loaded, std::string> load_file(const std::filesystem::path& path,
                                            const std::vector<knit::RepairKind>& repairs = {},
                                            knit::Progress* progress = nullptr,
                                            const std::vector<knit::Cycle>& curves = {});
// Likewise, with the repairs that help if it is unfit.
std::variant<Loaded, NotOpened> open_mesh(const std::filesystem::path& path,
                                          const knit::RepairWish& wish = {},
                                          knit::Progress* progress = nullptr, const CurveWish& curves = {});
std::variant<Loaded, std::string> load_repaired(const knit::RepairPlan& plan,
                                                knit::Progress* progress = nullptr,
                                                const std::vector<knit::Cycle>& curves = {});
// "Piece 2: 14 % of the surface, 2310 triangles". Requires a number from 1 to as many pieces as there are.
std::string piece_words(const knit::RepairPlan& plan, std::size_t number);
// How many pieces the mesh is in when all that is wished but the choice of one has been done; 0: it cannot be said.
std::variant<std::size_t, std::string> count_pieces(const std::filesystem::path& path,
                                                    const knit::RepairWish& wish);
std::variant<Loaded, std::string> load_example(const std::filesystem::path& assets, const std::string& name);
// The same mesh again, for parameters whose weld differs or along other curves.
std::variant<Loaded, std::string> load_again(const std::shared_ptr<const knit::Mesh>& original,
                                             const knit::Parameters& parameters,
                                             knit::Progress* progress = nullptr,
                                             const std::vector<knit::Cycle>& curves = {});
// Whether the mesh is welded alike for both, and cut alike: curves may follow the stitch's width and the axis.
bool made_alike(const knit::Parameters& a, const knit::Parameters& b, const std::vector<knit::Cycle>& curves);

}  // namespace app
