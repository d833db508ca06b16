// The short form of a piece whose front and back halves are shaped apart, beside four mains: the round begins at the back one,
// markers stand at the side, the front and the other side.
//
//   Place markers (m) after 2, 6 and 10 sts: side, front and side; the round begins at the back.
//   Inc rnd A: K1, m1l, k to front m, m1r, K1, m1l, k to end, m1r. (+4 sts)
//   Dec rnd: k to 2 sts before front m, k2tog, K1, ssk, k to end. (-2 sts)
//
// A quarter is shaped at its beginning, K1 and m1l or ssk, at its end, m1r or k2tog, at both or not at all; what is knit
// through is not told. So that no marker is meant twice, the front one stands between two times "side". A round that has other work
// is written out.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "knit/pattern/rounds.h"
#include "knit/pattern/short_form.h"

namespace knit {

struct HalvesForm {
  std::vector<NamedRound> named;       // in the order of use
  std::vector<std::int32_t> of_round;  // the number of its name; -1: written out, -2: a plain round
  std::array<std::int32_t, 3> marks{};
};
// With so many stitches of the cast on from the back main to the side main. None: the quarters do not stay as wide as those that
// mirror them, a stitch is worked across a marker, or no way that shapes the halves apart comes twice.
std::optional<HalvesForm> halves_form(const Rounds& rounds, std::int32_t back_quarter);

}  // namespace knit
