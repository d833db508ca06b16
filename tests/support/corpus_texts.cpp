// Files that are no OBJ, or OBJ written oddly.
#include <algorithm>
#include <array>
#include <cstddef>
#include <sstream>

#include "tests/support/corpus.h"

namespace corpus {

namespace {

const std::string corners = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
const std::string faces = "f 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";

std::string good() { return obj_of(ball()); }

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
    text.replace(at, from.size(), to);
  return text;
}

std::string as_utf16(const std::string& text) {
  std::string wide = "\xFF\xFE";
  for (const char c : text) wide += {c, '\0'};
  return wide;
}

// A binary STL says its number of triangles behind 80 bytes.
std::string binary_stl() {
  std::string bytes = "solid made by a scanner";
  bytes.resize(80, ' ');
  bytes += std::string("\x04\0\0\0", 4);
  for (int i = 0; i < 4 * 50; ++i) bytes += static_cast<char>(i * 37);
  return bytes;
}

// A prism over a regular or concave polygon, both lids as one face each.
std::string prism(std::size_t n) {
  std::ostringstream text;
  for (const int z : {0, 1}) {
    for (std::size_t i = 0; i < n; ++i) {
      const auto x = static_cast<double>(i);
      text << "v " << x << ' ' << x * (static_cast<double>(n) - x) << ' ' << z << '\n';
    }
  }
  text << 'f';
  for (std::size_t i = 1; i <= n; ++i) text << ' ' << i;
  text << "\nf";
  for (std::size_t i = n; i > 0; --i) text << ' ' << n + i;
  text << '\n';
  for (std::size_t i = 1; i <= n; ++i) {
    const std::size_t next = i % n + 1;
    text << "f " << next << ' ' << i << ' ' << n + i << ' ' << n + next << '\n';
  }
  return text.str();
}

// A U, whose lids are no star: no corner sees all others.
const std::string concave =
    "v 0 0 0\nv 3 0 0\nv 3 2 0\nv 2 2 0\nv 2 1 0\nv 1 1 0\nv 1 2 0\nv 0 2 0\n"
    "v 0 0 1\nv 3 0 1\nv 3 2 1\nv 2 2 1\nv 2 1 1\nv 1 1 1\nv 1 2 1\nv 0 2 1\n"
    "f 8 7 6 5 4 3 2 1\nf 9 10 11 12 13 14 15 16\n"
    "f 1 2 10 9\nf 2 3 11 10\nf 3 4 12 11\nf 4 5 13 12\nf 5 6 14 13\nf 6 7 15 14\nf 7 8 16 15\nf 8 1 9 16\n";

Case refused(std::string name, std::string bytes, std::vector<std::string> words) {
  Case made{std::move(name), [bytes = std::move(bytes)] { return bytes; }};
  made.refused.words = std::move(words);
  return made;
}

Case opens(std::string name, std::string bytes, Opens as) {
  Case made{std::move(name), [bytes = std::move(bytes)] { return bytes; }, true};
  made.opened = std::move(as);
  return made;
}

void add_no_obj(std::vector<Case>& all) {
  const std::string as_obj = "xport the mesh";
  all.push_back(refused("empty.obj", "", {"empty", as_obj}));
  all.push_back(refused("only-a-bom.obj", "\xEF\xBB\xBF", {"no vertices and no faces", as_obj}));
  all.push_back(refused("blank-lines.obj", "\n\n  \n\t\n", {"no vertices and no faces", as_obj}));
  all.push_back(refused("letter.obj", "Dear Sir or Madam,\nplease find my mesh enclosed.\n",
                        {"no vertices and no faces", as_obj}));
  all.push_back(refused("page.obj", "<!DOCTYPE html>\n<html><body>404 not found</body></html>\n",
                        {"line 1", "\"<!DOCTYPE\"", "is not OBJ"}));
  all.push_back(refused("stl-as-text.obj", "solid ball\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\n",
                        {"no vertices and no faces", as_obj}));
  all.push_back(refused("ply-as-text.obj", "ply\nformat ascii 1.0\nelement vertex 3\nend_header\n0 0 0\n",
                        {"line 5", "\"0\"", "is not OBJ"}));
  all.push_back(refused("stl-binary.obj", binary_stl(), {"is not text", as_obj}));
  all.push_back(
      refused("picture.obj", std::string("\x89PNG\r\n\x1a\n\0\0\0\rIHDR", 16), {"is not text", as_obj}));
  all.push_back(refused("zip.obj", std::string("PK\x03\x04\x14\0\x08\0", 8), {"is not text", as_obj}));
  all.push_back(refused("utf-16.obj", as_utf16(corners + faces), {"is not text", "UTF-8"}));
  all.push_back(
      refused("noise.obj", "\x8f\xa4\x01\xff\xfe\x80\x93 \xc3\x28\n\xf0\x9f\n", {"line 1", "is not OBJ"}));
  all.push_back(
      refused("points-and-lines.obj", corners + "p 1 2\nl 1 2 3\n", {"no faces", "with its faces"}));
  all.push_back(refused("free-form.obj", corners + "cstype bspline\ndeg 3\ncurv 0 1 1 2 3 4\nend\n",
                        {"no faces", "with its faces"}));
}

void add_cut_short(std::vector<Case>& all) {
  const std::string whole = good();
  const std::size_t first_face = whole.find("\nf ") + 1;
  const std::size_t some_face = whole.find("\nf ", first_face + 2000) + 1;
  all.push_back(refused("cut-in-a-coordinate.obj", corners.substr(0, corners.size() - 4),
                        {"line 4", "three coordinates"}));
  all.push_back(refused("cut-before-the-faces.obj", whole.substr(0, first_face), {"no faces"}));
  all.push_back(refused("cut-in-a-face.obj", whole.substr(0, some_face + 5), {"three corners", "has 1"}));
  const std::string to_a_face = whole.substr(0, some_face);
  const auto kept = static_cast<std::size_t>(
      std::count(to_a_face.begin() + static_cast<std::ptrdiff_t>(first_face), to_a_face.end(), '\n'));
  all.push_back(opens("cut-between-faces.obj", to_a_face, {266, kept, {"open at 1 edge", "belong"}}));
  all.push_back(refused("vertices-missing.obj", whole.substr(whole.find("\nv ", whole.size() / 4) + 1),
                        {"a face asks for vertex"}));
}

void add_written_oddly(std::vector<Case>& all) {
  const std::string text = good();
  const Opens same{266, 528, {}};
  all.push_back(opens("crlf.obj", replaced(text, "\n", "\r\n"), same));
  all.push_back(opens("cr-alone.obj", replaced(text, "\n", "\r"), same));
  all.push_back(opens("tabs.obj", replaced(text, " ", "\t"), same));
  all.push_back(opens("many-blanks.obj", replaced(text, " ", " \t  "), same));
  all.push_back(opens("bom.obj", "\xEF\xBB\xBF" + text, same));
  all.push_back(opens("no-newline-at-the-end.obj", text.substr(0, text.size() - 1), same));
  all.push_back(opens("a ball of wool.obj", text, same));
  all.push_back(opens("h\xC3\xA4keln \xE2\x98\x83 \xE7\xB7\xA8\xE3\x81\xBF\xE7\x89\xA9.obj", text, same));
  all.push_back(opens("no-utf-8-\xFF\xC3.obj", text, same));
  all.push_back(opens("-begins-like-an-option.obj", text, same));
  all.push_back(opens("names-inside.obj",
                      "mtllib my h\xC3\xA4kel file.mtl\no Ball \xE2\x98\x83\ng a b\ns off\n" + text, same));
  all.push_back(opens("long-comment.obj", "#" + std::string(1 << 20, 'x') + "\n" + text, same));
  all.push_back(opens("normals-that-are-no-numbers.obj", "vn nan inf 1e999\nvt a b\n" + text, same));
  all.push_back(opens("negative-indices.obj", corners + "f -4 -2 -3\nf -4 -3 -1\nf -4 -1 -2\nf -3 -2 -1\n",
                      {4, 4, {}}));
  all.push_back(opens("continued-lines.obj", replaced(corners + faces, "f 1 ", "f \\\n 1 "), {4, 4, {}}));
  all.push_back(opens("colours-behind.obj", replaced(corners, "\n", " 0.5 0.5 0.5\n") + faces, {4, 4, {}}));
}

void add_numbers(std::vector<Case>& all) {
  const std::string no_number = "is no finite decimal number";
  for (const auto& [name, number] : {std::array{"nan", "nan"}, std::array{"inf", "-inf"},
                                     std::array{"decimal-comma", "0,5"}, std::array{"hexadecimal", "0x10"}}) {
    all.push_back(refused(std::string(name) + ".obj",
                          replaced(corners, "v 0 1 0", "v 0 " + std::string(number) + " 0") + faces,
                          {"line 3", "\"" + std::string(number) + "\"", no_number, "Correct it"}));
  }
  for (const char* huge : {"1e308", "-1e308", "1e999", "1e51"}) {
    all.push_back(refused("coordinate-" + std::string(huge) + ".obj",
                          replaced(corners, "v 0 1 0", "v 0 " + std::string(huge) + " 0") + faces,
                          {"1 vertex has a coordinate", "1e50", "vertex 2", "Correct the coordinates"}));
  }
  all.push_back(
      refused("no-z.obj", replaced(corners, "v 0 1 0", "v 0 1") + faces, {"line 3", "three coordinates"}));
  for (const auto& [name, index] :
       {std::array{"zero", "0"}, std::array{"too-negative", "-5"}, std::array{"beyond", "5"},
        std::array{"beyond-32-bits", "4294967297"}, std::array{"beyond-64-bits", "18446744073709551617"}}) {
    all.push_back(refused("index-" + std::string(name) + ".obj", corners + faces + "f 1 2 " + index + "\n",
                          {"line 9", "a face asks for vertex", "xport the mesh again"}));
  }
  all.push_back(
      refused("index-no-number.obj", corners + faces + "f 1 2 x\n", {"line 9", "\"x\"", "no vertex number"}));
}

void add_polygons(std::vector<Case>& all) {
  all.push_back(opens("loose-edge.obj", corners + faces + "f 1 2\n", {4, 4, {"two corners"}}));
  all.push_back(opens("five-corners.obj", prism(5), {10, 16, {}}));
  all.push_back(opens("hundred-corners.obj", prism(100), {200, 396, {}}));
  all.push_back(refused("ten-thousand-corners.obj", prism(10000),
                        {"a face has 10000 corners", "4096", "Triangulate the mesh"}));
  all.push_back(opens("concave.obj", concave, {16, 28, {}}));
}

}  // namespace

std::vector<Case> text_cases() {
  std::vector<Case> all;
  add_no_obj(all);
  add_cut_short(all);
  add_written_oddly(all);
  add_numbers(all);
  add_polygons(all);
  return all;
}

}  // namespace corpus
