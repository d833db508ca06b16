#include "app/files/rescue.h"

#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <sstream>

#include "app/base/files.h"
#include "app/base/text.h"
#include "app/files/session_file.h"
#include "app/files/session_json.h"
#include "app/session/document.h"
#include "app/session/program.h"

namespace app {

namespace fs = std::filesystem;

namespace {

constexpr std::string_view prefix = "session-";
constexpr std::string_view ending = ".json";

std::string folder_from(const char* variable) {
  const char* value = std::getenv(variable);
  return value != nullptr && *value == '/' ? value : "";  // anything else is not valid there
}

// Of /proc: in clock ticks since the machine was started, field 22; 0 where there is none.
std::uint64_t began(std::int64_t id) {
  std::ifstream in("/proc/" + std::to_string(id) + "/stat");
  std::string line;
  std::getline(in, line);
  const std::size_t after_name = line.rfind(')');  // the name may hold anything
  if (after_name == std::string::npos) return 0;
  std::istringstream rest(line.substr(after_name + 1));
  std::string word;
  for (int field = 3; field <= 22; ++field) rest >> word;
  return whole_number<std::uint64_t>(word).value_or(0);
}

std::optional<Process> process_of(const fs::path& file) {
  const std::string name = file.filename().string();
  if (name.rfind(prefix, 0) != 0 || file.extension() != ending) return std::nullopt;
  const std::string middle = file.stem().string().substr(prefix.size());
  const auto parts = split(middle, '-');
  if (parts.size() != 2) return std::nullopt;
  const auto id = whole_number<std::int64_t>(parts[0]);
  const auto start = whole_number<std::uint64_t>(parts[1]);
  if (!id || *id <= 0 || !start) return std::nullopt;
  return Process{*id, *start};
}

std::string words_of(const SavedSession& saved) {
  const Source& source = saved.source;
  std::string words = source.file.empty() ? source.example : source.file.stem().string();
  if (!saved.at) return words + ", at the start";
  if (saved.at->row > 0) return words + ", row " + std::to_string(saved.at->row);
  return words + ", " + std::string(knit::name_of(saved.at->stage));
}

// None for what cannot be opened anyway.
std::optional<std::string> words_in(const fs::path& file) {
  std::error_code error;
  constexpr std::uintmax_t most_bytes = 16U << 20U;
  const auto size = fs::file_size(file, error);
  if (error || size > most_bytes) return std::nullopt;
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  const auto saved = read_saved(text.str());
  const auto* session = std::get_if<SavedSession>(&saved);
  return session != nullptr ? std::optional(words_of(*session)) : std::nullopt;
}

}  // namespace

std::optional<fs::path> rescue_folder() {
  if (const std::string state = folder_from("XDG_STATE_HOME"); !state.empty())
    return fs::path(state) / "knit-mesh";
  if (const std::string home = folder_from("HOME"); !home.empty())
    return fs::path(home) / ".local" / "state" / "knit-mesh";
  return std::nullopt;
}

Process this_process() {
  const auto id = static_cast<std::int64_t>(::getpid());
  return {id, began(id)};
}

bool is_running(const Process& process) {
  if (::kill(static_cast<pid_t>(process.id), 0) != 0 && errno == ESRCH) return false;
  const std::uint64_t now = began(process.id);
  return now == 0 || process.began == 0 || now == process.began;
}

fs::path rescue_file(const fs::path& folder, const Process& process) {
  return folder / (std::string(prefix) + std::to_string(process.id) + "-" + std::to_string(process.began) +
                   std::string(ending));
}

std::optional<Rescued> find_rescued(const fs::path& folder) {
  std::optional<Rescued> newest;
  fs::file_time_type newest_time;
  std::error_code error;
  for (fs::directory_iterator it(folder, error); !error && it != fs::directory_iterator();
       it.increment(error)) {
    const auto process = process_of(it->path());
    if (!process || is_running(*process)) continue;
    std::error_code unknown;
    const auto time = fs::last_write_time(it->path(), unknown);
    if (unknown || (newest && time <= newest_time)) continue;
    if (auto words = words_in(it->path())) {
      newest = Rescued{it->path(), std::move(*words)};
      newest_time = time;
    }
  }
  return newest;
}

RescueKeeper::RescueKeeper(const Session& session, std::optional<fs::path> folder) {
  if (!folder) return;
  file_ = rescue_file(*folder, this_process());
  known_ = session_text(session, *file_).text;
}

void RescueKeeper::pass(const Session& session, double seconds) {
  waited_ += seconds;
  if (waited_ >= seconds_between) keep(session);
}

bool RescueKeeper::keep(const Session& session) {
  waited_ = 0.0;
  if (!file_) return false;
  std::string text = session_text(session, *file_).text;
  if (text.empty() || text == known_) return written_;
  std::error_code ignored;
  fs::create_directories(file_->parent_path(), ignored);
  written_ = !write_file(*file_, text);  // where it cannot be, there is no rescue
  known_ = std::move(text);
  return written_;
}

void RescueKeeper::end() {
  if (!file_) return;
  std::error_code ignored;
  fs::remove(*file_, ignored);
}

}  // namespace app
