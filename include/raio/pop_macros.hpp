// Gives back what push_macros.hpp has put aside.
#pragma pop_macro("check")
#pragma pop_macro("emit")
#pragma pop_macro("far")
#pragma pop_macro("major")
#pragma pop_macro("max")
#pragma pop_macro("min")
#pragma pop_macro("minor")
#pragma pop_macro("near")
#pragma pop_macro("small")

#if RAIO_OPTIMISES_ITSELF
#pragma GCC pop_options
#endif
