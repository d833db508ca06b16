#include "app/files/session_file.h"

#include <algorithm>
#include <cctype>
#include <chrono>
#include <fstream>
#include <utility>

#include "app/base/files.h"
#include "app/curves/curves_file.h"
#include "app/files/session_json.h"
#include "app/session/document.h"
#include "knit/model/settings_table.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_bytes = std::size_t{16} << 20U;

fs::path absolute_of(const fs::path& path) {
  std::error_code error;
  const fs::path absolute = fs::absolute(path, error);
  return (error ? path : absolute).lexically_normal();
}

// Beside the session file or below its folder: as seen from there, so that both can be moved together.
fs::path mesh_reference(const fs::path& mesh, const fs::path& session_file) {
  fs::path absolute = absolute_of(mesh);
  if (session_file == "-") return absolute;
  const fs::path near = absolute.lexically_relative(absolute_of(session_file).parent_path());
  const bool below = !near.empty() && *near.begin() != "..";
  return below ? near : absolute;
}

std::variant<SavedSession, std::string> read_file(const fs::path& path) {
  std::error_code error;
  if (!fs::exists(path, error)) return path.string() + " does not exist; give a session file.";
  if (fs::is_directory(path, error)) return path.string() + " is a folder; give a session file.";
  std::ifstream in(path, std::ios::binary);
  std::string text(most_bytes + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  if (in.bad() || (text.empty() && !in.eof()))
    return path.string() + " cannot be read; see to its permissions.";
  if (text.size() > most_bytes)
    return path.string() +
           " is larger than 16 MB, so it is no session; give a file that --save-session wrote.";
  auto saved = read_saved(text);
  if (const auto* fault = std::get_if<std::string>(&saved)) return path.string() + ": " + *fault;
  // From here on the mesh is where it lies.
  Source& source = std::get<SavedSession>(saved).source;
  if (!source.file.empty()) source.file = (path.parent_path() / source.file).lexically_normal();
  return saved;
}

std::variant<Loaded, std::string> load_source(const fs::path& assets, const Source& source,
                                              const fs::path& path, knit::Progress* progress) {
  if (source.file.empty()) {
    auto loaded = load_example(assets, source.example);
    if (const auto* ready = std::get_if<Loaded>(&loaded); ready != nullptr && !source.curves.empty())
      loaded = load_again(ready->original, ready->parameters, progress, source.curves);
    if (const auto* error = std::get_if<std::string>(&loaded)) return path.string() + ": " + *error;
    return loaded;
  }
  std::error_code error;
  if (!fs::exists(source.file, error)) {
    return path.string() + ": its mesh is not there, looked for " + absolute_of(source.file).string() +
           "; put it there, or change \"file\" in the session's \"source\".";
  }
  return load_file(source.file, source.repairs, progress, source.curves);
}

// A run to be shown: the mesh welded as its parameters say.
struct Prepared {
  std::shared_ptr<const knit::Input> input;
  std::vector<knit::Finding> findings;
};

// What a person cannot do in the window cannot be read from a file either.
std::optional<std::string> fault_of_edits(const Knobs& knobs, const knit::Input& input) {
  const knit::Parameters* before = &knobs.base;
  for (const knit::Edit& edit : knobs.edits) {
    if (auto fault = knit::fault_of(edit.parameters, input)) return fault;
    if (knit::why_not_from_here(*before, edit.parameters, edit.at))
      return "an edit changes weld or rows on the way, which only the whole run can; make them equal.";
    before = &edit.parameters;
  }
  return std::nullopt;
}

std::variant<Prepared, std::string> prepare(const Loaded& loaded, const Knobs& knobs, const fs::path& path) {
  Prepared prepared{loaded.input, loaded.findings};
  if (!made_alike(knobs.base, loaded.parameters, loaded.curves)) {
    auto again = load_again(loaded.original, knobs.base, nullptr, loaded.curves);
    if (const auto* error = std::get_if<std::string>(&again)) return path.string() + ": " + *error;
    prepared = {std::get<Loaded>(again).input, std::get<Loaded>(again).findings};
  }
  auto fault = knit::fault_of(knobs.base, *prepared.input);
  if (!fault) fault = fault_of_edits(knobs, *prepared.input);
  if (fault) return path.string() + ": " + *fault;
  return prepared;
}

// Its end is worked out when it is wanted.
Pin pin_of(const Prepared& prepared, const Knobs& knobs) {
  knit::Timeline timeline(prepared.input, knobs.base);
  timeline.set_knobs(knobs.base, knobs.edits);
  Pin pin;
  pin.input = prepared.input;
  pin.knobs = knobs_of(timeline);
  return pin;
}

std::string begin_of(const fs::path& path) {
  constexpr std::size_t enough = 4096;
  std::ifstream in(path, std::ios::binary);
  std::string text(enough, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(std::max<std::streamsize>(in.gcount(), 0)));
  return text;
}

}  // namespace

