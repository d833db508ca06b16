// OBJ text, read, checked and welded, as opening a file does it.
#include <cmath>
#include <sstream>

#include "knit/import/check.h"
#include "knit/import/obj.h"
#include "knit/mesh/mesh.h"
#include "tests/fuzz/bytes.h"

namespace {

void promise_findings(const knit::CheckResult& result) {
  for (const knit::Finding& finding : result.findings) fuzz::promise_sentence(finding.sentence);
}

bool in_range(const knit::Mesh& mesh) {
  for (const knit::Triangle& triangle : mesh.triangles)
    for (const knit::VertexId v : triangle)
      if (v >= mesh.positions.size()) return false;
  return true;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream in(fuzz::text_of(data, size));
  const auto read = knit::read_obj(in, "mesh");
  if (const auto* error = std::get_if<knit::ObjError>(&read)) {
    fuzz::promise_sentence(error->sentence);
    return 0;
  }
  const auto& mesh = std::get<knit::Mesh>(read);
  fuzz::promise(in_range(mesh), "the reader lets no index out of range through");
  const knit::CheckResult found = knit::check(mesh);
  promise_findings(found);
  if (!found.fit()) return 0;

  const knit::Mesh welded = knit::weld(mesh);
  const knit::CheckResult again = knit::check(welded);
  promise_findings(again);
  fuzz::promise(again.fit(), "a fit mesh is fit when it is welded");
  for (const knit::Finding& finding : again.findings)
    fuzz::promise(finding.kind != knit::FindingKind::coincident, "welding leaves nothing to weld");
  const auto input = knit::make_input(welded);
  fuzz::promise(std::isfinite(input->bounds.diagonal()) && input->bounds.diagonal() > 0.0, "it has a size");
  return 0;
}
