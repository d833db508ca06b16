#include "app/explain/pseudo_code.h"

#include <algorithm>

#include "app/explain/code_variables.h"
#include "app/explain/pseudo_code_texts.h"
#include "app/session/document.h"

namespace app {

namespace {

constexpr std::array<std::string_view, 6> keywords{"for", "each", "if", "else", "not", "write"};

Listing timing_listing(knit::TimingKind kind) {
  switch (kind) {
    case knit::TimingKind::linear:
      return Listing::timing_linear;
    case knit::TimingKind::arc_length:
      return Listing::timing_arc_length;
    case knit::TimingKind::geodesic:
      return Listing::timing_geodesic;
    case knit::TimingKind::harmonic:
      return Listing::timing_harmonic;
  }
  return Listing::timing_linear;
}

Listing index_listing(knit::PlacementPolicy placement) {
  switch (placement) {
    case knit::PlacementPolicy::thesis:
      return Listing::index_thesis;
    case knit::PlacementPolicy::even:
      return Listing::index_even;
    case knit::PlacementPolicy::nearest:
      return Listing::index_nearest;
  }
  return Listing::index_thesis;
}

Listing rows_listing(knit::Stage stage, knit::RowSource rows) {
  if (rows == knit::RowSource::contours) return Listing::rows_contours;
  return stage == knit::Stage::cast_on ? Listing::cast_on : Listing::rows_rings;
}

Listing listing_at(knit::Stage stage, const knit::Parameters& parameters) {
  switch (stage) {
    case knit::Stage::cast_on:
    case knit::Stage::rows:
      return rows_listing(stage, parameters.rows.source);
    case knit::Stage::stitches:
      return index_listing(parameters.stitches.placement);
    case knit::Stage::faces:
      return Listing::faces;
    case knit::Stage::pattern:
    case knit::Stage::done:
      return Listing::pattern;
    case knit::Stage::import:
    case knit::Stage::timing:
      break;
  }
  return timing_listing(parameters.timing.kind);
}

// What a step shows of how it was done counts for more than parameters, which may have been edited meanwhile.
struct ListingOf {
  Listing otherwise;

  Listing operator()(const knit::CycleFound&) const { return Listing::cast_on; }
  Listing operator()(const knit::StitchCastOn&) const { return Listing::cast_on; }
  Listing operator()(const knit::CycleGathered&) const { return Listing::rows_rings; }
  Listing operator()(const knit::CycleOrdered&) const { return Listing::rows_rings; }
  Listing operator()(const knit::CandidateMeasured&) const { return Listing::rows_rings; }
  Listing operator()(const knit::BandMissed&) const { return Listing::rows_rings; }
  Listing operator()(const knit::RowClosed&) const { return Listing::rows_rings; }
  Listing operator()(const knit::RowResampled&) const { return Listing::rows_rings; }
  Listing operator()(const knit::GapShared&) const { return Listing::rows_rings; }
  Listing operator()(const knit::RowsPlanned&) const { return Listing::rows_contours; }
  Listing operator()(const knit::CutFound&) const { return Listing::rows_contours; }
  Listing operator()(const knit::LoopClosed&) const { return Listing::rows_contours; }
  Listing operator()(const knit::LengthMeasured&) const { return Listing::rows_contours; }
  Listing operator()(const knit::CountChosen&) const { return Listing::rows_contours; }
  Listing operator()(const knit::StitchPlaced&) const { return Listing::rows_contours; }
  Listing operator()(const knit::RowsMatched&) const { return Listing::index_nearest; }
  Listing operator()(const auto&) const { return otherwise; }
};

// One overload a kind of step: its lines in its listing, counted from 0.
struct LinesOf {
  Listing listing;
  const knit::Place& place;

  [[nodiscard]] bool is(Listing other) const { return listing == other; }
  [[nodiscard]] LinesRun from_end(std::size_t lines) const {
    const std::size_t line = code_of(listing).lines.size() - lines;
    return {line, line};
  }

