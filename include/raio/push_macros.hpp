// Stands before all that a header of raio includes, and pop_macros.hpp at its end: between them these words are free of
// what windows.h, Qt and others define them to be, and afterwards everything is as it was. (No #pragma once: it is
// included again and again.)
//
// Between them g++ optimises also where a file is compiled without: see RAIO_OPTIMISES_ITSELF.

#pragma push_macro("check")
#undef check
#pragma push_macro("emit")
#undef emit
#pragma push_macro("far")
#undef far
#pragma push_macro("major")
#undef major
#pragma push_macro("max")
#undef max
#pragma push_macro("min")
#undef min
#pragma push_macro("minor")
#undef minor
#pragma push_macro("near")
#undef near
#pragma push_macro("small")
#undef small

#include <raio/abi.hpp>

#if RAIO_OPTIMISES_ITSELF
#pragma GCC push_options
#pragma GCC optimize("O1", "inline")
#endif
