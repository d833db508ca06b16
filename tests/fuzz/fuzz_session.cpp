// Session files: read, written and read again, the two files are the same.
#include "app/files/session_json.h"
#include "tests/fuzz/bytes.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto read = app::read_saved(fuzz::text_of(data, size));
  if (const auto* fault = std::get_if<std::string>(&read)) {
    fuzz::promise_sentence(*fault);
    return 0;
  }
  const std::string written = app::to_json(std::get<app::SavedSession>(read)).dump();
  const auto again = app::read_saved(written);
  const auto* fault = std::get_if<std::string>(&again);
  fuzz::promise(fault == nullptr, fault == nullptr ? "" : "what was written reads: " + *fault);
  fuzz::promise(app::to_json(std::get<app::SavedSession>(again)).dump() == written, "it reads back the same");
  return 0;
}