  LinesRun operator()(const knit::EndsFound&) const {
    return is(Listing::timing_linear) ? LinesRun{0, 2} : LinesRun{0, 0};
  }
  LinesRun operator()(const knit::FieldSolved& s) const {
    switch (s.which) {
      case knit::FieldStep::net:
        return {1, 1};
      case knit::FieldStep::heat:
      case knit::FieldStep::harmonic:
        return {2, 2};
      case knit::FieldStep::slopes:
        return {3, 3};
      case knit::FieldStep::distance:
        return {4, 4};
    }
    return {};
  }
  LinesRun operator()(const knit::HeightsMeasured&) const {
    return is(Listing::timing_harmonic) ? LinesRun{3, 3} : LinesRun{1, 2};
  }
  LinesRun operator()(const knit::VertexTimed& s) const {
    switch (listing) {
      case Listing::timing_arc_length:
        return s.clamped ? LinesRun{4, 5} : LinesRun{5, 5};
      case Listing::timing_geodesic:
        return s.clamped ? LinesRun{6, 7} : LinesRun{6, 6};
      case Listing::timing_harmonic:
        return {5, 5};
      default:
        return s.clamped ? LinesRun{4, 7} : LinesRun{4, 6};
    }
  }
  LinesRun operator()(const knit::CriticalsFound&) const { return from_end(2); }
  LinesRun operator()(const knit::LevelsGrouped&) const { return from_end(1); }

  LinesRun operator()(const knit::CycleFound&) const { return {1, 2}; }
  LinesRun operator()(const knit::StitchCastOn& s) const {
    return s.stitch == 1 ? LinesRun{3, 5} : LinesRun{5, 5};
  }

  LinesRun operator()(const knit::CycleGathered&) const { return {0, 0}; }
  LinesRun operator()(const knit::CycleOrdered&) const { return {1, 2}; }
  LinesRun operator()(const knit::CandidateMeasured& s) const {
    switch (s.verdict) {
      case knit::Verdict::too_near:
        return {4, 5};
      case knit::Verdict::accepted:
        return {4, 6};
      case knit::Verdict::too_far:
        return {4, 7};
    }
    return {};
  }
  LinesRun operator()(const knit::BandMissed&) const { return {8, 8}; }
  LinesRun operator()(const knit::RowClosed&) const { return {9, 9}; }
  LinesRun operator()(const knit::RowResampled&) const { return {10, 10}; }
  LinesRun operator()(const knit::GapShared&) const { return {11, 11}; }

  LinesRun operator()(const knit::RowsPlanned&) const { return {0, 0}; }
  LinesRun operator()(const knit::CutFound&) const { return {2, 2}; }
  LinesRun operator()(const knit::LoopClosed&) const { return {3, 3}; }
  LinesRun operator()(const knit::LengthMeasured&) const { return {4, 4}; }
  LinesRun operator()(const knit::CountChosen& s) const {
    switch (s.reason) {
      case knit::CountReason::as_cast_on:
        return {5, 5};
      case knit::CountReason::ideal:
        return {6, 6};
      case knit::CountReason::at_least_three:
      case knit::CountReason::at_most_double:
      case knit::CountReason::at_least_half:
        return {6, 7};
      case knit::CountReason::room_ahead:
        return {6, 8};
    }
    return {};
  }
  LinesRun operator()(const knit::StitchPlaced&) const { return {10, 10}; }

  LinesRun operator()(const knit::TransitionCounted&) const {
    return is(Listing::index_nearest) ? LinesRun{0, 0} : LinesRun{0, 1};
  }
  // The rules are tried in turn, up to the one that was taken.
  LinesRun operator()(const knit::SpacingChosen& s) const {
    const bool even = is(Listing::index_even);
    switch (s.rule) {
      case knit::Rule::from_cast_on:
        return {2, 2};
      case knit::Rule::plain:
        return even ? LinesRun{2, 2} : LinesRun{2, 3};
      case knit::Rule::equal:
        return {2, 4};
      case knit::Rule::follow:
        return {2, 5};
      case knit::Rule::remainder_last:
        return {2, 6};
      case knit::Rule::dense:
        return even ? LinesRun{2, 4} : LinesRun{2, 7};
      case knit::Rule::even:
      case knit::Rule::nearest:
        break;
    }
    return {2, 3};
  }
  LinesRun operator()(const knit::RowsMatched&) const { return {2, 2}; }
  LinesRun operator()(const knit::MainPlaced&) const {
    return is(Listing::index_nearest) ? LinesRun{3, 3} : from_end(3);
  }
  LinesRun operator()(const knit::ShapingPlaced& s) const {
    if (is(Listing::index_nearest)) return {4, 4};
    return s.label == knit::Label::m1r || s.label == knit::Label::ssk ? from_end(2) : from_end(1);
  }

  LinesRun operator()(const knit::FaceMade& s) const {
    return s.corner_count == 4 ? LinesRun{1, 3} : LinesRun{1, 4};
  }
  LinesRun operator()(const knit::LineWritten&) const {
    if (place.item > 0) return {4, 4};
    return place.row == 1 ? LinesRun{0, 0} : LinesRun{2, 3};
  }

