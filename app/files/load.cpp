#include "app/files/load.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "app/files/session_json.h"
#include "app/session/action.h"
#include "knit/curves/between.h"
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

// What a cut may leave out; what it does not is said then.
void forget_what_is_cut(std::vector<knit::Finding>& findings) {
  std::erase_if(findings, [](const knit::Finding& f) {
    return f.kind == knit::FindingKind::open_edges || f.kind == knit::FindingKind::several_pieces;
  });
}

// "left out: 3 %" as a finding: "Left out: 3 %."
knit::Finding finding_of(std::string note) {
  if (note.front() >= 'a' && note.front() <= 'z') note.front() = static_cast<char>(note.front() - 'a' + 'A');
  if (note.back() != '.' && note.back() != '?') note += '.';
  return {knit::FindingKind::cut_off, knit::Severity::warning, 1, {}, std::move(note)};
}

// Cuts the mesh along the curves; what was left out and chosen joins the findings. A sentence where it cannot be.
std::optional<std::string> cut_along(const std::vector<knit::Cycle>& curves, const knit::Mesh& mesh,
                                     const knit::Parameters& parameters, Loaded& loaded) {
  const knit::BetweenSettings settings{parameters.stitch.width, parameters.timing.axis.direction()};
  const auto found = knit::between_cycles(mesh, curves, settings);
  if (const auto* fault = std::get_if<std::string>(&found)) return *fault;
  const auto& piece = std::get<knit::Between>(found);
  if (piece.rims.size() != 2)
    return "The piece between the curves has " + std::to_string(piece.rims.size()) +
           " of them on its border, and it is knitted from one start to one end. Leave the others out.";
  loaded.input = knit::input_of(piece);
  for (const std::string& note : piece.notes) loaded.findings.push_back(finding_of(note));
  return std::nullopt;
}

std::variant<Loaded, std::string> prepare(std::shared_ptr<const knit::Mesh> original,
                                          const knit::Parameters* parameters,
                                          knit::Progress* progress = nullptr,
                                          const std::vector<knit::Cycle>& curves = {}) {
  Loaded loaded;
  loaded.original = std::move(original);
  loaded.curves = curves;
  knit::CheckResult checked = knit::check(*loaded.original, progress);
  if (!curves.empty()) forget_what_is_cut(checked.findings);
  if (!checked.fit()) return loaded.original->name + ": " + checked.findings.front().sentence;
  loaded.findings = std::move(checked.findings);
  if (progress != nullptr) progress->begin(knit::Progress::Task::preparing);
  loaded.mesh_hash = hash_text(*loaded.original);
  const bool weld = parameters != nullptr && parameters->mesh.weld == knit::Weld::on;
  if (weld) forget_coincident(loaded.findings);
  loaded.input = knit::make_input(weld ? knit::weld(*loaded.original) : *loaded.original);
  if (!curves.empty()) {
    // Stitches are as large as on the whole mesh.
    const std::shared_ptr<const knit::Input> whole = loaded.input;
    loaded.parameters =
        parameters != nullptr ? knit::resolved(*parameters, *whole) : knit::first_parameters(*whole);
    if (auto fault = cut_along(curves, whole->mesh, loaded.parameters, loaded))
      return loaded.original->name + ": " + *fault;
    loaded.parameters =
        knit::resolved(parameters != nullptr ? *parameters : loaded.parameters, *loaded.input);
    return loaded;
  }
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
                                            knit::Progress* progress,
                                            const std::vector<knit::Cycle>& curves) {
  knit::ObjNotes notes;
  auto read = knit::read_obj_file(path, progress, &notes);
  if (const auto* error = std::get_if<knit::ObjError>(&read)) return error->sentence;
  auto& mesh = std::get<knit::Mesh>(read);
  const knit::RepairWish wish{false, repairs};
  if (auto fault = fault_of_piece(mesh, wish)) return std::move(*fault);
  auto loaded = load_repaired(repaired_as(std::move(mesh), wish), progress, curves);
  if (auto* ready = std::get_if<Loaded>(&loaded)) tell_left_out(notes, ready->findings);
  return loaded;
}

std::variant<Loaded, std::string> load_repaired(const knit::RepairPlan& plan, knit::Progress* progress,
                                                const std::vector<knit::Cycle>& curves) {
  auto loaded = prepare(std::make_shared<const knit::Mesh>(plan.mesh), nullptr, progress, curves);
  if (auto* ready = std::get_if<Loaded>(&loaded)) ready->repaired = plan.steps;
  return loaded;
}

