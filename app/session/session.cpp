#include "app/session/session.h"

#include "knit/insight/narrate.h"

namespace app {

namespace {
constexpr std::array<std::string_view, layer_count> layer_names{
    "Surface",    "Time colours",         "Isolines of time", "Critical points",
    "Mesh edges", "Cycle and candidates", "Anchor and band",  "Stitches",
    "Row edges",  "Column edges",         "Faces by label"};
constexpr std::array<std::string_view, layer_count> layer_keys{
    "surface", "times",    "isolines",  "criticals",    "wire", "cycle",
    "band",    "stitches", "row-edges", "column-edges", "faces"};
}  // namespace

std::string_view name_of(Layer layer) { return layer_names.at(static_cast<std::size_t>(layer)); }
std::string_view key_of(Layer layer) { return layer_keys.at(static_cast<std::size_t>(layer)); }

Session::Session() = default;
Session::Session(const Session& other) = default;
Session::Session(Session&& other) noexcept = default;
Session& Session::operator=(const Session& other) = default;
Session& Session::operator=(Session&& other) noexcept = default;
Session::~Session() = default;

const knit::Step* last_step(const Session& session) {
  if (!session.timeline || session.timeline->position() == 0) return nullptr;
  return &session.timeline->step(session.timeline->position() - 1);
}

const knit::Parameters& parameters_of_last_step(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  return timeline.position() == 0 ? timeline.parameters()
                                  : timeline.parameters_of_step(timeline.position() - 1);
}

const knit::Step* stop_shown(const Session& session) {
  if (!session.timeline) return nullptr;
  const knit::Timeline& timeline = *session.timeline;
  return timeline.complete() && timeline.position() == timeline.known() ? timeline.stop() : nullptr;
}

std::string sentence(const Session& session) {
  if (!session.timeline) return "No mesh is open. Choose an example, or open a mesh.";
  if (const knit::Step* stop = stop_shown(session))
    return knit::narrate(*stop, session.timeline->parameters());
  const knit::Step* step = last_step(session);
  if (step == nullptr && session.lesson) return "Nothing has been done yet.";  // what to do the lesson says
  if (step == nullptr)
    return "Nothing has been done yet: press Space to play, or the right arrow for one step.";
  return knit::narrate(*step, parameters_of_last_step(session));
}

std::shared_ptr<const knit::Closeness> closeness_now(const Session& session) {
  const knit::Timeline& timeline = *session.timeline;
  if (session.closeness && session.closeness_run == knit::hash_of(timeline.state())) return session.closeness;
  const auto measured = knit::measure_closeness(timeline.input(), timeline.state());
  return measured ? std::make_shared<const knit::Closeness>(*measured) : nullptr;
}

}  // namespace app
