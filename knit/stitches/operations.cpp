#include "knit/stitches/operations.h"

namespace knit {

namespace {

// Cells whose stitch a decrease beside them takes in.
std::vector<std::uint8_t> taken_in(const Join& join) {
  std::vector<std::uint8_t> taken(join.labels.size(), 0);
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    if (is_decrease(join.labels[cell])) taken[static_cast<std::size_t>(join.partner[cell])] = 1;
  }
  return taken;
}

}  // namespace

Hand hand_of(Label label) {
  switch (label) {
    case Label::m1r:
      return Hand::m1r;
    case Label::m1l:
      return Hand::m1l;
    case Label::k2tog:
      return Hand::k2tog;
    case Label::ssk:
      return Hand::ssk;
    case Label::knit:
    case Label::cast:
    case Label::main:
    case Label::turn_left:
    case Label::turn_right:
    case Label::marked:
      break;
  }
  return Hand::knit;
}

std::int32_t consumed_by(Hand hand) {
  if (hand == Hand::knit) return 1;
  return hand == Hand::k2tog || hand == Hand::ssk ? 2 : 0;
}

std::int32_t made_by(Hand /*hand*/) { return 1; }

std::vector<Operation> operations_of(const Join& join) {
  std::vector<Operation> operations;
  const std::vector<std::uint8_t> taken = taken_in(join);
  for (std::size_t cell = 0; cell < join.labels.size(); ++cell) {
    if (taken[cell] != 0) continue;
    const Label label = join.labels[cell];
    const auto partner = static_cast<std::size_t>(join.partner[cell]);
    const bool at_main = label == Label::main || (is_decrease(label) && join.labels[partner] == Label::main);
    operations.push_back({hand_of(label), at_main});
  }
  return operations;
}

OperationCount count(std::span<const Operation> operations) {
  OperationCount sum;
  for (const Operation& operation : operations) {
    sum.consumed += consumed_by(operation.hand);
    sum.produced += made_by(operation.hand);
  }
  return sum;
}

}  // namespace knit
