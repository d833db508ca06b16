// The variables of the pseudo-code that are first met in the stages cast on and rows: what they are called, their symbols (as in
// the thesis where it has one) and their meaning.
#pragma once

#include "knit/model/event.h"

namespace knit::var {

inline constexpr CodeVariable level{"level", "level",
                                    "The number of the level, or of the cut, that the row is made on."};
inline constexpr CodeVariable last_level{"last_level", "last level", "The last level that makes a row."};
inline constexpr CodeVariable passed_over{"passed_over", "passed over",
                                          "How many levels or cuts were too short to make a row."};
inline constexpr CodeVariable cycle{"cycle", "v",
                                    "The ring of vertices, or the loop of a cut, that the row is made on."};
inline constexpr CodeVariable count{"count", "N", "How many vertices the ring has."};
inline constexpr CodeVariable length{"length", "L", "The length once round, in mesh units."};
inline constexpr CodeVariable width{"width", "w", "The stitch width: how long a stitch should be."};
inline constexpr CodeVariable epsilon{"epsilon", "\xCE\xB5",
                                      "By how much a stitch may be shorter or longer than that."};
inline constexpr CodeVariable rows_from{"rows_from", "rows", "What rows are made from: rings or contours."};
inline constexpr CodeVariable without_ring{"without_ring", "there", "A vertex where there is no ring."};
inline constexpr CodeVariable k{"k", "k", "How many stitches are cast on."};
inline constexpr CodeVariable item{"item", "i", "The number of the stitch that is placed, from 1."};
inline constexpr CodeVariable arc{"arc", "s", "How far along the ring the stitch stands."};
inline constexpr CodeVariable first{"first", "v[0]", "The vertex where the round begins."};
inline constexpr CodeVariable by{"by", "by",
                                 "How the ring was put in order: by angle or along the mesh's edges."};
inline constexpr CodeVariable anchor{"anchor", "v0",
                                     "The anchor: the stitch from which the next is measured."};
inline constexpr CodeVariable candidate{"candidate", "vi",
                                        "The candidate: the vertex that is measured, or taken."};
inline constexpr CodeVariable order{"order", "i", "The candidate's place in the ring, from 1."};
inline constexpr CodeVariable d{"d", "d", "The distance from the anchor to the candidate, by the metric."};
inline constexpr CodeVariable metric{"metric", "d2",
                                     "The ruler: through the air, along the ring or along the surface."};
inline constexpr CodeVariable verdict{"verdict", "verdict",
                                      "Whether the distance lies in the band, below it or above it."};
inline constexpr CodeVariable stitch{"stitch", "j", "The number of the stitch that the anchor is, from 1."};
inline constexpr CodeVariable skipped{"skipped", "other d",
                                      "The distance of the nearest vertex that was not taken."};
inline constexpr CodeVariable gap{"gap", "g", "The closing gap: from the row's last stitch to its first."};
inline constexpr CodeVariable in_band{"in_band", "g in band",
                                      "Whether the closing gap is a stitch's length within the tolerance."};
inline constexpr CodeVariable dropped_last{"dropped_last", "last dropped",
                                           "Whether the last anchor was too near the first stitch to stay."};
inline constexpr CodeVariable n{"n", "n", "How many stitches the row has so far, or has now."};
inline constexpr CodeVariable picked{"picked", "picked", "How many stitches Algorithm 2 had picked."};
inline constexpr CodeVariable below{"below", "p", "How many stitches the row below has."};
inline constexpr CodeVariable reason{"reason", "because", "Why the row has this count."};
inline constexpr CodeVariable share{"share", "share",
                                    "By how much a stitch is shifted for its number, or the even spacing."};
inline constexpr CodeVariable how{"how", "close", "How the closing gap is distributed: none, thesis or arc."};
inline constexpr CodeVariable shared{"shared", "shared", "Whether the stitches were moved."};
inline constexpr CodeVariable gap_after{"gap_after", "g after",
                                        "The closing gap once it has been distributed."};

// of contours
inline constexpr CodeVariable rows{"rows", "rows", "How many rounds the tube gets."};
inline constexpr CodeVariable stitch_height{"stitch_height", "h",
                                            "The stitch height: how far apart rows should be."};
inline constexpr CodeVariable surface_height{"surface_height", "H",
                                             "The height of the tube, along the surface."};
inline constexpr CodeVariable row_height{"row_height", "row height", "How far apart its rounds lie."};
inline constexpr CodeVariable tube{"tube", "tube", "The tube that is worked, by its letter."};
inline constexpr CodeVariable changes{"changes", "k",
                                      "The most stitches that a shaping round adds or takes."};
inline constexpr CodeVariable sections{"sections", "M",
                                       "How many equal sections a round has, and so how often its repeat."};
inline constexpr CodeVariable style{"style", "style", "Where a section's shaping stands."};
inline constexpr CodeVariable rhythms{"rhythms", "rhythms", "How many rhythms the tube is made of."};
inline constexpr CodeVariable shaping_rounds{"shaping_rounds", "shaping", "How many rounds shape."};
inline constexpr CodeVariable seen{
    "seen", "seen",
    "By how much the circumference is seen to be off at most, in % (a mean over six rounds)."};
inline constexpr CodeVariable most_off{"most_off", "most off", "The row where it is most off."};
inline constexpr CodeVariable score{"score", "score", "What decides among plans: less reads better."};
inline constexpr CodeVariable within_tolerance{"within_tolerance", "within",
                                               "Whether it is seen to be off by no more than asked for."};
inline constexpr CodeVariable has_rhythm{"has_rhythm", "found", "Whether there is a rhythm for the tube."};
inline constexpr CodeVariable passes{"passes", "passes", "How often the round was matched and slid."};
inline constexpr CodeVariable slid{"slid", "shift", "By how much the round was moved along its loop."};
inline constexpr CodeVariable squares{"squares", "\xCE\xA3",
                                      "The sum of the squared lengths of the wales below the row."};
inline constexpr CodeVariable saddle{"saddle", "S", "The saddle at which loops part or meet."};
inline constexpr CodeVariable arcs_tried{"arcs_tried", "tried",
                                         "How many ways of cutting the loop were tried."};
inline constexpr CodeVariable one{"one", "l1", "How many stitches the first side has."};
inline constexpr CodeVariable two{"two", "l2", "How many stitches the second side has."};
inline constexpr CodeVariable whole{"whole", "l", "How many stitches the one loop has."};
inline constexpr CodeVariable saddle_gap{"saddle_gap", "D / w",
                                         "How wide the gap across the saddle is, in stitch widths."};
inline constexpr CodeVariable bridge{"bridge", "g", "How many stitches are cast on across the gap."};
inline constexpr CodeVariable loops{"loops", "held", "How many loops wait on holders."};
inline constexpr CodeVariable dealt_from{"dealt_from", "from", "The tubes whose loops are dealt."};
inline constexpr CodeVariable dealt_to{"dealt_to", "to", "The tubes that get them."};
inline constexpr CodeVariable laid_aside{"laid_aside", "aside", "The tube that is laid on a holder first."};
inline constexpr CodeVariable points{"points", "N", "How many points the loop has."};
inline constexpr CodeVariable ideal{"ideal", "L / w",
                                    "How many stitches of the stitch width the length holds."};
inline constexpr CodeVariable course{"course", "L / n", "How wide the stitches come out."};

}  // namespace knit::var
