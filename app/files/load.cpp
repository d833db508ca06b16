#include "app/files/load.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/files/session_json.h"
#include "app/session/action.h"
#include "knit/import/obj.h"
#include "knit/import/quoting.h"
#include "knit/model/stitch_size.h"
#include "knit/model/words.h"
#include "knit/rows/first_choice.h"

namespace app {

namespace {

void forget_coincident(std::vector<knit::Finding>& findings) {
  std::erase_if(findings, [](const knit::Finding& f) { return f.kind == knit::FindingKind::coincident; });
}

std::variant<Loaded, std::string> prepare(std::shared_ptr<const knit::Mesh> original,
                                          const knit::Parameters* parameters,
                                          knit::Progress* progress = nullptr) {
  Loaded loaded;
  loaded.original = std::move(original);
  knit::CheckResult checked = knit::check(*loaded.original, progress);
  if (!checked.fit()) return loaded.original->name + ": " + checked.findings.front().sentence;
  loaded.findings = std::move(checked.findings);
  if (progress != nullptr) progress->begin(knit::Progress::Task::preparing);
  loaded.mesh_hash = hash_text(*loaded.original);
  const bool weld = parameters != nullptr && parameters->mesh.weld == knit::Weld::on;
  if (weld) forget_coincident(loaded.findings);
  loaded.input = knit::make_input(weld ? knit::weld(*loaded.original) : *loaded.original);
  if (progress != nullptr) progress->at(0.9);
  loaded.parameters = parameters != nullptr ? knit::resolved(*parameters, *loaded.input)
                                            : knit::first_parameters(*loaded.input);
  return loaded;
}

// What was read and left out; nothing where nothing was.
void tell_left_out(const knit::ObjNotes& notes, std::vector<knit::Finding>& findings) {
  if (notes.loose_edges == 0) return;
  const bool one = notes.loose_edges == 1;
  findings.push_back({knit::FindingKind::loose_edges,
                      knit::Severity::warning,
                      notes.loose_edges,
                      {},
                      std::to_string(notes.loose_edges) + (one ? " face has" : " faces have") +
                          " two corners, as a loose edge has; the first stands in line " +
                          std::to_string(notes.loose_line) +
                          " of the file. Such faces are left out; nothing need be done about them."});
}

// A piece that is not there, in one sentence.
std::optional<std::string> fault_of_piece(const knit::Mesh& mesh, const knit::RepairWish& wish) {
  if (wish.piece() == 0) return std::nullopt;
  const std::size_t pieces = knit::pieces_to_choose(mesh, wish);
  if (pieces == 0 || wish.piece() <= pieces) return std::nullopt;
  return mesh.name + " has no piece " + std::to_string(wish.piece()) + ": " +
         (pieces == 1 ? "it is one piece; leave --piece out."
                      : "it is in " + std::to_string(pieces) + " pieces; give one from 1 to " +
                            std::to_string(pieces) + ".");
}

// As a person wishes; what helps is only looked for where it is wanted.
knit::RepairPlan repaired_as(knit::Mesh mesh, const knit::RepairWish& wish) {
  if (wish.all) {
    if (auto plan = knit::plan_repairs(mesh, wish.piece())) return std::move(*plan);
  }
  if (!wish.kinds.empty()) return knit::carry_out(mesh, wish.kinds);
  return {std::move(mesh), {}};
}

std::string text_of(const nlohmann::json& value) {
  if (value.is_string()) return value.get<std::string>();
  return value.dump();
}

// The example's own parameters over those that follow the mesh's size.
std::variant<knit::Parameters, std::string> read_parameters(const std::filesystem::path& path,
                                                            knit::Parameters parameters) {
  std::ifstream in(path);
  const nlohmann::json json = nlohmann::json::parse(in, nullptr, false);
  if (!json.is_object() || !json.contains("parameters") || !json["parameters"].is_object()) {
    return path.string() + " is not a JSON object with \"parameters\"; build the project again.";
  }
  std::vector<knit::Setting> settings;
  for (const auto& [key, value] : json["parameters"].items()) {
    const knit::ParameterInfo* info = knit::find_parameter(key);
    if (info == nullptr) return path.string() + ": there is no parameter \"" + key + "\"; remove it.";
    settings.emplace_back(info, text_of(value));
  }
  if (const auto error = knit::set_values(settings, parameters)) return path.string() + ": " + *error;
  return parameters;
}

}  // namespace

std::variant<Loaded, std::string> load_file(const std::filesystem::path& path,
                                            const std::vector<knit::RepairKind>& repairs,
                                            knit::Progress* progress) {
  knit::ObjNotes notes;
  auto read = knit::read_obj_file(path, progress, &notes);
  if (const auto* error = std::get_if<knit::ObjError>(&read)) return error->sentence;
  auto& mesh = std::get<knit::Mesh>(read);
  const knit::RepairWish wish{false, repairs};
  if (auto fault = fault_of_piece(mesh, wish)) return std::move(*fault);
  auto loaded = load_repaired(repaired_as(std::move(mesh), wish), progress);
  if (auto* ready = std::get_if<Loaded>(&loaded)) tell_left_out(notes, ready->findings);
  return loaded;
}

std::variant<Loaded, std::string> load_repaired(const knit::RepairPlan& plan, knit::Progress* progress) {
  auto loaded = prepare(std::make_shared<const knit::Mesh>(plan.mesh), nullptr, progress);
  if (auto* ready = std::get_if<Loaded>(&loaded)) ready->repaired = plan.steps;
  return loaded;
}

namespace {

constexpr std::size_t most_pieces_tried = 12;

// Where the largest piece cannot be made fit, the next that can.
std::optional<knit::RepairPlan> plan_of_any_piece(const knit::Mesh& mesh, std::size_t piece) {
  auto plan = knit::plan_repairs(mesh, piece);
  if (plan || piece > 0) return plan;
  const std::size_t pieces = std::min(knit::pieces_to_choose(mesh, {}), most_pieces_tried);
  for (std::size_t number = 2; number <= pieces && !plan; ++number) plan = knit::plan_repairs(mesh, number);
  return plan;
}

}  // namespace

std::variant<Loaded, NotOpened> open_mesh(const std::filesystem::path& path, const knit::RepairWish& wish,
                                          knit::Progress* progress) {
  knit::ObjNotes notes;
  auto read = knit::read_obj_file(path, progress, &notes);
  if (auto* error = std::get_if<knit::ObjError>(&read)) return NotOpened{std::move(error->sentence), nullptr};
  const auto mesh = std::make_shared<const knit::Mesh>(std::get<knit::Mesh>(std::move(read)));
  if (auto fault = fault_of_piece(*mesh, wish)) return NotOpened{std::move(*fault), nullptr};
  const bool as_it_is = !wish.all && wish.kinds.empty();
  auto loaded =
      as_it_is ? prepare(mesh, nullptr, progress) : load_repaired(repaired_as(*mesh, wish), progress);
  if (auto* ready = std::get_if<Loaded>(&loaded)) {
    tell_left_out(notes, ready->findings);
    return std::move(*ready);
  }
  NotOpened unfit{std::get<std::string>(std::move(loaded)), nullptr};
  if (auto plan = plan_of_any_piece(*mesh, wish.piece())) {
    for (const knit::RepairStep& step : plan->steps) {
      const std::size_t kept = knit::piece_kept(step.kind);
      if (kept > 1 && wish.piece() == 0)
        unfit.sentence += " No piece before piece " + std::to_string(kept) + " can be repaired.";
    }
    unfit.plan = std::make_shared<const knit::RepairPlan>(std::move(*plan));
  }
  return unfit;
}

std::string piece_words(const knit::RepairPlan& plan, std::size_t number) {
  const knit::PieceShare& piece = plan.pieces.at(number - 1);
  return "Piece " + std::to_string(number) + ": " + knit::percent_text(piece.share) + " of the surface, " +
         knit::counted(piece.triangles, "triangle", "triangles");
}

std::variant<std::size_t, std::string> count_pieces(const std::filesystem::path& path,
                                                    const knit::RepairWish& wish) {
  auto read = knit::read_obj_file(path);
  if (auto* error = std::get_if<knit::ObjError>(&read)) return std::move(error->sentence);
  return knit::pieces_to_choose(std::get<knit::Mesh>(read), wish);
}

std::variant<Loaded, std::string> load_example(const std::filesystem::path& assets, const std::string& name) {
  const std::vector<std::string> names = list_examples(assets);
  if (std::find(names.begin(), names.end(), name) == names.end()) {
    std::string all;
    for (const std::string& known : names) all += (all.empty() ? "" : ", ") + known;
    if (all.empty()) return "no examples found in " + assets.string() + "; build the project again.";
    return "there is no example \"" + name + "\"; choose one of " + all + ".";
  }
  auto read = knit::read_obj_file(assets / name / "mesh.obj");
  if (const auto* error = std::get_if<knit::ObjError>(&read)) return error->sentence;
  knit::Mesh mesh = std::get<knit::Mesh>(std::move(read));
  mesh.name = name;
  const auto parameters = read_parameters(assets / name / "parameters.json",
                                          knit::default_parameters(knit::bounds_of(mesh.positions)));
  if (const auto* error = std::get_if<std::string>(&parameters)) return *error;
  auto loaded =
      prepare(std::make_shared<const knit::Mesh>(std::move(mesh)), &std::get<knit::Parameters>(parameters));
  // An example decides about welding itself; its seam is no news.
  if (auto* ready = std::get_if<Loaded>(&loaded)) forget_coincident(ready->findings);
  return loaded;
}

std::variant<Loaded, std::string> load_again(const std::shared_ptr<const knit::Mesh>& original,
                                             const knit::Parameters& parameters, knit::Progress* progress) {
  return prepare(original, &parameters, progress);
}

namespace {
// The menu's order; what else lies in the folder follows by name.
constexpr std::array<std::string_view, 17> known_order{
    "thesis-sphere", "sphere",       "stretched-sphere", "egg", "capsule",  "cone",    "vase",
    "torus",         "heel",         "trousers",         "y",   "starfish", "octopus", "mug",
    "cup",           "double-torus", "chain-of-three"};
}  // namespace

std::vector<std::string> list_examples(const std::filesystem::path& assets) {
  std::vector<std::string> names;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(assets, error)) {
    const bool example = std::filesystem::exists(entry.path() / "mesh.obj", error) &&
                         std::filesystem::exists(entry.path() / "parameters.json", error);
    if (example) names.push_back(entry.path().filename().string());
  }
  const auto rank = [](const std::string& name) {
    return std::find(known_order.begin(), known_order.end(), name) - known_order.begin();
  };
  std::sort(names.begin(), names.end(), [&](const std::string& a, const std::string& b) {
    return std::pair{rank(a), a} < std::pair{rank(b), b};
  });
  return names;
}

}  // namespace app
