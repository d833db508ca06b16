#pragma once

// One include for both: Catch2 3 has many headers, Catch2 2 (Debian 12) a single one.
#if __has_include(<catch2/catch_all.hpp>)
#include <catch2/catch_all.hpp>
using Catch::Approx;
#else
#include <catch2/catch.hpp>
#endif
