#include "app/core/asked_at_start.h"

#include <utility>

#include "app/core/opening.h"

namespace app {

namespace {

std::filesystem::path offered_in(const Session& session) {
  return session.mend_offer ? session.mend_offer->source.file : std::filesystem::path();
}

}  // namespace

AskedAtStart::AskedAtStart(const Session& session)
    : opening_(session.opening), offered_(session.timeline ? std::filesystem::path() : offered_in(session)) {}

AskedAtStart::Mesh AskedAtStart::mesh_in(const Session& session) const {
  if (opening_) {
    if (session.opening == opening_) return Mesh::pending;
    return session.timeline && !opening_->progress->stopped() ? Mesh::open : Mesh::other;
  }
  if (offered_in(session) == offered_ || session.opening) return Mesh::pending;
  return session.timeline && session.source.file == offered_ ? Mesh::open : Mesh::other;
}

bool AskedAtStart::tend(Session& session, const CommandLine& line) {
  if (!opening_ && offered_.empty()) return false;
  const Mesh mesh = mesh_in(session);
  if (mesh == Mesh::pending) return false;
  const auto opening = std::exchange(opening_, nullptr);
  offered_.clear();
  if (mesh == Mesh::other) {
    // Read, and unfit: the offer is the next thing to wait for.
    if (opening && offered_in(session) == opening->path) offered_ = opening->path;
    return false;
  }
  if (auto error = set_as_asked(session, line))
    session.notices.push_back({Notice::Kind::error, std::move(*error)});
  return true;
}

}  // namespace app
