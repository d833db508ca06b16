// Elementary functions with the same bits on every machine.
//
// The C library's sine, arc tangent or hypot differ in the last bit from one library to the next, and even from one
// processor to the next; sums, products, quotients and square roots do not (IEEE 754). So what a result may hang on is
// worked out from those alone, to some hundred bits for the functions of shapes and figures, and rounded once: wrong by
// no more than 0.501 of the last place. A test holds all other code to it.
//
// T. J. Dekker, "A floating-point technique for extending the available precision", 1971 (pairs of doubles);
// C. F. Borges, "Algorithm 1014: An improved algorithm for hypot(x,y)", 2020.
#pragma once

namespace knit {

// Requires |angle| <= 8. Some ten times slower than the C library's.
double sine(double angle);
double cosine(double angle);

// e to the power of x, for -700 <= x <= 700.
double exponential(double x);

// The angle in [0, pi] from the x axis to (x, y); requires y >= 0. As quick as the C library's.
double angle_to(double x, double y);

// The length of (x, y) and of (x, y, z), however large or small; the latter not to the last place.
double hypotenuse(double x, double y);
double hypotenuse(double x, double y, double z);

}  // namespace knit