SessionText session_text(const Session& session, const fs::path& path) {
  if (!session.document) return {"", "nothing is open, so there is no session to save; open a mesh first."};
  if (session.document->source.file.empty() && session.document->source.example.empty())
    return {"", "the mesh came from no file, so a session cannot name it; open it from a file."};
  SavedSession saved = saved_of(session);
  if (!saved.source.file.empty()) saved.source.file = mesh_reference(saved.source.file, path);
  saved.mesh_hash = session.document->mesh_hash;
  if (saved.mesh_hash.empty() && session.document->original != nullptr)
    saved.mesh_hash = hash_text(*session.document->original);
  try {
    return {to_json(saved).dump(2) + "\n", ""};
  } catch (const nlohmann::json::exception&) {
    return {"", "the mesh's file name or the pattern's words are not valid UTF-8; rename the file."};
  }
}

std::optional<std::string> save_session(const Session& session, const fs::path& path) {
  const SessionText said = session_text(session, path);
  if (!said.error.empty()) return said.error;
  return write_file(path, said.text);
}

std::variant<OpenedSession, std::string> read_session(const fs::path& assets, const fs::path& path,
                                                      knit::Progress* progress) {
  auto read = read_file(path);
  if (auto* error = std::get_if<std::string>(&read)) return std::move(*error);
  OpenedSession opened;
  opened.path = path;
  opened.saved = std::get<SavedSession>(std::move(read));
  const SavedSession& saved = opened.saved;
  auto source = load_source(assets, saved.source, path, progress);
  if (auto* error = std::get_if<std::string>(&source)) return std::move(*error);
  opened.loaded = std::get<Loaded>(std::move(source));
  auto prepared = prepare(opened.loaded, saved.knobs, path);
  if (auto* error = std::get_if<std::string>(&prepared)) return std::move(*error);
  if (saved.pinned) {
    auto other = prepare(opened.loaded, *saved.pinned, path);
    if (auto* error = std::get_if<std::string>(&other)) return std::move(*error);
    opened.pinned = pin_of(std::get<Prepared>(other), *saved.pinned);
  }
  opened.changed = !saved.mesh_hash.empty() && opened.loaded.mesh_hash != saved.mesh_hash;
  auto& [input, findings] = std::get<Prepared>(prepared);
  opened.input = std::move(input);
  opened.loaded.findings = std::move(findings);
  return opened;
}

std::variant<SavedRun, std::string> read_saved_run(const fs::path& path) {
  auto read = read_file(path);
  if (auto* error = std::get_if<std::string>(&read)) return std::move(*error);
  auto& saved = std::get<SavedSession>(read);
  return SavedRun{std::move(saved.source), saved.knobs.base, std::move(saved.knobs.edits)};
}

std::optional<SavedAs> saved_as(const Session& session, const fs::path& path) {
  SessionText said = session_text(session, path);
  if (!said.error.empty() || path == "-") return std::nullopt;
  return SavedAs{absolute_of(path), std::move(said.text)};
}

std::optional<fs::path> saved_unchanged(const Session& session) {
  if (!session.document || !session.document->saved) return std::nullopt;
  const SavedAs& saved = *session.document->saved;
  std::error_code error;
  const bool unchanged =
      session_text(session, saved.path).text == saved.text && fs::exists(saved.path, error);
  return unchanged ? std::optional(saved.path) : std::nullopt;
}

bool is_session_file(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  if (ending == ".obj") return false;
  std::error_code error;
  if (ending == ".json" || !fs::is_regular_file(path, error)) return ending == ".json";
  const std::string begin = begin_of(path);
  const std::size_t first = begin.find_first_not_of(" \t\r\n");
  return first != std::string::npos && begin[first] == '{' && begin.find(session_mark) != std::string::npos;
}

bool is_pattern_file(const fs::path& path) {
  std::string ending = path.extension().string();
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return ending == ".txt" || ending == ".md" || ending == ".markdown" || ending == ".html" ||
         ending == ".htm";
}

Action opening_of(const fs::path& path) {
  if (is_pattern_file(path)) return CheckFile{path};
  if (is_curves_file(path)) return OpenCurves{CurveWish{path, false, {}}};
  if (is_session_file(path)) return OpenSession{path};
  return OpenFile{path};
}

}  // namespace app
