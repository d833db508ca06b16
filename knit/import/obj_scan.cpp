#include "knit/import/obj_scan.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>

#include "knit/import/quoting.h"

namespace knit {

namespace {

constexpr std::size_t most_corners = 4096;      // keeps triangulating a hostile polygon quick
constexpr std::size_t most_vertices = 1 << 30;  // keeps every index within tinyobjloader's int
constexpr int most_index_digits = 10;
constexpr int most_exponent_digits = 4;

bool is_blank(char c) { return c == ' ' || c == '\t'; }
bool ends_a_file(char c) { return c == '\0' || c == '\x1A'; }  // ZBrush, DOS
bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }

const char* after_blanks(const char* p, const char* end) {
  while (p != end && is_blank(*p)) ++p;
  return p;
}

const char* before_blanks(const char* begin, const char* p) {
  while (p != begin && is_blank(p[-1])) --p;
  return p;
}

const char* after_word(const char* p, const char* end) {
  while (p != end && !is_blank(*p)) ++p;
  return p;
}

const char* after_digits(const char* p, const char* end) {
  while (p != end && is_digit(*p)) ++p;
  return p;
}

// [sign] digits [. digits] [e [sign] digits], the whole word.
bool is_number(const char* p, const char* end) {
  if (p != end && (*p == '+' || *p == '-')) ++p;
  const char* const whole = p;
  p = after_digits(p, end);
  std::ptrdiff_t digits = p - whole;
  if (p != end && *p == '.') {
    const char* const fraction = ++p;
    p = after_digits(p, end);
    digits += p - fraction;
  }
  if (digits == 0) return false;
  if (p == end) return true;
  if (*p != 'e' && *p != 'E') return false;
  if (++p != end && (*p == '+' || *p == '-')) ++p;
  const char* const exponent = p;
  p = after_digits(p, end);
  return p == end && p != exponent && p - exponent <= most_exponent_digits;
}

// A comment, and a file's name, may end in a backslash that means nothing; so may a name with a blank behind it.
bool keeps_backslash(std::string_view statement, bool blank_behind) {
  if (statement.starts_with('#') || statement.starts_with("usemtl") || statement.starts_with("mtllib"))
    return true;
  constexpr std::array<std::string_view, 7> named{"g",          "o",         "usemap", "maplib",
                                                  "shadow_obj", "trace_obj", "call"};
  const std::string_view word = statement.substr(0, statement.find_first_of(" \t\\"));
  return blank_behind && std::find(named.begin(), named.end(), word) != named.end();
}

// One line at a time; the first error ends the scan.
class Scanner {
 public:
  Scanner(std::string& scanned, PartProgress told)
      : text(scanned),
        progress(told),
        has_return(std::memchr(scanned.data(), '\r', scanned.size()) != nullptr) {}

  ObjScan run() {
    if (text.empty()) return failed(": the file is empty. Export the mesh again.");
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) {
      return failed(" is not text as OBJ has it, but UTF-16. Save it as UTF-8 and open it again.");
    }
    blank_what_means_nothing();
    if (std::memchr(text.data(), '\0', text.size()) != nullptr) {
      return failed(" is not text, so it is no Wavefront OBJ file. Export the mesh as OBJ and open that.");
    }
    if (text.starts_with("\xEF\xBB\xBF")) result.skip = 3;
    const char* at = text.data() + result.skip;
    const char* const end = text.data() + text.size();
    while (at != end && result.error.empty()) {
      ++line;
      progress.at(static_cast<std::size_t>(at - text.data()), text.size());
      const char* const stop = end_of_statement(at, end);
      scan_line(at, stop);
      at = after_newline(stop, end);
      line += std::exchange(continued, 0);
    }
    if (result.error.empty() && result.vertices == 0 && result.faces == 0) {
      return failed(
          " has no vertices and no faces, so it is no Wavefront OBJ file. Export the mesh as OBJ and open "
          "that.");
    }
    if (result.error.empty() && highest > result.vertices) {
      line = highest_line;
      fail("a face asks for vertex " + std::to_string(highest) + ", but the file has " +
           std::to_string(result.vertices) + ". It may be cut short; export the mesh again.");
    }
    return std::move(result);
  }

 private:
  std::string& text;
  PartProgress progress;
  bool has_return;
  ObjScan result;
  std::size_t line = 0;
  std::size_t continued = 0;  // further lines that the present one takes in
  std::uint64_t highest = 0;
  std::size_t highest_line = 0;

  ObjScan failed(std::string sentence) {
    result.error = std::move(sentence);
    return std::move(result);
  }

  void fail(const std::string& what) { result.error = ", line " + std::to_string(line) + ": " + what; }

  [[nodiscard]] const char* end_of_line(const char* p, const char* end) const {
    const auto* newline = static_cast<const char*>(std::memchr(p, '\n', static_cast<std::size_t>(end - p)));
    if (newline == nullptr) newline = end;
    if (!has_return) return newline;
    const auto* ret = static_cast<const char*>(std::memchr(p, '\r', static_cast<std::size_t>(newline - p)));
    return ret != nullptr ? ret : newline;
  }

  static const char* after_newline(const char* p, const char* end) {
    if (p == end) return p;
    if (*p == '\r' && p + 1 != end && p[1] == '\n') return p + 2;
    return p + 1;
  }

