// Shapes that branch, bend, have handles or an inside: the examples that are no rings about an axis.
//
// Every shape is one piece, closed, its triangles counter-clockwise seen from outside; y is up. Sizes are 2 to 3 units.
// `edge`: about how long a triangle's side is; 0.08 or less, or thin parts may be missed.
#pragma once

#include "knit/mesh/mesh.h"

namespace knit {

// Genus 0.
Mesh heel(double edge);      // a leg upright and a foot towards +x, one tube that bends, with round ends
Mesh trousers(double edge);  // two legs and a waist, closed at the hems and on top
Mesh letter_y(double edge);  // a trunk that forks, with round ends
Mesh starfish(double edge);  // five tapering arms in the plane z = 0, one of them up
Mesh octopus(double edge);   // a round head on eight legs that hang outwards and down
Mesh cup(double edge);       // a wall with an inside, open on top

// With handles.
Mesh mug(double edge);             // genus 1: a cup with a handle on the side of +x
Mesh double_torus(double edge);    // genus 2: two rings in the plane z = 0, one on the other
Mesh chain_of_three(double edge);  // genus 3: three rings on each other, the middle one turned a quarter

}  // namespace knit