namespace {

constexpr std::size_t most_pieces_tried = 12;

// What is wrong lies in the curves alone, and their sentence says it.
bool fit_but_for_curves(const knit::Mesh& mesh) {
  knit::CheckResult checked = knit::check(mesh);
  forget_what_is_cut(checked.findings);
  return checked.fit();
}

// Nothing is measured where there are none.
std::variant<std::vector<knit::Cycle>, std::string> curves_on(const CurveWish& wish, const knit::Mesh& mesh) {
  if (wish.none()) return std::vector<knit::Cycle>();
  return curves_for(wish, knit::bounds_of(mesh.positions));
}

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
                                          knit::Progress* progress, const CurveWish& curves) {
  knit::ObjNotes notes;
  auto read = knit::read_obj_file(path, progress, &notes);
  if (auto* error = std::get_if<knit::ObjError>(&read)) return NotOpened{std::move(error->sentence), nullptr};
  const auto mesh = std::make_shared<const knit::Mesh>(std::get<knit::Mesh>(std::move(read)));
  if (auto fault = fault_of_piece(*mesh, wish)) return NotOpened{std::move(*fault), nullptr};
  const bool as_it_is = !wish.all && wish.kinds.empty();
  auto plan = as_it_is ? knit::RepairPlan{} : repaired_as(*mesh, wish);
  auto placed = curves_on(curves, as_it_is ? *mesh : plan.mesh);
  if (auto* error = std::get_if<std::string>(&placed)) return NotOpened{std::move(*error), nullptr};
  const auto& cut = std::get<std::vector<knit::Cycle>>(placed);
  auto loaded = as_it_is ? prepare(mesh, nullptr, progress, cut) : load_repaired(plan, progress, cut);
  if (auto* ready = std::get_if<Loaded>(&loaded)) {
    tell_left_out(notes, ready->findings);
    return std::move(*ready);
  }
  NotOpened unfit{std::get<std::string>(std::move(loaded)), nullptr, cut};
  if (!cut.empty() && fit_but_for_curves(as_it_is ? *mesh : plan.mesh)) return unfit;
  if (auto help = plan_of_any_piece(*mesh, wish.piece())) {
    for (const knit::RepairStep& step : help->steps) {
      const std::size_t kept = knit::piece_kept(step.kind);
      if (kept > 1 && wish.piece() == 0)
        unfit.sentence += " No piece before piece " + std::to_string(kept) + " can be repaired.";
    }
    unfit.plan = std::make_shared<const knit::RepairPlan>(std::move(*help));
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
                                             const knit::Parameters& parameters, knit::Progress* progress,
                                             const std::vector<knit::Cycle>& curves) {
  return prepare(original, &parameters, progress, curves);
}

namespace {

bool any_curve(const std::vector<knit::Cycle>& curves, bool (*holds)(const knit::Cycle&)) {
  return std::any_of(curves.begin(), curves.end(), holds);
}

bool has_start(const std::vector<knit::Cycle>& curves) {
  return any_curve(curves, [](const knit::Cycle& one) { return one.as == knit::CycleEnd::start; });
}

// A circle may be as long as a cast on; so is that about an end that is looked for.
bool follows_width(const std::vector<knit::Cycle>& curves) {
  const bool has_end =
      any_curve(curves, [](const knit::Cycle& one) { return one.as == knit::CycleEnd::end; });
  return !has_start(curves) || !has_end || any_curve(curves, [](const knit::Cycle& one) {
    const bool round = one.kind == knit::CycleKind::circle || one.kind == knit::CycleKind::vertex;
    return one.kind == knit::CycleKind::farthest || (round && !one.radius);
  });
}

// The lowest edge is the lowest along the axis.
bool follows_axis(const std::vector<knit::Cycle>& curves) {
  return !has_start(curves) || any_curve(curves, [](const knit::Cycle& one) {
    return one.kind == knit::CycleKind::boundary && one.points.empty();
  });
}

}  // namespace

bool made_alike(const knit::Parameters& a, const knit::Parameters& b,
                const std::vector<knit::Cycle>& curves) {
  if (a.mesh.weld != b.mesh.weld) return false;
  if (curves.empty()) return true;
  if (follows_axis(curves) && a.timing.axis != b.timing.axis) return false;
  if (!follows_width(curves)) return true;
  const auto* a_mesh = std::get_if<knit::MeshSize>(&a.size.given);
  const auto* b_mesh = std::get_if<knit::MeshSize>(&b.size.given);
  if (a_mesh == nullptr || b_mesh == nullptr) return a.size == b.size && a.timing.axis == b.timing.axis;
  return a_mesh->width == b_mesh->width;
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
