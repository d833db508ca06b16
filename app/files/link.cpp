#include "app/files/link.h"

#include <algorithm>
#include <array>

#include "app/files/session_file.h"
#include "app/files/session_json.h"
#include "app/scene/colour_text.h"
#include "app/session/at.h"
#include "app/session/document.h"
#include "app/session/view.h"
#include "knit/model/settings_table.h"
#include "knit/pattern/written_rows.h"

namespace app {

namespace {

// Builds "knit-mesh --key value ...".
class Link {
 public:
  void add(const std::string& word) { text_ += " " + shell_quoted(word); }
  void add(const std::string& option, const std::string& value) {
    // A value that begins like an option must be tied to its own.
    if (value.rfind('-', 0) == 0) return add(option + "=" + value);
    add(option);
    add(value);
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_ = "knit-mesh";
};

bool is_size(const knit::ParameterInfo& info) {
  return info.group == knit::find_parameter(knit::keys::sizes)->group || info.tie == knit::Tie::width;
}

// What differs from the mesh's own defaults. Sizes follow each other, so all are given if any is.
void add_parameters(Link& link, const knit::Parameters& parameters, const knit::Parameters& defaults) {
  const auto differs = [&](const knit::ParameterInfo& info) {
    return knit::value_text(info, parameters) != knit::value_text(info, defaults);
  };
  const auto table = knit::parameter_table();
  const bool sizes = std::any_of(table.begin(), table.end(),
                                 [&](const auto& info) { return is_size(info) && differs(info); });
  for (const knit::ParameterInfo& info : table) {
    if (differs(info) || (sizes && is_size(info)))
      link.add("--" + std::string(info.key), knit::value_text(info, parameters));
  }
}

// Options say where curves are, but not what they are called nor their times; and a single vertex is a parameter.
bool curves_are_sayable(const Document& document) {
  const auto& curves = document.source.curves;
  if (curves.empty()) return true;
  const knit::TimingSettings& timing = document.timeline.base_parameters().timing;
  if (timing.start != knit::no_vertex || timing.end != knit::no_vertex) return false;
  bool any = false;
  std::array<int, 2> ends{};
  for (const knit::Cycle& curve : curves) {
    if (!curve.name.empty() || curve.value || ++ends.at(static_cast<std::size_t>(curve.as)) > 1) return false;
    any = any || curve.kind != knit::CycleKind::vertex;
  }
  return any;
}

void add_curves(Link& link, const std::vector<knit::Cycle>& curves) {
  for (const knit::Cycle& curve : curves)
    link.add("--" + std::string(knit::word_of(curve.as)), knit::cycle_text(curve));
}

void add_place(Link& link, const knit::Timeline& timeline) {
  if (timeline.position() == 0 && !timeline.sought()) return link.add("--at", "0");
  const knit::Place at = timeline.sought().value_or(timeline.place());
  if (at.stage == knit::Stage::done) return link.add("--at", "end");
  link.add("--at", text_of(at));
}

void add_yarn(Link& link, const YarnLook& look) {
  const YarnLook usual;
  if (look.by != usual.by)
    link.add("--yarn-shows", std::string(yarn_colours_keys.at(static_cast<std::size_t>(look.by))));
  if (look.wool != usual.wool) link.add("--yarn-colour", hex_text(look.wool));
  if (look.second != usual.second) link.add("--yarn-second", hex_text(look.second));
  if (look.stripe_rounds != usual.stripe_rounds)
    link.add("--yarn-stripes", std::to_string(look.stripe_rounds));
  if (look.radius != usual.radius) link.add("--yarn-radius", knit::number_text(look.radius));
  if (look.easing != usual.easing) link.add("--yarn-relax", std::to_string(look.easing));
}

// All of them where any differs from what is shown at first.
void add_layers(Link& link, const View& view) {
  if (view.layers == View{}.layers) return;
  std::string layers;
  for (std::size_t i = 0; i < layer_count; ++i) {
    if (view.layers[i]) layers += (layers.empty() ? "" : ",") + std::string(key_of(static_cast<Layer>(i)));
  }
  link.add("--layers", layers.empty() ? "none" : layers);
}

void add_pattern(Link& link, const knit::PatternOptions& pattern, const PatternPieces& pieces) {
  if (!pattern.title.empty()) link.add("--title", pattern.title);
  if (!pattern.yarn.empty()) link.add("--yarn", pattern.yarn);
  if (!pattern.colour.empty()) link.add("--colour", pattern.colour);
  if (pattern.needle_mm) link.add("--needle-mm", knit::number_text(*pattern.needle_mm));
  if (pattern.markers) link.add("--markers");
  if (pattern.stars) link.add("--stars");
  if (pattern.form != knit::PatternForm::by_itself)
    link.add("--pattern-form", pattern.form == knit::PatternForm::short_form ? "short" : "full");
  if (pattern.turns != knit::ShortRowTurns::usual)
    link.add("--turns", pattern.turns == knit::ShortRowTurns::wrap ? "wrap" : "german");
  for (const auto& [letters, word] : pieces.names) {
    std::string named = letters;
    named.append("=").append(word);
    link.add("--piece-name", named);
  }
  if (!pieces.order.empty()) link.add("--piece-order", piece_order_text(pieces.order));
}

// As the pattern counts: "12", or "12.1", the first short row on it.
std::string round_words(const knit::Fabric& fabric, std::int32_t row) {
  const auto called = knit::written_row(fabric, row);
  if (!called) return std::to_string(row);
  if (called->short_row == 0) return std::to_string(called->round);
  return std::to_string(called->round - 1) + "." + std::to_string(called->short_row);
}

}  // namespace

std::string shell_quoted(const std::string& word) {
  const auto plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("-_./,:=+@%").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::all_of(word.begin(), word.end(), plain)) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
}

std::optional<std::string> link_by_options(const Session& session) {
  if (!session.document) return std::nullopt;
  const knit::Timeline& timeline = session.document->timeline;
  const bool sayable = timeline.edits().empty() && session.view->breaks.empty() && !session.document->pinned;
  const Source& source = session.document->source;
  if (!sayable || !curves_are_sayable(*session.document) || (source.example.empty() && source.file.empty()))
    return std::nullopt;
  Link link;
  if (source.file.empty()) {
    link.add("--example", source.example);
  } else {
    std::error_code error;
    const auto absolute = std::filesystem::absolute(source.file, error);
    link.add((error ? source.file : absolute).lexically_normal().string());
    std::string repairs;
    for (const knit::RepairKind kind : source.repairs)
      repairs += (repairs.empty() ? "" : ",") + std::string(knit::key_of(kind));
    if (!repairs.empty()) link.add("--repair", repairs);
  }
  add_curves(link, source.curves);
  add_parameters(link, timeline.base_parameters(), session.document->defaults);
  add_place(link, timeline);
  if (session.view->side != SidePanel::step)
    link.add("--side", std::string(side_keys.at(static_cast<std::size_t>(session.view->side))));
  if (session.view->centre != CentrePanel::view) {
    const std::string& piece = session.view->gaze.chart_piece;
    link.add("--centre", piece.empty() ? "chart" : "chart:" + piece);
  }
  if (session.view->positions != Positions::settled)
    link.add("--positions",
             std::string(positions_keys.at(static_cast<std::size_t>(session.view->positions))));
  if (session.view->gaze.knit_along)
    link.add("--knit-along", round_words(timeline.furthest().fabric, *session.view->gaze.knit_along));
  add_layers(link, *session.view);
  add_yarn(link, session.view->yarn);
  add_pattern(link, session.view->pattern, session.document->pieces);
  return link.text();
}

std::optional<std::string> link_by_session(const Session& session) {
  const auto path = saved_unchanged(session);
  if (!path) return std::nullopt;
  Link link;
  link.add("--session", path->string());
  return link.text();
}

}  // namespace app
