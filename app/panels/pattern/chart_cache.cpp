#include "app/panels/pattern/chart_cache.h"

#include <algorithm>

#include "app/session/document.h"
#include "app/session/remarks.h"
#include "app/session/view.h"
#include "knit/limbs/limb_plan.h"
#include "knit/model/hash.h"
#include "knit/pattern/limb_words.h"
#include "knit/pattern/pattern_words.h"

namespace app {

namespace {

std::uint64_t key_of(const knit::State& state) {
  knit::Hasher hasher;
  hasher.add(state.fabric.empty() ? 0 : state.fabric.rows().front().content_hash());
  for (const auto& join : state.fabric.joins()) hasher.add(join.content_hash());
  hasher.add(state.fabric.rows().size());
  for (const auto& rhythm : state.rhythms) hasher.add(rhythm.content_hash());
  for (const auto& deal : state.fabric.deals()) hasher.add(deal.content_hash());
  return hasher.value();
}

std::uint64_t key_of(std::uint64_t run, const std::vector<std::string>& order, knit::GraftBy graft) {
  knit::Hasher hasher;
  hasher.add(run);
  hasher.add(static_cast<std::uint64_t>(graft));
  for (const std::string& letters : order) knit::hash_into(hasher, std::string_view(letters));
  return hasher.value();
}

std::uint64_t key_of(std::uint64_t planned, const knit::Parameters& parameters,
                     const knit::PatternOptions& options, const PatternPieces& pieces) {
  const knit::Gauge& gauge = parameters.stitch.gauge;
  knit::Hasher hasher;
  hasher.add(planned);
  for (const std::string* words : {&options.title, &options.yarn, &options.colour})
    knit::hash_into(hasher, std::string_view(*words));
  for (const double number :
       {options.needle_mm.value_or(0.0), gauge.stitches, gauge.rounds, parameters.size.height_cm})
    knit::hash_into(hasher, number);
  for (const auto& [letters, word] : pieces.names) {
    knit::hash_into(hasher, std::string_view(letters));
    knit::hash_into(hasher, std::string_view(word));
  }
  hasher.add((options.markers ? 1U : 0U) + (options.stars ? 2U : 0U) +
             4U * static_cast<unsigned>(options.form) + 16U * static_cast<unsigned>(options.turns));
  return hasher.value();
}

}  // namespace

void ChartCache::make_pieces(const Session& session, std::uint64_t planned) {
  const knit::Timeline& timeline = session.document->timeline;
  const PatternPieces& said = session.document->pieces;
  if (planned != planned_) {
    pieces_ =
        planned_pieces(timeline.furthest(), said, session.view->pattern, timeline.parameters().pattern.graft);
    piece_charts_.clear();
  }
  planned_ = planned;
  name_pieces(pieces_, said, session.view->pattern);
  if (piece_charts_.empty() || pieces_.options.piece_names != names_charted_) {
    names_charted_ = pieces_.options.piece_names;
    piece_charts_ = knit::piece_charts(pieces_.plan, knit::LimbNames(pieces_.plan, pieces_.options));
  }
  const knit::Parameters& parameters = timeline.parameters();
  pattern_ = knit::write_pattern(pieces_.plan, parameters.stitch.gauge, pieces_.options,
                                 timeline.input().mesh.name, parameters.size.height_cm);
}

void ChartCache::refresh(const Session& session) {
  const knit::Timeline& timeline = session.document->timeline;
  const knit::State& state = timeline.furthest();
  const knit::Gauge& gauge = timeline.parameters().stitch.gauge;  // as for a file
  const PatternPieces& said = session.document->pieces;
  const std::uint64_t planned = key_of(key_of(state), said.order, timeline.parameters().pattern.graft);
  const auto& closeness = session.document->closeness;
  knit::Hasher measured;
  measured.add(key_of(planned, timeline.parameters(), session.view->pattern, said));
  measured.add(closeness && closeness->coverage ? 1U : 0U);
  const std::uint64_t key = measured.value();
  if (key == key_) return;
  key_ = key;
  chart_ = {};
  stitches_ = {};
  written_ = {};
  pattern_ = {};
  written_out_.clear();
  rhythms_ = rhythm_figures_of(state);
  in_pieces_ = knit::has_limbs(state);
  if (in_pieces_ && knit::limbs_are_known(state)) {
    make_pieces(session, planned);
    return add_notes(session);
  }
  planned_ = 0;
  pieces_ = {};
  piece_charts_.clear();
  if (in_pieces_ || state.fabric.joins().empty()) return;
  const knit::Rounds rounds = knit::rounds_of(state);
  chart_ = knit::chart_of(rounds);
  stitches_ = knit::ChartStitches(state.fabric, chart_);
  written_ = knit::written_rows(state.fabric);
  const knit::PatternOptions options = in_form(session.view->pattern, state);
  pattern_ = knit::write_pattern(rounds, gauge, options, timeline.input().mesh.name);
  if (options.form == knit::PatternForm::short_form) written_out_ = knit::round_lines(rounds, options);
  number_rows(state.fabric);
  add_notes(session);
}

void ChartCache::add_notes(const Session& session) {
  const auto& closeness = session.document->closeness;
  const knit::Coverage* coverage = closeness && closeness->coverage ? &*closeness->coverage : nullptr;
  say_how_it_came_out(pattern_, session.document->timeline, coverage, in_pieces_ ? &pieces_ : nullptr);
}

namespace {

bool says(const knit::RoundLine& line, std::int32_t round) {
  return line.first <= round && round <= line.last;
}

bool turns(const knit::RoundLine& line) { return line.label.starts_with("Short row "); }

// Of the lines of rounds, in order, that of a row.
template <class Lines, class LineOf>
std::string line_in(const Lines& lines, const LineOf& line_of, const knit::WrittenRow& row) {
  std::string found;
  std::int32_t number = 0;
  for (const auto& each : lines) {
    const knit::RoundLine* line = line_of(each);
    if (line == nullptr || !says(*line, row.round)) continue;
    if (!line->short_row) return row.short_row == 0 ? line->text() : found;
    if (turns(*line)) ++number;
    if (number == row.short_row) found += (found.empty() ? "" : "\n") + line->text();
  }
  return found;
}

}  // namespace

// The lines of the text stand for rows of the fabric, which numbers short rows too.
void ChartCache::number_rows(const knit::Fabric& fabric) {
  std::int32_t round = 0, number = 0;
  for (auto& instruction : pattern_.instructions) {
    if (!instruction.round) continue;
    knit::RoundLine& line = *instruction.round;
    if (line.first != round) number = 0;
    round = line.first;
    if (line.short_row && turns(line)) ++number;
    const knit::WrittenRow wanted{round, line.short_row ? number : 0};
    const auto found = std::find(written_.begin(), written_.end(), wanted);
    const bool known = found != written_.end() && fabric.has_row(round);
    if (known) line.rows_before = static_cast<std::int32_t>(found - written_.begin()) + 1 - round;
  }
}

std::string ChartCache::line_of(std::int32_t row) const {
  if (row == 1) return pattern_.start;
  const knit::WrittenRow at = written(row);
  std::string line = line_in(
      written_out_, [](const knit::RoundLine& l) { return &l; }, at);
  return line.empty() ? line_in_pattern(at) : line;
}

std::string ChartCache::short_line_of(std::int32_t row) const {
  const std::string line = written_out_.empty() || row == 1 ? "" : line_in_pattern(written(row));
  return line == line_of(row) ? "" : line;
}

std::string ChartCache::line_in_pattern(const knit::WrittenRow& row) const {
  const auto line_of = [](const knit::WrittenPattern::Instruction& instruction) {
    return instruction.round ? &*instruction.round : nullptr;
  };
  return line_in(pattern_.instructions, line_of, row);
}

}  // namespace app
