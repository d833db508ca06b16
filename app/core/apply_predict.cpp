#include <algorithm>

#include "app/core/apply_parts.h"
#include "app/core/predict.h"
#include "knit/narrate.h"

namespace app {

namespace {

const knit::CandidateMeasured* measured_at(const knit::Timeline& timeline, std::size_t index) {
  return index < timeline.known() ? std::get_if<knit::CandidateMeasured>(&timeline.step(index).what)
                                  : nullptr;
}

}  // namespace

std::optional<AskedVertex> asked_vertex(const Session& session) {
  if (!session.prediction || !session.timeline || session.timeline->sought()) return std::nullopt;
  const auto* next = measured_at(*session.timeline, session.timeline->position());
  return next != nullptr ? std::optional(AskedVertex{next->anchor, next->candidate}) : std::nullopt;
}

std::optional<std::size_t> verdict_ahead(const Session& session, std::size_t end) {
  if (!session.prediction) return std::nullopt;
  for (std::size_t position = session.timeline->position(); position <= end; ++position) {
    if (measured_at(*session.timeline, position) != nullptr) return position;
  }
  return std::nullopt;
}

void wait_for_guess(Session& session) {
  Prediction prediction = *session.prediction;
  prediction.playing_from = session.timeline->position();
  session.prediction = std::make_shared<const Prediction>(std::move(prediction));
}

void take(Session& session, const SetPredicting& action) {
  if (action.on == (session.prediction != nullptr)) return;
  session.prediction = action.on ? std::make_shared<const Prediction>() : nullptr;
}

void take(Session& session, const Guess& action) {
  if (!asked_vertex(session)) return;
  knit::Timeline& timeline = *session.timeline;
  const std::size_t index = timeline.position();
  const knit::Verdict verdict = measured_at(timeline, index)->verdict;
  const std::string words = knit::narrate(timeline.step(index), timeline.parameters_of_step(index));
  Prediction prediction = *session.prediction;
  const bool right = action.verdict == verdict;
  ++prediction.guessed;
  prediction.right += right ? 1 : 0;
  prediction.streak = right ? prediction.streak + 1 : 0;
  const bool plays_on = prediction.playing_from == index;
  prediction.playing_from.reset();
  prediction.told = Prediction::Told{index + 1, right, words};
  std::int32_t& longest = session.preferences.longest_streak;
  longest = std::max(longest, prediction.streak);
  session.prediction = std::make_shared<const Prediction>(std::move(prediction));
  timeline.seek(index + 1);
  session.playback.playing = plays_on;
  session.playback.direction = 1;
}

void tend_prediction(Session& session) {
  if (!session.prediction || !session.timeline) return;
  knit::Timeline& timeline = *session.timeline;
  // Whether a verdict comes next can be said only once its step is there; taking it later is another matter.
  if (timeline.position() == timeline.known() && !timeline.complete() && !timeline.sought())
    session.beside ? timeline.extend_briefly(1) : timeline.extend(1);
  const auto& told = session.prediction->told;
  if (!told || told->position == timeline.position()) return;
  Prediction prediction = *session.prediction;
  prediction.told.reset();
  session.prediction = std::make_shared<const Prediction>(std::move(prediction));
}

}  // namespace app