  LinesRun operator()(const knit::Stopped& s) const {
    switch (s.reason) {
      case knit::StopReason::no_extent:
        return is(Listing::timing_linear) ? LinesRun{0, 1} : LinesRun{0, 0};
      case knit::StopReason::no_row_levels:
        return is(Listing::cast_on) ? LinesRun{1, 2} : LinesRun{0, 0};
      case knit::StopReason::not_a_ring:
        return {1, 1};
      case knit::StopReason::splits:
        return is(Listing::rows_contours) ? LinesRun{3, 3} : LinesRun{1, 1};
      case knit::StopReason::stall:
        return {8, 8};
      case knit::StopReason::changes_too_much:
        return {10, 10};
      case knit::StopReason::too_fine:
        return {0, 0};
    }
    return {};
  }
};

bool is_word(char c) { return c >= 'a' && c <= 'z'; }

// Keywords of a stretch without variables.
void add_words(std::string_view text, std::vector<CodePart>& parts) {
  std::size_t from = 0;
  for (std::size_t at = 0; at < text.size();) {
    std::size_t end = at;
    while (end < text.size() && is_word(text[end])) ++end;
    const std::string_view word = text.substr(at, end - at);
    if (std::find(keywords.begin(), keywords.end(), word) != keywords.end()) {
      if (at > from) parts.push_back({CodePart::Kind::plain, text.substr(from, at - from)});
      parts.push_back({CodePart::Kind::keyword, word});
      from = end;
    }
    at = std::max(end, at + 1);
  }
  if (from < text.size()) parts.push_back({CodePart::Kind::plain, text.substr(from)});
}

}  // namespace

const PseudoCode& code_of(Listing listing) {
  if (listing <= Listing::timing_harmonic) return timing_code(listing);
  return listing <= Listing::rows_contours ? rows_code(listing) : stitch_code(listing);
}

Listing listing_of(const knit::Step& step, const knit::Parameters& parameters) {
  return knit::visit_event(ListingOf{listing_at(step.place.stage, parameters)}, step.what);
}

LinesRun lines_of(const knit::Step& step, const knit::Parameters& parameters) {
  return knit::visit_event(LinesOf{listing_of(step, parameters), step.place}, step.what);
}

std::size_t line_of(const knit::Step& step, const knit::Parameters& parameters) {
  return lines_of(step, parameters).last;
}

std::vector<CodePart> parts_of(const CodeLine& line) {
  std::vector<CodePart> parts;
  std::string_view rest = line.text;
  while (!rest.empty()) {
    const std::size_t open = std::min(rest.find('{'), rest.size());
    add_words(rest.substr(0, open), parts);
    if (open == rest.size()) break;
    const std::size_t close = rest.find('}', open);
    parts.push_back({CodePart::Kind::variable, rest.substr(open + 1, close - open - 1)});
    rest.remove_prefix(close + 1);
  }
  return parts;
}

std::string shown_text(const CodeLine& line) {
  std::string text;
  for (const CodePart& part : parts_of(line))
    text += part.kind == CodePart::Kind::variable ? variable_named(part.text).symbol : part.text;
  return text;
}

std::vector<std::string_view> variable_names_of(Listing listing) {
  std::vector<std::string_view> names;
  const auto add = [&](std::string_view name) {
    if (!name.empty() && std::find(names.begin(), names.end(), name) == names.end()) names.push_back(name);
  };
  const PseudoCode& code = code_of(listing);
  for (const CodeLine& line : code.lines) {
    for (const CodePart& part : parts_of(line)) {
      if (part.kind == CodePart::Kind::variable) add(part.text);
    }
    add(line.value);
  }
  for (const std::string_view name : code.aside) add(name);
  return names;
}

std::optional<Explained> explained(const Session& session) {
  if (!session.document) return std::nullopt;
  const knit::Timeline& timeline = session.document->timeline;
  Explained at;
  const knit::Step* stop = stop_shown(session);
  at.stopped = stop != nullptr;
  at.step = at.stopped ? stop : last_step(session);
  if (at.step == nullptr) {
    at.listing = listing_at(timeline.state().stage(), timeline.parameters());
    return at;
  }
  const knit::Parameters& parameters =
      at.stopped ? timeline.parameters_of_stop() : timeline.parameters_of_step(timeline.position() - 1);
  at.listing = listing_of(*at.step, parameters);
  at.lines = lines_of(*at.step, parameters);
  return at;
}

}  // namespace app