  // What ends a file, and blanks that tinyobjloader does not know.
  void blank_what_means_nothing() {
    for (std::size_t i = text.size(); i > 0; --i) {
      char& last = text[i - 1];
      if (ends_a_file(last))
        last = ' ';
      else if (!is_blank(last) && last != '\n' && last != '\r')
        break;
    }
    for (const char blank : {'\f', '\v'})
      if (std::memchr(text.data(), blank, text.size()) != nullptr)
        std::replace(text.begin(), text.end(), blank, ' ');
  }

  void fill_blank(const char* from, const char* to) {
    std::fill(text.begin() + (from - text.data()), text.begin() + (to - text.data()), ' ');
  }

  // The end of the line, taking in the lines that a backslash at the end, or with blanks behind it, adds to it.
  const char* end_of_statement(const char* p, const char* end) {
    const char* stop = end_of_line(p, end);
    const char* last = before_blanks(p, stop);
    if (last == p || stop == end || last[-1] != '\\') return stop;
    const char* const word = after_blanks(p, stop);
    if (keeps_backslash({word, static_cast<std::size_t>(last - word)}, last != stop)) return stop;
    for (const char* begin = p; last != begin && stop != end && last[-1] == '\\';) {
      begin = after_newline(stop, end);
      fill_blank(last - 1, begin);
      stop = end_of_line(begin, end);
      last = before_blanks(begin, stop);
      ++continued;
    }
    return stop;
  }

  void scan_line(const char* p, const char* end) {
    p = after_blanks(p, end);
    if (p == end || *p == '#') return;
    const char* const word_end = after_word(p, end);
    const std::string_view word(p, static_cast<std::size_t>(word_end - p));
    if (word == "v") return scan_vertex(word_end, end);
    if (word == "f" || word == "fo") {
      fill_blank(p + 1, word_end);  // "fo" is the old form
      return scan_face(p, end);
    }
    const bool known_form = is_letter(word.front()) && std::all_of(word.begin(), word.end(), [](char c) {
                              return is_letter(c) || is_digit(c) || c == '-';
                            });
    if (!known_form || word == "V" || word == "F") {
      fail("a line that begins with " + quoted(word) +
           " is not OBJ; the file is damaged or of another kind. Export the mesh as OBJ again.");
    }
  }

  void scan_vertex(const char* p, const char* end) {
    for (int axis = 0; axis < 3; ++axis) {
      p = after_blanks(p, end);
      const char* const word_end = after_word(p, end);
      if (p == word_end)
        return fail("a vertex needs three coordinates. Complete the line or export the mesh again.");
      if (!is_number(p, word_end)) {
        return fail("the coordinate " + quoted({p, static_cast<std::size_t>(word_end - p)}) +
                    " is no finite decimal number like 0.5. Correct it or export the mesh again.");
      }
      p = word_end;
    }
    if (++result.vertices > most_vertices) fail("the file has too many vertices. Reduce the mesh.");
  }

  void scan_face(const char* const face, const char* end) {
    std::size_t count = 0;
    const char* p = after_blanks(face + 1, end);
    for (; p != end && *p != '#'; p = after_blanks(p, end)) {
      const char* const word_end = after_word(p, end);
      if (!scan_corner(p, word_end)) return;
      p = word_end;
      ++count;
    }
    fill_blank(p, end);
    const bool cut_short = end == text.data() + text.size();
    if (count == 2 && !cut_short) return leave_out_edge(face, end);
    if (count < 3) {
      return fail("a face needs three corners and has " + std::to_string(count) +
                  ". Remove it or export the mesh again.");
    }
    if (count > most_corners) {
      return fail("a face has " + std::to_string(count) + " corners; at most " +
                  std::to_string(most_corners) + " are read. Triangulate the mesh before exporting it.");
    }
    ++result.faces;
    result.corners += count;
    if (result.corners > most_vertices) fail("the file has too many faces. Reduce the mesh.");
  }

  // A face of two corners is an edge that belongs to no face.
  void leave_out_edge(const char* face, const char* end) {
    fill_blank(face, end);
    if (result.loose_edges++ == 0) result.loose_line = line;
  }

  // vertex[/[texture][/[normal]]]; only the vertex is used, the others need only be harmless to read.
  bool scan_corner(const char* p, const char* end) {
    const char* const word = p;
    const bool negative = *p == '-';
    if (negative) ++p;
    std::uint64_t index = 0;
    const char* const digits = p;
    for (; p != end && is_digit(*p) && p - digits < most_index_digits; ++p)
      index = 10 * index + static_cast<std::uint64_t>(*p - '0');
    bool sound = p != digits;
    for (int slash = 0; slash < 2 && p != end && *p == '/'; ++slash) {
      if (++p != end && *p == '-') ++p;
      const char* const number = p;
      p = after_digits(p, end);
      sound = sound && p - number <= most_index_digits;
    }
    const std::string_view whole(word, static_cast<std::size_t>(end - word));
    if (!sound || (p != end && !is_digit(*p))) {
      fail("the corner " + quoted(whole) + " is no vertex number. Correct it or export the mesh again.");
    } else if (index == 0) {
      fail("a face asks for vertex 0, but numbers begin at 1. Correct it or export the mesh again.");
    } else if (p != end || (negative && index > result.vertices)) {
      fail("a face asks for vertex " + quoted(whole) + ", but only " + std::to_string(result.vertices) +
           " have been given so far. Correct it or export the mesh again.");
    } else if (!negative && index > highest) {
      highest = index;
      highest_line = line;
    }
    return result.error.empty();
  }
};

}  // namespace

ObjScan scan_obj(std::string& text, PartProgress progress) { return Scanner(text, progress).run(); }

}  // namespace knit
