// What whoever runs a session beside its actions does with it: a window's loop, a program without a window, a
// script. It takes what is to be handed over, says what became of it, and has work done at once.
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "app/session/outbox.h"
#include "app/session/pins.h"
#include "app/session/program.h"
#include "app/session/session.h"

namespace app {

// Nothing is open. `assets`: the folder of examples and fonts.
Session new_session(std::filesystem::path assets);

// Whether long work is done beside a window from now on; what it was.
bool set_beside(Session& session, bool beside);
// In a page of others, from now on: without menus.
void embed(Session& session);
void offer_rescued(Session& session, std::optional<Rescued> rescued);

void notify(Session& session, Notice::Kind kind, std::string words);
// "Saved PATH.", or why not.
void notify_saved(Session& session, const std::filesystem::path& path,
                  const std::optional<std::string>& error);

// Each is there once. Pictures, pages and screenshots; what they become is drawn before the next actions are done.
Outbox take_outgoing(Session& session);
std::optional<std::string> take_clipboard(Session& session);
std::vector<Notice> take_notices(Session& session);
// Of the animation in the making, which there must be.
void note_frames_made(Session& session, std::size_t frames);

// The whole run, now. This and what follows it require something open.
void work_out(Session& session);
// No jump: there is no way back from it.
void show_position(Session& session, std::size_t position);
void pin(Session& session, Pin pinned);
// Undoing ends here.
void forget_changes(Session& session);
// The run and all that is worked out from it, for a picture; with nothing open there is nothing to do.
void make_whole(Session& session);

}  // namespace app
