#include "app/session/remarks.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <iterator>
#include <optional>
#include <utility>

#include "app/session/document.h"
#include "knit/insight/knitted_remarks.h"
#include "knit/limbs/limb_plan.h"
#include "knit/pattern/limb_notes.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/rounds.h"
#include "knit/pattern/written_pattern.h"
#include "knit/rhythm/rhythm_words.h"
#include "knit/run/machine.h"

namespace app {

namespace {

// Edits on the way may leave a tube with other counts than were planned.
bool is_kept(const knit::State& state, const knit::TubeRhythm& rhythm) {
  const auto keeps = [&](const auto& row) {
    return is_short(*row) || row->tube != rhythm.tube || !rhythm.has(row->level) ||
           rhythm.count(row->level) == size_of(*row);
  };
  const auto& rows = state.fabric.rows();
  return std::all_of(rows.begin(), rows.end(), keeps);
}

// A sentence, and the pieces that it says the rhythm of.
struct PiecesInRhythm {
  std::string sentence;
  std::vector<std::int32_t> pieces;
};

// Pieces that are knitted plain, or whose few rounds have no rhythm, have no sentence.
std::vector<std::string> rhythm_notes(const knit::State& state, const PlannedPieces& planned) {
  const std::vector<const knit::TubeRhythm*> rhythms = rhythms_of_run(state);
  std::vector<PiecesInRhythm> told;
  for (std::int32_t piece = 0; piece < planned.plan.count(); ++piece) {
    const knit::TubeId tube = planned.plan.piece(piece).tube;
    const auto of_tube = std::find_if(rhythms.begin(), rhythms.end(),
                                      [&](const knit::TubeRhythm* rhythm) { return rhythm->tube == tube; });
    if (of_tube == rhythms.end() || (*of_tube)->none != knit::NoRhythm::no) continue;
    const knit::RhythmPlan& plan = (*of_tube)->plan;
    std::string sentence = knit::segments_sentence(plan.segments, !plan.fronts.empty());
    if (sentence.empty()) continue;
    const auto same = std::find_if(told.begin(), told.end(),
                                   [&](const PiecesInRhythm& one) { return one.sentence == sentence; });
    if (same != told.end())
      same->pieces.push_back(piece);
    else
      told.push_back({std::move(sentence), {piece}});
  }
  const knit::LimbNames names(planned.plan, planned.options);
  std::vector<std::string> notes;
  notes.reserve(told.size());
  for (const PiecesInRhythm& one : told)
    notes.push_back("Rhythm of " + names.listed(one.pieces) + ": " + one.sentence + ".");
  return notes;
}

}  // namespace

knit::PieceSize size_knitted(const knit::State& state, const knit::Gauge& gauge) {
  if (!knit::has_limbs(state)) {
    const knit::PatternSizes sizes = knit::sizes_of(knit::rounds_of(state), gauge);
    if (sizes.longer_cm > sizes.height_cm) return {std::nullopt, sizes.around_cm};  // it bends
    return {sizes.height_cm, sizes.around_cm};
  }
  std::int32_t most = 0;
  for (const auto& row : state.fabric.rows()) most = std::max(most, knit::size_of(*row));
  return {std::nullopt, 10.0 * most / gauge.stitches};
}

std::vector<knit::Remark> remarks_of(const knit::Timeline& timeline, const knit::Coverage* coverage) {
  const knit::State& state = timeline.furthest();
  if (!state.finished()) return {};
  const knit::Parameters parameters = knit::as_chosen(timeline.parameters_of_stop(), state);
  std::vector<knit::Remark> remarks;
  const auto add = [&](std::optional<knit::Remark> remark) {
    if (remark) remarks.push_back(std::move(*remark));
  };
  add(knit::remark_on_size(size_knitted(state, parameters.stitch.gauge), knit::size_asked(state, parameters),
                           parameters));
  add(knit::remark_on_swatch(parameters));
  add(knit::remark_on_placement(state, timeline.parameters_of_stop()));
  if (state.relaxed) {
    std::vector<knit::Remark> of_piece = knit::remarks_on(state.fabric, *state.relaxed, parameters);
    std::move(of_piece.begin(), of_piece.end(), std::back_inserter(remarks));
  }
  if (coverage == nullptr) return remarks;
  std::vector<knit::Remark> of_rows = knit::remarks_on(*coverage, parameters);
  std::move(of_rows.begin(), of_rows.end(), std::back_inserter(remarks));
  return remarks;
}

std::optional<knit::Element> thing_of(const knit::Remark& remark) {
  if (remark.at) return knit::StitchElement{remark.at->row, remark.at->stitch};
  if (remark.uncovered()) return knit::VertexElement{remark.vertex};
  return std::nullopt;
}

std::vector<ListedRemark> listed_remarks(const Session& session) {
  const Document& document = *session.document;
  std::vector<ListedRemark> listed;
  for (const knit::RepairStep& step : document.repaired) listed.push_back({"Mesh: " + step.did, {}});
  for (const knit::Finding& finding : document.findings) listed.push_back({"Mesh: " + finding.sentence, {}});
  if (!document.closeness || !document.closeness->coverage) return listed;
  for (const knit::Remark& remark : remarks_of(document.timeline, &*document.closeness->coverage))
    listed.push_back({"Piece: " + remark.words, thing_of(remark)});
  return listed;
}

std::vector<std::string> notes_of(const std::vector<knit::Remark>& remarks) {
  std::array<bool, knit::remark_keys.size()> said{};
  std::vector<std::string> notes;
  for (const knit::Remark& remark : remarks) {
    bool& of_kind = said.at(static_cast<std::size_t>(remark.kind));
    if (!of_kind) notes.push_back("Not as asked: " + remark.words);
    of_kind = true;
  }
  return notes;
}

std::vector<std::string> pattern_notes(const knit::Timeline& timeline, const knit::Coverage* coverage,
                                       const PlannedPieces* pieces) {
  const knit::State& state = timeline.furthest();
  std::vector<std::string> notes = pieces != nullptr
                                       ? rhythm_notes(state, *pieces)
                                       : rhythm_sentences_of(state, timeline.parameters().stitch.gauge);
  std::vector<knit::Remark> remarks = remarks_of(timeline, coverage);
  if (state.relaxed) {
    // Said already, as the pattern's size.
    std::erase_if(remarks, [](const knit::Remark& remark) {
      return remark.kind == knit::RemarkKind::knitted && remark.words.starts_with("Knitted");
    });
  }
  std::vector<std::string> not_as_asked = notes_of(remarks);
  std::move(not_as_asked.begin(), not_as_asked.end(), std::back_inserter(notes));
  return notes;
}

void say_how_it_came_out(knit::WrittenPattern& pattern, const knit::Timeline& timeline,
                         const knit::Coverage* coverage, const PlannedPieces* pieces) {
  const knit::State& state = timeline.furthest();
  if (state.relaxed) {
    const knit::Parameters parameters = knit::as_chosen(timeline.parameters_of_stop(), state);
    if (!knit::is_without_size(*state.relaxed, parameters)) {
      pattern.size = {knit::about_size_text(state.relaxed->figures, parameters)};
      if (pieces != nullptr) pattern.size.front() += knit::where_sizes_stand;
    }
  }
  for (std::string& note : pattern_notes(timeline, coverage, pieces))
    pattern.notes.push_back(std::move(note));
}

std::vector<const knit::TubeRhythm*> rhythms_of_run(const knit::State& state) {
  std::vector<const knit::TubeRhythm*> rhythms;
  if (!state.tubes) return rhythms;
  for (std::size_t tube = 0; tube < state.tubes->tubes.size(); ++tube) {
    const knit::TubeRhythm* rhythm = knit::rhythm_of(state.rhythms, static_cast<knit::TubeId>(tube));
    if (rhythm != nullptr && is_kept(state, *rhythm)) rhythms.push_back(rhythm);
  }
  return rhythms;
}

const knit::TubeRhythm* rhythm_of_run(const knit::State& state) {
  if (!state.tubes || state.tubes->tubes.size() != 1) return nullptr;
  const std::vector<const knit::TubeRhythm*> all = rhythms_of_run(state);
  return !all.empty() && all.front()->none == knit::NoRhythm::no ? all.front() : nullptr;
}

std::vector<std::string> rhythm_sentences_of(const knit::State& state, const knit::TubeRhythm& rhythm,
                                             const knit::Gauge& gauge) {
  const std::vector<double>& lengths = state.tubes->tube(rhythm.tube).lengths;
  const std::ptrdiff_t from =
      std::clamp<std::ptrdiff_t>(rhythm.from, 0, std::max<std::ptrdiff_t>(0, std::ssize(lengths) - 1));
  const auto longest = std::max_element(lengths.begin() + from, lengths.end());
  if (longest == lengths.end()) return {};
  return knit::rhythm_sentences(rhythm, *longest / rhythm.stitch_width, gauge.stitches);
}

std::vector<std::string> rhythm_sentences_of(const knit::State& state, const knit::Gauge& gauge) {
  const knit::TubeRhythm* rhythm = rhythm_of_run(state);
  return rhythm != nullptr ? rhythm_sentences_of(state, *rhythm, gauge) : std::vector<std::string>{};
}

knit::PatternOptions in_form(knit::PatternOptions options, const knit::State& state) {
  if (options.form == knit::PatternForm::by_itself)
    options.form = rhythm_of_run(state) != nullptr ? knit::PatternForm::short_form : knit::PatternForm::full;
  return options;
}

}  // namespace app
